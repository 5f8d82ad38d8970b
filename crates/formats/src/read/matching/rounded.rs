//! Which vertices of the input a vertex may be that is rounded, or that differs by no more than a tolerance; and why such
//! vertices are refused.
//!
//! Each coordinate has a range, from the least to the greatest number that the input's may be. The ends are numbers of the
//! input's type, so comparing decides exactly.

use crate::Coordinate;
use crate::read::matching::nearby::{Nearby, apart};
use crate::read::matching::refusal::{Nearest, ResultError};
use crate::read::matching::rounding::{Rule, are_singles, fixed_places};
use crate::read::matching::written::{Precision, Written};

/// Vertices of a result whose coordinates are rounded, or differ by no more than a tolerance.
pub(super) struct Rounded<'a, S, W> {
    tolerance: Option<f64>,
    written: &'a W,
    points: &'a [[S; 2]],
    own: &'a [[S; 2]],
    /// The vertices of the input that are exactly these.
    found: &'a [Option<usize>],
    /// The points, as doubles.
    values: Vec<[f64; 2]>,
    /// How they may be rounded: all of them by one of these.
    pub(super) rules: Vec<Rule>,
}

impl<'a, S: Coordinate, W: Written> Rounded<'a, S, W> {
    pub(super) fn new(
        tolerance: Option<f64>,
        written: &'a W,
        points: &'a [[S; 2]],
        own: &'a [[S; 2]],
        found: &'a [Option<usize>],
    ) -> Rounded<'a, S, W> {
        let approximation = |point: &[S; 2]| point.each_ref().map(S::approx);
        let values: Vec<[f64; 2]> = points.iter().map(approximation).collect();
        let rules = match written.precision() {
            Precision::Digits if are_singles(written, &values) => {
                vec![Rule::Decimals, Rule::Singles]
            }
            Precision::Digits => vec![Rule::Decimals],
            Precision::Singles => vec![Rule::Singles],
            Precision::Exact => vec![Rule::Exact],
        };
        Rounded {
            tolerance,
            written,
            points,
            own,
            found,
            values,
            rules,
        }
    }

    /// Whether this vertex of the result may be that one of the input.
    pub(super) fn is_close(&self, at: usize, v: usize) -> bool {
        (0..2).all(|axis| {
            let (read, exact) = (&self.points[at][axis], &self.own[v][axis]);
            let is_in_range = |&rule: &Rule| {
                let range = self.range(rule, at, axis);
                range.is_some_and(|[low, high]| {
                    low.compare(exact).is_le() && exact.compare(&high).is_le()
                })
            };
            read == exact || self.rules.iter().any(is_in_range)
        })
    }

    /// The least and the greatest number that a coordinate of the input may be; `None` for a fraction, which is not
    /// rounded.
    fn range(&self, rule: Rule, at: usize, axis: usize) -> Option<[S; 2]> {
        if let Some(tolerance) = self.tolerance {
            return Some(self.points[at][axis].within(tolerance));
        }
        let text = self.written.text(at, axis);
        let [low, high] = rule.doubles(&text, self.values[at][axis])?;
        // Others than doubles were rounded to these first.
        let [low, high] = match S::APPROX_IS_EXACT {
            true => [low, high],
            false => [low.next_down(), high.next_up()],
        };
        Some([S::from_double(low).ok()?, S::from_double(high).ok()?])
    }

    /// The vertices of the input that this one may be: two of them, the only one, or none.
    pub(super) fn candidates(
        &self,
        nearby: &Nearby<'_, S>,
        rule: Rule,
        at: usize,
    ) -> [Option<usize>; 2] {
        let rectangle = self.range(rule, at, 0).zip(self.range(rule, at, 1));
        let rounded = rectangle.map(|(x, y)| nearby.first_two(&x, &y));
        rounded.unwrap_or([self.found[at], None])
    }

    /// For each vertex of the result the only one of the input that it may be, all by one rule.
    pub(super) fn places(&self, nearby: &Nearby<'_, S>) -> Option<(Vec<usize>, Rule)> {
        let fixed = fixed_places(self.written, self.points.len()).map(Rule::Fixed);
        let mut rules = fixed.into_iter().chain(self.rules.iter().copied());
        rules.find_map(|rule| {
            let mut first_at = vec![None; self.own.len()];
            let place = |at: usize| match self.candidates(nearby, rule, at) {
                // Vertices at two places are not one vertex.
                [Some(v), None] => {
                    let first = *first_at[v].get_or_insert(at);
                    (self.points[first] == self.points[at]).then_some(v)
                }
                _ => None,
            };
            let places: Option<Vec<usize>> = (0..self.points.len()).map(place).collect();
            Some((places?, rule))
        })
    }

    /// Why there are no places: the first vertex that may be none of the input, or else that may be two, or else two
    /// vertices that may be one.
    pub(super) fn refusal(
        &self,
        nearby: &Nearby<'_, S>,
        is_soup: bool,
        first: usize,
    ) -> ResultError {
        let named = |v: usize| v + first;
        let candidates = |at: usize| self.candidates(nearby, self.rules[0], at);
        let all = 0..self.points.len();
        let stranger = all.clone().find(|&at| candidates(at)[0].is_none());
        let ambiguous = || {
            all.clone().find_map(|at| match candidates(at) {
                [Some(one), Some(other)] => Some((at, [one, other])),
                _ => None,
            })
        };
        let accepted = nearby.tolerance(self.points);
        let tolerance = self.tolerance;
        if stranger.is_none()
            && let Some((at, mut of_input)) = ambiguous()
        {
            let (file, line, vertex) = self.written.name(at);
            of_input.sort_unstable();
            return ResultError::Ambiguous {
                file,
                line,
                vertex,
                at: self.values[at],
                of_input: of_input.map(named),
                tolerance,
                accepted,
            };
        }
        let mut first_at = vec![None; self.own.len()];
        let mut shared = all.filter_map(|at| {
            let v = candidates(at)[0]?;
            let first = *first_at[v].get_or_insert(at);
            (self.points[first] != self.points[at]).then_some((first, at, v))
        });
        if stranger.is_none()
            && let Some((one, other, v)) = shared.next()
        {
            let (file, line, other) = self.written.name(other);
            return ResultError::Shared {
                file,
                line,
                vertices: [self.written.name(one).2, other],
                of_input: named(v),
                tolerance,
                accepted,
            };
        }
        let at = stranger.unwrap_or(0);
        let (file, line, vertex) = self.written.name(at);
        let nearest = nearby.nearest(&self.points[at]).map(|v| {
            Box::new(Nearest {
                of_input: named(v),
                at: self.own[v].each_ref().map(S::approx),
                difference: apart(&self.points[at], &self.own[v]),
            })
        });
        ResultError::Stranger {
            file,
            line,
            vertex,
            at: self.values[at],
            nearest,
            is_numbered: !is_soup,
            tolerance,
            accepted,
        }
    }
}
