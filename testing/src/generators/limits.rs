//! How large an input may be, so that every exact check of it ends soon.

/// An input has at most so many points.
pub const POINTS: usize = 64;
/// And where their exact arithmetic takes thousands of bits, so many.
pub const FAR_POINTS: usize = 10;
/// An input has at most so many edges.
pub const EDGES: usize = 96;
