//! A map: a box for each variant and column, with its number, and darker where it is larger.

use plotters::style::{BLACK, RGBColor};

use super::canvas::{Place, TEXT, TITLE, fill, svg, text};
use super::number::short;
use super::palette::{BLUE, GREY, ORANGE, ink, tint};
use super::table::{Entry, Table};

/// What colour a number has.
#[derive(Clone, Copy, Debug)]
pub(super) enum Scale {
    /// From white to blue by logarithm.
    Logarithmic { least: f64, greatest: f64 },
    /// White at 1, blue at 4, orange at a quarter, by logarithm.
    Ratios,
    /// White at 0, blue at 1.
    Exponents,
}

impl Scale {
    /// The logarithmic scale that spans the numbers of a table; those below a hundredth count as one.
    pub(super) fn of(table: &Table) -> Scale {
        let entries = table.lines.iter().flat_map(|line| &line.cells);
        let (mut least, mut greatest) = (f64::INFINITY, SMALLEST);
        for entry in entries {
            if let Entry::Number(x) = *entry {
                least = least.min(x.max(SMALLEST));
                greatest = greatest.max(x);
            }
        }
        Scale::Logarithmic { least, greatest }
    }

    fn colour(self, x: f64) -> RGBColor {
        match self {
            Scale::Logarithmic { least, greatest } => {
                let span = (greatest / least).ln().max(f64::MIN_POSITIVE);
                tint(BLUE, (x.max(SMALLEST) / least).ln() / span)
            }
            Scale::Ratios => {
                let part = x.log(4.0);
                tint(if part < 0.0 { ORANGE } else { BLUE }, part.abs())
            }
            Scale::Exponents => tint(BLUE, x),
        }
    }
}

const SMALLEST: f64 = 0.01;

/// Pixels: a box, the names of the variants, those of the columns above.
const BOX: [i32; 2] = [60, 26];
const LEFT: i32 = 215;
const TOP: i32 = 145;
const MARGIN: i32 = 10;

pub(super) fn draw(table: &Table, scale: Scale) -> String {
    let [columns, lines] = [table.columns.len(), table.lines.len()]
        .map(|count| i32::try_from(count).expect("a small table"));
    // Room for the title, whatever the columns need.
    let title = i32::try_from(table.title.len()).expect("a short title") * 9 + 2 * MARGIN;
    let width = (LEFT + columns * BOX[0] + MARGIN).max(title);
    let height = TOP + lines * BOX[1] + MARGIN;
    let size = [width, height].map(|pixels| u32::try_from(pixels).expect("positive"));
    svg((size[0], size[1]), |area| {
        text(area, &table.title, (MARGIN, 18), Place::Right, TITLE, BLACK);
        for (i, column) in (0..).zip(&table.columns) {
            let at = (LEFT + i * BOX[0] + BOX[0] / 2, TOP - 6);
            text(area, column, at, Place::Upwards, TEXT, BLACK);
        }
        for (j, line) in (0..).zip(&table.lines) {
            let top = TOP + j * BOX[1];
            let middle = top + BOX[1] / 2;
            text(
                area,
                &line.variant,
                (LEFT - 6, middle),
                Place::Left,
                TEXT,
                BLACK,
            );
            for (i, entry) in (0..).zip(&line.cells) {
                let left = LEFT + i * BOX[0];
                let (colour, number) = match *entry {
                    Entry::Number(x) => (scale.colour(x), short(x)),
                    Entry::LeftOut => (GREY, "left out".to_owned()),
                    Entry::Unknown => continue,
                };
                let corners = [(left, top), (left + BOX[0] - 1, top + BOX[1] - 1)];
                fill(area, corners, colour);
                let at = (left + BOX[0] / 2, middle);
                text(area, &number, at, Place::Middle, TEXT - 2, ink(colour));
            }
        }
    })
}
