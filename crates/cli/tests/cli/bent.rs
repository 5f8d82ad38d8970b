//! Meshes with vertices that were added on edges, and rounded, by programs: verified against what they were made of.
//!
//! `a.json` is the sample A of Triangle, and `a.pq.json` its mesh by the options `pq` (package `triangle` of `PyPI`,
//! 20250106); `gmsh.json` is a polygon with a hole and an edge, and `gmsh.msh` its mesh by Gmsh, which prints 16 digits.

use std::fs;

use serde_json::Value;

use crate::verify::{first_line, refuted, verify};
use crate::{folder, printed, run, text};

pub(crate) const MESHES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/meshes");

#[test]
fn rounded_vertices_on_edges_are_within_their_depth() {
    for (files, deepest) in [("a.json a.pq.json", "9.9e-17"), ("gmsh.json gmsh.msh", "")] {
        let wrong = verify(MESHES, &format!("{files} --steiner"));
        let report = refuted(&wrong);
        assert!(
            report.contains("bent-boundary: the boundary from vertex"),
            "{report}"
        );
        let advice = report.lines().next_back().unwrap();
        assert!(
            advice.contains("`--max-depth 1e-12` accepts them"),
            "{advice}"
        );
        let within = verify(MESHES, &format!("{files} --steiner --max-depth 1e-12"));
        let report = text(&within.stdout);
        assert_eq!(within.status.code(), Some(3), "{report}");
        let line = first_line(report);
        assert!(line.starts_with("up to 1e-12: "), "{line}");
        assert!(
            line.contains(&format!("the deepest by {deepest}")),
            "{line}"
        );
        assert!(report.contains("  by ") && report.contains("of the distance of the two ends"));
        // No vertex may be farther than that.
        let less = verify(MESHES, &format!("{files} --steiner --max-depth 1e-17"));
        assert_eq!(less.status.code(), Some(1));
    }
}

#[test]
fn moved_vertices_are_not() {
    let folder = folder(&[]);
    let path = folder.path();
    fs::copy(format!("{MESHES}/a.json"), path.join("a.json")).unwrap();
    let mesh = fs::read_to_string(format!("{MESHES}/a.pq.json")).unwrap();
    let mesh: Value = serde_json::from_str(&mesh).unwrap();
    let own = 29;
    for v in own..mesh["points"].as_array().unwrap().len() {
        let mut moved = mesh.clone();
        // In a direction of no edge.
        for (axis, by) in [(0, 1e-3), (1, 1.7e-3)] {
            let x = mesh["points"][v][axis].as_f64().unwrap();
            moved["points"][v][axis] = (x + by).into();
        }
        fs::write(path.join("r.json"), moved.to_string()).unwrap();
        let output = verify(
            path,
            "a.json r.json --steiner --max-depth 1e-6 --level tiling",
        );
        let is_inner = output.status.code() == Some(3);
        // Only vertices inside may be anywhere.
        let [x, y] = [0, 1].map(|i| mesh["points"][v][i].as_f64().unwrap());
        assert_eq!(
            is_inner,
            !is_on_edge(&mesh, [x, y], own),
            "{v} {}",
            text(&output.stdout)
        );
    }
}

/// Whether a point is near the outline of the sample.
fn is_on_edge(mesh: &Value, p: [f64; 2], own: usize) -> bool {
    let input: Value =
        serde_json::from_str(&fs::read_to_string(format!("{MESHES}/a.json")).unwrap()).unwrap();
    let at = |v: &Value| {
        let v = usize::try_from(v.as_u64().unwrap()).unwrap();
        assert!(v < own);
        [0, 1].map(|i| mesh["points"][v][i].as_f64().unwrap())
    };
    let edges = input["edges"].as_array().unwrap();
    edges.iter().any(|edge| {
        let [a, b] = [at(&edge[0]), at(&edge[1])];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        let dot = (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1]);
        cross.abs() < 1e-9 && (0.0..=length * length).contains(&dot)
    })
}

#[test]
fn split_crossings_are_verified_against_their_file() {
    let folder = folder(&[]);
    let path = folder.path();
    let crossing =
        r#"{"points": [[0,0],[7,1],[6,8],[1,5],[2,0.1],[3,9]], "edges": [[0,2],[1,3],[4,5]]}"#;
    fs::write(path.join("x.json"), crossing).unwrap();
    let made = run(path, "x.json -o split.obj --split-crossings");
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let output = verify(path, "x.json split.obj --steiner --max-depth 1e-12");
    let report = text(&output.stdout);
    assert!(matches!(output.status.code(), Some(0 | 3)), "{report}");
    assert!(report.contains("split edges"), "{report}");
    // An edge that is not there is missed.
    fs::write(
        path.join("y.json"),
        crossing.replace("[4,5]]", "[4,5],[0,5]]"),
    )
    .unwrap();
    let other = verify(path, "y.json split.obj --steiner --max-depth 1e-6");
    assert_eq!(other.status.code(), Some(1), "{}", text(&other.stdout));
    // In fractions nothing is rounded.
    let options = "x.json -o exact.json --split-crossings --scalar rational";
    printed(&run(path, options));
    printed(&verify(
        path,
        "x.json exact.json --steiner --scalar rational",
    ));
    let unread = verify(path, "x.json exact.json --steiner");
    let error = text(&unread.stderr);
    assert!(
        error.contains("--scalar rational reads both exactly"),
        "{error}"
    );
}
