//! What a triangulation may promise: levels, each of which includes those before it.

use super::violation::Violation;

/// How good a triangulation is. Programs that cut polygons into triangles promise less than a constrained Delaunay
/// triangulation.
///
/// ```
/// use sweep_cdt::verify::{Level, Verifier};
///
/// // The diagonal is the wrong one, which does not matter to a triangulation of a polygon.
/// let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]];
/// let triangles = [[0, 1, 2], [0, 2, 3]];
/// let verifier = Verifier::new().level(Level::Constrained);
/// let report = verifier.verify(&points, &[[0, 1]], &triangles)?;
/// assert_eq!(report.level, Some(Level::Constrained));
/// # Ok::<(), sweep_cdt::verify::Violations>(())
/// ```
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    strum::EnumString,
    strum::IntoStaticStr,
    strum::VariantArray,
)]
#[strum(serialize_all = "lowercase")]
#[non_exhaustive]
pub enum Level {
    /// The triangles tile the hull, or the declared domain, and every point there is a corner.
    Tiling,
    /// And every edge is a side, or a chain of sides.
    Constrained,
    /// And every other side is locally Delaunay.
    Delaunay,
    /// And of four vertices on one circle the diagonal ends at the leftmost one (of two, the upper one).
    Canonical,
}

impl Level {
    /// What a triangulation of this level is called.
    pub fn title(self) -> &'static str {
        match self {
            Level::Tiling => "a triangulation",
            Level::Constrained => "a constrained triangulation",
            Level::Delaunay => "a constrained Delaunay triangulation",
            Level::Canonical => "the canonical constrained Delaunay triangulation",
        }
    }

    /// The level before it, if there is one.
    pub(super) fn below(self) -> Option<Level> {
        match self {
            Level::Tiling => None,
            Level::Constrained => Some(Level::Tiling),
            Level::Delaunay => Some(Level::Constrained),
            Level::Canonical => Some(Level::Delaunay),
        }
    }
}

impl Violation {
    /// The lowest level that is not reached because of it.
    pub fn level(&self) -> Level {
        match self {
            Violation::EdgeOutOfRange { .. } | Violation::MissingEdge { .. } => Level::Constrained,
            Violation::NotDelaunay { .. } => Level::Delaunay,
            Violation::NotCanonical { .. } => Level::Canonical,
            _ => Level::Tiling,
        }
    }
}
