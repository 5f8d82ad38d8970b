//! Other programs on the same inputs: spade, and CGAL where it can be compiled.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};
use sweep_cdt_testing::{Input, binary, families};

/// How long another program may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// How often another program runs.
const RUNS: usize = 3;

/// Nanoseconds a point of another program, the least of three runs; printed as what it is where there are
/// none. Each program runs in a process of its own, which is stopped when it takes too long.
#[derive(Clone, Copy)]
pub(crate) enum Time {
    Least(f64),
    TooLong,
    /// The program refuses the input, or is not installed.
    None,
}

/// Runs spade in this process on a member of a family, and prints the nanoseconds.
pub(crate) fn run_spade(family: &str, n: usize) {
    let mut families = families::all().chain(families::slanted());
    let family = families.find(|other| other.name == family);
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
pub(crate) fn time_spade(family: &str, n: usize) -> Time {
    let this = std::env::current_exe().expect("this program");
    let arguments = ["spade", family, &n.to_string()].map(str::to_owned);
    time_process(Command::new(this).args(arguments), n)
}

/// The time of CGAL.
pub(crate) fn time_cgal(program: Option<&Path>, input: &Input) -> Time {
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
pub(crate) fn columns(theirs: [Time; 2], ours: f64) -> String {
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
