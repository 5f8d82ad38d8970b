//! The last line of a report: every option that it names accepts the result, and every change makes it right.

use std::fs;

use serde_json::{Value, json};

use crate::verify::{refuted, verify};
use crate::{folder, printed, sweep_cdt, text};

fn last_line(report: &str) -> &str {
    report.lines().next_back().expect("a line")
}

/// A square with a notch from above, so that hull and interior differ.
const NOTCH: &str =
    r#"{"points": [[0,0],[4,0],[4,4],[2,1],[0,4]], "edges": [[0,1],[1,2],[2,3],[3,4],[4,0]]}"#;
const NOTCH_INSIDE: &str = r#"{"triangles": [[0,1,3],[1,2,3],[0,3,4]]}"#;
/// A square whose last corner is moved, so that the other diagonal is the wrong one: by 1e-14, of which the depth is twice
/// as much.
const ROUNDED: &str = r#"{"points": [[0,0],[1,0],[1,0.99999999999999],[0,1]]}"#;
const WRONG_DIAGONAL: &str = r#"{"triangles": [[0,1,3],[1,2,3]]}"#;
/// A trapezoid, with a wrong diagonal; and with this one as an edge.
const TRAPEZOID: &str = r#"{"points": [[0,0],[4,0],[5,3],[0,3]], "edges": [[0,1]]}"#;
const WITH_DIAGONAL: &str = r#"{"points": [[0,0],[4,0],[5,3],[0,3]], "edges": [[0,1],[0,2]]}"#;
const NOT_DELAUNAY: &str = r#"{"triangles": [[0,1,2],[0,2,3]]}"#;

/// The input, the result, the last line, the options that it names and their status.
const NAMED: &[(&str, &str, &str, &str, i32)] = &[
    (
        NOTCH,
        NOTCH_INSIDE,
        "this is a right triangulation of the interior: `--domain even-odd`",
        "--domain even-odd",
        0,
    ),
    (
        ROUNDED,
        WRONG_DIAGONAL,
        "the only violation is of the size of rounding (depth 2.0e-14): `--max-depth 1e-12` accepts it",
        "--max-depth 1e-12",
        3,
    ),
    (
        TRAPEZOID,
        NOT_DELAUNAY,
        "this is a constrained triangulation, but not Delaunay: `--level constrained` accepts it",
        "--level constrained",
        0,
    ),
];

#[test]
fn every_option_that_is_named_accepts_the_result() {
    for (input, result, line, named, status) in NAMED {
        let folder = folder(&[("a.json", input), ("b.json", result)]);
        let report = verify(&folder, "a.json b.json");
        assert_eq!(last_line(refuted(&report)), *line);
        let again = verify(&folder, &format!("a.json b.json {named}"));
        assert_eq!(again.status.code(), Some(*status), "{named}");
        let expected = match status {
            0 => "correct: nothing to do",
            _ => "right but for rounding, as --max-depth allows: nothing to do",
        };
        assert_eq!(last_line(text(&again.stdout)), expected);
    }
}

/// Of many violations not all are measured by default, but all are for the advice. The lattice of 1600 squares leans to
/// the right a little, and each square has its longer diagonal.
#[test]
fn all_depths_are_measured_for_the_advice() {
    let size = 40;
    let mut points = Vec::new();
    for y in 0..=size {
        for x in 0..=size {
            points.push(json!([f64::from(x) + f64::from(y) * 1e-13, y]));
        }
    }
    let mut triangles = Vec::new();
    for y in 0..size {
        for x in 0..size {
            let a = y * (size + 1) + x;
            let (b, c, d) = (a + 1, a + size + 2, a + size + 1);
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let folder = folder(&[
        ("a.json", &json!({ "points": points }).to_string()),
        ("b.json", &json!({ "triangles": triangles }).to_string()),
    ]);
    let report = verify(&folder, "a.json b.json");
    assert!(refuted(&report).contains("\nnot measured  "));
    let line = last_line(refuted(&report));
    assert!(
        line.starts_with("all ")
            && line.contains(" violations are of the size of rounding (deepest "),
        "{line}"
    );
    assert!(
        line.ends_with("): `--max-depth 1e-12` accepts them"),
        "{line}"
    );
    let again = verify(&folder, "a.json b.json --max-depth 1e-12");
    assert_eq!(again.status.code(), Some(3));
}

#[test]
fn edges_that_are_missing_are_named() {
    let folder = folder(&[("a.json", WITH_DIAGONAL), ("b.json", WRONG_DIAGONAL)]);
    let report = verify(&folder, "a.json b.json");
    let line = "this is a triangulation, but without all edges of the input (edge 1 is missing): `--level tiling` \
                accepts it";
    assert_eq!(last_line(refuted(&report)), line);
    printed(&verify(&folder, "a.json b.json --level tiling"));

    let crossing = WITH_DIAGONAL.replace("[0,1]", "[1,3]");
    fs::write(folder.path().join("a.json"), crossing).expect("a file");
    let report = verify(&folder, "a.json b.json");
    let line = "the input has no triangulation with its edges: a.json: edges 0 and 1 cross near \
                (2.2222222222222223, 1.3333333333333333) (`sweep-cdt crossings` lists edges that cross)";
    assert_eq!(last_line(refuted(&report)), line);
}

/// Programs of which some triangles run clockwise: all of them is no fault.
#[test]
fn the_order_of_corners_is_found() {
    let input = r#"{"points": [[0,0],[4,0],[4,4],[0,4],[2,1]]}"#;
    let right = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let with = |reversed: &[usize]| {
        let mut triangles = right;
        reversed.iter().for_each(|&t| triangles[t].swap(1, 2));
        let result = json!({ "triangles": triangles }).to_string();
        folder(&[("a.json", input), ("b.json", &result)])
    };
    let all = with(&[0, 1, 2, 3]);
    let report = verify(&all, "a.json b.json");
    let report = printed(&report);
    assert!(report.starts_with("correct: "), "{report}");
    assert_eq!(report.lines().nth(2), Some("the triangles run clockwise"));
    assert_eq!(
        last_line(report),
        "correct: nothing to do; the triangles run clockwise"
    );
    let json = verify(&all, "a.json b.json --json");
    let record: Value = serde_json::from_str(printed(&json)).expect("JSON");
    assert_eq!(record["clockwise"], true);

    let folder = with(&[1, 3]);
    let report = verify(&folder, "a.json b.json");
    let line = "2 triangles run the other way round than the others, the first is 1: swap two corners of each";
    assert_eq!(last_line(refuted(&report)), line);
}

/// Qhull leaves out points that are nearly equal to others.
#[test]
fn vertices_that_are_left_out_are_named() {
    let points = "[[0,0],[4,0],[5,3],[0,3]";
    let line = "vertex 4 of the input, at (1, 1), is used by no triangle, and nothing else is wrong: remove it from the \
                input, and run the program again";
    let input = format!(r#"{{"points": {points},[1,1]]}}"#);
    let folder = folder(&[("a.json", &input), ("b.json", WRONG_DIAGONAL)]);
    let report = verify(&folder, "a.json b.json --limit 0");
    assert_eq!(last_line(refuted(&report)), line);
    let input = format!(r#"{{"points": {points}]}}"#);
    fs::write(folder.path().join("a.json"), input).expect("a file");
    printed(&verify(&folder, "a.json b.json"));
}

#[test]
fn where_nothing_helps_the_first_violation_is_named() {
    let input = r#"{"points": [[0,0],[4,0],[4,4],[0,4],[2,1]]}"#;
    let result = r#"{"triangles": [[0,1,4],[0,1,4],[1,2,4],[2,3,4]]}"#;
    let folder = folder(&[("a.json", input), ("b.json", result)]);
    let report = verify(
        &folder,
        "a.json b.json --svg wrong.svg --geojson wrong.geojson",
    );
    let line = "no option accepts this, the first violation is repeated-side: `--svg wrong.svg` and \
                `--geojson wrong.geojson` show where it is wrong";
    assert_eq!(last_line(refuted(&report)), line);
    assert!(folder.path().join("wrong.geojson").exists());
}

#[test]
fn violations_are_features() {
    let folder = folder(&[
        ("a.json", ROUNDED),
        ("b.json", WRONG_DIAGONAL),
        ("c.json", r#"{"triangles": [[0,1,2]]}"#),
    ]);
    let features = |result: &str| -> Vec<Value> {
        refuted(&verify(
            &folder,
            &format!("a.json {result} --geojson v.geojson"),
        ));
        let text = fs::read_to_string(folder.path().join("v.geojson")).expect("a file");
        let collection: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(collection["type"], "FeatureCollection");
        collection["features"].as_array().expect("features").clone()
    };
    let found = features("b.json");
    assert_eq!(found.len(), 1);
    let properties = &found[0]["properties"];
    assert_eq!(properties["name"], "not-delaunay");
    assert_eq!(properties["triangles"], json!([1, 0]));
    let depth = properties["depth"].as_f64().expect("a depth");
    assert!((1.9e-14..2.1e-14).contains(&depth));
    let message = properties["message"].as_str().expect("a text");
    assert!(
        message.starts_with("side 3-1 of triangles 1 and 0 is not Delaunay"),
        "{message}"
    );
    let ring = |corners: [[f64; 2]; 3]| json!([[corners[0], corners[1], corners[2], corners[0]]]);
    let (origin, far, right, left) = ([0.0, 0.0], [1.0, 0.99999999999999], [1.0, 0.0], [0.0, 1.0]);
    let geometry = &found[0]["geometry"];
    assert_eq!(geometry["type"], "MultiPolygon");
    let rings: Vec<Value> = geometry["coordinates"]
        .as_array()
        .expect("polygons")
        .clone();
    assert_eq!(rings.len(), 2);
    // Whole numbers are written without a point.
    let numbers = |value: &Value| -> Vec<f64> {
        let points = value[0].as_array().expect("a ring").iter();
        points
            .flat_map(|p| [p[0].as_f64(), p[1].as_f64()])
            .flatten()
            .collect()
    };
    assert_eq!(numbers(&rings[0]), numbers(&ring([right, far, left])));
    assert_eq!(numbers(&rings[1]), numbers(&ring([origin, right, left])));

    let found = features("c.json");
    assert_eq!(found.len(), 1);
    assert_eq!(found[0]["properties"]["name"], "unused-point");
    assert_eq!(found[0]["properties"]["depth"], Value::Null);
    assert_eq!(
        found[0]["geometry"],
        json!({"type": "Point", "coordinates": [0, 1]})
    );
}

/// Each figure is explained below it, and the documentation has the same lines.
#[test]
fn every_figure_is_explained() {
    let folder = folder(&[
        ("a.json", ROUNDED),
        ("b.json", WRONG_DIAGONAL),
        ("c.json", r#"{"triangles": [[0,1,3],[1,2,3],[0,1,4]]}"#),
    ]);
    let report = verify(&folder, "a.json b.json --explain");
    let plain = verify(&folder, "a.json b.json");
    let (report, plain) = (refuted(&report), refuted(&plain));
    let manual = include_str!("../../../../docs/command.md");
    let mut lines = report.lines();
    let mut figures = 0;
    for expected in plain.lines() {
        let line = lines.next().expect("a line");
        assert_eq!(line, expected);
        // A figure ends in its column.
        let is_figure =
            line.len() >= 38 && line.get(26..38).is_some_and(|cell| cell.starts_with(' '));
        if is_figure && !line.contains(": ") || line.starts_with("signs: ") {
            let meaning = lines.next().expect("its line").trim_start();
            let name = line[..26].trim_end();
            let name = if name.starts_with("1e") {
                "from 1e-16 to 1e-15"
            } else {
                name
            };
            assert!(
                manual.contains(&format!("| {name} | {meaning} |")),
                "{name}: {meaning}"
            );
            figures += 1;
        }
    }
    assert_eq!(lines.next(), None);
    assert_eq!(figures, 14);
}

/// `nical/lyon`: which edges, and where.
#[test]
fn edges_that_cross_are_refused_with_the_place() {
    let input = r#"{"points": [[0,0],[3,4],[0,4],[3,0]], "edges": [[0,1],[2,3]]}"#;
    let folder = folder(&[("a.json", input), ("b.json", r#"{"triangles": []}"#)]);
    let error = |arguments: &str| {
        let output = sweep_cdt(&folder, arguments).output();
        text(&output.expect("the command starts").stderr).to_owned()
    };
    let place = "error: a.json: edges 0 and 1 cross near (1.5, 2)";
    let advice =
        " (`sweep-cdt crossings` lists all that do, --split-crossings makes vertices of them)\n";
    assert_eq!(error("triangulate a.json"), format!("{place}{advice}"));
    assert_eq!(
        error("verify a.json b.json --domain even-odd"),
        format!("{place}\n")
    );
    assert!(error("trace a.json -o a.txt").starts_with(place));
}
