//! Random inputs: small degenerate ones against the oracle, larger ones against its local tests; and the oracle
//! itself against its local tests.
//!
//! Each input goes through the default run and one other, which changes from input to input; about
//! every hundredth small one through all.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use sweep_cdt::triangulate;
use sweep_cdt_testing::generators::{medium, small};
use sweep_cdt_testing::oracle::{Verdict, check, check_found, verdict};
use sweep_cdt_testing::{Input, Random, minimize};

use crate::runs;

/// Tried of small inputs, unless `SWEEP_CDT_CASES` says otherwise.
const CASES: u64 = 2000;

/// Small inputs for each larger one.
const SMALL_FOR_MEDIUM: u64 = 20;

/// No input here takes nearly as long.
const PATIENCE: Duration = Duration::from_secs(60);

fn number(variable: &str, default: u64) -> u64 {
    std::env::var(variable).map_or(default, |text| text.parse().expect(variable))
}

/// Tests the inputs of many seeds; ends the program if one of them does not end.
fn for_seeds(count: u64, test: impl Fn(u64)) {
    let first = number("SWEEP_CDT_SEED", 0);
    let current = AtomicU64::new(first);
    let (done, is_done) = channel::<()>();
    std::thread::scope(|scope| {
        let current = &current;
        scope.spawn(move || {
            let mut before = None;
            while is_done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                let now = Some(current.load(Ordering::Relaxed));
                if now == before {
                    eprintln!(
                        "no end with SWEEP_CDT_SEED={}",
                        current.load(Ordering::Relaxed)
                    );
                    std::process::exit(1);
                }
                before = now;
            }
        });
        // Moved in, so that the watch ends with the tests, even where one panics.
        let _done = done;
        for seed in first..first + count {
            current.store(seed, Ordering::Relaxed);
            test(seed);
        }
    });
}

#[test]
fn every_kind_agrees_with_the_oracle() {
    let runs = runs::all();
    for_seeds(number("SWEEP_CDT_CASES", CASES), |seed| {
        let mut random = Random::new(seed);
        let input = small(&mut random);
        let some = if random.one_in(100) {
            runs.clone()
        } else {
            vec![runs[0].clone(), runs[random.below(runs.len())].clone()]
        };
        let agree = |input: &Input| {
            runs::assert_agree(input, &verdict(&input.points, &input.edges), &some);
        };
        minimize::run(&agree, &input, seed);
    });
}

#[test]
fn hundreds_of_points_and_edges_pass_the_local_tests() {
    let runs = runs::all();
    for_seeds(
        number("SWEEP_CDT_CASES", CASES) / SMALL_FOR_MEDIUM,
        |seed| {
            let mut random = Random::new(seed);
            let input = medium(&mut random);
            let other = runs[random.below(runs.len())].clone();
            let agree = |input: &Input| {
                let result = triangulate(&input.points, &input.edges).expect("no edges cross");
                let answer = check(&input.points, &input.edges, &result);
                if let Some(outcome) = other.outcome(input) {
                    assert_eq!(outcome, Ok(answer), "{} (right: default)", other.name);
                }
            };
            minimize::run(&agree, &input, seed);
        },
    );
}

#[test]
fn triangles_by_definition_pass_the_local_tests() {
    let mut crossing = 0;
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let input = small(&mut random);
        match verdict(&input.points, &input.edges) {
            Ok(answer) => check_found(&input.points, &input.edges, &answer),
            Err(_) => crossing += 1,
        }
    }
    println!("{crossing} of 1000 inputs have crossing edges");
    assert!(
        (30..500).contains(&crossing),
        "{crossing} of 1000 inputs have crossing edges"
    );
}

#[test]
fn fans_start_at_the_leftmost_upper_vertex() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let triangles = |edges: &[[usize; 2]]| verdict(&square, edges).map(|answer| answer.triangles);
    assert_eq!(triangles(&[]), Ok(vec![[0, 1, 3], [1, 2, 3]]));
    assert_eq!(triangles(&[[0, 2]]), Ok(vec![[0, 1, 2], [0, 2, 3]]));
    let crossing: Verdict = verdict(&square, &[[0, 2], [1, 3]]);
    assert_eq!(crossing, Err(vec![[0, 1]]));
}
