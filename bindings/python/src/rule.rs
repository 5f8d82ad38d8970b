//! Which triangles are inside: the rules by name.

use pyo3::prelude::*;
use sweep_cdt_engine::{Inside, UnknownName};

use crate::errors::refused;

/// An error for a name that is not known.
pub(crate) fn unknown(error: UnknownName) -> PyErr {
    refused(error.to_string())
}

/// The rule of a name.
pub(crate) fn named(name: &str) -> PyResult<Inside> {
    name.parse().map_err(unknown)
}

/// The name of the rule for an input: of the one that is asked for, or of the default.
#[pyfunction]
#[pyo3(signature = (name, has_holes, has_polygons))]
pub(crate) fn inside(name: Option<&str>, has_holes: bool, has_polygons: bool) -> PyResult<String> {
    let rule = match name {
        Some(name) => named(name)?,
        None => Inside::default_of(has_holes, has_polygons),
    };
    if rule == Inside::Polygons && !has_polygons {
        return Err(refused(
            "there are no polygons: the rule even-odd takes edges that are closed rings".to_owned(),
        ));
    }
    Ok(rule.to_string())
}
