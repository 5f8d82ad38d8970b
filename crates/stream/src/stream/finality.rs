//! When nothing that is to come can change a triangle, or a side of the hull.
//!
//! All vertices to come lie *beyond* a line: on the sweep line or above it, between the least and the greatest x. For a
//! band (`rest.rs`) they lie beyond either of two: the line, and the *floor*, which is a line upside down.
//!
//! ```text
//!     least x                    greatest x
//!        |     vertices to come     |
//!        +--------------------------+   the sweep line
//!     (  |  )         _
//!      ( |)          ( )                final: the circle's part in the range stays below the line
//!       \|            v
//! ```
//!
//! 1. **Circle rule.** A triangle is final if its closed circle meets no point beyond. On the circle counts, since a
//!    vertex on it may change which of two diagonals is made. Above the line the circle reaches highest at the x in the
//!    range that is nearest to its centre's: at the centre's own x, to its top; at the border otherwise, where the test is
//!    whether the point of the border on the line is in the circle. (The triangle lies below the line and in the range,
//!    so that from the border inwards the circle's lower half rises: it begins below the line.)
//! 2. **Hull.** A side of the hull is final if no point beyond the line lies beyond the side.
//!
//! Why it is right: the top of the circle is computed in doubles with a bound on every error ([`Near`]), and counts as
//! below the line only where that is certain. So a triangle may wait longer than it must, and never too short; what is
//! passed on is the same. All else is decided by exact signs. Cost: some 40 multiplications for each triangle of a window.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use sweep_cdt::scalar::{Scalar, in_circle, orient2d};

/// Whether a point is in the range of x.
pub(super) fn is_between<S: Scalar>(point: &[S; 2], between: Option<&[S; 2]>) -> bool {
    between.is_none_or(|[least, most]| {
        least.compare(&point[0]).is_le() && point[0].compare(most).is_le()
    })
}

/// The sweep line or the floor, and the borders of the range if they are known.
pub(super) struct Line<S> {
    y: S,
    /// How the y of what has come compares with the line's: less, and greater with a floor's.
    inner: Ordering,
    /// The points of the left and the right border on the line.
    ends: Option<[[S; 2]; 2]>,
}

impl<S: Scalar + Clone> Line<S> {
    /// The line through the next vertex.
    pub(super) fn new(next: &[S; 2], between: Option<&[S; 2]>) -> Self {
        let y = &next[1];
        let end = |x: &S| [x.clone(), y.clone()];
        Line {
            y: y.clone(),
            inner: Ordering::Less,
            ends: between.map(|[least, most]| [end(least), end(most)]),
        }
    }

    /// The floor through a vertex: others may come on it and below.
    pub(super) fn floor(first: &[S; 2], between: Option<&[S; 2]>) -> Self {
        Line {
            inner: Ordering::Greater,
            ..Line::new(first, between)
        }
    }

    /// The factor of all y under which the line is the upper one.
    fn up(&self) -> f64 {
        match self.inner {
            Ordering::Less => 1.0,
            _ => -1.0,
        }
    }

    /// Whether the closed circle of a counter-clockwise triangle meets no point beyond the line.
    #[inline]
    pub(super) fn is_clear_of_circle(&self, corners: [&[S; 2]; 3]) -> bool {
        S::APPROX_IS_EXACT && self.is_far_above(corners) || self.is_just_above(corners)
    }

    /// Whether the line is certainly higher above the lowest corner than the circle's diameter, by doubles that are the
    /// coordinates. The diameter is the product of the sides by twice the area. (A floor is lower below the highest one.)
    ///
    /// Each factor is exact but for some roundings: the area since it is not small beside its two terms, the squares of
    /// lengths since their terms are positive. So a thousandth is more than all of them, where nothing underflows.
    fn is_far_above(&self, [a, b, c]: [&[S; 2]; 3]) -> bool {
        let (ax, ay) = (a[0].approx(), a[1].approx());
        let (bx, by) = (b[0].approx(), b[1].approx());
        let (cx, cy) = (c[0].approx(), c[1].approx());
        let height = match self.inner {
            Ordering::Less => self.y.approx() - ay.min(by).min(cy),
            _ => ay.max(by).max(cy) - self.y.approx(),
        };
        let (ux, uy, vx, vy, wx, wy) = (bx - ax, by - ay, cx - ax, cy - ay, cx - bx, cy - by);
        let (left, right) = (ux * vy, uy * vx);
        let area = left - right;
        let (u, v, w) = (ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy);
        let reach = height * area;
        area > (1e-6 * (left.abs() + right.abs())).max(1e-200)
            && height > 0.0
            && u.min(v).min(w) > 1e-90
            && reach * reach > 1.001 * (u * v * w)
    }

    /// [`is_clear_of_circle`](Line::is_clear_of_circle) for circles near the line.
    #[cold]
    fn is_just_above(&self, [a, b, c]: [&[S; 2]; 3]) -> bool {
        let [bx, by] = vector(a, b);
        let [cx, cy] = vector(a, c);
        let (bb, cc) = (bx * bx + by * by, cx * cx + cy * cy);
        // The centre is (x, y) / d from a, and d is twice the area, twice.
        let two = Near::exact(2.0);
        let (x, y) = (cy * bb - by * cc, bx * cc - cx * bb);
        let d = two * (bx * cy - by * cx);
        let height = near(&self.y) - near(&a[1]);
        if !d.is_above_zero() {
            return false;
        }
        // The circle is clear of the line if the centre's distance from it is greater than the radius; all times d.
        let distance = (height * d - y).times_sign(self.up());
        let is_clear =
            distance.is_above_zero() && (distance * distance - (x * x + y * y)).is_above_zero();
        is_clear || self.is_above_border(x, d, [a, b, c])
    }

    /// Whether the circle, whose centre is `x / d` right of `a`, lies so far beyond a border that it meets the border
    /// below the line alone (above the floor alone).
    fn is_above_border(&self, x: Near, d: Near, [a, b, c]: [&[S; 2]; 3]) -> bool {
        let Some([left, right]) = &self.ends else {
            return false;
        };
        let [to_left, to_right] = [left, right].map(|end| near(&end[0]) - near(&a[0]));
        let border = if (to_left * d - x).is_above_zero() {
            left
        } else if (x - to_right * d).is_above_zero() {
            right
        } else {
            return false;
        };
        [a, b, c]
            .iter()
            .all(|p| p[1].compare(&self.y) == self.inner)
            && in_circle(a, b, c, border).is_lt()
    }

    /// Whether no point beyond the line lies beyond the side from `u` to `v` of the hull, which is on the left.
    pub(super) fn is_behind_side(&self, u: &[S; 2], v: &[S; 2]) -> bool {
        let Some(ends) = &self.ends else { return false };
        // High above lies beyond the side if it runs to the left, and deep below if it runs to the right.
        u[0].compare(&v[0]) != self.inner.reverse()
            && ends.iter().all(|end| orient2d(u, v, end).is_ge())
    }
}

/// A double, and how far it may be from the number that is meant.
#[derive(Clone, Copy)]
struct Near {
    value: f64,
    error: f64,
}

/// Twice what rounding changes, in parts of the rounded number, so that it also covers the rounding of the bounds.
const ROUNDING: f64 = f64::EPSILON;
/// What the rounding of the smallest numbers changes.
const LEAST: f64 = f64::MIN_POSITIVE;

impl Near {
    fn exact(value: f64) -> Near {
        Near { value, error: 0.0 }
    }

    /// A rounded number, with what its terms add to the error; four roundings of that sum at most.
    fn rounded(value: f64, error: f64) -> Near {
        let error = (error + value.abs() * ROUNDING + LEAST) * (1.0 + 4.0 * ROUNDING);
        Near { value, error }
    }

    /// The number times 1 or -1.
    fn times_sign(self, sign: f64) -> Near {
        Near {
            value: self.value * sign,
            error: self.error,
        }
    }

    /// Whether the number that is meant is certainly greater than zero. Infinite and undefined ones are not.
    fn is_above_zero(self) -> bool {
        self.value > self.error && self.value.is_finite()
    }
}

impl Add for Near {
    type Output = Near;

    fn add(self, other: Near) -> Near {
        Near::rounded(self.value + other.value, self.error + other.error)
    }
}

impl Sub for Near {
    type Output = Near;

    fn sub(self, other: Near) -> Near {
        Near::rounded(self.value - other.value, self.error + other.error)
    }
}

impl Mul for Near {
    type Output = Near;

    fn mul(self, other: Near) -> Near {
        let error = self.value.abs() * other.error
            + other.value.abs() * self.error
            + self.error * other.error;
        Near::rounded(self.value * other.value, error)
    }
}

fn near<S: Scalar>(number: &S) -> Near {
    let value = number.approx();
    let error = if S::APPROX_IS_EXACT {
        0.0
    } else {
        value.abs() * (2.0 * ROUNDING) + LEAST
    };
    Near { value, error }
}

fn vector<S: Scalar>(from: &[S; 2], to: &[S; 2]) -> [Near; 2] {
    [0, 1].map(|axis| near(&to[axis]) - near(&from[axis]))
}
