//! Advice after a verdict: what was found, and what to do, as data. `sentence.rs` says it.
//!
//! Why it can be trusted: a setting is named only if the verifier, run with it, has accepted the triangles. A change of
//! the triangles is named only if the changed ones have passed, or if the proof of the verifier says that they do.
//!
//! Cost: of right triangles, nothing. Wrong ones are verified again for each domain that they may fill, and for each
//! change that is tried.

use std::cmp::Reverse;

use sweep_cdt::Error;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Depth, Level, Violation, Violations};
use sweep_cdt_formats::Coordinate;

use crate::inside::Inside;
use crate::question::Question;
use crate::verdict::{Answer, Verdict};
use crate::wanted::Wanted;

/// What to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Advice {
    /// Nothing: the triangles are right. They may all run clockwise.
    Correct {
        /// Whether they do.
        clockwise: bool,
    },
    /// Nothing: no violation is deeper than what counts as rounding.
    Rounded,
    /// Mend the input, which has no triangulation with its edges.
    Refused(Error),
    /// Ask with the settings of this fit.
    Accept(Fit),
    /// Number corners from 0 instead of 1, and ask with the settings of this fit.
    NumberFromZero(Fit),
    /// Turn over the triangles that run the other way round than the others, and ask with the settings of this fit.
    TurnOver(Several, Fit),
    /// Remove the points from the input that no triangle has. Nothing else is wrong.
    Remove(Several),
    /// Make triangles: there are none.
    NoTriangles,
    /// Give the input of these triangles: corners are no points of this one.
    Strangers,
    /// Look at the violations: no setting and no change that is known helps. The first one has this name, if it is listed.
    Look(Option<&'static str>),
}

/// Triangles or points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Several {
    /// The position of the first.
    pub first: usize,
    /// How many there are.
    pub count: usize,
}

/// How triangles are accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The domain that they tile, if it is another than was asked for.
    pub domain: Option<Inside>,
    /// How well they do.
    pub how: How,
}

/// How well triangles tile a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum How {
    /// The triangles are right.
    Right,
    /// All violations have a depth.
    Shallow {
        /// How many there are.
        found: usize,
        /// The depth of the deepest.
        depth: Depth,
    },
    /// The triangles reach a lower level.
    Lower {
        /// The level.
        level: Level,
        /// The first edge that is not there, by its position, and whether it is there but bent.
        edge: Option<(usize, bool)>,
    },
}

/// A setting of a question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// What the triangles must tile.
    Domain(Inside),
    /// How deep violations may be.
    MaxDepth(f64),
    /// What the triangles must reach.
    Level(Level),
}

/// Depths up to this one come from rounding doubles.
pub(crate) const ROUNDING: f64 = 1e-12;
/// Depths up to this one come from rounding to single precision.
const SINGLE: f64 = 1e-5;

impl Several {
    fn of(positions: &[usize]) -> Option<Several> {
        Some(Several {
            first: *positions.first()?,
            count: positions.len(),
        })
    }
}

impl Fit {
    /// The settings that accept the triangles, beside those that were asked for; none, if those do.
    pub fn settings(&self) -> Vec<Setting> {
        let how = match self.how {
            How::Right => None,
            How::Shallow { depth, .. } => Some(Setting::MaxDepth(beyond(depth))),
            How::Lower { level, .. } => Some(Setting::Level(level)),
        };
        self.domain
            .map(Setting::Domain)
            .into_iter()
            .chain(how)
            .collect()
    }
}

impl<S: Coordinate, T: Scalar> Question<'_, S, T> {
    /// What to do after an answer to this question.
    pub fn advice(&self, answer: &Answer) -> Advice {
        let violations = match answer {
            Ok(report) => {
                let clockwise = report.clockwise;
                return Advice::Correct { clockwise };
            }
            Err(_) if self.verdict(answer) == Verdict::WithinMaxDepth => return Advice::Rounded,
            Err(violations) => violations,
        };
        let fit = match self.best_fit(self.triangles) {
            Ok(fit) => fit,
            Err(error) => return Advice::Refused(error),
        };
        let is_lower = |fit: &Fit| matches!(fit.how, How::Lower { .. });
        match fit {
            Some(fit) if !is_lower(&fit) => Advice::Accept(fit),
            _ => self
                .counted_from_one()
                .or_else(|| self.turned_over(violations))
                .or_else(|| self.left_out(violations))
                .or_else(|| fit.map(Advice::Accept))
                .unwrap_or_else(|| self.helpless(violations)),
        }
    }

    /// The best way to accept these triangles. Fails where the input has no triangulation.
    fn best_fit(&self, triangles: &[[usize; 3]]) -> Result<Option<Fit>, Error> {
        let fits = self.answers(triangles)?.into_iter();
        let fits = fits.filter_map(|(domain, answer)| {
            let how = match answer {
                Ok(_) => How::Right,
                Err(violations) => how(&violations)?,
            };
            let domain = (domain != self.domain).then_some(domain);
            Some(Fit { domain, how })
        });
        Ok(fits.min_by_key(|Fit { domain, how }| {
            let rank = match how {
                How::Right => (0, None),
                How::Shallow { .. } => (1, None),
                How::Lower { level, .. } => (2, Some(Reverse(*level))),
            };
            // Triangles that tile what was asked for tile nothing else.
            (domain.is_some(), rank)
        }))
    }

    /// The answers by all rules by which the triangles may be right; the one that was asked for is the first.
    fn answers(&self, triangles: &[[usize; 3]]) -> Result<Vec<(Inside, Answer)>, Error> {
        let mut rules = vec![Inside::HULL];
        if !self.input.rings.is_empty() {
            rules.push(Inside::Polygons);
        }
        let of_edges = [Inside::EVEN_ODD, Inside::NONZERO];
        if self.input.holes.is_empty() {
            rules.extend(of_edges);
            rules.push(Inside::Holes);
        } else {
            rules.extend([Inside::Holes, Inside::HullWithoutHoles]);
            rules.extend(of_edges);
        }
        rules.retain(|&rule| rule != self.domain);
        rules.insert(0, self.domain);
        let hull = self.hull()?;
        let may_add = self.added_from.is_some_and(|own| own < self.points.len());
        let is_possible = |wanted: &Wanted| {
            !triangles.is_empty() && (may_add || wanted.triangles == triangles.len())
        };
        let answer = |rule: Inside| {
            let mut question = self.but(triangles, rule, 1);
            // So all depths are measured.
            question.max_depth = Some(0.0);
            if rule == Inside::HULL {
                return Some((rule, question.in_hull()));
            }
            let wanted = Wanted::new(rule, self.input, &hull).ok();
            let wanted = wanted.filter(is_possible)?;
            Some((rule, question.within(&wanted)))
        };
        Ok(rules.into_iter().filter_map(answer).collect())
    }

    /// How changed triangles are accepted, if they are.
    fn fit_of(&self, changed: &[[usize; 3]]) -> Option<Fit> {
        self.best_fit(changed).ok().flatten()
    }

    /// Corners that run from 1 to the number of points.
    fn counted_from_one(&self) -> Option<Advice> {
        let count = self.points.len();
        let number = |&corner: &usize| {
            let stranger = corner
                .checked_sub(count)
                .and_then(|i| self.strangers.get(i));
            stranger.copied().unwrap_or(corner)
        };
        let numbers = || self.triangles.as_flattened().iter().map(number);
        if numbers().min() != Some(1) || numbers().max() != Some(count) {
            return None;
        }
        let from_zero = |corner: usize| corner.min(count) - 1;
        let changed: Vec<_> = self.triangles.iter().map(|t| t.map(from_zero)).collect();
        self.fit_of(&changed).map(Advice::NumberFromZero)
    }

    /// Triangles of which some run clockwise.
    fn turned_over(&self, violations: &Violations) -> Option<Advice> {
        let reversed = |violation: &Violation| match *violation {
            Violation::ReversedTriangle { triangle } => Some(triangle),
            _ => None,
        };
        let all = self.all_of(violations, |first| reversed(first).is_some())?;
        let fewer: Vec<usize> = all.iter().filter_map(reversed).collect();
        let mut changed = self.triangles.to_vec();
        for &triangle in &fewer {
            changed[triangle].swap(1, 2);
        }
        Some(Advice::TurnOver(
            Several::of(&fewer)?,
            self.fit_of(&changed)?,
        ))
    }

    /// Vertices that no triangle has, if nothing else is wrong. Then the proof of the verifier holds for all others.
    fn left_out(&self, violations: &Violations) -> Option<Advice> {
        let unused = |violation: &Violation| match *violation {
            Violation::UnusedPoint { vertex } => Some(vertex),
            _ => None,
        };
        let all = self.all_of(violations, |first| unused(first).is_some())?;
        let all: Vec<usize> = all.iter().map(unused).collect::<Option<_>>()?;
        Several::of(&all).map(Advice::Remove)
    }

    /// All violations, if the first one is of a kind.
    fn all_of(
        &self,
        violations: &Violations,
        is_of_it: impl Fn(&Violation) -> bool,
    ) -> Option<Vec<Violation>> {
        let all = |limit: usize| {
            let answer = self.but(self.triangles, self.domain, limit).answer();
            answer.ok().and_then(Result::err).map(|found| found.list)
        };
        let first = all(1)?;
        first
            .first()
            .is_some_and(is_of_it)
            .then(|| all(violations.found))?
    }

    fn helpless(&self, violations: &Violations) -> Advice {
        let is_stranger = |&corner: &usize| corner >= self.points.len();
        if self.triangles.is_empty() {
            Advice::NoTriangles
        } else if self.triangles.as_flattened().iter().any(is_stranger) {
            Advice::Strangers
        } else {
            Advice::Look(violations.list.first().map(Violation::name))
        }
    }
}

/// How violations can be accepted.
fn how(violations: &Violations) -> Option<How> {
    let found = violations.found;
    let depth = violations.depth().filter(|depth| depth.get() <= SINGLE);
    if let Some(depth) = depth {
        return Some(How::Shallow { found, depth });
    }
    let edge = match violations.list.first() {
        Some(&Violation::MissingEdge { edge, .. }) => Some((edge, false)),
        Some(&Violation::BentEdge { edge, .. }) => Some((edge, true)),
        _ => None,
    };
    let level = violations.report.level?;
    Some(How::Lower { level, edge })
}

/// A power of ten that no depth exceeds which comes from the same rounding.
fn beyond(depth: Depth) -> f64 {
    let above = format!("1e{}", depth.decade() + 1).parse();
    ROUNDING.max(above.unwrap_or(SINGLE))
}
