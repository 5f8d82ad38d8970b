//! Numbers about one run: what there was, what was done, how long it took.
//!
//! Nothing else reads the clock, so the library runs on platforms without one.

use std::time::{Duration, Instant};

use crate::scalar::Stage;
use crate::triangulation::Triangulation;

/// What one run of the sweep met and did.
///
/// All but the times are the same for every run on the same input with the same settings. Where the
/// platform has no clock (`wasm32-unknown-unknown`) the times are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stats {
    /// Input points.
    pub points: usize,
    /// Input points equal to one of a lower index.
    pub duplicates: usize,
    /// Input edges.
    pub edges: usize,
    /// Triangles of the result.
    pub triangles: usize,
    /// Vertices on the border of the hull.
    pub hull: usize,
    /// Time of the initialization (section 3.3; table 2).
    pub initialization: Duration,
    /// Time of the sweeping (section 3.4; table 2).
    pub sweeping: Duration,
    /// Time of the finalization (section 3.5; table 2).
    pub finalization: Duration,
    /// Whether divide and conquer made the result, because it was asked for or because the sweep was
    /// abandoned. Then times and counters hold the work of both.
    pub is_divided: bool,
    /// Bytes of the largest arrays held at one time, beyond the input.
    pub memory: usize,
    /// The work done.
    pub counters: Counters,
}

/// How often the sweep did each kind of work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Counters {
    /// Orientation tests decided by the floating-point filter.
    pub orient2d_filtered: u64,
    /// Orientation tests decided in machine integers.
    pub orient2d_integers: u64,
    /// Orientation tests decided by adaptive expansions.
    pub orient2d_expansions: u64,
    /// Orientation tests decided in big integers.
    pub orient2d_big: u64,
    /// Orientation tests decided in the scalar's own arithmetic.
    pub orient2d_own: u64,
    /// In-circle tests decided by the floating-point filter.
    pub in_circle_filtered: u64,
    /// In-circle tests decided in machine integers.
    pub in_circle_integers: u64,
    /// In-circle tests decided by adaptive expansions.
    pub in_circle_expansions: u64,
    /// In-circle tests decided in big integers.
    pub in_circle_big: u64,
    /// In-circle tests decided in the scalar's own arithmetic.
    pub in_circle_own: u64,
    /// Tests with an artificial vertex, decided by rule.
    pub symbolic: u64,
    /// In-circle tests that found four points on one circle.
    pub cocircular: u64,
    /// Sides swapped by the legalization.
    pub flips: u64,
    /// Steps along the front after the search structure's answer (3.4.1). Without a front, steps of the
    /// walk from triangle to triangle or along the beach line.
    pub front_steps: u64,
    /// Point events of the left case (figure 8).
    pub left_cases: u64,
    /// Triangles that close narrow corners of the front: the pi/2 heuristic (figure 9).
    pub narrow_corners: u64,
    /// Triangles added below the front by the basin heuristic (figure 10).
    pub basin_triangles: u64,
    /// Edges (or pieces) that were there already (section 3.4.2).
    pub edges_present: u64,
    /// Edges (or pieces) inserted by removing triangles.
    pub edges_inserted: u64,
    /// Triangles removed because an edge pierced them.
    pub pierced: u64,
    /// Triangles added in pockets of the front under an edge (figures 13 and 14).
    pub pocket_triangles: u64,
    /// Triangles added by the finalization (figure 15).
    pub hull_triangles: u64,
}

/// The parts of the algorithm (section 3.2), which the statistics time.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Phase {
    Initialization,
    Sweeping,
    Finalization,
    Finished,
}

/// Statistics as they are recorded.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    pub(crate) stats: Stats,
    /// The current phase, and when it began.
    current: Option<(Phase, Instant)>,
}

impl Recorder {
    /// Ends the current phase and begins the next one.
    pub(crate) fn clock(&mut self, next: Phase) {
        let has_clock = !cfg!(all(target_family = "wasm", target_os = "unknown"));
        let now = has_clock.then(Instant::now);
        if let (Some((phase, start)), Some(now)) = (self.current, now) {
            let time = now - start;
            match phase {
                Phase::Initialization => self.stats.initialization += time,
                Phase::Sweeping => self.stats.sweeping += time,
                Phase::Finalization => self.stats.finalization += time,
                Phase::Finished => {}
            }
        }
        self.current = now.map(|now| (next, now));
    }

    /// All statistics of a run, with the sizes of its input and result.
    pub(crate) fn finish(self, points: usize, edges: usize, result: &Triangulation) -> Stats {
        Stats {
            points,
            duplicates: result.duplicates().len(),
            edges,
            triangles: result.len(),
            hull: result.hull().len(),
            ..self.stats
        }
    }
}

impl Counters {
    /// Orientation tests that the filter left open.
    #[must_use]
    pub fn orient2d_exact(&self) -> u64 {
        self.orient2d_integers + self.orient2d_expansions + self.orient2d_big + self.orient2d_own
    }

    /// In-circle tests that the filter left open.
    #[must_use]
    pub fn in_circle_exact(&self) -> u64 {
        self.in_circle_integers
            + self.in_circle_expansions
            + self.in_circle_big
            + self.in_circle_own
    }

    /// Counts an orientation test that this stage decided.
    pub(crate) fn count_orient2d(&mut self, stage: Stage) {
        *match stage {
            Stage::Integers => &mut self.orient2d_integers,
            Stage::Expansions => &mut self.orient2d_expansions,
            Stage::BigIntegers => &mut self.orient2d_big,
            Stage::Own => &mut self.orient2d_own,
        } += 1;
    }

    /// Counts an in-circle test that this stage decided.
    pub(crate) fn count_in_circle(&mut self, stage: Stage) {
        *match stage {
            Stage::Integers => &mut self.in_circle_integers,
            Stage::Expansions => &mut self.in_circle_expansions,
            Stage::BigIntegers => &mut self.in_circle_big,
            Stage::Own => &mut self.in_circle_own,
        } += 1;
    }
}
