//! How pictures look: the colours of every picture, each defined here and nowhere else; the lines of a triangulation;
//! and the legend.
//!
//! Most colours are from Okabe and Ito's palette, which colour-blind readers can tell apart. Lines of different
//! kinds also differ in width or dashes, so that no picture depends on colour alone. The closer the vertices, the
//! thinner the lines, so that a million points make as clear a picture as ten.

use std::io::{self, Write};

use super::window::{PIXEL, units};

/// Red, green and blue.
pub(super) type Rgb = [u8; 3];

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

/// Input edges on a relief.
pub(super) const UMBER: &str = "#4A3B2A";
/// Tints of heights, from the lowest to the highest, each lighter than those before it.
pub(super) const RAMP: [Rgb; 6] = [
    [0x1F, 0x5F, 0x5B],
    [0x3F, 0x82, 0x5A],
    [0x84, 0xA3, 0x5C],
    [0xC9, 0xBC, 0x72],
    [0xE4, 0xD2, 0xA6],
    [0xF8, 0xF4, 0xEC],
];
/// Triangles whose height is not known.
pub(super) const UNKNOWN: Rgb = [0xB4, 0xB8, 0xBC];

/// A colour as three numbers.
pub(super) fn rgb(colour: &str) -> Rgb {
    let digits = colour.trim_start_matches('#');
    // One digit stands for two equal ones.
    let size = digits.len() / 3;
    [0, 1, 2].map(|part| {
        let digits = digits[part * size..(part + 1) * size].repeat(3 - size);
        u8::from_str_radix(&digits, 16).expect("digits")
    })
}

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
    let rule = |class| {
        let width = mesh_width(class, spacing);
        format!("{scope}.{class} {{ stroke-width: {width} }}\n")
    };
    ["hull", "side", "edge", "vertex"].map(rule).concat()
}

/// The width of the lines of a class, for vertices that are about `spacing` pixels apart.
pub(super) fn mesh_width(class: &str, spacing: f64) -> i64 {
    // A share of the spacing, between a least and a most in pixels.
    let (share, least, most) = match class {
        "hull" => (0.08, 1.6, 7.0),
        "side" => (0.05, 0.1, 1.4),
        "edge" => (0.12, 0.3, 3.0),
        _ => (0.2, 1.5, 8.0),
    };
    units((spacing * share).clamp(least, most) * PIXEL as f64)
}

/// The width of the hull around a domain, and of its dashes and gaps.
pub(super) const OUTSIDE: [f64; 3] = [100.0, 500.0, 400.0];
/// On a relief lines are so much thinner.
pub(super) const ON_RELIEF: f64 = 0.5;

/// The style rules of a relief and of the lines on it, which follow those of [`mesh_rules`].
pub(super) fn relief_rules(spacing: f64) -> String {
    let widths = ["side", "edge"].map(|class| {
        let width = mesh_width(class, spacing * ON_RELIEF);
        format!(".{class} {{ stroke-width: {width} }}\n")
    });
    let [r, g, b] = RAMP[2];
    format!(
        ".relief {{ fill: currentColor; stroke: currentColor; stroke-width: 60 }}
.edge {{ stroke: {UMBER} }}
{}.sample.relief {{ color: rgb({r} {g} {b}); stroke-width: 700 }}
.sample.side {{ stroke-width: 120 }}
.sample.edge {{ stroke-width: 300 }}
",
        widths.concat()
    )
}

/// The height of the legend.
pub(super) const LEGEND_HEIGHT: i64 = 44 * PIXEL;
/// The width of an entry of the legend.
pub(super) const COLUMN: i64 = 195 * PIXEL;
/// The length of a sample.
pub(super) const SAMPLE: i64 = 24 * PIXEL;
/// The width and height of the bar of tints.
pub(super) const BAR: [i64; 2] = [240 * PIXEL, 14 * PIXEL];
/// The gap between a sample or the bar and its text.
pub(super) const GAP: i64 = 8 * PIXEL;

/// Draws the legend, the strip under a picture that says what its lines are: a sample of each class of lines with
/// its text, centered at `middle` below `top`.
pub(super) fn write_legend(
    out: &mut impl Write,
    [middle, top]: [i64; 2],
    entries: &[(&str, String)],
) -> io::Result<()> {
    writeln!(out, "<g class=\"legend\">")?;
    let places = legend_places([middle, top], entries.len());
    for ((class, text), [[x, y], [right, baseline]]) in entries.iter().zip(places) {
        writeln!(
            out,
            "<path class=\"{class} sample\" d=\"M{x} {y}h{SAMPLE}\"/>\n\
             <text x=\"{right}\" y=\"{baseline}\">{text}</text>"
        )?;
    }
    writeln!(out, "</g>")
}

/// Where the sample and the text of each of so many entries of a legend begin.
pub(super) fn legend_places(
    [middle, top]: [i64; 2],
    count: usize,
) -> impl Iterator<Item = [[i64; 2]; 2]> {
    let left = middle - COLUMN * count as i64 / 2;
    (0..count as i64).map(move |at| {
        let x = left + at * COLUMN;
        [[x, top + 14 * PIXEL], [x + SAMPLE + GAP, top + 19 * PIXEL]]
    })
}
