//! Check 7: every input edge is a side, or a chain of sides where vertices lie on it.
//!
//! Most edges are a side. For the others the walk goes from vertex to vertex along the edge: from each one
//! to a neighbour that lies on the edge and is closer to its other end.

use std::cmp::Ordering;

use super::record::Record;
use super::sides::{Sides, range};
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// Checks the edges, given by number and the ranks of their ends, and fixes their sides.
pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &mut Sides,
    edges: &[(usize, [u32; 2])],
    record: &mut Record,
) {
    // Points on a line have no triangles, and check 4 has judged them.
    if soup.triangles.is_empty() {
        return;
    }
    let fixed = &mut record.report.constrained_sides;
    let mut fix = |sides: &mut Sides, a, b| {
        let is_new = sides.fix(a, b);
        *fixed += usize::from(is_new == Some(true));
        is_new.is_some()
    };
    let mut split = Vec::new();
    for &(edge, [a, b]) in edges {
        if !fix(sides, a, b) {
            split.push((edge, [a, b]));
        }
    }
    if split.is_empty() {
        return;
    }

    // Neighbours are grouped only now: most inputs have no such edge.
    let (starts, neighbors) = sides.neighbors();
    for (edge, [a, b]) in split {
        let forward = soup.signs.order(a, b);
        let mut at = a;
        while !fix(sides, at, b) {
            let next = neighbors[range(&starts, at)].iter().copied().find(|&v| {
                soup.signs.order(at, v) == forward
                    && soup.signs.order(v, b) == forward
                    && soup.signs.orient2d([a, b, v], &mut record.tally) == Ordering::Equal
            });
            let Some(next) = next else {
                let after = soup.signs.name(at);
                record.findings.add(Violation::MissingEdge { edge, after });
                break;
            };
            fix(sides, at, next);
            at = next;
        }
    }
}
