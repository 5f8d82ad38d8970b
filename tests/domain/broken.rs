//! Right results that are broken: the verifier says of each what ray casting says.

use std::collections::BTreeSet;

use sweep_cdt::domain::{Domain, Rule};
use sweep_cdt::triangulate;
use sweep_cdt::verify::Verifier;
use sweep_cdt_testing::Random;

use super::oracle::{cast, faces};
use super::rings::{Rings, rings};

/// Puts triangles in that are out, and takes out those that are in.
fn toggle(chosen: &mut BTreeSet<usize>, triangles: impl IntoIterator<Item = usize>) {
    for t in triangles {
        if !chosen.remove(&t) {
            chosen.insert(t);
        }
    }
}

#[test]
fn the_verifier_knows_each_domain() {
    let (mut right, mut wrong) = (0, 0);
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let Rings { points, edges } = rings(&mut random);
        let result = triangulate(&points, &edges).expect("edges cross at vertices only");
        let triangles: Vec<[usize; 3]> = result.triangles().collect();
        let is_even_odd = random.one_in(2);
        let is_inside = |t: &usize| match cast(&points, &edges, triangles[*t]) {
            (crossed, _) if is_even_odd => crossed % 2 == 1,
            (_, winding) => winding != 0,
        };
        let expected: BTreeSet<usize> = (0..triangles.len()).filter(is_inside).collect();

        // Every ring runs one way or the other.
        let rule = if is_even_odd {
            Rule::EvenOdd
        } else {
            Rule::NonZero(&edges)
        };
        let domain: Domain<'_> = result.domain(rule).expect("the rings are closed");
        let mut chains = domain.boundary();
        for chain in &mut chains {
            if random.one_in(2) {
                chain.reverse();
            }
        }
        // The edges that lie in it.
        let edges: Vec<[usize; 2]> = domain.constrained_edges().collect();

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
