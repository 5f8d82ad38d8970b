//! The strip under the picture that says what is what.

use std::io::{self, Write};

use super::frame::PIXEL;

/// Its height.
pub(super) const HEIGHT: i64 = 44 * PIXEL;
const COLUMN: i64 = 195 * PIXEL;
const SAMPLE: i64 = 24 * PIXEL;

/// Draws a sample of each class of lines and how many there are, centered at `middle` below `top`.
pub(super) fn write(
    out: &mut impl Write,
    [middle, top]: [i64; 2],
    entries: &[(&str, String)],
) -> io::Result<()> {
    let (y, baseline) = (top + 14 * PIXEL, top + 19 * PIXEL);
    let mut x = middle - COLUMN * entries.len() as i64 / 2;
    writeln!(out, "<g class=\"legend\">")?;
    for (class, text) in entries {
        writeln!(
            out,
            "<path class=\"{class} sample\" d=\"M{x} {y}h{SAMPLE}\"/>"
        )?;
        writeln!(
            out,
            "<text x=\"{}\" y=\"{baseline}\">{text}</text>",
            x + SAMPLE + 8 * PIXEL
        )?;
        x += COLUMN;
    }
    writeln!(out, "</g>")
}
