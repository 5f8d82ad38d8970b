//! Every scalar that holds the coordinates takes the same steps to the same result.
//!
//! The predicates of each scalar are another program: expansions of doubles, integers of 128 bits, big
//! integers, rationals over a common denominator, and for the plainest scalar the textbook's determinants.
//! One wrong sign changes a step. Some inputs are also scaled to integers (`wholes`), which are stretched,
//! moved far away or divided. The doubles that approximate such coordinates are rounded, which may change
//! the steps, but not the result.

mod wholes;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Error, Heuristics, Triangulation};

use crate::reached;
use sweep_cdt_testing::Steps;
use sweep_cdt_testing::fronts::{self, Choice, FrontKind};
use sweep_cdt_testing::oracle::found;
use sweep_cdt_testing::runs::{Archetype, Sample, convert};
use sweep_cdt_testing::{Input, generators};

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    let [scalar, heuristics, number, ..] = choices.to_le_bytes();
    let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
    let heuristics = settings[usize::from(heuristics) % settings.len()];
    let steps = Steps::of(&input.points, &input.edges, heuristics);
    judge(&input, &steps, scalar, usize::from(number));
}

/// How many scalars or sorts of numbers there are to choose from.
const CHOICES: u8 = 8;

/// Up to so many points the plainest scalar is tried, which is slow.
const FEW: usize = 16;

/// Panics unless one scalar agrees with doubles on this input, all of whose coordinates are finite. Of
/// several that might hold it, all are tried; where none does, its integers are.
fn judge(input: &Input, steps: &Steps, scalar: u8, number: usize) {
    let agrees = match scalar % CHOICES {
        0 => agrees_in_single(input, steps),
        1 => agrees::<i64>(input, steps, "i64") | agrees::<i32>(input, steps, "i32"),
        2 => agrees::<BigInt>(input, steps, "BigInt"),
        3 => agrees::<BigRational>(input, steps, "BigRational"),
        4 if input.points.len() <= FEW => agrees::<Archetype>(input, steps, "the plainest scalar"),
        _ => false,
    };
    if agrees {
        return;
    }
    let Input { points, edges } = input;
    let whole = wholes::integers(points);
    let expected = &steps.result;
    match scalar % CHOICES {
        5 => assert_same(&wholes::moved(&whole, number), edges, expected, "moved"),
        6 => assert_same(&wholes::divided(&whole, number), edges, expected, "divided"),
        7 => {
            if let Some(stretched) = wholes::stretched(&whole) {
                assert_same(&stretched, edges, expected, "stretched");
            }
        }
        _ => assert_same(&whole, edges, expected, "as integers"),
    }
}

/// The input in `f32`, rounded where that does not hold it: so that most coordinates use all bits.
fn agrees_in_single(Input { points, edges }: &Input, steps: &Steps) -> bool {
    let rounded: Vec<[f32; 2]> = points.iter().map(|p| p.map(|x| x as f32)).collect();
    let doubles: Vec<[f64; 2]> = rounded.iter().map(|p| p.map(f64::from)).collect();
    if doubles == *points {
        assert_same_steps(&rounded, edges, steps, "f32");
    } else if doubles.iter().flatten().all(|x| x.is_finite()) {
        let steps = Steps::of(&doubles, edges, Heuristics::FAST);
        assert_same_steps(&rounded, edges, &steps, "f32, rounded");
    } else {
        return false;
    }
    true
}

/// Panics if a scalar that holds the input takes other steps; says whether it holds it.
fn agrees<S: Sample>(Input { points, edges }: &Input, steps: &Steps, name: &str) -> bool {
    let points = convert::<S>(points);
    if let Some(points) = &points {
        assert_same_steps(points, edges, steps, name);
    }
    points.is_some()
}

/// Panics unless the same points in another scalar lead through the same steps, to a result that the
/// verifier accepts with that scalar's predicates.
fn assert_same_steps<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    steps: &Steps,
    name: &str,
) {
    steps.assert_same(points, edges, FrontKind::HashTable, name);
    if let Ok(result) = &steps.result {
        let report = result.verify(points, edges);
        assert!(
            report.is_ok_and(|report| report.is_canonical()),
            "{name}: verified"
        );
    }
}

/// Panics unless these points have the same triangulation, or edges that cross as well.
fn assert_same<S: Scalar + Sync>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    expected: &Result<Triangulation, Error>,
    name: &str,
) {
    let answer = |result: &Triangulation| found(result, points.len(), edges.len());
    let choice = Choice {
        algorithm: Algorithm::DivideAndConquer,
        ..Choice::default()
    };
    let here = fronts::triangulate(points, edges, choice);
    match (here, expected) {
        (Ok(here), Ok(there)) => assert_eq!(answer(&here), answer(there), "{name} (left)"),
        (Err(Error::CrossingEdges { .. }), Err(Error::CrossingEdges { .. })) => {}
        (here, there) => panic!("{name}: {here:?}, not {there:?}"),
    }
}
