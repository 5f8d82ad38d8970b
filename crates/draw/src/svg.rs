//! The text of an SVG picture: its beginning, its paths, its labels, and circles, the circumcircles of in-circle tests.
//!
//! Places are whole numbers, y downwards: a [`PIXEL`] is a hundred of them. The view box is in pixels, and the picture
//! fills whatever window or element it is shown in: a browser scales it to fit, and a program that has no window takes
//! the pixels of the view box for its size.

use std::fmt::Display;
use std::io::{self, Write};

use super::style::{INK, PAPER, Rgb};
use super::window::{PIXEL, Window};

/// A path is ended when its text is this long: some programs refuse much longer attributes.
const LONGEST_PATH: usize = 100_000;

/// Begins a picture of this size with the style rules of its classes.
pub(super) fn begin(
    out: &mut impl Write,
    [width, height]: [i64; 2],
    style: &str,
) -> io::Result<()> {
    let [across, down] = [width, height].map(|side| side as f64 / PIXEL as f64);
    write!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100%" height="100%" viewBox="0 0 {across} {down}">
<style>
path {{ fill: none; stroke-linecap: round; stroke-linejoin: round }}
{style}text {{ font: {}px sans-serif; fill: {INK}; paint-order: stroke; stroke: {PAPER}; stroke-width: 350 }}
</style>
<g transform="scale({})">
<rect width="{width}" height="{height}" fill="{PAPER}"/>
"#,
        15 * PIXEL,
        1.0 / PIXEL as f64,
    )
}

/// Ends a picture.
pub(super) fn end(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "</g>\n</svg>")
}

/// Writes the pieces of a layer, joined to few paths.
pub(super) fn layer(
    out: &mut impl Write,
    class: &str,
    pieces: impl IntoIterator<Item = String>,
) -> io::Result<()> {
    let mut pieces = pieces.into_iter().peekable();
    let mut path = String::new();
    while let Some(piece) = pieces.next() {
        path.push_str(&piece);
        if path.len() > LONGEST_PATH || pieces.peek().is_none() {
            writeln!(out, "<path class=\"{class}\" d=\"{path}\"/>")?;
            path.clear();
        }
    }
    Ok(())
}

/// Writes the lines around an area as one path, so that holes are not filled, in a colour of its own.
pub(super) fn area(
    out: &mut impl Write,
    class: &str,
    [r, g, b]: Rgb,
    lines: impl Iterator<Item = String>,
) -> io::Result<()> {
    let path: String = lines.collect();
    if path.is_empty() {
        return Ok(());
    }
    let colour = format!("#{r:02X}{g:02X}{b:02X}");
    writeln!(
        out,
        "<path class=\"{class}\" style=\"color:{colour}\" d=\"{path}\"/>"
    )
}

/// A dot: a line without a length, with round ends.
pub(super) fn dot([x, y]: [i64; 2]) -> String {
    format!("M{x} {y}h0")
}

/// A line through some places.
pub(super) fn line(places: &[[i64; 2]]) -> String {
    let mut path = String::new();
    for (at, [x, y]) in places.iter().enumerate() {
        path += &format!("{}{x} {y}", if at == 0 { 'M' } else { 'L' });
    }
    path
}

/// A line through some places and back to the first.
pub(super) fn polygon(places: &[[i64; 2]]) -> String {
    line(places) + "z"
}

/// Writes a text to the upper right of a place.
pub(super) fn label(out: &mut impl Write, [x, y]: [i64; 2], text: impl Display) -> io::Result<()> {
    let (x, y) = (x + 7 * PIXEL, y - 7 * PIXEL);
    writeln!(out, "<text x=\"{x}\" y=\"{y}\">{text}</text>")
}

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
