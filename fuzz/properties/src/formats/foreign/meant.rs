//! The meaning of a file of a mesh.

/// The meaning of a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Meant {
    pub(super) points: Vec<[f64; 2]>,
    /// None, or one for each point.
    pub(super) heights: Vec<f64>,
    pub(super) edges: Vec<[usize; 2]>,
    pub(super) triangles: Vec<[usize; 3]>,
}
