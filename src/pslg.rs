//! The input as one value: the planar straight-line graph (figure 1a), with seeds of holes and regions.

use alloc::vec::Vec;

/// A planar straight-line graph: the input to triangulate, and what of the result counts as inside.
///
/// ```
/// use sweep_cdt::Pslg;
///
/// let graph = Pslg {
///     points: vec![[0, 0], [3, 0], [3, 2], [0, 2]],
///     edges: vec![[1, 3]],
///     ..Pslg::default()
/// };
/// assert_eq!(sweep_cdt::triangulate(&graph.points, &graph.edges)?.len(), 2);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pslg<S> {
    /// The points.
    pub points: Vec<[S; 2]>,
    /// The edges, as positions in `points`.
    pub edges: Vec<[usize; 2]>,
    /// Points that stand for the holes they lie in.
    pub holes: Vec<[S; 2]>,
    /// Points that stand for the regions they lie in.
    pub regions: Vec<Region<S>>,
}

impl<S> Default for Pslg<S> {
    fn default() -> Pslg<S> {
        Pslg {
            points: Vec::new(),
            edges: Vec::new(),
            holes: Vec::new(),
            regions: Vec::new(),
        }
    }
}

/// A region of a [`Pslg`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Region<S> {
    /// A point in the region.
    pub seed: [S; 2],
    /// The number that the triangles of the region bear.
    pub attribute: f64,
}
