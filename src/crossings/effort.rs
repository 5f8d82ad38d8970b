//! How long a search goes on, how much it may find, and what it has done.

/// Bounds of a search for crossings, which tests make small, and counts of its work, which they look at.
#[derive(Clone, Debug)]
pub struct Effort {
    /// How many boxes may meet in vain for each edge and each crossing, before edges are separated.
    pub patience: usize,
    /// How many crossings may be listed.
    pub limit: usize,
    /// Boxes looked at: each once for each part that it is in or is compared with, and once for each pair.
    pub visited: u64,
    /// Edges given to the sweep line.
    pub swept: u64,
    /// Edges given to a triangulation.
    pub separated: u64,
}

impl Default for Effort {
    fn default() -> Effort {
        Effort {
            patience: 8,
            limit: 1 << 22,
            visited: 0,
            swept: 0,
            separated: 0,
        }
    }
}

impl Effort {
    pub(super) fn visit(&mut self, boxes: usize) {
        self.visited += boxes as u64;
    }
}
