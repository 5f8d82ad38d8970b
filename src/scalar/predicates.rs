//! The ladder of stages for every sign: each stage decides what those before it have left open.
//!
//! | | stage | answers where |
//! |---|---|---|
//! | 1 | the [filter] for exact doubles | the determinant is beyond the bound on its error |
//! | 2 | in circle: all points as integers ([`IntegerPoints`]), once there were many near-ties | they are integers of 61 bits in one unit |
//! | 3 | the determinant of doubles on a coarse [lattice](super::lattice), or the filter for rounded doubles | it is not rounded, or is beyond its bound |
//! | 4 | in circle: integers on a finer lattice | all points are on one |
//! | 5 | the exact stages of [`f64`](super::f64) | the doubles are the coordinates |
//! | 6 | the [`Scalar`] itself | always |
//!
//! The sweep enters below the filter, which its innermost loops have inline, and adds what it knows of the artificial
//! points. The verifier and [`orient2d`] and [`in_circle`], for a few points, take all stages.
//! Why it is right: doubles stand for the coordinates only where they equal them, all times one power of two, which
//! changes no sign. Each stage answers only what it is certain of, and the last one answers all.
//! Cost: the filter's 2 to 4 ns for nearly all signs; below it 10 to 30 ns in integers. Integers of all points take 60
//! instructions and 16 bytes a vertex to make, and save 300 instructions at each near-tie.

#[cfg(not(feature = "std"))]
use core::cell::OnceCell as Once;
use core::cmp::Ordering;
use core::fmt;
use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};
#[cfg(feature = "std")]
use std::sync::OnceLock as Once;

use super::doubles::power;
use super::filter;
use super::integer_points::IntegerPoints;
use super::scale::Scale;
use super::{Scalar, Stage};
use crate::tuning::{NEAR_TIES, VERTICES_A_TIE};

/// A sign, and the exact stage that decided it; `None` if doubles did.
pub(crate) type Decision = (Ordering, Option<Stage>);

/// The caller's points, of some [`Scalar`]: the last stage of the ladder.
///
/// The sweep asks them through `dyn`, and only where doubles do not decide. So it is compiled once, in this crate, and
/// not once more for each scalar in the crates that use it.
pub(crate) trait ExactPoints {
    /// The order of two points by x.
    fn compare_x(&self, points: [u32; 2]) -> Ordering;

    /// The order of two points by y.
    fn compare_y(&self, points: [u32; 2]) -> Ordering;

    /// [`Scalar::orient2d`] of three points.
    fn orient2d(&self, points: [u32; 3]) -> (Ordering, Stage);

    /// [`Scalar::in_circle`] of four points.
    fn in_circle(&self, points: [u32; 4]) -> (Ordering, Stage);
}

impl<S: Scalar> ExactPoints for &[[S; 2]] {
    fn compare_x(&self, points: [u32; 2]) -> Ordering {
        let [a, b] = points.map(|i| &self[i as usize][0]);
        a.compare(b)
    }

    fn compare_y(&self, points: [u32; 2]) -> Ordering {
        let [a, b] = points.map(|i| &self[i as usize][1]);
        a.compare(b)
    }

    fn orient2d(&self, points: [u32; 3]) -> (Ordering, Stage) {
        let [a, b, c] = points.map(|i| &self[i as usize]);
        S::orient2d_by_stage(a, b, c)
    }

    fn in_circle(&self, points: [u32; 4]) -> (Ordering, Stage) {
        let [a, b, c, d] = points.map(|i| &self[i as usize]);
        S::in_circle_by_stage(a, b, c, d)
    }
}

impl fmt::Debug for dyn ExactPoints + '_ {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ExactPoints").finish_non_exhaustive()
    }
}

/// The predicates of vertices, which have numbers.
pub(crate) struct Predicates<'a, E: ?Sized> {
    /// The caller's points.
    pub(crate) points: &'a E,
    /// For each vertex its point.
    pub(crate) index: &'a [u32],
    /// For each vertex its approximated coordinates, on one scale.
    pub(crate) approx: &'a [[f64; 2]],
    pub(crate) scale: &'a Scale,
    pub(crate) near_ties: &'a NearTies,
}

impl<E: ExactPoints + ?Sized> Predicates<'_, E> {
    /// `Greater` if three vertices turn left.
    #[inline(always)]
    pub(crate) fn orient2d(&self, vertices: [u32; 3]) -> Decision {
        match filter::orient2d(self.doubles(vertices), *self.scale) {
            Some(sign) => (sign, None),
            None => self.orient2d_cold(vertices),
        }
    }

    /// `Greater` if the last vertex lies inside the circle through the first three, which are counter-clockwise.
    #[inline(always)]
    pub(crate) fn in_circle(&self, vertices: [u32; 4]) -> Decision {
        match filter::in_circle(self.doubles(vertices), *self.scale) {
            Some(sign) => (sign, None),
            None => self.in_circle_cold(vertices),
        }
    }

    #[cold]
    #[inline(never)]
    fn orient2d_cold(&self, vertices: [u32; 3]) -> Decision {
        self.orient2d_below_filter(vertices)
    }

    #[cold]
    #[inline(never)]
    fn in_circle_cold(&self, vertices: [u32; 4]) -> Decision {
        self.in_circle_below_filter(vertices)
    }

    /// [`orient2d`](Predicates::orient2d) where the filter for exact doubles does not decide.
    #[inline(always)]
    pub(crate) fn orient2d_below_filter(&self, vertices: [u32; 3]) -> Decision {
        let exact = || self.points.orient2d(self.inputs(vertices));
        orient2d_below_filter(self.doubles(vertices), self.scale, exact)
    }

    /// [`in_circle`](Predicates::in_circle) where the filter for exact doubles does not decide.
    #[inline(always)]
    pub(crate) fn in_circle_below_filter(&self, vertices: [u32; 4]) -> Decision {
        if let Some(integers) = self.near_ties.integers.get()
            && let Some(sign) = integers.in_circle(vertices.map(|v| v as usize))
        {
            return (sign, Some(Stage::Integers));
        }
        let exact = || self.points.in_circle(self.inputs(vertices));
        let note = || self.near_ties.note(self);
        in_circle_below_filter(self.doubles(vertices), self.scale, note, exact)
    }

    #[inline(always)]
    fn doubles<const N: usize>(&self, vertices: [u32; N]) -> [[f64; 2]; N] {
        vertices.map(|v| self.approx[v as usize])
    }

    /// The points of vertices.
    #[inline(always)]
    fn inputs<const N: usize>(&self, vertices: [u32; N]) -> [u32; N] {
        vertices.map(|v| self.index[v as usize])
    }
}

/// How many in-circle tests came down to the exact stages of doubles, and the vertices as integers once they are many.
#[derive(Debug, Default)]
pub(crate) struct NearTies {
    count: AtomicUsize,
    integers: Once<IntegerPoints>,
}

impl NearTies {
    /// Counts a near-tie; makes integers of all vertices once these are many. Counts lost between threads delay that.
    #[cold]
    #[inline(never)]
    fn note<E: ?Sized>(&self, of: &Predicates<'_, E>) {
        let count = self.count.load(Relaxed) + 1;
        self.count.store(count, Relaxed);
        let n = of.index.len();
        if count == NEAR_TIES + n / VERTICES_A_TIE && of.scale.is_injective() {
            self.integers
                .get_or_init(|| IntegerPoints::of(&of.approx[..n]));
        }
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        self.integers.get().map_or(0, IntegerPoints::heap_bytes)
    }
}

/// The orientation of points that the filter for exact doubles has left open.
#[inline(always)]
fn orient2d_below_filter(
    doubles: [[f64; 2]; 3],
    scale: &Scale,
    exact: impl FnOnce() -> (Ordering, Stage),
) -> Decision {
    let filtered = if scale.is_exact() {
        filter::orient2d_on_lattice(doubles, scale)
    } else {
        filter::orient2d_approx(doubles, scale)
    };
    if let Some(sign) = filtered {
        return (sign, None);
    }
    let (sign, stage) = if are_coordinates(doubles, scale) {
        let [a, b, c] = &doubles;
        f64::orient2d_by_stage(a, b, c)
    } else {
        exact()
    };
    (sign, Some(stage))
}

/// The in-circle sign of points that the filter for exact doubles has left open. Near-ties of doubles call `note`.
#[inline(always)]
fn in_circle_below_filter(
    doubles: [[f64; 2]; 4],
    scale: &Scale,
    note: impl FnOnce(),
    exact: impl FnOnce() -> (Ordering, Stage),
) -> Decision {
    let filtered = if scale.is_exact() {
        filter::in_circle_on_lattice(doubles, scale)
    } else {
        filter::in_circle_approx(doubles, scale)
    };
    if let Some(sign) = filtered {
        return (sign, None);
    }
    let (sign, stage) = if let Some(sign) = scale.lattice().in_circle(doubles) {
        (sign, Stage::Integers)
    } else if are_coordinates(doubles, scale) {
        note();
        let [a, b, c, d] = &doubles;
        f64::in_circle_by_stage(a, b, c, d)
    } else {
        exact()
    };
    (sign, Some(stage))
}

/// Whether doubles are the coordinates up to a power of two. They lie nearer in memory than the caller's points.
fn are_coordinates<const N: usize>(doubles: [[f64; 2]; N], scale: &Scale) -> bool {
    scale.is_injective() || scale.is_exact() && doubles.iter().flatten().all(|x| x.is_finite())
}

/// `Greater` if `a`, `b`, `c` make a left turn, as [`Scalar::orient2d`] says, behind the floating-point filter.
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::orient2d;
///
/// assert_eq!(orient2d(&[0, 0], &[1, 0], &[0, 1]), Ordering::Greater);
/// assert_eq!(orient2d(&[0.1, 0.1], &[0.2, 0.2], &[0.3, 0.3]), Ordering::Equal);
/// ```
pub fn orient2d<S: Scalar>(a: &[S; 2], b: &[S; 2], c: &[S; 2]) -> Ordering {
    let filtered = unscaled([a, b, c]).and_then(|doubles| filter::orient2d(doubles, Scale::EXACT));
    filtered.unwrap_or_else(|| {
        let (doubles, scale) = scaled([a, b, c]);
        let exact = || S::orient2d_by_stage(a, b, c);
        let filtered = filter::orient2d(doubles, scale);
        filtered.unwrap_or_else(|| orient2d_below_filter(doubles, &scale, exact).0)
    })
}

/// `Greater` if `d` lies inside the circle through `a`, `b`, `c`, as [`Scalar::in_circle`] says, behind the filter.
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::in_circle;
///
/// let [a, b, c] = [[0, 0], [2, 0], [2, 2]];
/// assert_eq!(in_circle(&a, &b, &c, &[1, 1]), Ordering::Greater);
/// assert_eq!(in_circle(&a, &b, &c, &[0, 2]), Ordering::Equal);
/// ```
pub fn in_circle<S: Scalar>(a: &[S; 2], b: &[S; 2], c: &[S; 2], d: &[S; 2]) -> Ordering {
    let points = [a, b, c, d];
    let filtered = unscaled(points).and_then(|doubles| filter::in_circle(doubles, Scale::EXACT));
    filtered.unwrap_or_else(|| {
        let (doubles, scale) = scaled(points);
        let exact = || S::in_circle_by_stage(a, b, c, d);
        let filtered = filter::in_circle(doubles, scale);
        filtered.unwrap_or_else(|| in_circle_below_filter(doubles, &scale, || {}, exact).0)
    })
}

/// The coordinates of a few points as doubles, if the filter is right of them as they are: no product overflows.
#[inline(always)]
fn unscaled<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> Option<[[f64; 2]; N]> {
    let doubles = points.map(|[x, y]| [x.approx(), y.approx()]);
    let largest = doubles
        .iter()
        .flatten()
        .fold(0.0, |largest: f64, x| largest.max(x.abs()));
    (S::APPROX_IS_EXACT && largest < power(200)).then_some(doubles)
}

/// Doubles for a few points, on a scale of their own.
#[cold]
fn scaled<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> ([[f64; 2]; N], Scale) {
    let mut doubles = points.map(|[x, y]| [x.approx(), y.approx()]);
    let scale = Scale::unify(&mut doubles, S::APPROX_IS_EXACT);
    (doubles, scale)
}
