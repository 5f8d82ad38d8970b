//! This crate's times on one input.

use std::fmt;
use std::time::Instant;

use sweep_cdt::front::{FrontSearch, HashTable, SkipList};
use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Triangulator};
use sweep_cdt_testing::Input;

use super::MEMORY;

/// The sweep alone takes too long on some inputs of more points.
const MOST_SWEPT: usize = 10_000;

/// The measurements of one input.
pub(crate) struct Row {
    /// Nanoseconds a point by the default.
    pub(crate) default: f64,
    skip_list: f64,
    sweep: Option<f64>,
    divide: f64,
    is_divided: bool,
    /// Pierced triangles and vertices on edges, for each point.
    asked: f64,
    bytes: f64,
    /// The time of the verification, as text.
    pub(crate) verified: String,
}

/// Measures the input, whose family has this name.
pub(crate) fn measure(input: &Input, n: usize, name: &str) -> Row {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let (default, is_divided, asked) = time::<HashTable>(input, Algorithm::Auto, 1);
    let bytes = (MEMORY.peak_usage() - before) as f64 / input.points.len() as f64;
    let least = time::<HashTable>(input, Algorithm::Auto, 2).0.min(default);
    let sweep = (n <= MOST_SWEPT).then(|| time::<HashTable>(input, Algorithm::Sweep, 1).0);
    let has_hub = ["star", "asterisk", "edge many times"]
        .iter()
        .any(|word| name.contains(word));
    Row {
        default: least,
        skip_list: time::<SkipList>(input, Algorithm::Auto, 3).0,
        sweep,
        divide: time::<HashTable>(input, Algorithm::DivideAndConquer, 3).0,
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
fn time<F: FrontSearch + Clone + Default>(
    input: &Input,
    algorithm: Algorithm,
    runs: usize,
) -> (f64, bool, f64) {
    let triangulator = Triangulator::new().front(F::default()).algorithm(algorithm);
    let n = input.points.len() as f64;
    let mut least = f64::INFINITY;
    let mut last = (false, 0.0);
    for _ in 0..runs {
        let start = Instant::now();
        let run = triangulator.triangulate_with_stats(&input.points, &input.edges);
        least = least.min(1e9 * start.elapsed().as_secs_f64() / n);
        let run = run.expect("a valid input");
        // Equal edges share their chain, and ask for it once.
        let is_repeated = input.edges.windows(2).any(|pair| pair[0] == pair[1]);
        let listed = if is_repeated { 1 } else { input.edges.len() };
        let passed: usize = (0..listed)
            .map(|e| run.triangulation.edge_chain(e).len().saturating_sub(2))
            .sum();
        let asked = run.stats.counters.pierced as f64 + passed as f64;
        last = (run.stats.is_divided, asked / n);
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
