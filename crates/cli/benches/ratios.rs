//! The time of one way of triangulating beside that of another.
//!
//! `cargo bench -p sweep-cdt-cli --bench ratios [-- ROUNDS [WORD]]` measures these pairs, or those whose names contain `WORD`. The two of
//! a pair take turns, for five rounds unless named. Printed are the medians and the least times, in nanoseconds a
//! point, and the ratio of each. Contour lines are copies of those in `tests/data` side by side, 1.3 million points.
//!
//! * One thread and all threads, on uniform points and on contour lines; the triangles must be the same.
//! * 50 million uniform points and a million. This takes some 6 GB of memory.
//! * Rationals and doubles, of the same values.
//! * The command, which reads a `.poly` and writes an `.ele` and a `.node` where there were none, and the call
//!   that triangulates the same points on one thread.

use std::fmt::Write;
use std::fs;
use std::process::Command;
use std::time::Instant;

use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Bands, Triangulation, Triangulator, triangulate};
use sweep_cdt_testing::{Input, clouds, data};

/// Measures a pair, whose name it gets, in so many rounds.
type Measure = fn(&str, usize);

/// Copies of the contour lines in each direction.
const COPIES: [usize; 2] = [8, 7];

fn main() {
    // Cargo itself adds an argument, `--bench`.
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    let rounds = arguments
        .first()
        .map_or(5, |text| text.parse().expect("a number of rounds"));
    let wanted = arguments.get(1).map_or("", String::as_str);
    println!(
        "{:44} {:>8} {:>8} {:>6} {:>8} {:>8} {:>6}",
        "nanoseconds a point", "medians", "", "ratio", "least", "", "ratio"
    );
    let pairs: [(&str, Measure); 7] = [
        ("one thread, all: uniform 4e6", |name, rounds| {
            compare_threads(name, &clouds::uniform(4_000_000), rounds);
        }),
        ("one thread, all: contours", |name, rounds| {
            compare_threads(name, &contours(), rounds);
        }),
        ("50 million points, a million: uniform", |name, rounds| {
            let inputs = [50_000_000, 1_000_000].map(clouds::uniform);
            let [many, few] = inputs.each_ref().map(|input| move || time(input));
            compare(name, rounds, many, few);
        }),
        ("rationals, doubles: uniform 1e5", |name, rounds| {
            compare_scalars(name, &clouds::uniform(100_000), rounds);
        }),
        ("rationals, doubles: uniform 1e6", |name, rounds| {
            compare_scalars(name, &clouds::uniform(1_000_000), rounds);
        }),
        ("rationals, doubles: contours", |name, rounds| {
            compare_scalars(name, &contours(), rounds);
        }),
        ("command, one thread: contours", |name, rounds| {
            compare_command(name, &contours(), rounds);
        }),
    ];
    for (name, measure) in pairs {
        if name.contains(wanted) {
            measure(name, rounds);
        }
    }
}

fn contours() -> Input {
    data::contours().tiled(COPIES)
}

/// Calls both in turn, each of which returns its nanoseconds a point, and prints what they took.
fn compare(name: &str, rounds: usize, one: impl Fn() -> f64, other: impl Fn() -> f64) {
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..rounds {
        times[0].push(one());
        times[1].push(other());
    }
    for times in &mut times {
        times.sort_by(f64::total_cmp);
    }
    print!("{name:44}");
    for place in [rounds / 2, 0] {
        let [one, other] = [0, 1].map(|which| times[which][place]);
        print!(" {one:>8.0} {other:>8.0} {:>6.2}", one / other);
    }
    println!();
}

/// The nanoseconds a point that a call takes; what it returns is dropped later.
fn timed<T>(points: usize, call: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    let result = call();
    let time = start.elapsed();
    drop(result);
    1e9 * time.as_secs_f64() / points as f64
}

fn time(input: &Input) -> f64 {
    time_of(&input.points, &input.edges)
}

fn time_of<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]]) -> f64 {
    timed(points.len(), || {
        triangulate(points, edges).expect("a valid input")
    })
}

fn compare_threads(name: &str, input: &Input, rounds: usize) {
    let triangulator = Triangulator::new();
    let all = || {
        let result = triangulator.triangulate_parallel(&input.points, &input.edges, Bands::new());
        result.expect("a valid input")
    };
    let sorted = |result: &Triangulation| result.canonical_triangles();
    let one = triangulate(&input.points, &input.edges).expect("a valid input");
    assert_eq!(sorted(&one), sorted(&all()), "{name}");
    drop(one);
    let all_threads = || timed(input.points.len(), all);
    compare(name, rounds, || time(input), all_threads);
}

fn compare_scalars(name: &str, input: &Input, rounds: usize) {
    let rational = |x: f64| BigRational::from_float(x).expect("a finite number");
    let points: Vec<[BigRational; 2]> = (input.points.iter())
        .map(|point| point.map(rational))
        .collect();
    let rationals = || time_of(&points, &input.edges);
    compare(name, rounds, rationals, || time(input));
}

fn compare_command(name: &str, input: &Input, rounds: usize) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("contours.poly");
    fs::write(&file, poly(input)).expect("a file");
    let outputs = ["result.ele", "result.node"].map(|name| folder.path().join(name));
    let command = || {
        let time = timed(input.points.len(), || {
            let command = Command::new(env!("CARGO_BIN_EXE_sweep-cdt"))
                .arg("triangulate")
                .arg(&file)
                .arg("-o")
                .arg(&outputs[0])
                .status();
            assert!(command.expect("a process").success());
        });
        for output in &outputs {
            fs::remove_file(output).expect("what the command has written");
        }
        time
    };
    compare(name, rounds, command, || time(input));
}

fn poly(input: &Input) -> String {
    let mut text = format!("{} 2 0 0\n", input.points.len());
    for (i, [x, y]) in input.points.iter().enumerate() {
        writeln!(text, "{i} {x} {y}").expect("room");
    }
    writeln!(text, "{} 0", input.edges.len()).expect("room");
    for (i, [a, b]) in input.edges.iter().enumerate() {
        writeln!(text, "{i} {a} {b}").expect("room");
    }
    text + "0\n"
}
