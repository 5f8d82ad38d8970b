//! Traces: recorded, replayed, refused.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::{FORMATS, assert_fails, feed, folder, names, printed, sweep_cdt, text};

fn run(arguments: &str) -> Output {
    let output = sweep_cdt(FORMATS, arguments).output();
    output.expect("the command starts")
}

fn replay(trace: &[u8]) -> Output {
    feed(&mut sweep_cdt(FORMATS, "replay -"), trace)
}

/// The triangles of an input as `replay` prints them.
fn triangles(input: &str) -> String {
    let output = run(&format!("triangulate {input} -o - --to json"));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let list = json["triangles"].as_array().expect("triangles");
    let line = |triangle: &Value| format!("{} {} {}\n", triangle[0], triangle[1], triangle[2]);
    list.iter().map(line).collect()
}

#[test]
fn replay_prints_the_triangles_of_the_result() {
    for input in ["ten.poly", "thirds.json", "split.poly"] {
        for settings in ["", "--to jsonl", "--heuristics paper --front skip-list"] {
            let trace = run(&format!("trace {input} {settings}"));
            let replayed = replay(printed(&trace).as_bytes());
            assert_eq!(printed(&replayed), triangles(input), "{input} {settings}");
        }
    }
}

#[test]
fn fronts_and_scalars_take_the_same_steps() {
    let trace = run("trace ten.poly");
    for settings in ["--front skip-list", "--front linear", "--scalar rational"] {
        let other = run(&format!("trace ten.poly {settings}"));
        assert_eq!(printed(&other), printed(&trace));
    }
}

#[test]
fn files_are_written_by_their_extension() {
    let folder = folder(&[]);
    for (extension, option) in [("txt", ""), ("jsonl", "--to jsonl")] {
        let path = folder.path().join("steps").with_extension(extension);
        let written = run(&format!("trace ten.poly -o {}", path.display()));
        assert_eq!(printed(&written), "");
        let printed_directly = run(&format!("trace ten.poly {option}"));
        assert_eq!(
            fs::read_to_string(&path).expect("a file"),
            printed(&printed_directly)
        );
    }
    let refused = run("trace ten.poly -o steps.svgz");
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("only .txt, .jsonl, .html and .svg can be written"));
}

#[test]
fn a_stretch_of_the_steps_is_written_on_demand() {
    let whole = run("trace ten.poly");
    let lines: Vec<&str> = printed(&whole).lines().collect();
    let part = run("trace ten.poly --first 4 --last 6");
    let expected = [
        "sweep-cdt trace 1 from step 4",
        lines[4],
        lines[5],
        lines[6],
    ];
    assert_eq!(printed(&part).lines().collect::<Vec<_>>(), expected);
    assert_fails(
        &replay(&part.stdout),
        "standard input:1: the trace lacks its first 3 steps",
    );
}

#[test]
fn what_is_no_trace_is_refused_by_line() {
    assert_fails(
        &replay(b"sweep-cdt trace 1\nsorted 0\nhello\n"),
        "standard input:3: is no step: \"hello\"",
    );
    assert_fails(
        &replay(b"\xff"),
        "standard input:1: is not the header `sweep-cdt trace 1`",
    );
    assert_fails(
        &run("replay nowhere.txt"),
        "nowhere.txt: no such file or directory",
    );
}

#[test]
fn wrong_input_leaves_no_file() {
    let crossing = r#"{"points":[[0,0],[1,1],[0,1],[1,0]],"edges":[[0,1],[2,3]]}"#;
    let folder = folder(&[("crossing.json", crossing)]);
    let output = sweep_cdt(&folder, "trace crossing.json -o steps.txt").output();
    assert_fails(
        &output.expect("the command starts"),
        "crossing.json: edges 0 and 1 cross",
    );
    assert_eq!(names(folder.path()), ["crossing.json"]);
}
