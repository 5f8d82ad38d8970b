//! Where outputs go, and what must not happen to the files that are there.

use std::fs;

use tempfile::TempDir;

use crate::{assert_fails, folder, names, printed, run, sweep_cdt, text};

pub(crate) const TRIANGLE: &str = r#"{"points": [[0, 0], [1, 0], [0, 1]]}"#;
pub(crate) const NODE: &str = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";
pub(crate) const RIGHT: &str = r#"{"triangles": [[0, 1, 2]]}"#;

pub(crate) fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).expect("a file")
}

/// Asserts that a run is refused as wrong usage with just this message, and changes nothing.
#[track_caller]
pub(crate) fn assert_refused(folder: &TempDir, arguments: &str, message: &str) {
    let contents = |folder: &TempDir| {
        let names = names(folder.path()).into_iter();
        let bytes = |name: &String| fs::read(folder.path().join(name)).ok();
        names.map(|name| (bytes(&name), name)).collect::<Vec<_>>()
    };
    let before = contents(folder);
    let output = sweep_cdt(folder, arguments).output();
    let output = output.expect("the command starts");
    let found = text(&output.stderr).lines().next().unwrap_or_default();
    assert_eq!(found, format!("error: {message}"), "{arguments}");
    assert_eq!(output.status.code(), Some(2), "{arguments}");
    assert_eq!(text(&output.stdout), "", "{arguments}");
    assert_eq!(contents(folder), before, "{arguments}");
}

#[test]
fn an_output_that_cannot_be_written_leaves_the_old_ones() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old")]);
    fs::create_dir(folder.path().join("folder.obj")).expect("a folder");
    let output = run(&folder, "a.json -o old.svg -o folder.obj");
    assert_fails(&output, "folder.obj: is a directory");
    assert_eq!(read(&folder, "old.svg"), "old");
    let output = run(&folder, "a.json -o old.svg -o missing/new.obj");
    assert_fails(&output, "missing/new.obj: no such file or directory");
    assert_eq!(read(&folder, "old.svg"), "old");
    assert_eq!(names(folder.path()), ["a.json", "folder.obj", "old.svg"]);
}

#[test]
fn a_node_with_other_vertices_is_not_overwritten_unnamed() {
    for other in [
        "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n",
        "1 2 0 0\n0 7 7\n",
        "something else",
    ] {
        let folder = folder(&[("a.json", TRIANGLE), ("x.node", other)]);
        let message = "x.node would be overwritten, since the .ele needs its vertices beside it: \
                       give the .ele another name, or allow it by `-o x.node`";
        assert_refused(&folder, "triangulate a.json -o a.svg -o x.ele", message);
        assert_eq!(printed(&run(&folder, "a.json -o x.ele -o x.node")), "");
        assert_eq!(read(&folder, "x.node"), NODE);
        assert_eq!(read(&folder, "x.ele"), "1 3 0\n0 0 1 2\n");
    }
    let same = "# kept\n3 2 1 0\n0 0 0 .5\n1 1 0 .5\n2 0 1 7\n";
    let folder = folder(&[("a.json", TRIANGLE), ("x.node", same)]);
    assert_eq!(printed(&run(&folder, "a.json -o x.ele")), "");
    assert_eq!(read(&folder, "x.node"), same);
    assert_eq!(printed(&run(&folder, "a.json -o y.ele")), "");
    assert_eq!(read(&folder, "y.node"), NODE);
    assert_eq!(printed(&run(&folder, "a.json -o z.node")), "");
    assert_eq!(read(&folder, "z.node"), NODE);
    assert_eq!(
        names(folder.path()),
        ["a.json", "x.ele", "x.node", "y.ele", "y.node", "z.node"]
    );
}

#[test]
fn what_was_read_is_not_overwritten() {
    // The `.node` of the `.poly` and that of the `.ele` are read without being named.
    let files = [
        ("p.poly", "0 2\n1\n0 0 1\n"),
        ("p.node", NODE),
        ("r.ele", "1 3 0\n0 0 1 2\n"),
        ("r.node", NODE),
    ];
    let folder = folder(&files);
    // Only Unix tells that a hard link is the same file.
    let hard = if cfg!(unix) { "hard.svg" } else { "p.node" };
    fs::hard_link(folder.path().join("p.node"), folder.path().join("hard.svg")).expect("a link");
    let is_input = |name: &str| format!("{name} is an input and would be overwritten");
    for (subcommand, name) in [
        ("triangulate p.poly -o a.svg -o", "p.node"),
        (
            "triangulate p.poly --output-format json -o a.svg -o",
            "p.poly",
        ),
        ("triangulate p.poly -o a.svg --output-format svg -o", hard),
        ("trace p.poly --output-format txt -o", "./p.node"),
        ("verify p.poly r.ele --record", "p.poly"),
        ("verify p.poly r.ele --record", "p.node"),
        ("verify p.poly r.ele --record a.json --svg", "hard.svg"),
        ("verify p.poly r.ele --svg", "r.ele"),
        ("verify p.poly r.ele --svg", "r.node"),
    ] {
        assert_refused(&folder, &format!("{subcommand} {name}"), &is_input(name));
    }
}

#[test]
fn one_file_is_one_output() {
    let folder = folder(&[("a.json", TRIANGLE), ("r.json", RIGHT), ("old.svg", "old")]);
    fs::create_dir(folder.path().join("folder")).expect("a folder");
    for (arguments, first, second) in [
        ("triangulate a.json -o b.svg -o", "b.svg", "b.svg"),
        ("triangulate a.json -o b.svg -o", "b.svg", "folder/../b.svg"),
        ("triangulate a.json -o old.svg -o", "old.svg", "./old.svg"),
        (
            "verify a.json r.json --svg b.svg --record",
            "b.svg",
            "./b.svg",
        ),
        (
            "triangulate a.json --output-format obj -o - -o",
            "standard output",
            "-",
        ),
    ] {
        let shown = second.replace("-", "standard output");
        let message = format!("{first} and {shown} are the same file and would both be written");
        assert_refused(&folder, &format!("{arguments} {second}"), &message);
    }
}
