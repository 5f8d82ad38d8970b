//! The last line of a report of `verify`: what was found, and what to do, in words.
//!
//! Why it can be trusted: an option is named only if the verifier, run with it, has accepted the result. A change of the
//! result is named only if the changed result has passed, or if the proof of the verifier says that it does.
//!
//! Cost: of a correct result, nothing. A wrong one is verified again for each domain that it may fill, and for each
//! change that is tried.

use std::cmp::Reverse;
use std::fmt::Write;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Depth, Level, Verifier, Violation, Violations};
use sweep_cdt_formats::{Coordinate, Triangles};

use crate::shared::arithmetic::Given;
use crate::shared::failure::Failure;
use crate::shared::inside::{Inside, answer, answers};
use crate::shared::verification::Answer;

/// What was verified, and the answer.
pub(crate) struct Advised<'a, S, T> {
    pub(crate) given: &'a Given<'a, S, T>,
    /// How many points are the input's own.
    pub(crate) own: usize,
    pub(crate) verifier: Verifier<'a>,
    pub(crate) triangles: &'a Triangles,
    pub(crate) domain: Inside,
    pub(crate) answer: &'a Answer,
    /// Whether no violation is deeper than what was allowed.
    pub(crate) is_within: bool,
}

/// Options with which a result is accepted.
struct Fit {
    domain: Inside,
    how: How,
}

enum How {
    Right,
    /// So many violations, the deepest of this depth.
    Shallow(usize, Depth),
    /// A lower level, and the first edge that is not there, with what it is.
    Lower(Level, Option<(usize, &'static str)>),
}

/// Depths up to this one come from rounding doubles.
const ROUNDING: f64 = 1e-12;
/// Depths up to this one come from rounding to single precision.
const SINGLE: f64 = 1e-5;

impl<S: Coordinate, T: Scalar + Sync> Advised<'_, S, T> {
    /// The line.
    pub(crate) fn line(&self) -> String {
        let violations = match self.answer {
            Ok(report) if report.clockwise => {
                return "correct: nothing to do; the triangles run clockwise".to_owned();
            }
            Ok(_) => return "correct: nothing to do".to_owned(),
            Err(_) if self.is_within => {
                return "right but for rounding, as --max-depth allows: nothing to do".to_owned();
            }
            Err(violations) => violations,
        };
        let fit = match self.best_fit(self.triangles) {
            Ok(fit) => fit,
            Err(Failure::Error(message)) => {
                let advice = "(`sweep-cdt crossings` lists edges that cross)";
                return format!(
                    "the input has no triangulation with its edges: {message} {advice}"
                );
            }
            Err(_) => None,
        };
        let is_lower = |fit: &Fit| matches!(fit.how, How::Lower(..));
        if let Some(fit) = fit.as_ref().filter(|fit| !is_lower(fit)) {
            return self.in_words(fit);
        }
        let change = self
            .counted_from_one()
            .or_else(|| self.turned_over(violations))
            .or_else(|| self.left_out(violations));
        change
            .or_else(|| fit.map(|fit| self.in_words(&fit)))
            .unwrap_or_else(|| self.without_advice(violations))
    }

    /// The options that accept these triangles, with the fewest violations.
    fn best_fit(&self, triangles: &Triangles) -> Result<Option<Fit>, Failure> {
        let verifier = self.verifier.all_depths(true).limit(1);
        let found = answers(self.given, self.own, verifier, triangles, self.domain)?;
        let fits = found.into_iter().filter_map(|(domain, answer)| {
            let how = match answer {
                Ok(_) => How::Right,
                Err(violations) => how(&violations)?,
            };
            Some(Fit { domain, how })
        });
        Ok(fits.min_by_key(|Fit { domain, how }| {
            let rank = match how {
                How::Right => (0, None),
                How::Shallow(..) => (1, None),
                How::Lower(level, _) => (2, Some(Reverse(*level))),
            };
            // Triangles that tile what was asked for tile nothing else.
            (*domain != self.domain, rank)
        }))
    }

    /// The options of a fit, as they are written; none, if it needs none.
    fn options(&self, fit: &Fit) -> String {
        let mut options = Vec::new();
        if fit.domain != self.domain {
            options.push(format!("--domain {}", fit.domain));
        }
        match fit.how {
            How::Right => {}
            How::Shallow(_, depth) => options.push(format!("--max-depth {:e}", beyond(depth))),
            How::Lower(level, _) => options.push(format!("--level {}", level.name())),
        }
        options.join(" ")
    }

    fn in_words(&self, fit: &Fit) -> String {
        let options = self.options(fit);
        let place = match fit.domain {
            domain if domain == self.domain => "",
            Inside::Hull => " of the hull",
            _ => " of the interior",
        };
        match fit.how {
            How::Right => format!("this is a right triangulation{place}: `{options}`"),
            How::Shallow(found, depth) => {
                let what = match depth.get() <= ROUNDING {
                    true => "rounding",
                    false => "rounding to single precision",
                };
                let prefix = match place {
                    "" => String::new(),
                    place => format!("as a triangulation{place} "),
                };
                match found {
                    1 => format!(
                        "{prefix}the only violation is of the size of {what} (depth {depth}): `{options}` accepts it"
                    ),
                    _ => format!(
                        "{prefix}all {found} violations are of the size of {what} (deepest {depth}): `{options}` \
                         accepts them"
                    ),
                }
            }
            How::Lower(level, missing) => {
                let but = match (level, missing) {
                    (Level::Delaunay, _) => "not the canonical one".to_owned(),
                    (Level::Constrained, _) => "not Delaunay".to_owned(),
                    (_, Some((edge, is))) => {
                        let number = edge + self.given.file.numbering.edge;
                        format!("without all edges of the input (edge {number} is {is})")
                    }
                    (_, None) => "with wrong attributes of regions".to_owned(),
                };
                format!(
                    "this is {}{place}, but {but}: `{options}` accepts it",
                    level.title()
                )
            }
        }
    }

    /// A change of the result in words, with the options that accept the changed triangles.
    fn then(&self, mut change: String, changed: &Triangles) -> Option<String> {
        let fit = self.best_fit(changed).ok().flatten()?;
        let options = self.options(&fit);
        if !options.is_empty() {
            write!(change, ", and add `{options}`").expect("strings grow");
        }
        Some(change)
    }

    /// Corners that run from 1 to the number of points, where the format counts from 0.
    fn counted_from_one(&self) -> Option<String> {
        let Triangles {
            list, strangers, ..
        } = self.triangles;
        let count = self.given.file.graph.points.len();
        let least = list.as_flattened().iter().min();
        let is_last = |&number: &usize| number == count;
        if least != Some(&1) || strangers.is_empty() || !strangers.iter().all(is_last) {
            return None;
        }
        let mut changed = self.triangles.clone();
        for corner in changed.list.as_flattened_mut() {
            *corner = (*corner).min(count) - 1;
        }
        changed.strangers.clear();
        let change =
            "corners are numbered from 1 and this format counts from 0: subtract 1 from each";
        self.then(change.to_owned(), &changed)
    }

    /// Triangles of which some run clockwise.
    fn turned_over(&self, violations: &Violations) -> Option<String> {
        let is_reversed = |violation: &Violation| match *violation {
            Violation::ReversedTriangle { triangle } => Some(triangle),
            _ => None,
        };
        let all = self.all_of(violations, |first| is_reversed(first).is_some())?;
        let fewer: Vec<usize> = all.iter().filter_map(is_reversed).collect();
        let mut changed = self.triangles.clone();
        for &triangle in &fewer {
            changed.list[triangle].swap(1, 2);
        }
        let first = fewer.first()? + changed.first;
        let change = match fewer.len() {
            1 => format!(
                "triangle {first} runs the other way round than all others: swap two of its corners"
            ),
            count => format!(
                "{count} triangles run the other way round than the others, the first is {first}: swap two corners \
                 of each"
            ),
        };
        self.then(change, &changed)
    }

    /// Vertices that no triangle has, if nothing else is wrong. Then the proof of the verifier holds for all others.
    fn left_out(&self, violations: &Violations) -> Option<String> {
        let unused = |violation: &Violation| match *violation {
            Violation::UnusedPoint { vertex } => Some(vertex),
            _ => None,
        };
        let all = self.all_of(violations, |first| unused(first).is_some())?;
        let all: Option<Vec<usize>> = all.iter().map(unused).collect();
        let all = all?;
        let file = self.given.file;
        let number = all[0] + file.numbering.vertex;
        let [x, y] = file.graph.points[all[0]].each_ref().map(S::text);
        Some(match all.len() {
            1 => format!(
                "vertex {number} of the input, at ({x}, {y}), is used by no triangle, and nothing else is wrong: remove \
                 it from the input, and run the program again"
            ),
            count => format!(
                "{count} vertices of the input are used by no triangle, the first is {number} at ({x}, {y}), and \
                 nothing else is wrong: remove them from the input, and run the program again"
            ),
        })
    }

    /// All violations, if the first one is of a kind.
    fn all_of(
        &self,
        violations: &Violations,
        is_of_it: impl Fn(&Violation) -> bool,
    ) -> Option<Vec<Violation>> {
        let all = |limit: usize| {
            let verifier = self.verifier.limit(limit);
            let answer = answer(self.domain, self.given, self.own, verifier, self.triangles);
            answer.ok().and_then(Result::err).map(|found| found.list)
        };
        let first = all(1)?;
        first
            .first()
            .is_some_and(is_of_it)
            .then(|| all(violations.found))?
    }

    /// What is said where no option and no change that is known helps.
    fn without_advice(&self, violations: &Violations) -> String {
        let what = if self.triangles.list.is_empty() {
            "the result has no triangles".to_owned()
        } else if !self.triangles.strangers.is_empty() {
            "corners are no vertices of the input: perhaps this is the result of another one"
                .to_owned()
        } else {
            match violations.list.first() {
                Some(first) => format!(
                    "no option accepts this, the first violation is {}",
                    first.name()
                ),
                None => "no option accepts this".to_owned(),
            }
        };
        format!("{what}: `--svg wrong.svg` and `--geojson wrong.geojson` show where it is wrong")
    }
}

/// How violations can be accepted.
fn how(violations: &Violations) -> Option<How> {
    let depth = violations.depth().filter(|depth| depth.get() <= SINGLE);
    if let Some(depth) = depth {
        return Some(How::Shallow(violations.found, depth));
    }
    let missing = match violations.list.first() {
        Some(&Violation::MissingEdge { edge, .. }) => Some((edge, "missing")),
        Some(&Violation::BentEdge { edge, .. }) => Some((edge, "not straight")),
        _ => None,
    };
    let level = violations.report.level?;
    Some(How::Lower(level, missing))
}

/// A power of ten that no depth exceeds which comes from the same rounding.
fn beyond(depth: Depth) -> f64 {
    let above = format!("1e{}", depth.decade() + 1).parse();
    ROUNDING.max(above.unwrap_or(SINGLE))
}
