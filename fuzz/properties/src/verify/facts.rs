//! What is certain of a triangulation without the verifier.

use std::collections::BTreeSet;

use sweep_cdt::{Error, triangulate};

use super::case::Case;
use sweep_cdt_testing::oracle::{canonical, check, crosses, firm_sides, is_right, sorted};

/// Up to so many points, and twice as many triangles, everything is compared with everything.
const BY_DEFINITION: usize = 8;

/// Whether the triangulation is right, where that is certain.
pub(super) fn is_certainly_right(case: &Case) -> Option<bool> {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    let mut named = edges.iter().flatten().chain(triangles.iter().flatten());
    if !points.iter().flatten().all(|x| x.is_finite()) || named.any(|&v| v >= points.len()) {
        Some(false)
    } else if points.len() <= BY_DEFINITION && triangles.len() <= 2 * BY_DEFINITION {
        Some(is_right(points, edges, triangles))
    } else {
        by_uniqueness(case)
    }
}

/// The right answers to one input differ in sides with four cocircular vertices only, so that all have
/// as many triangles and all other sides in common.
fn by_uniqueness(case: &Case) -> Option<bool> {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    let result = match triangulate(points, edges) {
        Ok(result) => result,
        Err(Error::CrossingEdges { edges: pair }) => {
            assert!(crosses(points, edges, pair), "{pair:?} do not cross");
            return Some(false);
        }
        Err(error) => panic!("no reason for: {error}"),
    };
    let right = check(points, edges, &result);
    let given = canonical(&result, triangles);
    if given == right.triangles {
        return Some(true);
    }
    let (firm, all) = (firm_sides(points, &right), sides(&right.triangles));
    let may_be_right =
        firm != all && given.len() == right.triangles.len() && firm.is_subset(&sides(&given));
    if may_be_right { None } else { Some(false) }
}

fn sides(triangles: &[[usize; 3]]) -> BTreeSet<[usize; 2]> {
    let of_one = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]].map(sorted);
    triangles.iter().flat_map(of_one).collect()
}
