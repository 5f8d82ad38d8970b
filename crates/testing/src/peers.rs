//! Other crates behind one signature.
//!
//! Peers may panic, recurse without end or never return: callers must be prepared for that.

use std::collections::HashMap;

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

use crate::judge::Reply;

/// A crate's function.
pub type Program = fn(&[[f64; 2]], &[[usize; 2]]) -> Reply;

/// All of them, and whether they take edges. (`cdt` does, but answers another question then: it returns
/// the triangles inside closed chains of edges.)
pub const PROGRAMS: [(&str, Program, bool); 3] = [
    ("spade", spade, true),
    ("cdt", cdt, false),
    ("delaunator", delaunator, false),
];

/// `spade`, which bulk-loads the points and then adds the edges.
pub fn spade(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Reply {
    let vertices = points.iter().map(|&[x, y]| Point2::new(x, y)).collect();
    let result =
        ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(vertices, edges.to_vec())
            .map_err(|error| error.to_string())?;
    // A zero may have lost its sign.
    let key = |[x, y]: [f64; 2]| [x + 0.0, y + 0.0].map(f64::to_bits);
    let places: HashMap<[u64; 2], usize> =
        points.iter().zip(0..).map(|(&p, v)| (key(p), v)).collect();
    let corner = |p: Point2<f64>| places[&key([p.x, p.y])];
    let faces = result.inner_faces();
    Ok(faces
        .map(|face| face.vertices().map(|v| corner(v.position())))
        .collect())
}

/// `cdt`, without edges.
pub fn cdt(points: &[[f64; 2]], _edges: &[[usize; 2]]) -> Reply {
    let points: Vec<(f64, f64)> = points.iter().map(|&[x, y]| (x, y)).collect();
    let triangles = cdt::triangulate_points(&points).map_err(|error| error.to_string())?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect())
}

/// `delaunator`, which returns clockwise triangles.
pub fn delaunator(points: &[[f64; 2]], _edges: &[[usize; 2]]) -> Reply {
    let points: Vec<delaunator::Point> = points
        .iter()
        .map(|&[x, y]| delaunator::Point { x, y })
        .collect();
    let corners = delaunator::triangulate(&points).triangles;
    Ok(corners.as_chunks().0.to_vec())
}
