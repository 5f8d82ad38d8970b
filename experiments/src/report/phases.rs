//! Bars of the time of the three parts of the algorithm (section 3.2), nanoseconds a point.

use plotters::style::BLACK;

use super::canvas::{Place, TEXT, TITLE, fill, svg, text};
use super::number::{short, size as short_size};
use super::palette::{BLUE, ORANGE, ink, tint};
use super::view::View;
use crate::measure::Row;

/// Pixels: a bar, the names left of it, the title and the legend above.
const BAR: i32 = 30;
const LEFT: i32 = 250;
const TOP: i32 = 80;
const LENGTH: i32 = 600;
const MARGIN: i32 = 10;
/// Room for the sum behind the longest bar.
const SUM: i32 = 60;

pub(super) fn draw(view: &View, rows: &[Row]) -> String {
    let parts = [
        ("initialization", tint(BLUE, 0.85)),
        ("sweeping", tint(ORANGE, 0.55)),
        ("finalization", tint(BLACK, 0.5)),
    ];
    let greatest = rows
        .iter()
        .map(on_the_clock)
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
            let times = [row.initialization_ms, row.sweeping_ms, row.finalization_ms];
            let per_point = |time: f64| 1e6 * time / row.points.max(1) as f64;
            let pixels = |time: f64| (per_point(time) / greatest * f64::from(LENGTH)) as i32;
            let mut left = LEFT;
            for (time, (_, colour)) in times.into_iter().zip(parts) {
                let right = left + pixels(time);
                fill(area, [(left, top + 3), (right, top + BAR - 3)], colour);
                let number = short(per_point(time));
                if right - left > 40 {
                    let at = ((left + right) / 2, middle);
                    text(area, &number, at, Place::Middle, TEXT - 1, ink(colour));
                }
                left = right;
            }
            let sum = short(times.map(per_point).iter().sum());
            text(area, &sum, (left + 6, middle), Place::Right, TEXT, BLACK);
        }
    })
}

/// Nanoseconds a point of all parts together.
fn on_the_clock(row: &Row) -> f64 {
    1e6 * row.total_ms / row.points.max(1) as f64
}
