//! Whether edges have nothing in common but ends: the sweep of Shamos and Hoey (1976).
//!
//! A line goes over the plane from left to right and keeps the edges that it crosses, from below. Where an edge starts
//! it gets two neighbours on the line, and where one ends its two neighbours become those of each other. These pairs
//! alone are tested. *Left* is meant in the order (x, y), so that no edge is vertical.
//!
//! ```text
//!      |  .--'      An edge starts at v: it is tested against the one below v and the one above v.
//!    --+-'
//!      v-------
//!    --+----.
//!      |     '--
//! ```
//!
//! Why it is right: before the first point that two edges have in common, the order on the line holds. Just before it,
//! the two are neighbours, since what is between them would have to pass the point too. They were tested when they became
//! neighbours. The search stops there, so an order that does not hold is never used. Edges that touch or overlap count
//! as those that cross, even where a vertex is in common: the caller looks at them in another way.
//!
//! Cost: O(n log n) exact signs for n edges, in O(n) memory.

use alloc::collections::BTreeSet;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use crate::scalar::{Scalar, orient2d};

/// An edge on the line.
#[derive(Debug)]
struct OnLine<'a, S> {
    number: usize,
    left: &'a [S; 2],
    right: &'a [S; 2],
}

/// Whether no two of these edges, each given by its ends, have a point in common that is not an end of both. An edge of
/// no length is left out. An edge that is given twice overlaps itself.
pub(super) fn are_disjoint<'a, S: Scalar + 'a>(
    edges: impl Iterator<Item = [&'a [S; 2]; 2]>,
) -> bool {
    // Where an edge starts (`true`) and where it ends, by its number.
    let mut events: Vec<(bool, usize)> = Vec::new();
    let mut list: Vec<OnLine<'a, S>> = Vec::new();
    for [a, b] in edges {
        let (left, right) = match order(a, b) {
            Ordering::Less => (a, b),
            Ordering::Equal => continue,
            Ordering::Greater => (b, a),
        };
        let number = list.len();
        events.extend([(true, number), (false, number)]);
        list.push(OnLine {
            number,
            left,
            right,
        });
    }
    let at = |&(starts, number): &(bool, usize)| {
        let edge = &list[number];
        if starts { edge.left } else { edge.right }
    };
    // At a vertex edges end before others start.
    events.sort_unstable_by(|one, other| order(at(one), at(other)).then(one.0.cmp(&other.0)));

    let mut line: BTreeSet<&OnLine<'a, S>> = BTreeSet::new();
    // For each edge on the line the one below and the one above; where there is none, the place after all edges.
    let outside = list.len();
    let mut beside = vec![[outside; 2]; outside + 1];
    let meet = |one: usize, other: usize| {
        let pair = list.get(one).zip(list.get(other));
        pair.is_some_and(|(one, other)| one.meets(other))
    };
    events.into_iter().all(|(starts, number)| {
        let edge = &list[number];
        if starts {
            let lower = line.range::<&OnLine<'_, S>, _>(..edge).next_back();
            let below = lower.map_or(outside, |edge| edge.number);
            let above = beside[below][1];
            beside[number] = [below, above];
            beside[below][1] = number;
            beside[above][0] = number;
            !meet(below, number) && !meet(number, above) && line.insert(edge)
        } else {
            let [below, above] = beside[number];
            beside[below][1] = above;
            beside[above][0] = below;
            line.remove(edge) && !meet(below, above)
        }
    })
}

/// The order in which the line reaches points.
fn order<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[0].compare(&b[0]).then_with(|| a[1].compare(&b[1]))
}

impl<S: Scalar> OnLine<'_, S> {
    /// Whether a point lies above the edge, on the line through it, or below.
    fn turn(&self, point: &[S; 2]) -> Ordering {
        orient2d(self.left, self.right, point)
    }

    /// Where another edge on the line is, at the later one of the two left ends: above this edge, on it, or below.
    fn start(&self, other: &Self) -> Ordering {
        match order(self.left, other.left) {
            Ordering::Less => self.turn(other.left),
            Ordering::Equal => self.turn(other.right),
            Ordering::Greater => other.turn(self.left).reverse(),
        }
    }

    /// Where another edge on the line is, at the earlier one of the two right ends.
    fn end(&self, other: &Self) -> Ordering {
        match order(self.right, other.right) {
            Ordering::Less => other.turn(self.right).reverse(),
            Ordering::Equal => self.turn(other.left),
            Ordering::Greater => self.turn(other.right),
        }
    }

    /// Whether two edges on the line have a point in common that is not an end of both.
    fn meets(&self, other: &Self) -> bool {
        let start = self.start(other);
        start.is_eq() || start != self.end(other)
    }
}

/// The order on the line, from below. Edges are equal only if they meet.
impl<S: Scalar> Ord for OnLine<'_, S> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.start(other).reverse()
    }
}

impl<S: Scalar> PartialOrd for OnLine<'_, S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for OnLine<'_, S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for OnLine<'_, S> {}

#[cfg(test)]
mod tests {
    use super::are_disjoint;

    fn judged(edges: &[[[i32; 2]; 2]]) -> bool {
        let edges: Vec<_> = edges
            .iter()
            .map(|ends| ends.map(|p| p.map(f64::from)))
            .collect();
        are_disjoint(edges.iter().map(|ends| ends.each_ref()))
    }

    #[test]
    fn edges_may_meet_in_their_ends_alone() {
        let fan = [
            [[0, 0], [4, 1]],
            [[0, 0], [4, 3]],
            [[0, 0], [0, 5]],
            [[4, 1], [4, 3]],
        ];
        assert!(judged(&fan));
        let touching = [[[0, 0], [4, 0]], [[2, 0], [3, 5]]];
        let ending = [[[0, 0], [4, 0]], [[1, 5], [2, 0]]];
        let overlapping = [[[0, 0], [4, 0]], [[2, 0], [6, 0]]];
        let crossing = [[[0, 0], [4, 4]], [[0, 4], [4, 0]]];
        let twice = [[[0, 0], [4, 4]], [[4, 4], [0, 0]]];
        for pair in [touching, ending, overlapping, crossing, twice] {
            assert!(!judged(&pair), "{pair:?}");
        }
    }

    /// Up to five segments of a small lattice, against every pair of them in whole numbers.
    #[test]
    fn as_every_pair_by_itself() {
        const SIDE: u32 = 3;
        let at = |k: u32| [(k / SIDE) as i32, (k % SIDE) as i32];
        let mut state = 1_u32;
        let mut below = |n: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % n
        };
        let mut counts = [0; 2];
        for _ in 0..20_000 {
            let edges: Vec<[[i32; 2]; 2]> = (0..1 + below(5))
                .map(|_| [at(below(9)), at(below(9))])
                .collect();
            let expected = (0..edges.len()).all(|f| (0..f).all(|e| apart(edges[e], edges[f])));
            assert_eq!(judged(&edges), expected, "{edges:?}");
            counts[usize::from(expected)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 2000), "{counts:?}");
    }

    /// Whether two segments with whole coordinates up to 2 have nothing in common but ends: every point that two such
    /// segments can share is an end of both, an end of one, or a crossing.
    fn apart(one: [[i32; 2]; 2], other: [[i32; 2]; 2]) -> bool {
        let turn = |[a, b]: [[i32; 2]; 2], c: [i32; 2]| {
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
        };
        let has_length = |[a, b]: [[i32; 2]; 2]| a != b;
        if !has_length(one) || !has_length(other) {
            return true;
        }
        // Strictly inside: on the line, and between the ends.
        let is_inside = |[a, b]: [[i32; 2]; 2], c: [i32; 2]| {
            let dot = (a[0] - c[0]) * (b[0] - c[0]) + (a[1] - c[1]) * (b[1] - c[1]);
            turn([a, b], c) == 0 && dot < 0
        };
        let cross = turn(one, other[0]) * turn(one, other[1]) < 0
            && turn(other, one[0]) * turn(other, one[1]) < 0;
        let is_same = one == other || one == [other[1], other[0]];
        !cross
            && !is_same
            && !other.iter().any(|&end| is_inside(one, end))
            && !one.iter().any(|&end| is_inside(other, end))
    }
}
