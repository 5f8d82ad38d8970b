//! What messages call a seed.

use std::fmt;

/// A point that stands for the whole face that it lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Seed {
    /// The hole of this index.
    Hole(usize),
    /// The region of this index.
    Region(usize),
}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Seed::Hole(hole) => write!(f, "hole {hole}"),
            Seed::Region(region) => write!(f, "region {region}"),
        }
    }
}
