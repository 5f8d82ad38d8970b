//! The same steps for every front and for exact numbers where the front is long and searches jump.

use num_rational::BigRational;
use sweep_cdt::{HashTable, Heuristics, Linear, SkipList};
use sweep_cdt_properties::Input;

use super::observe;
use crate::generators::{Random, medium};

/// Panics, with the first step that differs, unless fronts and scalars take the same steps.
fn assert_same_steps(input: &Input, heuristics: Heuristics) {
    let (expected, result) = super::trace(input, heuristics);
    assert!(result.is_ok(), "{result:?}");
    assert!(expected.events.len() > 3 * input.points.len());
    for (name, observe) in [
        ("f64, skip list", observe::<f64, SkipList> as fn(_, _) -> _),
        ("f64, linear", observe::<f64, Linear>),
        ("BigRational, hash table", observe::<BigRational, HashTable>),
    ] {
        let (trace, _) = observe(input, heuristics).expect("a rational holds a double");
        let pairs = trace.events.iter().zip(&expected.events);
        for (step, (found, expected)) in (1..).zip(pairs) {
            assert_eq!(found, expected, "{name}, step {step} (right: default)");
        }
        assert_eq!(trace.events.len(), expected.events.len(), "{name}");
    }
}

#[test]
fn inputs_of_hundreds_of_points_and_edges() {
    for seed in 0..40 {
        println!("seed {seed}");
        let input = medium(&mut Random::new(seed));
        for heuristics in super::HEURISTICS {
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

#[cfg(feature = "formats")]
#[test]
fn contours() {
    use sweep_cdt::formats::{Input as Read, InputFormat, Source, read};

    let name = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/data/isolines_small.poly"
    );
    let (name, bytes) = (
        name.to_owned(),
        std::fs::read(name).expect("a readable file"),
    );
    let Ok(Read::Doubles(graph)) = read(InputFormat::Poly, &Source { name, bytes }, None) else {
        panic!("the file holds doubles");
    };
    let input = Input {
        points: graph.points,
        edges: graph.edges,
    };
    assert_same_steps(&input, Heuristics::FAST);
    assert_same_steps(&input, Heuristics::PAPER);
}
