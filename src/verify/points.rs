//! Check 5: every distinct point is a corner, or lies outside the domain that the caller declared.

use super::domain::Domain;
use super::record::Record;
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
    for v in used..soup.vertices() {
        let is_needed = match domain {
            Some(domain) => domain.contains(soup, v, record),
            None => !soup.triangles.is_empty(),
        };
        if is_needed {
            let vertex = soup.signs.name(v);
            record.findings.add(Violation::UnusedPoint { vertex });
        }
    }
}
