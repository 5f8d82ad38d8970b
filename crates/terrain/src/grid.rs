//! A grid of square cells, and the heights of triangles at their centres.
//!
//! Cells lie at whole multiples of their size, so that grids of neighbouring terrains fit together. The centre of a cell is
//! the double that is nearest to an odd multiple of half the size.
//!
//! The cells of a row whose centres lie in a triangle are found side by side: going to the right, a centre passes each
//! side of the triangle once, so that the exact predicate tells by halving where. A centre on a side or at a vertex has the
//! height there, which is the same for all triangles around.
//!
//! Cost: log of the columns for each row that a triangle spans, and some predicates for each centre.

use std::cmp::Ordering;
use std::ops::Range;

use sweep_cdt::scalar::orient2d;

use crate::interpolate::{along, within};
use crate::passing::Corner;

/// A grid of square cells. Rows are counted from below, columns from the left.
///
/// ```
/// use sweep_cdt_terrain::Grid;
///
/// let grid = Grid::covering(2.0, [[-1.0, 3.0], [0.0, 4.0]]).unwrap();
/// assert_eq!((grid.columns(), grid.rows()), (3, 2));
/// assert_eq!(grid.corners(), [[-2.0, 0.0], [4.0, 4.0]]);
/// assert_eq!(grid.center(0, 2), [3.0, 1.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    cell: f64,
    /// Which multiples of the cell begin it: whole numbers.
    first: [f64; 2],
    size: [usize; 2],
}

/// Whole numbers up to here have halves.
const FAR: f64 = (1_u64 << 51) as f64;
/// So many rows or columns fit in an image.
const MOST: f64 = u32::MAX as f64;

impl Grid {
    /// The cells of this size that cover an interval of x and one of y; `None` if there is no interval, or if the cells are
    /// so small that there are too many, or that doubles cannot tell their centres apart.
    #[must_use]
    pub fn covering(cell: f64, intervals: [[f64; 2]; 2]) -> Option<Grid> {
        let axis = |[least, most]: [f64; 2]| {
            let first = (least / cell).floor();
            let last = ((most / cell).ceil() - 1.0).max(first);
            let count = last - first + 1.0;
            let is_fine = least <= most && first.abs().max(last.abs()) < FAR && count <= MOST;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number of at least 1 that is no larger than that"
            )]
            (is_fine && cell > 0.0).then_some((first, count as usize))
        };
        let [(x, columns), (y, rows)] = [axis(intervals[0])?, axis(intervals[1])?];
        columns.checked_mul(rows)?.checked_mul(size_of::<f64>())?;
        Some(Grid {
            cell,
            first: [x, y],
            size: [columns, rows],
        })
    }

    /// The size of a cell.
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// How many columns there are.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.size[0]
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.size[1]
    }

    /// The lower left corner, and the upper right one.
    #[must_use]
    pub fn corners(&self) -> [[f64; 2]; 2] {
        let [columns, rows] = self.size.map(|size| size as f64);
        let last = [self.first[0] + columns, self.first[1] + rows];
        [self.first, last].map(|corner| corner.map(|at| at * self.cell))
    }

    /// The centre of a cell.
    #[must_use]
    pub fn center(&self, row: usize, column: usize) -> [f64; 2] {
        [self.middle(0, column), self.middle(1, row)]
    }

    /// The coordinate of the centre of a column or row.
    fn middle(&self, axis: usize, at: usize) -> f64 {
        (2.0 * (self.first[axis] + at as f64) + 1.0) * (self.cell / 2.0)
    }

    /// The columns or rows whose centres lie in an interval.
    fn between(&self, axis: usize, [least, most]: [f64; 2]) -> Range<usize> {
        let near = |value: f64| {
            let near = (value / self.cell).floor() - self.first[axis];
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a number that is too large or too small becomes the nearest"
            )]
            (near as usize).min(self.size[axis])
        };
        // A quotient is rounded: centres tell.
        let split = |mut at: usize, is_before: &dyn Fn(f64) -> bool| {
            while at > 0 && !is_before(self.middle(axis, at - 1)) {
                at -= 1;
            }
            while at < self.size[axis] && is_before(self.middle(axis, at)) {
                at += 1;
            }
            at
        };
        let begin = split(near(least), &|middle| middle < least);
        begin..split(near(most), &|middle| middle <= most).max(begin)
    }

    /// The heights at the centres that lie in a triangle, whose corners are counter-clockwise: `put` gets a row, the first
    /// column and the heights from there on, NaN where a height that counts is missing.
    ///
    /// # Errors
    /// Errors of `put`.
    pub fn heights<E>(
        &self,
        corners: [Corner; 3],
        mut put: impl FnMut(usize, usize, &[f64]) -> Result<(), E>,
    ) -> Result<(), E> {
        let interval = |axis: usize| {
            let range = [f64::INFINITY, f64::NEG_INFINITY];
            let of_corners = corners.iter().map(|corner| corner.point[axis]);
            of_corners.fold(range, |[low, high], x| [low.min(x), high.max(x)])
        };
        let columns = self.between(0, interval(0));
        let mut heights = Vec::new();
        for row in self.between(1, interval(1)) {
            let inside = self.inside(row, columns.clone(), &corners);
            heights.clear();
            let centers = inside.clone().map(|column| self.center(row, column));
            heights.extend(centers.map(|center| height_at(center, &corners)));
            if !heights.is_empty() {
                put(row, inside.start, &heights)?;
            }
        }
        Ok(())
    }

    /// The columns among these of a row whose centres lie in a triangle.
    fn inside(&self, row: usize, columns: Range<usize>, corners: &[Corner; 3]) -> Range<usize> {
        let Range { mut start, mut end } = columns;
        for side in 0..3 {
            let [from, to] = [corners[side].point, corners[(side + 1) % 3].point];
            // How many columns are beyond the side, or not: the first ones are, until one is not.
            let split = |is_before: &dyn Fn(Ordering) -> bool| {
                let (mut low, mut high) = (start, end.max(start));
                while low < high {
                    let middle = low + (high - low) / 2;
                    match is_before(orient2d(&from, &to, &self.center(row, middle))) {
                        true => low = middle + 1,
                        false => high = middle,
                    }
                }
                low
            };
            if from[1] < to[1] {
                end = split(&Ordering::is_ge);
            } else {
                // Along a level side all centres are on one side of it.
                start = split(&Ordering::is_lt);
            }
        }
        start..end.max(start)
    }
}

/// The height at a place in a triangle.
fn height_at(place: [f64; 2], corners: &[Corner; 3]) -> f64 {
    #[expect(clippy::float_cmp, reason = "equal places are one place")]
    if let Some(corner) = corners.iter().find(|corner| corner.point == place) {
        return corner.height;
    }
    for side in 0..3 {
        let ends = [corners[side], corners[(side + 1) % 3]];
        let [from, to] = ends.each_ref().map(|end| &end.point);
        if orient2d(from, to, &place).is_eq() {
            let heights = ends.map(|end| end.height);
            let is_known = heights.iter().all(|height| !height.is_nan());
            return if is_known {
                along(&place, [from, to], heights)
            } else {
                f64::NAN
            };
        }
    }
    let heights = corners.map(|corner| corner.height);
    let is_known = heights.iter().all(|height| !height.is_nan());
    match is_known {
        true => within(
            &place,
            corners.each_ref().map(|corner| &corner.point),
            heights,
        ),
        false => f64::NAN,
    }
}
