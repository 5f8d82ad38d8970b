//! Which algorithm triangulates.

/// The algorithm. All give the same result; they differ in time.
///
/// ```
/// use sweep_cdt::{Algorithm, Triangulator};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [2.0, 1.0]];
/// let sweep = Triangulator::new().algorithm(Algorithm::Sweep);
/// let other = Triangulator::new().algorithm(Algorithm::DivideAndConquer);
/// assert_eq!(
///     sweep.triangulate(&points, &[[0, 2]])?.canonical_triangles(),
///     other.triangulate(&points, &[[0, 2]])?.canonical_triangles(),
/// );
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Algorithm {
    /// The sweep. Where it swaps many sides, it goes on with the paper's heuristics. Where it swaps more
    /// than a budget allows that is linear in its work, it is abandoned, and divide and conquer goes on; with
    /// edges it begins anew.
    #[default]
    Auto,
    /// The sweep of Domiter and Žalik (2008), to its end and with the heuristics given. Fast on ordinary
    /// inputs; O(n^2) on some, such as the outline of a square with nothing inside.
    Sweep,
    /// Divide and conquer for the points (Lee and Schachter 1980; Guibas and Stolfi 1985), then the edges
    /// one by one (Anglada 1997): O(n log n) for the points, whatever they are.
    DivideAndConquer,
}
