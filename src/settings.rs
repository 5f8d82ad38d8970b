//! Settings of a run, which change the work and never the result: the algorithm, and the triangles that a point event
//! adds beyond the necessary ones (section 3.4.1, figures 9 and 10).

use crate::tuning::Tuning;

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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Algorithm {
    /// The sweep. Where it flips many sides, it goes on with the paper's heuristics. Flips and long walks along the front
    /// spend a budget, which is linear in the work. Where it is spent, the sweep is abandoned, and divide and conquer
    /// begins anew.
    #[default]
    Auto,
    /// The sweep of Domiter and Žalik (2008), to its end and with the heuristics given. Fast on ordinary inputs; O(n^2)
    /// on some, such as the outline of a square with nothing inside.
    Sweep,
    /// [`Sweep`](Algorithm::Sweep), and edges are inserted as in the paper: each in its event, however many triangles it
    /// pierces, and pseudo-polygons from one end to the other. The steps of such a run are a trace that can be replayed.
    /// O(n^2) on a hatch, too.
    Paper,
    /// Divide and conquer for the points (Lee and Schachter 1980; Guibas and Stolfi 1985), then the edges one by one
    /// (Anglada 1997): O(n log n) for the points, whatever they are.
    DivideAndConquer,
    /// Randomized incremental insertion with jump and walk for the points (Mücke, Saias and Zhu 1996), then the edges
    /// one by one (Anglada 1997): the paper's M-INC, for comparison. Expected O(n^(4/3)) if points are evenly spread,
    /// O(n^2) on some inputs.
    #[cfg(feature = "comparison")]
    Incremental,
    /// Fortune's sweep line (1987) for the points, then the edges one by one: the paper's F-S, for comparison. The
    /// beach line is kept in floating point; exact signs judge what comes of it. O(n^2) on some inputs.
    #[cfg(feature = "comparison")]
    Fortune,
    /// The sweep of Žalik (2005) for the points, without artificial points and with the heuristics given, then the
    /// edges one by one, for comparison. O(n^2) on some inputs.
    #[cfg(feature = "comparison")]
    Sweep2005,
}

/// The two heuristics of the point event, which change the work, never the result.
///
/// Without heuristics the front undulates, and many badly shaped triangles are made and flipped later. Both test angles
/// in floating point; whether a triangle may be made at all is decided exactly. [`Algorithm::Auto`] begins with them.
/// Where they flip over four sides a vertex for a while, [`Heuristics::PAPER`] replaces them for that time.
///
/// ```
/// use sweep_cdt::{Heuristics, Triangulator};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [1.0, 2.0], [2.0, 1.0]];
/// let fast = Triangulator::new().triangulate(&points, &[])?;
/// let paper = Triangulator::new().heuristics(Heuristics::PAPER).triangulate(&points, &[])?;
/// assert_eq!(fast.canonical_triangles(), paper.canonical_triangles());
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Heuristics {
    /// The corners of the front beside the new vertex that are narrow enough to be closed by a further triangle, by the
    /// angle between a new triangle's side and the next front segment (figure 9).
    pub corners: Corners,
    /// Whether basins are filled: parts of the front that fall away from the new point more steeply than 45 degrees, an
    /// angle of more than 3pi/4 with the upward vertical (figure 10).
    pub basins: bool,
}

/// Up to which angle the point event closes corners left and right of the new vertex (figure 9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Corners {
    /// None are closed.
    Off,
    /// Below pi/2, the paper's angle.
    RightAngle,
    /// Below pi/2, and on either side one corner of up to 110 degrees: the fastest measured.
    Wide,
    /// Below pi/2, and on either side one obtuse corner whose squared cosine is below so many sixteenths: 1 for 104
    /// degrees, 4 for 120, 8 for 3pi/4. For comparison.
    #[cfg(feature = "comparison")]
    OneUpTo(u8),
    /// Below pi/2, and all obtuse corners whose squared cosine is below so many sixteenths.
    #[cfg(feature = "comparison")]
    AllUpTo(u8),
}

impl Heuristics {
    /// The fastest setting measured, wider angles and no basins; the default.
    pub const FAST: Heuristics = Heuristics {
        corners: Corners::Wide,
        basins: false,
    };
    /// The paper's setting: pi/2 and 3pi/4.
    pub const PAPER: Heuristics = Heuristics {
        corners: Corners::RightAngle,
        basins: true,
    };
    /// Neither heuristic: only the triangles that the point event needs.
    pub const OFF: Heuristics = Heuristics {
        corners: Corners::Off,
        basins: false,
    };
}

impl Default for Heuristics {
    fn default() -> Self {
        Heuristics::FAST
    }
}

/// A function that is called as `progress(swept, vertices)` at intervals.
pub(crate) type Progress<'a> = Option<&'a mut dyn FnMut(usize, usize)>;

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Settings {
    pub(crate) algorithm: Algorithm,
    pub(crate) heuristics: Heuristics,
    pub(crate) ties: Ties,
    pub(crate) tuning: &'static Tuning,
}

/// At which of several vertices on one circle the diagonals between them end. Alone of the settings it changes the result;
/// only a stream sets it, for windows whose coordinates it exchanges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ties {
    /// At the leftmost one, the upper one of two: the canonical rule.
    #[default]
    Leftmost,
    /// At the lowest one, the right one of two: the canonical rule for points whose coordinates were exchanged.
    Lowest,
}
