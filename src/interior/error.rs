//! Why a rule gives no interior.

use core::fmt;

use crate::error::Error;

/// Why a rule gives no interior. Every error names the offenders by the caller's own indices.
///
/// ```
/// use sweep_cdt::interior::{InteriorError, FillRule};
///
/// let result = sweep_cdt::triangulate(&[[0, 0], [4, 0], [0, 4], [1, 1]], &[[0, 3]])?;
/// let error = result.interior(FillRule::EvenOdd).unwrap_err();
/// assert_eq!(error, InteriorError::OpenAtVertex { vertex: 0 });
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum InteriorError {
    /// The edges do not form closed chains, so they do not separate inside from outside.
    OpenAtVertex {
        /// The lowest such point.
        vertex: usize,
    },
    /// The list of rings names no ring for an edge, a ring that there is not, or one for an edge that there is not.
    UnknownRing {
        /// The first such edge.
        edge: usize,
    },
    /// A coordinate of a seed is NaN or infinite.
    SeedNotFinite {
        /// The first such seed.
        seed: Seed,
    },
    /// The points and edges cannot be triangulated.
    Refused {
        /// Why not.
        error: Error,
    },
    /// A seed lies outside of the convex hull.
    SeedOutside {
        /// The first such seed.
        seed: Seed,
    },
    /// A seed lies on a vertex, so it does not tell one face from another.
    SeedOnVertex {
        /// The first such seed.
        seed: Seed,
        /// The vertex.
        vertex: usize,
    },
    /// A seed lies on an edge, so it does not tell one face from the other.
    SeedOnEdge {
        /// The first such seed.
        seed: Seed,
        /// The ends of the side that the seed lies on, the lower one first.
        ends: [usize; 2],
    },
    /// The seed of a region lies in a hole, or where no edges keep the outside out.
    RegionOutside {
        /// The first such region.
        region: usize,
    },
}

impl fmt::Display for InteriorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            InteriorError::OpenAtVertex { vertex } => write!(
                f,
                "the edges are no closed rings: they do not go on at vertex {vertex}"
            ),
            InteriorError::UnknownRing { edge } => {
                write!(f, "edge {edge} and its ring do not belong together")
            }
            InteriorError::Refused { .. } => {
                f.write_str("the points and edges cannot be triangulated")
            }
            InteriorError::SeedNotFinite { seed } => {
                write!(f, "the seed of {seed} has a coordinate that is not finite")
            }
            InteriorError::SeedOutside { seed } => {
                write!(f, "the seed of {seed} lies outside of the hull")
            }
            InteriorError::SeedOnVertex { seed, vertex } => {
                write!(f, "the seed of {seed} lies on vertex {vertex}")
            }
            InteriorError::SeedOnEdge { seed, ends } => write!(
                f,
                "the seed of {seed} lies on the edge between vertices {} and {}",
                ends[0], ends[1]
            ),
            InteriorError::RegionOutside { region } => write!(
                f,
                "the seed of region {region} lies in a hole, or outside of the outline"
            ),
        }
    }
}

impl core::error::Error for InteriorError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            InteriorError::Refused { error } => Some(error),
            _ => None,
        }
    }
}

impl From<Error> for InteriorError {
    fn from(error: Error) -> InteriorError {
        InteriorError::Refused { error }
    }
}

impl InteriorError {
    /// The error with other numbers for vertices, edges, holes and regions, for callers that do not count from 0.
    ///
    /// ```
    /// use sweep_cdt::interior::{InteriorError, Seed};
    ///
    /// let error = InteriorError::SeedOutside { seed: Seed::Hole(0) };
    /// let from_1 = error.renumbered(|v| v + 1, |e| e + 1, |h| h + 1, |r| r + 1);
    /// assert_eq!(from_1.to_string(), "the seed of hole 1 lies outside of the hull");
    /// ```
    #[must_use]
    pub fn renumbered(
        self,
        mut on_vertex: impl FnMut(usize) -> usize,
        mut on_edge: impl FnMut(usize) -> usize,
        on_hole: impl Fn(usize) -> usize,
        on_region: impl Fn(usize) -> usize,
    ) -> InteriorError {
        use InteriorError as E;
        let named = |seed: Seed| match seed {
            Seed::Hole(hole) => Seed::Hole(on_hole(hole)),
            Seed::Region(region) => Seed::Region(on_region(region)),
        };
        match self {
            E::OpenAtVertex { vertex } => E::OpenAtVertex {
                vertex: on_vertex(vertex),
            },
            E::UnknownRing { edge } => E::UnknownRing {
                edge: on_edge(edge),
            },
            E::Refused { error } => E::Refused {
                error: error.renumbered(on_vertex, on_edge),
            },
            E::SeedNotFinite { seed } => E::SeedNotFinite { seed: named(seed) },
            E::SeedOutside { seed } => E::SeedOutside { seed: named(seed) },
            E::SeedOnVertex { seed, vertex } => E::SeedOnVertex {
                seed: named(seed),
                vertex: on_vertex(vertex),
            },
            E::SeedOnEdge { seed, ends } => E::SeedOnEdge {
                seed: named(seed),
                ends: ends.map(on_vertex),
            },
            E::RegionOutside { region } => E::RegionOutside {
                region: on_region(region),
            },
        }
    }
}

/// A point that stands for the whole face that it lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
