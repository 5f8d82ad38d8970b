//! Every scalar that holds the coordinates takes the same steps to the same result.
//!
//! The predicates of each scalar are another program: expansions of doubles, integers of 128 bits, big
//! integers, rationals over a common denominator, and for the plainest scalar the textbook's determinants.
//! One that is wrong once changes a step. Some inputs are besides scaled to integers, and these divided by
//! a number that no power of two makes whole: doubles near such coordinates are rounded, which may
//! change the steps, but not the result.

use bnum::types::I256;
use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::{Error, HashTable, Heuristics, Scalar, Triangulation, triangulate};

use crate::oracle::{Integers, found, integers};
use crate::runs::{Archetype, Sample, convert};
use crate::steps::Steps;
use crate::{Input, generators, reached};

/// Up to so many points rationals are tried.
const RATIONAL: usize = 16;

/// What integers are divided by.
const DIVISORS: [u64; 8] = [3, 7, 10, 49, 60, 1_000_000_007, (1 << 53) + 1, u64::MAX];

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    judge(&input, choices.to_le_bytes()[0]);
}

/// Panics unless all scalars agree on this input, all of whose coordinates are finite. Of the choices
/// two bits say whether rationals are tried, three what divides them, and the rest picks heuristics.
fn judge(input: &Input, choices: u8) {
    let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
    let heuristics = settings[usize::from(choices >> 5) % settings.len()];
    let steps = Steps::of::<f64, HashTable>(&input.points, &input.edges, heuristics);
    judge_single(input, &steps);
    judge_scalar::<i32>(input, &steps, "i32");
    judge_scalar::<i64>(input, &steps, "i64");
    judge_scalar::<BigInt>(input, &steps, "BigInt");
    if choices & 3 == 0 && input.points.len() <= RATIONAL {
        judge_scalar::<BigRational>(input, &steps, "BigRational");
        judge_scalar::<Archetype>(input, &steps, "the plainest scalar");
        let divisor = DIVISORS[usize::from(choices >> 2) % DIVISORS.len()];
        judge_divided(input, &steps.result, divisor);
    }
}

/// The input in `f32`, rounded where that does not hold it: else hardly a coordinate would use all bits.
fn judge_single(input: &Input, steps: &Steps) {
    let Input { points, edges } = input;
    let rounded: Vec<[f32; 2]> = points.iter().map(|p| p.map(|x| x as f32)).collect();
    let doubles: Vec<[f64; 2]> = rounded.iter().map(|p| p.map(f64::from)).collect();
    if doubles == *points {
        steps.assert_same::<f32, HashTable>(&rounded, edges, "f32");
    } else if doubles.iter().flatten().all(|x| x.is_finite()) {
        Steps::of::<f64, HashTable>(&doubles, edges, Heuristics::FAST)
            .assert_same::<f32, HashTable>(&rounded, edges, "f32, rounded");
    }
}

fn judge_scalar<S: Sample>(input: &Input, steps: &Steps, name: &str) {
    if let Some(points) = convert::<S>(&input.points) {
        steps.assert_same::<S, HashTable>(&points, &input.edges, name);
        if let Ok(result) = &steps.result {
            let report = result.verify(&points, &input.edges);
            assert!(
                report.is_ok_and(|report| report.is_canonical()),
                "{name}: verified"
            );
        }
    }
}

/// The input scaled to integers, and these divided.
fn judge_divided(input: &Input, expected: &Result<Triangulation, Error>, divisor: u64) {
    let widened = |x: I256| x.to_string().parse().expect("an integer");
    let points: Vec<[BigInt; 2]> = match integers(&input.points) {
        Integers::Small(points) => points.iter().map(|p| p.map(BigInt::from)).collect(),
        Integers::Medium(points) => points.iter().map(|p| p.map(widened)).collect(),
        Integers::Big(points) => points,
    };
    assert_same(&points, &input.edges, expected, "as integers");
    let divided = |x: &BigInt| BigRational::new(x.clone(), divisor.into());
    let points: Vec<[BigRational; 2]> = points.iter().map(|p| p.each_ref().map(divided)).collect();
    assert_same(&points, &input.edges, expected, "as fractions");
}

fn assert_same<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    expected: &Result<Triangulation, Error>,
    name: &str,
) {
    let answer = |result: &Triangulation| found(result, points.len(), edges.len());
    match (triangulate(points, edges), expected) {
        (Ok(here), Ok(there)) => assert_eq!(answer(&here), answer(there), "{name} (left)"),
        (Err(Error::CrossingEdges { .. }), Err(Error::CrossingEdges { .. })) => {}
        (here, there) => panic!("{name}: {here:?}, not {there:?}"),
    }
}
