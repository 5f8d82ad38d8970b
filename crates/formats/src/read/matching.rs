//! Which vertex of the input each vertex of a result is.
//!
//! A result that lists its vertices tells so by their coordinates, in whatever order they stand: all of
//! them must be vertices of the input, exactly. Where one is not, the file may have rounded coordinates.
//! Then numbers decide, and coordinates only confirm them: each must be the one of the same number,
//! rounded ([`is_rounded`]). The nearest vertex is never taken for the right one.
//!
//! Triangles that are listed by coordinates alone have no numbers. Where these are numbers of single precision, a vertex
//! of the input is taken that is rounded to them, if only one is.
//!
//! Cost: one sort of the input's points, and a binary search for each vertex of the file.

use std::cmp::Ordering;
use std::collections::HashSet;

use num_rational::BigRational;

use crate::read::content::Vertices;
use crate::read::source::{ReadError, ResultError};
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
    /// By coordinates; by number where they are rounded to 6 or more digits, or where there are none.
    #[must_use]
    pub fn new() -> Matching {
        Matching::default()
    }

    /// Whether vertices are matched by number, whatever their coordinates.
    #[must_use]
    pub fn by_number(self, by_number: bool) -> Matching {
        Matching { by_number, ..self }
    }

    /// By how much a coordinate may differ from that of the vertex of the same number, in place of
    /// rounding.
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
        if let (true, Some(places)) = (is_soup && vertices.is_single(), by_singles(points, own)) {
            let pairs = points.iter().zip(&places).map(|(p, &v)| apart(p, &own[v]));
            let difference = pairs.fold(0.0, f64::max);
            return Ok((Matched::Single { difference }, Some(places)));
        }
        if is_soup || points.len() != own.len() {
            let stranger = found.iter().position(Option::is_none);
            let at = stranger.expect("not all were found");
            let (file, line, vertex) = vertices.name(at);
            let at = points[at].each_ref().map(S::approx);
            return Err(ResultError::Stranger {
                file,
                line,
                vertex,
                at,
            });
        }
        let is_close = |at: &usize| match self.tolerance {
            Some(tolerance) => apart(&points[*at], &own[*at]) <= tolerance,
            None => (0..2).all(|axis| {
                let (read, exact) = (&points[*at][axis], &own[*at][axis]);
                let is_near = !S::APPROX_IS_EXACT;
                let text = vertices.text(*at, axis);
                let rounded = || single(exact.approx()).compare(&read.approx());
                let is_single = vertices.is_single() && rounded().is_eq();
                read == exact
                    || is_single
                    || is_rounded(exact.approx(), is_near, &text, read.approx())
            }),
        };
        let far: Vec<usize> = (0..points.len()).filter(|at| !is_close(at)).collect();
        if far.is_empty() {
            let difference = greatest();
            let matched = match self.tolerance {
                None => Matched::Rounded { difference },
                Some(_) => Matched::Near { difference },
            };
            return Ok((matched, None));
        }
        // A vertex that is nowhere in the input says more than one that is elsewhere.
        let stranger = far.iter().copied().find(|&at| found[at].is_none());
        let at = stranger.unwrap_or(far[0]);
        let (file, line, vertex) = vertices.name(at);
        Err(ResultError::Elsewhere {
            file,
            line,
            vertex,
            at: points[at].each_ref().map(S::approx),
            of_input: at + input.numbering.vertex,
            expected: own[at].each_ref().map(S::approx),
            tolerance: self.tolerance,
        })
    }
}

/// The vertices of a file that are none of `own`, the input's.
pub(super) fn added<S: Coordinate>(
    vertices: &Vertices<'_>,
    points: Vec<[S; 2]>,
    own: &[[S; 2]],
) -> Result<Vec<[S; 2]>, ResultError> {
    refuse_non_finite(vertices, &points)?;
    let found = find(&points, own);
    let pairs = points.into_iter().zip(found);
    Ok(pairs
        .filter(|(_, found)| found.is_none())
        .map(|(point, _)| point)
        .collect())
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

/// For each of `points` the first of the input's `own` whose coordinates they are in single precision, if each has one,
/// and no other vertex of the input has the same.
fn by_singles<S: Coordinate>(points: &[[S; 2]], own: &[[S; 2]]) -> Option<Vec<usize>> {
    if !own.iter().all(is_finite) {
        return None;
    }
    let singles = own
        .iter()
        .map(|point| point.each_ref().map(|x| single(x.approx())));
    let singles: Vec<[f64; 2]> = singles.collect();
    let near: Vec<[f64; 2]> = points
        .iter()
        .map(|point| point.each_ref().map(S::approx))
        .collect();
    let places: Vec<usize> = find(&near, &singles).into_iter().collect::<Option<_>>()?;
    let (same, equal) = (find(&singles, &singles), find(own, own));
    let pairs = same.iter().zip(&equal);
    let ambiguous: HashSet<usize> = pairs
        .filter_map(|(&same, &equal)| same.filter(|&first| equal != Some(first)))
        .collect();
    places
        .iter()
        .all(|place| !ambiguous.contains(place))
        .then_some(places)
}

/// The nearest number of single precision.
#[expect(
    clippy::cast_possible_truncation,
    reason = "this is how programs round"
)]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// For each of `points` the lowest position in `among` of an equal point. All of `points` are finite.
pub(super) fn find<S: Scalar>(points: &[[S; 2]], among: &[[S; 2]]) -> Vec<Option<usize>> {
    let mut sorted: Vec<usize> = (0..among.len()).filter(|&v| is_finite(&among[v])).collect();
    sorted.sort_by(|&v, &w| order(&among[v], &among[w]));
    let place = |point: &[S; 2]| {
        let at = sorted.partition_point(|&v| order(&among[v], point).is_lt());
        sorted
            .get(at)
            .copied()
            .filter(|&v| order(&among[v], point).is_eq())
    };
    points.iter().map(place).collect()
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
            Matched::Equal | Matched::Single { .. } => "coordinates",
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
            Matched::Unplaced => "unplaced",
            Matched::Rounded { .. } => "rounded",
            Matched::Near { .. } => "near",
            Matched::Asked { .. } => "asked",
        }
    }
}

/// The fewest significant digits that a program is taken to have printed.
const FEWEST: usize = 6;
/// A double is known from so many digits.
const MOST: usize = 17;

/// Whether a value is what printing `exact` gives, as this text has it.
///
/// Half a unit may be rounded to either side. `exact` is known to one unit in its last place only, if
/// `is_near` says so.
///
/// A program that prints a coordinate with k significant digits moves it by at most half a unit of its
/// k-th digit. How many digits were printed is seen in the file: as many as stand there, without leading
/// zeros, but 6 at least, since many programs (`%g`, C++ streams) drop zeros at the end of their 6. So a
/// number that is written with more digits than 6 must agree in all of them.
fn is_rounded(exact: f64, is_near: bool, text: &str, value: f64) -> bool {
    let Some(digits) = digits(text) else {
        return false;
    };
    let digits = digits.clamp(FEWEST, MOST);
    // Digits that a double has for certain leave room for both ways to round a half. (Next to zero is a
    // number of other digits.)
    let either_way = exact.is_normal() && (is_near || digits <= f64::DIGITS as usize);
    let printed = |exact: f64| format!("{exact:.*e}", digits - 1).parse() == Ok(value);
    printed(exact) || either_way && (printed(exact.next_up()) || printed(exact.next_down()))
}

/// How many significant digits are written; `None` for a fraction, which is not rounded.
fn digits(text: &str) -> Option<usize> {
    let mantissa = text.split(['e', 'E']).next()?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit);
    (!text.contains('/')).then(|| digits.skip_while(|&digit| digit == b'0').count())
}
