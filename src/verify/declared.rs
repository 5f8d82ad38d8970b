//! Check 4 for a domain that the caller declared by its boundary, in place of the convex hull. The chains may run any
//! way: they declare what a path from outside enters by an odd number of their sides. Why it is enough to turn them as
//! the triangles run: their boundary goes round a place as often as they cover it (see the parent module), an odd
//! number where that of crossed sides is odd, whatever way each runs. A boundary that is the declared one (here), and
//! goes round each place once or not at all (`scanline`), leaves one triangle where it is odd, else none.
//!
//! Added points may split a declared side. So boundary sides that go straight on through added points are merged first.
//! Cost: O(m log m) for m sides.

use super::report::Record;
use super::soup::{Soup, Tally};
use super::violation::Violation;
use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;

/// The sides of the declared chains, by rank, in the caller's order.
#[derive(Debug)]
pub(super) struct DeclaredBoundary {
    pub(super) sides: Vec<[u32; 2]>,
}

impl DeclaredBoundary {
    /// Turns each declared side whose reverse is on the boundary of the triangles, so that it runs as they do.
    pub(super) fn orient<S: Scalar>(&mut self, soup: &Soup<'_, S>, boundary: &[u32]) {
        let found = merged(soup, boundary);
        let is_found = |side: [u32; 2]| found.binary_search_by_key(&side, |found| found.0).is_ok();
        for side in &mut self.sides {
            let [a, b] = *side;
            if !is_found([a, b]) && is_found([b, a]) {
                *side = [b, a];
            }
        }
    }

    /// Checks that the boundary of the triangles is exactly the declared one.
    pub(super) fn check_boundary<S: Scalar>(
        &self,
        soup: &Soup<'_, S>,
        boundary: &[u32],
        record: &mut Record,
    ) {
        let found = merged(soup, boundary);
        let mut declared = self.sides.clone();
        declared.sort_unstable();
        for &(ends, side) in &found {
            if declared.binary_search(&ends).is_err() {
                record.findings.add(Violation::UndeclaredBoundary {
                    side: soup.names(soup.side(side)),
                    triangle: side as usize / 3,
                });
            }
        }
        for (i, &side) in declared.iter().enumerate() {
            // A side is on the boundary once at most.
            let again = i > 0 && declared[i - 1] == side;
            if again || found.binary_search_by_key(&side, |found| found.0).is_err() {
                let side = soup.names(side);
                record.findings.add(Violation::MissingBoundary { side });
            }
        }
    }
}

/// The ends of each side of the boundary, sorted, with its number. Sides that go straight on through added points, from
/// one point of the input to another, count as one, with the number of the first.
fn merged<S: Scalar>(soup: &Soup<'_, S>, boundary: &[u32]) -> Vec<([u32; 2], u32)> {
    let mut found: Vec<([u32; 2], u32)> = boundary
        .iter()
        .map(|&side| (soup.side(side), side))
        .collect();
    found.sort_unstable();
    if !boundary
        .iter()
        .any(|&side| soup.predicates.is_added(soup.side(side)[0]))
    {
        return found;
    }
    // The side that goes straight on. One or two declared sides pass through an added point, on one line. Where more
    // leave it, only two are looked at: nobody has declared these.
    let straight_on = |[a, b]: [u32; 2]| {
        let forward = |side: [u32; 2]| soup.predicates.order(side[0], side[1]);
        let first = found.partition_point(|&([start, _], _)| start < b);
        (first..found.len().min(first + 2)).find(|&at| {
            let side = found[at].0;
            let turn = || {
                soup.predicates
                    .orient2d([a, b, side[1]], &mut Tally::default())
            };
            side[0] == b && forward(side) == forward([a, b]) && turn().is_eq()
        })
    };
    // Each side is walked once.
    let mut is_walked = vec![false; found.len()];
    let mut whole = Vec::new();
    for (first, &(ends, side)) in found.iter().enumerate() {
        if soup.predicates.is_added(ends[0]) {
            continue;
        }
        let (mut path, mut last) = (vec![first], ends);
        while soup.predicates.is_added(last[1])
            && let Some(on) = straight_on(last).filter(|&on| !is_walked[on])
        {
            is_walked[on] = true;
            path.push(on);
            last = found[on].0;
        }
        is_walked[first] = true;
        if soup.predicates.is_added(last[1]) {
            whole.extend(path.into_iter().map(|at| found[at]));
        } else {
            whole.push(([ends[0], last[1]], side));
        }
    }
    let rest = found.iter().zip(is_walked);
    whole.extend(rest.filter(|(_, walked)| !walked).map(|(side, _)| *side));
    whole.sort_unstable();
    whole
}
