//! Where many points lie: walks from each to the next along a curve, and a sweep where walks are long.
//!
//! Points that follow each other along Hilbert's curve (1891) are near each other, so a walk from one to the next has
//! few steps. All walks together have as many steps as there are triangles and points, times [`STEPS_TO_LOCATE`]. In
//! slivers and clusters that may not do: once the steps are spent, a sweep finds all points that are left
//! ([`super::strips`]).
//!
//! Why it is right: a location is the same wherever the walk began, and by the sweep.
//!
//! Cost: O((n + m) log(n + m)) for n triangles and m points, whatever they are. Where both are spread evenly, walks have
//! O(m + sqrt(n m)) steps, and the points are sorted once. Few points, at most the cube root of n, each take a jump and
//! a walk, as [`WithPoints::locate`] does.

use alloc::vec;
use alloc::vec::Vec;

use crate::scalar::Scalar;
use crate::triangulation::locate::Location;
use crate::triangulation::strips;
use crate::triangulation::with_points::WithPoints;
use crate::tuning::STEPS_TO_LOCATE;

impl<S: Scalar> WithPoints<'_, S> {
    /// Where each of these points lies: what [`locate`](Self::locate) says, in the order given, and in less time than
    /// by calls for each.
    ///
    /// O((n + m) log(n + m)) for n triangles and m points, however thin the triangles are and in whatever order the
    /// points come.
    ///
    /// ```
    /// use sweep_cdt::Location;
    ///
    /// let points = [[0, 0], [4, 0], [4, 4], [0, 4]];
    /// let result = sweep_cdt::triangulate(&points, &[[0, 2]])?;
    /// let found = result.with_points(&points).locate_all(&[[3, 1], [9, 9], [4, 4], [1, 3]]);
    /// let [Location::Triangle(lower), _, _, Location::Triangle(upper)] = found[..] else {
    ///     panic!("two of them are inside of triangles");
    /// };
    /// assert!(result.triangle(lower).contains(&1) && result.triangle(upper).contains(&3));
    /// assert_eq!(found[1..3], [Location::Outside, Location::Vertex(2)]);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn locate_all(&self, queries: &[[S; 2]]) -> Vec<Location> {
        self.locate_within(queries, STEPS_TO_LOCATE).0
    }

    /// As [`locate_all`](Self::locate_all), with so many steps of walks for each triangle and point; and how many steps
    /// were taken: for tests.
    #[doc(hidden)]
    pub fn locate_within(&self, queries: &[[S; 2]], steps: usize) -> (Vec<Location>, usize) {
        let mut found = vec![Location::Outside; queries.len()];
        let count = self.result.len();
        if count == 0 {
            return (found, 0);
        }
        let order = along_curve(queries);
        let are_few = order.len().saturating_pow(3) <= count;
        let all = (count + order.len()).saturating_mul(steps);
        let (mut left, mut last) = (all, None);
        for (place, &at) in order.iter().enumerate() {
            let query = &queries[at];
            let start = last.filter(|_| !are_few);
            let start = start.unwrap_or_else(|| self.start(query));
            let Some((location, triangle)) = self.walk(query, start, &mut left) else {
                strips::locate(self, queries, order[place..].to_vec(), &mut found);
                break;
            };
            found[at] = location;
            last = Some(triangle);
        }
        (found, all - left)
    }
}

/// The positions of the points whose coordinates are finite, along Hilbert's curve around all of them.
fn along_curve<S: Scalar>(queries: &[[S; 2]]) -> Vec<usize> {
    let mut order: Vec<(u64, usize)> = Vec::with_capacity(queries.len());
    // Halves: their differences do not overflow.
    let near = |query: &[S; 2]| query.each_ref().map(|x| x.approx() / 2.0);
    let is_finite = |query: &&[S; 2]| query.iter().all(S::is_finite);
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for query in queries.iter().filter(is_finite).map(near) {
        low = [0, 1].map(|i| query[i].min(low[i]));
        high = [0, 1].map(|i| query[i].max(high[i]));
    }
    for (at, query) in queries.iter().enumerate() {
        if is_finite(&query) {
            let query = near(query);
            order.push((key([0, 1].map(|i| cell(query[i], low[i], high[i]))), at));
        }
    }
    order.sort_unstable();
    order.into_iter().map(|(_, at)| at).collect()
}

/// The number of the cell of a coordinate, from 0 up.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a part from 0 to 1; what is none counts as 0"
)]
fn cell(x: f64, low: f64, high: f64) -> u32 {
    ((x - low) / (high - low) * f64::from(u32::MAX)) as u32
}

/// The place of a cell on the curve.
fn key([mut x, mut y]: [u32; 2]) -> u64 {
    let mut key = 0;
    for bit in (0..u32::BITS).rev() {
        let [right, above] = [x, y].map(|number| (number >> bit) & 1);
        key = (key << 2) | u64::from((3 * right) ^ above);
        if above == 0 {
            if right == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::key;

    #[test]
    fn the_curve_goes_from_each_cell_to_one_beside_it() {
        const SIDE: u32 = 16;
        let shift = u32::BITS - SIDE.ilog2();
        let cells = (0..SIDE * SIDE).map(|i| [i % SIDE, i / SIDE]);
        let mut cells: Vec<[u32; 2]> = cells.collect();
        cells.sort_unstable_by_key(|cell| key(cell.map(|x| x << shift)));
        for pair in cells.windows(2) {
            let steps = [0, 1].map(|i| pair[0][i].abs_diff(pair[1][i]));
            assert_eq!(steps[0] + steps[1], 1, "{pair:?}");
        }
    }
}
