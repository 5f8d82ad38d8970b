//! The amount of work for larger inputs: a change must be looked at.

use std::path::Path;

use sweep_cdt::formats::{Input as Read, InputFormat, Source, read};
use sweep_cdt::{Heuristics, Triangulator};

use crate::assert_snapshot;

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
        let (_, stats) = run.expect("a valid input");
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
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/isolines_small.poly");
    let source = Source {
        name: path.display().to_string(),
        bytes: std::fs::read(&path).expect("a readable file"),
    };
    let input = read(InputFormat::Poly, &source, None);
    let Ok(Read::Doubles(graph)) = input else {
        panic!("doubles are in {}", source.name);
    };
    check("work_contours", &graph.points, &graph.edges);
}

/// Points by chance in a square, x to some power: the higher, the more lie on the left.
fn by_chance(count: usize, power: i32) -> Vec<[f64; 2]> {
    // Knuth's MMIX generator; its upper 32 bits.
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005);
        state = state.wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).expect("32 bits")) / 4_294_967_296.0
    };
    (0..count).map(|_| [next().powi(power), next()]).collect()
}

#[test]
fn uniform() {
    check("work_uniform", &by_chance(10_000, 1), &[]);
}

#[test]
fn crowded() {
    // Not so much that the hash table gives up equal intervals; so much that it does.
    for (name, power) in [("work_crowded", 2), ("work_crowded_more", 3)] {
        let points = by_chance(5000, power);
        let points: Vec<_> = points.iter().map(|[x, y]| [x - 0.25, *y]).collect();
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
