//! The picture of a triangulation, readable with ten points as well as with a million.
//!
//! From back to front: the hull around a domain (thin, dashed); the area (pale) and border of the domain, or of the
//! hull where none is known (a broad orange band, so that an edge on the border shows inside it), sides of triangles (thin, grey), input edges (blue), vertices (dark dots)
//! and their numbers in the file. Dots and numbers are drawn only if there is room for them. Each line is
//! drawn once, as part of a long stroke, in relative whole units: about 10 bytes a side.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::style::{COLUMN, LEGEND_HEIGHT, mesh_rules, write_legend};
use super::svg;
use super::window::{Bounds, PIXEL, Window, places};
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Triangulation};
use sweep_cdt_formats::{Numbering, sorted_pairs};

/// Up to this many vertices get numbers.
const MOST_NUMBERS: usize = 60;
/// Vertices are drawn if they are about this many pixels apart, or more.
const LEAST_SPACING: f64 = 8.0;
/// The longer side of the points' bounding box.
const LONG_SIDE: i64 = 1000 * PIXEL;
/// The longest entries of the legend, without and with a domain: no picture is narrower.
const ENTRIES: [i64; 2] = [4, 5];
const MARGIN: i64 = 28 * PIXEL;

/// A picture of a triangulation, as SVG.
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

    /// Writes the picture.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let ResultPicture {
            graph,
            result,
            numbering,
            interior,
        } = *self;
        let points = places(&graph.points);
        let bounds = Bounds::of(points.iter().copied());
        let window = Window::new(bounds, LONG_SIDE);
        let spacing = bounds.spacing(points.len()) * (LONG_SIDE / PIXEL) as f64;

        // The drawing stands in the middle, with a margin around it and the legend below.
        let [width, height] = [
            window.size[0].max(ENTRIES[usize::from(interior.is_some())] * COLUMN),
            window.size[1],
        ];
        let [width, height] = [width, height].map(|side| side + 2 * MARGIN);
        let left = (width - window.size[0]) / 2;
        let place = |point| {
            let [x, y] = window.place(point);
            [left + x, MARGIN + y]
        };
        let places: Vec<[i64; 2]> = points.into_iter().map(place).collect();
        svg::begin(out, [width, height + LEGEND_HEIGHT], &mesh_rules(spacing))?;

        // Lines, from back to front.
        let strokes = |sides: &[[usize; 2]]| {
            let trails = trails(places.len(), sides).into_iter();
            trails.map(|trail| stroke(&places, &trail))
        };
        let hull: Vec<usize> = result.hull().collect();
        let border = match interior {
            Some(interior) => interior.boundary(),
            None => vec![hull.clone()],
        };
        let closed = |chain: &Vec<usize>| {
            let closed: Vec<usize> = chain.iter().chain(chain.first()).copied().collect();
            if let [_, .., _] = closed[..] {
                stroke(&places, &closed)
            } else {
                String::new()
            }
        };
        // In one path, so that holes are not filled.
        let strokes_of_border: String = border.iter().map(closed).collect();
        let around = closed(&hull);
        if interior.is_some() && !around.is_empty() {
            svg::layer(out, "outside", [around])?;
        }
        if !strokes_of_border.is_empty() {
            svg::layer(out, "hull", [strokes_of_border])?;
        }
        svg::layer(out, "side", strokes(&inner_sides(result, interior)))?;
        svg::layer(out, "edge", strokes(&input_edges(graph, result)))?;

        // Vertices and their numbers, where there is room, and the legend.
        let (triangles, name) = match interior {
            Some(interior) => (interior.inside().len(), "border"),
            None => (result.len(), "hull"),
        };
        let mut entries = vec![
            ("side", format!("triangles: {triangles}")),
            ("edge", format!("edges: {}", graph.edges.len())),
            (
                "hull",
                format!("{name}: {}", border.iter().map(Vec::len).sum::<usize>()),
            ),
        ];
        if interior.is_some() {
            entries.push(("outside", format!("hull: {}", hull.len())));
        }
        let vertices = || (0..places.len()).filter(|&v| result.representative(v) == v);
        if spacing > LEAST_SPACING {
            svg::layer(out, "vertex", vertices().map(|v| svg::dot(places[v])))?;
            entries.push(("vertex", format!("vertices: {}", places.len())));
        }
        if places.len() <= MOST_NUMBERS {
            for vertex in vertices() {
                svg::label(out, places[vertex], vertex + numbering.vertex)?;
            }
        }
        write_legend(out, [width / 2, height], &entries)?;
        svg::end(out)
    }
}

/// The sides between two triangles, of the domain if there is one, that are not pieces of input edges.
fn inner_sides(result: &Triangulation, interior: Option<&Interior<'_>>) -> Vec<[usize; 2]> {
    let is_drawn = |t: usize| interior.is_none_or(|interior| interior.is_inside(t));
    let of_triangle = |t: usize| {
        let corners = result.triangle(t);
        let is_inner = move |side: &usize| {
            let across = result.neighbor(t, *side);
            let is_listed = across.is_some_and(|across| across > t && is_drawn(across));
            is_listed && !result.is_constrained(t, *side)
        };
        let ends = move |side| [corners[(side + 1) % 3], corners[(side + 2) % 3]];
        (0..3).filter(is_inner).map(ends)
    };
    let drawn = (0..result.len()).filter(|&t| is_drawn(t));
    sorted_pairs(drawn.flat_map(of_triangle))
}

/// The input edges that have a length, each once.
fn input_edges<S>(graph: &Pslg<S>, result: &Triangulation) -> Vec<[usize; 2]> {
    let ends = graph
        .edges
        .iter()
        .map(|edge| edge.map(|vertex| result.representative(vertex)));
    let mut edges = sorted_pairs(ends.filter(|[a, b]| a != b));
    edges.dedup();
    edges
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

/// Lines of a drawing joined to long strokes, which are shorter to write than their pieces: long walks that
/// together use each edge once. They start at vertices with an odd number of edges first,
/// since a walk must begin or end there.
///
/// Cost: linear.
fn trails(vertices: usize, edges: &[[usize; 2]]) -> Vec<Vec<usize>> {
    let mut at_vertex = vec![Vec::new(); vertices];
    for (edge, &[a, b]) in edges.iter().enumerate() {
        at_vertex[a].push(edge);
        at_vertex[b].push(edge);
    }
    let odd = (0..vertices)
        .filter(|&v| at_vertex[v].len() % 2 == 1)
        .collect::<Vec<_>>();
    let mut used = vec![false; edges.len()];
    let mut trails = Vec::new();
    for start in odd.into_iter().chain(0..vertices) {
        loop {
            let mut trail = vec![start];
            let mut end = start;
            while let Some(edge) = at_vertex[end].pop() {
                if !std::mem::replace(&mut used[edge], true) {
                    let [a, b] = edges[edge];
                    end = a + b - end;
                    trail.push(end);
                }
            }
            if trail.len() == 1 {
                break;
            }
            trails.push(trail);
        }
    }
    trails
}

#[cfg(test)]
mod tests {
    use super::trails;
    use sweep_cdt_formats::sorted_pairs;

    #[test]
    fn each_edge_is_walked_once() {
        let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [4, 5]];
        let trails = trails(6, &edges);
        let walked = trails
            .iter()
            .flat_map(|trail| trail.windows(2).map(|step| [step[0], step[1]]));
        assert_eq!(sorted_pairs(walked), edges);
        assert_eq!(trails.len(), 2);
    }
}
