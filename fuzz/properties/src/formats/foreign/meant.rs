//! What a file of a mesh must be read as.

/// What a file means.
#[derive(Clone, Debug, Default)]
pub(super) struct Meant {
    pub(super) points: Vec<[f64; 2]>,
    /// None, or one for each point.
    pub(super) heights: Vec<f64>,
    pub(super) edges: Vec<[usize; 2]>,
    pub(super) triangles: Vec<[usize; 3]>,
}
