//! What is to say about an input or a result, as objects of `sweep_cdt._remarks`: the sentence of the engine, and its numbers.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use sweep_cdt_formats::Remark;

/// The remark on so many things that are ignored, if there are any, with the name of one and of many.
#[pyfunction]
pub(crate) fn ignored(count: usize, one: &str, many: &str) -> Remarks {
    let remark = (count > 0).then(|| Remark::ignored(count, one, many));
    Remarks(remark.into_iter().collect())
}

/// Remarks as Python has them.
#[derive(Debug, Default)]
pub(crate) struct Remarks(pub(crate) Vec<Remark>);

impl<'py> IntoPyObject<'py> for Remarks {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let class = py.import("sweep_cdt._remarks")?.getattr("Remark")?;
        let made = self.0.into_iter().map(|remark| {
            let numbers = PyDict::new(py);
            let kind = match &remark {
                Remark::Ignored { count, .. } => {
                    numbers.set_item("count", count)?;
                    "ignored"
                }
                Remark::Conflict {
                    column,
                    vertex,
                    values: [kept, other],
                    count,
                } => {
                    numbers.set_item("column", column)?;
                    numbers.set_item("vertex", vertex)?;
                    numbers.set_item("values", (kept, other))?;
                    numbers.set_item("count", count)?;
                    "conflict"
                }
                _ => "chosen",
            };
            class.call1((kind, remark.to_string(), remark.is_loss(), numbers))
        });
        let made = made.collect::<PyResult<Vec<_>>>()?;
        made.into_pyobject(py)
    }
}
