//! After every edit a triangulation that changes is that of a fresh run.
//!
//! The first batch is the input, which is refused if its edges cross. Then a few batches insert points of the input, again
//! too, and edges between any of them, and remove what is there. `sweep_cdt_testing::edits` compares and judges.

use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_edit::Edits;
use sweep_cdt_testing::{Input, Random, edits, generators};

use crate::reached;

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    let Input { points, edges } = &input;
    if points.is_empty() || !points.as_flattened().iter().all(|x| x.is_finite()) {
        return;
    }
    if choices & 7 == 0 {
        let fraction = |x: f64| BigRational::from_float(x).expect("a finite number");
        let points: Vec<_> = points.iter().map(|point| point.map(fraction)).collect();
        judge(&points, edges, choices);
    } else {
        judge(points, edges, choices);
    }
}

fn judge<S: Scalar + Clone>(points: &[[S; 2]], edges: &[[usize; 2]], choices: u64) {
    let [_, most, batches, ..] = choices.to_le_bytes();
    let random = &mut Random::new(choices >> 24);
    let is_in_range = |&[a, b]: &[usize; 2]| a.max(b) < points.len();
    let edges = edges.iter().copied().filter(is_in_range).collect();
    let points = points.to_vec();
    let first = Edits {
        points: points.clone(),
        edges,
        ..Edits::default()
    };
    let most = [1, 2, 5, 20][usize::from(most) % 4];
    let batches = 1 + usize::from(batches) % 8;
    let point = |random: &mut Random| points[random.below(points.len())].clone();
    edits::history(random, first, [batches, most], "edits", point);
}
