//! How pictures look: the colours of every picture, each defined here and nowhere else; the lines of a triangulation;
//! and the legend.
//!
//! Most colours are from Okabe and Ito's palette, which colour-blind readers can tell apart. Lines of different
//! kinds also differ in width or dashes, so that no picture depends on colour alone. The closer the vertices, the
//! thinner the lines, so that a million points make as clear a picture as ten.

use std::io::{self, Write};

use super::window::{PIXEL, units};

/// Text, vertices, and what a step points at.
pub(super) const INK: &str = "#1B1F23";
/// Secondary text, and pierced triangles.
pub(super) const SLATE: &str = "#5B646D";
/// Sides of triangles.
pub(super) const GREY: &str = "#848E98";
/// Frames of panels.
pub(super) const MIST: &str = "#C9CED3";
/// The inside of the triangulation.
pub(super) const SAND: &str = "#F6F5F1";
/// The background.
pub(super) const PAPER: &str = "#FFF";
/// Input edges.
pub(super) const BLUE: &str = "#0072B2";
/// The hull, and the advancing front.
pub(super) const ORANGE: &str = "#E69F00";
/// The colour of all that appears, and of legal sides.
pub(super) const GREEN: &str = "#009E73";
/// The colour of all that disappears, and of illegal sides.
pub(super) const VERMILION: &str = "#D55E00";
/// The sweep line.
pub(super) const PURPLE: &str = "#CC79A7";
/// The upper pseudo-polygon.
pub(super) const SKY: &str = "#56B4E9";
/// The lower pseudo-polygon.
pub(super) const OCHRE: &str = "#B8A500";
/// Violations.
pub(super) const RED: &str = "#D5190B";

/// The colours of the page of steps, by the names that its style sheet (`var(--ink)`) and its script (`colour("ink")`)
/// have for them: on light paper, as in every other picture, and on dark paper.
pub(super) const PAGE_COLOURS: [(&str, &str, &str); 13] = [
    ("ink", INK, "#E6E9EC"),
    ("slate", SLATE, "#A9B2BB"),
    ("grey", GREY, "#7D8791"),
    ("mist", MIST, "#4A525A"),
    ("sand", SAND, "#22272D"),
    ("paper", PAPER, "#14171A"),
    ("blue", BLUE, "#4DB1F0"),
    ("orange", ORANGE, "#E69F00"),
    ("green", GREEN, "#1FC596"),
    ("vermilion", VERMILION, "#FF8A3D"),
    ("purple", PURPLE, "#E08FBD"),
    ("sky", SKY, "#7CC8F2"),
    ("ochre", OCHRE, "#D4C02A"),
];

/// The style rules of hull, hull outside of a domain, inner sides, input edges and vertices, and of their samples in the legend, for vertices
/// that are about `spacing` pixels apart.
pub(super) fn mesh_rules(spacing: f64) -> String {
    format!(
        ".outside {{ stroke: {SLATE}; stroke-width: 100; stroke-dasharray: 500 400; fill: none }}
.hull {{ stroke: {ORANGE}; fill: {SAND} }}
.side {{ stroke: {GREY} }}
.edge {{ stroke: {BLUE} }}
.vertex {{ stroke: {INK} }}
{}.sample.hull {{ stroke-width: 700 }}
.sample.side {{ stroke-width: 120 }}
.sample.edge {{ stroke-width: 300 }}
.sample.vertex {{ stroke-width: 700; stroke-dasharray: 1 1150 }}
",
        mesh_widths("", spacing)
    )
}

/// The rules for the widths of lines inside `scope`, for vertices that are about `spacing` pixels apart.
pub(super) fn mesh_widths(scope: &str, spacing: f64) -> String {
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

/// The height of the legend.
pub(super) const LEGEND_HEIGHT: i64 = 44 * PIXEL;
/// The width of an entry of the legend.
pub(super) const COLUMN: i64 = 195 * PIXEL;
const SAMPLE: i64 = 24 * PIXEL;

/// Draws the legend, the strip under a picture that says what its lines are: a sample of each class of lines with
/// its text, centered at `middle` below `top`.
pub(super) fn write_legend(
    out: &mut impl Write,
    [middle, top]: [i64; 2],
    entries: &[(&str, String)],
) -> io::Result<()> {
    let (y, baseline) = (top + 14 * PIXEL, top + 19 * PIXEL);
    let mut x = middle - COLUMN * entries.len() as i64 / 2;
    writeln!(out, "<g class=\"legend\">")?;
    for (class, text) in entries {
        let right = x + SAMPLE + 8 * PIXEL;
        writeln!(
            out,
            "<path class=\"{class} sample\" d=\"M{x} {y}h{SAMPLE}\"/>\n\
             <text x=\"{right}\" y=\"{baseline}\">{text}</text>"
        )?;
        x += COLUMN;
    }
    writeln!(out, "</g>")
}
