//! The whole answer by its definition.

use super::answer::Answer;
use super::graph::Graph;
use super::numbers::{Number, Point};
use crate::with_integers;

/// The answer, or all pairs of edges that cross (at least one).
pub type Verdict = Result<Answer, Vec<[usize; 2]>>;

/// What must come out for these points and edges.
pub fn verdict(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Verdict {
    with_integers!(points, |exact| exact_verdict(&exact, edges))
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
    with_integers!(points, |exact| {
        !Graph::new(&exact, &edges).crossings().is_empty()
    })
}
