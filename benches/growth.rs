//! How the time grows with the number of points on inputs that are hard for a sweep: points on a line, a
//! circle or a parabola, in one column or row, on a lattice; an edge through the whole front; a star of
//! edges.
//!
//! `cargo bench --bench growth [-- MOST [FRONT]]` goes up to `MOST` points (a million unless named) and
//! uses the front `hash` (unless named), `skip-list` or `linear`. Printed are nanoseconds a point and,
//! in brackets, that divided by log2 of the number of points: it stays level where the time grows as
//! n log n.

use std::f64::consts::TAU;
use std::time::Instant;

use sweep_cdt::Triangulator;
use sweep_cdt::front::{FrontSearch, HashTable, Linear, SkipList};

type Edges = Vec<[usize; 2]>;

/// A point of a family: number `i` of `n`.
type Family = fn(i: f64, n: f64) -> [f64; 2];
/// Its edges.
type EdgesOf = fn(n: usize) -> Edges;

const FAMILIES: &[(&str, Family, EdgesOf)] = &[
    ("line", |i, _| [i, 2.0 * i], no_edges),
    (
        "circle",
        |i, n| [(TAU * i / n).cos(), (TAU * i / n).sin()],
        no_edges,
    ),
    (
        "parabola, open above",
        |i, n| [i - n / 2.0, (i - n / 2.0).powi(2)],
        no_edges,
    ),
    (
        "parabola, open below",
        |i, n| [i - n / 2.0, -(i - n / 2.0).powi(2)],
        no_edges,
    ),
    (
        "parabola, open right",
        |i, n| [(i - n / 2.0).powi(2), i - n / 2.0],
        no_edges,
    ),
    (
        "parabola, open left",
        |i, n| [-(i - n / 2.0).powi(2), i - n / 2.0],
        no_edges,
    ),
    ("column", |i, _| [3.0, i], no_edges),
    ("row", |i, _| [i, 3.0], no_edges),
    (
        "column and one point",
        |i, n| if i < 1.0 { [-n, n / 3.0] } else { [3.0, i] },
        no_edges,
    ),
    (
        "row and one point",
        |i, n| if i < 1.0 { [n / 3.0, -n] } else { [i, 3.0] },
        no_edges,
    ),
    (
        "two slanted chains",
        |i, n| [i, i + n / 50.0 * (i % 2.0 - 0.5)],
        no_edges,
    ),
    (
        "lattice",
        |i, n| [i % n.sqrt().round(), (i / n.sqrt().round()).floor()],
        no_edges,
    ),
    ("edge through teeth", tooth, |n| vec![[0, n - 1]]),
    (
        "edge above teeth",
        |i, n| {
            if i < 1.0 || i > n - 1.5 {
                [i, 9.0]
            } else {
                [i, i % 2.0]
            }
        },
        |n| vec![[0, n - 1]],
    ),
    (
        "star at one upper end",
        |i, n| {
            if i < 1.0 {
                [n / 2.0, n]
            } else {
                [i, i * 7.0 % 11.0]
            }
        },
        star,
    ),
    (
        "star at one lower end",
        |i, n| {
            if i < 1.0 {
                [n / 2.0, -n]
            } else {
                [i, i * 7.0 % 11.0]
            }
        },
        star,
    ),
];

fn no_edges(_: usize) -> Edges {
    Vec::new()
}

/// Teeth on both sides of the line from the first to the last point. They stay on the front, as their
/// angles are wide, until the last point comes, above nearly all of them.
fn tooth(i: f64, n: f64) -> [f64; 2] {
    let height = if i < 1.0 || i > n - 1.5 {
        0.0
    } else {
        0.6 * (i % 2.0 - 0.5)
    };
    [i, 2.0 * i / n + height]
}

/// Every point joined to the first.
fn star(n: usize) -> Edges {
    (1..n).map(|i| [i, 0]).collect()
}

fn main() {
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    let most = arguments
        .first()
        .map_or(1_000_000, |text| text.parse().expect("a number of points"));
    match arguments.get(1).map_or("hash", String::as_str) {
        "hash" => table::<HashTable>(most),
        "skip-list" => table::<SkipList>(most),
        "linear" => table::<Linear>(most),
        front => panic!("no front {front}: hash, skip-list or linear"),
    }
}

fn table<F: FrontSearch + Clone + Default>(most: usize) {
    let sizes: Vec<usize> = [10_000, 100_000, 1_000_000, 10_000_000]
        .into_iter()
        .filter(|&n| n <= most)
        .collect();
    print!("{:24}", "ns a point (by log n)");
    sizes.iter().for_each(|n| print!(" {n:>18}"));
    println!();
    for &(name, family, edges) in FAMILIES {
        print!("{name:24}");
        for &n in &sizes {
            let time = time::<F>(n, family, edges);
            print!(
                " {:>18}",
                format!("{time:.1} ({:.2})", time / (n as f64).log2())
            );
        }
        println!();
    }
}

/// Nanoseconds a point, the least of three runs. The points come in a scattered order.
fn time<F: FrontSearch + Clone + Default>(n: usize, family: Family, edges: EdgesOf) -> f64 {
    // Coprime to every n of the table.
    const STRIDE: usize = 7_368_787;
    let place = |i: usize| i * STRIDE % n;
    let mut points = vec![[0.0; 2]; n];
    for i in 0..n {
        points[place(i)] = family(i as f64, n as f64);
    }
    let edges: Edges = edges(n).into_iter().map(|edge| edge.map(place)).collect();
    let run = || {
        let start = Instant::now();
        let result = Triangulator::new()
            .front(F::default())
            .triangulate(&points, &edges);
        let time = start.elapsed();
        result.expect("a valid input");
        1e9 * time.as_secs_f64() / n as f64
    };
    (0..3).map(|_| run()).fold(f64::INFINITY, f64::min)
}
