//! Refusals: of which inputs, in which words, and the files left behind.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use crate::{
    FORMATS, assert_fails, command, feed, folder, names, printed, run, sweep_cdt, text,
    without_losses,
};

/// Inputs that are refused, and the error.
const REFUSED: &[(&str, &str, &str)] = &[
    (
        "a.node",
        "",
        "a.node:1: the file ends where the number of vertices should follow",
    ),
    (
        "a.node",
        "# only\n\n#",
        "a.node:3: the file ends where the number of vertices should follow",
    ),
    ("a.node", "x", "a.node:1: `x` is not a number of vertices"),
    (
        "a.node",
        "-1 2",
        "a.node:1: `-1` is not a number of vertices",
    ),
    (
        "a.node",
        "1 3\n1 0 0 0",
        "a.node:1: 3 coordinates are announced, and only x and y are read: leave out z and announce 2",
    ),
    (
        "a.node",
        "1 two",
        "a.node:1: `two` is not 2, the number of coordinates",
    ),
    (
        "a.node",
        "2 2\n0 0 0\n",
        "a.node:2: the file ends where vertex 2 of 2 should follow",
    ),
    (
        "a.node",
        "18446744073709551615\n0 0 0\n",
        "a.node:2: the file ends where vertex 2 of 18446744073709551615 should follow",
    ),
    (
        "a.node",
        "1\n2 0 0",
        "a.node:2: the first number is 2, not 0 or 1",
    ),
    (
        "a.node",
        "2\n1 0 0\n\n3 1 1",
        "a.node:4: the number is 3, not 2",
    ),
    (
        "a.node",
        "1\n0 0",
        "a.node:2: the line ends where a y coordinate should follow",
    ),
    (
        "a.node",
        "1\n0 0 1,5",
        "a.node:2: `1,5` is not a coordinate",
    ),
    (
        "a.node",
        "1\n0 0 1/0",
        "a.node:2: `1/0` is not a coordinate",
    ),
    (
        "a.node",
        "1\n0 0 \u{1b}[2J",
        "a.node:2: `\\u{1b}[2J` is not a coordinate",
    ),
    (
        "a.node",
        "2\n0 1/2 1\n1 1e99999 0",
        "a.node:3: `1e99999` has an exponent beyond 400, the limit where numbers are read exactly",
    ),
    (
        "a.node",
        "1\n0 0 0\n1 1 1",
        "a.node:3: the first line announces only 1 vertices",
    ),
    (
        "a.node",
        "2\n1 0 0\n2 nan 0",
        "a.node: vertex 2 has a coordinate that is not finite",
    ),
    (
        "a.node",
        "2\n1 0 0\n2 -1e400 0",
        "a.node:3: `-1e400` is too large for a double",
    ),
    (
        "a.node",
        "2\n1 0 0\n2 -inf 0",
        "a.node: vertex 2 has a coordinate that is not finite",
    ),
    ("a.poly", "0\n0\n", "a.node: no such file or directory"),
    (
        "a.poly",
        "1\n1 0 0\n",
        "a.poly:2: the file ends where the number of edges should follow",
    ),
    (
        "a.poly",
        "1\n1 0 0\n1\n1 1 0\n",
        "a.poly:4: vertex 0 does not exist: the vertices are numbered from 1 to 1",
    ),
    (
        "a.poly",
        "1\n1 0 0\n1\n1 1 2\n",
        "a.poly:4: vertex 2 does not exist: the vertices are numbered from 1 to 1",
    ),
    (
        "a.poly",
        "1\n1 0 0\n1\n1 1\n",
        "a.poly:4: the line ends where a vertex's number should follow",
    ),
    (
        "a.poly",
        "4\n1 0 0\n2 2 2\n3 0 2\n4 2 0\n3\n1 1 2\n2 1 4\n3 3 4\n",
        "a.poly: edges 1 and 3 cross near (1, 1) (`sweep-cdt crossings` lists all that do, --split-crossings makes vertices of them)",
    ),
    ("a.json", "", "a.json:1: the file is empty"),
    (
        "a.json",
        "{\"points\": [\n\n[0, 1]\n",
        "a.json:3: the file ends where the JSON should go on",
    ),
    (
        "a.json",
        "{\"points\": [\n[0, ]]}",
        "a.json:2:5: `]` is no JSON here: expected value",
    ),
    (
        "a.json",
        "{\"points\": [\n[0, NaN]]}",
        "a.json:2:5: `NaN` is no JSON here: expected value",
    ),
    ("a.json", "\n {}", "a.json:2:2: the object has no `points`"),
    (
        "a.json",
        "7",
        "a.json:1:1: an object such as {\"points\": [[x, y], ...]} should stand here",
    ),
    (
        "a.json",
        "[[0, 0], [1, 0]]",
        "a.json: a list stands where an object with named lists should, such as {\"points\": [...]}",
    ),
    (
        "a.json",
        "{\"points\": 3}",
        "a.json:1:12: `points` should be a list",
    ),
    (
        "a.json",
        "{\"points\": [],\n\"points\": []}",
        "a.json:2:11: `points` is there twice",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0],\n  7]}",
        "a.json:2:3: `7` is not a point, a list of 2 coordinates",
    ),
    (
        "a.json",
        "{\"points\": [\n  [0, 0, 7, 1]]}",
        "a.json:2:3: a point has 2 coordinates, and this one 4: leave out all but x, y and z",
    ),
    (
        "a.json",
        "{\"points\": [\n  [0]]}",
        "a.json:2:3: a point has 2 coordinates, and this one 1",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0]], \"edges\": [[0, 0],\n [0, -1]]}",
        "a.json:2:6: `-1` is not a vertex's number",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0]], \"edges\": [[0, 0, 0]]}",
        "a.json:1:32: an edge has 2 ends, and this one 3: split it into edges",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0], [1, 0]], \"edges\": [\n[1, 2]]}",
        "a.json:2:5: vertex 2 does not exist: the vertices are numbered from 0 to 1; subtract 1 from each",
    ),
    (
        "a.json",
        "{\"points\": [], \"edges\": [[0, 1]]}",
        "a.json:1:27: vertex 0 does not exist: there are no vertices",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0],\n[0, 1e400]]}",
        "a.json:2:5: `1e400` is too large for a double",
    ),
    (
        "a.json",
        "{\"points\": [\n [1, {}]]}",
        "a.json:2:6: `{}` is not a coordinate",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0]], \"edges\": [[0, 1]]}",
        "a.json:1:36: vertex 1 does not exist: the vertices are numbered from 0 to 0",
    ),
    (
        "a.json",
        "{\"points\": [[0, 0], [\"inf\", 0]]}",
        "a.json: vertex 1 has a coordinate that is not finite",
    ),
    (
        "a.json",
        "{\"points\": [[0, \"1/2\"],\n [\"nan\", 0]]}",
        "a.json:2:3: `nan` is not a coordinate",
    ),
    (
        "a.json",
        "{\"points\": [[0,0],[2,2],[0,2],[2,0]], \"edges\": [[0,1],[0,3],[2,3]]}",
        "a.json: edges 0 and 2 cross near (1, 1) (`sweep-cdt crossings` lists all that do, --split-crossings makes vertices of them)",
    ),
];

#[test]
fn errors_name_file_and_line_or_the_offenders() {
    for &(name, contents, error) in REFUSED {
        let folder = folder(&[(name, contents)]);
        for scalar in ["f64", "rational"] {
            if !(scalar == "f64" && contents.contains('/')) {
                let output = run(
                    &folder,
                    &format!("{name} -o a.ele -o a.svg --scalar {scalar}"),
                );
                assert_fails(&output, error);
                assert_eq!(names(folder.path()), [name]);
            }
        }
    }
    let output = run(FORMATS, "thirds.poly --scalar f64");
    assert_fails(
        &output,
        "thirds.poly: has fractions, which --scalar f64 refuses",
    );
    assert_fails(
        &run(FORMATS, "missing.poly"),
        "missing.poly: no such file or directory",
    );
}

#[test]
fn wrong_usage_exits_with_2() {
    let ten = fs::read_to_string(format!("{FORMATS}/ten.json")).expect("a file");
    let folder = folder(&[("ten.json", &ten), ("ten.poly", "0\n0\n")]);
    fs::create_dir(folder.path().join("formats")).expect("a folder");
    let wrong = [
        "",
        "ten.poly --front tree",
        "ten.poly -o ten.gif",
        "ten.poly -o -",
        "ten.poly -o - --output-format json --stats",
        "ten.json -o formats/../ten.json",
        "isolines",
        "-",
    ];
    for arguments in wrong {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        let error = without_losses(&output.stderr);
        assert!(error.starts_with("error: "), "{arguments}");
        assert_eq!(names(folder.path()), ["formats", "ten.json", "ten.poly"]);
    }
    assert_eq!(run(FORMATS, "--help").status.code(), Some(0));
}

#[test]
fn a_missing_format_is_asked_for_by_its_option() {
    for (arguments, option) in [
        ("triangulate - -o a.svg", "--input-format json"),
        ("triangulate ten.json -o -", "--output-format obj"),
        ("verify ten.json -", "--result-format json"),
        ("trace -", "--input-format json"),
    ] {
        let asked = sweep_cdt(FORMATS, arguments).output();
        let asked = asked.expect("the command starts");
        assert_eq!(asked.status.code(), Some(2), "{arguments}");
        let name = option.split(' ').next().expect("a name");
        let message = text(&asked.stderr);
        let known = match name {
            "--input-format" if cfg!(feature = "las") => {
                "node, poly, json, obj, off, csv, xyz, txt, ply, vtk, vtu, vtp, msh, geojson, wkt, npy, npz, las, laz"
            }
            "--input-format" => {
                "node, poly, json, obj, off, csv, xyz, txt, ply, vtk, vtu, vtp, msh, geojson, wkt, npy, npz"
            }
            "--output-format" => {
                "ele, node, json, cert, obj, off, ply, vtk, vtu, vtp, msh, stl, geojson, wkt, npy, npz, svg, png"
            }
            _ => "ele, json, obj, off, ply, vtk, vtu, vtp, msh, stl, geojson, wkt, npy, npz",
        };
        let advice = format!("is not known: add {name} with one of {known}\n");
        assert!(message.contains(&advice), "{message}");
        // The usage is that of the subcommand.
        let (subcommand, _) = arguments.split_once(' ').expect("a subcommand");
        let usage = format!("\nUsage: sweep-cdt {subcommand} [OPTIONS] <INPUT>");
        assert!(message.contains(&usage), "{message}");
        // Given that option, it does not complain of its usage any more.
        let given = feed(
            &mut sweep_cdt(FORMATS, &format!("{arguments} {option}")),
            b"",
        );
        assert_ne!(given.status.code(), Some(2), "{}", text(&given.stderr));
    }
}

#[test]
fn a_broken_pipe_is_no_crash() {
    for arguments in [
        "- --input-format json",
        "- --input-format json --stats",
        "- --input-format json -o - --output-format svg",
    ] {
        let mut child = command(FORMATS, arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        drop(child.stdout.take());
        // The command prints only when its input ends, after the pipe was broken.
        let mut input = child.stdin.take().expect("a pipe");
        input
            .write_all(br#"{"points": [[0, 0], [1, 0], [0, 1]]}"#)
            .expect("the input is read");
        drop(input);
        assert_eq!(
            printed(&child.wait_with_output().expect("the command ends")),
            ""
        );
    }
}
