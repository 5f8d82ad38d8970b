//! How large an input may be, so that every exact check of it ends soon.

/// An input has at most this many points.
pub const POINTS: usize = 64;
/// The same where exact arithmetic takes thousands of bits.
pub const FAR_POINTS: usize = 10;
/// An input has at most this many edges.
pub const EDGES: usize = 96;
