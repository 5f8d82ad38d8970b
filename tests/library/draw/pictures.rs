//! One picture of each kind, to the byte.

use std::io;
use std::ops::RangeInclusive;

use sweep_cdt::draw::{ResultPicture, StepsSheet, ViolationsPicture};
use sweep_cdt::formats::{Graph, ResultFormat, Source, read_result};
use sweep_cdt::verify::Verifier;
use sweep_cdt::{Triangulator, triangulate};

use crate::snapshots::assert_snapshot;

pub(crate) const NAMES: &[&str] = &[
    "picture_result",
    "picture_edge_event",
    "picture_legalization",
    "picture_violations",
];

/// Points around a cluster of four, and edges: one that pierces triangles, one that is a side already.
fn graph() -> Graph<f64> {
    let points = vec![
        [0.0, 0.0],
        [6.0, 0.5],
        [7.5, 3.5],
        [1.0, 6.0],
        [2.0, 2.0],
        [2.75, 2.0],
        [2.25, 2.75],
        [2.25, 1.5],
        [5.0, 4.0],
    ];
    Graph {
        points,
        edges: vec![[3, 1], [0, 4]],
        first_vertex: 1,
        first_edge: 1,
        ..Graph::default()
    }
}

fn text(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> String {
    let mut picture = Vec::new();
    write(&mut picture).expect("memory takes all");
    String::from_utf8(picture).expect("text")
}

#[test]
fn result() {
    let graph = graph();
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let picture = text(|out| ResultPicture::new(&graph, &result).write(out));
    assert_snapshot(NAMES[0], &picture);
}

fn sheet(steps: RangeInclusive<usize>, most: usize) -> String {
    let graph = graph();
    let mut events = Vec::new();
    Triangulator::new()
        .triangulate_observed(&graph.points, &graph.edges, |event| events.push(event))
        .expect("a correct input");
    let sheet = StepsSheet::new(&graph, &events).steps(steps).most(most);
    text(|out| sheet.write(out))
}

/// Pierced triangles and both pseudo-polygons; one step too many.
#[test]
fn edge_event() {
    assert_snapshot(NAMES[1], &sheet(72..=77, 5));
}

/// An illegal side, its flip, and tests with and without a circle.
#[test]
fn legalization() {
    assert_snapshot(NAMES[2], &sheet(50..=53, 60));
}

/// A flipped side, with circles of different size on either side, and a missing edge. The close-ups cut
/// lines off.
#[test]
fn violations() {
    let graph = graph();
    let result = triangulate(&graph.points, &[]).expect("a correct input");
    let mut list = result.canonical_triangles();
    list.retain(|corners| !(corners.contains(&4) && corners.contains(&5)));
    list.extend([[4, 7, 6], [7, 5, 6]]);
    let source = Source {
        name: "flipped.json".to_owned(),
        bytes: format!("{{\"triangles\": {list:?}}}").into_bytes(),
    };
    let triangles = read_result(ResultFormat::Json, &source, None, &graph).expect("a result");
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let violations = verdict.expect_err("a wrong result");
    let picture = ViolationsPicture::new(&graph, &triangles, &violations.list);
    assert_snapshot(NAMES[3], &text(|out| picture.write(out)));
}
