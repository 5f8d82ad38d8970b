//! Bands of a larger input, and rests of bands that are joined: for `sweep_cdt.distributed`, whose tasks hold them as the
//! bytes of a `.rest` file.

use numpy::{PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use sweep_cdt::Triangulator;
use sweep_cdt_stream::{Cut, Final, Rest, RestError};

use crate::calls::call;
use crate::errors::{Fault, refused};
use crate::triangulation::table;

/// The band of an input that has so many `vertices`, `between` a least and a greatest x, that begins with vertex `first`
/// of the order. `numbers` and `points` are its vertices; `edges` and `ends` (both places in a row) are the edges that
/// begin or end in it, or pass it.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "a table a column")]
pub(crate) fn band<'py>(
    py: Python<'py>,
    vertices: u64,
    between: [f64; 2],
    first: u64,
    numbers: PyReadonlyArray1<'py, u64>,
    points: PyReadonlyArray2<'py, f64>,
    edges: PyReadonlyArray1<'py, u64>,
    ends: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyBytes>> {
    let numbered = numbers.as_slice()?.iter().copied();
    let numbered = numbered.zip(points.as_slice()?.as_chunks().0.iter().copied());
    let edges = edges.as_slice()?.iter().copied();
    let edges = edges.zip(ends.as_slice()?.as_chunks::<4>().0);
    let edges = edges.map(|(edge, &[ax, ay, bx, by])| (edge, [[ax, ay], [bx, by]]));
    let cut = Cut { vertices, between };
    let band = cut.band(first, numbered, edges, |_| ());
    let band = band.map_err(|error| Fault::Stream(error).raise(py))?;
    Ok(PyBytes::new(py, &band.to_bytes()))
}

/// The triangles that are final now, of how many points the input is, and what is left.
type Joined<'py> = (Bound<'py, PyArray2<u64>>, u64, Option<Bound<'py, PyBytes>>);

/// Joins bands, and rests of bands, that follow each other. Nothing is left once all bands are in.
#[pyfunction]
pub(crate) fn join(py: Python<'_>, rests: Vec<Vec<u8>>) -> PyResult<Joined<'_>> {
    let read = rests.iter().map(|bytes| Rest::from_bytes(bytes));
    let read: Result<Vec<Rest<f64>>, RestError> = read.collect();
    let mut read = read
        .map_err(|error| refused(error.to_string()))?
        .into_iter();
    let Some(first) = read.next() else {
        return Err(refused("there are no rests to join".to_owned()));
    };
    let total = first.total();
    let size = rests.iter().map(Vec::len).sum();
    let (triangles, left) = call(py, size, 1, |_| {
        let mut joined = read.try_fold(first, Rest::followed_by)?;
        let mut triangles = Vec::new();
        joined = joined.settle(&mut Triangulator::new().session(), |found| {
            if let Final::Triangle { corners, .. } = found {
                triangles.push(corners);
            }
        })?;
        let left = (!joined.is_complete()).then(|| joined.to_bytes());
        Ok((triangles, left))
    })?;
    let left = left.map(|bytes| PyBytes::new(py, &bytes));
    Ok((table(py, triangles)?, total, left))
}
