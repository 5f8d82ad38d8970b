//! Coordinates that no double holds, inputs that are refused, and scalars whose signs contradict each other.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::panic::{AssertUnwindSafe, catch_unwind};

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::interior::FillRule;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Violation, verify};
use sweep_cdt::{Algorithm, Bands, Error, Triangulation, Triangulator, triangulate};
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::{exact_verdict, found};
use sweep_cdt_testing::runs::ALGORITHMS;

/// Runs points of a scalar and compares with the oracle's integers.
fn agrees<S: Scalar>(points: &[[S; 2]], integers: &[[BigInt; 2]], edges: &[[usize; 2]]) {
    let outcome = triangulate(points, edges);
    match exact_verdict(integers, edges) {
        Ok(expected) => {
            let result: Triangulation = outcome.expect("the oracle finds no crossing");
            assert_eq!(
                found(&result, points.len(), edges.len()),
                expected,
                "right: oracle"
            );
        }
        Err(crossings) => match outcome {
            Err(Error::CrossingEdges { edges }) => assert!(crossings.contains(&edges)),
            other => panic!("{other:?}, but {crossings:?} cross"),
        },
    }
}

fn big<T: Copy + Into<BigInt>>(points: &[[T; 2]]) -> Vec<[BigInt; 2]> {
    points.iter().map(|p| p.map(Into::into)).collect()
}

/// The corners of a square, and points on and beside its diagonals.
fn square<T: Copy + From<i8>>(least: T, most: T) -> Vec<[T; 2]> {
    let [minus, zero, one] = [-1, 0, 1].map(T::from);
    vec![
        [least, least],
        [most, least],
        [most, most],
        [least, most],
        [zero, one],
        [zero, most],
        [one, zero],
        [minus, minus],
    ]
}

#[test]
fn the_largest_integers() {
    let edges = [[0, 2], [4, 5]];
    let points = square(i32::MIN, i32::MAX);
    agrees(&points, &big(&points), &edges);
    let points = square(i64::MIN, i64::MAX);
    agrees(&points, &big(&points), &edges);
}

#[test]
fn integers_next_to_each_other_that_round_to_one_double() {
    let near = 1_i64 << 62;
    let points: Vec<[i64; 2]> = (0..20).map(|i| [near + i % 5, i / 5 - near]).collect();
    agrees(
        &points,
        &big(&points),
        &[[0, 19], [4, 15 + 1]].map(|[a, b]| [a, b]),
    );
    agrees(&points, &big(&points), &[[0, 18], [5, 9], [19, 15]]);
}

#[test]
fn thirds() {
    let thirds = |x: i32| BigRational::new(x.into(), 3.into());
    let points: Vec<[i32; 2]> = (0..25).map(|i| [i % 5 * 2, i / 5]).collect();
    let rationals: Vec<_> = points.iter().map(|p| p.map(thirds)).collect();
    agrees(&rationals, &big(&points), &[[0, 24], [1, 3], [20, 21]]);
}

#[test]
fn what_is_not_finite_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, bad], [bad, bad]];
        let error = triangulate(&points, &[]).unwrap_err();
        assert_eq!(error, Error::NonFiniteCoordinate { vertex: 2 });
    }
    let error = triangulate(&[[0.0, f32::INFINITY]], &[]).unwrap_err();
    assert_eq!(error, Error::NonFiniteCoordinate { vertex: 0 });
}

#[test]
fn edges_to_nowhere_are_refused() {
    let points = [[0, 0], [1, 0], [0, 1]];
    let error = triangulate(&points, &[[0, 1], [2, 3], [9, 9]]).unwrap_err();
    assert_eq!(error, Error::EdgeOutOfRange { edge: 1, vertex: 3 });
    let error = triangulate(&points, &[[usize::MAX, 7]]).unwrap_err();
    assert_eq!(
        error,
        Error::EdgeOutOfRange {
            edge: 0,
            vertex: usize::MAX
        }
    );
    let error = triangulate::<f64>(&[], &[[0, 0]]).unwrap_err();
    assert_eq!(error, Error::EdgeOutOfRange { edge: 0, vertex: 0 });
}

/// A coordinate that takes no memory.
#[derive(Clone, Copy)]
struct Nothing;

impl Scalar for Nothing {
    fn approx(&self) -> f64 {
        0.0
    }

    fn compare(&self, _: &Self) -> Ordering {
        Equal
    }

    fn orient2d(_: &[Self; 2], _: &[Self; 2], _: &[Self; 2]) -> Ordering {
        Equal
    }

    fn in_circle(_: &[Self; 2], _: &[Self; 2], _: &[Self; 2], _: &[Self; 2]) -> Ordering {
        Equal
    }
}

#[test]
fn more_than_can_be_numbered_is_refused() {
    let (given, limit) = (1 << 27, (1 << 27) - 4);
    let error = triangulate(&[[Nothing; 2]; 1 << 27], &[]).unwrap_err();
    assert_eq!(error, Error::TooManyPoints { given, limit });
    // Zeros from the system: no memory is touched.
    let edges = vec![[0; 2]; 1 << 27];
    let error = triangulate::<f64>(&[], &edges).unwrap_err();
    assert_eq!(error, Error::TooManyEdges { given, limit });
    let sentence = "134217728 edges are more than the limit of 134217724";
    assert_eq!(error.to_string(), sentence);

    let (given, limit) = ((1 << 31) + 1, 1 << 31);
    let violations = verify(&[[Nothing; 2]; (1 << 31) + 1], &[], &[]).unwrap_err();
    assert_eq!(violations.list, [Violation::TooLarge { given, limit }]);
}

/// Runs itself again where the address space ends before the memory that eight million points take.
#[cfg(target_os = "linux")]
#[test]
fn what_there_is_no_memory_for_is_refused() {
    const INSIDE: &str = "SWEEP_CDT_WITHOUT_MEMORY";
    let (count, limit) = (1 << 23, 700 << 20);
    if std::env::var_os(INSIDE).is_some() {
        let points = vec![[Nothing; 2]; count];
        let bytes = 96 * count;
        let error = triangulate(&points, &[]).unwrap_err();
        assert_eq!(error, Error::OutOfMemory { bytes });
        let sentence = "out of memory: the triangulation takes some 805306368 bytes";
        assert_eq!(error.to_string(), sentence);
        let run = Triangulator::new().triangulate_parallel(&points, &[], Bands::new());
        assert_eq!(run.unwrap_err(), Error::OutOfMemory { bytes });
        return;
    }
    let program = std::env::current_exe().expect("the tests");
    let output = std::process::Command::new("prlimit")
        .arg(format!("--as={limit}"))
        .arg(program)
        .args(["--exact", "limits::what_there_is_no_memory_for_is_refused"])
        .args(["--test-threads", "1"])
        .env(INSIDE, "")
        .output()
        .expect("prlimit starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}");
    assert!(text.contains("1 passed"), "{text}");
}

/// A double with wrong signs, which contradict each other; the kind of wrong is a constant.
#[derive(Clone, Copy, Debug)]
struct Wrong<const KIND: u8>(f64);

/// In circle is always positive; never negative; all signs are random.
const ALWAYS_INSIDE: u8 = 0;
const RANDOM_CIRCLES: u8 = 1;
const RANDOM: u8 = 2;

/// A sign that depends on nothing but the order of the coordinates.
fn random(points: &[&[f64; 2]]) -> Ordering {
    let seed = points.iter().flat_map(|p| p.iter()).fold(7_u64, |seed, x| {
        seed.rotate_left(9) ^ x.to_bits().wrapping_mul(0x9E37_79B9)
    });
    [Less, Equal, Greater][Random::new(seed).below(3)]
}

impl<const KIND: u8> Scalar for Wrong<KIND> {
    fn approx(&self) -> f64 {
        self.0
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| x.0));
        if KIND == RANDOM {
            random(&[&a, &b, &c])
        } else {
            Scalar::orient2d(&a, &b, &c)
        }
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        if KIND == ALWAYS_INSIDE {
            return Greater;
        }
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(|x| x.0));
        random(&[&a, &b, &c, &d])
    }
}

/// Points whose doubles are approximations for the filter, which cannot separate them.
fn collapsed<const KIND: u8>(seed: u64) -> Vec<[Wrong<KIND>; 2]> {
    let random = &mut Random::new(seed);
    (0..30)
        .map(|_| [0, 1].map(|_| Wrong(1.0 + random.integer(40) * f64::EPSILON)))
        .collect()
}

/// Triangulates small inputs; [`collapsed`] coordinates are so near each other that the filter decides
/// nothing. Returns how many runs ended in a panic that blames the scalar.
fn blamed<const KIND: u8>(algorithm: Algorithm) -> usize {
    let mut blamed = 0;
    for seed in 0..40 {
        let points = collapsed::<KIND>(seed);
        let edges = [[0, 1], [2, 3], [4, 5]];
        let run = Triangulator::new().algorithm(algorithm);
        let result = catch_unwind(AssertUnwindSafe(|| {
            run.triangulate(&points, &edges).is_ok()
        }));
        if let Err(panic) = result {
            let message = panic
                .downcast_ref::<String>()
                .map(String::as_str)
                .or_else(|| panic.downcast_ref::<&str>().copied())
                .unwrap_or_default();
            blamed += usize::from(message.contains("signs contradict each other"));
        }
    }
    blamed
}

/// In a panic that says so, if not well: never in an endless loop.
#[test]
fn every_run_ends() {
    let mut all = 0;
    let others = ALGORITHMS.iter().map(|&(_, algorithm)| algorithm);
    for algorithm in [Algorithm::Auto, Algorithm::Sweep]
        .into_iter()
        .chain(others)
    {
        let blamed = [
            blamed::<ALWAYS_INSIDE>(algorithm),
            blamed::<RANDOM_CIRCLES>(algorithm),
            blamed::<RANDOM>(algorithm),
        ];
        println!("{algorithm:?}: {blamed:?} of 40");
        all += blamed.iter().sum::<usize>();
    }
    assert!(all > 0, "no scalar was blamed");
}

/// The memory of a session is whatever the panic of a scalar left in it.
#[test]
fn a_session_goes_on_after_a_panic() {
    let others = ALGORITHMS.iter().map(|&(_, algorithm)| algorithm);
    for algorithm in [Algorithm::Auto, Algorithm::Sweep]
        .into_iter()
        .chain(others)
    {
        let mut session = Triangulator::new().algorithm(algorithm).session();
        let (mut panics, edges) = (0, [[0, 1], [2, 3], [4, 5]]);
        for seed in 0..40 {
            let wrong = collapsed::<RANDOM>(seed);
            let run = || session.triangulate(&wrong, &edges).is_ok();
            panics += usize::from(catch_unwind(AssertUnwindSafe(run)).is_err());

            // Few points, so that the panic leaves numbers that are none of theirs.
            let points: Vec<[f64; 2]> = wrong[..7]
                .iter()
                .map(|point| [0, 1].map(|axis| (point[axis].0 - 1.0) / f64::EPSILON))
                .collect();
            let lists = |result: &Triangulation| result.canonical_triangles();
            let result = session.triangulate(&points, &edges).map(lists);
            let expected = triangulate(&points, &edges).map(|result| lists(&result));
            assert_eq!(result, expected, "{algorithm:?}, seed {seed}");

            // Nor does a polygon, of which the inside alone is triangulated, keep what a panic left.
            let ring: Vec<[usize; 2]> = (0..30).map(|v| [v, (v + 1) % 30]).collect();
            let run = || {
                session
                    .triangulate_inside(&wrong, &ring, FillRule::EvenOdd)
                    .is_ok()
            };
            panics += usize::from(catch_unwind(AssertUnwindSafe(run)).is_err());
            let (square, sides) = ([[0, 0], [4, 0], [5, 4], [0, 4]], &ring[..3]);
            let sides = [sides, &[[3, 0]]].concat();
            let inside = session.triangulate_inside(&square, &sides, FillRule::EvenOdd);
            assert_eq!(inside, Ok(&[[0, 1, 3], [1, 2, 3]][..]));
        }
        assert!(panics > 0, "{algorithm:?}: no scalar was blamed");
    }
}
