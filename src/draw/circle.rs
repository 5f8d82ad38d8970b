//! The circumcircle of a triangle, as in the in-circle test.

use std::io::{self, Write};

use super::window::{PIXEL, Window};

/// Circles with a larger radius are not drawn: they would look straight.
const LARGEST: i64 = 100_000 * PIXEL;

/// A circle by its centre and radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    middle: [f64; 2],
    pub(super) radius: f64,
}

impl Circle {
    /// The circle through three points, computed in doubles; `None` if they are on one line.
    pub(super) fn through([a, b, c]: [[f64; 2]; 3]) -> Option<Circle> {
        let [[bx, by], [cx, cy]] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
        // Scaled, so that squares of tiny distances do not vanish.
        let unit = bx.abs().max(by.abs()).max(cx.abs()).max(cy.abs());
        let [bx, by, cx, cy] = [bx, by, cx, cy].map(|x| x / unit);
        let area = 2.0 * (bx * cy - by * cx);
        let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
        let (x, y) = ((cy * b2 - by * c2) / area, (bx * c2 - cx * b2) / area);
        let circle = Circle {
            middle: [a[0] + x * unit, a[1] + y * unit],
            radius: x.hypot(y) * unit,
        };
        circle.radius.is_finite().then_some(circle)
    }

    /// Draws it, unless it is too large.
    pub(super) fn write(
        &self,
        class: &str,
        window: &Window,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let ([x, y], r) = (window.place(self.middle), window.length(self.radius));
        if r >= LARGEST {
            return Ok(());
        }
        writeln!(
            out,
            "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Circle;

    #[test]
    fn circles_of_any_size() {
        for unit in [1e-300, 1.0, 1e300] {
            let corners = [[1.0, 0.0], [5.0, 0.0], [1.0, 3.0]].map(|p| p.map(|x: f64| x * unit));
            let circle = Circle::through(corners).expect("a triangle");
            assert!((circle.radius / unit - 2.5).abs() < 1e-12, "{unit:e}");
            assert!((circle.middle[0] / unit - 3.0).abs() < 1e-12, "{unit:e}");
            assert!((circle.middle[1] / unit - 1.5).abs() < 1e-12, "{unit:e}");
        }
        assert!(Circle::through([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]).is_none());
        assert!(Circle::through([[1.0, 1.0]; 3]).is_none());
    }
}
