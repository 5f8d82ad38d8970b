//! Check 8: every free side is locally Delaunay. Ties whose diagonal is not the canonical one are only counted.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::chunks::{Progress, Schedule};
use super::report::{Findings, Level, Record};
use super::sides::Sides;
use super::soup::{Soup, Tally};
use super::violation::Violation;
use crate::scalar::Scalar;

/// Findings and counts of a chunk of triangles.
struct Part {
    tally: Tally,
    findings: Findings,
    /// Sides that are not Delaunay, with their twins.
    wrong: Vec<[usize; 2]>,
    free: usize,
    cocircular: usize,
    uncanonical: usize,
}

pub(super) fn check<S: Scalar, C: Schedule<S>>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    progress: &Progress<'_>,
    record: &mut Record,
) {
    // The chunks, in any order or at the same time.
    let none = record.findings.emptied();
    let parts = C::run(soup, progress, |soup, chunk| {
        let mut part = Part {
            tally: Tally::default(),
            findings: none.clone(),
            wrong: Vec::new(),
            free: 0,
            cocircular: 0,
            uncanonical: 0,
        };
        for side in 3 * chunk.start..3 * chunk.end {
            // Each side once.
            match sides.free_twin(side) {
                Some(twin) if twin < side => part.check_side(soup, side, twin),
                _ => {}
            }
        }
        part.report(soup);
        part
    });
    // The first findings of all chunks, by the numbers of their triangles.
    let mut list = Vec::new();
    for mut part in parts {
        record.tally += part.tally;
        list.append(&mut part.findings.list);
        record.findings.append(part.findings);
        record.report.free_sides += part.free;
        record.report.cocircular_sides += part.cocircular;
        record.report.uncanonical_sides += part.uncanonical;
    }
    list.sort_by_cached_key(|violation| violation.offenders().triangles);
    record.findings.list(list);
}

impl Part {
    /// Checks the side from `a` to `b` of triangle `a`, `b`, `c`; `d` is opposite to it in the triangle of its twin.
    fn check_side<S: Scalar>(&mut self, soup: &Soup<'_, S>, side: usize, twin: usize) {
        let [[a, b, c], [_, _, d]] = [side, twin].map(|side| corners(soup, side));
        self.free += 1;
        match soup.in_circle([a, b, c, d], &mut self.tally) {
            Ordering::Less => {}
            Ordering::Equal => {
                self.cocircular += 1;
                // Canonical: the leftmost of the four is an end of the side.
                let leftmost = |v, w| {
                    if soup.is_left_or_above(v, w) { v } else { w }
                };
                let of_side = leftmost(a, b);
                if leftmost(leftmost(c, d), of_side) != of_side {
                    self.uncanonical += 1;
                }
            }
            Ordering::Greater => self.wrong.push([side, twin]),
        }
    }

    /// Adds the wrong sides to the findings, each from the triangle with the higher number, by these numbers.
    fn report<S: Scalar>(&mut self, soup: &Soup<'_, S>) {
        let triangles = |sides: &[usize; 2]| sides.map(|side| soup.number(side / 3));
        for sides in &mut self.wrong {
            let [one, other] = triangles(sides);
            if one < other {
                sides.reverse();
            }
        }
        self.wrong.sort_unstable_by_key(triangles);
        for sides in &self.wrong {
            let [[a, b, c], [_, _, d]] = sides.map(|side| corners(soup, side));
            let depths = || {
                let [one, other] = [[a, b, c, d], [b, a, d, c]].map(|v| soup.depth(v));
                Some(one?.max(other?))
            };
            let depth = self.findings.measure(Level::Delaunay, depths);
            self.findings.add(Violation::NotDelaunay {
                side: soup.names([a, b]),
                triangles: triangles(sides),
                opposite: soup.names([c, d]),
                depth,
            });
        }
    }
}

/// The ends of a side and the corner opposite to it, in the order of its triangle.
fn corners<S>(soup: &Soup<'_, S>, side: usize) -> [u32; 3] {
    let triangle = soup.triangles[side / 3];
    [0, 1, 2].map(|i| triangle[(side % 3 + i) % 3])
}
