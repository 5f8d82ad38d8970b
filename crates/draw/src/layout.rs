//! What a picture of a triangulation shows, and where: the lists that it is drawn from, as SVG or as pixels.

use super::relief::Relief;
use super::style::{COLUMN, LEGEND_HEIGHT};
use super::trails::trails;
use super::window::{Bounds, PIXEL, Window, places};
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Triangulation};
use sweep_cdt_formats::{Cell, Column, sorted_pairs};

/// Up to this many vertices get numbers.
const MOST_NUMBERS: usize = 60;
/// Vertices are drawn if they are about this many pixels apart, or more; and sides on a relief.
const LEAST_SPACING: f64 = 8.0;
/// The longer side of the points' bounding box.
const LONG_SIDE: i64 = 1000 * PIXEL;
/// The longest entries of the legend, without and with a domain: no picture is narrower.
const ENTRIES: [i64; 2] = [4, 5];
const MARGIN: i64 = 28 * PIXEL;

/// A picture before it is drawn. All lines are vertices in turn.
#[derive(Debug)]
pub(super) struct Layout {
    /// Where the points are: the drawing stands in the middle, with a margin around it and the legend below.
    pub(super) places: Vec<[i64; 2]>,
    /// The size of all but the legend.
    pub(super) size: [i64; 2],
    /// About how many pixels vertices are apart.
    pub(super) spacing: f64,
    /// The hull around a domain.
    pub(super) outside: Option<Vec<usize>>,
    /// What is inside: closed lines around it.
    pub(super) border: Vec<Vec<usize>>,
    pub(super) relief: Option<Relief>,
    pub(super) sides: Vec<Vec<usize>>,
    pub(super) edges: Vec<Vec<usize>>,
    pub(super) dots: Vec<usize>,
    /// The vertices that get numbers.
    pub(super) numbered: Vec<usize>,
    /// The classes of lines in the legend, with their texts.
    pub(super) entries: Vec<(&'static str, String)>,
}

impl Layout {
    pub(super) fn new<S: Scalar>(
        graph: &Pslg<S>,
        result: &Triangulation,
        interior: Option<&Interior<'_>>,
        heights: Option<&Column>,
    ) -> Layout {
        let points = places(&graph.points);
        let relief = heights.and_then(|heights| match interior {
            Some(interior) => Relief::new(&points, heights, interior),
            None => Relief::new(&points, heights, &Interior::whole(result)),
        });

        let entries = ENTRIES[usize::from(interior.is_some())];
        let (places, size, spacing) = in_frame(&points, points.len(), entries);

        let hull: Vec<usize> = result.hull().collect();
        let border = match interior {
            Some(interior) => interior.boundary(),
            None => vec![hull.clone()],
        };
        let (triangles, name) = match interior {
            Some(interior) => (interior.inside().len(), "border"),
            None => (result.len(), "hull"),
        };
        let is_wide = spacing > LEAST_SPACING;
        let has_sides = relief.is_none() || is_wide;
        let mut entries = vec![
            (
                if has_sides { "side" } else { "relief" },
                format!("triangles: {triangles}"),
            ),
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
        let dots: Vec<usize> = if is_wide {
            vertices().collect()
        } else {
            Vec::new()
        };
        if is_wide {
            entries.push(("vertex", format!("vertices: {}", places.len())));
        }
        let has_numbers = places.len() <= MOST_NUMBERS;
        let numbered = vertices().filter(|_| has_numbers).collect();
        let sides = match has_sides {
            true => trails(places.len(), &inner_sides(result, interior)),
            false => Vec::new(),
        };
        Layout {
            size,
            spacing,
            outside: interior.map(|_| closed(&hull)),
            border: border.iter().map(|chain| closed(chain)).collect(),
            relief,
            sides,
            edges: trails(places.len(), &input_edges(graph, result)),
            dots,
            numbered,
            entries,
            places,
        }
    }

    /// The cells of points: sides of one cell are the border, and those of two lie between them.
    pub(super) fn of_cells<S: Scalar>(points: &[[S; 2]], cells: &[Cell<S>]) -> Layout {
        let near = |place: &[S; 2]| place.each_ref().map(S::approx);
        let rings = cells.iter().flat_map(|cell| cell.polygons.iter().flatten());
        let rings: Vec<Vec<[f64; 2]>> = rings.map(|ring| ring.iter().map(near).collect()).collect();
        let order = |p: &[f64; 2], q: &[f64; 2]| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1]));
        let mut corners: Vec<[f64; 2]> = rings.iter().flatten().copied().collect();
        corners.sort_by(order);
        corners.dedup_by(|p, q| order(p, q).is_eq());
        let number = |corner: &[f64; 2]| {
            let place = corners.binary_search_by(|other| order(other, corner));
            points.len() + place.expect("a corner of a cell")
        };
        let directed = rings.iter().flat_map(|ring| {
            let ring: Vec<usize> = ring.iter().map(number).collect();
            (0..ring.len()).map(move |i| [ring[i], ring[(i + 1) % ring.len()]])
        });
        let mut directed: Vec<[usize; 2]> = directed.collect();
        directed.sort_unstable();
        let is_between = |&[a, b]: &[usize; 2]| directed.binary_search(&[b, a]).is_ok();
        let (between, border): (Vec<_>, Vec<_>) =
            directed.iter().partition(|side| is_between(side));
        let all: Vec<[f64; 2]> = points
            .iter()
            .map(near)
            .chain(corners.iter().copied())
            .collect();
        let (places, size, spacing) = in_frame(&places(&all), points.len(), ENTRIES[0]);
        let mut entries = vec![
            ("side", format!("cells: {}", cells.len())),
            ("hull", format!("border: {}", border.len())),
        ];
        let dots: Vec<usize> = match spacing > LEAST_SPACING {
            true => cells.iter().map(|cell| cell.point).collect(),
            false => Vec::new(),
        };
        if !dots.is_empty() {
            entries.push(("vertex", format!("points: {}", points.len())));
        }
        let has_numbers = points.len() <= MOST_NUMBERS;
        let mut sides = sorted_pairs(between.into_iter());
        sides.dedup();
        Layout {
            size,
            spacing,
            outside: None,
            border: trails(places.len(), &border),
            relief: None,
            sides: trails(places.len(), &sides),
            edges: Vec::new(),
            numbered: cells
                .iter()
                .map(|cell| cell.point)
                .filter(|_| has_numbers)
                .collect(),
            dots,
            entries,
            places,
        }
    }

    /// The size with the legend, which has a row more for a relief.
    pub(super) fn whole_size(&self) -> [i64; 2] {
        let rows = 1 + i64::from(self.relief.is_some());
        [self.size[0], self.size[1] + rows * LEGEND_HEIGHT]
    }
}

/// The places of points in a picture, the size of all but its legend of so many entries, and about how many pixels points
/// are apart, of which there are `count` among them.
fn in_frame(points: &[[f64; 2]], count: usize, entries: i64) -> (Vec<[i64; 2]>, [i64; 2], f64) {
    let bounds = Bounds::of(points.iter().copied());
    let window = Window::new(bounds, LONG_SIDE);
    let [width, height] = [window.size[0].max(entries * COLUMN), window.size[1]];
    let size = [width, height].map(|side| side + 2 * MARGIN);
    let left = (size[0] - window.size[0]) / 2;
    let place = |&point: &[f64; 2]| {
        let [x, y] = window.place(point);
        [left + x, MARGIN + y]
    };
    let spacing = bounds.spacing(count) * (LONG_SIDE / PIXEL) as f64;
    (points.iter().map(place).collect(), size, spacing)
}

/// A chain back to its first vertex.
fn closed(chain: &[usize]) -> Vec<usize> {
    chain.iter().chain(chain.first()).copied().collect()
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
