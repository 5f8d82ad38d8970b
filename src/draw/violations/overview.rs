//! The first panel of violations: all of the triangulation, with a number at each close-up.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::background::Background;
use crate::draw::plane::Bounds;
use crate::draw::svg;
use crate::draw::window::Window;

/// Draws the overview in a window, with a dot at each of the `foci`: the vertices of a violation. The
/// first `numbered` of them have close-ups.
pub(super) fn draw(
    background: &Background,
    window: &Window,
    foci: &[Vec<usize>],
    numbered: usize,
    out: &mut impl Write,
) -> io::Result<()> {
    background.draw(window, out)?;
    let middle = |vertices: &Vec<usize>| {
        let count = vertices.len() as f64;
        let points = || vertices.iter().map(|&v| background.points[v]);
        let mean = |axis: usize| points().map(|point| point[axis] / count).sum();
        window.place([mean(0), mean(1)])
    };
    let places: Vec<[i64; 2]> = foci.iter().map(middle).collect();
    svg::layer(out, "culprit", places.iter().copied().map(svg::dot))?;
    // Violations at one place share a label.
    let mut names: BTreeMap<[i64; 2], Vec<String>> = BTreeMap::new();
    for (&place, panel) in places.iter().take(numbered).zip(1_usize..) {
        names.entry(place).or_default().push(panel.to_string());
    }
    for (place, panels) in names {
        svg::label(out, place, panels.join(", "))?;
    }
    Ok(())
}

/// The window of an overview of this size.
pub(super) fn window(background: &Background, size: i64) -> Window {
    let all = Bounds::of(background.points.iter().copied());
    Window::new(all.squared(all.longer()).with_margin(0.06), size)
}
