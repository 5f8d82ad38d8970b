//! Traces: replayed, alone and beside their input.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::trace::run;
use crate::{FORMATS, assert_fails, feed, folder, printed, printed_despite_losses, sweep_cdt};

fn replay(trace: &[u8]) -> Output {
    feed(&mut sweep_cdt(FORMATS, "replay -"), trace)
}

/// The triangles of an input as `replay` prints them.
fn triangles(input: &str) -> String {
    let output = run(&format!("triangulate {input} -o - --output-format json"));
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let list = json["triangles"].as_array().expect("triangles");
    let line = |triangle: &Value| format!("{} {} {}\n", triangle[0], triangle[1], triangle[2]);
    list.iter().map(line).collect()
}

#[test]
fn replay_prints_the_triangles_of_the_result() {
    for input in ["ten.poly", "thirds.json", "split.poly"] {
        for settings in [
            "",
            "--output-format jsonl",
            "--heuristics paper --front skip-list",
        ] {
            let trace = run(&format!("trace {input} {settings}"));
            let replayed = replay(printed_despite_losses(&trace).as_bytes());
            assert_eq!(printed(&replayed), triangles(input), "{input} {settings}");
        }
    }
}

/// Damage that a replay alone cannot notice, and damage that it can, is noticed beside the input.
#[test]
fn a_replay_beside_its_input_notices_every_edit() {
    let trace = run("trace ten.poly");
    let lines: Vec<&str> = printed(&trace).lines().collect();
    let folder = folder(&[]);
    fs::copy(
        format!("{FORMATS}/ten.poly"),
        folder.path().join("ten.poly"),
    )
    .expect("a copy");
    let replay = |lines: &[&str], settings: &str| {
        fs::write(folder.path().join("ten.txt"), lines.join("\n") + "\n").expect("a file");
        let output = sweep_cdt(&folder, &format!("replay ten.txt {settings}")).output();
        output.expect("the command starts")
    };
    let compared = "--input ten.poly";
    assert_eq!(printed(&replay(&lines, compared)), triangles("ten.poly"));
    let others = "--input ten.poly --front skip-list --scalar rational";
    assert_eq!(printed(&replay(&lines, others)), triangles("ten.poly"));

    let is_legal = |line: &&str| line.starts_with("test") && line.ends_with("legal");
    let legal = lines.iter().position(is_legal).expect("a legal test");
    let mut edited = lines.clone();
    edited.remove(legal);
    assert_eq!(printed(&replay(&edited, "")), triangles("ten.poly"));
    let error = |line: usize, found: &str, wanted: &str| {
        format!("ten.txt:{line}: `{found}` is not what the run does: `{wanted}`")
    };
    let message = error(legal + 1, edited[legal], lines[legal]);
    assert_fails(&replay(&edited, compared), &message);

    let paper = run("trace ten.poly --heuristics paper");
    let paper: Vec<&str> = printed(&paper).lines().collect();
    let line = (0..).find(|&line| paper[line] != lines[line]).expect("one");
    let message = error(line + 1, paper[line], lines[line]);
    assert_fails(&replay(&paper, compared), &message);
    let same = "--input ten.poly --heuristics paper";
    assert_eq!(printed(&replay(&paper, same)), triangles("ten.poly"));

    let end = lines.len() + 1;
    let longer = [&lines[..], &["sorted 0"]].concat();
    let message = format!("ten.txt:{end}: `sorted 0` is not what the run does: it is over");
    assert_fails(&replay(&longer, compared), &message);
    let shorter = &lines[..lines.len() - 1];
    let message = format!("ten.txt:{}: the trace ends too early", end - 1);
    assert_fails(&replay(shorter, compared), &message);
    let both = sweep_cdt(&folder, "replay - --input -").output();
    assert_eq!(both.expect("the command starts").status.code(), Some(2));
}

#[test]
fn a_stretch_of_the_steps_is_written_on_demand() {
    let whole = run("trace ten.poly");
    let lines: Vec<&str> = printed(&whole).lines().collect();
    let part = run("trace ten.poly --from 4 --to 6");
    let expected = [
        "sweep-cdt trace 3 from step 4",
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
        &replay(b"sweep-cdt trace 3\nsorted 0\nhello\n"),
        "standard input:3: is no step: \"hello\"",
    );
    assert_fails(
        &replay(b"\xff"),
        "standard input:1: is not the header `sweep-cdt trace 3`",
    );
    assert_fails(
        &run("replay nowhere.txt"),
        "nowhere.txt: no such file or directory",
    );
}
