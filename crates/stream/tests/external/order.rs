//! The order of points and edges, for many runs of points that are hard to sort.

use sweep_cdt_stream::external::Sorting;

use crate::{Made, Random, check};

/// Little memory: 2,343 points or 625 edges are a run.
const LITTLE: u64 = 200_000;

/// A kind of points: the point of a number.
type Kind = fn(u64, &mut Random) -> [f64; 2];

/// Kinds of points, of which equal ones and equal y are the hardest.
const KINDS: [(&str, Kind); 12] = [
    ("uniform", |_, random| [random.share(), random.share()]),
    ("equal", |_, _| [3.5, -2.5]),
    ("one row", |_, random| [random.share(), 7.0]),
    ("one column", |_, random| [7.0, random.share()]),
    ("in order", |at, _| [0.0, at as f64]),
    ("reversed", |at, _| [0.0, -(at as f64)]),
    ("a row, reversed", |at, _| [-(at as f64), 1.0]),
    ("a few places", |_, random| {
        [random.below(3) as f64, random.below(3) as f64]
    }),
    ("a lattice", |at, _| {
        [(at % 64) as f64, (at / 64 % 64) as f64]
    }),
    ("all magnitudes", |_, random| {
        let sign = [-1.0, 1.0][usize::from(random.below(2) == 0)];
        let value =
            |random: &mut Random| f64::from_bits(random.below(0x7fe) << 52 | random.below(1 << 40));
        [sign * value(random), -sign * value(random)]
    }),
    ("extremes", |_, random| {
        let values = [
            f64::MAX,
            f64::MIN,
            0.0,
            -0.0,
            5e-324,
            -5e-324,
            1.0,
            f64::MIN_POSITIVE,
        ];
        let mut value = || values[usize::try_from(random.below(8)).expect("below 8")];
        [value(), value()]
    }),
    ("powers", |_, random| {
        let value = random.share();
        [random.share(), value.powi(40)]
    }),
];

/// Edges between random points, some of them between equal ones.
fn random_edges(count: u64, points: u64, random: &mut Random) -> Vec<[u64; 2]> {
    (0..count)
        .map(|_| [random.below(points), random.below(points)])
        .collect()
}

#[test]
fn many_runs_come_in_the_order_of_a_plain_sort() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, kind) in KINDS {
        println!("{name}");
        let mut random = Random(42);
        let points: Vec<[f64; 2]> = (0..20_000).map(|at| kind(at, &mut random)).collect();
        let edges = random_edges(4000, 20_000, &mut random);
        check(&points, &edges, LITTLE, folder.path());
    }
}

#[test]
fn one_run_comes_in_the_order_of_a_plain_sort() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, kind) in KINDS {
        println!("{name}");
        let mut random = Random(43);
        let points: Vec<[f64; 2]> = (0..20_000).map(|at| kind(at, &mut random)).collect();
        let edges = random_edges(4000, 20_000, &mut random);
        check(&points, &edges, 1 << 30, folder.path());
    }
}

#[test]
fn every_small_number_of_points_is_sorted() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(44);
    // With this memory 109 points are a run.
    for count in 0..50 {
        let points: Vec<[f64; 2]> = (0..count)
            .map(|_| [random.below(5) as f64, random.below(5) as f64])
            .collect();
        check(&points, &[], 13 * 72 * 10, folder.path());
        if count > 0 {
            let edges = random_edges(count, count, &mut random);
            check(&points, &edges, 200_000, folder.path());
        }
    }
}

/// Edges that join neighbours, all edges of one point, and edges of which all but one end at the last point.
#[test]
fn edges_of_every_locality_are_joined() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(45);
    let points: Vec<[f64; 2]> = (0..20_000)
        .map(|_| [random.share(), random.share()])
        .collect();
    let chain: Vec<[u64; 2]> = (0..4000).map(|at| [at * 5 + 1, at * 5]).collect();
    let star: Vec<[u64; 2]> = (0..4000).map(|at| [7, at * 5]).collect();
    let last: Vec<[u64; 2]> = (0..4000).map(|at| [at * 5, 19_999]).collect();
    // Batches of the order end early where points have so many edges.
    let repeated: Vec<[u64; 2]> = (0..20_000)
        .map(|at| [at / 10 * 3 + 1, at / 10 * 3])
        .collect();
    let back: Vec<[u64; 2]> = (0..4000).map(|at| [19_999 - at, at]).collect();
    for edges in [
        chain,
        star,
        last,
        back,
        repeated,
        vec![[5, 5]; 4000],
        vec![[3, 19_000]; 4000],
    ] {
        check(&points, &edges, LITTLE, folder.path());
        check(&points, &edges, 1 << 30, folder.path());
    }
}

#[test]
fn statistics_tell_what_was_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(46);
    let points: Vec<[f64; 2]> = (0..20_000)
        .map(|_| [random.share(), random.share()])
        .collect();
    let mut input = Made::new(points, Vec::new());
    let mut order = Sorting::new(LITTLE, folder.path())
        .sort(&mut input)
        .expect("no fault");
    while order.next_vertex().expect("no fault").is_some() {}
    let statistics = order.statistics();
    assert_eq!((statistics.runs, statistics.edge_runs), (9, 1));
    assert_eq!((statistics.written, statistics.read), (400_000, 400_000));
}

/// A name in the folder would be left behind where a signal ends the process.
#[test]
fn temporary_files_have_no_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(47);
    let points: Vec<[f64; 2]> = (0..20_000)
        .map(|_| [random.share(), random.share()])
        .collect();
    let edges = random_edges(4000, 20_000, &mut random);
    let mut input = Made::new(points, edges);
    let mut order = Sorting::new(LITTLE, folder.path())
        .sort(&mut input)
        .expect("no fault");
    order.next_vertex().expect("no fault").expect("a vertex");
    assert!(order.statistics().written > 400_000);
    #[cfg(unix)]
    assert_eq!(
        std::fs::read_dir(folder.path()).expect("a folder").count(),
        0
    );
    drop(order);
    assert_eq!(
        std::fs::read_dir(folder.path()).expect("a folder").count(),
        0
    );
}
