//! Check 2: every triangle turns left, strictly.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::chunks::{Progress, Schedule};
use super::report::Record;
use super::soup::{REJECTED, Soup, Tally};
use super::violation::Violation;
use crate::scalar::Scalar;

/// Rejects the triangles that do not turn left. If `clockwise` ones are accepted and more turn right than left, all are
/// reversed; if as many turn right as left, the first one in the caller's list that is not flat decides.
pub(super) fn check<S: Scalar, C: Schedule<S>>(
    soup: &mut Soup<'_, S>,
    clockwise: bool,
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
            let turn = soup.orient2d(corners, &mut tally);
            if turn != Ordering::Greater {
                wrong.push((t, turn));
            }
        }
        (tally, wrong)
    });
    // The findings of the chunks, in order.
    let mut wrong = Vec::new();
    for (tally, found) in parts {
        record.tally += tally;
        wrong.extend(found);
    }
    if let Some(reversed) = clockwise.then(|| reversed(soup, &wrong)).flatten() {
        wrong = reversed;
        record.report.clockwise = true;
        for triangle in &mut soup.triangles {
            triangle.swap(1, 2);
        }
    }
    wrong.sort_unstable_by_key(|&(t, _)| soup.number(t));
    for (t, turn) in wrong {
        soup.triangles[t] = REJECTED;
        let triangle = soup.number(t);
        record.findings.add(match turn {
            Ordering::Equal => Violation::FlatTriangle { triangle },
            _ => Violation::ReversedTriangle { triangle },
        });
    }
}

/// The triangles that do not turn left once all are reversed, if they are to be. These ones do not turn left now.
fn reversed<S: Scalar>(
    soup: &Soup<'_, S>,
    wrong: &[(usize, Ordering)],
) -> Option<Vec<(usize, Ordering)>> {
    let right = || wrong.iter().filter(|(_, turn)| turn.is_lt());
    let count = right().count();
    let left = soup.accepted().count() - wrong.len();
    if count < left.max(1) {
        return None;
    }
    let is_left = |t: &usize| wrong.binary_search_by_key(t, |&(t, _)| t).is_err();
    let left_ones = soup.accepted().map(|(t, _)| t as usize).filter(is_left);
    let mut all: Vec<_> = left_ones.map(|t| (t, Ordering::Less)).collect();
    let number = |&(t, _): &(usize, Ordering)| soup.number(t);
    if count == left && right().map(number).min() > all.iter().map(number).min() {
        return None;
    }
    all.extend(wrong.iter().filter(|(_, turn)| turn.is_eq()));
    all.sort_unstable();
    Some(all)
}
