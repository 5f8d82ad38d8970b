//! Which vertex of a result is which point of the input, by the rules of the crate that reads files.

use num_rational::BigRational;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sweep_cdt_formats::{Coordinate, Listed, Matching, Precision, ResultError, WayOut};

use crate::errors::{exception, refused};
use crate::input::{ExactPoints, Points, View};
use crate::triangulation::table;

/// How vertices are matched.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asked {
    is_soup: bool,
    tolerance: Option<f64>,
    by_number: bool,
    /// Whether there may be vertices that the input lacks.
    steiner: bool,
}

/// Matches the vertices of a result with the points of the input. Returns the words of a report, the place of each vertex,
/// unless it is its number, and the points of the input with those that were added behind them, if these are looked for.
#[pyfunction]
pub(crate) fn match_vertices<'py>(
    py: Python<'py>,
    result: Points<'_>,
    own: Points<'_>,
    asked: Asked,
) -> PyResult<Bound<'py, PyDict>> {
    let (words, places, all) = match (result.view()?, own.view()?) {
        (View::Doubles(points), View::Doubles(own)) => {
            let found = by(&asked, points, Precision::Digits, own);
            let (words, places, all) = found.map_err(|error| refusal(py, &error))?;
            (words, places, table(py, all)?.into_any())
        }
        (result, own) => {
            let (points, precision) = match result {
                View::Doubles(points) => (exactly(points)?, Precision::Digits),
                View::Exact(points) => (points.to_vec(), Precision::Exact),
            };
            let own = match own {
                View::Doubles(own) => exactly(own)?,
                View::Exact(own) => own.to_vec(),
            };
            let found = by(&asked, &points, precision, &own);
            let (words, places, points) = found.map_err(|error| refusal(py, &error))?;
            let all = Bound::new(py, ExactPoints { points })?.into_any();
            (words, places, all)
        }
    };
    let matched = PyDict::new(py);
    matched.set_item("words", words)?;
    matched.set_item("places", places.map(|places| places.into_pyarray(py)))?;
    matched.set_item("points", asked.steiner.then_some(all))?;
    Ok(matched)
}

type Found<S> = (String, Option<Vec<usize>>, Vec<[S; 2]>);

fn by<S: Coordinate>(
    asked: &Asked,
    points: &[[S; 2]],
    precision: Precision,
    own: &[[S; 2]],
) -> Result<Found<S>, ResultError> {
    let listed = Listed {
        points,
        precision,
        is_soup: asked.is_soup,
    };
    let mut all = Vec::new();
    if asked.steiner {
        all = [own, &listed.added(own)?].concat();
    }
    let own = if asked.steiner { &all } else { own };
    let matching = Matching::new().by_number(asked.by_number);
    let matching = match asked.tolerance {
        Some(tolerance) => matching.tolerance(tolerance),
        None => matching,
    };
    let (matched, places) = listed.places(matching, own)?;
    Ok((matched.words(), places, all))
}

/// Doubles as fractions.
fn exactly(points: &[[f64; 2]]) -> PyResult<Vec<[BigRational; 2]>> {
    let points = points.iter().enumerate().map(|(v, [x, y])| {
        let pair = BigRational::from_float(*x).zip(BigRational::from_float(*y));
        let message = || refused(format!("point {v} has a coordinate that is not finite"));
        pair.map(|(x, y)| [x, y]).ok_or_else(message)
    });
    points.collect()
}

/// The exception for vertices that cannot be matched.
fn refusal(py: Python<'_>, error: &ResultError) -> PyErr {
    let (vertex, at, nearest, candidates) = match error {
        ResultError::Stranger {
            vertex,
            at,
            nearest,
            ..
        } => {
            let nearest = nearest.as_ref().map(|nearest| nearest.of_input);
            (Some(*vertex), Some(*at), nearest, None)
        }
        ResultError::Ambiguous {
            vertex,
            at,
            of_input,
            ..
        } => (Some(*vertex), Some(*at), None, Some(*of_input)),
        ResultError::Shared {
            vertices, of_input, ..
        } => (Some(vertices[1]), None, Some(*of_input), None),
        ResultError::NonFinite { vertex, .. } => (Some(*vertex), None, None, None),
        _ => (None, None, None, None),
    };
    let attributes = PyDict::new(py);
    let set = || {
        attributes.set_item("vertex", vertex)?;
        attributes.set_item("at", at.map(|[x, y]| (x, y)))?;
        attributes.set_item("nearest", nearest)?;
        attributes.set_item("candidates", candidates.map(|[v, w]| (v, w)))
    };
    if let Err(error) = set() {
        return error;
    }
    let message = error.with_ways_out(|way| match way {
        WayOut::Tolerance(tolerance) => format!("tolerance={} accepts it", tolerance.text()),
        WayOut::Steiner => "steiner=True allows for vertices that were added".to_owned(),
        WayOut::ByNumber => "by_number=True ignores coordinates".to_owned(),
        _ => "pass the points of the result with all digits, or its triangles alone".to_owned(),
    });
    exception(py, "MatchError", message, &attributes)
}
