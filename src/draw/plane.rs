//! Points of any scalar as doubles that are safe to draw with, and the boxes around them.

use crate::scalar::Scalar;

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

    /// What lengths are measured by: the longer side, or 1 if the box is a point.
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
    use super::places;

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
