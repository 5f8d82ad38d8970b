//! A square part of the plane, and its place in the picture.

use super::frame::{PIXEL, half, units};
use crate::scalar::Scalar;

/// A square window. Coordinates are halves, since the difference of two doubles may overflow.
pub(super) struct Window {
    middle: [f64; 2],
    /// Half a side.
    radius: f64,
    /// Side of the window in the picture, in its units.
    size: i64,
}

impl Window {
    /// The smallest window around some points, and a margin of this share of its side; the points
    /// become `size` wide.
    pub(super) fn around(points: &[[f64; 2]], margin: f64, size: i64) -> Window {
        let range = |axis: usize| {
            let values = points.iter().map(|point| point[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            (low / 2.0 + high / 2.0, high / 2.0 - low / 2.0)
        };
        let ((x, across), (y, up)) = (range(0), range(1));
        Window {
            middle: [x, y],
            radius: (across.max(up) * (1.0 + 2.0 * margin)).min(f64::MAX / 4.0),
            size,
        }
    }

    /// The place of a point, y upwards.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [i64; 2] {
        let [across, up] = self.offset([x, y]);
        [self.size / 2 + across, self.size / 2 - up]
    }

    /// A distance in the picture.
    pub(super) fn length(&self, distance: f64) -> i64 {
        units((distance * self.scale()).min(1e9 * PIXEL as f64))
    }

    /// Whether it shows a point.
    pub(super) fn shows(&self, [x, y]: [f64; 2]) -> bool {
        let [mx, my] = self.middle;
        (x - mx).abs() <= self.radius && (y - my).abs() <= self.radius
    }

    /// The part of a segment that it shows, if any (by Liang and Barsky's algorithm).
    pub(super) fn clip(&self, [a, b]: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (start, step, middle) in [(a[0], dx, self.middle[0]), (a[1], dy, self.middle[1])] {
            let (low, high) = (middle - self.radius, middle + self.radius);
            if step == 0.0 {
                if start < low || start > high {
                    return None;
                }
                continue;
            }
            let [enter, leave] = [low, high].map(|border| (border - start) / step);
            from = from.max(enter.min(leave));
            to = to.min(enter.max(leave));
        }
        let at = |t: f64| [a[0] + t * dx, a[1] + t * dy];
        (from <= to).then(|| {
            [
                if from > 0.0 { at(from) } else { a },
                if to < 1.0 { at(to) } else { b },
            ]
        })
    }

    fn scale(&self) -> f64 {
        // Where all points are one, any scale will do.
        (self.size as f64 / 2.0 / self.radius).min(f64::MAX)
    }

    fn offset(&self, [x, y]: [f64; 2]) -> [i64; 2] {
        let [mx, my] = self.middle;
        [x - mx, y - my].map(|distance| units(distance * self.scale()))
    }
}

/// Points in halves.
pub(super) fn halves<S: Scalar>(points: &[[S; 2]]) -> Vec<[f64; 2]> {
    let halves = |point: &[S; 2]| point.each_ref().map(half);
    points.iter().map(halves).collect()
}
