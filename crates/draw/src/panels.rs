//! Several drawings on one sheet: framed panels in rows, each with its caption below: a title, and a text broken
//! into lines.

use std::io::{self, Write};

use super::style::MIST;
use super::window::PIXEL;

/// Width of a sheet.
const WIDTH: i64 = 1320 * PIXEL;
const GAP: i64 = 24 * PIXEL;

/// Where the panels of a sheet lie.
#[derive(Debug)]
pub(super) struct Panels {
    columns: usize,
    rows: usize,
    tallest: i64,
    /// The largest width of a panel.
    pub(super) side: i64,
}

impl Panels {
    /// The layout of `count` square panels.
    pub(super) fn new(count: usize) -> Panels {
        let columns = match count {
            0 | 1 => 1,
            2 | 4 => 2,
            _ => 3,
        };
        let side = (WIDTH - GAP * (columns as i64 + 1)) / columns as i64;
        Panels {
            columns,
            rows: count.div_ceil(columns),
            tallest: side,
            side,
        }
    }

    /// The layout if no panel is taller than this.
    pub(super) fn tallest(self, tallest: i64) -> Panels {
        Panels { tallest, ..self }
    }

    /// Width and height of the sheet.
    pub(super) fn size(&self) -> [i64; 2] {
        [WIDTH, GAP + self.rows as i64 * self.row()]
    }

    /// Writes a panel: a drawing of this size, clipped to its frame and centered in its column, with a
    /// title and a text below.
    pub(super) fn write<W: Write>(
        &self,
        out: &mut W,
        position: usize,
        [width, height]: [i64; 2],
        class: &str,
        [title, text]: [&str; 2],
        draw: impl FnOnce(&mut W) -> io::Result<()>,
    ) -> io::Result<()> {
        let (row, column) = (position / self.columns, position % self.columns);
        let left = GAP + column as i64 * (self.side + GAP);
        let top = GAP + row as i64 * self.row();
        let x = left + (self.side - width) / 2;
        let place = format!("x=\"{x}\" y=\"{top}\" width=\"{width}\" height=\"{height}\"");
        writeln!(out, "<svg class=\"{class}\" {place}>")?;
        draw(out)?;
        writeln!(out, "</svg>\n<rect class=\"frame\" {place}/>")?;
        write_caption(out, [left, top + height], self.side, title, text)
    }

    fn row(&self) -> i64 {
        self.tallest + CAPTION_HEIGHT + GAP
    }
}

/// The style rules of panels and their captions.
pub(super) fn rules() -> String {
    let caption = caption_rules();
    format!(".frame {{ stroke: {MIST}; stroke-width: 100; fill: none }}\n{caption}")
}

/// Room for a title and three lines of text.
const CAPTION_HEIGHT: i64 = 86 * PIXEL;
const LINE: i64 = 18 * PIXEL;
/// About the width of a letter.
const LETTER: i64 = 7 * PIXEL;

/// The style rules of its classes.
fn caption_rules() -> String {
    format!(
        ".title {{ font-size: {}px; font-weight: bold }}\n\
         .caption {{ font-size: {}px }}\n",
        15 * PIXEL,
        13 * PIXEL
    )
}

/// Writes a caption with its upper left corner at a place, `width` units wide.
fn write_caption(
    out: &mut impl Write,
    [x, y]: [i64; 2],
    width: i64,
    title: &str,
    text: &str,
) -> io::Result<()> {
    let mut baseline = y + LINE;
    writeln!(
        out,
        "<text class=\"title\" x=\"{x}\" y=\"{baseline}\">{title}</text>"
    )?;
    let letters = usize::try_from(width / LETTER).unwrap_or(0);
    for line in wrapped(text, letters) {
        baseline += LINE;
        writeln!(
            out,
            "<text class=\"caption\" x=\"{x}\" y=\"{baseline}\">{line}</text>"
        )?;
    }
    Ok(())
}

/// The words of a text in lines of at most `letters` letters; a longer word has a line of its own.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if length(line) + 1 + length(word) <= letters => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn lines_are_full_and_not_overfull() {
        assert_eq!(wrapped("", 5), Vec::<String>::new());
        assert_eq!(wrapped("a bc def", 4), ["a bc", "def"]);
        assert_eq!(wrapped("a bc def", 3), ["a", "bc", "def"]);
        assert_eq!(wrapped("–– –– incircle –", 5), ["–– ––", "incircle", "–"]);
    }
}
