//! Results of other programs: the verifier accepts the right ones and refuses the wrong ones.
//!
//! First answers of other crates to chosen inputs: which are right, and which are known to be wrong. Then their
//! answers to the hard inputs: the verifier must call correct those that are, and no other. Where no four
//! vertices lie on one circle there is only one correct answer, the sweep's, so that a verdict can be checked by
//! comparing lists. `cargo test --release --test peers -- --nocapture` lists the wrong answers; a folder with more
//! inputs may be named in `SWEEP_CDT_HARD`. Each answer is asked for in a process of its own: some never come,
//! and some programs crash.

use std::collections::BTreeMap;
use std::env::{current_exe, var, var_os};
use std::fs;
use std::process::{Command, Stdio};
use std::thread::{self, sleep};
use std::time::{Duration, Instant};

use num_rational::BigRational;
use sweep_cdt::verify::{Verifier, Violation, verify};
use sweep_cdt::{Triangulation, triangulate};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::judge::Reply;
use sweep_cdt_testing::peers::{PROGRAMS, cdt, delaunator, spade};

/// Points on a Weyl sequence: evenly spread, not on a lattice.
fn spread(n: usize) -> Vec<[f64; 2]> {
    let steps = [0.618_033_988_749_894_9, 0.754_877_666_246_692_7];
    (1..=n)
        .map(|i| steps.map(|step| (i as f64 * step).fract()))
        .collect()
}

fn lattice(n: usize) -> Vec<[f64; 2]> {
    (0..n * n)
        .map(|i| [(i % n) as f64, (i / n) as f64])
        .collect()
}

#[test]
fn right_results() {
    for points in [spread(10), spread(3000), lattice(20)] {
        verify(&points, &[], &spade(&points, &[]).unwrap()).unwrap();
        let clockwise = Verifier::new().accept_clockwise(true);
        clockwise
            .verify(&points, &[], &delaunator(&points, &[]).unwrap())
            .unwrap();
    }
    for points in [spread(10), spread(100), lattice(20)] {
        verify(&points, &[], &cdt(&points, &[]).unwrap()).unwrap();
    }
    // Parallel edges, longer than the points are far apart.
    let points = spread(500);
    let edges: Vec<[usize; 2]> = (0..267).map(|i| [i, i + 233]).collect();
    verify(&points, &edges, &spade(&points, &edges).unwrap()).unwrap();
}

/// The three agree up to cocircular points, where each chooses its own way.
#[test]
fn choices() {
    let points = lattice(20);
    let ours: Vec<[usize; 3]> = triangulate(&points, &[]).unwrap().triangles().collect();
    let ours = verify(&points, &[], &ours).unwrap();
    let spades = verify(&points, &[], &spade(&points, &[]).unwrap()).unwrap();
    assert_eq!(ours.cocircular_sides, 19 * 19);
    assert_eq!(spades.cocircular_sides, 19 * 19);
    assert!(ours.is_canonical() && !spades.is_canonical());
}

/// `delaunator` 1 decides the in-circle test in plain doubles, `cdt` 0.1 misses flips.
#[test]
fn wrong_results() {
    let circle: Vec<[f64; 2]> = spread(300)
        .iter()
        .map(|p| (p[0] * std::f64::consts::TAU).sin_cos())
        .map(|(sin, cos)| [3.0 + cos, 5.0 + sin])
        .collect();
    let spread = spread(3000);
    let results = [
        (&circle, delaunator(&circle, &[]).unwrap()),
        (&spread, cdt(&spread, &[]).unwrap()),
    ];
    for (points, result) in results {
        let verifier = Verifier::new().accept_clockwise(true).limit(usize::MAX);
        let violations = verifier.verify(points, &[], &result).unwrap_err();
        let is_caught = |v: &Violation| v.name() == "not-delaunay";
        assert!(violations.list.iter().all(is_caught), "{violations}");
        let rationals: Vec<[BigRational; 2]> = points
            .iter()
            .map(|p| p.map(|x| BigRational::from_float(x).unwrap()))
            .collect();
        let exact = verifier.verify(&rationals, &[], &result).unwrap_err();
        assert_eq!(exact.list, violations.list);
        let ours: Vec<[usize; 3]> = triangulate(points, &[]).unwrap().triangles().collect();
        verify(points, &[], &ours).unwrap();
    }
}

/// How long a program may take for one input.
const PATIENCE: Duration = Duration::from_secs(20);
/// Recursion may go that deep.
const STACK: usize = 64 << 20;
/// Variables of the environment: which program to run in this process, on which input, and where its
/// answer goes.
const PROGRAM: &str = "SWEEP_CDT_PEER";
const INPUT: &str = "SWEEP_CDT_PEER_INPUT";
const ANSWER: &str = "SWEEP_CDT_PEER_ANSWER";

#[test]
fn wrong_answers_and_no_others_are_found() {
    if let Ok(program) = var(PROGRAM) {
        return answer(&program);
    }
    let mut counts = BTreeMap::<(&str, &str), usize>::new();
    for Hard { name, input, .. } in inputs() {
        // What has no triangulation is no question.
        let Ok(ours) = triangulate(&input.points, &input.edges) else {
            continue;
        };
        if ours.is_empty() {
            continue;
        }
        let takes = |takes_edges: &bool| *takes_edges || input.edges.is_empty();
        for (program, _, _) in PROGRAMS.iter().filter(|(_, _, edges)| takes(edges)) {
            let (kind, text) = match ask(program, &input) {
                Ok(triangles) => verdict(&input, &ours, &triangles),
                Err(reason) => ("no answer", reason),
            };
            *counts.entry((program, kind)).or_default() += 1;
            if kind != "correct" {
                println!("{program:10} {name:44} {kind}: {text}");
            }
        }
    }
    for ((program, kind), count) in &counts {
        println!("{program}: {kind} {count}");
    }
    assert!(counts[&("spade", "correct")] >= 50 && counts[&("cdt", "wrong")] >= 5);
}

/// Whether an answer is correct, and what is wrong with it.
fn verdict(
    Input { points, edges }: &Input,
    ours: &Triangulation,
    theirs: &[[usize; 3]],
) -> (&'static str, String) {
    let verifier = Verifier::new().accept_clockwise(true);
    let verdict = verifier.verify(points, edges, theirs);
    let our_triangles: Vec<[usize; 3]> = ours.triangles().collect();
    let report = verifier.verify(points, edges, &our_triangles);
    let report = report.expect("the sweep is right");
    if report.cocircular_sides == 0 {
        let is_same = sorted(ours, &our_triangles) == sorted(ours, theirs);
        assert_eq!(verdict.is_ok(), is_same, "there is one correct answer");
    }
    match verdict {
        Ok(_) => ("correct", String::new()),
        Err(violations) => {
            let name = violations.list[0].name();
            ("wrong", format!("{name}: {violations}"))
        }
    }
}

/// Triangles as sets of vertices, of equal ones the lowest, so that lists can be compared.
fn sorted(ours: &Triangulation, triangles: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let named = |&triangle: &[usize; 3]| {
        let mut corners = triangle.map(|v| ours.representative(v));
        corners.sort_unstable();
        corners
    };
    let mut list: Vec<[usize; 3]> = triangles.iter().map(named).collect();
    list.sort_unstable();
    list
}

/// Asks a program in a process of its own.
fn ask(program: &str, Input { points, edges }: &Input) -> Reply {
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let [question, file] = ["question.json", "answer.json"].map(|name| folder.path().join(name));
    let text = serde_json::to_string(&(points, edges)).expect("finite numbers");
    fs::write(&question, text).expect("it is written");
    let mut child = Command::new(current_exe().expect("a path"))
        .args(["--exact", "wrong_answers_and_no_others_are_found"])
        .env(PROGRAM, program)
        .env(INPUT, question)
        .env(ANSWER, &file)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the process starts");
    let since = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().expect("a process to wait for") {
            break status;
        }
        if since.elapsed() > PATIENCE {
            child.kill().expect("it ends");
            child.wait().expect("it ends");
            return Err(format!("none within {} s", PATIENCE.as_secs()));
        }
        sleep(Duration::from_millis(2));
    };
    match fs::read_to_string(file) {
        Ok(text) => serde_json::from_str(&text).expect("an answer"),
        Err(_) if status.success() => unreachable!("a process that ends well has written"),
        Err(_) if status.code().is_some() => Err("panics".to_owned()),
        Err(_) => Err("crashes".to_owned()),
    }
}

/// Answers in this process.
fn answer(program: &str) {
    let text = fs::read_to_string(var_os(INPUT).expect("an input")).expect("it was written");
    let (points, edges): (Vec<[f64; 2]>, Vec<[usize; 2]>) =
        serde_json::from_str(&text).expect("an input");
    let (_, run, _) = PROGRAMS
        .into_iter()
        .find(|(name, _, _)| *name == program)
        .expect("a program of the list");
    let thread = thread::Builder::new().stack_size(STACK);
    let answer: Reply = thread
        .spawn(move || run(&points, &edges))
        .expect("a thread")
        .join()
        .expect("no panic");
    let text = serde_json::to_string(&answer).expect("it is plain");
    fs::write(var_os(ANSWER).expect("a file"), text).expect("it is written");
}

/// The hard inputs. Two of one name are one input.
fn inputs() -> Vec<Hard> {
    let mut inputs = [Hard::own(), Hard::further()].concat();
    inputs.sort_by(|a, b| a.name.cmp(&b.name));
    inputs.dedup_by(|a, b| a.name == b.name);
    inputs
}
