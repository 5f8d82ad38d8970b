//! Why a rule says nothing of an input. Every error names the offenders by the caller's own indices.

use std::fmt;

/// Why no domain follows from a rule.
///
/// ```
/// use sweep_cdt::domain::{DomainError, Rule};
///
/// let result = sweep_cdt::triangulate(&[[0, 0], [4, 0], [0, 4], [1, 1]], &[[0, 3]])?;
/// let error = result.domain(Rule::EvenOdd).unwrap_err();
/// assert_eq!(error, DomainError::OpenAtVertex { vertex: 0 });
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// The edges do not form closed chains, so that they do not separate inside from outside.
    #[error("the edges are no closed rings: they do not go on at vertex {vertex}")]
    OpenAtVertex {
        /// The lowest such point.
        vertex: usize,
    },
    /// These are not the edges that were triangulated.
    #[error("edge {edge} is not the one that was triangulated")]
    OtherEdge {
        /// The first edge that differs, or the first one of which there are too many or too few.
        edge: usize,
    },
    /// The triangulation has a vertex that is none of these points.
    #[error("vertex {vertex} of the triangulation does not exist")]
    MissingPoint {
        /// The first such vertex.
        vertex: usize,
    },
    /// A coordinate of this seed is NaN or infinite.
    #[error("the seed of {seed} has a coordinate that is not finite")]
    SeedNotFinite {
        /// The first such seed.
        seed: Seed,
    },
    /// This seed lies outside of the convex hull.
    #[error("the seed of {seed} lies outside of the hull")]
    SeedOutside {
        /// The first such seed.
        seed: Seed,
    },
    /// This seed lies on a vertex, so that it does not tell one face from another.
    #[error("the seed of {seed} lies on vertex {vertex}")]
    SeedOnVertex {
        /// The first such seed.
        seed: Seed,
        /// The vertex.
        vertex: usize,
    },
    /// This seed lies on an edge, so that it does not tell one face from the other.
    #[error("the seed of {seed} lies on the edge between vertices {} and {}", ends[0], ends[1])]
    SeedOnEdge {
        /// The first such seed.
        seed: Seed,
        /// The ends of the side that it lies on, the lower one first.
        ends: [usize; 2],
    },
    /// The seed of this region lies in a hole, or where no edges keep the outside out.
    #[error("the seed of region {region} lies in a hole, or outside of the outline")]
    RegionOutside {
        /// The first such region.
        region: usize,
    },
}

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
