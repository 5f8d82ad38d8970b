//! Inputs that broke other programs: `tests/data/hard.jsonl`, and the folder that `SWEEP_CDT_HARD` names.

use sweep_cdt::{Error, triangulate};
use sweep_cdt_testing::Input;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::oracle::{check, crosses, verdict};

use super::runs;

/// Up to so many points the exact scalars run too, and up to fewer the oracle.
const EXACT_LIMIT: usize = 3000;
const ORACLE_LIMIT: usize = 30;

/// Whether the error is the one that `expect` asks for, and names offenders.
fn is_right(error: Error, Hard { expect, input, .. }: &Hard) -> bool {
    let Input { points, edges } = input;
    match error {
        Error::NonFiniteCoordinate { vertex } => {
            expect == "nonfinite" && points[vertex].iter().any(|x| !x.is_finite())
        }
        Error::EdgeOutOfRange { edge, vertex } => {
            expect == "invalid_index" && edges[edge].contains(&vertex) && vertex >= points.len()
        }
        Error::CrossingEdges { edges: pair } => {
            expect == "crossing" && crosses(points, edges, pair)
        }
        _ => false,
    }
}

fn test(hard: &Hard) {
    println!("{}", hard.name);
    let Input { points, edges } = &hard.input;
    let is_error = ["nonfinite", "invalid_index", "crossing"].contains(&hard.expect.as_str());
    let is_exact = points.len() <= EXACT_LIMIT;
    let scalars: &[&str] = if is_exact {
        &["f64", "BigRational", "rug"]
    } else {
        &["f64, hash", "f64, skip-list", "f64, divide and conquer"]
    };
    let expected = match triangulate(points, edges) {
        Ok(result) => {
            assert!(!is_error, "no error, but {} is expected", hard.expect);
            let answer = check(points, edges, &result);
            assert_eq!(
                answer.triangles.is_empty(),
                hard.is_flat,
                "triangles, or none"
            );
            Some(answer)
        }
        Err(error) => {
            assert!(
                is_right(error, hard),
                "{error} ({} is expected)",
                hard.expect
            );
            None
        }
    };
    if points.len() <= ORACLE_LIMIT && (expected.is_some() || hard.expect == "crossing") {
        assert_eq!(verdict(points, edges).ok(), expected, "the oracle (left)");
    }
    for run in runs::of(scalars) {
        match run.outcome(&hard.input) {
            Some(Ok(answer)) => assert_eq!(Some(answer), expected, "{} (left)", run.name),
            Some(Err(error)) => assert!(is_right(error, hard), "{}: {error}", run.name),
            None => assert_eq!(
                hard.expect, "nonfinite",
                "every finite double is a rational"
            ),
        }
    }
}

#[test]
fn inputs_that_broke_other_programs() {
    Hard::own().iter().for_each(test);
}

#[test]
fn further_hard_inputs() {
    Hard::further().iter().for_each(test);
}
