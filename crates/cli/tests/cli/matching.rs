//! `sweep-cdt verify`: vertices of the result that are not, or not quite, those of the input.

use std::fmt::Write;
use std::fs;

use serde_json::Value;
use tempfile::TempDir;

use crate::verify::{first_line, refuted, verify};
use crate::{assert_fails, folder, printed, text};

/// Five points of which none is like another, and a triangulation of them.
const POINTS: [[f64; 2]; 5] = [
    [0.25, 0.5],
    [4000.125, 0.0],
    [4000.0, 3999.0],
    [-1.0, 4001.5],
    [1234.5678125, 1999.0],
];
const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];

/// A result in each format: its name, and the files.
fn results(
    points: &[[f64; 2]],
    triangles: &[[usize; 3]],
) -> [(&'static str, Vec<(&'static str, String)>); 3] {
    let mut ele = format!("{} 3 0\n", triangles.len());
    let mut node = format!("{} 2 0 0\n", points.len());
    let mut obj = String::new();
    for (v, [x, y]) in points.iter().enumerate() {
        writeln!(node, "{v} {x} {y}").expect("strings grow");
        writeln!(obj, "v {x} {y} 0").expect("strings grow");
    }
    for (t, [a, b, c]) in triangles.iter().enumerate() {
        writeln!(ele, "{t} {a} {b} {c}").expect("strings grow");
        writeln!(obj, "f {} {} {}", a + 1, b + 1, c + 1).expect("strings grow");
    }
    let json = format!(r#"{{"points": {points:?}, "triangles": {triangles:?}}}"#);
    [
        ("r.ele", vec![("r.ele", ele), ("r.node", node)]),
        ("r.obj", vec![("r.obj", obj)]),
        ("r.json", vec![("r.json", json)]),
    ]
}

/// A folder with the input and a result.
fn with_result(files: &[(&str, String)]) -> TempDir {
    let input = format!(r#"{{"points": {POINTS:?}}}"#);
    let folder = folder(&[("in.json", &input)]);
    for (name, contents) in files {
        fs::write(folder.path().join(name), contents).expect("a file");
    }
    folder
}

/// Asserts that results with these points are refused in all formats because of this vertex, from 0.
fn assert_refused(points: &[[f64; 2]], vertex: usize) {
    for (name, files) in results(points, &TRIANGLES) {
        let folder = with_result(&files);
        let output = verify(&folder, &format!("in.json {name}"));
        let error = text(&output.stderr);
        let vertex = vertex + usize::from(name == "r.obj");
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert_eq!(text(&output.stdout), "", "{name}");
        assert!(error.starts_with("error: r."), "{error}");
        assert!(
            error.contains(&format!(" vertex {vertex} is at (")),
            "{error}"
        );
        let by_number = verify(&folder, &format!("in.json {name} --by-number"));
        let report = printed(&by_number);
        assert!(first_line(report).starts_with("correct: "), "{report}");
        let second = report.lines().nth(1).expect("a line");
        let expected = "vertices matched by number, as was asked for: greatest difference ";
        assert!(second.starts_with(expected), "{second}");
    }
}

#[test]
fn vertices_elsewhere_are_refused() {
    assert_refused(&POINTS.map(|_| [7.0, 7.0]), 0);
    assert_refused(&POINTS.map(|[x, y]| [-x, y]), 0);
    assert_refused(&POINTS.map(|[x, y]| [x + 7.0, y + 7.0]), 0);
    assert_refused(&POINTS.map(|[x, y]| [x * 2.0, y * 2.0]), 0);
    assert_refused(&POINTS.map(|[x, y]| [y, x]), 0);
    for vertex in 0..5 {
        for nudge in [5000.0, 1e-3] {
            let mut points = POINTS;
            points[vertex][1] += nudge;
            assert_refused(&points, vertex);
        }
    }
}

#[test]
fn vertices_in_another_order_are_matched_by_coordinates() {
    let order = [3, 1, 4, 0, 2];
    let points = order.map(|v| POINTS[v]);
    let place = |v: usize| order.iter().position(|&w| w == v).expect("all are there");
    let triangles = TRIANGLES.map(|triangle| triangle.map(place));
    for (name, files) in results(&points, &triangles) {
        let folder = with_result(&files);
        let output = verify(&folder, &format!("in.json {name}"));
        let mut lines = printed(&output).lines();
        let verdict = lines.next().expect("a line");
        assert!(
            verdict.starts_with(&format!("correct: {name} is ")),
            "{verdict}"
        );
        let matched = lines.next();
        let expected = "vertices matched by coordinates: greatest difference 0";
        assert_eq!(matched, Some(expected));
        // By number they are wrong.
        refuted(&verify(&folder, &format!("in.json {name} --by-number")));
    }
}

#[test]
fn rounded_vertices_are_matched_by_number_and_reported() {
    let mut points = POINTS;
    points[4][0] = 1234.57;
    for (name, files) in results(&points, &TRIANGLES) {
        let folder = with_result(&files);
        let arguments = format!("in.json {name} --record c.json");
        let output = verify(&folder, &arguments);
        let second = printed(&output).lines().nth(1);
        let expected = "vertices matched by number, because coordinates are rounded: greatest \
                        difference 0.0021874999999909051";
        assert_eq!(second.map(|line| &line[..72]), Some(&expected[..72]));
        let json = verify(&folder, &format!("{arguments} --json"));
        let record = fs::read_to_string(folder.path().join("c.json")).expect("a file");
        assert_eq!(printed(&json), record);
        let record: Value = serde_json::from_str(&record).expect("JSON");
        let matched = &record["vertices_matched"];
        assert_eq!(matched["by"], "number");
        assert_eq!(matched["because"], "rounded");
        assert_eq!(matched["greatest_difference"], 1234.57 - 1234.5678125);
    }
}

#[test]
fn a_tolerance_takes_the_place_of_rounding() {
    let mut points = POINTS;
    points[2][1] += 0.5;
    for (name, files) in results(&points, &TRIANGLES) {
        let folder = with_result(&files);
        let run = |tolerance| verify(&folder, &format!("in.json {name} --tolerance {tolerance}"));
        let output = run("0.5");
        let second = printed(&output).lines().nth(1);
        let expected = "vertices matched by number, within the tolerance: greatest difference 0.5";
        assert_eq!(second, Some(expected));
        let vertex = if name == "r.obj" { 3 } else { 2 };
        let place = if name == "r.json" {
            "r.json:1"
        } else {
            "r.node:4"
        };
        let place = if name == "r.obj" { "r.obj:3" } else { place };
        let error = format!(
            "{place}: vertex {vertex} is at (4000, 3999.5), where the input has none within the tolerance 0.49: the \
             nearest is vertex 2 at (4000, 3999), by 0.5 (--tolerance 0.5 accepts it)"
        );
        assert_fails(&run("0.49"), &error);
        for wrong in ["-1", "x", "nan", "inf", "1 --by-number"] {
            assert_eq!(run(wrong).status.code(), Some(2), "{wrong}");
        }
    }
}

#[test]
fn other_numbers_of_vertices_are_matched_by_coordinates_alone() {
    let mut more = POINTS.to_vec();
    more.push([9.0, 9.0]);
    for (name, files) in results(&more, &TRIANGLES) {
        let folder = with_result(&files);
        let error = text(&verify(&folder, &format!("in.json {name}")).stderr).to_owned();
        let expected = " is at (9, 9), where the input has none: the nearest is vertex 0 at (0.25, 0.5), by 8.75 \
             (--steiner allows for vertices that were added, --by-number ignores coordinates, write the result with all \
             digits, 17, or without coordinates)\n";
        assert!(error.ends_with(expected), "{error}");
        printed(&verify(&folder, &format!("in.json {name} --by-number")));
    }
    // A vertex that no triangle has may be left out.
    for (name, files) in results(&POINTS[..4], &[[0, 1, 2], [0, 2, 3]]) {
        let folder = with_result(&files);
        let output = verify(&folder, &format!("in.json {name}"));
        let report = refuted(&output);
        assert!(
            report.contains("vertices matched by coordinates: "),
            "{report}"
        );
        assert!(
            report.contains("unused-point: vertex 4 is in no triangle"),
            "{report}"
        );
    }
    // Twice the same one is one.
    let mut twice = POINTS.to_vec();
    twice.push(POINTS[4]);
    let triangles = [[0, 1, 5], [1, 2, 4], [2, 3, 5], [3, 0, 4]];
    for (name, files) in results(&twice, &triangles) {
        let folder = with_result(&files);
        let output = verify(&folder, &format!("in.json {name}"));
        assert!(printed(&output).starts_with("correct: "));
    }
}

#[test]
fn vertices_that_are_not_finite_are_refused() {
    let obj = "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_owned();
    let folder = with_result(&[("r.obj", obj)]);
    for option in ["", "--by-number", "--tolerance 1e9"] {
        let output = verify(&folder, &format!("in.json r.obj {option}"));
        let error = "r.obj:1: vertex 1 has a coordinate that is not finite";
        assert_fails(&output, error);
    }
}
