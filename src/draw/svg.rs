//! The text of an SVG picture: its beginning, its paths and its labels.
//!
//! Places are whole numbers of a hundredth of a [`PIXEL`], y downwards.

use std::fmt::Display;
use std::io::{self, Write};

use super::palette::{INK, PAPER};
use super::window::PIXEL;

/// A path is ended when its text is this long: some programs refuse much longer attributes.
const LONGEST_PATH: usize = 100_000;

/// Begins a picture with the style rules of its classes.
pub(super) fn begin(
    out: &mut impl Write,
    [width, height]: [i64; 2],
    style: &str,
) -> io::Result<()> {
    write!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {width} {height}">
<style>
path {{ fill: none; stroke-linecap: round; stroke-linejoin: round }}
{style}text {{ font: {}px sans-serif; fill: {INK}; paint-order: stroke; stroke: {PAPER}; stroke-width: 350 }}
</style>
<rect width="{width}" height="{height}" fill="{PAPER}"/>
"#,
        width / PIXEL,
        height / PIXEL,
        15 * PIXEL,
    )
}

/// Ends a picture.
pub(super) fn end(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "</svg>")
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
