//! The interior: the part of the hull that is inside.
//!
//! The triangles of a [`Triangulation`] cover the convex hull of the points. A polygon with holes, or a map of regions,
//! is a part of it: an [`Interior`]. Edges are chains of sides, so each triangle lies wholly inside or wholly outside,
//! and a rule counts which sides a path from outside crosses. Only seeds have coordinates; exact signs locate them.
//!
//! | | inside is |
//! |---|---|
//! | [`FillRule::Hull`] | everything |
//! | [`FillRule::EvenOdd`] | what a path from outside enters by an odd number of edges |
//! | [`FillRule::NonZero`] | what the edges go round |
//! | [`FillRule::Positive`], [`Negative`](FillRule::Negative) | what they go round counter-clockwise, or clockwise |
//! | [`FillRule::AtLeast`] | what they go round so many times |
//! | [`interior_of_polygons`](Triangulation::interior_of_polygons) | what polygons cover, but for their holes |
//! | [`WithPoints::interior_of_seeds`](crate::WithPoints::interior_of_seeds) | the faces that edges close off, but those with the seed of a hole |
//! | [`WithPoints::hull_without_holes`](crate::WithPoints::hull_without_holes) | the hull, but the faces with the seed of a hole |
//!
//! Why it is right: for the rules the edges on each side are counted, all paths to a triangle agree, and one of them is
//! followed. For seeds the triangles that no edge parts are joined, and each seed is in one such face. Cost:
//! O(n + m log m) for n triangles and chains of m sides together, and 13 bytes a triangle.

// The rules are in `flow`, rings of polygons in `polygons`, the seeds in `holes`, the boundary of what is inside in
// `labels`.
mod error;
mod flow;
mod holes;
mod labels;
mod polygons;

pub use error::{InteriorError, Seed};
pub use labels::Interior;
pub use polygons::Ring;

use crate::Triangulation;
use flow::Flow;

/// A rule for the part of the convex hull that is inside.
///
/// ```
/// use sweep_cdt::interior::FillRule;
///
/// // A square in a square, both counter-clockwise.
/// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// assert_eq!(result.interior(FillRule::Hull)?.inside().len(), 10);
/// assert_eq!(result.interior(FillRule::EvenOdd)?.inside().len(), 8);
/// assert_eq!(result.interior(FillRule::NonZero)?.inside().len(), 10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum FillRule {
    /// All of the hull.
    Hull,
    /// All that a path from far away enters by crossing an odd number of edges, in any direction. An edge given twice
    /// is crossed twice, and so is a place where edges overlap. An even number of edges must end at each point.
    EvenOdd,
    /// All that the edges go round more often in one direction than in the other. Each edge runs from its first to its
    /// second point. As many must end at each point as start there.
    NonZero,
    /// All that the edges go round more often counter-clockwise than clockwise: what an outline that is moved outwards
    /// and crosses itself leaves of its area.
    Positive,
    /// All that the edges go round more often clockwise than counter-clockwise.
    Negative,
    /// All that the edges go round at least so many times, in one direction: the overlap of rings that run one way. At
    /// least 0 times is the hull.
    AtLeast(u32),
}

impl Triangulation {
    /// The interior by a [`FillRule`].
    ///
    /// # Errors
    /// [`InteriorError::OpenAtVertex`], if the edges form no closed chains.
    ///
    /// ```
    /// use sweep_cdt::interior::FillRule;
    ///
    /// // An arrowhead: its notch is in the hull, but not inside.
    /// let points = [[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
    /// let result = sweep_cdt::triangulate(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let domain = result.interior(FillRule::EvenOdd)?;
    /// assert_eq!((result.len(), domain.inside().len()), (3, 2));
    ///
    /// // Two squares that run one way, and overlap in a third one.
    /// let points = [[0, 0], [2, 0], [2, 1], [3, 1], [3, 3], [1, 3], [1, 2], [0, 2], [2, 2], [1, 1]];
    /// let edges = [[0, 1], [1, 2], [2, 8], [8, 6], [6, 7], [7, 0], [9, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 9]];
    /// let result = sweep_cdt::triangulate(&points, &edges)?;
    /// assert_eq!(result.interior(FillRule::AtLeast(2))?.inside().len(), 2);
    /// assert_eq!(result.interior(FillRule::Negative)?.inside().len(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn interior(&self, rule: FillRule) -> Result<Interior<'_>, InteriorError> {
        if rule == FillRule::Hull {
            return Ok(Interior::whole(self));
        }
        let flow = Flow::new(self);
        let flow_in = |t, side| match self.is_constrained(t, side) {
            true => flow.of_side(self.side(t, side)),
            false => 0,
        };
        let is_odd = |number: i32| number % 2 != 0;
        if rule == FillRule::EvenOdd {
            flow.expect_closed(is_odd)?;
            let depths = flow::layers(self, |t, side| is_odd(flow_in(t, side)));
            return Ok(Interior::new(self, depths, is_odd));
        }
        flow.expect_closed(|flow| flow != 0)?;
        let depths = flow::sums(self, flow_in);
        Ok(Interior::new(self, depths, |winding| match rule {
            FillRule::Positive => winding > 0,
            FillRule::Negative => winding < 0,
            FillRule::AtLeast(times) => winding.unsigned_abs() >= times,
            _ => winding != 0,
        }))
    }
}
