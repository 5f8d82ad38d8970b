//! How the statistics of a run are recorded: clocks, counters, the length of the front, and a tag for each triangle
//! that says what made it, until it is flipped or removed. So the last tags say what of the work of each kind survives.
//! Cost: eight bytes for each triangle, and a write to it for each triangle made and two for each flip.

use alloc::vec::Vec;
#[cfg(feature = "std")]
use std::time::Instant;

use crate::ids::TriangleId;
use crate::mesh::HalfEdge;
use crate::observe::stats::{ByCause, Counters, Stats};
use crate::trace::Why;
use crate::triangulation::Triangulation;

/// The parts of the algorithm (section 3.2), which the statistics time.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Phase {
    Initialization,
    Sweeping,
    Finalization,
    Finished,
}

/// The cause of a triangle: the field of [`ByCause`] that counts it.
type Cause = fn(&mut ByCause) -> &mut u64;

const DIVIDE_AND_CONQUER: Cause = |numbers| &mut numbers.divide_and_conquer;

#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    pub(crate) stats: Stats,
    /// The current phase, and when it began.
    #[cfg(feature = "std")]
    current: Option<(Phase, Instant)>,
    /// The last cause of each place in the mesh.
    causes: Vec<Cause>,
    /// Vertices on the front.
    front: u64,
    /// The tests and flips when the last triangle was made.
    tests_before: u64,
    flips_before: u64,
}

impl Recorder {
    /// Ends the current phase and begins the next one. Without a clock nothing is timed.
    pub(crate) fn clock(&mut self, next: Phase) {
        #[cfg(feature = "std")]
        self.tick(next);
        #[cfg(not(feature = "std"))]
        let _ = next;
    }

    #[cfg(feature = "std")]
    fn tick(&mut self, next: Phase) {
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

    pub(crate) fn made(&mut self, t: TriangleId, why: Why) {
        let counters = &self.stats.counters;
        let cause: Cause = match why {
            Why::First => |numbers| &mut numbers.first,
            // A left case is counted before its second triangle is made.
            Why::Point if counters.made.left < counters.left_cases => |numbers| &mut numbers.left,
            Why::Point => |numbers| &mut numbers.middle,
            Why::NarrowCorner => |numbers| &mut numbers.narrow_corners,
            Why::Basin => |numbers| &mut numbers.basins,
            Why::Pocket => |numbers| &mut numbers.pockets,
            Why::PseudoPolygon => |numbers| &mut numbers.pseudo_polygons,
            Why::Hull => |numbers| &mut numbers.hull,
        };
        self.tag(t, cause);
    }

    /// Counts a triangle made by divide and conquer.
    pub(crate) fn merged(&mut self, t: TriangleId) {
        self.tag(t, DIVIDE_AND_CONQUER);
    }

    fn tag(&mut self, t: TriangleId, cause: Cause) {
        self.end_legalization();
        *cause(&mut self.stats.counters.made) += 1;
        self.set(t, cause);
    }

    fn set(&mut self, t: TriangleId, cause: Cause) {
        if self.causes.len() <= t.index() {
            self.causes.resize(t.index() + 1, cause);
        }
        self.causes[t.index()] = cause;
    }

    /// Counts a flip, which replaces two triangles by two.
    pub(crate) fn flipped(&mut self, sides: [HalfEdge; 2]) {
        self.stats.counters.made.flips += 2;
        for t in sides.map(HalfEdge::triangle) {
            self.set(t, |numbers| &mut numbers.flips);
        }
    }

    /// Compares the tests and flips since the last triangle was made with the most so far.
    fn end_legalization(&mut self) {
        let Counters {
            legalization_tests: tests,
            flips,
            ref mut most_tests,
            ref mut most_flips,
            ..
        } = self.stats.counters;
        *most_tests = (*most_tests).max(tests - self.tests_before);
        *most_flips = (*most_flips).max(flips - self.flips_before);
        (self.tests_before, self.flips_before) = (tests, flips);
    }

    pub(crate) fn front_grows(&mut self) {
        let counters = &mut self.stats.counters;
        counters.front_lengths += self.front;
        self.front += 1;
        counters.longest_front = counters.longest_front.max(self.front);
    }

    pub(crate) fn front_shrinks(&mut self) {
        self.front = self.front.saturating_sub(1);
    }

    /// Counts the triangles that survive: the first `triangles` without the `artificial` ones, an ascending list.
    pub(crate) fn survived(&mut self, triangles: usize, artificial: &[TriangleId]) {
        self.end_legalization();
        // The artificial triangles around the hull are the last to come: never were there more triangles.
        debug_assert!(
            self.causes.len() <= triangles,
            "a place of a triangle is gone"
        );
        let mut artificial = artificial.iter().map(|t| t.index()).peekable();
        for (t, cause) in self.causes.iter().enumerate() {
            if artificial.next_if_eq(&t).is_none() {
                *cause(&mut self.stats.counters.survived) += 1;
            }
        }
    }

    /// Adds what a band counted. Its triangles come after the first `triangles`, and it has the times of all bands.
    #[cfg(feature = "parallel")]
    pub(crate) fn add_band(&mut self, mut band: Recorder, triangles: usize) {
        band.end_legalization();
        self.stats.counters += band.stats.counters;
        self.stats.is_divided |= band.stats.is_divided;
        self.stats.memory += band.stats.memory;
        self.causes.resize(triangles, DIVIDE_AND_CONQUER);
        self.causes.append(&mut band.causes);
        let counters = &self.stats.counters;
        (self.tests_before, self.flips_before) = (counters.legalization_tests, counters.flips);
    }

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
