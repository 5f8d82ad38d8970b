//! The same steps for every scalar and front, on small inputs and where the front is long and searches jump.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::Heuristics;
use sweep_cdt_testing::fronts::FrontKind;
use sweep_cdt_testing::runs::{Sample, convert};
use sweep_cdt_testing::{Input, Random, Steps, data};

use super::{HEURISTICS, steps};
use crate::cases;
use crate::generators::medium;

/// Panics unless the steps in these numbers, if they hold the points, are the same with every front.
fn assert_same<S: Sample>(input: &Input, expected: &Steps) {
    if let Some(points) = convert::<S>(&input.points) {
        for (front, kind) in FrontKind::ALL {
            let name = format!("{}, {front}", std::any::type_name::<S>());
            expected.assert_same(&points, &input.edges, kind, &name);
        }
    }
}

#[test]
fn every_scalar_and_front_on_every_case() {
    for (name, input) in cases::all() {
        println!("{name}");
        for heuristics in HEURISTICS {
            let expected = steps(&input, heuristics);
            assert_same::<f64>(&input, &expected);
            assert_same::<f32>(&input, &expected);
            assert_same::<i32>(&input, &expected);
            assert_same::<i64>(&input, &expected);
            assert_same::<BigInt>(&input, &expected);
            assert_same::<BigRational>(&input, &expected);
        }
    }
}

/// Panics, with the first step that differs, unless fronts and scalars take the same steps.
fn assert_same_steps(input: &Input, heuristics: Heuristics) {
    let Input { points, edges } = input;
    let expected = steps(input, heuristics);
    assert!(expected.result.is_ok(), "{:?}", expected.result);
    assert!(expected.trace.events.len() > 3 * points.len());
    expected.assert_same(points, edges, FrontKind::SkipList, "skip list");
    expected.assert_same(points, edges, FrontKind::Linear, "linear");
    let points = convert::<BigRational>(points).expect("a rational holds a double");
    expected.assert_same(&points, edges, FrontKind::HashTable, "BigRational");
}

#[test]
fn hundreds_of_points_and_edges() {
    for seed in 0..40 {
        println!("seed {seed}");
        let input = medium(&mut Random::new(seed));
        for heuristics in HEURISTICS {
            assert_same_steps(&input, heuristics);
        }
    }
}

#[test]
fn thousands_of_points_even_and_skewed() {
    let mut random = Random::new(1);
    // By the cube most points are where intervals of equal width would be few.
    for power in [1, 3] {
        let mut at = || random.integer(1 << 20).powi(power);
        let points = (0..5000).map(|_| [at(), at()]).collect();
        let edges = Vec::new();
        assert_same_steps(&Input { points, edges }, Heuristics::FAST);
    }
}

#[test]
fn contours() {
    let input = data::contours();
    assert_same_steps(&input, Heuristics::FAST);
    assert_same_steps(&input, Heuristics::PAPER);
}
