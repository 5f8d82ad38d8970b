//! How deep faults are, vertices that the input lacks, and levels: as the oracle has them.

use sweep_cdt::verify::{Level, Verifier, Violation, Violations};
use sweep_cdt_testing::oracle::arrangement::fractions;
use sweep_cdt_testing::oracle::refined::{Wanted, depth, height, is_near};
use sweep_cdt_testing::oracle::{Number, Point, is_right};
use sweep_cdt_testing::with_integers;

use super::case::{Case, is_defined, is_small};

/// Panics unless the first violations are as deep as they say.
pub(super) fn judge_depths(case: &Case, violations: &Violations) {
    for violation in violations.list.iter().take(4) {
        let expected = match *violation {
            Violation::NotDelaunay { side, opposite, .. } => {
                let [[a, b], [c, d]] = [side, opposite].map(|pair| pair.map(|v| case.points[v]));
                let exact = fractions(&[a, b, c, d]);
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| &exact[i]);
                assert!(violation.depth().is_some(), "{violation:?} of {case:?}");
                depth([a, b, c, d]).max(depth([b, a, d, c]))
            }
            Violation::ConcaveBoundary { vertices, .. } if violation.depth().is_some() => {
                let exact = fractions(&vertices.map(|v| case.points[v]));
                -height([&exact[0], &exact[1], &exact[2]])
            }
            _ => continue,
        };
        let found = violation.depth().map_or(0.0, |depth| depth.get());
        let is_right = found > 0.0 && is_near(found, &expected);
        assert!(is_right, "{violation:?} is {expected} deep in {case:?}");
    }
    let is_all = violations.depths.measured() == violations.found;
    assert_eq!(violations.depth().is_some(), is_all, "{violations:?}");
}

/// Panics unless the verdict is right where the last points may be vertices that the input lacks.
pub(super) fn judge_added(case: &Case) {
    if !is_defined(case) || !is_small(case) {
        return;
    }
    let own = case.points.len() - case.points.len() / 3;
    let is_own = |edge: &&[usize; 2]| edge.iter().all(|&v| v < own);
    let edges: Vec<[usize; 2]> = case.edges.iter().filter(is_own).copied().collect();
    with_integers!(&case.points, |exact| judge_with(case, own, &edges, &exact));
}

/// [`judge_added`] with the coordinates as integers: the points up to `own` are the input's.
fn judge_with<N: Number>(case: &Case, own: usize, edges: &[[usize; 2]], exact: &[Point<N>]) {
    let triangles = case.triangles.iter();
    let triangles: Vec<_> = triangles.map(|t| t.map(|v| exact[v].clone())).collect();
    let wanted = Wanted {
        points: &exact[..own],
        edges,
        chains: &[],
    };
    let verifier = Verifier::new().added_from(own);
    let verdict = verifier.verify(&case.points, edges, &case.triangles);
    let is_right = wanted.is_met_by(&triangles);
    assert_eq!(
        verdict.is_ok(),
        is_right,
        "{verdict:?} from {own} of {case:?}"
    );
    if let Err(violations) = &verdict {
        for violation in &violations.list {
            judge_bend(case, edges, violation);
        }
    }
    if let Ok(report) = verdict {
        let split = wanted.split_edges(&triangles);
        assert_eq!(report.split_edges, split, "{case:?}");
    }
}

/// Panics unless an added vertex beside an edge or the boundary is as far from it as it says.
fn judge_bend(case: &Case, edges: &[[usize; 2]], violation: &Violation) {
    let ([a, b], vertex) = match *violation {
        Violation::BentEdge { edge, vertex, .. } => (edges[edge], vertex),
        Violation::BentBoundary { side, vertex, .. } => (side, vertex),
        _ => return,
    };
    let Some(depth) = violation.depth() else {
        return;
    };
    let exact = fractions(&[a, vertex, b].map(|v| case.points[v]));
    let expected = height([&exact[0], &exact[1], &exact[2]]);
    let is_right = is_near(depth.get(), &expected) || is_near(depth.get(), &-expected);
    assert!(is_right, "{violation:?} of {case:?}");
}

/// Panics unless the levels are those of the definition. Edges need not be Delaunay: so with all sides for edges, a
/// right triangulation is one that tiles the hull, and with the case's own edges besides a constrained one.
pub(super) fn judge_levels(case: &Case) {
    if !is_defined(case) || !is_small(case) {
        return;
    }
    let Case {
        points,
        edges,
        triangles,
    } = case;
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let sides: Vec<[usize; 2]> = sides.collect();
    let both = [&edges[..], &sides].concat();
    let verdict = |level| {
        Verifier::new()
            .level(level)
            .verify(points, edges, triangles)
    };
    let reached = match verdict(Level::Canonical) {
        Ok(report) => report.level,
        Err(violations) => violations.report.level,
    };
    for level in [
        Level::Tiling,
        Level::Constrained,
        Level::Delaunay,
        Level::Canonical,
    ] {
        let is_reached = verdict(level).is_ok();
        assert_eq!(is_reached, reached >= Some(level), "{level:?} of {case:?}");
        let expected = match level {
            Level::Tiling => is_right(points, &sides, triangles),
            Level::Constrained => is_right(points, &both, triangles),
            Level::Delaunay => is_right(points, edges, triangles),
            _ => continue,
        };
        assert_eq!(is_reached, expected, "{level:?} of {case:?}");
    }
}
