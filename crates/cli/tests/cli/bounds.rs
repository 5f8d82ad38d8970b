//! `verify` with bounds on angles, areas and sides: decided by exact signs, of results and of meshes by themselves.

use std::fs;

use serde_json::{Value, json};

use crate::bent::MESHES;
use crate::verify::{first_line, refuted, verify};
use crate::{folder, printed, text};

/// A square of side 2 in two triangles, whose angles are 45 degrees and more, and whose longest side is the root of 8.
const SQUARE: &str = r#"{"points": [[0,0],[2,0],[2,2],[0,2]], "triangles": [[0,1,2],[0,2,3]]}"#;
/// The corners of the square alone.
const CORNERS: &str = r#"{"points": [[0,0],[2,0],[2,2],[0,2]]}"#;
/// The double above the root of 8 is nearest to it.
const BOUNDS: [(&str, &str); 3] = [
    ("--min-angle 45", "--min-angle 45.00000000000001"),
    ("--max-area 2", "--max-area 1.9999999999999998"),
    (
        "--max-side 2.8284271247461903",
        "--max-side 2.82842712474619",
    ),
];

#[test]
fn bounds_are_decided_by_exact_signs() {
    let folder = folder(&[("a.json", SQUARE), ("p.json", CORNERS)]);
    for (kept, broken) in BOUNDS {
        for files in ["p.json a.json", "a.json"] {
            let right = verify(&folder, &format!("{files} {kept}"));
            assert!(first_line(printed(&right)).ends_with(", within the bounds"));
            let wrong = verify(&folder, &format!("{files} {broken}"));
            assert!(
                first_line(refuted(&wrong)).ends_with(", but 2 of 2 triangles break the bounds")
            );
        }
    }
}

/// Each corner moved by a last place breaks a bound that the square keeps.
#[test]
fn corrupted_meshes_are_listed() {
    let moved = |to: &str| SQUARE.replace("[2,2]", to);
    let files = [
        ("area.json", moved("[2,2.0000000000000004]")),
        ("side.json", moved("[2.0000000000000004,2]")),
        ("angle.json", moved("[2,1.9999999999999998]")),
    ];
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (*name, &text[..]))
        .collect();
    let folder = folder(&files);
    let area = "large-area: triangle 0 has an area of 2.0000000000000004, more than 2";
    for (name, bound, listed) in [
        ("area.json", "--max-area 2", area),
        (
            "side.json",
            "--max-side 2.8284271247461903",
            "long-side: triangle 0 has",
        ),
        (
            "angle.json",
            "--min-angle 45",
            "small-angle: triangle 0 has",
        ),
    ] {
        let report = verify(&folder, &format!("{name} {bound}"));
        let report = refuted(&report);
        assert!(report.contains(&format!("\n\n{listed}")), "{report}");
        assert!(report.contains("\n  (0, 0), (2, 0), (2"), "{report}");
        printed(&verify(
            &folder,
            &format!("{name} --max-area 2.1 --min-angle 44 --max-side 2.9"),
        ));
    }
}

#[test]
fn records_and_reports_list_what_is_out_of_bounds() {
    let folder = folder(&[("a.json", SQUARE), ("p.json", CORNERS)]);
    let out = "--max-area 1 --max-side 2 --limit 3";
    let report = verify(&folder, &format!("p.json a.json {out}"));
    let report = refuted(&report);
    let line = "wrong: a.json is a constrained Delaunay triangulation of p.json, not the canonical one, but 2 of 2 triangles break the bounds";
    assert_eq!(first_line(report), line);
    let end = "\nand 1 more out of bounds\n\nonly bounds are broken: refine the input with them, or ask for less\n";
    assert!(report.ends_with(end), "{report}");
    for files in ["p.json a.json", "a.json"] {
        let record = verify(&folder, &format!("{files} {out} --json"));
        let record: Value = serde_json::from_str(refuted(&record)).expect("JSON");
        assert_eq!(record["verdict"], "wrong");
        let bounds = &record["bounds"];
        assert_eq!(bounds["min_angle"], Value::Null);
        assert_eq!(
            (&bounds["max_area"], &bounds["max_side"]),
            (&json!(1.0), &json!(2.0))
        );
        assert_eq!(bounds["triangles_out_of_bounds"], 2);
        assert_eq!(bounds["violations_found"], 4);
        let listed = bounds["violations"].as_array().expect("a list");
        let classes: Vec<_> = listed
            .iter()
            .map(|one| (&one["class"], &one["triangle"]))
            .collect();
        let expected = [
            (json!("large-area"), json!(0)),
            (json!("long-side"), json!(0)),
            (json!("large-area"), json!(1)),
        ];
        assert_eq!(
            classes,
            expected.iter().map(|(a, b)| (a, b)).collect::<Vec<_>>()
        );
        assert_eq!(listed[0]["at"], json!([[0, 0], [2, 0], [2, 2]]));
    }
    // Without bounds the record says nothing of them, and what is wrong stays wrong within them.
    let record = verify(&folder, "p.json a.json --json");
    assert!(!printed(&record).contains("bounds"));
    fs::write(
        folder.path().join("b.json"),
        r#"{"triangles": [[0,1,2],[0,2,7]]}"#,
    )
    .expect("a file");
    let report = verify(&folder, "p.json b.json --max-area 2");
    let report = refuted(&report);
    assert!(
        first_line(report).starts_with("wrong: ") && report.contains("triangle-out-of-range"),
        "{report}"
    );
    let report = verify(&folder, "p.json b.json --max-area 1");
    assert!(first_line(refuted(&report)).ends_with(", and 1 of 2 triangles breaks the bounds"));
}

/// Meshes of Triangle and Gmsh, each by itself.
#[test]
fn meshes_of_other_programs() {
    for (mesh, triangles, kept, broken) in [
        ("a.pq.json", 60, "--min-angle 20", "--min-angle 30"),
        ("gmsh.msh", 69, "--min-angle 10", "--max-side 0.01"),
    ] {
        let right = verify(MESHES, &format!("{mesh} {kept}"));
        let line =
            format!("correct: {mesh} is a mesh of {triangles} triangles, within the bounds\n");
        assert_eq!(printed(&right), line);
        assert!(refuted(&verify(MESHES, &format!("{mesh} {broken}"))).starts_with("wrong: "));
    }
}

#[test]
fn what_is_asked_of_a_mesh_by_itself() {
    let folder = folder(&[("a.json", SQUARE), ("b.ele", "1 3 0\n0 0 1 2\n")]);
    for arguments in [
        "a.json",
        "a.json --max-area 2 --svg a.svg",
        "a.json --max-area 2 --stream",
    ] {
        let refused = verify(&folder, arguments);
        assert_eq!(refused.status.code(), Some(2), "{arguments}");
        let message = text(&refused.stderr);
        assert!(message.starts_with("error: "), "{message}");
    }
    let refused = verify(&folder, "b.ele --max-area 2");
    let message =
        "b.ele: the triangles have no coordinates: give the INPUT with the vertices first";
    crate::assert_fails(&refused, message);
}
