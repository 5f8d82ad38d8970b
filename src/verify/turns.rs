//! Check 2: every triangle turns left, strictly.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::chunks::{Progress, Schedule};
use super::report::Record;
use super::soup::{REJECTED, Soup, Tally};
use super::violation::Violation;
use crate::scalar::Scalar;

/// Reverses all triangles if the first one that is not flat turns right, and at least half of them do.
pub(super) fn reverse_if_clockwise<S: Scalar>(soup: &mut Soup<'_, S>, record: &mut Record) {
    let mut turns = soup
        .accepted()
        .map(|(_, corners)| soup.predicates.orient2d(corners, &mut record.tally))
        .filter(|turn| turn.is_ne());
    let first_turn = turns.next();
    if first_turn == Some(Ordering::Less) {
        let others = turns.fold(0_isize, |sum, turn| sum + turn as isize);
        if others > 1 {
            return;
        }
        record.report.clockwise = true;
        for triangle in &mut soup.triangles {
            triangle.swap(1, 2);
        }
    }
}

/// Rejects the triangles that do not turn left.
pub(super) fn check<S: Scalar, C: Schedule<S>>(
    soup: &mut Soup<'_, S>,
    progress: &Progress<'_>,
    record: &mut Record,
) {
    // The chunks, in any order or at the same time.
    let parts = C::run(soup, progress, |soup, chunk| {
        let mut tally = Tally::default();
        let mut wrong = Vec::new();
        for t in chunk {
            let corners = soup.triangles[t];
            if corners == REJECTED {
                continue;
            }
            let turn = soup.predicates.orient2d(corners, &mut tally);
            if turn != Ordering::Greater {
                wrong.push((t, turn));
            }
        }
        (tally, wrong)
    });
    // The findings of the chunks, in order.
    for (tally, wrong) in parts {
        record.tally += tally;
        for (triangle, turn) in wrong {
            soup.triangles[triangle] = REJECTED;
            record.findings.add(match turn {
                Ordering::Equal => Violation::FlatTriangle { triangle },
                _ => Violation::ReversedTriangle { triangle },
            });
        }
    }
}
