//! Crates whose triangles cover the hull.

use std::collections::HashMap;

use ghx_constrained_delaunay::triangulation::TriangulationConfiguration;
use ghx_constrained_delaunay::types::Vertex;
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation as _};
use sweep_cdt_testing::Input;

use crate::stopwatch::Stopwatch;

type Answer = Result<Vec<[usize; 3]>, String>;

/// This crate.
pub(super) fn ours(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let result = stopwatch.time(|| sweep_cdt::triangulate(&input.points, &input.edges));
    let result = result.map_err(|error| error.to_string())?;
    Ok(result.triangles().collect())
}

/// `spade`, by bulk loading.
pub(super) fn spade(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
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
pub(super) fn delaunator(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| delaunator::Point { x, y };
    let points: Vec<_> = input.points.iter().map(point).collect();
    let result = stopwatch.time(|| delaunator::triangulate(&points));
    Ok(result.triangles.as_chunks().0.to_vec())
}

/// `cdt`, without edges.
pub(super) fn cdt(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let points: Vec<(f64, f64)> = input.points.iter().map(|&[x, y]| (x, y)).collect();
    let result = stopwatch.time(|| cdt::triangulate_points(&points));
    let triangles = result.map_err(|error| error.to_string())?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect())
}

/// `ghx_constrained_delaunay`, without edges.
pub(super) fn ghx(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| Vertex::new(x, y);
    let points: Vec<_> = input.points.iter().map(point).collect();
    let result = stopwatch.time(|| {
        let settings = TriangulationConfiguration::default();
        ghx_constrained_delaunay::triangulation_from_2d_vertices(&points, settings)
    });
    let triangles = result.map_err(|error| error.to_string())?.triangles;
    Ok(triangles.iter().map(|t| t.map(|v| v as usize)).collect())
}

/// The points by their coordinates.
pub(super) struct Places(HashMap<[u64; 2], usize>);

impl Places {
    pub(super) fn new(input: &Input) -> Places {
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
    pub(super) fn find(&self, p: [f64; 2]) -> usize {
        self.0[&key(p)]
    }
}

/// A zero may lose its sign.
fn key(p: [f64; 2]) -> [u64; 2] {
    p.map(|c| (c + 0.0).to_bits())
}
