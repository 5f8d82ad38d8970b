//! Plots of boxes with numbers in them: maps, and bars of the parts of the algorithm.

use plotters::style::{BLACK, Color, RGBColor, WHITE};

use super::canvas::{
    Area, BLUE, GREY, ORANGE, Place, TEXT, TITLE, fill, ink, line, svg, text, tint,
};
use super::table::{Entry, Table};
use super::view::{View, short, size as short_size};
use crate::measure::Row;

/// Pixels of a map: a box, the names of the variants, those of the columns above.
const BOX: [i32; 2] = [60, 26];
const NAMES: i32 = 215;
const HEADS: i32 = 145;
const MARGIN: i32 = 10;

const LEGEND: &str =
    "= no difference of 5 % is sure; framed: faster than the first; darker: slower, up to 4 times";

/// A map: a box for each variant and column, with its number, and darker where it is larger.
pub(super) fn map(table: &Table, scale: Scale) -> String {
    let [columns, lines] = [table.columns.len(), table.lines.len()]
        .map(|count| i32::try_from(count).expect("a small table"));
    // Room for the title, whatever the columns need.
    let title = i32::try_from(table.title.len()).expect("a short title") * 9 + 2 * MARGIN;
    let width = (NAMES + columns * BOX[0] + MARGIN).max(title);
    let legend = matches!(scale, Scale::Ratios);
    let height = HEADS + lines * BOX[1] + MARGIN + if legend { BOX[1] } else { 0 };
    let size = [width, height].map(|pixels| u32::try_from(pixels).expect("positive"));
    svg((size[0], size[1]), |area| {
        text(area, &table.title, (MARGIN, 18), Place::Right, TITLE, BLACK);
        if legend {
            let at = (MARGIN, height - MARGIN - BOX[1] / 2);
            text(area, LEGEND, at, Place::Right, TEXT - 2, BLACK);
        }
        for (i, column) in (0..).zip(&table.columns) {
            let at = (NAMES + i * BOX[0] + BOX[0] / 2, HEADS - 6);
            text(area, column, at, Place::Upwards, TEXT, BLACK);
        }
        for (j, line) in (0..).zip(&table.lines) {
            let top = HEADS + j * BOX[1];
            let middle = top + BOX[1] / 2;
            text(
                area,
                &line.variant,
                (NAMES - 6, middle),
                Place::Left,
                TEXT,
                BLACK,
            );
            for (i, entry) in (0..).zip(&line.cells) {
                let left = NAMES + i * BOX[0];
                let (colour, number) = match *entry {
                    Entry::Number(x) => (scale.colour(x), short(x)),
                    Entry::Ratio(ratio) if ratio.is_tie() => {
                        (WHITE, format!("={}", short(ratio.middle)))
                    }
                    Entry::Ratio(ratio) => (scale.colour(ratio.middle), short(ratio.middle)),
                    Entry::LeftOut => (GREY, "left out".to_owned()),
                    Entry::Unknown => continue,
                };
                let corners = [(left, top), (left + BOX[0] - 1, top + BOX[1] - 1)];
                fill(area, corners, colour);
                if matches!(entry, Entry::Ratio(ratio) if ratio.verdict() == Some("loss")) {
                    frame(area, corners);
                }
                let at = (left + BOX[0] / 2, middle);
                text(area, &number, at, Place::Middle, TEXT - 2, ink(colour));
            }
        }
    })
}

/// A line around a box.
fn frame(area: &Area<'_>, [(left, top), (right, bottom)]: [(i32, i32); 2]) {
    let corners = [
        (left, top),
        (right, top),
        (right, bottom),
        (left, bottom),
        (left, top),
    ];
    line(area, corners.to_vec(), BLACK.stroke_width(2));
}

/// The colour of a number.
#[derive(Clone, Copy, Debug)]
pub(super) enum Scale {
    /// From white to blue by logarithm.
    Logarithmic { least: f64, greatest: f64 },
    /// White at 1 and below, blue at 4, by logarithm.
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
            Scale::Ratios => tint(BLUE, x.log(4.0)),
            Scale::Exponents => tint(BLUE, x),
        }
    }
}

const SMALLEST: f64 = 0.01;

/// Pixels of bars: a bar, the names left of it, the title and the legend above.
const BAR: i32 = 30;
const LEFT: i32 = 250;
const TOP: i32 = 80;
const LENGTH: i32 = 600;
/// Room for the sum behind the longest bar.
const SUM: i32 = 60;

/// Bars of the time of the three parts of the algorithm (section 3.2), nanoseconds a point.
pub(super) fn phases(view: &View, rows: &[Row]) -> String {
    let parts = [
        ("initialization", tint(BLUE, 0.85)),
        ("sweeping", tint(ORANGE, 0.55)),
        ("finalization", tint(BLACK, 0.5)),
    ];
    let greatest = rows
        .iter()
        .filter_map(|row| Some(row.phases()?.iter().sum()))
        .fold(f64::MIN_POSITIVE, f64::max);
    let count = i32::try_from(rows.len()).expect("few rows");
    let size = [LEFT + LENGTH + SUM, TOP + count * BAR + MARGIN]
        .map(|pixels| u32::try_from(pixels).expect("positive"));
    svg((size[0], size[1]), |area| {
        text(area, view.title, (MARGIN, 18), Place::Right, TITLE, BLACK);
        for (i, (name, colour)) in (0..).zip(parts) {
            let left = LEFT + i * 150;
            fill(area, [(left, 44), (left + 16, 60)], colour);
            text(area, name, (left + 24, 52), Place::Right, TEXT, BLACK);
        }
        for (j, row) in (0..).zip(rows) {
            let (top, middle) = (TOP + j * BAR, TOP + j * BAR + BAR / 2);
            let name = format!("{} {}, {}", row.data, short_size(row.points), row.variant);
            text(area, &name, (LEFT - 8, middle), Place::Left, TEXT, BLACK);
            let times = row.phases().unwrap_or_default();
            let pixels = |time: f64| (time / greatest * f64::from(LENGTH)) as i32;
            let mut left = LEFT;
            for (time, (_, colour)) in times.into_iter().zip(parts) {
                let right = left + pixels(time);
                fill(area, [(left, top + 3), (right, top + BAR - 3)], colour);
                let number = short(time);
                if right - left > 40 {
                    let at = ((left + right) / 2, middle);
                    text(area, &number, at, Place::Middle, TEXT - 1, ink(colour));
                }
                left = right;
            }
            let sum = short(times.iter().sum());
            text(area, &sum, (left + 6, middle), Place::Right, TEXT, BLACK);
        }
    })
}
