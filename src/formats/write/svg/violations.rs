//! SVG: what is wrong with a triangulation. The whole of it with the places of the violations, and
//! then the first ones from near.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::drawing::{Drawing, MOST_PANELS};
use super::frame::PIXEL;
use super::{begin, legend};
use crate::formats::{Coordinate, Graph, Triangles};
use crate::verify::Violation;

const WIDTH: i64 = 1320 * PIXEL;
const GAP: i64 = 24 * PIXEL;
const CAPTION: i64 = 72 * PIXEL;
const LINE: i64 = 18 * PIXEL;

const STYLE: &str = "<style>
.wrong { stroke: #D5190B; stroke-width: 350 }
.absent { stroke: #D5190B; stroke-width: 350; stroke-dasharray: 900 700 }
.circle { stroke: #D5190B; stroke-width: 150; stroke-dasharray: 500 400; fill: none }
.bad { fill: #D5190B; fill-opacity: 0.18; stroke: none }
.culprit { stroke: #D5190B; stroke-width: 1000 }
.sample.wrong { stroke-width: 350 }
.frame { stroke: #C9CED3; stroke-width: 100; fill: none }
.caption { font-size: 1350px }
.class { font-size: 1500px; font-weight: bold; fill: #D5190B }
</style>";

/// Draws a triangulation and its violations, of which `found` is the number of all.
///
/// # Errors
/// Those of `out`.
pub fn write_violations_svg<S: Coordinate>(
    graph: &Graph<S>,
    triangles: &Triangles,
    violations: &[Violation],
    found: usize,
    out: &mut impl Write,
) -> io::Result<()> {
    let drawing = Drawing::new(graph, triangles);
    let focus = |&violation: &Violation| (violation, triangles.vertices_of(graph, violation));
    let foci: Vec<(Violation, Vec<usize>)> = violations
        .iter()
        .map(focus)
        .filter(|(_, vertices)| !vertices.is_empty())
        .collect();
    let panels = 1 + foci.len().min(MOST_PANELS);
    let columns = if panels == 4 { 2 } else { panels.min(3) };
    let rows = panels.div_ceil(columns);
    let size = (WIDTH - GAP * (columns as i64 + 1)) / columns as i64;
    let height = GAP + rows as i64 * (size + CAPTION + GAP);
    begin(out, [WIDTH, height], 60.0)?;
    writeln!(out, "{STYLE}")?;

    for panel in 0..panels {
        let (row, column) = ((panel / columns) as i64, (panel % columns) as i64);
        let corner = [
            GAP + column * (size + GAP),
            GAP + row * (size + CAPTION + GAP),
        ];
        if panel == 0 {
            let title = match found {
                0 => "correct".to_owned(),
                1 => "1 violation".to_owned(),
                _ => format!("{found} violations"),
            };
            drawing.overview(&foci, corner, size, out)?;
            caption(&title, "", corner, size, out)?;
        } else {
            let (violation, vertices) = &foci[panel - 1];
            let numbered = triangles.as_numbered(graph, *violation);
            let title = format!("{panel}: {}", violation.name());
            drawing.detail(*violation, vertices, corner, size, out)?;
            caption(&title, &numbered.to_string(), corner, size, out)?;
        }
    }
    let entries = [
        ("side", format!("triangles: {}", triangles.list.len())),
        ("edge", format!("edges: {}", graph.edges.len())),
        ("hull", "boundary".to_owned()),
        ("vertex", format!("vertices: {}", graph.points.len())),
        ("wrong", format!("violations: {found}")),
    ];
    legend::write(out, [WIDTH / 2, height], &entries)?;
    writeln!(out, "</svg>")
}

/// Writes what a panel shows under it.
fn caption(
    title: &str,
    text: &str,
    [x, y]: [i64; 2],
    size: i64,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut baseline = y + size + LINE;
    writeln!(
        out,
        "<text class=\"class\" x=\"{x}\" y=\"{baseline}\">{title}</text>"
    )?;
    // A letter is about this wide.
    let letters = usize::try_from(size / (7 * PIXEL)).unwrap_or(0);
    for line in wrapped(text, letters) {
        baseline += LINE;
        writeln!(
            out,
            "<text class=\"caption\" x=\"{x}\" y=\"{baseline}\">{line}</text>"
        )?;
    }
    Ok(())
}

/// Text in lines of about so many letters.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < letters => {
                write!(line, " {word}").expect("strings grow");
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
