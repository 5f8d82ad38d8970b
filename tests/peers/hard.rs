//! The answers of other crates to the hard inputs: the verifier must call correct those that are, and
//! no other.
//!
//! Where no four vertices lie on one circle there is only one correct answer, the sweep's, so that a
//! verdict can be checked by comparing lists. `cargo test --release --test peers -- --nocapture` lists
//! the wrong answers; a folder with more inputs may be named in `SWEEP_CDT_HARD`. Each answer is asked
//! for in a process of its own: some never come, and some programs crash.

use std::collections::BTreeMap;
use std::env::{current_exe, var, var_os};
use std::fs;
use std::process::{Command, Stdio};
use std::thread::{self, sleep};
use std::time::{Duration, Instant};

use sweep_cdt::verify::Verifier;
use sweep_cdt::{Triangulation, triangulate};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::peers::{Answer, PROGRAMS};

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
fn ask(program: &str, Input { points, edges }: &Input) -> Answer {
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let [question, file] = ["question.json", "answer.json"].map(|name| folder.path().join(name));
    let text = serde_json::to_string(&(points, edges)).expect("finite numbers");
    fs::write(&question, text).expect("it is written");
    let mut child = Command::new(current_exe().expect("a path"))
        .args(["--exact", "hard::wrong_answers_and_no_others_are_found"])
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
    let answer: Answer = thread
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
