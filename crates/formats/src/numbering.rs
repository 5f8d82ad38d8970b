//! The numbers that a file gives to what it holds, and where it lies among several that are put together.

use std::ops::Range;

/// How a file counts: its number of the first thing of each kind, 0 or 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Numbering {
    /// The number of the first vertex.
    pub vertex: usize,
    /// The number of the first edge.
    pub edge: usize,
    /// The number of the first hole.
    pub hole: usize,
    /// The number of the first region.
    pub region: usize,
}

impl Numbering {
    /// A file that counts all things from 1.
    pub const FROM_ONE: Numbering = Numbering {
        vertex: 1,
        edge: 1,
        hole: 1,
        region: 1,
    };

    /// The numbers that the file gives to edges.
    ///
    /// ```
    /// use sweep_cdt_formats::Numbering;
    ///
    /// assert_eq!(Numbering::FROM_ONE.edges([0, 2]), [1, 3]);
    /// ```
    #[must_use]
    pub fn edges(self, edges: [usize; 2]) -> [usize; 2] {
        edges.map(|edge| edge.saturating_add(self.edge))
    }
}

/// A file among those that a [`GraphFile`](crate::GraphFile) is put together from: which part of the whole it is. All are
/// positions in the whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layer {
    /// The name of the file in messages.
    pub name: String,
    /// How the file counts.
    pub numbering: Numbering,
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its edges.
    pub edges: Range<usize>,
    /// Its seeds of holes.
    pub holes: Range<usize>,
    /// Its seeds of regions.
    pub regions: Range<usize>,
    /// Its features: the first one has the number after `start`.
    pub features: Range<usize>,
}
