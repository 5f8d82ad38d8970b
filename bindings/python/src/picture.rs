//! Pictures of a triangulation, as SVG and PNG.

use std::io;

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use sweep_cdt_draw::ResultPicture;
use sweep_cdt_engine::Inside;

use crate::input::{Input, with_graph};
use crate::rule::named;
use crate::triangulation::Core;

/// What is written, as text.
pub(crate) fn text(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> PyResult<String> {
    let mut out = Vec::new();
    write(&mut out)?;
    String::from_utf8(out).map_err(|error| PyOSError::new_err(error.to_string()))
}

/// A picture of a triangulation of an input, as bytes: of what is inside by a rule, with its border.
#[pyfunction]
pub(crate) fn picture(
    py: Python<'_>,
    core: &Bound<'_, Core>,
    input: Input<'_>,
    rule: &str,
    png: bool,
) -> PyResult<Vec<u8>> {
    let rule = named(rule)?;
    let graph = input.graph()?;
    let result = &core.get().result;
    with_graph!(&graph, |graph| {
        let drawn = py.detach(|| {
            let pslg = graph.for_pictures();
            let asked = graph.asked();
            let interior = rule.interior(&asked, result);
            let picture = ResultPicture::new(&pslg, result);
            let picture = match &interior {
                Ok(interior) if rule != Inside::HULL => picture.interior(interior),
                _ => picture,
            };
            let mut out = Vec::new();
            match png {
                true => picture.write_png(&mut out)?,
                false => picture.write(&mut out)?,
            }
            io::Result::Ok(out)
        });
        Ok(drawn?)
    })
}
