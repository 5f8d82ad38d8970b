//! This crate and `spade` on the same inputs, in turn, in one run.
//!
//! `cargo bench --bench peers [-- FOLDER]` takes a million uniform points and every `.poly` file of the
//! folder (`tests/data` unless named). Points without edges go to spade's `bulk_load`, others to its
//! `bulk_load_cdt`. Printed are median and minimum of nanoseconds a point, and their ratios.

mod inputs;

use std::time::Instant;

use inputs::Named;
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};
use sweep_cdt_testing::Input;

/// How often each program runs on each input; odd, so that there is a median.
const ROUNDS: usize = 9;

fn main() {
    println!(
        "{:24} {:>8} {:>8} {:>15} {:>15} {:>15}",
        "", "", "", "sweep-cdt", "spade", "ratio"
    );
    println!(
        "{:24} {:>8} {:>8} {:>8}{:>7} {:>8}{:>7} {:>8}{:>7}",
        "input", "points", "edges", "median", "min", "median", "min", "median", "min"
    );
    for Named { name, input } in inputs::inputs() {
        let mut ours = Vec::new();
        let mut theirs = Vec::new();
        for _ in 0..ROUNDS {
            let (our_triangles, our_time) = sweep(&input);
            let (their_triangles, their_time) = spade(&input);
            assert_eq!(our_triangles, their_triangles, "triangles of {name}");
            ours.push(our_time);
            theirs.push(their_time);
        }
        let [ours, theirs] = [ours, theirs].map(median_and_least);
        println!(
            "{name:24} {:>8} {:>8} {:>8.1}{:>7.1} {:>8.1}{:>7.1} {:>7.1}%{:>6.1}%",
            input.points.len(),
            input.edges.len(),
            ours[0],
            ours[1],
            theirs[0],
            theirs[1],
            100.0 * ours[0] / theirs[0],
            100.0 * ours[1] / theirs[1]
        );
    }
}

fn median_and_least(mut times: Vec<f64>) -> [f64; 2] {
    times.sort_by(f64::total_cmp);
    [times[times.len() / 2], times[0]]
}

/// How many triangles this crate finds, and the nanoseconds a point it takes.
fn sweep(input: &Input) -> (usize, f64) {
    let start = Instant::now();
    let result = sweep_cdt::triangulate(&input.points, &input.edges).expect("a valid input");
    (result.len(), per_point(start, input))
}

/// The same for `spade`.
fn spade(input: &Input) -> (usize, f64) {
    let points: Vec<Point2<f64>> = input
        .points
        .iter()
        .map(|&[x, y]| Point2::new(x, y))
        .collect();
    if input.edges.is_empty() {
        let start = Instant::now();
        let result = DelaunayTriangulation::<Point2<f64>>::bulk_load(points);
        let time = per_point(start, input);
        (result.expect("a valid input").num_inner_faces(), time)
    } else {
        let edges = input.edges.clone();
        let start = Instant::now();
        let result = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges);
        let time = per_point(start, input);
        (result.expect("a valid input").num_inner_faces(), time)
    }
}

fn per_point(start: Instant, input: &Input) -> f64 {
    1e9 * start.elapsed().as_secs_f64() / input.points.len() as f64
}
