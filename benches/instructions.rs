//! How many instructions the library takes for its tasks, against the numbers of the last recording.
//!
//! `cargo bench -p sweep-cdt-benches --bench instructions` fails if one differs by more than 2 % from benches/instructions.txt;
//! `-- --record` writes that file anew. Instructions are counted by `valgrind`, without which the check says so
//! and passes: first for a process that only makes the input, then for one that does the work too. The
//! difference varies by less than 0.1 %. To compare two commits, copy this file, `Cargo.toml` and `instructions.txt` into
//! the earlier one, record there, and check here.
//!
//! The counts depend on the compiler, on the machine's instructions and a little on the system's library. These stand
//! in the first lines of the file; where they are others, the counts are printed and nothing is compared.

use std::fs;
use std::hint::black_box;
use std::process::{Command, ExitCode};

use num_rational::BigRational;
use sweep_cdt::crossings::crossings;
use sweep_cdt::interior::FillRule;
use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Bands, Stats, Triangulator, Watch};
use sweep_cdt_stream::{Final, Stream, StreamVerifier};
use sweep_cdt_testing::{Input, clouds, data, families, segments};

/// By how much a count may differ.
const TOLERANCE: f64 = 0.02;

const FILE: &str = "benches/instructions.txt";

/// Makes an input, and works on it so many times.
type Work = fn(usize);

const WORKS: [(&str, Work); 16] = [
    ("uniform", |times| {
        triangulated(&clouds::uniform(100_000), times);
    }),
    ("clusters", |times| {
        triangulated(&clouds::clusters(100_000), times);
    }),
    // Five times, as some others, since hash tables with random seeds take up to 1 % more or less.
    ("contours", |times| {
        triangulated(&data::contours(), 5 * times);
    }),
    ("lattice", |times| {
        triangulated(&clouds::shuffled_lattice(100_000), times);
    }),
    ("circle", |times| {
        triangulated(&clouds::circle(100_000), times);
    }),
    ("segments", |times| triangulated(&segments(100_000), times)),
    ("session", session_of_tens),
    ("polygons", polygons_inside),
    ("rationals", rationals),
    ("statistics", |times| {
        worked(&clouds::uniform(100_000), times, |input| {
            let mut stats = Stats::default();
            let watch = Watch::new().stats(&mut stats);
            let result = Triangulator::new().run(&input.points, &input.edges, watch);
            drop(black_box((result.expect("a valid input"), stats)));
        });
    }),
    ("bands", two_bands),
    ("conquered", |times| {
        let triangulator = Triangulator::new().algorithm(Algorithm::DivideAndConquer);
        worked(&clouds::uniform(100_000), times, |input| {
            let result = triangulator.triangulate(&input.points, &input.edges);
            drop(black_box(result.expect("a valid input")));
        });
    }),
    ("verify", verified),
    ("crossings", |times| {
        let input = families::crossed()
            .next()
            .expect("a family")
            .of_edges(20_000);
        worked(&input, times, |input| {
            let found = crossings(&input.points, &input.edges);
            drop(black_box(found.expect("a valid input")));
        });
    }),
    ("stream", streamed),
    ("verified", |times| verified_stream(5 * times)),
];

fn worked(input: &Input, times: usize, work: impl Fn(&Input)) {
    for _ in 0..times {
        work(input);
    }
}

fn triangulated(input: &Input, times: usize) {
    worked(input, times, |input| {
        let result = sweep_cdt::triangulate(&input.points, &input.edges);
        drop(black_box(result.expect("a valid input")));
    });
}

/// Ten thousand inputs of ten points and two edges.
fn session_of_tens(times: usize) {
    let input = clouds::uniform(100_000);
    worked(&input, times, |input| {
        let mut session = Triangulator::new().session();
        for points in input.points.chunks(10) {
            let mut by_y: Vec<usize> = (0..10).collect();
            by_y.sort_unstable_by(|&v, &w| points[v][1].total_cmp(&points[w][1]));
            let edges = [[by_y[0], by_y[1]], [by_y[8], by_y[9]]];
            black_box(
                session
                    .triangulate(points, &edges)
                    .expect("a valid input")
                    .len(),
            );
        }
    });
}

/// Stars of 30 corners.
fn polygons_inside(times: usize) {
    let stars = clouds::uniform(3_000).points;
    let corner = |center: [f64; 2], k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / 30.0;
        let radius = 1.0 + (k % 2) as f64;
        [
            center[0] + radius * angle.cos(),
            center[1] + radius * angle.sin(),
        ]
    };
    let points = |&center: &[f64; 2]| (0..30).map(|k| corner(center, k)).collect::<Vec<_>>();
    let stars: Vec<Vec<[f64; 2]>> = stars.iter().map(points).collect();
    let edges: Vec<[usize; 2]> = (0..30).map(|k| [k, (k + 1) % 30]).collect();
    for _ in 0..times {
        let mut session = Triangulator::new().session();
        for points in &stars {
            let inside = session.triangulate_inside(points, &edges, FillRule::EvenOdd);
            black_box(inside.expect("a valid input").len());
        }
    }
}

fn rationals(times: usize) {
    let input = clouds::uniform(5_000);
    let fraction =
        |x: f64| BigRational::from_float(x).expect("finite") / BigRational::from_integer(3.into());
    let points: Vec<_> = input.points.iter().map(|p| p.map(fraction)).collect();
    for _ in 0..times {
        let result = sweep_cdt::triangulate(&points, &[]);
        drop(black_box(result.expect("a valid input")));
    }
}

/// In two bands, on one thread.
fn two_bands(times: usize) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("a pool");
    worked(&clouds::uniform(100_000), times, |input| {
        let result = pool.install(|| {
            let bands = Bands::new().count(2);
            Triangulator::new().triangulate_parallel(&input.points, &input.edges, bands)
        });
        drop(black_box(result.expect("a valid input")));
    });
}

fn verified(times: usize) {
    let input = segments(100_000);
    let result = sweep_cdt::triangulate(&input.points, &input.edges).expect("a valid input");
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    worked(&input, times, |input| {
        let report = verify(&input.points, &input.edges, &triangles);
        black_box(report.expect("a right result"));
    });
}

/// Points in the order of the sweep.
fn ordered() -> Input {
    let mut input = clouds::uniform(100_000);
    input
        .points
        .sort_unstable_by(|p, q| p[1].total_cmp(&q[1]).then(p[0].total_cmp(&q[0])));
    input
}

/// The triangles in the order in which they are final.
fn stream(input: &Input) -> Vec<[u64; 3]> {
    let mut triangles = Vec::new();
    let mut stream = Stream::new(Triangulator::new(), |found| {
        if let Final::Triangle { corners, .. } = found {
            triangles.push(corners);
        }
    });
    for (number, point) in (0..).zip(&input.points) {
        stream.push(number, *point).expect("an ordered point");
    }
    stream.finish().expect("a valid input");
    triangles
}

fn streamed(times: usize) {
    worked(&ordered(), times, |input| drop(black_box(stream(input))));
}

/// As `verify --stream` does it: a point comes when a triangle names it.
fn verified_stream(times: usize) {
    let input = ordered();
    let triangles = stream(&input);
    worked(&input, times, |input| {
        let mut verifier = StreamVerifier::new();
        let mut points = (0..).zip(&input.points);
        for &corners in &triangles {
            let most = corners.into_iter().max().expect("three corners");
            while !verifier.has_vertex(most) {
                let (number, &point) = points.next().expect("a vertex to come");
                verifier.vertex(number, point).expect("a new vertex");
            }
            let judged = verifier.triangle(corners, None);
            judged.expect("a right triangle");
        }
        black_box(verifier.finish().expect("all triangles"));
    });
}

fn main() -> ExitCode {
    // Cargo itself adds an argument, `--bench`.
    let arguments = std::env::args().skip(1);
    let arguments: Vec<String> = arguments.filter(|text| text != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => check(false),
        ["--record"] => check(true),
        ["run", name, times] => {
            run(name, times.parse().expect("a number"));
            ExitCode::SUCCESS
        }
        _ => panic!("unknown arguments: {arguments:?}"),
    }
}

/// The work that is counted.
fn run(name: &str, times: usize) {
    let work = WORKS.iter().find(|(other, _)| *other == name);
    work.expect("a name of some work").1(times);
}

fn check(is_recording: bool) -> ExitCode {
    let Some(place) = place() else {
        println!("not checked: there is no valgrind");
        return ExitCode::SUCCESS;
    };
    let path = data::path(FILE);
    let recorded = fs::read_to_string(&path).unwrap_or_default();
    let is_compared = !is_recording && recorded.starts_with(&place);
    let mut text = place.clone();
    let mut is_good = true;
    for (name, _) in WORKS {
        let count = count(name, 1) - count(name, 0);
        text.push_str(&format!("{name} {count}\n"));
        let old = recorded
            .lines()
            .find_map(|line| line.strip_prefix(name)?.trim().parse::<f64>().ok());
        let change = old.map_or(f64::NAN, |old| count as f64 / old - 1.0);
        println!("{name:10} {count:>12} {:>+7.2} %", 100.0 * change);
        is_good &= change.abs() <= TOLERANCE;
    }
    if is_recording {
        fs::write(path, text).expect("a file for the counts");
    } else if !is_compared {
        println!("not checked: {FILE} was recorded elsewhere; here it would begin\n{place}");
    } else if !is_good {
        println!(
            "more than 2 % from {FILE}; if it is meant: cargo bench -p sweep-cdt-benches --bench instructions -- --record"
        );
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// The instructions of a process that does some work so many times.
fn count(name: &str, times: usize) -> u64 {
    let this = std::env::current_exe().expect("this program");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args(["run", name, &times.to_string()])
        .output()
        .expect("valgrind");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}");
    let count = text
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    let count = count.and_then(|(_, count)| count.trim().parse().ok());
    count.unwrap_or_else(|| panic!("no count of instructions in\n{text}"))
}

/// The place of the counts, a line each for the compiler, the machine, the system's library and valgrind; none without
/// valgrind.
fn place() -> Option<String> {
    let valgrind = first_line("valgrind", "--version")?;
    let compiler = first_line("rustc", "--version").unwrap_or_default();
    let library = first_line("ldd", "--version").unwrap_or_default();
    let machine = std::env::consts::ARCH;
    Some(format!(
        "# {compiler}\n# {machine}{}\n# {library}\n# {valgrind}\n",
        extensions()
    ))
}

/// The extensions that the libraries choose their code by, as far as valgrind has them.
fn extensions() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        return " with avx2";
    }
    ""
}

/// The first line that a command prints, if there is such a command.
fn first_line(command: &str, argument: &str) -> Option<String> {
    let output = Command::new(command).arg(argument).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().next().map(str::to_owned)
}
