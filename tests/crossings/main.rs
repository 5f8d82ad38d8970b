//! Edges that cross: all are listed, and split at their crossings, exactly and rounded.
//!
//! Random inputs of the kinds that are hard: small lattices, where many edges cross at one point or overlap; nearly
//! parallel edges; numbers with so few digits that rounding bends edges by much. Each goes through
//! `sweep_cdt_properties::crossings`, which compares with a judge that tries every pair in fractions.
//!
//! `SWEEP_CDT_CROSSINGS=20000 cargo test --release --test crossings -- --nocapture` tries more of them, and
//! prints how far edges moved.

use std::cell::Cell;

use sweep_cdt_properties::crossings::{Rounded, judge};
use sweep_cdt_testing::{Input, Random, minimize};

/// Tried of them, unless `SWEEP_CDT_CROSSINGS` says otherwise.
const CASES: u64 = 150;

/// The kinds of points.
const KINDS: [(&str, fn(&mut Random) -> [f64; 2]); 8] = [
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
    let cases = std::env::var("SWEEP_CDT_CROSSINGS");
    let cases = cases.map_or(CASES, |text| text.parse().expect("a number"));
    let mut most = [Rounded::default(); KINDS.len()];
    let mut crossing = 0;
    for seed in 0..cases {
        let mut random = Random::new(seed);
        let kind = random.below(KINDS.len());
        let input = input(&mut random, kind);
        let found = Cell::default();
        minimize::run(&|input| found.set(judge(input)), &input, seed);
        let (found, most) = (found.get(), &mut most[kind]);
        crossing += u64::from(found.crossings > 0);
        most.crossings = most.crossings.max(found.crossings);
        most.rounds = most.rounds.max(found.rounds);
        most.displacement = most.displacement.max(found.displacement);
    }
    println!("{crossing} of {cases} inputs have edges that cross; at most");
    for ((name, _), most) in KINDS.iter().zip(most) {
        println!("  {name}: {most:?}");
    }
    assert!(
        crossing > cases / 3,
        "edges of only {crossing} inputs cross"
    );
}
