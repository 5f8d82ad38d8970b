//! What several kinds need.

use sweep_cdt_testing::Input;

/// Points without edges.
pub(super) fn only(points: Vec<[f64; 2]>) -> Input {
    Input {
        points,
        edges: Vec::new(),
    }
}

/// Numbers 0 to n - 1 as doubles.
pub(super) fn numbers(n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(|i| i as f64)
}
