//! Check 4 for a domain that the caller declared by its boundary, in place of the convex hull. The chains may run any
//! way: they declare what a path from outside enters by an odd number of their sides. Why it is enough to turn them as
//! the triangles run: their boundary goes round a place as often as they cover it (see the parent module), an odd
//! number where that of crossed sides is odd, whatever way each runs. A boundary that is the declared one (here), and
//! goes round each place once or not at all (`scanline`), leaves one triangle where it is odd, else none.
//!
//! Added points may split a declared side, or lie beside it if they were rounded. So boundary sides that lead from a point
//! of the input to the next one through added points are merged first, to [runs](super::runs).
//! Cost: O(m log m) for m sides.

use super::report::Record;
use super::runs::Run;
use super::sides::Sides;
use super::soup::Soup;
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
        let is_found = |side: [u32; 2]| found.binary_search_by_key(&side, Merged::ends).is_ok();
        for side in &mut self.sides {
            let [a, b] = *side;
            if !is_found([a, b]) && is_found([b, a]) {
                *side = [b, a];
            }
        }
    }

    /// Checks that the boundary of the triangles is the declared one, or runs beside it (a bent run). Returns its runs.
    pub(super) fn check_boundary<S: Scalar>(
        &self,
        soup: &Soup<'_, S>,
        sides: &Sides,
        record: &mut Record,
    ) -> Vec<Run> {
        let found = merged(soup, &sides.boundary);
        let mut declared = self.sides.clone();
        declared.sort_unstable();
        let mut runs = Vec::new();
        for whole in &found {
            let is_declared = declared.binary_search(&whole.ends()).is_ok();
            let run = Run::of(soup, sides, &whole.chain);
            if !is_declared || run.is_none() && whole.chain.len() > 2 {
                record.findings.add(Violation::UndeclaredBoundary {
                    side: soup.names(soup.side(whole.side)),
                    triangle: soup.number(whole.side as usize / 3),
                });
            } else if let Some(run) = run {
                let violation = run.violation(soup, true).into_iter();
                violation.for_each(|violation| record.findings.add(violation));
                runs.push(run);
            }
        }
        let is_missing = |&(i, side): &(usize, &[u32; 2])| {
            // A side is on the boundary once at most.
            let again = i > 0 && declared[i - 1] == *side;
            again || found.binary_search_by_key(side, Merged::ends).is_err()
        };
        let missing = declared.iter().enumerate().filter(is_missing);
        let mut missing: Vec<[usize; 2]> = missing.map(|(_, &side)| soup.names(side)).collect();
        missing.sort_unstable();
        for side in missing {
            record.findings.add(Violation::MissingBoundary { side });
        }
        runs
    }
}

/// A side of the boundary, or several through added points.
struct Merged {
    /// The number of the first side.
    side: u32,
    chain: Vec<u32>,
}

impl Merged {
    fn ends(&self) -> [u32; 2] {
        [self.chain[0], self.chain[self.chain.len() - 1]]
    }
}

/// The sides of the boundary, sorted by their ends. Those that go on through added points from one point of the input to
/// another count as one.
fn merged<S: Scalar>(soup: &Soup<'_, S>, boundary: &[u32]) -> Vec<Merged> {
    let mut found: Vec<([u32; 2], u32)> = boundary
        .iter()
        .map(|&side| (soup.side(side), side))
        .collect();
    found.sort_unstable();
    // The side that goes on, or straight on where two declared sides pass through an added point, on one line. Where more
    // leave it, only two are looked at: nobody has declared these.
    let on = |[a, b]: [u32; 2]| {
        let forward = |side: [u32; 2]| soup.order(side[0], side[1]);
        let first = found.partition_point(|&([start, _], _)| start < b);
        let leaves = |at: &usize| found.get(*at).is_some_and(|(side, _)| side[0] == b);
        let is_only = !leaves(&(first + 1));
        (first..first + 2).filter(leaves).find(|&at| {
            let side = found[at].0;
            let turn = || soup.turn([a, b, side[1]]);
            is_only || forward(side) == forward([a, b]) && turn().is_eq()
        })
    };
    // Each side is walked once.
    let mut is_walked = vec![false; found.len()];
    let mut whole = Vec::new();
    for (first, &(ends, side)) in found.iter().enumerate() {
        if soup.is_added(ends[0]) {
            continue;
        }
        is_walked[first] = true;
        let (mut last, mut chain) = (ends, ends.to_vec());
        while soup.is_added(last[1])
            && let Some(next) = on(last).filter(|&next| !is_walked[next])
        {
            is_walked[next] = true;
            last = found[next].0;
            chain.push(last[1]);
        }
        whole.push(Merged { side, chain });
    }
    let rest = found.iter().zip(is_walked);
    whole.extend(
        rest.filter(|(_, walked)| !walked)
            .map(|(&(ends, side), _)| Merged {
                side,
                chain: ends.to_vec(),
            }),
    );
    whole.sort_unstable_by_key(|whole| (whole.ends(), whole.side));
    whole
}
