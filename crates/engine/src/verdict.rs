//! Verdicts on triangles: by name, in words and in numbers.

use sweep_cdt::verify::{Depth, Level, Report, Violations};
use sweep_cdt_formats::Remark;

use crate::bounds::Violator;

/// The answer of the verifier.
pub type Answer = Result<Report, Violations>;

/// The verdict on triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The triangles are right.
    Correct,
    /// The triangles are wrong, but no violation is deeper than what counts as rounding.
    WithinMaxDepth,
    /// The triangles are wrong.
    Wrong,
}

impl Verdict {
    /// The verdict of an answer, where violations up to this depth count as rounding.
    pub fn of(answer: &Answer, max_depth: Option<f64>) -> Verdict {
        let Err(violations) = answer else {
            return Verdict::Correct;
        };
        match violations.depth().zip(max_depth) {
            Some((depth, max)) if depth.get() <= max => Verdict::WithinMaxDepth,
            _ => Verdict::Wrong,
        }
    }

    /// The verdict, where triangles that break bounds are wrong, too.
    #[must_use]
    pub fn with_bounds(self, violators: &[Violator]) -> Verdict {
        if violators.is_empty() {
            self
        } else {
            Verdict::Wrong
        }
    }

    /// The name in records.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Correct => "correct",
            Verdict::WithinMaxDepth => "within-max-depth",
            Verdict::Wrong => "wrong",
        }
    }
}

/// The counts of a report, by the names that they have in records.
pub fn counts(report: &Report) -> [(&'static str, usize); 11] {
    [
        ("points", report.points),
        ("distinct_points", report.distinct_points),
        ("edges", report.edges),
        ("triangles", report.triangles),
        ("boundary_sides", report.boundary_sides),
        ("constrained_sides", report.constrained_sides),
        ("free_sides", report.free_sides),
        ("cocircular_sides", report.cocircular_sides),
        ("uncanonical_sides", report.uncanonical_sides),
        ("added_points", report.added_points),
        ("split_edges", report.split_edges),
    ]
}

/// The remark that no side could break a level that was reached: all are edges.
pub fn nothing_free(answer: &Answer, level: Level) -> Option<Remark> {
    let report = answer.as_ref().ok()?;
    let sides = (3 * report.triangles - report.boundary_sides) / 2;
    let is_empty = level >= Level::Delaunay && report.free_sides == 0 && sides > 0;
    is_empty.then_some(Remark::NothingFree { sides })
}

/// The verdict on a level in words. `result` and `input` are what they are called.
pub fn headline(
    answer: &Answer,
    level: Level,
    max_depth: Option<f64>,
    [result, input]: [&str; 2],
) -> String {
    let what = level.title();
    let violations = match answer {
        Ok(report) => {
            let canonical = match (level, report.is_canonical()) {
                (Level::Delaunay, true) => ", the canonical one",
                (Level::Delaunay, false) => ", not the canonical one",
                _ => "",
            };
            return format!("correct: {result} is {what} of {input}{canonical}");
        }
        Err(violations) => violations,
    };
    let found = match violations.found {
        1 => "1 violation".to_owned(),
        found => format!("{found} violations"),
    };
    match (Verdict::of(answer, max_depth), max_depth) {
        (Verdict::WithinMaxDepth, Some(max)) => {
            let deepest = violations.depth().map_or(0.0, Depth::get);
            format!(
                "up to {max:e}: {result} is {what} of {input}, but not exactly: {found}, the deepest by {deepest:.1e}"
            )
        }
        _ => format!("wrong: {result} is not {what} of {input}: {found}"),
    }
}
