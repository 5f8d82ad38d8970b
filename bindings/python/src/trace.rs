//! The steps of the sweep, as data and as pictures.

use std::io;

use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Pslg, Triangulator};
use sweep_cdt_draw::{StepsPage, StepsSheet};
use sweep_cdt_trace::Trace;

use crate::calls::call;
use crate::input::{Input, with_graph};
use crate::measure::heuristics;
use crate::picture::text;

/// All steps of a run.
#[pyclass(frozen, module = "sweep_cdt._native")]
#[derive(Debug)]
pub(crate) struct Steps {
    trace: Trace,
}

/// Triangulates, and keeps every step.
#[pyfunction]
pub(crate) fn trace(py: Python<'_>, input: Input<'_>, rules: &str) -> PyResult<Steps> {
    let rules = heuristics(rules)?;
    let graph = input.graph()?;
    with_graph!(&graph, |graph| {
        let size = graph.points.len() + graph.edges.len();
        call(py, size, 1, |watch| {
            let mut events = Vec::new();
            let mut observer = |event| {
                events.push(event);
                if events.len() % 65536 == 0 {
                    watch.look();
                }
            };
            let triangulator = Triangulator::new().algorithm(Algorithm::Paper);
            let steps = sweep_cdt::Watch::new().events(&mut observer);
            triangulator
                .heuristics(rules)
                .run(graph.points, graph.edges, steps)?;
            let trace = Trace { skipped: 0, events };
            Ok(Steps { trace })
        })
    })
}

#[pymethods]
impl Steps {
    fn __len__(&self) -> usize {
        self.trace.events.len()
    }

    /// A step as JSON.
    fn step(&self, number: usize) -> PyResult<String> {
        let event = serde_json::to_string(self.event(number)?);
        event.map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// A step in words.
    fn words(&self, number: usize) -> PyResult<String> {
        Ok(self.event(number)?.to_string())
    }

    /// All steps as text.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| self.trace.to_string())
    }

    /// A page for a browser; `around` is the step to show first, counted from 1.
    fn page(&self, py: Python<'_>, input: Input<'_>, around: Option<usize>) -> PyResult<String> {
        self.drawn(py, &input, |graph, out| {
            let page = StepsPage::new(graph, &self.trace.events);
            match around {
                Some(step) => page.around(step).write(out),
                None => page.write(out),
            }
        })
    }

    /// Pictures of the steps from `first` to `last`, counted from 1, at most so many.
    fn sheet(
        &self,
        py: Python<'_>,
        input: Input<'_>,
        first: usize,
        last: usize,
        most: usize,
    ) -> PyResult<String> {
        self.drawn(py, &input, |graph, out| {
            let sheet = StepsSheet::new(graph, &self.trace.events);
            sheet.steps(first..=last).most(most).write(out)
        })
    }
}

impl Steps {
    fn event(&self, number: usize) -> PyResult<&Event> {
        let event = self.trace.events.get(number);
        event.ok_or_else(|| PyIndexError::new_err("there is no such step"))
    }

    fn drawn(
        &self,
        py: Python<'_>,
        input: &Input<'_>,
        draw: impl Fn(&Pslg<f64>, &mut Vec<u8>) -> io::Result<()> + Sync,
    ) -> PyResult<String> {
        let graph = input.graph()?;
        let graph = with_graph!(&graph, |graph| graph.for_pictures());
        py.detach(|| text(|out| draw(&graph, out)))
    }
}
