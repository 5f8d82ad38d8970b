//! Upright boxes around edges and cells, in doubles.
//!
//! Why it is right: boxes are made of approximations, which are monotone ([`Scalar::approx`]), and are only compared.
//! So what has a point in common has boxes that meet, however large, small or close the coordinates are. Where more
//! than comparisons decide, a bound on the errors of doubles is on the safe side.

use crate::scalar::Scalar;

/// More than the errors of a few differences and products, relative to the largest coordinate.
const OFF: f64 = 32.0 * f64::EPSILON;

/// A point in doubles.
pub(super) type Near = [f64; 2];

/// An upright box: its lower left and its upper right corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: Near,
    pub(super) high: Near,
}

impl Bounds {
    /// The box around nothing, which meets no other.
    pub(super) const NOTHING: Bounds = Bounds {
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    pub(super) fn of<S: Scalar>(points: [&[S; 2]; 2]) -> Bounds {
        Bounds::around(points.map(near))
    }

    pub(super) fn around([a, b]: [Near; 2]) -> Bounds {
        Bounds { low: a, high: a }.and(Bounds { low: b, high: b })
    }

    pub(super) fn and(self, other: Bounds) -> Bounds {
        Bounds {
            low: [0, 1].map(|i| self.low[i].min(other.low[i])),
            high: [0, 1].map(|i| self.high[i].max(other.high[i])),
        }
    }

    pub(super) fn meets(&self, other: &Bounds) -> bool {
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
    pub(super) fn is_beside(&self, [a, b]: [Near; 2]) -> bool {
        let all = [a, b, self.low, self.high];
        let largest = largest(&all);
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

    pub(super) fn middles(&self) -> Near {
        [0, 1].map(|axis| self.middle(axis))
    }

    pub(super) fn corners(&self) -> [Near; 4] {
        let Bounds { low, high } = self;
        [*low, [high[0], low[1]], *high, [low[0], high[1]]]
    }
}

pub(super) fn near<S: Scalar>(point: &[S; 2]) -> Near {
    point.each_ref().map(S::approx)
}

/// The size of the largest coordinate.
fn largest(points: &[Near]) -> f64 {
    let sizes = points.as_flattened().iter().map(|x| x.abs());
    sizes.fold(0.0, f64::max)
}

/// How far points reach along a direction of a size of at most one in x and y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    low: f64,
    high: f64,
    /// The size of the largest coordinate.
    largest: f64,
}

impl Extent {
    /// The extent of nothing, which is apart from all others.
    pub(super) const NOTHING: Extent = Extent {
        low: f64::INFINITY,
        high: f64::NEG_INFINITY,
        largest: 0.0,
    };

    pub(super) fn of(points: &[Near], direction: Near) -> Extent {
        let places = points.iter().map(|point| along(*point, direction));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        Extent {
            low,
            high,
            largest: largest(points),
        }
    }

    pub(super) fn and(self, other: Extent) -> Extent {
        Extent {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            largest: self.largest.max(other.largest),
        }
    }

    /// Whether nothing of one extent has the place of anything of the other, for certain: with the larger size M of
    /// all coordinates each place is off by at most 2^-50 M, and the bound is 2^-47 M. Where numbers overflow the
    /// answer is `false`.
    pub(super) fn is_apart(&self, other: &Extent) -> bool {
        let off = OFF * self.largest.max(other.largest) + f64::MIN_POSITIVE;
        self.low > other.high + off || other.low > self.high + off
    }

    pub(super) fn length(&self) -> f64 {
        self.high - self.low
    }

    /// Whether a place is within the extent, as far as doubles tell.
    pub(super) fn holds(&self, place: f64) -> bool {
        self.low <= place && place <= self.high
    }
}

/// The place of a point along a direction.
pub(super) fn along(point: Near, direction: Near) -> f64 {
    direction[0] * point[0] + direction[1] * point[1]
}
