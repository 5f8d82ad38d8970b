//! Families of inputs that grow: each gives an input of about `n` points, for every `n`.
//!
//! They are the attacks on every promise about time. `cargo bench --bench growth` measures how time and
//! memory grow; the tests compare small members with the oracle.

mod chains;
mod crowds;
mod hubs;
mod outlines;
mod rows;

use crate::Input;

/// A family of inputs.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// What it is.
    pub name: &'static str,
    /// Its member of about `n` points; `n` is at least 100.
    pub member: fn(n: usize) -> Input,
}

/// All families.
pub fn all() -> impl Iterator<Item = Family> {
    let parts = [
        rows::FAMILIES,
        chains::FAMILIES,
        outlines::FAMILIES,
        hubs::FAMILIES,
        crowds::FAMILIES,
    ];
    parts.into_iter().flatten().copied()
}

/// Points without edges: number `i` of `n`.
fn points(n: usize, point: impl Fn(f64, f64) -> [f64; 2]) -> Input {
    Input {
        points: (0..n).map(|i| point(i as f64, n as f64)).collect(),
        edges: Vec::new(),
    }
}

/// The same points with each joined to the next.
fn path(mut input: Input) -> Input {
    input.edges = (1..input.points.len()).map(|i| [i - 1, i]).collect();
    input
}

/// The same points with each joined to the next, and the last to the first.
fn ring(input: Input) -> Input {
    let last = input.points.len() - 1;
    let mut input = path(input);
    input.edges.push([last, 0]);
    input
}

/// The same input with its points in a scattered order.
pub fn scattered(input: &Input) -> Input {
    let n = input.points.len();
    // A prime: coprime to every smaller n and to most larger ones.
    let stride = [7_368_787, 7_368_791]
        .into_iter()
        .find(|&p| !n.is_multiple_of(p));
    let stride = stride.expect("no n is a multiple of both");
    let order: Vec<usize> = (0..n).map(|i| i * stride % n).collect();
    input.permuted(&order)
}
