//! Crates behind one signature, and the time and memory of their calls that triangulate.
//!
//! The triangles of the first five cover the hull, those of the others the polygon that the points bound in
//! their order.

use std::collections::HashMap;
use std::fs;
use std::time::{Duration, Instant};

use ghx_constrained_delaunay::constrained_triangulation::ConstrainedTriangulationConfiguration;
use ghx_constrained_delaunay::constrained_triangulation_from_2d_vertices;
use ghx_constrained_delaunay::triangulation::TriangulationConfiguration;
use ghx_constrained_delaunay::types::{Edge, Vertex};
use i_triangle::i_overlay::i_float::int::point::IntPoint;
use i_triangle::int::unchecked::IntUncheckedTriangulatable;
use poly2tri_rs::{Point, SweeperBuilder};
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation as _};
use sweep_cdt_testing::Input;

/// Triangles, or why there are none.
pub(crate) type Answer = Result<Vec<[usize; 3]>, String>;

/// This crate.
pub(crate) fn ours(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let result = stopwatch.time(|| sweep_cdt::triangulate(&input.points, &input.edges));
    let result = result.map_err(|error| error.to_string())?;
    Ok(result.triangles().collect())
}

/// `spade`, by bulk loading.
pub(crate) fn spade(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let points: Vec<_> = input
        .points
        .iter()
        .map(|&[x, y]| Point2::new(x, y))
        .collect();
    if input.edges.is_empty() {
        let result = stopwatch.time(|| DelaunayTriangulation::<Point2<f64>>::bulk_load(points));
        faces(&result.map_err(|error| error.to_string())?, input)
    } else {
        let edges = input.edges.clone();
        let result = stopwatch
            .time(|| ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges));
        faces(&result.map_err(|error| error.to_string())?, input)
    }
}

fn faces(result: &impl spade::Triangulation<Vertex = Point2<f64>>, input: &Input) -> Answer {
    let places = Places::new(input);
    let corner = |p: Point2<f64>| places.find([p.x, p.y]);
    let face = |face: spade::handles::FaceHandle<'_, spade::handles::InnerTag, _, _, _, _>| {
        face.vertices().map(|v| corner(v.position()))
    };
    Ok(result.inner_faces().map(face).collect())
}

/// `delaunator`, which returns clockwise triangles.
pub(crate) fn delaunator(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| delaunator::Point { x, y };
    let points: Vec<_> = input.points.iter().map(point).collect();
    let result = stopwatch.time(|| delaunator::triangulate(&points));
    Ok(result.triangles.as_chunks().0.to_vec())
}

/// `cdt`, without edges.
pub(crate) fn cdt(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let points: Vec<(f64, f64)> = input.points.iter().map(|&[x, y]| (x, y)).collect();
    let result = stopwatch.time(|| cdt::triangulate_points(&points));
    let triangles = result.map_err(|error| error.to_string())?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect())
}

/// `ghx_constrained_delaunay`, without edges.
pub(crate) fn ghx(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| Vertex::new(x, y);
    let points: Vec<_> = input.points.iter().map(point).collect();
    let result = stopwatch.time(|| {
        let settings = TriangulationConfiguration::default();
        ghx_constrained_delaunay::triangulation_from_2d_vertices(&points, settings)
    });
    let triangles = result.map_err(|error| error.to_string())?.triangles;
    Ok(triangles.iter().map(|t| t.map(|v| v as usize)).collect())
}

/// `cdt`, with edges.
pub(crate) fn cdt_inside(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let points: Vec<(f64, f64)> = input.points.iter().map(|&[x, y]| (x, y)).collect();
    let edges: Vec<(usize, usize)> = input.edges.iter().map(|&[a, b]| (a, b)).collect();
    let result = stopwatch.time(|| cdt::triangulate_with_edges(&points, &edges));
    let triangles = result.map_err(|error| error.to_string())?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect())
}

/// `ghx_constrained_delaunay`, which keeps what clockwise edges bound.
pub(crate) fn ghx_inside(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| Vertex::new(x, y);
    let points: Vec<_> = input.points.iter().map(point).collect();
    let number = |v: usize| u32::try_from(v).expect("few points");
    let edge = |&[a, b]: &[usize; 2]| Edge::new(number(b), number(a));
    let edges: Vec<_> = input.edges.iter().rev().map(edge).collect();
    let result = stopwatch.time(|| {
        let settings = ConstrainedTriangulationConfiguration::default();
        constrained_triangulation_from_2d_vertices(&points, &edges, settings)
    });
    let triangles = result.map_err(|error| error.to_string())?.triangles;
    Ok(triangles.iter().map(|t| t.map(|v| v as usize)).collect())
}

/// `i_triangle` on integers, without its checks of the polygon.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the polygons have integer coordinates"
)]
pub(crate) fn i_triangle(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| IntPoint::new(x as i32, y as i32);
    let contour: Vec<IntPoint<i32>> = input.points.iter().map(point).collect();
    let result = stopwatch.time(|| {
        let delaunay = contour.uncheck_triangulate().into_delaunay();
        delaunay.into_triangulation::<u32>()
    });
    let places = Places::new(input);
    let corner = |p: IntPoint<i32>| places.find([f64::from(p.x), f64::from(p.y)]);
    let corners = result.indices.as_chunks::<3>().0.iter();
    Ok(corners
        .map(|t| t.map(|v| corner(result.points[v as usize])))
        .collect())
}

/// `earcut`, whose triangles are not Delaunay.
pub(crate) fn earcut(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let corners = stopwatch.time(|| ears(input));
    Ok(triples(&corners))
}

/// `earcut`, and its flips to Delaunay triangles.
pub(crate) fn earcut_refined(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let corners = stopwatch.time(|| {
        let mut corners = ears(input);
        earcut::refine(&mut corners, &input.points);
        corners
    });
    Ok(triples(&corners))
}

fn ears(input: &Input) -> Vec<u32> {
    let mut corners = Vec::new();
    earcut::Earcut::new().earcut_slice(&input.points, &[], &mut corners);
    corners
}

fn triples(corners: &[u32]) -> Vec<[usize; 3]> {
    let corners = corners.as_chunks().0.iter();
    corners.map(|t| t.map(|v| v as usize)).collect()
}

/// `poly2tri-rs`.
pub(crate) fn poly2tri(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
    let points: Vec<_> = input.points.iter().map(point).collect();
    let triangles = stopwatch.time(|| SweeperBuilder::new(points).build().triangulate());
    let places = Places::new(input);
    Ok(triangles
        .map(|t| t.points.map(|p| places.find([p.x, p.y])))
        .collect())
}

/// The points by their coordinates.
struct Places(HashMap<[u64; 2], usize>);

impl Places {
    fn new(input: &Input) -> Places {
        Places(
            (input.points.iter().zip(0..))
                .map(|(&p, v)| (key(p), v))
                .collect(),
        )
    }

    /// The point with these coordinates.
    ///
    /// # Panics
    /// If there is none.
    fn find(&self, p: [f64; 2]) -> usize {
        self.0[&key(p)]
    }
}

/// A zero may lose its sign.
fn key(p: [f64; 2]) -> [u64; 2] {
    p.map(|c| (c + 0.0).to_bits())
}

/// Adds up the time of all calls and takes the memory of the first one.
#[derive(Default)]
pub(crate) struct Stopwatch {
    /// How long all calls took.
    pub(crate) time: Duration,
    /// By how many bytes the resident set grew at its peak in the first call; none where the system does
    /// not say.
    pub(crate) memory: Option<u64>,
    has_run: bool,
}

impl Stopwatch {
    /// Times a call.
    pub(crate) fn time<T>(&mut self, call: impl FnOnce() -> T) -> T {
        if self.has_run {
            return self.timed(call);
        }
        self.has_run = true;
        // Sets the peak to what is resident now.
        let is_reset = fs::write("/proc/self/clear_refs", "5").is_ok();
        let before = peak();
        let result = self.timed(call);
        if is_reset {
            self.memory = peak().zip(before).map(|(after, before)| after - before);
        }
        result
    }

    fn timed<T>(&mut self, call: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = call();
        self.time += start.elapsed();
        result
    }
}

/// The largest resident set so far, in bytes.
fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().trim_end_matches(" kB").parse().ok()?;
    Some(1024 * kilobytes)
}
