//! Where a point lies in a triangulation: jump and walk (Mücke, Saias and Zhu 1999), with exact signs.
//!
//! The walk starts at the nearest triangle of a sample, or at one that the caller names. It leaves each triangle across
//! a side that has the point on its other side, until there is none.
//!
//! Why it is right: an exact sign says that the point is strictly on the other side of each side that the walk crosses.
//! Where there is no such side the triangle holds the point, and the signs that are zero tell the side or the corner.
//! Where nothing is across, the point is outside: the hull is convex. Doubles choose only where the walk starts.
//!
//! Why it ends: where edges keep triangles from being Delaunay, a walk may come back to where it was. So the side tried
//! first is drawn at random in each triangle (Devillers, Pion and Teillaud 2001), which lets no walk go round for ever.
//! If a walk takes more steps than there are triangles, or there are few, all are looked at instead.
//!
//! Cost: for n triangles over points spread evenly, about n^(1/3) triangles to start from and as many steps; from a
//! triangle near by as many steps as lie between. O(n) at worst. Many points have a call of their own
//! ([`super::locate_all`]).

use core::cmp::Ordering;

use crate::ids::TriangleId;
use crate::mesh::{HalfEdge, next, prev};
use crate::scalar::{Scalar, orient2d};
use crate::triangulation::with_points::WithPoints;
use crate::tuning::LOOKED_AT_ONE_BY_ONE;

/// Where a point lies; the same wherever the search began.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Location {
    /// Inside a triangle.
    Triangle(usize),
    /// Inside a side of a triangle: of the two triangles beside it, the one with the lower number.
    Side {
        /// The triangle.
        triangle: usize,
        /// The side, opposite this corner: 0, 1 or 2.
        side: usize,
    },
    /// At a vertex: the lowest of several equal points.
    Vertex(usize),
    /// Outside of the hull. If there are no triangles, everything is.
    Outside,
}

impl<S: Scalar> WithPoints<'_, S> {
    /// Where a point lies. A point with a coordinate that is not finite is outside.
    ///
    /// ```
    /// use sweep_cdt::Location;
    ///
    /// let points = [[0, 0], [4, 0], [4, 4], [0, 4]];
    /// let result = sweep_cdt::triangulate(&points, &[[0, 2]])?;
    /// let view = result.with_points(&points);
    /// let Location::Triangle(t) = view.locate(&[3, 1]) else {
    ///     panic!("it is inside one");
    /// };
    /// assert!(result.triangle(t).contains(&1));
    /// assert_eq!(view.locate(&[4, 4]), Location::Vertex(2));
    /// assert!(matches!(view.locate(&[3, 3]), Location::Side { .. }));
    /// assert_eq!(view.locate(&[5, 1]), Location::Outside);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn locate(&self, query: &[S; 2]) -> Location {
        if !query.iter().all(S::is_finite) {
            return Location::Outside;
        }
        self.locate_from(query, self.start(query))
    }

    /// The nearest triangle of a sample.
    pub(super) fn start(&self, query: &[S; 2]) -> usize {
        let approx = |point: &[S; 2]| [point[0].approx(), point[1].approx()];
        let to = approx(query);
        let distance = |t: usize| {
            let [x, y] = approx(self.corner(t, 0));
            let [dx, dy] = [x - to[0], y - to[1]];
            dx * dx + dy * dy
        };
        let root = (1..).find(|root: &usize| root.pow(3) >= self.result.len());
        let step = self.result.len() / root.unwrap_or(1);
        let starts = (0..self.result.len()).step_by(step.max(1));
        let start = starts.min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        start.unwrap_or(0)
    }

    /// Where a point lies, by a walk from a triangle near by, such as the triangle of the last point. A triangle that
    /// does not exist counts as the first one.
    ///
    /// ```
    /// use sweep_cdt::Location;
    ///
    /// let points: Vec<_> = (0..400).map(|i| [f64::from(i % 20), f64::from(i / 20)]).collect();
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let mut last = 0;
    /// let view = result.with_points(&points);
    /// for step in 0..100 {
    ///     let query = [f64::from(step) * 0.19, 7.25];
    ///     let found = view.locate_from(&query, last);
    ///     assert_eq!(found, view.locate(&query));
    ///     if let Location::Triangle(t) = found {
    ///         last = t;
    ///     }
    /// }
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn locate_from(&self, query: &[S; 2], triangle: usize) -> Location {
        if !query.iter().all(S::is_finite) {
            return Location::Outside;
        }
        if self.result.len() <= LOOKED_AT_ONE_BY_ONE {
            return self.look(query);
        }
        let start = if triangle < self.result.len() {
            triangle
        } else {
            0
        };
        let found = self.walk(query, start, &mut (self.result.len() + 1));
        found.map_or_else(|| self.look(query), |(location, _)| location)
    }

    /// Walks from a triangle to another one, where the point lies or the hull ends, unless that takes more steps than are
    /// left.
    pub(super) fn walk(
        &self,
        query: &[S; 2],
        start: usize,
        left: &mut usize,
    ) -> Option<(Location, usize)> {
        let (mut t, mut random) = (start, 1_u32);
        loop {
            *left = left.checked_sub(1)?;
            let turns = self.turns(query, t);
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let first = (random >> 16) % 3;
            let sides = [first, next(first), prev(first)];
            let Some(side) = sides.into_iter().find(|&side| turns(side).is_lt()) else {
                return Some((self.at(t, [0, 1, 2].map(turns)), t));
            };
            let twin = self.result.triangles[t].twin(side);
            if twin.is_border() {
                return Some((Location::Outside, t));
            }
            t = twin.triangle().index();
        }
    }

    fn look(&self, query: &[S; 2]) -> Location {
        let holds = |t: &usize| (0..3).all(|side| self.turns(query, *t)(side).is_ge());
        match (0..self.result.len()).find(holds) {
            Some(t) => self.at(t, [0, 1, 2].map(self.turns(query, t))),
            None => Location::Outside,
        }
    }

    /// The turn from each side of a triangle to the point: to the left where the triangle is.
    fn turns<'q>(&'q self, query: &'q [S; 2], t: usize) -> impl Fn(u32) -> Ordering + Copy + 'q {
        let corner = move |i| self.corner(t, i);
        move |side| orient2d(corner(next(side)), corner(prev(side)), query)
    }

    fn vertex(&self, t: usize, corner: u32) -> usize {
        self.result
            .input_index(self.result.triangles[t].vertex(corner))
    }

    fn corner(&self, t: usize, corner: u32) -> &[S; 2] {
        &self.points[self.vertex(t, corner)]
    }

    /// The location of a point in a triangle, by its turns from the sides, none of them to the right.
    pub(super) fn at(&self, t: usize, turns: [Ordering; 3]) -> Location {
        let [a, b, c] = turns.map(Ordering::is_eq);
        let vertex = |i| Location::Vertex(self.vertex(t, i));
        let side = |i| {
            let twin = self.result.triangles[t].twin(i);
            let here = HalfEdge::new(TriangleId::at(t), i);
            let lower = if twin.is_border() {
                here
            } else {
                here.min(twin.unconstrained())
            };
            Location::Side {
                triangle: lower.triangle().index(),
                side: lower.corner() as usize,
            }
        };
        // A point on two sides is where they meet, opposite the third one.
        match [a, b, c] {
            [false, false, false] => Location::Triangle(t),
            [true, false, false] => side(0),
            [false, true, false] => side(1),
            [false, false, true] => side(2),
            [_, true, true] => vertex(0),
            [true, _, true] => vertex(1),
            [true, true, _] => vertex(2),
        }
    }
}
