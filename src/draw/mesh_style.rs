//! How the parts of a triangulation look: hull, inner sides, input edges and vertices.
//!
//! The closer the vertices, the thinner the lines, so that a million points make as clear a picture as ten.

use super::palette::{BLUE, GREY, INK, ORANGE, SAND};
use super::window::{PIXEL, units};

/// The style rules of the four classes and of their samples in the legend, for vertices that are about
/// `spacing` pixels apart.
pub(super) fn rules(spacing: f64) -> String {
    format!(
        ".hull {{ stroke: {ORANGE}; fill: {SAND} }}
.side {{ stroke: {GREY} }}
.edge {{ stroke: {BLUE} }}
.vertex {{ stroke: {INK} }}
{}.sample.hull {{ stroke-width: 700 }}
.sample.side {{ stroke-width: 120 }}
.sample.edge {{ stroke-width: 300 }}
.sample.vertex {{ stroke-width: 700; stroke-dasharray: 1 1150 }}
",
        widths("", spacing)
    )
}

/// The rules for the widths of lines inside `scope`, for vertices that are about `spacing` pixels apart.
pub(super) fn widths(scope: &str, spacing: f64) -> String {
    // Each width is a share of the spacing, between a least and a most in pixels.
    let of_class = |(class, share, least, most): (&str, f64, f64, f64)| {
        let width = units((spacing * share).clamp(least, most) * PIXEL as f64);
        format!("{scope}.{class} {{ stroke-width: {width} }}\n")
    };
    [
        ("hull", 0.08, 1.6, 7.0),
        ("side", 0.05, 0.1, 1.4),
        ("edge", 0.12, 0.3, 3.0),
        ("vertex", 0.2, 1.5, 8.0),
    ]
    .map(of_class)
    .concat()
}
