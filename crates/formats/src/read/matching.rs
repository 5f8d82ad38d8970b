//! Which vertex of the input each vertex of a result is.
//!
//! A result that lists its vertices tells so by their coordinates, in whatever order they stand: all of
//! them must be vertices of the input, exactly. Where one is not, the file may have rounded coordinates.
//! Then numbers decide, and coordinates only confirm them: each must be the one of the same number,
//! rounded. Where numbers do not fit, or there are none because triangles are listed by coordinates alone, each vertex
//! of the file must be one vertex of the input, rounded ([`Rule`]), and no other one. Of two that are possible none is
//! taken, and the nearest vertex is never taken for the right one.
//!
//! Cost: a sort of the input's points and one of the vertices of the file; of rounded ones what [`Nearby`] takes.

use std::cmp::Ordering;

use num_rational::BigRational;

use crate::read::content::Vertices;
use crate::read::nearby::{Nearby, around};
use crate::read::rounding::{Rule, are_singles, fixed_places};
use crate::read::source::{Nearest, ReadError, ResultError};
use crate::{Coordinate, GraphFile};
use sweep_cdt::scalar::Scalar;

/// How vertices of a result are matched with those of the input.
///
/// [`Matching::read`] reads a result so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Matching {
    by_number: bool,
    tolerance: Option<f64>,
}

impl Matching {
    /// By coordinates; by number where these are rounded to 6 or more digits, or where there are none. Rounded ones
    /// whose numbers do not fit are matched by coordinates too, if each is that of one vertex only.
    #[must_use]
    pub fn new() -> Matching {
        Matching::default()
    }

    /// Whether vertices are matched by number, whatever their coordinates.
    #[must_use]
    pub fn by_number(self, by_number: bool) -> Matching {
        Matching { by_number, ..self }
    }

    /// By how much a coordinate may differ from that of the vertex of the same number, or of the only vertex within
    /// this difference, in place of rounding.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Matching {
        Matching {
            tolerance: Some(tolerance),
            ..self
        }
    }

    /// How the vertices of a file match those of the input, and for each of them the place in the input,
    /// unless it is that of the same number.
    pub(super) fn places<S: Coordinate>(
        self,
        vertices: &Vertices<'_>,
        is_soup: bool,
        points: &[[S; 2]],
        input: &GraphFile<S>,
    ) -> Result<(Matched, Option<Vec<usize>>), ResultError> {
        refuse_non_finite(vertices, points)?;
        let own = &input.graph.points;
        if self.by_number && is_soup {
            let message = "the triangles are coordinates, and their vertices have no numbers";
            return Err(ReadError::of_file(&vertices.source.name, message).into());
        }
        let pairs = || points.iter().zip(own).map(|(p, q)| apart(p, q));
        let greatest = || pairs().fold(0.0, f64::max);
        if self.by_number {
            let difference = greatest();
            return Ok((Matched::Asked { difference }, None));
        }
        // The corners of a soup have no numbers: each is the lowest of equal vertices.
        if !is_soup && points == own {
            return Ok((Matched::Equal, None));
        }
        let found = find(points, own);
        if let Some(places) = found.iter().copied().collect() {
            return Ok((Matched::Equal, Some(places)));
        }

        // Some vertex is none of the input's: numbers decide, if there are any, and as many.
        let rounded = Rounded::new(self.tolerance, vertices, points, own, &found);
        let has_numbers = !is_soup && points.len() == own.len();
        let far: Vec<usize> = match has_numbers {
            true => (0..points.len())
                .filter(|&at| !rounded.is_close(at, at))
                .collect(),
            false => Vec::new(),
        };
        if has_numbers && far.is_empty() {
            let difference = greatest();
            let matched = match self.tolerance {
                None => Matched::Rounded { difference },
                Some(_) => Matched::Near { difference },
            };
            return Ok((matched, None));
        }
        let nearby = Nearby::new(approximations(own), distinct(own));
        let at = match rounded.places(&nearby) {
            Ok((places, rule)) => {
                let pairs = points.iter().zip(&places).map(|(p, &v)| apart(p, &own[v]));
                let difference = pairs.fold(0.0, f64::max);
                let matched = match (self.tolerance, rule) {
                    (Some(_), _) => Matched::Within { difference },
                    (None, Rule::Decimals | Rule::Fixed(_)) => Matched::Printed { difference },
                    (None, Rule::Singles) => Matched::Single { difference },
                };
                return Ok((matched, Some(places)));
            }
            Err(at) => at,
        };

        let accepted = nearby.tolerance(&rounded.values);
        if has_numbers {
            // A vertex that is nowhere in the input says more than one that is elsewhere.
            let stranger = far.iter().copied().find(|&at| found[at].is_none());
            let at = stranger.unwrap_or(far[0]);
            let (file, line, vertex) = vertices.name(at);
            let greatest = greatest();
            return Err(ResultError::Elsewhere {
                file,
                line,
                vertex,
                at: rounded.values[at],
                of_input: at + input.numbering.vertex,
                expected: own[at].each_ref().map(S::approx),
                difference: apart(&points[at], &own[at]),
                tolerance: self.tolerance,
                accepted: accepted.map_or(greatest, |by_place| by_place.min(greatest)),
            });
        }
        let (file, line, vertex) = vertices.name(at);
        let place = rounded.values[at];
        let named = |v: usize| v + input.numbering.vertex;
        if let [Some(one), Some(other)] = rounded.candidates(&nearby, rounded.rules[0], at) {
            return Err(ResultError::Ambiguous {
                file,
                line,
                vertex,
                at: place,
                of_input: [one.min(other), one.max(other)].map(named),
                tolerance: self.tolerance,
            });
        }
        let nearest = nearby.nearest(place).map(|(v, difference)| {
            Box::new(Nearest {
                of_input: named(v),
                at: nearby.points()[v],
                difference,
            })
        });
        Err(ResultError::Stranger {
            file,
            line,
            vertex,
            at: place,
            nearest,
            is_numbered: !is_soup,
            accepted,
        })
    }
}

/// A file with coordinates that are rounded, or differ by no more than a tolerance.
struct Rounded<'a, S> {
    tolerance: Option<f64>,
    vertices: &'a Vertices<'a>,
    points: &'a [[S; 2]],
    own: &'a [[S; 2]],
    /// The vertices of the input that are exactly these.
    found: &'a [Option<usize>],
    /// The points, as doubles.
    values: Vec<[f64; 2]>,
    /// How they may be rounded: all of them by one of these.
    rules: Vec<Rule>,
}

impl<'a, S: Coordinate> Rounded<'a, S> {
    fn new(
        tolerance: Option<f64>,
        vertices: &'a Vertices<'a>,
        points: &'a [[S; 2]],
        own: &'a [[S; 2]],
        found: &'a [Option<usize>],
    ) -> Rounded<'a, S> {
        let values = approximations(points);
        let rules = if vertices.is_single() {
            vec![Rule::Singles]
        } else {
            let singles = are_singles(vertices, &values).then_some(Rule::Singles);
            [Rule::Decimals].into_iter().chain(singles).collect()
        };
        Rounded {
            tolerance,
            vertices,
            points,
            own,
            found,
            values,
            rules,
        }
    }

    /// Whether this vertex of the file may be that one of the input.
    fn is_close(&self, at: usize, v: usize) -> bool {
        if let Some(tolerance) = self.tolerance {
            return apart(&self.points[at], &self.own[v]) <= tolerance;
        }
        (0..2).all(|axis| {
            let (read, exact) = (&self.points[at][axis], &self.own[v][axis]);
            let is_rounded = |&rule: &Rule| {
                let range = self.range(rule, at, axis);
                range.is_some_and(|[low, high]| (low..=high).contains(&exact.approx()))
            };
            read == exact || self.rules.iter().any(is_rounded)
        })
    }

    /// The least and the greatest double that a coordinate of the input may be which is rounded to this one; `None` for
    /// a fraction, which is not rounded.
    fn range(&self, rule: Rule, at: usize, axis: usize) -> Option<[f64; 2]> {
        let text = self.vertices.text(at, axis);
        let [low, high] = rule.doubles(&text, self.values[at][axis])?;
        // Others than doubles are known to one unit in the last place only.
        Some(match S::APPROX_IS_EXACT {
            true => [low, high],
            false => [low.next_down(), high.next_up()],
        })
    }

    /// The vertices of the input that this one may be: two of them, the only one, or none.
    fn candidates(&self, nearby: &Nearby, rule: Rule, at: usize) -> [Option<usize>; 2] {
        let rectangle = match self.tolerance {
            Some(tolerance) => Some(around(self.values[at], tolerance)),
            None => self.range(rule, at, 0).zip(self.range(rule, at, 1)),
        };
        let rounded = rectangle.map(|(x, y)| nearby.first_two(x, y));
        rounded.unwrap_or([self.found[at], None])
    }

    /// For each vertex of the file the only one of the input that it may be, all by one rule; or the first vertex for
    /// which there are two, or none.
    fn places(&self, nearby: &Nearby) -> Result<(Vec<usize>, Rule), usize> {
        let by = |rule: Rule| {
            let mut places = Vec::with_capacity(self.points.len());
            let mut first_at = vec![None; self.own.len()];
            for at in 0..self.points.len() {
                let [Some(v), None] = self.candidates(nearby, rule, at) else {
                    return Err(at);
                };
                // Vertices at two places are not one vertex.
                let first = *first_at[v].get_or_insert(at);
                if self.points[first] != self.points[at] {
                    return Err(if self.found[at].is_none() { at } else { first });
                }
                places.push(v);
            }
            Ok((places, rule))
        };
        let fixed = fixed_places(self.vertices).map(Rule::Fixed);
        let mut rules = fixed.into_iter().chain(self.rules.iter().copied());
        rules
            .find_map(|rule| by(rule).ok())
            .map_or_else(|| by(self.rules[0]), Ok)
    }
}

/// The points as doubles.
fn approximations<S: Scalar>(points: &[[S; 2]]) -> Vec<[f64; 2]> {
    let approximation = |point: &[S; 2]| point.each_ref().map(S::approx);
    points.iter().map(approximation).collect()
}

/// The positions of finite points, of equal ones the lowest.
fn distinct<S: Scalar>(points: &[[S; 2]]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..points.len())
        .filter(|&v| is_finite(&points[v]))
        .collect();
    sorted.sort_by(|&v, &w| order(&points[v], &points[w]));
    sorted.dedup_by(|v, w| order(&points[*v], &points[*w]).is_eq());
    sorted
}

/// The vertices of a file that are none of `own`, the input's. One is the input's too if it is that of the only vertex
/// that the file lacks otherwise, and that is rounded to it.
pub(super) fn added<S: Coordinate>(
    vertices: &Vertices<'_>,
    points: &[[S; 2]],
    own: &[[S; 2]],
) -> Result<Vec<[S; 2]>, ResultError> {
    refuse_non_finite(vertices, points)?;
    let found = find(points, own);
    let mut is_there = vec![false; own.len()];
    found.iter().flatten().for_each(|&v| is_there[v] = true);
    let mut missing = distinct(own);
    missing.retain(|&v| !is_there[v]);
    let nearby = Nearby::new(approximations(own), missing);
    let rounded = Rounded::new(None, vertices, points, own, &found);
    let is_rounded = |at: usize| {
        let mut rules = rounded.rules.iter();
        rules.any(|&rule| matches!(rounded.candidates(&nearby, rule, at), [Some(_), None]))
    };
    let is_added = |&at: &usize| found[at].is_none() && !is_rounded(at);
    let added = (0..points.len()).filter(is_added);
    Ok(added.map(|at| points[at].clone()).collect())
}

fn refuse_non_finite<S: Scalar>(
    vertices: &Vertices<'_>,
    points: &[[S; 2]],
) -> Result<(), ResultError> {
    let Some(at) = points.iter().position(|point| !is_finite(point)) else {
        return Ok(());
    };
    let (file, line, vertex) = vertices.name(at);
    Err(ResultError::NonFinite { file, line, vertex })
}

/// For each of `points` the lowest position in `among` of an equal point. All of `points` are finite.
pub(super) fn find<S: Scalar>(points: &[[S; 2]], among: &[[S; 2]]) -> Vec<Option<usize>> {
    let among_sorted = sorted(among);
    let mut found = vec![None; points.len()];
    let mut first = 0;
    for (approx, at) in sorted(points) {
        let point = &points[at];
        let is_before = |&(other, v): &([f64; 2], usize)| {
            let by_approx = by_approx(&other, &approx);
            by_approx.then_with(|| order(&among[v], point)).is_lt()
        };
        while among_sorted.get(first).is_some_and(is_before) {
            first += 1;
        }
        let candidate = among_sorted.get(first).map(|&(_, v)| v);
        found[at] = candidate.filter(|&v| order(&among[v], point).is_eq());
    }
    found
}

/// The finite points by x, then y, with their approximations, which decide nearly always; of equal ones the first first.
fn sorted<S: Scalar>(points: &[[S; 2]]) -> Vec<([f64; 2], usize)> {
    let finite = points.iter().enumerate().filter(|(_, p)| is_finite(p));
    let mut sorted: Vec<([f64; 2], usize)> = finite
        .map(|(v, point)| (point.each_ref().map(S::approx), v))
        .collect();
    sorted.sort_unstable_by(|&(p, v), &(q, w)| {
        by_approx(&p, &q)
            .then_with(|| order(&points[v], &points[w]))
            .then(v.cmp(&w))
    });
    sorted
}

/// The order of approximations, which are never NaN.
fn by_approx(p: &[f64; 2], q: &[f64; 2]) -> Ordering {
    p.partial_cmp(q).unwrap_or(Ordering::Equal)
}

fn order<S: Scalar>(p: &[S; 2], q: &[S; 2]) -> Ordering {
    p[0].compare(&q[0]).then_with(|| p[1].compare(&q[1]))
}

pub(super) fn is_finite<S: Scalar>(point: &[S; 2]) -> bool {
    point.iter().all(S::is_finite)
}

/// The greater of the differences in x and in y.
fn apart<S: Coordinate>(p: &[S; 2], q: &[S; 2]) -> f64 {
    let [x, y] = [0, 1].map(|axis| difference(&p[axis], &q[axis]));
    x.max(y)
}

/// The difference of two coordinates, as a finite double.
fn difference<S: Coordinate>(x: &S, y: &S) -> f64 {
    let exact = |x: &S| BigRational::from_text(&x.text()).ok();
    let difference = match (S::APPROX_IS_EXACT || x == y, exact) {
        (true, _) => None,
        (false, exact) => exact(x).zip(exact(y)).map(|(x, y)| (x - y).approx()),
    };
    let difference = difference.unwrap_or_else(|| x.approx() - y.approx());
    difference.abs().min(f64::MAX)
}

/// How the vertices of a result were matched with those of the input.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Matched {
    /// By coordinates: each vertex of the result is one of the input, exactly.
    Equal,
    /// By coordinates: each is that of a vertex of the input, rounded to single precision, and of no other one.
    Single {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By coordinates: each is that of a vertex of the input, rounded to the digits that are printed, and of no other one.
    Printed {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By coordinates: within the tolerance that was asked for, each has one vertex of the input, and no other one.
    Within {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number: the result has no coordinates.
    Unplaced,
    /// By number: each coordinate of the result is that of the input, rounded.
    Rounded {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number: no coordinate differs by more than the tolerance that was asked for.
    Near {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number, as was asked for, wherever the vertices are.
    Asked {
        /// The greatest difference of two coordinates; of a vertex that only one of the files has there is
        /// none.
        difference: f64,
    },
}

impl Matched {
    /// The rule that decided: `coordinates` or `number`.
    pub fn by(self) -> &'static str {
        match self {
            Matched::Equal
            | Matched::Single { .. }
            | Matched::Printed { .. }
            | Matched::Within { .. } => "coordinates",
            _ => "number",
        }
    }

    /// The greatest difference of a coordinate of the result from that of the input; `None` where the
    /// result has none. (At most the largest double.)
    pub fn difference(self) -> Option<f64> {
        match self {
            Matched::Equal => Some(0.0),
            Matched::Unplaced => None,
            Matched::Single { difference }
            | Matched::Printed { difference }
            | Matched::Within { difference }
            | Matched::Rounded { difference }
            | Matched::Near { difference }
            | Matched::Asked { difference } => Some(difference),
        }
    }

    /// The name of the variant, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Matched::Equal => "equal",
            Matched::Single { .. } => "single",
            Matched::Printed { .. } => "printed",
            Matched::Within { .. } => "within",
            Matched::Unplaced => "unplaced",
            Matched::Rounded { .. } => "rounded",
            Matched::Near { .. } => "near",
            Matched::Asked { .. } => "asked",
        }
    }
}
