//! A domain that the caller declared by its boundary, in place of the convex hull.

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
