//! Random rings: every triangle's depth and winding number, the domains and their boundaries; and right results
//! that are broken.

use std::collections::BTreeSet;

use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt::triangulate;
use sweep_cdt::verify::Verifier;
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::windings;

use super::oracle::{Rings, faces, layers, rings};

/// Tried of them, unless `SWEEP_CDT_DOMAINS` says otherwise.
const CASES: u64 = 2000;

/// The boundary must have exactly the sides of the triangles inside that have none on their right.
fn assert_boundary(domain: &Interior<'_>) {
    let result = domain.triangulation();
    let inside = domain.inside().map(|t| result.triangle(t));
    let sides: BTreeSet<[usize; 2]> = inside
        .flat_map(|t| [0, 1, 2].map(|i| [t[i], t[(i + 1) % 3]]))
        .collect();
    let is_open = |&[a, b]: &[usize; 2]| !sides.contains(&[b, a]);
    let expected: Vec<[usize; 2]> = sides.iter().copied().filter(is_open).collect();
    let loops = domain.boundary();
    let ring = |ring: &Vec<usize>| -> Vec<[usize; 2]> {
        let next = |i: usize| ring[(i + 1) % ring.len()];
        (0..ring.len()).map(|i| [ring[i], next(i)]).collect()
    };
    let mut found: Vec<[usize; 2]> = loops.iter().flat_map(ring).collect();
    found.sort_unstable();
    assert_eq!(found, expected);
    // The lowest side first, in each and among all.
    let firsts: Vec<[usize; 2]> = loops.iter().map(|list| ring(list)[0]).collect();
    let lowest = |list| ring(list).into_iter().min();
    assert_eq!(firsts, loops.iter().filter_map(lowest).collect::<Vec<_>>());
    assert!(firsts.is_sorted());
}

#[test]
fn every_triangle_is_where_rays_say() {
    let cases = std::env::var("SWEEP_CDT_DOMAINS");
    let cases = cases.map_or(CASES, |text| text.parse().expect("a number"));
    let (mut deep, mut wound, mut differ) = (0, 0, 0);
    for seed in 0..cases {
        let mut random = Random::new(seed);
        let Rings { points, edges } = rings(&mut random);
        let what = || format!("seed {seed}: {points:?} {edges:?}");
        let result = triangulate(&points, &edges).expect("edges cross at vertices only");
        let even_odd = result
            .interior(FillRule::EvenOdd)
            .expect("the rings are closed");
        let nonzero = result
            .interior(FillRule::NonZero)
            .expect("the rings are closed");
        let of_winding = |rule| result.interior(rule).expect("the rings are closed");
        let positive = of_winding(FillRule::Positive);
        let negative = of_winding(FillRule::Negative);
        let twice = of_winding(FillRule::AtLeast(2));
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let expected = layers(&points, &edges, &triangles);
        for (t, &triangle) in triangles.iter().enumerate() {
            let (crossed, winding) = windings(&points, &edges, triangle);
            assert_eq!(even_odd.is_inside(t), crossed % 2 == 1, "{t}, {}", what());
            assert_eq!(even_odd.depth(t), expected[t], "{t}, {}", what());
            assert_eq!(nonzero.is_inside(t), winding != 0, "{t}, {}", what());
            assert_eq!(nonzero.depth(t), winding, "{t}, {}", what());
            assert_eq!(positive.is_inside(t), winding > 0, "{t}, {}", what());
            assert_eq!(negative.is_inside(t), winding < 0, "{t}, {}", what());
            assert_eq!(twice.is_inside(t), winding.abs() > 1, "{t}, {}", what());
            deep += usize::from(expected[t] > 1);
            wound += usize::from(winding.abs() > 1);
            differ += usize::from((crossed % 2 == 1) != (winding != 0));
        }
        for domain in [&even_odd, &nonzero] {
            let is_listed = |t: &usize| domain.is_inside(*t);
            assert!(domain.inside().eq((0..result.len()).filter(is_listed)));
            assert_boundary(domain);
        }
    }
    println!("{cases} inputs: {deep} deep, {wound} wound, {differ} differ");
    let least = usize::try_from(cases).expect("a number") / 2;
    assert!(deep.min(wound).min(differ) > least);
}

#[test]
fn edges_that_do_not_close_are_refused() {
    for seed in 0..500 {
        let mut random = Random::new(seed);
        let Rings { points, mut edges } = rings(&mut random);
        if edges.is_empty() {
            continue;
        }
        let [a, b] = edges.swap_remove(random.below(edges.len()));
        let result = triangulate(&points, &edges).expect("edges cross at vertices only");
        // Without an edge that has a length, two vertices are open.
        let is_closed = points[a] == points[b];
        assert_eq!(
            result.interior(FillRule::EvenOdd).is_ok(),
            is_closed,
            "seed {seed}"
        );
        assert_eq!(
            result.interior(FillRule::NonZero).is_ok(),
            is_closed,
            "seed {seed}"
        );
        assert!(result.interior(FillRule::Hull).is_ok());
    }
}

/// Puts triangles in that are out, and takes out those that are in.
fn toggle(chosen: &mut BTreeSet<usize>, triangles: impl IntoIterator<Item = usize>) {
    for t in triangles {
        if !chosen.remove(&t) {
            chosen.insert(t);
        }
    }
}

/// Of right results and of broken ones the verifier says what ray casting says.
#[test]
fn the_verifier_knows_each_domain() {
    let (mut right, mut wrong) = (0, 0);
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let Rings { points, edges } = rings(&mut random);
        let result = triangulate(&points, &edges).expect("edges cross at vertices only");
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let is_even_odd = random.one_in(2);
        let is_inside = |t: &usize| match windings(&points, &edges, triangles[*t]) {
            (crossed, _) if is_even_odd => crossed % 2 == 1,
            (_, winding) => winding != 0,
        };
        let expected: BTreeSet<usize> = (0..triangles.len()).filter(is_inside).collect();

        // Every ring runs one way or the other.
        let rule = if is_even_odd {
            FillRule::EvenOdd
        } else {
            FillRule::NonZero
        };
        let domain: Interior<'_> = result.interior(rule).expect("the rings are closed");
        let mut chains = domain.boundary();
        for chain in &mut chains {
            if random.one_in(2) {
                chain.reverse();
            }
        }
        // The edges that lie in it.
        let edges: Vec<[usize; 2]> = domain.constrained_sides().collect();

        let faces = faces(&points, &edges, &triangles);
        let mut chosen = expected.clone();
        for _ in 0..random.below(3) {
            let t = random.below(triangles.len());
            match random.below(2) {
                // A triangle, or a face: a hole filled, or made.
                0 => toggle(&mut chosen, [t]),
                _ => toggle(
                    &mut chosen,
                    (0..triangles.len()).filter(|&u| faces[u].0 == faces[t].0),
                ),
            }
        }
        let given: Vec<[usize; 3]> = chosen.iter().map(|&t| triangles[t]).collect();
        let verdict = Verifier::new()
            .boundary(&chains)
            .verify(&points, &edges, &given);
        assert_eq!(
            verdict.is_ok(),
            chosen == expected,
            "seed {seed}: {verdict:?} {points:?} {chains:?} {given:?}"
        );
        right += usize::from(verdict.is_ok());
        wrong += usize::from(verdict.is_err());
    }
    println!("{right} right, {wrong} wrong");
    assert!(right > 400 && wrong > 400);
}
