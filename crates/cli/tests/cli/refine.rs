//! `sweep-cdt refine`: meshes within bounds in every format, what they inherit, and what cannot be better.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::{Value, json};

use crate::bent::MESHES;
use crate::inside::FRAME;
use crate::verify::{first_line, verify};
use crate::{assert_fails, folder, printed, printed_despite_losses, sweep_cdt, text};

fn refine(folder: impl AsRef<Path>, arguments: &str) -> Output {
    let output = sweep_cdt(folder, &format!("refine {arguments}")).output();
    output.expect("the command starts")
}

fn object(folder: &Path, name: &str) -> Value {
    let text = fs::read_to_string(folder.join(name)).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

fn count(list: &Value) -> usize {
    list.as_array().expect("a list").len()
}

#[test]
fn meshes_keep_their_bounds_in_every_format() {
    let folder = folder(&[("a.poly", FRAME)]);
    let formats = "ele json obj off ply vtk vtu vtp msh stl geojson wkt npz";
    let outputs = formats.split(' ').map(|format| format!("-o m.{format}"));
    let outputs = outputs.collect::<Vec<_>>().join(" ");
    let bounds = "--min-angle 28 --max-area 2 --max-side 2.5";
    let made = refine(
        &folder,
        &format!("a.poly {bounds} {outputs} -o m.svg -o m.png"),
    );
    assert!(printed_despite_losses(&made).ends_with(", out of bounds 0\n"));
    for format in formats.split(' ') {
        // Sides of this frame are halved exactly, so that none is bent.
        let report = verify(&folder, &format!("a.poly m.{format} --steiner {bounds}"));
        let line = first_line(printed(&report));
        let expected = "the canonical one, within the bounds";
        assert!(
            line.starts_with("correct: ") && line.ends_with(expected),
            "{line}"
        );
        printed(&verify(&folder, &format!("m.{format} {bounds}")));
        let less = verify(&folder, &format!("m.{format} --max-area 0.25"));
        assert_eq!(less.status.code(), Some(1), "{format}");
    }
    // The mesh is the triangulation of its own vertices and edges.
    let report = verify(&folder, "m.json m.ele --domain even-odd --level canonical");
    assert_eq!(report.status.code(), Some(0), "{}", text(&report.stdout));
    let picture = fs::read_to_string(folder.path().join("m.svg")).expect("a picture");
    let triangles = count(&object(folder.path(), "m.json")["triangles"]);
    assert!(
        picture.contains(&format!("triangles: {triangles}<")),
        "{picture}"
    );
    assert!(
        fs::read(folder.path().join("m.png"))
            .expect("a picture")
            .starts_with(b"\x89PNG")
    );
}

#[test]
fn parts_inherit_markers_and_vertices_heights() {
    let poly = "4 2 1 0\n1 0 0 0\n2 8 0 16\n3 8 4 12\n4 0 4 -4\n5 1\n1 1 2 7\n2 2 3 8\n3 3 4 9\n4 4 1 10\n5 1 1 3\n0\n";
    let folder = folder(&[("a.poly", poly)]);
    let made = refine(&folder, "a.poly --max-side 2 -o m.json");
    let mesh = object(folder.path(), "m.json");
    let points = mesh["points"].as_array().expect("points");
    let new = points.len() - 4;
    let (parts, triangles) = (count(&mesh["edges"]), count(&mesh["triangles"]));
    let summary = format!(
        "a.poly: points 4 and {new} new, edges 5 in {parts} parts, triangles {triangles}, out of bounds 0\n"
    );
    assert_eq!(text(&made.stdout), summary);
    assert_eq!(
        text(&made.stderr),
        format!("note: a.poly: {new} heights are interpolated\n")
    );
    for point in points {
        let [x, y, z] = [0, 1, 2].map(|i| point[i].as_f64().expect("a number"));
        assert!((z - (2.0 * x - y)).abs() < 1e-12, "{point}");
    }
    let split = mesh["split"].as_array().expect("a chain for each edge");
    let ends = split
        .iter()
        .map(|chain| json!([chain[0], chain[count(chain) - 1]]));
    assert_eq!(
        Value::from_iter(ends),
        json!([[0, 1], [1, 2], [2, 3], [3, 0], [0, 0]])
    );
    let pieces = split.iter().map(|chain| (count(chain) - 1).max(1));
    let markers = [7, 8, 9, 10, 3].iter().zip(pieces);
    let markers = markers.flat_map(|(&marker, pieces)| vec![marker; pieces]);
    assert_eq!(mesh["edge_markers"], Value::from_iter(markers));
}

/// The sample A of Triangle has 56 vertices and 60 triangles after `triangle -pq`, at 20 degrees.
#[test]
fn about_as_few_vertices_as_triangle_adds() {
    let folder = folder(&[]);
    let output = format!("-o {}/m.json", folder.path().display());
    printed(&refine(MESHES, &format!("a.json {output}")));
    let mesh = object(folder.path(), "m.json");
    assert_eq!(
        (count(&mesh["points"]), count(&mesh["triangles"])),
        (58, 62)
    );
    // Both keep 20 degrees.
    printed(&verify(MESHES, "a.pq.json --min-angle 20"));
    printed(&verify(&folder, "m.json --min-angle 20"));
}

#[test]
fn regions_have_areas_of_their_own() {
    let poly = FRAME.replace("1 1 2 0.5\n", "1 1 2 0.5 0.5\n");
    let folder = folder(&[("a.poly", &poly)]);
    let largest = |arguments: &str| {
        let made = refine(&folder, &format!("a.poly -o m.json {arguments}"));
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        let found = verify(&folder, "m.json --max-area 1e-300 --json --limit 100000");
        let record: Value = serde_json::from_str(text(&found.stdout)).expect("JSON");
        let found = record["bounds"]["violations"]
            .as_array()
            .expect("violations");
        let sizes = found
            .iter()
            .map(|one| one["size"].as_f64().expect("a number"));
        sizes.fold(0.0, f64::max)
    };
    assert!(largest("") <= 0.5);
    assert!(largest("--region-area 1=2") > 0.5);
    assert!(largest("--region-area 1=2") <= 2.0);
    assert!(largest("--region-area 1=2 --max-area 0.25") <= 0.25);
    let unknown = refine(&folder, "a.poly --region-area 7=1");
    assert_fails(&unknown, r#"a.poly: region "7" is not one of 1"#);
    let unused =
        "1 area of a region is not used: the rule hull has no regions (--inside holes has regions)";
    let made = refine(&folder, "a.poly --inside hull --min-angle 20");
    assert_eq!(text(&made.stderr), format!("note: a.poly: {unused}\n"));
    let refused = refine(&folder, "a.poly --inside hull --strict");
    assert_fails(
        &refused,
        &format!("a.poly: {unused}; --strict refuses that"),
    );
    let nothing = refine(&folder, "a.poly --inside hull --region-area 1=2");
    let advice = "nor any other region; the rule is hull: --inside holes has regions";
    assert_fails(
        &nothing,
        &format!(r#"a.poly: there is no region "1", {advice}"#),
    );
    let other = crate::run(&folder, "a.poly -o m.obj");
    assert_eq!(other.status.code(), Some(0));
    let ignored = "note: a.poly: ignored: 1 area of a region\n";
    assert!(
        text(&other.stderr).contains(ignored),
        "{}",
        text(&other.stderr)
    );
}

/// Areas of regions ask for their rule, as holes do.
#[test]
fn areas_count_without_holes() {
    let poly = FRAME.replace("1\n1 4 5\n1\n1 1 2 0.5\n", "0\n1\n1 1 2 0.5 0.5\n");
    let folder = folder(&[("a.poly", &poly)]);
    printed(&refine(&folder, "a.poly -o m.json"));
    let report = verify(&folder, "m.json --max-area 0.5");
    assert_eq!(report.status.code(), Some(1), "the square in it is free");
    let mesh = object(folder.path(), "m.json");
    assert!(count(&mesh["triangles"]) > 150, "{mesh}");
}

#[test]
fn what_stays_is_listed_with_its_reason() {
    // Two edges meet at 6 degrees.
    let sharp = r#"{"points": [[0,0],[10,0],[10,1]], "edges": [[0,1],[1,2],[2,0]]}"#;
    let folder = folder(&[("a.json", sharp), ("b.poly", FRAME)]);
    let made = refine(&folder, "a.json --limit 1");
    let note = "triangle breaks a bound still: a sharp corner of the input\n";
    assert_eq!(text(&made.stderr), format!("note: a.json: 1 {note}"));
    let mut lines = text(&made.stdout).lines();
    let summary = lines.next().expect("a summary");
    assert!(summary.ends_with(", out of bounds 1"), "{summary}");
    let listed = lines.next().expect("a triangle");
    assert!(listed.starts_with("triangle 0 (0, 0) "), "{listed}");
    assert!(
        listed.contains(" has an angle of 5.71059313749964"),
        "{listed}"
    );
    assert!(
        listed.ends_with(" degrees: a sharp corner of the input"),
        "{listed}"
    );
    let refused = "a.json: 1 triangle breaks a bound still: a sharp corner of the input; --strict refuses that";
    assert_fails(&refine(&folder, "a.json --strict -o m.obj"), refused);
    assert!(!folder.path().join("m.obj").exists());

    let made = refine(&folder, "b.poly --max-area 0.1 --max-points 30 --limit 2");
    let note = text(&made.stderr);
    assert!(
        note.ends_with(" triangles break a bound still: the limit of points\n"),
        "{note}"
    );
    let report = text(&made.stdout);
    assert!(
        report.contains("points 8 and 22 new") && report.contains("\nand "),
        "{report}"
    );

    let made = refine(&folder, "b.poly --max-side 1 --keep-boundary -o m.json");
    let note = text(&made.stderr);
    assert!(
        note.ends_with(" triangles break a bound still: the boundary is kept\n"),
        "{note}"
    );
    assert_eq!(count(&object(folder.path(), "m.json")["edges"]), 8);
}

#[test]
fn bounds_that_are_none_are_refused() {
    let folder = folder(&[("a.poly", FRAME)]);
    for (arguments, message) in [
        (
            "--min-angle 60",
            "the least angle must be at least 0 and below 60 degrees",
        ),
        ("--max-area 0", "the greatest area and side must be above 0"),
        (
            "--max-side nan",
            "the greatest area and side must be above 0",
        ),
        ("--min-angle 35", "give a limit of points (--max-points)"),
        (
            "--region-area 1",
            "it is no number of a region with an area above 0",
        ),
    ] {
        let refused = refine(&folder, &format!("a.poly {arguments}"));
        assert_eq!(refused.status.code(), Some(2), "{arguments}");
        assert!(
            text(&refused.stderr).contains(message),
            "{}",
            text(&refused.stderr)
        );
    }
    printed(&refine(
        &folder,
        "a.poly --min-angle 35 --max-points 9000 --max-area 9",
    ));
}

/// Of fractions vertices are halved exactly.
#[test]
fn fractions_stay_on_their_edges() {
    let thirds = r#"{"points": [["1/3",0],[3,"1/7"],[2,"5/3"]], "edges": [[0,1],[1,2],[2,0]]}"#;
    let folder = folder(&[("a.json", thirds)]);
    printed(&refine(&folder, "a.json --max-area 0.05 -o m.json"));
    let report = verify(
        &folder,
        "a.json m.json --steiner --max-area 0.05 --min-angle 0",
    );
    assert!(first_line(printed(&report)).ends_with(", the canonical one, within the bounds"));
}
