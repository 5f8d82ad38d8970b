//! Traces. Here: the steps that the figures of the paper show, and what becomes of degenerate inputs; the same
//! steps for every scalar and front, on small inputs and where the front is long and searches jump.
//!
//! `replay`: a replay returns the result, and refuses a damaged trace. `formats`: how steps are written.

mod formats;
mod replay;

use std::fmt::Write;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::trace::Event;
use sweep_cdt::{Corners, Heuristics};
use sweep_cdt_testing::generators::medium;
use sweep_cdt_testing::runs::{Sample, convert};
use sweep_cdt_testing::{AnyFront, Input, Random, Steps, data};
use sweep_cdt_trace::Trace;
use sweep_cdt_trace::write_trace;

use crate::{assert_snapshot, cases};

const OFF: Heuristics = Heuristics::OFF;
const PAPER: Heuristics = Heuristics::PAPER;
const HEURISTICS: [Heuristics; 3] = [Heuristics::FAST, PAPER, OFF];

/// The steps of the default scalar and front.
fn steps(input: &Input, heuristics: Heuristics) -> Steps {
    Steps::of(&input.points, &input.edges, heuristics)
}

fn text(trace: &Trace) -> String {
    let mut text = Vec::new();
    trace.write_text(&mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

fn lines(trace: &Trace) -> String {
    let mut text = Vec::new();
    write_trace(trace, &mut text).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

/// The basin heuristic alone.
fn basins() -> Heuristics {
    let mut heuristics = PAPER;
    heuristics.corners = Corners::Off;
    heuristics
}

/// The cases of the figures and of degenerate inputs, each with the lines of the trace that show what its figure
/// does.
macro_rules! cases {
    ($($name:ident: $heuristics:expr, $points:literal, $edges:literal, [$($line:literal),* $(,)?];)*) => {
        /// The names of the snapshots.
        pub(crate) const NAMES: &[&str] = &[$(stringify!($name)),*];
        $(
            #[test]
            fn $name() {
                let input = Input::parse($points, $edges);
                check(stringify!($name), &input, $heuristics, &[$($line),*]);
            }
        )*
    };
}

cases! {
    figure_02_fixed_edge: OFF, "0 0, 8 1, 4 2, 4.5 2.75", "1 2",
        ["fixed 2 1", "test 2 1 against 3 0: fixed"];
    figure_03_legalization: OFF, "0 0, 10 3, 2 5, 5 5.75", "",
        ["test 2 1 against 3 0: illegal", "flip 2 1 to 3 0"];
    figure_04_advancing_front: OFF, "0 0, 10 3, 2 5, -2 5.25, 12 5.5, 5 5.75", "",
        ["point 5: middle case, projected on segment 2 1", "triangle 5 2 1 (point)", "flip 2 1 to 5 0", "front gains 5 after 2"];
    figure_05_edges_at_upper_ends: OFF, "0 0, 6 0, 3 2, 1 5, 6 5", "0 3, 3 1, 3 4, 4 1",
        ["edge 0: from 3 down to 0", "edge 1: from 3 down to 1", "edge 2: from 4 down to 3", "edge 3: from 4 down to 1"];
    figure_06_first_triangle: OFF, "2 1", "",
        ["triangle 0 P-1 P-2 (first)", "front gains 0 after P-1"];
    figure_07_middle_case: OFF, "0 0, 9 1, 4 6", "",
        ["point 2: middle case, projected on segment 0 1", "triangle 2 0 1 (point)", "front gains 2 after 0"];
    figure_08_left_case: OFF, "0 0, 9 1, 4 2, 4 6", "",
        ["point 3: left case, projected on segment 2 1", "triangle 3 2 1 (point)", "triangle 3 0 2 (point)", "front loses 2"];
    figure_09_narrow_corner: PAPER, "0 0, 6 1, 12 2, 14 8, 7 9", "",
        ["point 4: middle case, projected on segment 1 2", "triangle 4 2 3 (narrow corner)", "front loses 2"];
    figure_10_basin: basins(), "0 0.25, 2 0, 4 0.125, 6 4.5, -6 5, -6.5 9.5", "",
        ["point 5: middle case, projected on segment P-1 4", "front loses 0", "front loses 1", "front loses 2"];
    figure_11_first_pierced_triangle: PAPER, "0 0, 6 1, 3 2, 5 4, 2 8", "1 4",
        ["part 4 1: below the front", "pierced 4 2 3"];
    figure_12_pseudo_polygons: PAPER, "0 0, 4 0.5, 7 3, 2 4, 5 6, 10 8", "0 5",
        ["part 5 0: below the front", "border 3 (upper pseudo-polygon)", "border 2 (lower pseudo-polygon)"];
    figure_13_front_only: OFF, "2 0, 1 1, 3 1.5, 0 5, 4 6", "3 4",
        ["switch to the front at 4 4", "part 4 3: front only", "triangle 2 4 3 (pocket)"];
    figure_14_mixed: OFF, "0 1, 3 6, 5 0, 7 7, 9 2, 11 9, 12 3, 14 10", "0 7",
        ["switch to triangles at 5 6", "switch to the front at 4 5", "switch to triangles at 3 4", "switch to the front at 2 3", "part 7 0: mixed"];
    figure_15_upper_hull: OFF, "0 0, 2 1, -2 1.5, 3 2.25, -3 3", "",
        ["triangle 2 0 4 (upper hull)"];
    figure_15_lower_hull: OFF, "0 0, 3 1, 6 1.5, 2 4", "",
        ["test 1 P-2 against 2 0: illegal", "flip 1 P-2 to 2 0"];
    edge_present: OFF, "0 0, 4 0, 1 3", "2 0", ["part 2 0: there already", "fixed 2 0"];
    vertex_on_edge: OFF, "0 0, 4 4, 2 2, 3 0, 0 3", "0 1",
        ["part 1 2: front only", "part 2 0: there already", "fixed 1 2", "fixed 2 0"];
    hanging_edge: OFF, "-3 -96, -1 -53, 2 -101, -2 -74, -1 -106, 0 -83, -2 -95", "4 1, 6 0",
        ["fixed 6 0"];
    overlapping_edges: OFF, "0 0, 2 1, 4 2, 6 3, 3 4, 3 -4", "0 2, 1 3",
        ["fixed 2 1", "part 2 1: there already"];
    crossing_edges: OFF, "0 0, 4 4, 0 4, 4 0", "0 1, 2 3", ["error: edges 0 and 1 cross"];
    no_points: OFF, "", "", ["finished: 0 triangles"];
    collinear_points: OFF, "0 0, 2 1, 6 3, 4 2", "0 2", ["fixed 2 3", "finished: 0 triangles"];
    row_of_points: PAPER, "0 0, 1 0, 2 0, 1 1", "", ["finished: 2 triangles"];
    column_of_points: OFF, "0 0, 0 1, 0 2, 1 1", "", ["finished: 2 triangles"];
    duplicate_points: OFF, "0 0, 2 0, 0 0, 1 2, 2 0", "2 4, 0 2", ["edge 0: from 1 down to 0"];
    cocircular_points: OFF, "5 0, 4 3, 3 4, 0 5, -3 4, -4 3", "", ["finished: 4 triangles"];
    lattice: PAPER, "0 0, 1 0, 2 0, 0 1, 1 1, 2 1", "", ["finished: 4 triangles"];
}

/// Compares the story of an input with its snapshot.
fn check(name: &str, input: &Input, heuristics: Heuristics, lines: &[&str]) {
    let Steps { trace, result, .. } = Steps::of(&input.points, &input.edges, heuristics);
    let mut story = String::new();
    for (index, [x, y]) in input.points.iter().enumerate() {
        writeln!(story, "vertex {index} at {x} {y}").expect("memory takes all");
    }
    for (index, [a, b]) in input.edges.iter().enumerate() {
        writeln!(story, "edge {index} between {a} and {b}").expect("memory takes all");
    }
    for (index, event) in trace.events.iter().enumerate() {
        let opens = match event {
            Event::Sorted { .. } => index == 0,
            Event::Triangle { .. } => matches!(trace.events[index - 1], Event::Sorted { .. }),
            Event::Point { .. } | Event::Edge { .. } | Event::Finalization => true,
            _ => false,
        };
        let gap = if opens { "\n" } else { "" };
        writeln!(story, "{gap}{event}").expect("memory takes all");
    }
    match result {
        Ok(result) => {
            assert_eq!(trace.replay(), Ok(result.canonical_triangles()));
        }
        Err(error) => writeln!(story, "\nerror: {error}").expect("memory takes all"),
    }
    assert_snapshot(name, &story);
    for line in lines {
        assert!(
            story.lines().any(|other| other == *line),
            "no line `{line}` in\n{story}"
        );
    }
}

/// Panics unless the steps in these numbers, if they hold the points, are the same with every front.
fn assert_same<S: Sample>(input: &Input, expected: &Steps) {
    if let Some(points) = convert::<S>(&input.points) {
        for mut front in AnyFront::all() {
            let name = format!("{}, {}", std::any::type_name::<S>(), front.name());
            expected.assert_same(&points, &input.edges, &mut front, &name);
        }
    }
}

#[test]
fn every_scalar_and_front_on_every_case() {
    for (name, input) in cases::all() {
        println!("{name}");
        for heuristics in HEURISTICS {
            let expected = steps(&input, heuristics);
            assert_same::<f64>(&input, &expected);
            assert_same::<f32>(&input, &expected);
            assert_same::<i32>(&input, &expected);
            assert_same::<i64>(&input, &expected);
            assert_same::<BigInt>(&input, &expected);
            assert_same::<BigRational>(&input, &expected);
        }
    }
}

/// Panics, with the first step that differs, unless fronts and scalars take the same steps.
fn assert_same_steps(input: &Input, heuristics: Heuristics) {
    let Input { points, edges } = input;
    let expected = steps(input, heuristics);
    assert!(expected.result.is_ok(), "{:?}", expected.result);
    assert!(expected.trace.events.len() > 3 * points.len());
    // The steps are those of the first one.
    for mut front in AnyFront::all().into_iter().skip(1) {
        let name = front.name();
        expected.assert_same(points, edges, &mut front, name);
    }
    let points = convert::<BigRational>(points).expect("a rational holds a double");
    expected.assert_same(&points, edges, &mut AnyFront::default(), "BigRational");
}

#[test]
fn hundreds_of_points_and_edges() {
    for seed in 0..40 {
        println!("seed {seed}");
        let input = medium(&mut Random::new(seed));
        for heuristics in HEURISTICS {
            assert_same_steps(&input, heuristics);
        }
    }
}

#[test]
fn thousands_of_points_even_and_skewed() {
    let mut random = Random::new(1);
    // By the cube most points are where intervals of equal width would be few.
    for power in [1, 3] {
        let mut at = || random.integer(1 << 20).powi(power);
        let points = (0..5000).map(|_| [at(), at()]).collect();
        let edges = Vec::new();
        assert_same_steps(&Input { points, edges }, Heuristics::FAST);
    }
}

#[test]
fn contours() {
    let input = data::contours();
    assert_same_steps(&input, Heuristics::FAST);
    assert_same_steps(&input, Heuristics::PAPER);
}
