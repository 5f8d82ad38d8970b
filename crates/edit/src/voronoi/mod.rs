//! The Voronoi diagram: the dual of a Delaunay triangulation.
//!
//! A Voronoi vertex is the centre of a circle that is empty and goes through three points or more: triangles with one
//! circle share one. A ridge separates the cells of two points that a side joins, and stands on the middle of the side.
//!
//! ```text
//!            | ridge         Side a b has its triangle t on the left. The ridge runs from the centre of t to that of the
//!       a----+----b          triangle across, with b on its left and a on its right; on the hull it has no other end, and
//!        \   | t /           leaves at a right angle to the side.
//! ```
//!
//! **Why it is right.** The triangulation holds a side of the Delaunay triangulation wherever two cells share a ridge, and
//! others only between triangles with one circle, whose ridge has no length (Shamos and Hoey 1975). Edges that keep a
//! triangulation from being Delaunay are refused. Each centre is a quotient of polynomials in fractions, rounded once.
//!
//! **Cost.** Some microseconds a triangle, nearly all for the fractions.

mod cells;

use std::fmt;

use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::in_circle;
use sweep_cdt::{Triangulation, VertexStars};

use crate::measure::{center, exactly};

/// The Voronoi diagram of the points of a triangulation.
///
/// ```
/// use sweep_cdt_edit::Voronoi;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [8.0, 2.0]];
/// let result = sweep_cdt::triangulate(&points, &[])?;
/// let voronoi = Voronoi::new(&result, &points)?;
/// // The two triangles of the square share a circle.
/// assert_eq!(voronoi.vertices, [[2.0, 2.0], [5.5, 2.0]]);
/// assert_eq!(voronoi.cells[1], [1, 0]);
/// // Bounded by a box, the cell of the point on the right.
/// let square = [[0.0, -4.0], [10.0, -4.0], [10.0, 6.0], [0.0, 6.0]];
/// let cell = voronoi.cell_within(4, &square)?;
/// assert_eq!(cell, [[8.5, -4.0], [10.0, -4.0], [10.0, 6.0], [7.5, 6.0], [5.5, 2.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Voronoi<'a, S> {
    points: &'a [[S; 2]],
    /// The places of the Voronoi vertices, for fractions exactly, else each coordinate rounded once.
    pub vertices: Vec<[S; 2]>,
    /// The lines that separate the cells of two points.
    pub ridges: Vec<Ridge>,
    /// For each point the Voronoi vertices around its cell, counter-clockwise; of an unbounded cell from the end of the
    /// ridge that comes in to that of the one that goes out. Equal points have one cell. Empty, if there is no triangle.
    pub cells: Vec<Vec<usize>>,
    /// For each point the points whose cells share a ridge with its cell.
    neighbors: Vec<Vec<usize>>,
}

/// A line that separates two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Ridge {
    /// The points of the cells on its left and on its right, on the way from its first end to its second.
    pub points: [usize; 2],
    /// The ends of the ridge, as Voronoi vertices. A ridge without a second end goes on for ever in its
    /// [direction](Voronoi::direction). Where all points lie on one line, ridges have no ends, and go on both ways.
    pub ends: [Option<usize>; 2],
}

/// Why there is no Voronoi diagram, no cell, or no natural neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum VoronoiError {
    /// An edge keeps this side from being Delaunay.
    NotDelaunay {
        /// The side's vertices, lower number first.
        side: [usize; 2],
    },
    /// Natural neighbours are those of points alone, and there is an edge.
    Edge {
        /// The lowest number of an edge.
        edge: usize,
    },
    /// The points are not those of the triangulation.
    OtherInput,
    /// There is no such point.
    NoPoint {
        /// The number.
        point: usize,
    },
    /// A coordinate of a polygon's corner is NaN or infinite.
    NonFiniteCorner {
        /// The position of the corner.
        corner: usize,
    },
}

impl fmt::Display for VoronoiError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VoronoiError::NotDelaunay { side: [a, b] } => {
                write!(
                    f,
                    "an edge keeps side {a}-{b} from being Delaunay: triangulate the points without edges"
                )
            }
            VoronoiError::Edge { edge } => {
                write!(
                    f,
                    "there is edge {edge}: natural neighbours are those of points without edges"
                )
            }
            VoronoiError::OtherInput => f.write_str("the triangulation is not one of these points"),
            VoronoiError::NoPoint { point } => write!(f, "there is no point {point}"),
            VoronoiError::NonFiniteCorner { corner } => {
                write!(f, "a coordinate of corner {corner} is not finite")
            }
        }
    }
}

impl std::error::Error for VoronoiError {}

impl<'a, S: Exact> Voronoi<'a, S> {
    /// The Voronoi diagram of the points of a triangulation. Sides that edges cover must be Delaunay, as all others are.
    ///
    /// # Errors
    /// [`VoronoiError`].
    pub fn new(
        result: &Triangulation,
        points: &'a [[S; 2]],
    ) -> Result<Voronoi<'a, S>, VoronoiError> {
        let is_finite = |point: &[S; 2]| point.iter().all(S::is_finite);
        let count = result.sweep_order().len() + result.duplicates().len();
        if count != points.len() || !points.iter().all(is_finite) {
            return Err(VoronoiError::OtherInput);
        }
        let circles = circles(result, points)?;
        let mut first = vec![usize::MAX; result.len()];
        let (mut vertices, mut ridges) = (Vec::new(), Vec::new());
        for t in 0..result.len() {
            let circle = circles[t];
            if circle == t {
                first[t] = vertices.len();
                let center = center(result.triangle(t).map(|v| &points[v]));
                let center = center.ok_or(VoronoiError::OtherInput)?;
                vertices.push(center.each_ref().map(S::nearest));
            }
        }
        let vertex = |t: usize| first[circles[t]];
        for t in 0..result.len() {
            for k in 0..3 {
                let across = result.neighbor(t, k);
                let [a, b] = result.side(t, k);
                if across.is_none_or(|across| t < across && circles[t] != circles[across]) {
                    let ends = [Some(vertex(t)), across.map(vertex)];
                    ridges.push(Ridge {
                        points: [b, a],
                        ends,
                    });
                }
            }
        }
        let stars = result.vertex_stars();
        let cells = (0..points.len()).map(|v| cell(&stars, v, vertex)).collect();
        if result.is_empty() {
            ridges = along_a_line(result, points);
        }
        let mut neighbors = vec![Vec::new(); points.len()];
        for &Ridge { points: [a, b], .. } in &ridges {
            neighbors[a].push(b);
            neighbors[b].push(a);
        }
        for [duplicate, of] in result.duplicates() {
            neighbors[duplicate] = neighbors[of].clone();
        }
        Ok(Voronoi {
            points,
            vertices,
            ridges,
            cells,
            neighbors,
        })
    }

    /// The direction from the first end of a ridge to its second: to the right of the way from its second point to its
    /// first, and as long. Of doubles each coordinate is rounded once.
    ///
    /// ```
    /// use sweep_cdt_edit::Voronoi;
    ///
    /// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 3.0]];
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let voronoi = Voronoi::new(&result, &points)?;
    /// let below = voronoi.ridges.iter().find(|ridge| ridge.points == [1, 0]).expect("a ridge");
    /// assert_eq!((below.ends[1], voronoi.direction(below)), (None, [0.0, -4.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Panics
    /// If the ridge is not one of this diagram, and has a point with a greater number than there are.
    pub fn direction(&self, ridge: &Ridge) -> [S; 2] {
        let [[bx, by], [ax, ay]] = ridge.points.map(|v| exactly(&self.points[v]));
        [S::nearest(&(by - ay)), S::nearest(&(ax - bx))]
    }
}

/// For each triangle the lowest number of one that has the same circle and hangs together with it.
fn circles<S: Exact>(
    result: &Triangulation,
    points: &[[S; 2]],
) -> Result<Vec<usize>, VoronoiError> {
    let mut circles = vec![usize::MAX; result.len()];
    for first in 0..result.len() {
        let mut waiting = vec![first];
        while let Some(t) = waiting.pop() {
            if circles[t] != usize::MAX {
                continue;
            }
            circles[t] = first;
            let [a, b, c] = result.triangle(t).map(|v| &points[v]);
            for k in 0..3 {
                let Some((across, twin)) = result.twin(t, k) else {
                    continue;
                };
                let apex = result.triangle(across)[twin];
                let sign = in_circle(a, b, c, &points[apex]);
                if sign.is_gt() {
                    let [a, b] = result.side(t, k);
                    return Err(VoronoiError::NotDelaunay {
                        side: [a.min(b), a.max(b)],
                    });
                }
                waiting.extend(sign.is_eq().then_some(across));
            }
        }
    }
    Ok(circles)
}

/// The ridges of points on one line: between those that follow each other.
fn along_a_line<S: Exact>(result: &Triangulation, points: &[[S; 2]]) -> Vec<Ridge> {
    let mut order: Vec<usize> = result.sweep_order().iter().map(|&v| v as usize).collect();
    order.sort_unstable_by(|&v, &w| {
        let ([x, y], [z, w]) = (&points[v], &points[w]);
        x.compare(z).then_with(|| y.compare(w))
    });
    let pairs = order.windows(2);
    let ridge = |pair: &[usize]| Ridge {
        points: [pair[1], pair[0]],
        ends: [None; 2],
    };
    pairs.map(ridge).collect()
}

/// The Voronoi vertices around a point, each once.
fn cell(stars: &VertexStars<'_>, v: usize, vertex: impl Fn(usize) -> usize) -> Vec<usize> {
    let mut around: Vec<usize> = stars.star(v).map(|(t, _)| vertex(t)).collect();
    around.dedup();
    if around.len() > 1 && around.first() == around.last() {
        around.pop();
    }
    around
}
