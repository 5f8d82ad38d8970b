//! Pictures of steps: one alone, or a contact sheet of several, each with its sentence below.

use std::io::{self, Write};
use std::ops::RangeInclusive;

use super::frame::Frame;
use super::panel::Panel;
use super::positions;
use super::scene::Scene;
use super::story::{heading, sentence};
use crate::formats::Graph;
use crate::scalar::Scalar;
use crate::trace::Event;

/// How many steps a contact sheet shows at most; it says so if it was to show more.
pub const MOST_PANELS: usize = 60;

const STYLE: &str = include_str!("sheet.css");
const WIDTH: f64 = 1200.0;
const GAP: f64 = 24.0;
/// Room for a heading and three lines.
const CAPTION: f64 = 86.0;
const LINE: f64 = 18.0;

const DEFINITIONS: &str = r##"<defs>
<pattern id="upper" width="7" height="7" patternUnits="userSpaceOnUse"><rect width="7" height="7" fill="#56B4E9" fill-opacity="0.2"/><path d="M-1 8L8 -1" stroke="#56B4E9"/></pattern>
<pattern id="lower" width="7" height="7" patternUnits="userSpaceOnUse"><rect width="7" height="7" fill="#F0E442" fill-opacity="0.25"/><path d="M-1 -1L8 8" stroke="#B8A500"/></pattern>
<marker id="arrow" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="4" markerHeight="4" orient="auto"><path d="M0 0L10 5L0 10Z" style="fill:#0072B2"/></marker>
</defs>"##;

/// Draws some steps of a run, of which `events` are all up to the last of them. The first step has the
/// number 1.
///
/// # Errors
/// Those of `out`.
pub fn write_sheet<S: Scalar>(
    graph: &Graph<S>,
    events: &[Event],
    steps: RangeInclusive<usize>,
    out: &mut impl Write,
) -> io::Result<()> {
    let frame = Frame::of(&graph.points);
    let wanted = positions(&steps, events.len(), usize::MAX / 2).len();
    let positions = positions(&steps, events.len(), MOST_PANELS);
    let mut scene = Scene::new();
    for event in &events[..positions.start] {
        scene.advance(event);
    }
    let columns = match positions.len() {
        0 | 1 => 1.0,
        2 | 4 => 2.0,
        _ => 3.0,
    };
    let side = (WIDTH - GAP * (columns + 1.0)) / columns;
    let mut panels = Vec::new();
    for (number, event) in (positions.start + 1..).zip(&events[positions.clone()]) {
        scene.advance(event);
        let panel = Panel::new(&frame, &graph.edges, &scene, side);
        panels.push((number, event, panel.size(), panel.draw(&scene)));
    }
    let tallest = panels.iter().map(|(_, _, size, _)| size[1]);
    let tallest = tallest.fold(0.0, f64::max);
    let rows = (panels.len() as f64 / columns).ceil();
    let height = GAP + rows * (tallest + CAPTION + GAP);
    write!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height:.0}" viewBox="0 0 {WIDTH} {height:.0}">
<style>
{STYLE}</style>
{DEFINITIONS}
<rect class="paper" width="{WIDTH}" height="{height:.0}"/>
"#
    )?;
    let (mut column, mut y) = (0.0, GAP);
    for (number, event, [width, height], drawn) in panels {
        let left = GAP + column * (side + GAP);
        let x = left + (side - width) / 2.0;
        writeln!(
            out,
            r#"<svg x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}">"#
        )?;
        writeln!(out, "{drawn}</svg>")?;
        writeln!(
            out,
            r#"<rect class="frame" x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}"/>"#
        )?;
        let mut baseline = y + height + LINE + 2.0;
        let title = format!("{number}  {}", heading(event));
        text(out, "number", [left, baseline], &title)?;
        for line in wrapped(&sentence(event), side) {
            baseline += LINE;
            text(out, "sentence", [left, baseline], &line)?;
        }
        column += 1.0;
        if column >= columns {
            (column, y) = (0.0, y + tallest + CAPTION + GAP);
        }
    }
    if wanted > MOST_PANELS {
        let note = format!("The first {MOST_PANELS} of {wanted} steps.");
        text(out, "sentence", [GAP, height - GAP / 2.0], &note)?;
    }
    writeln!(out, "</svg>")
}

fn text(out: &mut impl Write, class: &str, [x, y]: [f64; 2], text: &str) -> io::Result<()> {
    writeln!(
        out,
        r#"<text class="{class}" x="{x:.1}" y="{y:.1}">{text}</text>"#
    )
}

/// Text in lines so many pixels wide.
fn wrapped(text: &str, width: f64) -> Vec<String> {
    // A letter is about this wide.
    let fits = |line: &str| line.chars().count() as f64 * 6.8 < width;
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.last().map_or("", String::as_str);
        let longer = if last.is_empty() {
            word.to_owned()
        } else {
            format!("{last} {word}")
        };
        if last.is_empty() || fits(&longer) {
            lines.pop();
            lines.push(longer);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}
