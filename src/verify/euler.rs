//! Check 6: the number of triangles is Euler's, 2 n - 2 - h for n distinct points, h of them on the hull.
//!
//! It follows from the checks before it: a second opinion, by nothing but counting.

use super::domain::Domain;
use super::record::Record;
use super::violation::Violation;

/// Checks the count, if nothing else is wrong and the triangles are to fill the hull.
pub(super) fn check(domain: Option<&Domain>, record: &mut Record) {
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
