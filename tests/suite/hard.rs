//! Inputs that broke other programs: `tests/data/hard`, and the folder that `SWEEP_CDT_HARD` names.
//!
//! Each file says where it comes from (`source`), what broke (`note`) and, computed with exact
//! rational arithmetic, what is special about it (`expect`).

use std::path::{Path, PathBuf};

use serde_json::Value;
use sweep_cdt::{Error, triangulate};

use crate::runs;
use sweep_cdt_properties::Input;
use sweep_cdt_properties::oracle::{Graph, Integers, check, integers, verdict};

/// Up to so many points the exact scalars run too, and up to fewer the oracle.
const EXACT_LIMIT: usize = 3000;
const ORACLE_LIMIT: usize = 30;

pub(crate) struct File {
    pub(crate) path: PathBuf,
    expect: String,
    /// Whether there is no triangle.
    is_flat: bool,
    pub(crate) input: Input,
}

fn read(path: &Path) -> File {
    let text = std::fs::read_to_string(path).expect("a readable file");
    let json: Value = serde_json::from_str(&text).expect("a JSON file");
    let list = |name: &str| json[name].as_array().expect(name).clone();
    let coordinate = |value: &Value| match value {
        Value::String(text) => text.parse().expect("nan, inf or -inf"),
        _ => value.as_f64().expect("a number"),
    };
    let index = |value: &Value| {
        // What no index can be is out of range in any case.
        value
            .as_u64()
            .map_or(usize::MAX, |index| usize::try_from(index).expect("64 bits"))
    };
    let points = list("points")
        .iter()
        .map(|p| [coordinate(&p[0]), coordinate(&p[1])])
        .collect();
    let edges = list("edges")
        .iter()
        .map(|e| [index(&e[0]), index(&e[1])])
        .collect();
    let expect = json["expect"].as_str().expect("expect").to_owned();
    let has_flag = |name| json["flags"].get(name).is_some();
    let is_flat = has_flag("all_collinear") || has_flag("fewer_than_3_distinct_points");
    File {
        path: path.to_owned(),
        expect,
        is_flat,
        input: Input { points, edges },
    }
}

fn files(folder: &Path) -> Vec<File> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "json")
    });
    paths.sort();
    assert!(
        !paths.is_empty(),
        "{} holds no hard inputs",
        folder.display()
    );
    paths.iter().map(|path| read(path)).collect()
}

fn is_crossing(input: &Input, pair: [usize; 2]) -> bool {
    let edges = pair.map(|e| input.edges[e]);
    match integers(&input.points) {
        Integers::Small(points) => !Graph::new(&points, &edges).crossings().is_empty(),
        Integers::Medium(points) => !Graph::new(&points, &edges).crossings().is_empty(),
        Integers::Big(points) => !Graph::new(&points, &edges).crossings().is_empty(),
    }
}

/// Whether the error is the one that `expect` asks for, and names offenders.
fn is_right(error: Error, File { expect, input, .. }: &File) -> bool {
    match error {
        Error::NonFiniteCoordinate { vertex } => {
            expect == "nonfinite" && input.points[vertex].iter().any(|x| !x.is_finite())
        }
        Error::EdgeOutOfRange { edge, vertex } => {
            expect == "invalid_index"
                && input.edges[edge].contains(&vertex)
                && vertex >= input.points.len()
        }
        Error::CrossingEdges { edges } => expect == "crossing" && is_crossing(input, edges),
        _ => false,
    }
}

fn test(file: &File) {
    println!("{}", file.path.display());
    let Input { points, edges } = &file.input;
    let is_error = ["nonfinite", "invalid_index", "crossing"].contains(&file.expect.as_str());
    let is_exact = points.len() <= EXACT_LIMIT;
    let scalars: &[&str] = if is_exact {
        &["f64", "BigRational", "rug"]
    } else {
        &["f64, hash table", "f64, skip list"]
    };
    let expected = match triangulate(points, edges) {
        Ok(result) => {
            assert!(!is_error, "no error, but {} is expected", file.expect);
            let answer = check(points, edges, &result);
            assert_eq!(
                answer.triangles.is_empty(),
                file.is_flat,
                "triangles, or none"
            );
            Some(answer)
        }
        Err(error) => {
            assert!(
                is_right(error, file),
                "{error} ({} is expected)",
                file.expect
            );
            None
        }
    };
    if points.len() <= ORACLE_LIMIT && (expected.is_some() || file.expect == "crossing") {
        assert_eq!(verdict(points, edges).ok(), expected, "the oracle (left)");
    }
    for run in runs::of(scalars) {
        match run.outcome(&file.input) {
            Some(Ok(answer)) => assert_eq!(Some(answer), expected, "{} (left)", run.name),
            Some(Err(error)) => assert!(is_right(error, file), "{}: {error}", run.name),
            None => assert_eq!(
                file.expect, "nonfinite",
                "every finite double is a rational"
            ),
        }
    }
}

/// Those of `tests/data/hard`.
pub(crate) fn own_files() -> Vec<File> {
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hard"))
}

#[test]
fn inputs_that_broke_other_programs() {
    own_files().iter().for_each(test);
}

#[test]
fn further_hard_inputs() {
    if let Some(folder) = std::env::var_os("SWEEP_CDT_HARD") {
        files(Path::new(&folder)).iter().for_each(test);
    }
}
