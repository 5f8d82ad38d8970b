//! How time and memory grow with the number of points on inputs that are made to be hard, and other programs
//! on the same inputs.
//!
//! `cargo run --release --manifest-path benches/peers/Cargo.toml --bin growth [-- MOST [FAMILY]]` goes up to `MOST` points (a million unless named), with the
//! families of `sweep_cdt_testing::families` whose names contain `FAMILY`. Printed are, for each number of
//! points:
//!
//! * nanoseconds a point, the least of three runs: by the default with the hash table and with the skip
//!   list, by the sweep alone up to 10,000 points, and by divide and conquer; `*` marks a sweep that was
//!   abandoned;
//! * what the input asks for beyond its points: pierced triangles and vertices on edges, for each point;
//! * bytes a point at the peak, beyond the input;
//! * at 100,000 points the time of spade and of CGAL (compiled here, where `c++` finds its headers), and the
//!   default's time divided by that of the faster one;
//! * for stars and asterisks the time of the verification.

use std::fmt;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use peak_alloc::PeakAlloc;
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};
use sweep_cdt::front::{FrontSearch, HashTable, SkipList};
use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Triangulator};
use sweep_cdt_testing::{Input, binary, families};

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
    let most = arguments
        .first()
        .map_or(1_000_000, |text| text.parse().expect("a number of points"));
    let wanted = arguments.get(1).map_or("", String::as_str);
    let cgal = compile_cgal();

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
                    let theirs = [spade, time_cgal(cgal.as_deref(), &input)];
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
    let (default, is_divided, asked) = time_ours::<HashTable>(input, Algorithm::Auto, 1);
    let bytes = (MEMORY.peak_usage() - before) as f64 / input.points.len() as f64;
    let least = time_ours::<HashTable>(input, Algorithm::Auto, 2)
        .0
        .min(default);
    let sweep = (n <= MOST_SWEPT).then(|| time_ours::<HashTable>(input, Algorithm::Sweep, 1).0);
    let has_hub = ["star", "asterisk", "edge many times"]
        .iter()
        .any(|word| name.contains(word));
    Row {
        default: least,
        skip_list: time_ours::<SkipList>(input, Algorithm::Auto, 3).0,
        sweep,
        divide: time_ours::<HashTable>(input, Algorithm::DivideAndConquer, 3).0,
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
fn time_ours<F: FrontSearch + Clone + Default>(
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

/// How long another program may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// How often another program runs.
const RUNS: usize = 3;

/// Nanoseconds a point of another program, the least of three runs; printed as what it is where there are
/// none. Each program runs in a process of its own, which is stopped when it takes too long.
#[derive(Clone, Copy)]
enum Time {
    Least(f64),
    TooLong,
    /// The program refuses the input, or is not installed.
    None,
}

/// Runs spade in this process on a member of a family, and prints the nanoseconds.
fn run_spade(family: &str, n: usize) {
    let family = families::all().find(|other| other.name == family);
    let input = families::scattered(&(family.expect("a family").member)(n));
    let points: Vec<_> = (input.points.iter())
        .map(|&[x, y]| Point2::new(x, y))
        .collect();
    for _ in 0..RUNS {
        let (points, edges) = (points.clone(), input.edges.clone());
        let start = Instant::now();
        let faces = if edges.is_empty() {
            let result = DelaunayTriangulation::<Point2<f64>>::bulk_load(points);
            result.map(|result| result.num_inner_faces())
        } else {
            let result =
                ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges);
            result.map(|result| result.num_inner_faces())
        };
        let time = start.elapsed();
        faces.expect("an input that spade accepts");
        println!("{}", time.as_nanos());
    }
}

/// The time of [`run_spade`], in a process of its own.
fn time_spade(family: &str, n: usize) -> Time {
    let this = std::env::current_exe().expect("this program");
    let arguments = ["spade", family, &n.to_string()].map(str::to_owned);
    time_process(Command::new(this).args(arguments), n)
}

/// Compiles the program that calls CGAL, if `c++` and CGAL are there.
fn compile_cgal() -> Option<PathBuf> {
    let program = std::env::temp_dir().join("sweep-cdt-growth-cgal");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("cgal.cpp");
    let compiled = Command::new("c++")
        .args(["-O2", "-DNDEBUG", "-frounding-math", "-o"])
        .args([&program, &source])
        .args(["-lgmp", "-lmpfr"])
        .stderr(Stdio::null())
        .status();
    compiled
        .is_ok_and(|status| status.success())
        .then_some(program)
}

/// The time of CGAL.
fn time_cgal(program: Option<&Path>, input: &Input) -> Time {
    let Some(program) = program else {
        return Time::None;
    };
    let path = std::env::temp_dir().join("sweep-cdt-growth-input");
    binary::write_inputs(&path, std::slice::from_ref(input)).expect("a file for the input");
    let mut command = Command::new(program);
    time_process(command.arg(path).arg(RUNS.to_string()), input.points.len())
}

/// Runs a program that prints the nanoseconds of its runs, one a line, and waits for it.
fn time_process(command: &mut Command, points: usize) -> Time {
    let command = command.stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().expect("a process");
    let start = Instant::now();
    loop {
        match child.try_wait().expect("a process") {
            Some(status) if status.success() => break,
            Some(_) => return Time::None,
            None if start.elapsed() > PATIENCE => {
                child.kill().expect("a process");
                child.wait().expect("a process");
                return Time::TooLong;
            }
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    }
    let output = child.wait_with_output().expect("a process");
    let text = String::from_utf8_lossy(&output.stdout);
    let least = (text.lines())
        .filter_map(|line| line.split_whitespace().next()?.parse().ok())
        .fold(f64::INFINITY, f64::min);
    Time::Least(least / points as f64)
}

/// Both times, and ours divided by the lesser one.
fn columns(theirs: [Time; 2], ours: f64) -> String {
    let [spade, cgal] = theirs.map(|time| match time {
        Time::Least(time) => format!("{time:.0}"),
        Time::TooLong => "too long".to_owned(),
        Time::None => "-".to_owned(),
    });
    let least = theirs.iter().filter_map(|time| match time {
        Time::Least(time) => Some(*time),
        _ => None,
    });
    let ratio = least
        .min_by(f64::total_cmp)
        .map_or(String::new(), |least| format!("{:.2}", ours / least));
    format!(" {spade:>8} {cgal:>8} {ratio:>6}")
}
