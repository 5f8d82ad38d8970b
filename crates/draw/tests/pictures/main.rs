//! Pictures: one of each kind, to the byte, and details of larger ones, for which the snapshots are too small.

mod relief;
mod story;

use std::io;
use std::ops::RangeInclusive;

use sweep_cdt::trace::{Event, PointCase, PseudoPolygon, Vertex};
use sweep_cdt::verify::Verifier;
use sweep_cdt::{Algorithm, Pslg, Triangulator, Watch, triangulate};
use sweep_cdt_draw::{ResultPicture, StepsSheet, ViolationsPicture};
use sweep_cdt_formats::{Format, GraphFile, Numbering, Source, read_result};

/// Compares with the snapshot of this name.
fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Points around a cluster of four, and edges: one that pierces triangles, one that is a side already.
fn graph() -> Pslg<f64> {
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
    Pslg {
        points,
        edges: vec![[3, 1], [0, 4]],
        ..Pslg::default()
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
    let picture = ResultPicture::new(&graph, &result).numbering(Numbering::FROM_ONE);
    let picture = text(|out| picture.write(out));
    assert_snapshot("picture_result", &picture);
}

fn sheet(steps: RangeInclusive<usize>, most: usize) -> String {
    let graph = graph();
    let mut events = Vec::new();
    let mut push = |event| events.push(event);
    let watch = Watch::new().events(&mut push);
    let triangulator = Triangulator::new().algorithm(Algorithm::Paper);
    let result = triangulator.run(&graph.points, &graph.edges, watch);
    result.expect("a correct input");
    let sheet = StepsSheet::new(&graph, &events).steps(steps).most(most);
    text(|out| sheet.write(out))
}

/// Pierced triangles and both pseudo-polygons; one step too many.
#[test]
fn edge_event() {
    assert_snapshot("picture_edge_event", &sheet(72..=77, 5));
}

/// An illegal side, its flip, and tests with and without a circle.
#[test]
fn legalization() {
    assert_snapshot("picture_legalization", &sheet(50..=53, 60));
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
    let source = Source::new(
        "flipped.json",
        format!("{{\"triangles\": {list:?}}}").into_bytes(),
    );
    let file = GraphFile {
        numbering: Numbering::FROM_ONE,
        ..graph.clone().into()
    };
    let triangles = read_result(Format::Json, &source, None, &file).expect("a result");
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let violations = verdict.expect_err("a wrong result");
    let picture = ViolationsPicture::new(&file, &triangles, &violations.list);
    assert_snapshot("picture_violations", &text(|out| picture.write(out)));
}

fn raster(columns: usize, rows: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| [i % columns, i / columns].map(|x| x as f64);
    (0..columns * rows).map(at).collect()
}

fn drawn_result(points: Vec<[f64; 2]>, edges: Vec<[usize; 2]>) -> String {
    let graph = Pslg {
        points,
        edges,
        ..Pslg::default()
    };
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let mut picture = Vec::new();
    ResultPicture::new(&graph, &result)
        .write(&mut picture)
        .expect("memory takes all");
    String::from_utf8(picture).expect("text")
}

/// The last of these steps.
fn last_step(points: Vec<[f64; 2]>, events: &[Event]) -> String {
    let graph = Pslg {
        points,
        ..Pslg::default()
    };
    let mut sheet = Vec::new();
    StepsSheet::new(&graph, events)
        .steps(events.len()..=events.len())
        .write(&mut sheet)
        .expect("memory takes all");
    String::from_utf8(sheet).expect("text")
}

/// The numbers at vertices: texts without a class that are no words of the legend.
fn numbers(picture: &str) -> usize {
    let label = |line: &&str| line.starts_with("<text x=");
    let text = |line: &str| line.split(['>', '<']).nth(2).map(str::to_owned);
    let labels = picture.lines().filter(label).filter_map(text);
    labels.filter(|text| text.parse::<usize>().is_ok()).count()
}

#[test]
fn sixty_vertices_have_numbers_and_more_have_none() {
    assert_eq!(numbers(&drawn_result(raster(10, 6), vec![])), 60);
    assert_eq!(numbers(&drawn_result(raster(61, 1), vec![])), 0);
}

#[test]
fn what_is_given_twice_is_drawn_once() {
    let mut points = raster(3, 3);
    let once = drawn_result(points.clone(), vec![[0, 8]]);
    points.push(points[4]);
    let twice = drawn_result(points, vec![[0, 8], [8, 0], [9, 9]]);
    assert_eq!(numbers(&twice), 9);
    let edges = |picture: &str| {
        let edge = |line: &&str| line.starts_with("<path class=\"edge\"");
        let first = picture.lines().find(edge).expect("edges");
        first.to_owned()
    };
    assert_eq!(edges(&twice), edges(&once));
}

/// A layer of a large picture has several paths, which have nothing in common.
#[test]
fn long_layers_are_split() {
    let picture = drawn_result(raster(100, 100), vec![]);
    for class in ["side", "vertex"] {
        let start = format!("<path class=\"{class}\" d=\"");
        let paths: Vec<&str> = picture
            .lines()
            .filter_map(|line| line.strip_prefix(&start)?.strip_suffix("\"/>"))
            .collect();
        let pieces = |path: &&str| {
            path.split('M')
                .skip(1)
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let mut all: Vec<String> = paths.iter().flat_map(pieces).collect();
        let count = all.len();
        all.sort();
        all.dedup();
        assert!(count > 0 && all.len() == count, "{class}: {count}");
    }
    assert!(picture.matches("class=\"vertex\" d=").count() > 1);
}

#[test]
fn the_sweep_line_divides_a_row() {
    let v = Vertex::Input;
    let point = Event::Point {
        vertex: v(1),
        case: PointCase::Middle,
        segment: [v(0), Vertex::Right],
    };
    let sheet = last_step(raster(3, 1), &[point]);
    let count = |class: &str| sheet.matches(&format!("<circle class=\"{class}\"")).count();
    assert_eq!([count("swept"), count("vertex")], [2, 1]);
    assert_eq!(sheet.matches("<path class=\"sweep\"").count(), 1);

    let sheet = last_step(raster(3, 1), &[point, Event::Finalization]);
    assert_eq!(sheet.matches("<path class=\"sweep\"").count(), 0);
    assert_eq!(sheet.matches("<circle class=\"swept\"").count(), 3);
}

/// A step at one vertex of many shows the surroundings.
#[test]
fn a_step_at_a_vertex_shows_others_around_it() {
    let vertex = Vertex::Input(210);
    let sheet = last_step(raster(20, 20), &[Event::Sorted { vertex }]);
    let shown = sheet.matches("<circle class=\"vertex\"").count();
    assert!((100..300).contains(&shown), "{shown}");
}

/// Pseudo-polygons of an edge are gone when the next one is inserted.
#[test]
fn pseudo_polygons_belong_to_one_edge() {
    let v = Vertex::Input;
    let edge = Event::Edge {
        edge: 0,
        upper: v(8),
        lower: v(0),
    };
    let border = |vertex| Event::Border {
        polygon: PseudoPolygon::Upper,
        vertex: v(vertex),
    };
    let mut events = vec![edge, border(0), border(3), border(8)];
    let upper = |events: &[Event]| {
        let sheet = last_step(raster(3, 3), events);
        sheet.matches("<path class=\"upper\"").count()
    };
    assert_eq!(upper(&events), 1);
    events.push(edge);
    assert_eq!(upper(&events), 0);
}
