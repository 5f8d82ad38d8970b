//! Domains in a right answer: a hole, some of its triangles, and the hull of all points but one.

use sweep_cdt::triangulate;
use sweep_cdt::verify::{Report, Verifier, Violation, Violations};
use sweep_cdt_testing::boundary;

use super::case::Case;

/// Panics unless a triangle of a right answer that has no side on the hull must be there, but for a
/// declared hole, where it must not be. Returns what the verifier says where the hole is not declared.
pub(super) fn judge_hole(case: &Case, hull: &[usize]) -> Option<Result<Report, Violations>> {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    let next = |list: &[usize], i: usize| list[(i + 1) % list.len()];
    let is_on_hull = |from: usize, to: usize| {
        let ends = [points[from], points[to]];
        (0..hull.len()).any(|i| [points[hull[i]], points[next(hull, i)]] == ends)
    };
    let is_inner = |t: &[usize; 3]| !(0..3).any(|i| is_on_hull(t[i], next(t, i)));
    let t = triangles.iter().position(is_inner)?;
    let mut others = triangles.clone();
    let [a, b, c] = others.swap_remove(t);
    let declared = [hull.to_vec(), vec![c, b, a]];
    let within = Verifier::new().boundary(&declared);
    let is_right = |triangles| within.verify(points, edges, triangles).is_ok();
    assert!(is_right(&others), "a hole at {t} in {case:?}");
    assert!(!is_right(triangles), "no hole at {t} in {case:?}");
    let unaware = Verifier::new().boundary(&declared[..1]);
    let verdict = unaware.verify(points, edges, &others);
    assert!(verdict.is_err(), "a hole not declared at {t} in {case:?}");
    Some(verdict)
}

/// Panics unless two of three triangles of a right answer fill the domain that they bound, but none with
/// fewer chains. Edges would have to lie in it, so there must be none.
pub(super) fn judge_part(case: &Case) {
    if !case.edges.is_empty() {
        return;
    }
    let first = |v: usize| {
        let equal = case.points.iter().position(|p| *p == case.points[v]);
        equal.expect("it equals itself")
    };
    let triangles = case.triangles.iter().map(|t| t.map(first));
    let part: Vec<[usize; 3]> = triangles
        .enumerate()
        .filter(|(t, _)| t % 3 != 0)
        .map(|(_, t)| t)
        .collect();
    let mut chains = boundary(&part);
    let is_right = |chains: &[Vec<usize>]| {
        let verifier = Verifier::new().boundary(chains);
        verifier.verify(&case.points, &[], &part).is_ok()
    };
    assert!(is_right(&chains), "a part of {case:?}");
    if let Some(chain) = chains.pop() {
        assert!(!is_right(&chains), "a part of {case:?} without {chain:?}");
    }
}

/// Panics unless triangles that go round a hub are right in the domain that they bound, if they are without
/// one: if they go round it once.
pub(super) fn judge_wound(case: &Case) {
    let chains = boundary(&case.triangles);
    let is_right = |verifier: Verifier<'_>| {
        let verdict = verifier.verify(&case.points, &[], &case.triangles);
        verdict.is_ok()
    };
    let within = is_right(Verifier::new().boundary(&chains));
    assert_eq!(
        within,
        is_right(Verifier::new()),
        "within {chains:?} (left) {case:?}"
    );
}

/// Panics unless a vertex that is left out within the hull is missed.
pub(super) fn judge_unused(case: &Case, hull: &[usize]) {
    let is_alone = |&v: &usize| {
        let equal = case.points.iter().filter(|p| **p == case.points[v]);
        equal.count() == 1 && !hull.contains(&v)
    };
    let Some(vertex) = (1..case.points.len()).find(is_alone) else {
        return;
    };
    // In its place the others have a duplicate.
    let mut others = case.points.clone();
    others[vertex] = others[0];
    let result = triangulate(&others, &[]).expect("there are no edges");
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    if triangles.is_empty() {
        return;
    }
    let chains = [result.hull().collect::<Vec<_>>()];
    let within = Verifier::new().boundary(&chains);
    let verdict = within.verify(&case.points, &[], &triangles);
    let list = verdict.map_or_else(|violations| violations.list, |_| Vec::new());
    assert_eq!(list, [Violation::UnusedPoint { vertex }], "of {case:?}");
}
