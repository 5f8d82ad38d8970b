//! Check 5: every distinct point is a corner, or lies outside the domain that the caller declared, if that
//! is one. Check 6: the number of triangles is Euler's, 2 n - 2 - h for n distinct points, h of them on the hull.

use super::boundary::Domain;
use super::record::Record;
use super::scanline;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// Checks the vertices of rank `used` and above, which are the ones that no triangle names. Without any
/// triangles that is for check 4 to judge.
pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    used: u32,
    domain: Option<&Domain>,
    record: &mut Record,
) {
    let unused = used..soup.vertices();
    let needed = match domain {
        Some(domain) => match scanline::inside(&soup.signs, &domain.sides, unused) {
            Ok(inside) => inside,
            Err(side) => {
                // Where something is wrong already, nobody knows what the domain is.
                if record.findings.is_empty() {
                    let side = soup.names(side);
                    record.findings.add(Violation::TangledBoundary { side });
                }
                return;
            }
        },
        None if soup.triangles.is_empty() => return,
        None => unused.collect(),
    };
    for v in needed {
        let vertex = soup.signs.name(v);
        record.findings.add(Violation::UnusedPoint { vertex });
    }
}

/// Checks the count, if nothing else is wrong and the triangles are to fill the hull. It follows from the checks
/// before it: a second opinion, by nothing but counting.
pub(super) fn check_count(domain: Option<&Domain>, record: &mut Record) {
    let report = &record.report;
    if domain.is_some() || report.triangles == 0 || !record.findings.is_empty() {
        return;
    }
    let expected = 2 * report.distinct_points - 2 - report.boundary_sides;
    if report.triangles != expected {
        record.findings.add(Violation::WrongCount {
            triangles: report.triangles,
            expected,
        });
    }
}
