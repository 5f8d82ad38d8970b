//! Where points lie in the picture: the longer side of their bounding box is one.

use crate::scalar::Scalar;

/// The points' places, y upwards, from the lower left corner of their bounding box.
pub(super) struct Frame {
    pub(super) places: Vec<[f64; 2]>,
    /// Width and height of the bounding box.
    pub(super) size: [f64; 2],
}

impl Frame {
    pub(super) fn of<S: Scalar>(points: &[[S; 2]]) -> Frame {
        // Halves, since the difference of two doubles may overflow.
        let half = |value: &S| value.approx().clamp(f64::MIN, f64::MAX) / 2.0;
        let halves: Vec<[f64; 2]> = points.iter().map(|p| p.each_ref().map(half)).collect();
        let range = |axis: usize| {
            let values = halves.iter().map(|point| point[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            (low, (high - low).max(0.0))
        };
        let ((left, width), (bottom, height)) = (range(0), range(1));
        let longer = width.max(height);
        let share = |length: f64| if longer > 0.0 { length / longer } else { 0.0 };
        Frame {
            places: halves
                .iter()
                .map(|[x, y]| [share(x - left), share(y - bottom)])
                .collect(),
            size: [share(width), share(height)],
        }
    }

    /// About the distance of vertices that are neighbours.
    pub(super) fn spacing(&self) -> f64 {
        let count = self.places.len().max(1) as f64;
        (self.size[0] * self.size[1] / count)
            .sqrt()
            .max(1.0 / count)
    }
}

/// The circle through three points, if they are not on one line: center and radius.
pub(super) fn circle([a, b, c]: [[f64; 2]; 3]) -> Option<([f64; 2], f64)> {
    let [bx, by] = [b[0] - a[0], b[1] - a[1]];
    let [cx, cy] = [c[0] - a[0], c[1] - a[1]];
    let area = 2.0 * (bx * cy - by * cx);
    let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
    let [x, y] = [(cy * b2 - by * c2) / area, (bx * c2 - cx * b2) / area];
    let radius = x.hypot(y);
    radius.is_finite().then_some(([a[0] + x, a[1] + y], radius))
}
