//! Remarks about a result: why there is nothing, and what polygons and heights leave open.

use std::collections::HashMap;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_formats::{Coordinate, GraphFile, NoTriangles, Remark};

/// The remarks on the triangulation of a file, and on its domain unless that is the hull.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_engine::remarks;
/// use sweep_cdt_formats::{GraphFile, NoTriangles, Remark};
///
/// let file = GraphFile::from(Pslg { points: vec![[0.0, 0.0], [1.0, 1.0]], ..Pslg::default() });
/// let result = sweep_cdt::triangulate(&file.graph.points, &[])?;
/// let why = NoTriangles::OneLine { up: None };
/// assert_eq!(remarks(&file, &result, None), [Remark::NoTriangles(why)]);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn remarks<S: Coordinate>(
    file: &GraphFile<S>,
    result: &Triangulation,
    domain: Option<&Interior<'_>>,
) -> Vec<Remark> {
    let of_polygons = domain.filter(|domain| domain.is_of_polygons());
    let list = [
        why_nothing(file, result, domain),
        of_polygons.and_then(|_| traced_twice(file)),
        of_polygons.and_then(covered_twice),
    ];
    list.into_iter().flatten().collect()
}

/// How many vertices have no height, if others have. It counts where an output has heights.
pub fn without_heights<S>(file: &GraphFile<S>) -> Option<Remark> {
    let missing = file.heights()?.missing();
    let vertices = file.graph.points.len();
    (missing > 0).then_some(Remark::WithoutHeights { missing, vertices })
}

/// How many triangles are covered by more than one polygon, if any are.
fn covered_twice(domain: &Interior<'_>) -> Option<Remark> {
    let triangles = domain.inside().filter(|&t| domain.depth(t) > 1).count();
    (triangles > 0).then_some(Remark::CoveredTwice { triangles })
}

/// How many sides a polygon has again in the same direction, if any. One in each direction is a slit, which hides nothing.
fn traced_twice<S>(file: &GraphFile<S>) -> Option<Remark> {
    let mut times: HashMap<(usize, [usize; 2]), usize> = HashMap::new();
    for (&edge, ring) in file.graph.edges.iter().zip(&file.polygons.ring_of) {
        if let &Some(ring) = ring
            && edge[0] != edge[1]
        {
            let polygon = file.polygons.rings[ring].polygon;
            *times.entry((polygon, edge)).or_default() += 1;
        }
    }
    let edges = times.values().filter(|&&times| times > 1).count();
    (edges > 0).then_some(Remark::TracedTwice { edges })
}

/// Why there are no triangles, or none inside, if there are none.
fn why_nothing<S: Coordinate>(
    file: &GraphFile<S>,
    result: &Triangulation,
    domain: Option<&Interior<'_>>,
) -> Option<Remark> {
    let graph = &file.graph;
    if !result.is_empty() {
        let is_empty = domain.is_some_and(|domain| domain.inside().len() == 0);
        return is_empty.then_some(Remark::NothingInside {
            edges: graph.edges.len(),
            has_holes: !graph.holes.is_empty(),
        });
    }
    let Some(first) = graph.points.first() else {
        return Some(Remark::NoTriangles(NoTriangles::NoPoints));
    };
    let is_same = |axis: usize| {
        let mut points = graph.points.iter();
        points.all(|point| point[axis].compare(&first[axis]).is_eq())
    };
    let same = [0, 1].map(is_same);
    if same == [true, true] {
        return Some(Remark::NoTriangles(NoTriangles::OnePlace));
    }
    let are_different = |heights: &[f64]| {
        let mut pairs = heights.windows(2);
        pairs.any(|pair| !pair[0].total_cmp(&pair[1]).is_eq())
    };
    let has_heights = file
        .heights()
        .is_some_and(|column| are_different(&column.values));
    let up = same.iter().position(|&same| same).filter(|_| has_heights);
    Some(Remark::NoTriangles(NoTriangles::OneLine { up }))
}
