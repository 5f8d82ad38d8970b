//! How time and memory grow with the number of points on inputs that are made to be hard, and other programs
//! on the same inputs.
//!
//! `cargo bench --manifest-path benches/peers/Cargo.toml --bench growth [-- [slanted] [MOST [FAMILY]]]` goes up to
//! `MOST` points (a million unless named), with the families of `sweep_cdt_testing::families` whose names contain
//! `FAMILY`. Printed are, for each number of points:
//!
//! * nanoseconds a point, the least of three runs: by the default with the hash table and with the skip
//!   list, by the sweep alone up to 10,000 points, and by divide and conquer; `*` marks a sweep that was
//!   abandoned;
//! * what the input asks for beyond its points: pierced triangles and vertices on edges, for each point;
//! * bytes a point at the peak, beyond the input;
//! * at 100,000 points the time of spade and of CGAL (compiled here, where `c++` finds its headers), and the
//!   default's time divided by that of the faster one;
//! * for stars and asterisks the time of the verification.
//!
//! A second table has the families whose edges some order makes quadratic; after the word `slanted` it is the only
//! one.

#[path = "../src/cgal.rs"]
mod cgal;
mod others;
mod slanted;

use std::fmt;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

use others::{columns, run_spade, time_cgal, time_spade};
use peak_alloc::PeakAlloc;
use sweep_cdt::front::{FrontSearch, SkipList};
use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Stats, Triangulator, Watch};
use sweep_cdt_testing::{Input, families};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The number of points at which other programs run.
const COMPARED: usize = 100_000;

fn main() {
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    if let [command, family, n] = &arguments[..]
        && command == "spade"
    {
        return run_spade(family, n.parse().expect("a number of points"));
    }
    let (is_slanted_only, arguments) = match arguments.split_first() {
        Some((word, others)) if word == "slanted" => (true, others),
        _ => (false, &arguments[..]),
    };
    let most = arguments
        .first()
        .map_or(1_000_000, |text| text.parse().expect("a number of points"));
    let wanted = arguments.get(1).map_or("", String::as_str);
    let folder = tempfile::tempdir().expect("a folder");
    let cgal = cgal::compile(folder.path());
    if !is_slanted_only {
        print(most, wanted, cgal.as_deref());
    }
    slanted::print(most, wanted, cgal.as_deref());
}

/// Prints the table of all families.
fn print(most: usize, wanted: &str, cgal: Option<&Path>) {
    println!(
        "{:40} {:>8} {:>8} {:>9} {:>8} {:>8} {:>7} {:>7} {:>8} {:>8} {:>6} {:>8}",
        "nanoseconds a point",
        "points",
        "hash",
        "skip list",
        "sweep",
        "divide",
        "asked",
        "bytes",
        "spade",
        "CGAL",
        "ratio",
        "verified"
    );
    for family in families::all().filter(|family| family.name.contains(wanted)) {
        for n in [10_000, 100_000, 1_000_000, 10_000_000] {
            if n <= most {
                let input = families::scattered(&(family.member)(n));
                let row = measure(&input, n, family.name);
                print!("{:40} {:>8} {row}", family.name, input.points.len());
                if n == COMPARED {
                    let spade = time_spade(family.name, n);
                    let theirs = [spade, time_cgal(cgal, &input)];
                    print!("{}", columns(theirs, row.default));
                } else {
                    print!(" {:>8} {:>8} {:>6}", "", "", "");
                }
                println!(" {}", row.verified);
                std::io::stdout().flush().expect("standard output");
            }
        }
    }
}

/// The sweep alone takes too long on some inputs of more points.
const MOST_SWEPT: usize = 10_000;

/// The measurements of this crate on one input.
struct Row {
    /// Nanoseconds a point by the default.
    default: f64,
    skip_list: f64,
    sweep: Option<f64>,
    divide: f64,
    is_divided: bool,
    /// Pierced triangles and vertices on edges, for each point.
    asked: f64,
    bytes: f64,
    /// The time of the verification, as text.
    verified: String,
}

/// Measures the input, whose family has this name.
fn measure(input: &Input, n: usize, name: &str) -> Row {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let (default, is_divided, asked) = time_ours(input, Algorithm::Auto, None, 1);
    let bytes = (MEMORY.peak_usage() - before) as f64 / input.points.len() as f64;
    let least = time_ours(input, Algorithm::Auto, None, 2).0.min(default);
    let sweep = (n <= MOST_SWEPT).then(|| time_ours(input, Algorithm::Sweep, None, 1).0);
    let has_hub = ["star", "asterisk", "edge many times"]
        .iter()
        .any(|word| name.contains(word));
    Row {
        default: least,
        skip_list: time_ours(input, Algorithm::Auto, Some(&mut SkipList::default()), 3).0,
        sweep,
        divide: time_ours(input, Algorithm::DivideAndConquer, None, 3).0,
        is_divided,
        asked,
        bytes,
        verified: if has_hub {
            verified(input)
        } else {
            String::new()
        },
    }
}

/// The least of so many runs, whether the last one was divided, and what the input asked for.
fn time_ours(
    input: &Input,
    algorithm: Algorithm,
    mut front: Option<&mut dyn FrontSearch>,
    runs: usize,
) -> (f64, bool, f64) {
    let triangulator = Triangulator::new().algorithm(algorithm);
    let n = input.points.len() as f64;
    let mut least = f64::INFINITY;
    let mut last = (false, 0.0);
    for _ in 0..runs {
        let start = Instant::now();
        let mut stats = Stats::default();
        let mut watch = Watch::new().stats(&mut stats);
        if let Some(front) = &mut front {
            watch = watch.front(&mut **front);
        }
        let result = triangulator.run(&input.points, &input.edges, watch);
        least = least.min(1e9 * start.elapsed().as_secs_f64() / n);
        let result = result.expect("a valid input");
        // Equal edges share their chain, and ask for it once.
        let is_repeated = input.edges.windows(2).any(|pair| pair[0] == pair[1]);
        let listed = if is_repeated { 1 } else { input.edges.len() };
        let passed: usize = (0..listed)
            .map(|e| result.edge_chain(e).len().saturating_sub(2))
            .sum();
        let asked = stats.counters.pierced as f64 + passed as f64;
        last = (stats.is_divided, asked / n);
    }
    (least, last.0, last.1)
}

/// How long the verification takes.
fn verified(input: &Input) -> String {
    let result = sweep_cdt::triangulate(&input.points, &input.edges).expect("a valid input");
    let triangles: Vec<_> = result.triangles().collect();
    let start = Instant::now();
    let report = verify(&input.points, &input.edges, &triangles);
    let time = 1e9 * start.elapsed().as_secs_f64() / input.points.len() as f64;
    assert!(report.is_ok(), "the result is refused");
    format!("{time:8.0}")
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mark = if self.is_divided { "*" } else { "" };
        let default = format!("{:.0}{mark}", self.default);
        let sweep = self
            .sweep
            .map_or(String::new(), |time| format!("{time:.0}"));
        write!(
            f,
            "{default:>8} {:>9.0} {sweep:>8} {:>8.0} {:>7.2} {:>7.0}",
            self.skip_list, self.divide, self.asked, self.bytes
        )
    }
}
