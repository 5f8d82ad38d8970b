//! Numbers of places, of which several are one vertex, by the rules of the crate that reads files.

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use sweep_cdt_formats::Column;

use crate::errors::refused;
use crate::remarks::Remarks;

/// The columns of x, y and perhaps the height by their names; nothing, if none are x and y.
#[pyfunction]
pub(crate) fn named_columns(names: Vec<String>) -> PyResult<Option<Vec<usize>>> {
    sweep_cdt_formats::named_columns(&names).map_err(refused)
}

/// The column with the best of the names of a height.
#[pyfunction]
pub(crate) fn named_height(names: Vec<String>) -> Option<usize> {
    sweep_cdt_formats::named_height(&names)
}

/// The number of each of so many vertices in a column: the first that one of its places has. `vertices` has the vertex of
/// each place.
#[pyfunction]
pub(crate) fn gathered<'py>(
    py: Python<'py>,
    values: PyReadonlyArray1<'_, f64>,
    vertices: PyReadonlyArray1<'_, usize>,
    count: usize,
    column: &str,
) -> PyResult<(Bound<'py, PyArray1<f64>>, Remarks)> {
    let (values, vertices) = (values.as_array(), vertices.as_array());
    if let Some(vertex) = vertices.iter().find(|&&vertex| vertex >= count) {
        return Err(refused(format!("there is no vertex {vertex}")));
    }
    let places = vertices.iter().copied().zip(values.iter().copied());
    let column = Column {
        name: column.to_owned(),
        values: Vec::new(),
    };
    let (column, conflict) = column.gathered(count, places);
    Ok((
        column.values.into_pyarray(py),
        Remarks(conflict.into_iter().collect()),
    ))
}
