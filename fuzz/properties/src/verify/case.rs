//! A triangulation to verify, its changes, what is certain of it without the verifier, and domains in a right
//! answer: a hole, some of its triangles, the hull of all points but one, and regions.

use std::collections::BTreeSet;

use sweep_cdt::Error;
use sweep_cdt::verify::{Report, Verifier, Violation, Violations};
use sweep_cdt_formats::locate_seeds;
use sweep_cdt_testing::tuned::triangulate;

use sweep_cdt_testing::boundary;
use sweep_cdt_testing::oracle::refined::Wanted;
use sweep_cdt_testing::oracle::{
    Number, Point, canonical, check, crosses, firm_sides, is_right, sorted,
};
use sweep_cdt_testing::with_integers;

/// The case that is verified.
#[derive(Debug, Default)]
pub(super) struct Case {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) edges: Vec<[usize; 2]>,
    pub(super) triangles: Vec<[usize; 3]>,
}

/// Up to so many points, and twice as many triangles, everything is compared with everything.
const BY_DEFINITION: usize = 8;

/// Whether all points are finite and all indices in range.
pub(super) fn is_defined(case: &Case) -> bool {
    let named = case.edges.as_flattened().iter();
    let mut named = named.chain(case.triangles.as_flattened());
    case.points.iter().flatten().all(|x| x.is_finite()) && named.all(|&v| v < case.points.len())
}

/// Whether everything may be compared with everything.
pub(super) fn is_small(case: &Case) -> bool {
    case.points.len() <= BY_DEFINITION && case.triangles.len() <= 2 * BY_DEFINITION
}

/// Whether the triangulation is right, where that is certain without the verifier.
pub(super) fn is_certainly_right(case: &Case) -> Option<bool> {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    if !is_defined(case) {
        Some(false)
    } else if is_small(case) {
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

/// How many kinds of change there are.
const KINDS: u8 = 16;

/// Changes the case as the four bytes say: most changes make a right one wrong.
pub(super) fn change(case: &mut Case, [kind, which, other, how]: [u8; 4]) {
    let kind = kind % KINDS;
    let among = |byte: u8, count: usize| (count > 0).then(|| usize::from(byte) % count);
    if let Some(t) = among(which, case.triangles.len()) {
        change_triangle(case, kind, t, other, how);
    }
    let n = case.points.len();
    if let (Some(v), Some(w)) = (among(which, n), among(other, n)) {
        change_input(case, kind, [v, w], how);
    }
}

/// Kinds 0 to 9.
fn change_triangle(case: &mut Case, kind: u8, t: usize, other: u8, how: u8) {
    let (n, count) = (case.points.len(), case.triangles.len());
    let (u, v) = (
        usize::from(other) % count,
        usize::from(other).min(n) % (n + 1),
    );
    let (i, j) = (usize::from(how % 3), usize::from(how / 3 % 3));
    let triangles = &mut case.triangles;
    match kind {
        // Another corner; one that does not exist if `other` is large.
        0 => triangles[t][i] = v,
        1 => drop(triangles.swap_remove(t)),
        2 => triangles.push(triangles[t]),
        3 => triangles[t].swap(i, (i + 1) % 3),
        4 => triangles[t].rotate_left(i),
        5 => flip(triangles, t, i),
        // Corners of two triangles exchanged.
        6 => (triangles[t][i], triangles[u][j]) = (triangles[u][j], triangles[t][i]),
        // One triangle in the place of another, which harms unless they are the same.
        7 => triangles[t] = triangles[u],
        8 => triangles.swap(t, u),
        // Two vertices change their roles.
        9 => {
            let pair = [triangles[t][i], v];
            for corner in triangles.as_flattened_mut() {
                if let Some(at) = pair.iter().position(|v| v == corner) {
                    *corner = pair[1 - at];
                }
            }
        }
        _ => {}
    }
}

/// Kinds 10 to 15.
fn change_input(case: &mut Case, kind: u8, [v, w]: [usize; 2], how: u8) {
    let axis = usize::from(how & 1);
    let x = case.points[v][axis];
    match kind {
        10 if how & 2 == 0 => case.points[v][axis] = x.next_up(),
        10 => case.points[v][axis] = x.next_down(),
        11 => case.points[v] = case.points[w],
        12 => case.points[v][axis] = [x + 1.0, x - 1.0, 2.0 * x, -x][usize::from(how >> 1 & 3)],
        13 => case.edges.push([v, w]),
        14 if !case.edges.is_empty() => drop(case.edges.swap_remove(v % case.edges.len())),
        15 => {
            let [p, q] = [v, w].map(|v| case.points[v]);
            let place = [0, 1].map(|i| f64::midpoint(p[i], q[i]));
            case.points.push(place);
        }
        _ => {}
    }
}

/// Replaces side `i` of triangle `t` by the other diagonal of its two triangles, if it has two.
fn flip(triangles: &mut [[usize; 3]], t: usize, i: usize) {
    let [a, b, c] = [0, 1, 2].map(|k| triangles[t][(i + k) % 3]);
    let across = |u: &[usize; 3]| (0..3).find(|&k| [u[k], u[(k + 1) % 3]] == [b, a]);
    if let Some(u) = triangles.iter().position(|u| across(u).is_some()) {
        let d = triangles[u][(across(&triangles[u]).unwrap_or(0) + 2) % 3];
        (triangles[t], triangles[u]) = ([c, a, d], [d, b, c]);
    }
}

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

/// The attributes that triangles must have: each seed lies in the middle of a triangle.
fn attributes<N: Number>(exact: &[Point<N>], case: &Case, seeds: &[(usize, f64)]) -> Vec<f64> {
    // The sum of three corners is their middle in a plane three times as large.
    let sum = |[a, b, c]: [&N; 3]| a.clone() + b.clone() + c.clone();
    let middle = |corners: [usize; 3]| [0, 1].map(|i| sum(corners.map(|v| &exact[v][i])));
    let large: Vec<Point<N>> = (0..exact.len()).map(|v| middle([v; 3])).collect();
    let wanted = Wanted {
        points: &large,
        edges: &case.edges,
        chains: &[],
    };
    let places = case.triangles.iter().map(|t| t.map(|v| large[v].clone()));
    let seeds = seeds
        .iter()
        .map(|&(t, attribute)| (middle(case.triangles[t]), attribute));
    wanted.attributes(&places.collect::<Vec<_>>(), &seeds.collect::<Vec<_>>())
}

/// Panics unless the triangles of a right answer must have the attributes of the faces in which the first and the last
/// triangle lie, and no others; and unless points are found in triangles that have them for corners.
pub(super) fn judge_regions(case: &Case) {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    if !is_small(case) || triangles.is_empty() {
        return;
    }
    let seeds = [(0, 1.0), (triangles.len() - 1, 2.0)];
    let mut attributes = with_integers!(points, |exact| attributes(&exact, case, &seeds));
    let verify = |attributes: &[f64]| {
        let verifier = Verifier::new().regions(attributes, &seeds);
        let verdict = verifier.verify(points, edges, triangles);
        verdict.map_or_else(|violations| violations.list, |_| Vec::new())
    };
    assert_eq!(verify(&attributes), [], "{attributes:?} of {case:?}");
    for triangle in 0..triangles.len() {
        attributes[triangle] += 1.0;
        let found = verify(&attributes);
        assert_eq!(found, [Violation::WrongRegion { triangle }], "{case:?}");
        attributes[triangle] -= 1.0;
    }
    let turned: Vec<[usize; 3]> = triangles.iter().map(|&[a, b, c]| [b, a, c]).collect();
    for list in [triangles, &turned] {
        for (found, point) in locate_seeds(points, list, points).iter().zip(points) {
            let is_there = found.is_some_and(|t| list[t].iter().any(|&v| points[v] == *point));
            assert!(is_there, "{point:?} in triangle {found:?} of {case:?}");
        }
    }
}
