//! A part of the plane, and where its points lie in the picture. Points of any scalar become doubles that are safe
//! to draw with, and have boxes around them.

use sweep_cdt::scalar::Scalar;

/// A pixel of a picture at its own size, in the whole units that pictures are written in.
pub(super) const PIXEL: i64 = 100;
/// Nothing is placed farther out than this many units, so that sums of places do not overflow.
const FARTHEST: f64 = 1e12;

/// A part of the plane, drawn with its upper left corner at the origin and y upwards.
#[derive(Debug)]
pub(super) struct Window {
    part: Bounds,
    /// Units of the picture for the longer side of the part.
    longer: f64,
    /// Width and height in units of the picture.
    pub(super) size: [i64; 2],
}

impl Window {
    /// A window on a part of the plane, whose longer side becomes this many units long.
    pub(super) fn new(part: Bounds, longer: i64) -> Window {
        let longer = longer as f64;
        let size = part.size.map(|side| units(side / part.unit() * longer));
        Window { part, longer, size }
    }

    /// The place of a point.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [i64; 2] {
        let [left, bottom] = self.part.low;
        let [across, up] = [self.length(x - left), self.length(y - bottom)];
        [across, self.size[1] - up]
    }

    /// A distance in the picture.
    pub(super) fn length(&self, distance: f64) -> i64 {
        // Divide first: the quotient does not overflow, even where a window is tiny.
        units(distance / self.part.unit() * self.longer)
    }

    /// Whether it shows a point.
    pub(super) fn shows(&self, point: [f64; 2]) -> bool {
        let Bounds { low, size } = self.part;
        (0..2).all(|axis| (low[axis]..=low[axis] + size[axis]).contains(&point[axis]))
    }

    /// Whether it may show something of a shape through these places: whether they are not all beside it.
    pub(super) fn may_show(&self, places: &[[i64; 2]]) -> bool {
        (0..2).all(|axis| {
            places.iter().any(|place| place[axis] >= 0)
                && places.iter().any(|place| place[axis] <= self.size[axis])
        })
    }

    /// The part of a segment that it shows, if any (by Liang and Barsky's algorithm).
    pub(super) fn clip(&self, [a, b]: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
        let step = [b[0] - a[0], b[1] - a[1]];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for axis in [0, 1] {
            let low = self.part.low[axis];
            let borders = [low, low + self.part.size[axis]];
            if step[axis] == 0.0 {
                if a[axis] < borders[0] || a[axis] > borders[1] {
                    return None;
                }
                continue;
            }
            let [enter, leave] = borders.map(|border| (border - a[axis]) / step[axis]);
            from = from.max(enter.min(leave));
            to = to.min(enter.max(leave));
        }
        let at = |t: f64| [a[0] + t * step[0], a[1] + t * step[1]];
        (from <= to).then(|| {
            [
                if from > 0.0 { at(from) } else { a },
                if to < 1.0 { at(to) } else { b },
            ]
        })
    }
}

/// The nearest whole number of units, 0 for NaN.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the value is in the range of the integers"
)]
pub(super) fn units(value: f64) -> i64 {
    value.clamp(-FARTHEST, FARTHEST).round() as i64
}

/// Points as doubles, all multiplied by one power of two that brings the largest coordinate near 1.
///
/// A picture shows proportions only, so the factor does not show. It makes every later difference safe:
/// none overflows, and distances between subnormal coordinates are no longer subnormal. A coordinate
/// beyond the doubles is drawn at the largest double.
pub(super) fn places<S: Scalar>(points: &[[S; 2]]) -> Vec<[f64; 2]> {
    let approx = |x: &S| x.approx().clamp(f64::MIN, f64::MAX);
    let coordinates = points.iter().flatten();
    let largest = coordinates.fold(0.0, |largest: f64, x| largest.max(approx(x).abs()));
    // The exponent, or one near it for subnormal numbers. Its power of two alone could overflow.
    let exponent = 1023 - i32::try_from(largest.to_bits() >> 52).unwrap_or(1023);
    let factors = [exponent / 2, exponent - exponent / 2].map(|half| 2.0_f64.powi(half));
    let scaled = |x: &S| approx(x) * factors[0] * factors[1];
    points.iter().map(|p| p.each_ref().map(scaled)).collect()
}

/// An upright box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// The lower left corner.
    pub(super) low: [f64; 2],
    /// Width and height.
    pub(super) size: [f64; 2],
}

impl Bounds {
    /// The smallest box around some points; the origin if there are none.
    pub(super) fn of(points: impl IntoIterator<Item = [f64; 2]>) -> Bounds {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for axis in [0, 1] {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        Bounds {
            low: low.map(|x| if x.is_finite() { x } else { 0.0 }),
            size: [0, 1].map(|axis| (high[axis] - low[axis]).max(0.0)),
        }
    }

    /// The longer side.
    pub(super) fn longer(&self) -> f64 {
        self.size[0].max(self.size[1])
    }

    /// The unit of lengths: the longer side, or 1 if the box is a point.
    pub(super) fn unit(&self) -> f64 {
        if self.longer() > 0.0 {
            self.longer()
        } else {
            1.0
        }
    }

    /// A point as seen from the lower left corner, in units.
    pub(super) fn share(&self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (point[axis] - self.low[axis]) / self.unit())
    }

    /// The square with the same middle and sides of this length.
    pub(super) fn squared(&self, side: f64) -> Bounds {
        Bounds {
            low: [0, 1].map(|axis| self.low[axis] + (self.size[axis] - side) / 2.0),
            size: [side; 2],
        }
    }

    /// The box with a margin all around, given as a share of its unit.
    pub(super) fn with_margin(&self, share: f64) -> Bounds {
        let margin = share * self.unit();
        Bounds {
            low: self.low.map(|x| x - margin),
            size: self.size.map(|length| length + 2.0 * margin),
        }
    }

    /// About the distance of neighbours among `count` points in the box, as a share of its unit.
    pub(super) fn spacing(&self, count: usize) -> f64 {
        let [width, height] = self.size.map(|side| side / self.unit());
        let count = count.max(1) as f64;
        (width * height / count).sqrt().max(1.0 / count)
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Window, places};

    fn window() -> Window {
        let part = Bounds {
            low: [1.0, 2.0],
            size: [4.0, 2.0],
        };
        Window::new(part, 400)
    }

    #[test]
    fn y_points_upwards() {
        assert_eq!(window().size, [400, 200]);
        assert_eq!(window().place([1.0, 2.0]), [0, 200]);
        assert_eq!(window().place([5.0, 4.0]), [400, 0]);
        assert_eq!(window().place([f64::MAX, f64::NAN])[1], 200);
    }

    #[test]
    fn segments_end_at_the_border() {
        let clip = |ends| window().clip(ends);
        let inside = [[2.0, 2.5], [3.0, 3.5]];
        assert_eq!(clip(inside), Some(inside));
        assert_eq!(
            clip([[0.0, 3.0], [6.0, 3.0]]),
            Some([[1.0, 3.0], [5.0, 3.0]])
        );
        assert_eq!(
            clip([[3.0, 3.0], [3.0, 9.0]]),
            Some([[3.0, 3.0], [3.0, 4.0]])
        );
        // Beside it, above it, and past a corner of it.
        assert_eq!(clip([[0.0, 2.0], [0.0, 4.0]]), None);
        assert_eq!(clip([[0.0, 5.0], [6.0, 5.0]]), None);
        assert_eq!(clip([[0.0, 3.5], [2.0, 5.5]]), None);
    }

    #[test]
    fn proportions_survive_any_magnitude() {
        let expected = places(&[[1.0, -3.0], [0.0, 4.0]]);
        for factor in [5e-324, 2.0_f64.powi(-1022), 1.0, 2.0_f64.powi(1021)] {
            let points = [[factor, -3.0 * factor], [0.0, 4.0 * factor]];
            let found = places(&points);
            let ratio = expected[1][1] / found[1][1];
            let back: Vec<_> = found.iter().map(|p| p.map(|x| x * ratio)).collect();
            assert_eq!(back, expected, "{factor:e}");
            assert!((1e-17..4.0).contains(&found[1][1]), "{factor:e}");
        }
    }
}
