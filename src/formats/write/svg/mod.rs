//! SVG: a picture to be read at a glance, of ten points as well as of a million.
//!
//! From back to front: the hull's area (pale) and border (a broad orange band, so that an edge on the
//! border shows inside it), sides of triangles (thin, grey), input edges (blue), vertices (dark dots)
//! and their numbers in the file; dots and numbers only where there is room for them. The colours are
//! from Okabe and Ito's palette, which colour-blind people can tell, and widths differ as well. They
//! follow the distance of neighbouring vertices. Each line is drawn once, as part of a stroke as long
//! as possible, in relative whole units of a hundredth of a pixel: about 10 bytes a side.

mod drawing;
mod frame;
mod legend;
mod violations;
mod window;

use std::fmt::{Display, Write as _};
use std::io::{self, Write};

use frame::{Frame, PIXEL, units};
pub use violations::write_violations_svg;

use crate::Triangulation;
use crate::formats::write::trails::{sorted_pairs, trails};
use crate::formats::{Coordinate, Graph};

/// Up to how many vertices numbers are written.
const MOST_NUMBERS: usize = 60;
/// From which spacing on, in pixels, vertices are drawn.
const LEAST_SPACING: f64 = 8.0;
/// A path ends when its text is that long: programs refuse attributes that are much longer.
const LONGEST_PATH: usize = 100_000;

/// Draws the picture.
pub(super) fn write<S: Coordinate>(
    graph: &Graph<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    let frame = Frame::of(&graph.points);
    let places: Vec<[i64; 2]> = graph
        .points
        .iter()
        .map(|point| frame.place(point))
        .collect();
    let hull: Vec<usize> = result.hull().chain(result.hull().take(1)).collect();
    let strokes = |sides: &[[usize; 2]]| {
        trails(places.len(), sides)
            .into_iter()
            .map(|trail| stroke(&places, &trail))
    };
    let vertices = || (0..places.len()).filter(|&v| result.representative(v) == v);

    let [width, height] = frame.outer();
    begin(out, [width, height], frame.spacing)?;
    if let [_, .., _] = hull[..] {
        layer(out, "hull", std::iter::once(stroke(&places, &hull)))?;
    }
    layer(out, "side", strokes(&inner_sides(result)))?;
    layer(out, "edge", strokes(&input_edges(graph, result)))?;
    let mut entries = vec![
        ("side", format!("triangles: {}", result.len())),
        ("edge", format!("edges: {}", graph.edges.len())),
        ("hull", format!("hull: {}", result.hull().len())),
    ];
    if frame.spacing > LEAST_SPACING {
        let dots = vertices().map(|v| format!("M{} {}h0", places[v][0], places[v][1]));
        layer(out, "vertex", dots)?;
        entries.push(("vertex", format!("vertices: {}", places.len())));
    }
    if places.len() <= MOST_NUMBERS {
        numbers(out, &places, graph.first_vertex, vertices())?;
    }
    legend::write(out, [width / 2, height], &entries)?;
    writeln!(out, "</svg>")
}

/// The sides between two triangles that are not pieces of input edges.
fn inner_sides(result: &Triangulation) -> Vec<[usize; 2]> {
    let of_triangle = |t: usize| {
        let corners = result.triangle(t);
        let is_inner = move |side: &usize| {
            let across = result.neighbor(t, *side);
            across.is_some_and(|across| across > t) && !result.is_constrained(t, *side)
        };
        let ends = move |side| [corners[(side + 1) % 3], corners[(side + 2) % 3]];
        (0..3).filter(is_inner).map(ends)
    };
    sorted_pairs((0..result.len()).flat_map(of_triangle))
}

/// The input edges that have a length, each once.
fn input_edges<S>(graph: &Graph<S>, result: &Triangulation) -> Vec<[usize; 2]> {
    let ends = graph
        .edges
        .iter()
        .map(|edge| edge.map(|vertex| result.representative(vertex)));
    let mut edges = sorted_pairs(ends.filter(|[a, b]| a != b));
    edges.dedup();
    edges
}

/// Begins a picture of this size without the legend, with lines for vertices so far apart.
fn begin(out: &mut impl Write, [width, height]: [i64; 2], spacing: f64) -> io::Result<()> {
    let height = height + legend::HEIGHT;
    write!(
        out,
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {width} {height}">
<style>
path {{ fill: none; stroke-linecap: round; stroke-linejoin: round }}
.hull {{ stroke: #E69F00; fill: #F6F5F1 }}
.side {{ stroke: #848E98 }}
.edge {{ stroke: #0072B2 }}
.vertex {{ stroke: #1B1F23 }}
"##,
        width / PIXEL,
        height / PIXEL,
    )?;
    widths(out, "", spacing)?;
    write!(
        out,
        r##".sample.hull {{ stroke-width: 700 }}
.sample.side {{ stroke-width: 120 }}
.sample.edge {{ stroke-width: 300 }}
.sample.vertex {{ stroke-width: 700; stroke-dasharray: 1 1150 }}
text {{ font: {}px sans-serif; fill: #1B1F23; paint-order: stroke; stroke: #FFF; stroke-width: 350 }}
</style>
<rect width="{width}" height="{height}" fill="#FFF"/>
"##,
        15 * PIXEL,
    )
}

/// Writes how wide lines are inside `scope`, where vertices are so far apart.
fn widths(out: &mut impl Write, scope: &str, spacing: f64) -> io::Result<()> {
    for (class, share, least, most) in [
        ("hull", 0.08, 1.6, 7.0),
        ("side", 0.05, 0.1, 1.4),
        ("edge", 0.12, 0.3, 3.0),
        ("vertex", 0.2, 1.5, 8.0),
    ] {
        let width = units((spacing * share).clamp(least, most) * PIXEL as f64);
        writeln!(out, "{scope}.{class} {{ stroke-width: {width} }}")?;
    }
    Ok(())
}

/// Writes the pieces of a layer, joined to paths.
fn layer(
    out: &mut impl Write,
    class: &str,
    pieces: impl Iterator<Item = String>,
) -> io::Result<()> {
    let mut pieces = pieces.peekable();
    let mut path = String::new();
    while let Some(piece) = pieces.next() {
        path.push_str(&piece);
        if path.len() > LONGEST_PATH || pieces.peek().is_none() {
            writeln!(out, "<path class=\"{class}\" d=\"{path}\"/>")?;
            path.clear();
        }
    }
    Ok(())
}

/// A stroke through vertices; steps shorter than a unit are left out, and so is a stroke without any.
fn stroke(places: &[[i64; 2]], trail: &[usize]) -> String {
    let [mut x, mut y] = places[trail[0]];
    let start = format!("M{x} {y}");
    let mut path = start.clone();
    for &vertex in &trail[1..] {
        let [to_x, to_y] = places[vertex];
        let (right, down) = (to_x - x, to_y - y);
        if (right, down) != (0, 0) {
            let first = path.len() == start.len();
            let before = if first { "l" } else { space(right) };
            write!(path, "{before}{right}{}{down}", space(down)).expect("strings grow");
            (x, y) = (to_x, to_y);
        }
    }
    if path.len() == start.len() {
        String::new()
    } else {
        path
    }
}

/// What separates a number from the one before it.
fn space(number: i64) -> &'static str {
    if number < 0 { "" } else { " " }
}

/// Writes vertices' numbers beside them.
fn numbers(
    out: &mut impl Write,
    places: &[[i64; 2]],
    first: usize,
    vertices: impl Iterator<Item = usize>,
) -> io::Result<()> {
    for vertex in vertices {
        label(out, places[vertex], vertex + first)?;
    }
    Ok(())
}

/// Writes a text beside a place.
fn label(out: &mut impl Write, [x, y]: [i64; 2], text: impl Display) -> io::Result<()> {
    let (x, y) = (x + 7 * PIXEL, y - 7 * PIXEL);
    writeln!(out, "<text x=\"{x}\" y=\"{y}\">{text}</text>")
}
