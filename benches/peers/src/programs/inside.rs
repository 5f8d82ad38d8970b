//! Crates whose triangles cover the polygon that the points bound in their order.

use ghx_constrained_delaunay::constrained_triangulation::ConstrainedTriangulationConfiguration;
use ghx_constrained_delaunay::constrained_triangulation_from_2d_vertices;
use ghx_constrained_delaunay::types::{Edge, Vertex};
use i_triangle::i_overlay::i_float::int::point::IntPoint;
use i_triangle::int::unchecked::IntUncheckedTriangulatable;
use poly2tri_rs::{Point, SweeperBuilder};
use sweep_cdt_testing::Input;

use super::hull::Places;
use crate::stopwatch::Stopwatch;

type Answer = Result<Vec<[usize; 3]>, String>;

/// `cdt`, with edges.
pub(super) fn cdt(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let points: Vec<(f64, f64)> = input.points.iter().map(|&[x, y]| (x, y)).collect();
    let edges: Vec<(usize, usize)> = input.edges.iter().map(|&[a, b]| (a, b)).collect();
    let result = stopwatch.time(|| cdt::triangulate_with_edges(&points, &edges));
    let triangles = result.map_err(|error| error.to_string())?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect())
}

/// `ghx_constrained_delaunay`, which keeps what clockwise edges bound.
pub(super) fn ghx(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
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
pub(super) fn i_triangle(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
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
pub(super) fn earcut(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let corners = stopwatch.time(|| ears(input));
    Ok(triples(&corners))
}

/// `earcut`, and its flips to Delaunay triangles.
pub(super) fn earcut_refined(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
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
pub(super) fn poly2tri(input: &Input, stopwatch: &mut Stopwatch) -> Answer {
    let point = |&[x, y]: &[f64; 2]| Point::new(x, y);
    let points: Vec<_> = input.points.iter().map(point).collect();
    let triangles = stopwatch.time(|| SweeperBuilder::new(points).build().triangulate());
    let places = Places::new(input);
    Ok(triangles
        .map(|t| t.points.map(|p| places.find([p.x, p.y])))
        .collect())
}
