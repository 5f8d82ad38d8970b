//! A part of the plane, and where its points lie in the picture.

use super::plane::Bounds;

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

#[cfg(test)]
mod tests {
    use super::Window;
    use crate::draw::plane::Bounds;

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
}
