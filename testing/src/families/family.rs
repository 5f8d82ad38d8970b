//! A family, and the shapes that several families share.

use crate::Input;

/// A family of inputs.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// What it is.
    pub name: &'static str,
    /// Its member of about `n` points; `n` is at least 100.
    pub member: fn(n: usize) -> Input,
}

/// Points without edges: number `i` of `n`.
pub(super) fn points(n: usize, point: impl Fn(f64, f64) -> [f64; 2]) -> Input {
    Input {
        points: (0..n).map(|i| point(i as f64, n as f64)).collect(),
        edges: Vec::new(),
    }
}

/// The same points with each joined to the next.
pub(super) fn path(mut input: Input) -> Input {
    input.edges = (1..input.points.len()).map(|i| [i - 1, i]).collect();
    input
}

/// The same points with each joined to the next, and the last to the first.
pub(super) fn ring(input: Input) -> Input {
    let last = input.points.len() - 1;
    let mut input = path(input);
    input.edges.push([last, 0]);
    input
}
