//! The rules that need no more than the edges.

/// What of the convex hull is inside.
///
/// ```
/// use sweep_cdt::domain::Rule;
///
/// // A square in a square, both counter-clockwise.
/// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// assert_eq!(result.domain(Rule::Hull)?.inside().len(), 10);
/// assert_eq!(result.domain(Rule::EvenOdd)?.inside().len(), 8);
/// assert_eq!(result.domain(Rule::NonZero(&edges))?.inside().len(), 10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Rule<'a> {
    /// All of it.
    Hull,
    /// Whatever a path from far away enters by crossing an odd number of edges. The direction of the edges
    /// does not matter. An edge that is given twice is crossed twice, and so is a place where two edges
    /// overlap. The edges must form closed chains: at each point an even number of them ends.
    EvenOdd,
    /// Whatever the edges go round, more often in one direction than in the other. Each edge runs from its
    /// first to its second point, and these must be the edges that were triangulated. As many must end at
    /// each point as start there.
    NonZero(&'a [[usize; 2]]),
}
