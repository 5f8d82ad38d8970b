//! Boundaries that turn right: whether their turns are measured; and declared ones whose sides are split by vertices
//! that the input lacks.
//!
//! The judge is the arrangement of the sides in fractions: a side that crosses another one, or has a vertex on it, goes
//! through more than its two ends.

use num_bigint::Sign;
use sweep_cdt::verify::{Verifier, Violation, Violations};
use sweep_cdt_testing::boundary;
use sweep_cdt_testing::oracle::arrangement::{Exact, chains, crossings, fractions};
use sweep_cdt_testing::oracle::refined::Wanted;
use sweep_cdt_testing::oracle::{Number, Point};
use sweep_cdt_testing::with_integers;

use super::case::{Case, is_defined, is_small};

/// Panics unless the turns of a boundary have depths if that is all that is wrong: they go on, and the boundary
/// neither crosses nor covers itself. Of boundaries that touch themselves nothing is said.
pub(super) fn judge_turns(case: &Case, violations: &Violations) {
    let turns = violations.list.iter().map(|violation| match violation {
        Violation::ConcaveBoundary { vertices, depth } => Some((*vertices, depth.is_some())),
        _ => None,
    });
    // Then the triangles are sound, and their boundary is one chain.
    let Some(turns) = turns.collect::<Option<Vec<_>>>() else {
        return;
    };
    if turns.len() < violations.found {
        return;
    }
    let exact = fractions(&case.points);
    let goes_on = |[a, b, c]: [usize; 3]| {
        let along = |i: usize| (&exact[b][i] - &exact[a][i]) * (&exact[c][i] - &exact[b][i]);
        (along(0) + along(1)).numer().sign() == Sign::Plus
    };
    let go_on = turns.iter().all(|(turn, _)| goes_on(*turn));
    let sides = sides(&outline(case));
    let is_measured = turns.iter().any(|(_, is_measured)| *is_measured);
    if is_measured {
        assert!(go_on, "a turn back is measured: {violations:?} of {case:?}");
        let crossing = crossings(&exact, &sides);
        assert!(
            crossing.is_empty(),
            "{crossing:?}: {violations:?} of {case:?}"
        );
    } else {
        let is_flat = go_on && is_simple(&exact, &sides);
        assert!(!is_flat, "not measured: {violations:?} of {case:?}");
    }
}

/// Panics unless the verdict is right where the sides of a declared domain may be split by vertices that the input
/// lacks. One triangle is left out if that makes a dent in the boundary at such a vertex.
pub(super) fn judge_declared(case: &Case) {
    if !is_defined(case) || !is_small(case) {
        return;
    }
    let own = case.points.len() - case.points.len() / 3;
    let triangles = distinct(case);
    let all: Vec<[usize; 2]> = triangles.iter().flat_map(sides_of).collect();
    if (1..all.len()).any(|i| all[..i].contains(&all[i])) {
        return;
    }
    judge_within(case, own, &triangles);
    let is_outer = |[a, b]: [usize; 2]| !all.contains(&[b, a]);
    let makes_dent = |t: &[usize; 3]| {
        let mut sides = (0..3).map(|i| [t[i], t[(i + 1) % 3], t[(i + 2) % 3]]);
        sides.any(|[a, b, c]| is_outer([a, b]) && a.max(b) < own && own <= c)
    };
    if let Some(dent) = triangles.iter().position(makes_dent) {
        let mut others = triangles.clone();
        others.remove(dent);
        judge_within(case, own, &others);
    }
}

/// Judges triangles no two of which share a directed side. They are to fill what their boundary bounds without
/// the vertices that the input lacks.
fn judge_within(case: &Case, own: usize, triangles: &[[usize; 3]]) {
    let mut declared = boundary(triangles);
    for chain in &mut declared {
        chain.retain(|&v| v < own);
    }
    let exact = fractions(&case.points);
    let is_domain = declared.iter().all(|chain| chain.len() > 2);
    if declared.is_empty() || !is_domain || !is_simple(&exact, &sides(&declared)) {
        return;
    }
    let is_own = |edge: &&[usize; 2]| edge.iter().all(|&v| v < own);
    let edges: Vec<[usize; 2]> = case.edges.iter().filter(is_own).copied().collect();
    let is_right = with_integers!(&case.points, |exact| fills(
        &exact, own, &edges, &declared, triangles
    ));
    let verifier = Verifier::new().added_from(own).boundary(&declared);
    let verdict = verifier.verify(&case.points, &edges, triangles);
    assert_eq!(
        verdict.is_ok(),
        is_right,
        "{verdict:?} within {declared:?} from {own} of {case:?}"
    );
}

/// Whether triangles are right within these chains, where the points up to `own` are the input's.
fn fills<N: Number>(
    exact: &[Point<N>],
    own: usize,
    edges: &[[usize; 2]],
    chains: &[Vec<usize>],
    triangles: &[[usize; 3]],
) -> bool {
    let places = triangles.iter().map(|t| t.map(|v| exact[v].clone()));
    let wanted = Wanted {
        points: &exact[..own],
        edges,
        chains,
    };
    // An edge may have an end outside of the domain, unless it has no length.
    let is_corner = |v: &usize| {
        triangles
            .as_flattened()
            .iter()
            .any(|w| exact[*w] == exact[*v])
    };
    let has_corners = |[a, b]: &[usize; 2]| exact[*a] == exact[*b] || is_corner(a) && is_corner(b);
    wanted.is_met_by(&places.collect::<Vec<_>>()) && edges.iter().all(has_corners)
}

/// The triangles, with the first of equal points for each corner.
fn distinct(case: &Case) -> Vec<[usize; 3]> {
    let first = |v: usize| {
        let equal = case.points.iter().position(|p| *p == case.points[v]);
        equal.expect("it equals itself")
    };
    case.triangles.iter().map(|t| t.map(first)).collect()
}

/// The closed chains around the triangles of a case.
fn outline(case: &Case) -> Vec<Vec<usize>> {
    boundary(&distinct(case))
}

fn sides_of(&[a, b, c]: &[usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The sides of closed chains.
fn sides(chains: &[Vec<usize>]) -> Vec<[usize; 2]> {
    let of_one = |chain: &Vec<usize>| {
        let ends = chain
            .iter()
            .copied()
            .zip(chain.iter().copied().cycle().skip(1));
        ends.map(|(a, b)| [a, b]).collect::<Vec<_>>()
    };
    chains.iter().flat_map(of_one).collect()
}

/// Whether sides of closed chains meet in their ends only, two at each.
fn is_simple(points: &[Exact], sides: &[[usize; 2]]) -> bool {
    let starts: Vec<Exact> = sides.iter().map(|side| points[side[0]].clone()).collect();
    let place = |v: usize| starts.iter().position(|start| *start == points[v]);
    let ends = |side: &[usize; 2]| side.map(|v| place(v).expect("chains are closed"));
    let ends: Vec<[usize; 2]> = sides.iter().map(ends).collect();
    let are_distinct = (0..starts.len()).all(|i| !starts[..i].contains(&starts[i]));
    are_distinct && chains(&starts, &ends).iter().all(|chain| chain.len() == 2)
}
