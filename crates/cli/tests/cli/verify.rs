//! `sweep-cdt verify`: what is correct, in all layouts, and how it is used.

use std::fs;
use std::path::Path;
use std::process::Output;

use tempfile::TempDir;

use crate::{
    CONTOURS, FORMATS, feed, folder, names, printed, printed_despite_losses, run, sweep_cdt, text,
};

/// A square with a vertex inside, numbered from 1, and its bottom given as an edge.
const SQUARE: &str = "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 2 1\n1 0\n1 1 2\n";
pub(crate) const RIGHT: &str = "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n";

pub(crate) fn verify(folder: impl AsRef<Path>, arguments: &str) -> Output {
    let arguments = format!("verify {arguments}");
    sweep_cdt(folder, &arguments)
        .output()
        .expect("the command starts")
}

pub(crate) fn with_square(files: &[(&str, &str)]) -> TempDir {
    let folder = folder(files);
    fs::write(folder.path().join("a.poly"), SQUARE).expect("a file");
    folder
}

/// The report of a run that finds violations.
#[track_caller]
pub(crate) fn refuted(output: &Output) -> &str {
    assert_eq!(text(&output.stderr), "");
    assert_eq!(output.status.code(), Some(1));
    text(&output.stdout)
}

/// Where the faces of a mesh are its edges, no side can break a rule of Delaunay.
#[test]
fn nothing_is_asked_of_delaunay_where_all_sides_are_edges() {
    let bad = "v 0 0\nv 4 0\nv 5 3\nv 0 3\nf 1 2 3\nf 1 3 4\n";
    let folder = folder(&[("bad.obj", bad)]);
    let asked = verify(&folder, "bad.obj bad.obj");
    assert_eq!(asked.status.code(), Some(1));
    let with_faces = verify(&folder, "bad.obj bad.obj --faces");
    let remark = "of 1 side between two triangles each is an edge: nothing was asked of Delaunay";
    assert_eq!(
        text(&with_faces.stderr),
        format!("note: bad.obj: {remark}\n")
    );
    printed(&verify(
        &folder,
        "bad.obj bad.obj --faces --strict --level constrained",
    ));
}

#[track_caller]
pub(crate) fn first_line(report: &str) -> &str {
    report.lines().next().expect("a line")
}

#[test]
fn the_report_of_a_correct_result() {
    let folder = with_square(&[("a.ele", RIGHT)]);
    let report = "\
correct: a.ele is a constrained Delaunay triangulation of a.poly, the canonical one
vertices matched by number: the result has no coordinates

points                               5
distinct points                      5
edges                                1
triangles                            4
boundary sides                       4
constrained sides                    1
free sides                           4
cocircular ties                      0
ties not canonical                   0
highest level                canonical
signs: by filter               100.000 %
signs: exact                     0.000 %

correct: nothing to do
";
    assert_eq!(printed(&verify(&folder, "a.poly a.ele")), report);
}

#[test]
fn own_results_are_correct_in_all_formats_and_scalars() {
    for input in ["ten.poly", "split.node", "thirds.json"] {
        let folder = folder(&[]);
        let input = format!("{FORMATS}/{input}");
        let outputs = ["ele", "json", "obj"].map(|format| format!("r.{format}"));
        let list = outputs.join(" -o ");
        printed_despite_losses(&run(&folder, &format!("{input} -o {list}")));
        let expected =
            format!("is a constrained Delaunay triangulation of {input}, the canonical one");
        for scalar in ["", "--scalar rational"] {
            for output in &outputs {
                let report = verify(&folder, &format!("{input} {output} {scalar}"));
                let line = first_line(printed_despite_losses(&report));
                assert_eq!(line, format!("correct: {output} {expected}"));
            }
        }
    }
}

#[test]
fn foreign_layouts_are_understood() {
    let layouts = [
        ("from_0.ele", "4 3 0\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 4\n"),
        (
            "attributes.ele",
            "4 3 1\n1 1 2 5 .5\n2 2 3 5 .5\n3 3 4 5 7\n4 4 1 5 0\n",
        ),
        (
            "flat.json",
            r#"{"triangles": [0,1,4, 1,2,4, 2,3,4, 3,0,4], "halfedges": []}"#,
        ),
        (
            "more.json",
            r#"{"n": {"triangles": 1}, "triangles": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]}"#,
        ),
        (
            "permuted.obj",
            "o a\nv 2 1 7\nv 0 0 0\nvt 0 0\nv 4 0 0\nv 4 4\nv 0 4 0\ns off\n\
             f 2/1/1 3//2 1\nf 3 4 1\nf 4 5 1\nf -1 -4 -5\n",
        ),
    ];
    let folder = with_square(&layouts);
    for (name, _) in layouts {
        let report = verify(&folder, &format!("a.poly {name}"));
        assert!(
            printed(&report).starts_with(&format!("correct: {name} ")),
            "{name}"
        );
    }
    let clockwise = r#"{"triangles": [[4,1,0],[4,2,1],[4,3,2],[4,0,3]]}"#;
    let clockwise = || {
        feed(
            &mut sweep_cdt(&folder, "verify a.poly - --result-format json"),
            clockwise.as_bytes(),
        )
    };
    assert!(printed(&clockwise()).starts_with("correct: standard input is "));
}

#[test]
fn triangulate_verifies_its_own_result() {
    let said = |input: &str| {
        format!(
            "correct: the result is a constrained Delaunay triangulation of {input}, the \
             canonical one\n"
        )
    };
    let folder = folder(&[]);
    let output = run(&folder, &format!("{CONTOURS} --verify -o a.ele"));
    assert_eq!(printed(&output), said(CONTOURS));
    assert_eq!(names(folder.path()), ["a.ele", "a.node"]);
    let output = run(FORMATS, "ten.poly --verify");
    assert!(printed(&output).ends_with(&said("ten.poly")));
    let quiet = run(FORMATS, "ten.poly -o - --output-format obj");
    assert_eq!(
        printed_despite_losses(&run(FORMATS, "ten.poly --verify -o - --output-format obj")),
        printed_despite_losses(&quiet)
    );
}

#[test]
fn wrong_usage_exits_with_2() {
    let folder = with_square(&[("a.ele", RIGHT)]);
    for arguments in [
        "a.poly",
        "a.poly a.svg",
        "- - --input-format json --result-format json",
        "a.poly -",
        "a.poly a.ele --svg a.ele",
        "a.poly a.ele --record a.poly",
        "a.poly a.ele --limit x",
    ] {
        let output = verify(&folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(text(&output.stderr).starts_with("error: "), "{arguments}");
        assert_eq!(names(folder.path()), ["a.ele", "a.poly"]);
    }
}

/// A user may have so many threads already that no more can be started. (Root may always start more, and
/// becomes nobody here.)
#[test]
#[cfg(target_os = "linux")]
fn without_threads_it_verifies_on_one() {
    use std::process::Command;

    let result = run(FORMATS, "ten.poly -o - --output-format json").stdout;
    let id = Command::new("id").arg("-u").output();
    let is_root = id.is_ok_and(|output| output.stdout == b"0\n");
    let user: &[&str] = if is_root {
        &[
            "setpriv",
            "--reuid=65534",
            "--regid=65534",
            "--clear-groups",
        ]
    } else {
        &[]
    };
    let command = |limit: &[&str], arguments: &[&str]| {
        let own = [env!("CARGO_BIN_EXE_sweep-cdt")];
        let words = [user, limit, &own, arguments].concat();
        let mut command = Command::new(words[0]);
        command.args(&words[1..]).current_dir(FORMATS);
        command
    };
    let version = command(&["prlimit"], &["--version"]).output();
    if !version.is_ok_and(|output| output.status.success()) {
        println!("skipped: no setpriv, no prlimit, or another user may not run the command");
        return;
    }
    let arguments = ["verify", "ten.poly", "-", "--result-format", "json"];
    for threads in ["--nproc=0", "--nproc=1"] {
        let output = feed(&mut command(&["prlimit", threads], &arguments), &result);
        assert!(printed(&output).starts_with("correct: "));
    }
}
