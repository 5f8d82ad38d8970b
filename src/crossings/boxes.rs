//! Upright boxes, and which of them meet: pairs of edges that may cross, and vertices that a piece may pass.
//!
//! The boxes are in an order in which neighbours are near each other. The order is halved repeatedly, and each range
//! has a box around its boxes (a tree in an array). A search for boxes that meet a given one skips ranges whose box
//! does not.
//!
//! ```text
//!           1                The ranges by number. Range k has the halves 2k and 2k + 1, so that the one to
//!       2       3            the right of a range and all its halves is found by its number alone.
//!     4   5   6   7
//! ```
//!
//! Why it is right: boxes are made of approximations, which are monotone ([`Scalar::approx`]), and are only compared.
//! So edges and cells with a point in common have boxes that meet, however large, small or close the coordinates are. A
//! range that is skipped holds no box that meets the given one. A search along a segment also skips ranges whose box is
//! beside it, by more than the errors of doubles. Cost: O(n log n) to build, with one selection for each
//! range; for each search O(log n) where boxes are spread, and all that it finds.

use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;
use core::convert::Infallible;

/// A range is not halved if its halves would have fewer boxes.
const LEAST: usize = 4;

/// An upright box: its lower left and its upper right corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    /// The box around nothing, which meets no other.
    const NOTHING: Bounds = Bounds {
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    pub(super) fn of<S: Scalar>(points: [&[S; 2]; 2]) -> Bounds {
        let [a, b] = points.map(|point| point.each_ref().map(S::approx));
        Bounds { low: a, high: a }.and(Bounds { low: b, high: b })
    }

    fn and(self, other: Bounds) -> Bounds {
        Bounds {
            low: [0, 1].map(|i| self.low[i].min(other.low[i])),
            high: [0, 1].map(|i| self.high[i].max(other.high[i])),
        }
    }

    fn meets(&self, other: &Bounds) -> bool {
        (0..2).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    /// Whether the box lies on one side of the line through two points, for certain, the doubles being no more than
    /// approximations of box and points.
    ///
    /// With the larger size M of all coordinates each of them is off by at most 2^-52 M, and so each difference by at
    /// most 2^-50 M, its rounding included. The corner that is nearest to the line is where the cross product of the
    /// line and the way to the middle falls by the half sizes of the box. A product of two differences is off by at most
    /// 2^-50 M times their sizes, where these are larger than that; if they are not, the answer is `false`. With what is
    /// rounded afterwards all of it is less than 2^-48 M times the sum of the sizes; the bound has 2^-47. Where numbers
    /// overflow or are so small that digits are lost, the answer is `false` as well.
    fn is_beside(&self, [a, b]: [[f64; 2]; 2]) -> bool {
        const OFF: f64 = 32.0 * f64::EPSILON;
        let all = [a, b, self.low, self.high];
        let largest = all
            .as_flattened()
            .iter()
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        let along = [0, 1].map(|i| b[i] - a[i]);
        let to = [0, 1].map(|i| self.middle(i) - a[i]);
        let half = [0, 1].map(|i| self.high[i] / 2.0 - self.low[i] / 2.0);
        let cross = along[0] * to[1] - along[1] * to[0];
        let reach = along[0].abs() * half[1] + along[1].abs() * half[0];
        let sizes = [along, to, half]
            .as_flattened()
            .iter()
            .fold(0.0, |sum, x| sum + x.abs());
        cross.abs() > reach + OFF * largest * sizes + f64::MIN_POSITIVE
    }

    /// The middle along an axis, as far as doubles tell.
    fn middle(&self, axis: usize) -> f64 {
        self.low[axis] / 2.0 + self.high[axis] / 2.0
    }
}

#[derive(Debug)]
pub(super) struct Boxes {
    /// Each box with its position in the list given, in the order of the tree.
    list: Vec<(usize, Bounds)>,
    /// The box around each range, by number.
    around: Vec<Bounds>,
    /// How often the order is halved.
    height: u32,
}

impl Boxes {
    pub(super) fn new(list: impl Iterator<Item = Bounds>) -> Boxes {
        let list: Vec<(usize, Bounds)> = list.enumerate().collect();
        let height = (list.len() / LEAST).checked_ilog2().unwrap_or(0);
        let mut boxes = Boxes {
            list,
            around: vec![Bounds::NOTHING; 2 << height],
            height,
        };
        for number in 1..boxes.around.len() {
            let (from, to) = boxes.range(number);
            let range = boxes.list[from..to].iter();
            let around = range.fold(Bounds::NOTHING, |all, (_, one)| all.and(*one));
            boxes.around[number] = around;
            if number >> boxes.height == 0 {
                let half = boxes.range(2 * number).1 - from;
                let size = [0, 1].map(|i| around.high[i] - around.low[i]);
                let axis = usize::from(size[1] > size[0]);
                let middle = |(_, one): &(usize, Bounds)| one.middle(axis);
                boxes.list[from..to]
                    .select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
            }
        }
        boxes
    }

    /// Where a range begins and ends.
    fn range(&self, number: usize) -> (usize, usize) {
        let depth = number.ilog2();
        let place = number - (1 << depth);
        let cut = |place: usize| {
            // The product may be wider than a position.
            let cut = (self.list.len() as u128 * place as u128) >> depth;
            usize::try_from(cut).expect("a position")
        };
        (cut(place), cut(place + 1))
    }

    /// Passes each pair of boxes that meet, once, to `report`, until that returns an error.
    pub(super) fn pairs<E>(
        &self,
        mut report: impl FnMut([usize; 2]) -> Result<(), E>,
    ) -> Result<(), E> {
        for (position, &(one, bounds)) in self.list.iter().enumerate() {
            let meets = |other: &Bounds| bounds.meets(other);
            self.search(position + 1, meets, |other| report([one, other]))?;
        }
        Ok(())
    }

    /// Passes each box that meets the segment between two points to `report`, and some that do not.
    pub(super) fn near<S: Scalar>(&self, ends: [&[S; 2]; 2], mut report: impl FnMut(usize)) {
        let bounds = Bounds::of(ends);
        let ends = ends.map(|point| point.each_ref().map(S::approx));
        let meets = |other: &Bounds| bounds.meets(other) && !other.is_beside(ends);
        let Ok(()) = self.search(0, meets, |one| {
            report(one);
            Ok::<(), Infallible>(())
        });
    }

    /// Passes each box of which `meets` holds, from position `first` on, to `report`, until that returns an error.
    /// Boxes inside a box of which `meets` does not hold are left out.
    fn search<E>(
        &self,
        first: usize,
        meets: impl Fn(&Bounds) -> bool,
        mut report: impl FnMut(usize) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut number = 1;
        loop {
            let (from, to) = self.range(number);
            let is_of_use = first < to && meets(&self.around[number]);
            if is_of_use && number >> self.height == 0 {
                number *= 2;
                continue;
            }
            if is_of_use {
                let range = self.list[from.max(first)..to].iter();
                for (one, _) in range.filter(|(_, at)| meets(at)) {
                    report(*one)?;
                }
            }
            // The range to the right of this one, or of the smallest range around it that has such a neighbour.
            number = (number >> number.trailing_ones()) + 1;
            if number == 1 {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Boxes};

    #[test]
    fn every_pair_that_meets_is_found_once() {
        for count in (0..40).chain([100, 257]) {
            let coordinate =
                |i: usize, by: usize| f64::from(u8::try_from(i * by % 61).expect("61"));
            let end = |i| [coordinate(i, 17), coordinate(i, 23)];
            let points: Vec<[f64; 2]> = (0..2 * count).map(end).collect();
            let edges: Vec<[usize; 2]> = (0..count).map(|e| [2 * e, 2 * e + 1]).collect();
            let meet = |e: usize, f: usize| {
                (0..2).all(|i| {
                    let [a, b, c, d] = [2 * e, 2 * e + 1, 2 * f, 2 * f + 1].map(|v| points[v][i]);
                    a.max(b) >= c.min(d) && c.max(d) >= a.min(b)
                })
            };
            let pairs = (0..count).flat_map(|f| (0..f).map(move |e| [e, f]));
            let expected: Vec<_> = pairs.filter(|&[e, f]| meet(e, f)).collect();
            let mut found = Vec::new();
            let bounds = edges
                .iter()
                .map(|edge| Bounds::of(edge.map(|v| &points[v])));
            let boxes = Boxes::new(bounds);
            let reported = boxes.pairs(|[e, f]| {
                found.push([e.min(f), e.max(f)]);
                Ok::<(), ()>(())
            });
            assert_eq!(reported, Ok(()));
            found.sort_unstable_by_key(|&[e, f]| [f, e]);
            assert_eq!(found, expected, "{count} edges");
        }
    }
}
