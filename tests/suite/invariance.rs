//! What must not change the result: the order of the input, exact scaling and moving, an edge that is
//! there anyway; and mirrors and turns, but for the choice among cocircular triangles.

use std::collections::BTreeSet;

use sweep_cdt::triangulate;

use crate::generators::{Random, medium, small};
use sweep_cdt_properties::Input;
use sweep_cdt_properties::minimize;
use sweep_cdt_properties::oracle::{Answer, check, firm_sides};

/// The checked answer, unless edges cross.
fn answer(input: &Input) -> Option<Answer> {
    let result = triangulate(&input.points, &input.edges).ok()?;
    Some(check(&input.points, &input.edges, &result))
}

/// Runs the test on small inputs of every kind and on medium ones.
fn for_inputs(test: &dyn Fn(&Input)) {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        minimize::run(test, &small(&mut random), seed);
    }
    for seed in 0..20 {
        minimize::run(test, &medium(&mut Random::new(seed)), seed);
    }
}

fn mapped(input: &Input, map: impl Fn([f64; 2]) -> [f64; 2]) -> Input {
    let points = input.points.iter().copied().map(map).collect();
    Input {
        points,
        edges: input.edges.clone(),
    }
}

/// The triangles, with vertices of another numbering.
fn renamed(answer: &Answer, name: impl Fn(usize) -> usize) -> BTreeSet<[usize; 3]> {
    let rename = |triangle: &[usize; 3]| {
        let mut triangle = triangle.map(&name);
        let least = (0..3).min_by_key(|&i| triangle[i]).expect("three corners");
        triangle.rotate_left(least);
        triangle
    };
    answer.triangles.iter().map(rename).collect()
}

#[test]
fn order_of_the_input() {
    for_inputs(&|input| {
        let mut random = Random::new(input.points.len() as u64);
        let mut order: Vec<usize> = (0..input.points.len()).collect();
        random.shuffle(&mut order);
        let mut other = input.permuted(&order);
        random.shuffle(&mut other.edges);
        other.edges.iter_mut().for_each(|edge| edge.reverse());
        let (here, there) = (answer(input), answer(&other));
        assert_eq!(here.is_some(), there.is_some());
        if let (Some(here), Some(there)) = (here, there) {
            let triangles = renamed(&there, |v| here.representatives[order[v]]);
            assert_eq!(triangles, renamed(&here, |v| v));
        }
    });
}

#[test]
fn powers_of_two() {
    for_inputs(&|input| {
        let here = answer(input);
        for scale in [-400, -60, -1, 3, 50, 400].map(|power| 2f64.powi(power)) {
            let is_exact = |x: &f64| (x * scale / scale).total_cmp(x).is_eq();
            if input.points.iter().flatten().all(is_exact) {
                assert_eq!(
                    answer(&mapped(input, |point| point.map(|x| x * scale))),
                    here
                );
            }
        }
    });
}

#[test]
fn exact_moves() {
    for_inputs(&|input| {
        let here = answer(input);
        let offset = [12_345_678.0, -987_654_321.0];
        let there = mapped(input, |p| [0, 1].map(|i| p[i] + offset[i]));
        let back = mapped(&there, |p| [0, 1].map(|i| p[i] - offset[i]));
        // Rounding shows: integers are exact on the way there and back.
        let is_integer = |x: &f64| x.fract() == 0.0 && x.abs() < 1e9;
        if input.points.iter().flatten().all(is_integer) {
            assert_eq!(
                back.to_string().replace("-0.0", "0.0"),
                input.to_string().replace("-0.0", "0.0")
            );
            assert_eq!(answer(&there), here);
        }
    });
}

#[test]
fn mirrors_and_turns_but_for_cocircular_choices() {
    let maps: [fn([f64; 2]) -> [f64; 2]; 3] = [|[x, y]| [-x, y], |[x, y]| [-y, x], |[x, y]| [y, x]];
    for_inputs(&|input| {
        let here = answer(input);
        for map in maps {
            let other = mapped(input, map);
            let there = answer(&other);
            assert_eq!(here.is_some(), there.is_some());
            if let (Some(here), Some(there)) = (&here, &there) {
                let sides = firm_sides(&other.points, there);
                assert_eq!(sides, firm_sides(&input.points, here));
            }
        }
    });
}

#[test]
fn an_edge_that_is_there_anyway() {
    for_inputs(&|input| {
        let Some(here) = answer(input) else { return };
        let mut random = Random::new(input.edges.len() as u64);
        let mut more = input.clone();
        for &[a, b, c] in &here.triangles {
            if random.one_in(3) {
                more.edges.push(random.pick(&[[a, b], [c, b], [a, c]]));
            }
        }
        let there = answer(&more).expect("sides do not cross");
        assert_eq!(there.triangles, here.triangles);
    });
}
