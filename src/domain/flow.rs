//! How often the edges run along each side, one direction against the other.
//!
//! Every edge is a chain of sides. Each counts as a *flow* along them: +1 in its direction. The flow of a side is
//! the sum over all edges. For the winding number the flow is what crossing the side changes. For crossing
//! parity it is odd where the number of edges on the side is odd, whatever their directions.
//!
//! The edges form closed chains if no flow starts or ends at a vertex: as much comes as goes. (For parity: if
//! what comes and what goes differ by an even number.) Then the sum over the sides that a closed path crosses is
//! zero (even), because that holds for a path around one vertex, and every path is a sum of these. So what a
//! rule says of a triangle does not depend on the path to it.
//!
//! Cost: O(m log m), where m is the sum of the lengths of all chains. Equal edges are walked once.

use super::error::DomainError;
use crate::Triangulation;
use crate::ids::narrow;

/// The flows of all sides.
#[derive(Debug)]
pub(super) struct Flow {
    /// Sides, lower vertex first, with what flows from there to the other; sorted, and none twice.
    sides: Vec<([u32; 2], i32)>,
    /// `(vertex, flow)`: what goes out of a vertex, less what comes in; sorted, no vertex twice, none zero.
    sources: Vec<(u32, i32)>,
}

impl Flow {
    /// The flow of all edges, each from its upper to its lower end.
    pub(super) fn downwards(result: &Triangulation) -> Flow {
        let edges = (0..result.chains.len()).map(|edge| (edge, 1));
        Flow::of(result, edges.collect())
    }

    /// The flow of all edges, each from its first to its second point.
    pub(super) fn along(result: &Triangulation, edges: &[[usize; 2]]) -> Result<Flow, DomainError> {
        let count = result.chains.len();
        let known = edges.len().min(count);
        let mut directions = Vec::with_capacity(count);
        for (edge, ends) in edges[..known].iter().enumerate() {
            let [from, to] = ends.map(|vertex| result.representative(vertex));
            let [upper, lower] = result.chains.ends(edge).map(|vertex| vertex as usize);
            directions.push(match [from, to] {
                ends if ends == [upper, lower] => (edge, 1),
                ends if ends == [lower, upper] => (edge, -1),
                _ => return Err(DomainError::OtherEdge { edge }),
            });
        }
        if edges.len() != count {
            return Err(DomainError::OtherEdge { edge: known });
        }
        Ok(Flow::of(result, directions))
    }

    /// The flow of edges, each with +1 if it runs from its upper to its lower end, and -1 otherwise.
    fn of(result: &Triangulation, mut directions: Vec<(usize, i32)>) -> Flow {
        let ends = |edge: usize| result.chains.ends(edge);
        directions.sort_unstable_by_key(|&(edge, _)| ends(edge));
        let (mut sides, mut sources) = (Vec::new(), Vec::new());
        for equal in directions.chunk_by(|a, b| ends(a.0) == ends(b.0)) {
            let flow: i32 = equal.iter().map(|&(_, direction)| direction).sum();
            let [upper, lower] = ends(equal[0].0);
            if flow == 0 || upper == lower {
                continue;
            }
            sources.extend([(upper, flow), (lower, -flow)]);
            let chain = result.edge_chain(equal[0].0).map(narrow);
            for (from, to) in chain.clone().zip(chain.skip(1)) {
                sides.push(if from < to {
                    ([from, to], flow)
                } else {
                    ([to, from], -flow)
                });
            }
        }
        Flow {
            sides: summed(sides),
            sources: summed(sources),
        }
    }

    /// The flow of a side, from vertex to vertex.
    pub(super) fn of_side(&self, [from, to]: [usize; 2]) -> i32 {
        let [a, b] = [narrow(from), narrow(to)];
        let side = [a.min(b), a.max(b)];
        let found = self.sides.binary_search_by_key(&side, |&(side, _)| side);
        let flow = found.map_or(0, |at| self.sides[at].1);
        if a < b { flow } else { -flow }
    }

    /// An error if anything starts or ends at a vertex, of what `counts`.
    pub(super) fn expect_closed(&self, counts: impl Fn(i32) -> bool) -> Result<(), DomainError> {
        match self.sources.iter().find(|&&(_, flow)| counts(flow)) {
            Some(&(vertex, _)) => Err(DomainError::OpenAtVertex {
                vertex: vertex as usize,
            }),
            None => Ok(()),
        }
    }
}

/// The sum for each key, where it is not zero.
fn summed<K: Copy + Ord>(mut list: Vec<(K, i32)>) -> Vec<(K, i32)> {
    list.sort_unstable();
    let sums = list.chunk_by(|a, b| a.0 == b.0).map(|same| {
        let sum = same.iter().map(|&(_, flow)| flow).sum();
        (same[0].0, sum)
    });
    sums.filter(|&(_, flow)| flow != 0).collect()
}
