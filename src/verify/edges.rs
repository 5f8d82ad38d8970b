//! Check 7: every input edge is a side, or a chain of sides where vertices lie on it.
//!
//! Most edges are a side. The others are followed along the [straight chains](super::straight) of sides.

use super::record::Record;
use super::sides::Sides;
use super::soup::Soup;
use super::straight::Chains;
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

    // The edges that reach farthest in their direction come first, as the chains ask.
    let forward = |[a, b]: [u32; 2]| soup.signs.order(a, b);
    split.sort_unstable_by(|&(_, one), &(_, other)| {
        let direction = forward(one);
        let farther = soup.signs.order(other[1], one[1]);
        direction.cmp(&forward(other)).then(if direction.is_lt() {
            farther
        } else {
            farther.reverse()
        })
    });
    let mut chains = Chains::new(sides);
    let mut missing = Vec::new();
    for (edge, ends) in split {
        let reached = chains.follow(soup, ends, |a, b| {
            fix(sides, a, b);
        });
        if reached != ends[1] {
            missing.push((edge, soup.signs.name(reached)));
        }
    }
    missing.sort_unstable();
    for (edge, after) in missing {
        record.findings.add(Violation::MissingEdge { edge, after });
    }
}
