//! The part of a long run on a page: the steps that fit into its bytes, and of a large input the vertices that these
//! steps are about.
//!
//! Sorting shows no triangle, so a page that cannot hold every step begins at the first point event. Where the
//! vertices and edges alone would take half of the page, it keeps those that its steps name, those of the triangles
//! beside them, and of the others every so-many-th one, so that the outline of the input remains.
//!
//! Cost: linear in the steps that fit and the vertices.

use std::collections::BTreeSet;
use std::ops::Range;

use super::change::Change;
use super::scene::Scene;
use sweep_cdt::trace::{Event, Vertex};

/// The steps of `asked` (positions in `events`) that fit into `room` bytes by their `cost`: all of them; or as many as
/// fit on both sides of `around`; or from the first point event on.
pub(super) fn fitting(
    events: &[Event],
    asked: &Range<usize>,
    around: Option<usize>,
    cost: impl Fn(&Event) -> usize,
    room: usize,
) -> Range<usize> {
    let grown = |within: Range<usize>, at: usize| {
        let (mut low, mut high, mut left) = (at, at, room);
        let mut is_upward = true;
        while low > within.start || high < within.end {
            // A step upwards and a step downwards, in turn as long as there are both.
            is_upward = low == within.start || high < within.end && is_upward;
            let next = if is_upward { high } else { low - 1 };
            let Some(rest) = left.checked_sub(cost(&events[next])) else {
                break;
            };
            left = rest;
            if is_upward {
                high += 1;
            } else {
                low = next;
            }
            is_upward = !is_upward;
        }
        low..high
    };
    let whole = grown(asked.clone(), asked.start);
    if whole == *asked {
        return whole;
    }
    let point = events.iter().position(|e| matches!(e, Event::Point { .. }));
    let start = point.unwrap_or(0).clamp(asked.start, asked.end);
    let at = around.unwrap_or(start).clamp(start, asked.end);
    grown(start..asked.end, at)
}

/// The vertices and the changes before the first step that a page of a large input keeps.
#[derive(Debug)]
pub(super) struct Detail {
    /// In increasing order.
    pub(super) vertices: Vec<usize>,
    pub(super) before: Vec<Change>,
    /// Which edges have both ends among the vertices that matter.
    pub(super) edges: Vec<usize>,
}

impl Detail {
    /// The vertices of `events`, which follow `before`, out of `count` vertices; and about `sample` of the others.
    pub(super) fn new(
        events: impl Iterator<Item = Change>,
        before: &Scene,
        count: usize,
        edges: &[[usize; 2]],
        sample: usize,
    ) -> Detail {
        let mut named = vec![false; count];
        let all = before.changes_since_new();
        let is_lasting = |change: &&Change| matches!(change, Change::Add(_) | Change::Fix(_));
        let shown = all.iter().filter(|change| !is_lasting(change)).copied();
        for v in events.chain(shown).flat_map(|change| change.vertices()) {
            named[v] = true;
        }
        // Triangles and constraints that one of them belongs to, with their other corners.
        let touches = |change: &&Change| {
            let vertices = change.vertices();
            !is_lasting(change) || vertices.iter().any(|&v| named[v])
        };
        let before: Vec<Change> = all.iter().filter(touches).copied().collect();
        for v in before.iter().flat_map(Change::vertices) {
            named[v] = true;
        }
        let is_inner = |&e: &usize| edges[e].iter().all(|&v| named[v]);
        let inner = (0..edges.len()).filter(is_inner).collect();
        let others = (0..count).filter(|&v| !named[v]).count();
        let every = others.div_ceil(sample.max(1)).max(1);
        let outline = (0..count).filter(|&v| !named[v]).step_by(every);
        let vertices: BTreeSet<usize> = outline.chain((0..count).filter(|&v| named[v])).collect();
        Detail {
            vertices: vertices.into_iter().collect(),
            before,
            edges: inner,
        }
    }
}

/// The vertex of an event of the sorting.
pub(super) fn sorted(event: &Event) -> Option<usize> {
    match event {
        Event::Sorted {
            vertex: Vertex::Input(v),
        } => Some(*v),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::fitting;
    use sweep_cdt::trace::{Event, PointCase, Vertex};

    #[test]
    fn a_cut_begins_at_the_first_point_event_or_goes_round_a_step() {
        let vertex = Vertex::Input(0);
        let mut events = vec![Event::Sorted { vertex }; 10];
        events.push(Event::Finalization);
        let (case, segment) = (PointCase::Middle, [vertex; 2]);
        events.extend(
            [Event::Point {
                vertex,
                case,
                segment,
            }; 20],
        );
        let fitting = |asked, around, room| fitting(&events, &asked, around, |_| 2, room);
        assert_eq!(fitting(0..31, None, 62), 0..31);
        assert_eq!(fitting(0..31, None, 61), 11..31);
        assert_eq!(fitting(0..31, None, 9), 11..15);
        assert_eq!(fitting(2..6, None, 9), 2..6);
        assert_eq!(fitting(0..31, Some(20), 8), 18..22);
        assert_eq!(fitting(0..31, Some(20), 62), 0..31);
        assert_eq!(fitting(0..31, Some(30), 8), 27..31);
        assert_eq!(fitting(0..31, Some(12), 12), 11..17);
        assert_eq!(fitting(0..31, Some(3), 8), 11..15);
        assert_eq!(fitting(0..31, None, 1), 11..11);
        assert_eq!(fitting(5..5, None, 1), 5..5);
    }
}
