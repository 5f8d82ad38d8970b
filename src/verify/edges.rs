//! Every input edge is a chain of sides.
//!
//! Most edges are a side; where vertices lie on an edge, the walk goes from one to the next among the
//! neighbours of the vertex that it has reached, always closer to the other end.

use std::cmp::Ordering;

use super::findings::Findings;
use super::input::Mesh;
use super::report::Violation;
use super::sides::{Sides, range};
use super::signs::Tally;
use crate::scalar::Scalar;

/// Checks the edges, given by number and the ranks of their ends, and marks their sides as fixed;
/// returns how many sides that are.
pub(super) fn check<S: Scalar>(
    mesh: &Mesh<'_, S>,
    sides: &mut Sides,
    edges: &[(usize, [u32; 2])],
    tally: &mut Tally,
    findings: &mut Findings,
) -> usize {
    let mut fixed = 0;
    let mut fix = |sides: &mut Sides, a, b| {
        let is_new = sides.fix(a, b);
        fixed += usize::from(is_new == Some(true));
        is_new.is_some()
    };
    let mut split = Vec::new();
    for &(edge, [a, b]) in edges {
        if !fix(sides, a, b) {
            split.push((edge, [a, b]));
        }
    }
    if split.is_empty() {
        return fixed;
    }
    let (starts, neighbors) = sides.neighbors();
    for (edge, [a, b]) in split {
        let forward = mesh.signs.order(a, b);
        let mut at = a;
        while !fix(sides, at, b) {
            let next = neighbors[range(&starts, at)].iter().copied().find(|&v| {
                mesh.signs.order(at, v) == forward
                    && mesh.signs.order(v, b) == forward
                    && mesh.signs.orient2d([a, b, v], tally) == Ordering::Equal
            });
            let Some(next) = next else {
                findings.add(Violation::MissingEdge {
                    edge,
                    after: mesh.signs.name(at),
                });
                break;
            };
            fix(sides, at, next);
            at = next;
        }
    }
    fixed
}
