//! The verifier's answer: counts, the level reached, and the violations if there are any; and how the checks record it.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use super::depth::{Depth, Depths};
use super::soup::Tally;
use super::violation::Violation;

/// Counts and decisions. An `Ok(Report)` proves the triangulation correct, to the level that was asked for. A *side* is
/// a side of a triangle, counted once however many triangles have it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Report {
    /// Input points.
    pub points: usize,
    /// Points that differ from all of a lower index.
    pub distinct_points: usize,
    /// Input edges.
    pub edges: usize,
    /// Triangles.
    pub triangles: usize,
    /// Whether the triangles were given clockwise, and accepted so.
    pub clockwise: bool,
    /// Sides with a triangle on one side only.
    pub boundary_sides: usize,
    /// Sides that are input edges or pieces of them.
    pub constrained_sides: usize,
    /// Corners that are not points of the input, where [these are allowed](super::Verifier::added_from).
    pub added_points: usize,
    /// Edges with an added point on them, between their ends.
    pub split_edges: usize,
    /// Sides between two triangles that are not pieces of input edges, so must be Delaunay.
    pub free_sides: usize,
    /// Free sides whose two triangles have all corners on one circle: ties, where either diagonal is Delaunay.
    pub cocircular_sides: usize,
    /// Cocircular sides for which this crate chooses the other diagonal (see [`is_canonical`](Report::is_canonical)).
    pub uncanonical_sides: usize,
    /// Signs that doubles decided. Signs of searches (along edges through vertices, in a declared domain) do not count.
    pub filtered: u64,
    /// Signs that the filter left to exact arithmetic.
    pub exact: u64,
    /// The highest level that the triangulation reaches, whatever was asked for; `None` where one of the
    /// checks 1 to 6 fails, even if one point alone is no corner.
    pub level: Option<Level>,
}

impl Report {
    /// Whether a correct result is the canonical one, as from [`triangulate`](crate::triangulate): of four vertices on
    /// one circle the diagonal ends at the leftmost one (of two, the upper one). There is only one such result.
    pub fn is_canonical(&self) -> bool {
        self.uncanonical_sides == 0
    }
}

/// The violations found in a triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Violations {
    /// The level that was asked for.
    pub asked: Level,
    /// The first violations, in the order of the checks, up to the limit.
    pub list: Vec<Violation>,
    /// How many violations there are, beyond the limit too.
    pub found: usize,
    /// The depths of the violations that have one.
    pub depths: Depths,
    /// The counts, as far as the checks came.
    pub report: Box<Report>,
}

impl Violations {
    /// The greatest depth, if each violation has one: all of them are sides that are not Delaunay, turns of a boundary
    /// that is simple, or edges and boundaries with added points beside them. So what is wrong may be rounding, if the
    /// depth is small.
    ///
    /// Then the triangles still meet side to side and cover what they cover once, every point is a corner, and every
    /// edge is a chain of sides, on it or beside it. They do not fill the hull where a turn is concave. By default not all of very many
    /// depths are measured, and there is no answer; see [`Verifier::all_depths`](super::Verifier::all_depths).
    ///
    /// ```
    /// use sweep_cdt::verify::verify;
    ///
    /// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0 - 1e-15], [0.0, 1.0]];
    /// let violations = verify(&points, &[], &[[0, 1, 3], [1, 2, 3]]).unwrap_err();
    /// assert!(violations.depth().is_some_and(|depth| depth.get() < 1e-12));
    ///
    /// let violations = verify(&points, &[], &[[0, 1, 3]]).unwrap_err();
    /// assert_eq!(violations.depth(), None);
    /// ```
    pub fn depth(&self) -> Option<Depth> {
        let greatest = self.depths.greatest;
        greatest.filter(|_| self.depths.measured() == self.found)
    }
}

impl fmt::Display for Violations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "not {}: ", self.asked.title())?;
        let Some(first) = self.list.first() else {
            return write!(f, "{} violation{}", self.found, plural(self.found));
        };
        match self.found - 1 {
            0 => write!(f, "{first}"),
            more => write!(f, "{first}, and {more} more violation{}", plural(more)),
        }
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

impl core::error::Error for Violations {}

/// How good a triangulation is; each level includes those before it. Programs that cut polygons into triangles promise
/// less than a constrained Delaunay triangulation.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
#[non_exhaustive]
pub enum Level {
    /// The triangles tile the hull, or the declared domain, and every point there is a corner.
    Tiling,
    /// And every edge is a chain of sides; where [regions](super::Verifier::regions) are given, triangles match them.
    Constrained,
    /// And every other side is locally Delaunay.
    Delaunay,
    /// And of four vertices on one circle the diagonal ends at the leftmost one (of two, the upper one).
    Canonical,
}

impl Level {
    /// All levels, each of which asks for more than the one before it.
    pub const ALL: [Level; 4] = [
        Level::Tiling,
        Level::Constrained,
        Level::Delaunay,
        Level::Canonical,
    ];

    /// The name of the level: the variant in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Level::Tiling => "tiling",
            Level::Constrained => "constrained",
            Level::Delaunay => "delaunay",
            Level::Canonical => "canonical",
        }
    }

    /// The name of a triangulation of this level.
    pub fn title(self) -> &'static str {
        match self {
            Level::Tiling => "a triangulation",
            Level::Constrained => "a constrained triangulation",
            Level::Delaunay => "a constrained Delaunay triangulation",
            Level::Canonical => "the canonical constrained Delaunay triangulation",
        }
    }

    /// The level before this one, if there is one.
    pub(super) fn below(self) -> Option<Level> {
        Level::ALL.into_iter().rfind(|&level| level < self)
    }
}

impl Violation {
    /// The lowest level that is not reached because of the violation.
    pub fn level(&self) -> Level {
        match self {
            Violation::EdgeOutOfRange { .. }
            | Violation::MissingEdge { .. }
            | Violation::BentEdge { .. }
            | Violation::WrongRegion { .. } => Level::Constrained,
            Violation::NotDelaunay { .. } => Level::Delaunay,
            Violation::NotCanonical { .. } => Level::Canonical,
            _ => Level::Tiling,
        }
    }
}

/// The answer in the making: counts, how signs were decided, and violations.
#[derive(Debug)]
pub(super) struct Record {
    pub(super) report: Report,
    pub(super) tally: Tally,
    pub(super) findings: Findings,
}

impl Record {
    /// A record of no checks, for at most `limit` violations of the level asked for or below, and `measured` depths.
    pub(super) fn new(limit: usize, measured: usize, asked: Level) -> Record {
        Record {
            report: Report::default(),
            tally: Tally::default(),
            findings: Findings::new(limit, measured, asked),
        }
    }

    pub(super) fn answer(mut self) -> Result<Report, Violations> {
        if !self.report.is_canonical() {
            let sides = self.report.uncanonical_sides;
            self.findings.add(Violation::NotCanonical { sides });
        }
        let report = Report {
            filtered: self.tally.filtered,
            exact: self.tally.exact,
            level: self.findings.reached(),
            ..self.report
        };
        if self.findings.is_empty() {
            return Ok(report);
        }
        Err(Violations {
            asked: self.findings.asked,
            list: self.findings.list,
            found: self.findings.found,
            depths: self.findings.depths,
            report: Box::new(report),
        })
    }
}

/// The first violations that matter, how many there are, and the level that all of them leave.
#[derive(Clone, Debug)]
pub(super) struct Findings {
    limit: usize,
    /// The level asked for. What breaks a higher level only is no violation.
    asked: Level,
    /// The lowest level that is not reached.
    broken: Option<Level>,
    /// Whether all that breaks a level up to [`Level::Constrained`] has a depth.
    is_sound: bool,
    pub(super) list: Vec<Violation>,
    pub(super) found: usize,
    /// How many of the violations found have a depth at most.
    pub(super) measured: usize,
    depths: Depths,
}

impl Findings {
    fn new(limit: usize, measured: usize, asked: Level) -> Findings {
        Findings {
            limit,
            measured,
            depths: Depths::default(),
            asked,
            broken: None,
            is_sound: true,
            list: Vec::new(),
            found: 0,
        }
    }

    /// No findings, with the same limits and the same level asked for.
    pub(super) fn emptied(&self) -> Findings {
        Findings::new(self.limit, self.measured, self.asked)
    }

    /// The depth of a fault on a level, if it is to be measured.
    pub(super) fn measure(
        &self,
        level: Level,
        size: impl FnOnce() -> Option<f64>,
    ) -> Option<Depth> {
        let is_asked = level <= self.asked && self.depths.measured() < self.measured;
        is_asked.then(size).flatten().and_then(Depth::new)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.found == 0
    }

    /// Whether rounding may explain all that keeps the triangles from being a constrained triangulation.
    pub(super) fn is_sound(&self) -> bool {
        self.is_sound
    }

    /// The highest level reached.
    fn reached(&self) -> Option<Level> {
        self.broken.map_or(Some(Level::Canonical), Level::below)
    }

    pub(super) fn add(&mut self, violation: Violation) {
        let level = violation.level();
        self.breaks(Some(level));
        self.is_sound &= level > Level::Constrained || violation.depth().is_some();
        if level > self.asked {
            return;
        }
        self.found += 1;
        if let Some(depth) = violation.depth() {
            self.depths.add(depth);
        }
        if self.list.len() < self.limit {
            self.list.push(violation);
        }
    }

    pub(super) fn append(&mut self, later: Findings) {
        self.breaks(later.broken);
        self.is_sound &= later.is_sound;
        self.found += later.found;
        self.depths.append(later.depths);
        self.list(later.list);
    }

    /// Lists violations that are counted already, as far as there is room.
    pub(super) fn list(&mut self, counted: Vec<Violation>) {
        let room = self.limit - self.list.len();
        self.list.extend(counted.into_iter().take(room));
    }

    fn breaks(&mut self, level: Option<Level>) {
        self.broken = self.broken.into_iter().chain(level).min();
    }
}
