//! The strip under a picture that says what its lines are.

use std::io::{self, Write};

use super::window::PIXEL;

/// Its height.
pub(super) const HEIGHT: i64 = 44 * PIXEL;
const COLUMN: i64 = 195 * PIXEL;
const SAMPLE: i64 = 24 * PIXEL;

/// Draws a sample of each class of lines with its text, centered at `middle` below `top`.
pub(super) fn write(
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
