//! Edges that cross: all are listed, and split at their crossings, exactly and rounded.
//!
//! Random inputs of the kinds that are hard: small lattices, where many edges cross at one point or overlap; nearly
//! parallel edges; numbers with so few digits that rounding bends edges by much. Each goes through
//! `sweep_cdt_properties::crossings`, which compares with a judge that tries every pair in fractions.
//!
//! `SWEEP_CDT_CROSSINGS=20000 cargo test --release --manifest-path fuzz/Cargo.toml --package sweep-cdt-properties --test crossings -- --nocapture` goes on until so many inputs had
//! edges that cross, and prints how far edges moved. `SWEEP_CDT_SEED` says where they begin.

use std::cell::Cell;
use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::{Exact, SplitError, crossings, split};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, triangulate};
use sweep_cdt_properties::crossings::{Rounded, judge};
use sweep_cdt_testing::{Input, Random, minimize};

/// So many inputs with edges that cross are tried, unless `SWEEP_CDT_CROSSINGS` says otherwise.
const CASES: u64 = 80;
/// At least one of so many inputs has such edges.
const RARELY: u64 = 3;

/// A kind of points, and its name.
type Kind = (&'static str, fn(&mut Random) -> [f64; 2]);

const KINDS: [Kind; 8] = [
    ("lattice", |random| [random.integer(3), random.integer(3)]),
    ("thirds", |random| {
        [random.integer(6) / 3.0, random.integer(6) / 7.0]
    }),
    ("uniform", |random| [random.unit(), random.unit()]),
    ("nearly parallel", |random| {
        let x = random.integer(4);
        [x, x + random.integer(3) * f64::EPSILON]
    }),
    ("few lines", |random| {
        let x = random.integer(5);
        [x, random.pick(&[0.0, 1.0, -1.0, 0.5]) * x]
    }),
    ("few digits", |random| {
        // The doubles here are the whole numbers.
        [0, 1].map(|_| 2f64.powi(52) + 20.0 + random.integer(20))
    }),
    ("subnormal", |random| {
        [random.integer(9), random.integer(9)].map(|x| x * 5e-324)
    }),
    ("all sizes", |random| {
        [0, 1].map(|_| {
            let size = random.pick(&[1e-300, 1e-40, 1e-3, 1.0, 1e3, 1e40, 1e300]);
            random.integer(5) * size
        })
    }),
];

/// Edges among few points of a kind; every third time they all go through one point.
fn input(random: &mut Random, kind: usize) -> Input {
    let point = KINDS[kind].1;
    let mut input = Input::default();
    if random.one_in(3) {
        let [x, y] = point(random);
        for _ in 0..2 + random.below(6) {
            let [dx, dy] = point(random).map(|x| x / 8.0);
            let back = random.pick(&[1.0, 2.0, 0.5]);
            let first = input.points.len();
            input.points.push([x + dx, y + dy]);
            input.points.push([x - back * dx, y - back * dy]);
            input.edges.push([first, first + 1]);
        }
        return input;
    }
    let count = 4 + random.below(9);
    input.points.extend((0..count).map(|_| point(random)));
    for _ in 0..2 + random.below(9) {
        input.edges.push([random.below(count), random.below(count)]);
    }
    input
}

#[test]
fn random_edges_are_listed_and_split() {
    let number = |variable: &str, default: u64| {
        let given = std::env::var(variable);
        given.map_or(default, |text| text.parse().expect(variable))
    };
    let cases = number("SWEEP_CDT_CROSSINGS", CASES);
    let first = number("SWEEP_CDT_SEED", 0);
    let mut most = [Rounded::default(); KINDS.len()];
    let (mut tried, mut crossing) = (0, 0);
    while crossing < cases && tried < RARELY * cases {
        let seed = first + tried;
        let mut random = Random::new(seed);
        let kind = random.below(KINDS.len());
        let input = input(&mut random, kind);
        let found = Cell::default();
        minimize::run(&|input| found.set(judge(input)), &input, seed);
        let (found, most) = (found.get(), &mut most[kind]);
        tried += 1;
        crossing += u64::from(found.crossings > 0);
        most.crossings = most.crossings.max(found.crossings);
        most.rounds = most.rounds.max(found.rounds);
        most.displacement = most.displacement.max(found.displacement);
    }
    println!("{crossing} of {tried} inputs have edges that cross; at most");
    for ((name, _), most) in KINDS.iter().zip(most) {
        println!("  {name}: {most:?}");
    }
    assert_eq!(crossing, cases, "inputs with edges that cross (left)");
}

#[test]
fn many_edges_through_one_point_give_one_vertex() {
    let ends = |i: u32| [[0.0, f64::from(i)], [3.0, 7.0 - f64::from(i)]];
    let mut points: Vec<[f64; 2]> = (0..8).flat_map(ends).collect();
    let edges: Vec<[usize; 2]> = (0..8).map(|e| [2 * e, 2 * e + 1]).collect();
    assert_eq!(crossings(&points, &edges).expect("valid").len(), 28);
    let found = split(&points, &edges).expect("valid");
    assert_eq!(found.points[16..], [[1.5, 3.5]]);
    assert_eq!((found.edges.len(), found.displacement), (16, 0.0));
    // Where the point is a vertex, nothing crosses, and nothing is split.
    points.push([1.5, 3.5]);
    assert_eq!(crossings(&points, &edges), Ok(Vec::new()));
    let found = split(&points, &edges).expect("valid");
    assert_eq!((found.edges, found.rounds), (edges, 0));
}

#[test]
fn all_edges_among_the_points_of_a_lattice_are_split() {
    // Tenths are not doubles, and the spacing of doubles changes among them.
    for [from, step] in [
        [0.0, 0.1],
        [0.9, 0.1],
        [2f64.powi(52), 9.0],
        [-1e-3, 1.0 / 1700.0],
    ] {
        let at = |i: u32| from + f64::from(i) * step;
        let points: Vec<_> = (0..16).map(|i| [at(i % 4), at(i / 4)]).collect();
        let edges: Vec<_> = (0..16).flat_map(|w| (0..w).map(move |v| [v, w])).collect();
        let split = split(&points, &edges).expect("few rounds");
        let result = triangulate(&split.points, &split.edges).expect("no pieces cross");
        assert!(
            result
                .with_points(&split.points)
                .verify(&split.edges)
                .is_ok()
        );
        println!(
            "{from} {step}: {} pieces, {} rounds, {} units",
            split.edges.len(),
            split.rounds,
            split.displacement
        );
        assert!(
            split.rounds <= 2 && split.points.len() > 100,
            "{from} {step}"
        );
    }
}

#[test]
fn what_is_wrong_is_named() {
    let points = [[0.0, 0.0], [1.0, f64::NAN]];
    let vertex = SplitError::Input(Error::NonFiniteCoordinate { vertex: 1 });
    assert_eq!(crossings(&points, &[[0, 0]]), Err(vertex));
    assert_eq!(split(&points, &[[0, 0]]).unwrap_err(), vertex);
    let missing = SplitError::Input(Error::EdgeOutOfRange { edge: 1, vertex: 9 });
    assert_eq!(crossings(&points[..1], &[[0, 0], [0, 9]]), Err(missing));
    assert_eq!(split(&points[..1], &[[0, 0], [0, 9]]).unwrap_err(), missing);
}

/// A double that is wrong about what is rounded to it: nothing but itself.
#[derive(Clone, Debug)]
struct Wrong(f64);

impl Scalar for Wrong {
    fn approx(&self) -> f64 {
        self.0
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.compare(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(|point| point.each_ref().map(Scalar::approx));
        f64::orient2d(&a, &b, &c)
    }

    fn in_circle(_: &[Self; 2], _: &[Self; 2], _: &[Self; 2], _: &[Self; 2]) -> Ordering {
        unreachable!("nothing is triangulated")
    }
}

impl Exact for Wrong {
    fn to_fraction(&self) -> BigRational {
        self.0.to_fraction()
    }

    fn nearest(fraction: &BigRational) -> Wrong {
        Wrong(f64::nearest(fraction))
    }

    fn around(&self) -> [Wrong; 2] {
        [self.clone(), self.clone()]
    }
}

#[test]
fn rounding_that_does_not_end_is_an_error() {
    let points = [[0.0, 0.0], [3.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|p| p.map(Wrong));
    let outcome = split(&points, &[[0, 1], [2, 3]]);
    assert_eq!(
        outcome.unwrap_err(),
        SplitError::TooManyRounds { limit: 100 }
    );
}
