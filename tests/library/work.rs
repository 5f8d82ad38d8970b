//! The amount of work for larger inputs: a change must be looked at.

use sweep_cdt::{Heuristics, Triangulator};
use sweep_cdt_testing::{Input, Random, data};

use crate::snapshots::assert_snapshot;

/// The names of the snapshots.
pub(crate) const NAMES: &[&str] = &[
    "work_comb",
    "work_contours",
    "work_crowded",
    "work_crowded_more",
    "work_lattice",
    "work_uniform",
];

/// Compares all counters with a snapshot.
fn check(name: &str, points: &[[f64; 2]], edges: &[[usize; 2]]) {
    let mut text = format!("points {}\nedges {}\n", points.len(), edges.len());
    for (setting, heuristics) in [("fast", Heuristics::FAST), ("paper", Heuristics::PAPER)] {
        let triangulator = Triangulator::new().heuristics(heuristics);
        let run = triangulator.triangulate_with_stats(points, edges);
        let stats = run.expect("a valid input").stats;
        text += &format!("\n{setting} heuristics\n");
        // All counters, whatever there will be: `name: number,` in the middle of the debug format.
        for line in format!("{:#?}", stats.counters).lines() {
            if let Some((name, number)) = line.trim().trim_end_matches(',').split_once(": ") {
                text += &format!("{name} {number}\n");
            }
        }
    }
    assert_snapshot(name, &text);
}

#[test]
fn contours() {
    let Input { points, edges } = data::contours();
    check("work_contours", &points, &edges);
}

#[test]
fn uniform() {
    check("work_uniform", &Random::new(1).points(10_000), &[]);
}

#[test]
fn crowded() {
    // First so little that the hash table keeps intervals of equal width, then so much that it does not.
    for (name, power) in [("work_crowded", 2), ("work_crowded_more", 3)] {
        // The higher the power of x, the more points lie on the left.
        let points = Random::new(1).points(5000);
        let crowded = |[x, y]: &[f64; 2]| [x.powi(power) - 0.25, *y];
        let points: Vec<_> = points.iter().map(crowded).collect();
        check(name, &points, &[]);
    }
}

#[test]
fn lattice() {
    let points: Vec<[f64; 2]> = (0..10_000)
        .map(|i| [i % 100, i / 100].map(f64::from))
        .collect();
    check("work_lattice", &points, &[]);
}

#[test]
fn comb() {
    // Teeth of the front along a slope, and an edge through all of them.
    let tooth = |i: u32| {
        let x = f64::from(i);
        let length = 1.0 + f64::from(i * 7 % 10) / 16.0;
        [
            x,
            if i.is_multiple_of(2) {
                x - length
            } else {
                x + length
            },
        ]
    };
    let mut points: Vec<[f64; 2]> = (1..=2000).map(tooth).collect();
    let ends = [points.len(), points.len() + 1];
    points.extend([[0.0, 0.0], [2001.0, 2001.0]]);
    check("work_comb", &points, &[ends]);
}
