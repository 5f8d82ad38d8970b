//! The inside by every rule, and of polygons. The rings run round triangles of a right answer, so that it is known which
//! triangles are inside; the verifier must accept these in the domain that they bound, and no others.

use sweep_cdt::Triangulation;
use sweep_cdt::interior::{FillRule, Interior, Ring};
use sweep_cdt::verify::Verifier;
use sweep_cdt_testing::oracle::canonical;
use sweep_cdt_testing::tuned::triangulate;

use super::case::Case;

/// How often rings run round the triangles, which take these numbers in turn; clockwise is negative.
const WINDINGS: [i32; 7] = [1, -1, 0, 2, 0, -2, 1];

/// A rule, and whether it counts as inside what rings run round so often.
type Rule = (FillRule, fn(i32) -> bool);

/// Panics unless the inside of rings round triangles of this right answer is right. With edges nothing is judged.
pub(super) fn judge(case: &Case) {
    if !case.edges.is_empty() || case.triangles.is_empty() {
        return;
    }
    judge_windings(case);
    judge_polygons(case);
}

fn judge_windings(case: &Case) {
    let winding = |t: usize| WINDINGS[t % WINDINGS.len()];
    let mut edges = Vec::new();
    for (t, &[a, b, c]) in case.triangles.iter().enumerate() {
        let ring = match winding(t) > 0 {
            true => [[a, b], [b, c], [c, a]],
            false => [[a, c], [c, b], [b, a]],
        };
        (0..winding(t).abs()).for_each(|_| edges.extend(ring));
    }
    let result = triangulate(&case.points, &edges).expect("sides do not cross");
    let rules: [Rule; 5] = [
        (FillRule::EvenOdd, |winding| winding % 2 != 0),
        (FillRule::NonZero, |winding| winding != 0),
        (FillRule::Positive, |winding| winding > 0),
        (FillRule::Negative, |winding| winding < 0),
        (FillRule::AtLeast(2), |winding| winding.abs() >= 2),
    ];
    for (rule, is_inside) in rules {
        let domain = result.interior(rule).expect("closed rings");
        judge_domain(case, &result, &domain, |t| is_inside(winding(t)));
    }
}

/// Of three triangles in turn the first has no ring, the second is a polygon, and the third is a part of the same polygon
/// and a hole in it at once, so that only the second one is inside.
fn judge_polygons(case: &Case) {
    let (mut edges, mut rings, mut ring_of) = (Vec::new(), Vec::new(), Vec::new());
    for (t, &[a, b, c]) in case.triangles.iter().enumerate() {
        for is_hole in [false, true].into_iter().take(t % 3) {
            let polygon = t / 3;
            edges.extend([[a, b], [b, c], [c, a]]);
            ring_of.extend([Some(rings.len()); 3]);
            rings.push(Ring { polygon, is_hole });
        }
    }
    let result = triangulate(&case.points, &edges).expect("sides do not cross");
    let domain = result.interior_of_polygons(&rings, &ring_of);
    let domain = domain.expect("closed rings");
    judge_domain(case, &result, &domain, |t| t % 3 == 1);
}

/// Panics unless these triangles are inside, and the verifier accepts them and no others in the domain that they bound.
fn judge_domain(
    case: &Case,
    result: &Triangulation,
    domain: &Interior<'_>,
    is_inside: impl Fn(usize) -> bool,
) {
    let mut expected = case.triangles.clone();
    let mut at = 0..;
    expected.retain(|_| at.next().is_some_and(&is_inside));
    let found: Vec<[usize; 3]> = domain.inside().map(|t| result.triangle(t)).collect();
    assert_eq!(
        canonical(result, &found),
        canonical(result, &expected),
        "inside {case:?}"
    );
    let chains = domain.boundary();
    if found.is_empty() {
        assert!(chains.is_empty(), "{chains:?} around nothing");
        return;
    }
    let verifier = Verifier::new().boundary(&chains);
    let is_right = |triangles: &[[usize; 3]]| verifier.verify(&case.points, &[], triangles).is_ok();
    assert!(is_right(&found), "the inside within {chains:?} of {case:?}");
    assert!(
        !is_right(&found[1..]),
        "a part within {chains:?} of {case:?}"
    );
    if found.len() < result.len() {
        let all: Vec<[usize; 3]> = result.triangles().collect();
        assert!(!is_right(&all), "the hull within {chains:?} of {case:?}");
    }
}
