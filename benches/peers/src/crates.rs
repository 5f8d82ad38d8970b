//! Crates behind one signature, and the time and memory of their calls that triangulate.
//!
//! The triangles of those that take points alone, of `spade` and of this crate, unless it is asked for the inside, cover
//! the hull, those of the others the polygon that the points bound in their order: one ring, or the outer one and then holes, each closed by an edge to its first point.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fmt::Debug;
use std::fs;
use std::ops::Range;
use std::time::{Duration, Instant};

use earcut::Earcut;
use geo::triangulate_delaunay::{DelaunayTriangulationConfig, TriangulateDelaunay};
use geo::{Coord, LineString, Polygon};
use ghx_constrained_delaunay::constrained_triangulation::ConstrainedTriangulationConfiguration;
use ghx_constrained_delaunay::constrained_triangulation_from_2d_vertices;
use ghx_constrained_delaunay::triangulation::TriangulationConfiguration;
use ghx_constrained_delaunay::types::{Edge, Vertex};
use i_triangle::i_overlay::i_float::adapter::FloatPointAdapter;
use i_triangle::i_overlay::i_float::int::point::IntPoint;
use i_triangle::int::unchecked::IntUncheckedTriangulatable;
use poly2tri_rs::{Point, SweeperBuilder};
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation as _};
use sweep_cdt::interior::FillRule;
use sweep_cdt::{Session, Triangulator};
use sweep_cdt_testing::Input;

/// Triangles, or why there are none.
pub(crate) type Answer = Result<Vec<[usize; 3]>, String>;

/// The library.
pub(crate) fn ours(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let result = stopwatch.time(|| sweep_cdt::triangulate(&input.points, &input.edges));
    let result = result.map_err(|error| error.to_string())?;
    Ok(result.triangles().collect())
}

/// The library, in memory that is kept from one input to the next.
pub(crate) fn ours_kept(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    SESSION.with_borrow_mut(|session| {
        let result = stopwatch.time(|| session.triangulate(&input.points, &input.edges));
        let result = result.map_err(|error| error.to_string())?;
        Ok(result.triangles().collect())
    })
}

/// The library, asked for the inside of a polygon alone, in memory that is kept from one input to the next.
pub(crate) fn ours_inside(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    SESSION.with_borrow_mut(|session| {
        let result = stopwatch
            .time(|| session.triangulate_inside(&input.points, &input.edges, FillRule::EvenOdd));
        let triangles = result.map_err(|error| error.to_string())?;
        Ok(triangles.to_vec())
    })
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::new(Triangulator::new().session());
    static EARCUT: RefCell<Earcut<f64>> = RefCell::new(Earcut::new());
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

/// `i_triangle` on the finest grid that it makes for doubles.
pub(crate) fn i_triangle_grid(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let grid = FloatPointAdapter::<[f64; 2], i64>::with_iter_conservative(input.points.iter());
    let points: Vec<IntPoint<i64>> = input.points.iter().map(|p| grid.float_to_int(p)).collect();
    let shape: Vec<Vec<IntPoint<i64>>> = rings(input)
        .into_iter()
        .map(|ring| points[ring].to_vec())
        .collect();
    let result = stopwatch.time(|| {
        let delaunay = shape.uncheck_triangulate().into_delaunay();
        delaunay.into_triangulation::<u32>()
    });
    let place = |p: &IntPoint<i64>| {
        points
            .iter()
            .position(|q| q == p)
            .expect("a point of the input")
    };
    let corners = result.indices.as_chunks::<3>().0.iter();
    Ok(corners
        .map(|t| t.map(|v| place(&result.points[v as usize])))
        .collect())
}

/// `geo`, which has `spade` triangulate, without its snapping.
pub(crate) fn geo(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let line = |ring: Range<usize>| LineString::from(input.points[ring].to_vec());
    let mut lines: Vec<LineString> = rings(input).into_iter().map(line).collect();
    let outer = lines.remove(0);
    let polygon = Polygon::new(outer, lines);
    let settings = DelaunayTriangulationConfig { snap_radius: 0.0 };
    let result = stopwatch.time(|| polygon.constrained_triangulation(settings));
    let places = Places::new(input);
    let corner = |Coord { x, y }| places.find([x, y]);
    let triangles = result.map_err(|error| format!("{error:?}"))?;
    Ok(triangles.iter().map(|t| t.to_array().map(corner)).collect())
}

/// `earcutr`, an older port.
pub(crate) fn earcutr(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let numbers = input.points.as_flattened();
    let holes = holes(input);
    let corners = stopwatch.time(|| earcutr::earcut(numbers, &holes, 2));
    let corners = corners.map_err(|error| format!("{error:?}"))?;
    Ok(corners.as_chunks().0.to_vec())
}

/// `earcut`, whose triangles are not Delaunay.
pub(crate) fn earcut(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let holes = holes(input);
    let corners = stopwatch.time(|| ears(input, &holes));
    Ok(triples(&corners))
}

/// `earcut`, and its flips to Delaunay triangles.
pub(crate) fn earcut_refined(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let holes = holes(input);
    let corners = stopwatch.time(|| {
        let mut corners = ears(input, &holes);
        earcut::refine(&mut corners, &input.points);
        corners
    });
    Ok(triples(&corners))
}

fn ears(input: &Input, holes: &[u32]) -> Vec<u32> {
    let mut corners = Vec::new();
    EARCUT.with_borrow_mut(|earcut| earcut.earcut_slice(&input.points, holes, &mut corners));
    corners
}

/// The rings of a polygon: each ends where an edge leads back.
fn rings(input: &Input) -> Vec<Range<usize>> {
    let mut start = 0;
    let ends = input.edges.iter().filter(|[a, b]| b < a);
    ends.map(|&[last, _]| std::mem::replace(&mut start, last + 1)..last + 1)
        .collect()
}

/// Where holes begin.
fn holes<N: TryFrom<usize, Error: Debug>>(input: &Input) -> Vec<N> {
    let holes = rings(input).into_iter().skip(1);
    holes
        .map(|ring| N::try_from(ring.start).expect("few points"))
        .collect()
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

/// Takes the time of each call and the memory of the first one.
#[derive(Default)]
pub(crate) struct Stopwatch {
    /// How long the last call took.
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
        self.time = start.elapsed();
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
