//! The line of the legend that says what the colours of a relief mean: the name of the heights and the lowest, a bar of
//! tints, the highest, and how many vertices have none.

use std::io::{self, Write};

use super::relief::{Relief, TINTS, tint};
use super::style::{BAR, GAP, Rgb, SAMPLE, UNKNOWN};
use super::window::PIXEL;

/// Places of the parts, in units.
#[derive(Debug)]
pub(super) struct ReliefLegend {
    /// The boxes of the bar, from their upper left to their lower right corners.
    pub(super) boxes: Vec<(Rgb, [[i64; 2]; 2])>,
    /// What stands before the bar, and where it ends.
    pub(super) low: ([i64; 2], String),
    /// What stands behind the bar, and where it begins.
    pub(super) high: ([i64; 2], String),
    /// How many vertices have no height, if any, and where that begins.
    pub(super) missing: Option<([i64; 2], String)>,
}

impl ReliefLegend {
    /// The parts of a legend that is centered at `middle` below `top`.
    pub(super) fn new([middle, top]: [i64; 2], relief: &Relief) -> ReliefLegend {
        let ([width, height], baseline) = (BAR, top + 19 * PIXEL);
        let [left, upper] = [middle - width / 2, top + 7 * PIXEL];
        let edge = |at: usize| left + width * at as i64 / TINTS as i64;
        let bar = (0..TINTS).map(|at| {
            let corners = [[edge(at), upper], [edge(at + 1), upper + height]];
            (tint(at), corners)
        });
        let mut boxes: Vec<(Rgb, [[i64; 2]; 2])> = bar.collect();
        let right = left + width + GAP;
        let [low, high] = &relief.range;
        // The sample of grey stands well behind the highest height.
        let sample = middle + width / 2 + 130 * PIXEL;
        let missing = (relief.missing > 0).then(|| {
            boxes.push((
                UNKNOWN,
                [[sample, upper], [sample + SAMPLE, upper + height]],
            ));
            let text = format!("no height: {}", relief.missing);
            ([sample + SAMPLE + GAP, baseline], text)
        });
        ReliefLegend {
            boxes,
            low: ([left - GAP, baseline], format!("{}: {low}", relief.name)),
            high: ([right, baseline], high.clone()),
            missing,
        }
    }

    /// Writes it as SVG.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "<g class=\"legend heights\">")?;
        for ([r, g, b], [[left, top], [right, bottom]]) in &self.boxes {
            let (width, height) = (right - left, bottom - top);
            writeln!(
                out,
                "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"#{r:02X}{g:02X}{b:02X}\"/>"
            )?;
        }
        let ([x, y], low) = &self.low;
        let low = escaped(low);
        writeln!(
            out,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"end\">{low}</text>"
        )?;
        for ([x, y], text) in [&self.high].into_iter().chain(&self.missing) {
            writeln!(out, "<text x=\"{x}\" y=\"{y}\">{text}</text>")?;
        }
        writeln!(out, "</g>")
    }
}

/// A text as XML has it.
fn escaped(text: &str) -> String {
    let printable = text.chars().filter(|letter| !letter.is_control());
    let text: String = printable.collect();
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
