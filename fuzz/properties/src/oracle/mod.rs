//! What the result must be: the canonical constrained Delaunay triangulation by its definition.
//!
//! Nothing here is shared with the crate: the numbers are integers (`numbers`), and each part of the
//! answer is found by trying everything (`graph`: vertices, pieces of edges, crossings; `definition`:
//! triangles, hull). That is slow and short, and meant for a dozen points. For large results `check`
//! tests what makes a triangulation the canonical one, side by side. `naive` takes triangulations of any
//! program, canonical or not.

mod check;
mod definition;
mod graph;
mod naive;
mod numbers;

use std::collections::BTreeMap;

use sweep_cdt::Triangulation;

pub use check::{check, check_answer, check_found, check_links, firm_sides};
pub use graph::Graph;
pub use naive::{is_exactly_right, is_right};
pub use numbers::{Integers, Number, Point, integers};

/// A result in a form that does not depend on how it was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Each with its lowest vertex first; sorted.
    pub triangles: Vec<[usize; 3]>,
    /// The constrained sides, lower vertex first; sorted.
    pub constrained: Vec<[usize; 2]>,
    /// The vertices on the hull, counter-clockwise from the leftmost, upper one.
    pub hull: Vec<usize>,
    /// For each point the lowest index of an equal one.
    pub representatives: Vec<usize>,
    /// For each edge the vertices along it.
    pub chains: Vec<Vec<usize>>,
}

/// The answer, or all pairs of edges that cross (at least one).
pub type Verdict = Result<Answer, Vec<[usize; 2]>>;

/// What must come out for these points and edges.
pub fn verdict(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Verdict {
    match integers(points) {
        Integers::Small(points) => exact_verdict(&points, edges),
        Integers::Medium(points) => exact_verdict(&points, edges),
        Integers::Big(points) => exact_verdict(&points, edges),
    }
}

/// The same for points that are given as integers.
pub fn exact_verdict<N: Number>(points: &[Point<N>], edges: &[[usize; 2]]) -> Verdict {
    let graph = Graph::new(points, edges);
    let crossings = graph.crossings();
    if !crossings.is_empty() {
        return Err(crossings);
    }
    let triangles = graph.triangles();
    let flat = triangles.is_empty();
    Ok(Answer {
        constrained: if flat {
            Vec::new()
        } else {
            graph.pieces.clone()
        },
        hull: if flat { Vec::new() } else { graph.hull() },
        triangles,
        representatives: graph.representatives.clone(),
        chains: graph.chains.clone(),
    })
}

/// Whether two edges of an input cross at a point that is no vertex.
pub fn crosses(points: &[[f64; 2]], edges: &[[usize; 2]], pair: [usize; 2]) -> bool {
    let edges = pair.map(|e| edges[e]);
    match integers(points) {
        Integers::Small(points) => !Graph::new(&points, &edges).crossings().is_empty(),
        Integers::Medium(points) => !Graph::new(&points, &edges).crossings().is_empty(),
        Integers::Big(points) => !Graph::new(&points, &edges).crossings().is_empty(),
    }
}

/// What the crate found for `points` points and `edges` edges, its links checked on the way.
pub fn found(result: &Triangulation, points: usize, edges: usize) -> Answer {
    check_links(result);
    let mut constrained: Vec<_> = result.constrained_edges().map(sorted).collect();
    constrained.sort_unstable();
    let representatives: Vec<usize> = (0..points).map(|v| result.representative(v)).collect();
    let duplicates: BTreeMap<_, _> = result.duplicates().map(|[v, of]| (v, of)).collect();
    for (v, &of) in representatives.iter().enumerate() {
        assert_eq!(
            of != v,
            duplicates.contains_key(&v),
            "point {v} is listed as a duplicate or not"
        );
        assert_eq!(
            of,
            *duplicates.get(&v).unwrap_or(&v),
            "representative of point {v}"
        );
    }
    Answer {
        triangles: result.canonical_triangles(),
        constrained,
        hull: result.hull().collect(),
        representatives,
        chains: (0..edges).map(|e| result.edge_chain(e).collect()).collect(),
    }
}

/// The triangles as [`Triangulation::canonical_triangles`] lists those of a result.
pub fn canonical(result: &Triangulation, triangles: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut list: Vec<[usize; 3]> = triangles
        .iter()
        .map(|corners| lowest_first(corners.map(|v| result.representative(v))))
        .collect();
    list.sort_unstable();
    list
}

fn lowest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
    match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    }
}

/// The lower of two first.
pub fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}
