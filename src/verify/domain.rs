//! A domain that the caller declared by its boundary, in place of the convex hull.
//!
//! Which way the chains run does not matter: they declare what a path from outside enters by an odd number of their
//! sides. Why it is enough to run as the triangles do: how many triangles cover a place is how often their boundary
//! goes round it (see the module), which is odd where the number of crossed sides is odd, whatever way each runs.
//! That the boundary is the declared one (here), and goes round every place once or not at all (`scanline`), leaves
//! one triangle where the number is odd, and none elsewhere.

use super::record::Record;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// The sides of the declared chains, by rank, in the caller's order.
#[derive(Debug)]
pub(super) struct Domain {
    pub(super) sides: Vec<[u32; 2]>,
}

impl Domain {
    /// Turns each declared side whose reverse is on the boundary of the triangles, so that it runs as they do: the
    /// caller's chains may run any way.
    pub(super) fn orient<S: Scalar>(&mut self, soup: &Soup<'_, S>, boundary: &[u32]) {
        let mut found: Vec<[u32; 2]> = boundary.iter().map(|&side| soup.side(side)).collect();
        found.sort_unstable();
        let is_found = |side: [u32; 2]| found.binary_search(&side).is_ok();
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
        let mut found: Vec<([u32; 2], u32)> = boundary
            .iter()
            .map(|&side| (soup.side(side), side / 3))
            .collect();
        let mut declared = self.sides.clone();
        found.sort_unstable();
        declared.sort_unstable();
        for &(side, triangle) in &found {
            if declared.binary_search(&side).is_err() {
                record.findings.add(Violation::UndeclaredBoundary {
                    side: soup.names(side),
                    triangle: triangle as usize,
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
