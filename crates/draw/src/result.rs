//! The picture of a triangulation, readable with ten points as well as with a million.
//!
//! From back to front: the hull around a domain (thin, dashed); the area (pale) and border of the domain, or of the
//! hull where none is known (a broad orange band, so that an edge on the border shows inside it), sides of triangles (thin, grey), input edges (blue), vertices (dark dots)
//! and their numbers in the file. Dots and numbers are drawn only if there is room for them. Each line is
//! drawn once, as part of a long stroke, in relative whole units: about 10 bytes a side.
//!
//! With heights the triangles are areas of colours between the area of the domain and the lines: one path for each colour,
//! around all of its triangles. Where vertices are close, sides are left out.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::layout::Layout;
use super::pixels;
use super::relief_legend::ReliefLegend;
use super::style::{LEGEND_HEIGHT, mesh_rules, relief_rules, write_legend};
use super::svg;
use super::trails::loops;
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Triangulation};
use sweep_cdt_formats::{Column, Numbering};

/// A picture of a triangulation, as SVG or PNG.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_draw::ResultPicture;
///
/// let points = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let graph = Pslg { points, edges: vec![[0, 2]], ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut picture = Vec::new();
/// ResultPicture::new(&graph, &result).write(&mut picture)?;
/// assert!(picture.starts_with(b"<svg "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct ResultPicture<'a, S> {
    graph: &'a Pslg<S>,
    result: &'a Triangulation,
    numbering: Numbering,
    interior: Option<&'a Interior<'a>>,
    heights: Option<&'a Column>,
}

impl<'a, S: Scalar> ResultPicture<'a, S> {
    /// A picture of `result`, the triangulation of `graph`.
    #[must_use]
    pub fn new(graph: &'a Pslg<S>, result: &'a Triangulation) -> ResultPicture<'a, S> {
        ResultPicture {
            graph,
            result,
            numbering: Numbering::default(),
            interior: None,
            heights: None,
        }
    }

    /// How the file of the graph counts its vertices. By default from 0.
    #[must_use]
    pub fn numbering(self, numbering: Numbering) -> Self {
        ResultPicture { numbering, ..self }
    }

    /// Draws only the triangles inside a domain of this triangulation, and its border. The hull is a thin dashed line
    /// around it, with nothing between the two but the vertices and edges of the input, which are all drawn.
    #[must_use]
    pub fn interior(self, interior: &'a Interior<'a>) -> ResultPicture<'a, S> {
        let interior = Some(interior);
        ResultPicture { interior, ..self }
    }

    /// Colours the triangles by height, with hill shading: the sun stands in the north-west, 45 degrees high, and heights
    /// are stretched so that the mean slope is one of hills. Triangles with a corner that has no height are grey. Where
    /// all heights are equal or missing, the picture is the one without them.
    #[must_use]
    pub fn heights(self, heights: &'a Column) -> ResultPicture<'a, S> {
        let heights = Some(heights);
        ResultPicture { heights, ..self }
    }

    /// Writes the picture as PNG.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_png(&self, out: &mut impl Write) -> io::Result<()> {
        pixels::write(&self.layout(), self.numbering, out)
    }

    fn layout(&self) -> Layout {
        Layout::new(self.graph, self.result, self.interior, self.heights)
    }

    /// Writes the picture as SVG.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        write_layout(&self.layout(), self.numbering, out)
    }
}

/// Writes a picture of triangles or cells as SVG.
pub(super) fn write_layout(
    layout: &Layout,
    numbering: Numbering,
    out: &mut impl Write,
) -> io::Result<()> {
    let Layout { places, relief, .. } = layout;
    let mut rules = mesh_rules(layout.spacing);
    if relief.is_some() {
        rules += &relief_rules(layout.spacing);
    }
    svg::begin(out, layout.whole_size(), &rules)?;

    // Areas and lines, from back to front.
    let stroke_of = |trail: &Vec<usize>| stroke(places, trail);
    let border = |chain: &Vec<usize>| match chain[..] {
        [_, .., _] => stroke_of(chain),
        _ => String::new(),
    };
    // In one path, so that holes are not filled.
    let strokes_of_border: String = layout.border.iter().map(border).collect();
    let around = layout.outside.as_ref().map(border);
    if let Some(around) = around.filter(|around| !around.is_empty()) {
        svg::layer(out, "outside", [around])?;
    }
    if !strokes_of_border.is_empty() {
        svg::layer(out, "hull", [strokes_of_border])?;
    }
    for (colour, sides) in relief.iter().flat_map(|relief| &relief.colours) {
        let loops = loops(sides);
        svg::area(out, "relief", *colour, loops.iter().map(stroke_of))?;
    }
    svg::layer(out, "side", layout.sides.iter().map(stroke_of))?;
    svg::layer(out, "edge", layout.edges.iter().map(stroke_of))?;

    // Vertices and their numbers, where there is room, and the legend.
    svg::layer(
        out,
        "vertex",
        layout.dots.iter().map(|&v| svg::dot(places[v])),
    )?;
    for &vertex in &layout.numbered {
        svg::label(out, places[vertex], vertex + numbering.vertex)?;
    }
    let [middle, mut top] = [layout.size[0] / 2, layout.size[1]];
    if let Some(relief) = relief {
        ReliefLegend::new([middle, top], relief).write(out)?;
        top += LEGEND_HEIGHT;
    }
    write_legend(out, [middle, top], &layout.entries)?;
    svg::end(out)
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

/// The separator between a number and the one before it.
fn space(number: i64) -> &'static str {
    if number < 0 { "" } else { " " }
}
