//! Several drawings on one sheet: framed panels in rows, each with its caption below.

use std::io::{self, Write};

use super::caption;
use super::palette::MIST;
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
        caption::write(out, [left, top + height], self.side, title, text)
    }

    fn row(&self) -> i64 {
        self.tallest + caption::HEIGHT + GAP
    }
}

/// The style rules of panels and their captions.
pub(super) fn rules() -> String {
    let caption = caption::rules();
    format!(".frame {{ stroke: {MIST}; stroke-width: 100; fill: none }}\n{caption}")
}
