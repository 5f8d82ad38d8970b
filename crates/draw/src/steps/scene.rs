//! The picture after a step, and the steps that a page or a sheet shows, out of all steps of a run.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use super::change::{Change, changes};
use sweep_cdt::trace::{Event, PseudoPolygon, Vertex};

/// The state of the sweep, without any coordinate.
#[derive(Debug)]
pub(super) struct Scene {
    /// Triangles, each with its least vertex first.
    pub(super) triangles: BTreeSet<[Vertex; 3]>,
    /// The front, from P-1 to P-2.
    pub(super) front: Vec<Vertex>,
    pub(super) fixed: BTreeSet<[Vertex; 2]>,
    pub(super) sweep: Option<Vertex>,
    pub(super) is_swept: bool,
    /// The edge being inserted, and the triangles that it pierces.
    pub(super) edge: Option<[Vertex; 2]>,
    pub(super) pierced: Vec<[Vertex; 3]>,
    /// The borders of the upper and lower pseudo-polygon.
    pub(super) borders: [Vec<Vertex>; 2],
    /// The changes by the last step.
    pub(super) step: Vec<Change>,
}

impl Scene {
    /// Before the first step.
    pub(super) fn new() -> Scene {
        Scene {
            triangles: BTreeSet::new(),
            front: vec![Vertex::Left, Vertex::Right],
            fixed: BTreeSet::new(),
            sweep: None,
            is_swept: false,
            edge: None,
            pierced: Vec::new(),
            borders: [Vec::new(), Vec::new()],
            step: Vec::new(),
        }
    }

    /// Applies the changes of an event.
    pub(super) fn advance(&mut self, event: &Event) {
        self.step = changes(event);
        for at in 0..self.step.len() {
            self.change(self.step[at]);
        }
    }

    /// The changes that rebuild this scene from an empty one.
    pub(super) fn changes_since_new(&self) -> Vec<Change> {
        let mut all = Vec::new();
        all.extend(self.triangles.iter().copied().map(Change::Add));
        let inner = self
            .front
            .windows(2)
            .filter(|pair| pair[1] != Vertex::Right);
        all.extend(inner.map(|pair| Change::Join(pair[1], pair[0])));
        all.extend(self.fixed.iter().copied().map(Change::Fix));
        all.extend(self.sweep.map(Change::Sweep));
        all.extend(self.is_swept.then_some(Change::Swept));
        all.extend(self.edge.map(Change::Edge));
        all.extend(self.pierced.iter().copied().map(Change::Pierce));
        let polygons = [PseudoPolygon::Upper, PseudoPolygon::Lower];
        for (polygon, border) in polygons.into_iter().zip(&self.borders) {
            all.extend(border.iter().map(|&vertex| Change::Border(polygon, vertex)));
        }
        all
    }

    fn change(&mut self, change: Change) {
        match change {
            Change::Sweep(vertex) => {
                self.sweep = Some(vertex);
                self.edge = None;
            }
            Change::Swept => (self.sweep, self.edge, self.is_swept) = (None, None, true),
            Change::End => self.front.clear(),
            Change::Add(corners) => {
                self.triangles.insert(from_least(corners));
            }
            Change::Remove(corners) => {
                self.triangles.remove(&from_least(corners));
            }
            Change::Pierce(corners) => {
                self.triangles.remove(&from_least(corners));
                self.pierced.push(corners);
            }
            Change::Join(vertex, after) => {
                if let Some(at) = self.front.iter().position(|&v| v == after) {
                    self.front.insert(at + 1, vertex);
                }
            }
            Change::Leave(vertex) => self.front.retain(|&v| v != vertex),
            Change::Edge(ends) => {
                self.edge = Some(ends);
                self.forget_polygons();
            }
            Change::Border(polygon, vertex) => self.borders[polygon as usize].push(vertex),
            Change::Fix(mut ends) => {
                ends.sort_unstable();
                self.fixed.insert(ends);
                self.forget_polygons();
            }
            Change::About(_)
            | Change::Vertex(_)
            | Change::Line(_)
            | Change::Gone(_)
            | Change::Test(..) => {}
        }
    }

    fn forget_polygons(&mut self) {
        self.pierced.clear();
        self.borders.iter_mut().for_each(Vec::clear);
    }
}

fn from_least(mut corners: [Vertex; 3]) -> [Vertex; 3] {
    let least = (0..3).min_by_key(|&corner| corners[corner]);
    corners.rotate_left(least.unwrap_or(0));
    corners
}

/// Some steps that follow one another.
#[derive(Debug)]
pub(super) struct Part<'a> {
    /// The number of the first one, counted from 1.
    pub(super) first: usize,
    pub(super) events: &'a [Event],
    /// The scene before the first one.
    pub(super) before: Scene,
    /// How many steps were asked for, if there is no limit.
    pub(super) wanted: usize,
}

impl<'a> Part<'a> {
    /// The steps with these numbers, as far as they exist, and at most `most` of them.
    pub(super) fn new(all: &'a [Event], steps: &RangeInclusive<usize>, most: usize) -> Part<'a> {
        let start = steps.start().saturating_sub(1).min(all.len());
        let end = (*steps.end()).min(all.len()).max(start);
        let mut before = Scene::new();
        for event in &all[..start] {
            before.advance(event);
        }
        Part {
            first: start + 1,
            events: &all[start..end.min(start.saturating_add(most))],
            before,
            wanted: end - start,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Part;
    use sweep_cdt::trace::Event;

    #[test]
    fn steps_that_do_not_exist_are_left_out() {
        let all = [Event::Finalization; 5];
        let part = |steps, most| {
            let part = Part::new(&all, &steps, most);
            [part.first, part.events.len(), part.wanted]
        };
        assert_eq!(part(1..=usize::MAX, 10), [1, 5, 5]);
        assert_eq!(part(2..=4, 10), [2, 3, 3]);
        assert_eq!(part(2..=4, 2), [2, 2, 3]);
        assert_eq!(part(0..=1, 10), [1, 1, 1]);
        assert_eq!(part(9..=12, 10), [6, 0, 0]);
        assert_eq!(part(4..=9, usize::MAX), [4, 2, 2]);
    }
}
