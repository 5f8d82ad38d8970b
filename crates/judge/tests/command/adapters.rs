//! Adapters in Python, with faults planted: each is found, made small and written.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::{judge, path, text};

/// The Python to run adapters with. Without one the test says so, and fails where `CI` is `true`.
fn python() -> Option<&'static str> {
    let is_there = |name: &&str| Command::new(name).arg("--version").output().is_ok();
    let found = ["python3", "python"].into_iter().find(is_there);
    if found.is_none() {
        println!("skipped: there is no python3");
        assert_ne!(
            std::env::var("CI").as_deref(),
            Ok("true"),
            "python3 is missing"
        );
    }
    found
}

/// A campaign against `points.py` with a fault: whether nothing was found, what was printed, and the findings' names.
fn campaign(
    folder: &Path,
    python: &str,
    fault: &str,
    more: &[&str],
) -> (Option<i32>, String, Vec<String>) {
    let adapter = path("crates/judge/tests/command/points.py");
    let adapter = adapter.to_str().expect("a path of characters");
    let mut arguments = vec![
        "campaign",
        "--numbers",
        "integers:10",
        "--never",
        "equal-points",
        "--most",
        "9",
    ];
    arguments.extend(more);
    arguments.extend(["--", python, adapter, fault]);
    let output = judge(folder, &arguments);
    let mut names = Vec::new();
    for entry in fs::read_dir(folder.join("findings")).into_iter().flatten() {
        let name = entry.expect("an entry").file_name();
        names.push(name.to_string_lossy().into_owned());
    }
    names.sort();
    (
        output.status.code(),
        text(&output.stdout) + &text(&output.stderr),
        names,
    )
}

/// The number of points of the question of a finding.
fn points(folder: &Path, name: &str) -> usize {
    let file = folder.join("findings").join(name).join("question.json");
    let question: Value =
        serde_json::from_slice(&fs::read(file).expect("a question")).expect("JSON");
    question["points"].as_array().map_or(0, Vec::len)
}

#[test]
fn a_right_adapter_has_no_findings() {
    let Some(python) = python() else { return };
    for fault in ["", "once"] {
        let folder = tempfile::tempdir().expect("a folder");
        // Also of four points on a circle it chooses as this crate does.
        let count = if fault == "once" { "20" } else { "300" };
        let more = ["--level", "canonical", "--executions", count];
        let (status, said, names) = campaign(folder.path(), python, fault, &more);
        assert_eq!((status, names.len()), (Some(0), 0), "{said}");
        assert!(said.contains("points.py 1"), "{said}");
    }
}

#[test]
fn planted_faults_are_found_and_made_small() {
    let Some(python) = python() else { return };
    for (fault, prefixes, most) in [
        (
            "drop",
            &[
                "concave-boundary",
                "extra-boundary",
                "pinched-boundary",
                "unused-point",
            ][..],
            7,
        ),
        ("flip", &["not-delaunay"], 4),
        ("crash", &["crash"], 5),
        ("garbage", &["unreadable"], 5),
        ("refuse", &["refused"], 5),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let (status, said, names) = campaign(
            folder.path(),
            python,
            fault,
            &["--executions", "60", "--keep", "1"],
        );
        assert_eq!(status, Some(1), "{said}");
        assert!(!names.is_empty(), "{said}");
        for name in &names {
            assert!(
                prefixes.iter().any(|prefix| name.starts_with(prefix)),
                "{said}"
            );
            assert!(points(folder.path(), name) <= most, "{said}");
        }
        let report = folder
            .path()
            .join("findings")
            .join(&names[0])
            .join("report.txt");
        let report = fs::read_to_string(report).expect("a report");
        let last_words = if fault == "crash" {
            "an assertion failed"
        } else {
            "points.py 1"
        };
        assert!(report.contains(last_words), "{report}");
        // The finding, asked again.
        let question = format!("findings/{}/question.json", names[0]);
        let adapter = path("crates/judge/tests/command/points.py");
        let adapter = adapter.to_str().expect("a path of characters");
        let again = |fault| {
            judge(
                folder.path(),
                &["ask", &question, "--", python, adapter, fault],
            )
        };
        assert_eq!(
            again(fault).status.code(),
            Some(1),
            "{}",
            text(&again(fault).stdout)
        );
        let thrice = judge(
            folder.path(),
            &[
                "ask", &question, "--repeat", "3", "--", python, adapter, fault,
            ],
        );
        let said = text(&thrice.stdout);
        assert!(
            said.contains("3 of 3: ") && thrice.status.code() == Some(1),
            "{said}"
        );
        assert_eq!(
            again("").status.code(),
            Some(0),
            "{}",
            text(&again("").stdout)
        );
    }
}

/// Killed, counted, and started again for the next question.
#[test]
fn an_adapter_that_hangs_is_started_again() {
    let Some(python) = python() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let more = ["--executions", "4", "--keep", "0", "--timeout", "5"];
    let (status, said, names) = campaign(folder.path(), python, "hang", &more);
    assert_eq!((status, names.len()), (Some(1), 0), "{said}");
    assert!(
        said.contains("\nhang: ") && !said.contains("\ncrash"),
        "{said}"
    );
}

#[test]
fn a_program_that_answers_nothing_is_not_asked_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = judge(folder.path(), &["campaign", "--", "no-such-program"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("cannot start no-such-program"));
    let Some(python) = python() else { return };
    let output = judge(
        folder.path(),
        &["campaign", "--", python, "-c", "import no_such_module"],
    );
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(
        said.contains("does not answer a single triangle (crash")
            && said.contains("no_such_module"),
        "{said}"
    );
}

/// The program of the suite: what the adapter claims it answers rightly, and where it flips a side it is wrong.
#[test]
fn the_suite_judges_an_adapter() {
    let Some(python) = python() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let adapter = path("crates/judge/tests/command/points.py");
    let adapter = adapter.to_str().expect("a path of characters");
    let suite = |fault: &str| {
        let claims = [
            "suite",
            "--numbers",
            "integers:20",
            "--never",
            "equal-points",
            "--level",
            "canonical",
        ];
        let output = judge(
            folder.path(),
            &[&claims[..], &["--", python, adapter, fault]].concat(),
        );
        (
            output.status.code(),
            text(&output.stdout) + &text(&output.stderr),
        )
    };
    let (status, said) = suite("");
    assert_eq!(status, Some(0), "{said}");
    assert!(said.contains("cocircular "), "{said}");
    let (status, said) = suite("flip");
    assert_eq!(status, Some(1), "{said}");
    assert!(
        said.contains("cocircular/") && said.contains(": not-delaunay: "),
        "{said}"
    );
}

/// Of each finding in `docs/findings`, the judge says of the answer what the page says, and that the right one is right.
#[test]
fn findings_stand_as_they_are_recorded() {
    let Some(python) = python() else { return };
    let mut again = Command::new(python);
    again.arg(path("docs/findings/again.py"));
    again.args([
        "--recorded",
        "--judge",
        env!("CARGO_BIN_EXE_sweep-cdt-judge"),
    ]);
    let output = again.output().expect("python3 can be run");
    assert!(output.status.success(), "{}", text(&output.stdout));
}
