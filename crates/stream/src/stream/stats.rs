//! What has come and gone in a stream, and what is alive.

/// Counts of a [`Stream`](super::Stream).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StreamStats {
    /// Vertices that have come, without duplicates.
    pub vertices: u64,
    /// Vertices that equal their predecessor.
    pub duplicates: u64,
    /// Edges that have begun, without those of no length.
    pub edges: u64,
    /// Triangles that have been passed on.
    pub triangles: u64,
    /// Sides of the hull that have been passed on.
    pub hull_sides: u64,
    /// Windows that have been triangulated.
    pub windows: u64,
    /// What is alive after the last window.
    pub alive: Alive,
    /// What was alive after the window that left most vertices.
    pub most_alive: Alive,
}

/// What stays in memory after a window, and what it waits for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Alive {
    /// Vertices of all that is alive.
    pub vertices: usize,
    /// Triangles whose circle reaches the sweep line.
    pub circles: usize,
    /// Triangles that an edge pierces whose upper end has not come.
    pub edges: usize,
    /// Sides of the hull beyond which vertices may come.
    pub hull_sides: usize,
}

impl StreamStats {
    /// Counts windows, after which this is alive.
    pub(super) fn after(&mut self, windows: u64, alive: Alive) {
        self.windows += windows;
        self.alive = alive;
        if alive.vertices > self.most_alive.vertices {
            self.most_alive = alive;
        }
    }
}
