//! Every scalar that holds the coordinates takes the same steps to the same result.
//!
//! The predicates of each scalar are another program: expansions of doubles, integers of 128 and 256 bits, big
//! integers, rationals over a common denominator, and for the plainest scalar the textbook's determinants.
//! One wrong sign changes a step. Some inputs are also scaled to integers, which are stretched,
//! moved far away or divided. The doubles that approximate such coordinates are rounded, which may change
//! the steps, but not the result.

use bnum::types::I256;
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Error, Heuristics, Triangulation};

use crate::reached;
use sweep_cdt_testing::fronts::{self, Choice};
use sweep_cdt_testing::oracle::{self, Integers, found};
use sweep_cdt_testing::runs::{Archetype, Sample, convert};
use sweep_cdt_testing::{AnyFront, Steps};
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
        1 => {
            agrees::<i64>(input, steps, "i64")
                | agrees::<i32>(input, steps, "i32")
                | agrees::<i128>(input, steps, "i128")
        }
        2 => agrees::<BigInt>(input, steps, "BigInt"),
        3 => {
            agrees_by_reference(input, steps);
            agrees::<BigRational>(input, steps, "BigRational")
                | agrees::<Ratio<i64>>(input, steps, "Ratio<i64>")
        }
        4 if input.points.len() <= FEW => agrees::<Archetype>(input, steps, "the plainest scalar"),
        _ => false,
    };
    if agrees {
        return;
    }
    let Input { points, edges } = input;
    let whole = integers(points);
    let expected = &steps.result;
    match scalar % CHOICES {
        5 => assert_same(&moved(&whole, number), edges, expected, "moved"),
        6 => {
            let divided = divided(&whole, number);
            assert_same(&divided, edges, expected, "divided");
            if let Some(small) = in_machine_integers(&divided) {
                assert_same(&small, edges, expected, "Ratio<i64>, divided");
            }
        }
        7 => {
            // All of the range, or a part of it where integers have some bits more than doubles.
            let ranges = [(-(1 << 60), (1 << 61) - 1), (i64::MIN, u64::MAX)];
            let (least, range) = ranges[number % 2];
            if let Some(stretched) = stretched(&whole, least, range) {
                assert_same(&stretched, edges, expected, "i64, stretched");
            }
            if let Some(stretched) = stretched(&whole, i128::MIN, u128::MAX) {
                assert_same(&stretched, edges, expected, "i128, stretched");
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

/// Panics if points that borrow their coordinates take other steps.
fn agrees_by_reference(Input { points, edges }: &Input, steps: &Steps) {
    let borrowed: Vec<[&f64; 2]> = points.iter().map(|[x, y]| [x, y]).collect();
    assert_same_steps(&borrowed, edges, steps, "&f64");
}

/// Panics unless the same points in another scalar lead through the same steps, to a result that the
/// verifier accepts with that scalar's predicates.
fn assert_same_steps<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    steps: &Steps,
    name: &str,
) {
    steps.assert_same(points, edges, &mut AnyFront::default(), name);
    if let Ok(result) = &steps.result {
        let report = result.with_points(points).verify(edges);
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
    let here = fronts::triangulate(points, edges, &choice);
    match (here, expected) {
        (Ok(here), Ok(there)) => assert_eq!(answer(&here), answer(there), "{name} (left)"),
        (Err(Error::CrossingEdges { .. }), Err(Error::CrossingEdges { .. })) => {}
        (here, there) => panic!("{name}: {here:?}, not {there:?}"),
    }
}

/// A point as whole numbers. The changes below, which make numbers that are hard to hold, change no turns or
/// circles: one positive factor for all coordinates, and one number that is added to all.
type Whole = [BigInt; 2];

/// The points in the unit that makes them the smallest integers.
fn integers(points: &[[f64; 2]]) -> Vec<Whole> {
    let widened = |x: I256| x.to_string().parse().expect("an integer");
    match oracle::integers(points) {
        Integers::Small(points) => points.iter().map(|p| p.map(BigInt::from)).collect(),
        Integers::Medium(points) => points.iter().map(|p| p.map(widened)).collect(),
        Integers::Big(points) => points,
    }
}

/// Rationals far from zero, where they need a bit more than a double or a machine's integer has.
fn moved(points: &[Whole], number: usize) -> Vec<[BigRational; 2]> {
    const FAR: [i128; 8] = [
        1 << 53,
        -(1 << 53),
        (1 << 54) + 1,
        (1 << 61) - 1,
        -(1 << 62),
        1 << 63,
        (1 << 64) + 1,
        1 << 100,
    ];
    let by = BigInt::from(FAR[number % FAR.len()]);
    each(points, |x| BigRational::from_integer(x + &by))
}

/// Fractions, reduced or as they are; their denominators are alike or not, and may be below zero.
fn divided(points: &[Whole], number: usize) -> Vec<[BigRational; 2]> {
    const DIVISORS: [u64; 8] = [3, 7, 10, 49, 60, 1_000_000_007, (1 << 53) + 1, u64::MAX];
    let divisor = BigInt::from(DIVISORS[number % DIVISORS.len()]);
    let style = number / DIVISORS.len();
    let mut factor = BigInt::from(if style & 1 == 0 { 1 } else { -1 });
    each(points, |x| {
        if style & 2 == 0 {
            return BigRational::new(x.clone(), divisor.clone());
        }
        if style & 4 == 0 {
            factor = 4 - &factor;
        }
        BigRational::new_raw(x * &factor, &divisor * &factor)
    })
}

/// The fractions in machine integers, not reduced, if their parts fit.
fn in_machine_integers(points: &[[BigRational; 2]]) -> Option<Vec<[Ratio<i64>; 2]>> {
    let part = |x: &BigInt| i64::try_from(x).ok();
    let small = |x: &BigRational| Some(Ratio::new_raw(part(x.numer())?, part(x.denom())?));
    let points = points.iter();
    points.map(|[x, y]| Some([small(x)?, small(y)?])).collect()
}

/// Over the whole range of a type, from its least value on, if they do not need more.
fn stretched<T, U>(points: &[Whole], least: T, range: U) -> Option<Vec<[T; 2]>>
where
    T: TryFrom<BigInt>,
    BigInt: From<T> + From<U>,
{
    let coordinates = || points.iter().flatten();
    let (low, high) = (coordinates().min()?, coordinates().max()?);
    let span = (high - low).max(1.into());
    let (least, factor) = (BigInt::from(least), BigInt::from(range) / span);
    let stretched = |x: &BigInt| T::try_from((x - low) * &factor + &least).ok();
    let points = points.iter().map(|p| p.each_ref().map(stretched));
    let points = points.map(|p| p.map(|x| x.expect("it is in the range")));
    (factor > BigInt::ZERO).then(|| points.collect())
}

fn each<T>(points: &[Whole], mut number: impl FnMut(&BigInt) -> T) -> Vec<[T; 2]> {
    points
        .iter()
        .map(|p| p.each_ref().map(&mut number))
        .collect()
}
