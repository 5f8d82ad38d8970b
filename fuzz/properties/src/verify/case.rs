//! What is verified.

/// A triangulation to verify.
#[derive(Debug, Default)]
pub(super) struct Case {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) edges: Vec<[usize; 2]>,
    pub(super) triangles: Vec<[usize; 3]>,
}
