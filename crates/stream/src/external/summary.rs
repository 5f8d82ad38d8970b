//! What is known of an input when it is sorted, and what sorting costs.

use std::time::Duration;

/// What is known when all is sorted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// How many points there are, equal ones included.
    pub points: u64,
    /// How many edges come with the vertices.
    pub edges: u64,
    /// No line of the sweep passes more edges than so many, counted in strips of y.
    pub open_edges: u64,
    /// How many edges have no length, and do not come.
    pub edges_without_length: u64,
    /// The least and the greatest x; infinite, and the wrong way round, without points.
    pub x: [f64; 2],
    /// The least and the greatest y, likewise.
    pub y: [f64; 2],
    /// The power of two of which all x and y are whole multiples, the greatest one; 0 if all are 0.
    pub exponent: i64,
    /// The lowest and the highest height that the vertices come with, likewise.
    pub height: [f64; 2],
}

/// What sorting cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Bytes written to temporary files.
    pub written: u64,
    /// Bytes read from temporary files, up to now.
    pub read: u64,
    /// The runs of points.
    pub runs: usize,
    /// The runs of edges.
    pub edge_runs: usize,
    /// The time in which points were read and runs written.
    pub reading: Duration,
    /// The time in which edges were read and joined to their ends.
    pub joining: Duration,
    /// The time of merging up to now, which passes while others work.
    pub merging: Duration,
}
