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

pub(super) mod listed;
pub(super) mod matched;
mod nearby;
pub(super) mod refusal;
mod rounded;
mod rounding;
pub(super) mod written;

use crate::Coordinate;
use crate::order::{is_finite, order, sorted};
use crate::read::matching::matched::Matched;
use crate::read::matching::nearby::{Nearby, apart};
use crate::read::matching::refusal::ResultError;
use crate::read::matching::rounded::Rounded;
use crate::read::matching::rounding::Rule;
use crate::read::matching::written::Written;
use crate::read::source::ReadError;
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

    /// How vertices match those of the input, `own`, and for each of them the place in the input, unless it is that of the
    /// same number. The input numbers its vertices from `first`.
    pub(super) fn places<S: Coordinate>(
        self,
        written: &impl Written,
        is_soup: bool,
        points: &[[S; 2]],
        own: &[[S; 2]],
        first: usize,
    ) -> Result<(Matched, Option<Vec<usize>>), ResultError> {
        refuse_non_finite(written, points)?;
        if self.by_number && is_soup {
            let message = "the triangles are coordinates, and their vertices have no numbers";
            return Err(ReadError::of_file(written.file(), message).into());
        }
        let by_number = || greatest(points.iter().zip(own));
        if self.by_number {
            let difference = by_number();
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
        let rounded = Rounded::new(self.tolerance, written, points, own, &found);
        let has_numbers = !is_soup && points.len() == own.len();
        if has_numbers && (0..points.len()).all(|at| rounded.is_close(at, at)) {
            let difference = by_number();
            let matched = match self.tolerance {
                None => Matched::Rounded { difference },
                Some(_) => Matched::Near { difference },
            };
            return Ok((matched, None));
        }
        let nearby = Nearby::new(own, distinct(own));
        let Some((places, rule)) = rounded.places(&nearby) else {
            return Err(rounded.refusal(&nearby, is_soup, first));
        };
        let difference = greatest(points.iter().zip(places.iter().map(|&v| &own[v])));
        let matched = match (self.tolerance, rule) {
            (Some(_), _) => Matched::Within { difference },
            (None, Rule::Singles) => Matched::Single { difference },
            (None, _) => Matched::Printed { difference },
        };
        Ok((matched, Some(places)))
    }
}

/// The greatest difference of two coordinates.
fn greatest<'a, S: Coordinate + 'a>(pairs: impl Iterator<Item = (&'a [S; 2], &'a [S; 2])>) -> f64 {
    pairs.map(|(p, q)| apart(p, q)).fold(0.0, f64::max)
}

/// The positions of finite points, of equal ones the lowest.
fn distinct<S: Scalar>(points: &[[S; 2]]) -> Vec<usize> {
    let mut sorted = sorted(points);
    sorted
        .dedup_by(|(near, v), (other, w)| order((near, &points[*v]), (other, &points[*w])).is_eq());
    sorted.into_iter().map(|(_, v)| v).collect()
}

/// The vertices of a file that are none of `own`, the input's. One is the input's too if it is that of the only vertex
/// that the file lacks otherwise, and that is rounded to it.
pub(super) fn added<S: Coordinate>(
    written: &impl Written,
    points: &[[S; 2]],
    own: &[[S; 2]],
) -> Result<Vec<[S; 2]>, ResultError> {
    refuse_non_finite(written, points)?;
    let found = find(points, own);
    let mut is_there = vec![false; own.len()];
    found.iter().flatten().for_each(|&v| is_there[v] = true);
    let mut missing = distinct(own);
    missing.retain(|&v| !is_there[v]);
    let nearby = Nearby::new(own, missing);
    let rounded = Rounded::new(None, written, points, own, &found);
    let is_rounded = |at: usize| {
        let mut rules = rounded.rules.iter();
        rules.any(|&rule| matches!(rounded.candidates(&nearby, rule, at), [Some(_), None]))
    };
    let is_added = |&at: &usize| found[at].is_none() && !is_rounded(at);
    let added = (0..points.len()).filter(is_added);
    Ok(added.map(|at| points[at].clone()).collect())
}

fn refuse_non_finite<S: Scalar>(
    written: &impl Written,
    points: &[[S; 2]],
) -> Result<(), ResultError> {
    let Some(at) = points.iter().position(|point| !is_finite(point)) else {
        return Ok(());
    };
    let (file, line, vertex) = written.name(at);
    Err(ResultError::NonFinite { file, line, vertex })
}

/// For each of `points` the lowest position in `among` of an equal point. All of `points` are finite.
pub(super) fn find<S: Scalar>(points: &[[S; 2]], among: &[[S; 2]]) -> Vec<Option<usize>> {
    let among_sorted = sorted(among);
    let mut found = vec![None; points.len()];
    let mut first = 0;
    for (near, at) in sorted(points) {
        let compared =
            |(other, v): &([f64; 2], usize)| order((other, &among[*v]), (&near, &points[at]));
        while among_sorted
            .get(first)
            .is_some_and(|other| compared(other).is_lt())
        {
            first += 1;
        }
        let candidate = among_sorted
            .get(first)
            .filter(|&other| compared(other).is_eq());
        found[at] = candidate.map(|&(_, v)| v);
    }
    found
}
