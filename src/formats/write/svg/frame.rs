//! Where vertices come to lie in the picture, y upwards, and how large all is.

use crate::scalar::Scalar;

/// A pixel of the picture at its own size, in its units.
pub(super) const PIXEL: i64 = 100;
/// The longer side of the points' bounding box.
const LONG_SIDE: f64 = 1000.0 * PIXEL as f64;
/// Room for the legend: no picture is narrower.
const NARROWEST: i64 = 780 * PIXEL;
const MARGIN: i64 = 28 * PIXEL;

/// The bounding box of the points and its place in the picture.
pub(super) struct Frame {
    /// Half the lower left corner; halves, since the difference of two doubles may overflow.
    low: [f64; 2],
    /// Half the longer side of the bounding box: divided by it first, no distance overflows.
    longer: f64,
    /// Width and height of the bounding box.
    size: [i64; 2],
    /// About the distance of vertices that are neighbours, in pixels.
    pub(super) spacing: f64,
}

impl Frame {
    pub(super) fn of<S: Scalar>(points: &[[S; 2]]) -> Frame {
        let range = |axis: usize| {
            let values = points.iter().map(|point| half(&point[axis]));
            let (low, high) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    (value.min(low), value.max(high))
                });
            (low, (high - low).max(0.0))
        };
        let ((left, width), (bottom, height)) = (range(0), range(1));
        let longer = width.max(height);
        let count = points.len().max(1) as f64;
        let square = (width / longer * (height / longer) / count).sqrt();
        Frame {
            low: [left, bottom],
            longer,
            size: [width, height].map(|side| scaled(side, longer)),
            spacing: square.max(1.0 / count) * LONG_SIDE / PIXEL as f64,
        }
    }

    /// Width and height of the picture without the legend.
    pub(super) fn outer(&self) -> [i64; 2] {
        [
            self.size[0].max(NARROWEST) + 2 * MARGIN,
            self.size[1] + 2 * MARGIN,
        ]
    }

    /// The place of a point.
    pub(super) fn place<S: Scalar>(&self, [x, y]: &[S; 2]) -> [i64; 2] {
        let [left, bottom] = self.low;
        let across = scaled(half(x) - left, self.longer);
        let up = scaled(half(y) - bottom, self.longer);
        let [width, height] = self.outer();
        [(width - self.size[0]) / 2 + across, height - MARGIN - up]
    }
}

/// A distance in units of the picture; 0 if all points are in one place.
fn scaled(distance: f64, longer: f64) -> i64 {
    units(distance / longer * LONG_SIDE)
}

/// Half a coordinate, as a finite double.
pub(super) fn half<S: Scalar>(value: &S) -> f64 {
    value.approx().clamp(f64::MIN, f64::MAX) / 2.0
}

/// The nearest whole number of units, 0 for NaN.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a float is cast to the nearest integer there is"
)]
pub(super) fn units(value: f64) -> i64 {
    value.round() as i64
}
