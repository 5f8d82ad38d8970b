//! Edges that cross, and edges split where they cross.

use num_bigint::BigInt;
use num_rational::BigRational;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use sweep_cdt::Pslg;
use sweep_cdt::crossings::{Crossing, Exact};
use sweep_cdt_formats::{Column, Coordinate, GraphFile};

use crate::calls::call;
use crate::input::{ExactPoints, Graph, Input, with_graph};
use crate::remarks::Remarks;
use crate::triangulation::table;

/// All pairs of edges that cross.
#[pyclass(frozen, module = "sweep_cdt._native")]
#[derive(Debug)]
pub(crate) struct Crossings {
    list: Vec<Found>,
}

/// Two edges that cross, and the double nearest to the place.
#[derive(Debug)]
struct Found {
    edges: [usize; 2],
    near: [f64; 2],
    ends: Ends,
}

/// What the exact place is computed from.
#[derive(Debug)]
pub(crate) enum Ends {
    Doubles(Crossing<f64>),
    Exact(Box<Crossing<BigRational>>),
}

/// Coordinates that come from Python and go back.
pub(crate) trait Kind: Exact + Sync + Send {
    fn ends(crossing: Crossing<Self>) -> Ends;

    fn hand(py: Python<'_>, points: Vec<[Self; 2]>) -> PyResult<Bound<'_, PyAny>>;

    /// Numbers as an array of doubles, or as a list of numerators with denominators.
    fn hand_numbers(py: Python<'_>, numbers: Vec<Self>) -> PyResult<Bound<'_, PyAny>>;
}

impl Kind for f64 {
    fn ends(crossing: Crossing<f64>) -> Ends {
        Ends::Doubles(crossing)
    }

    fn hand(py: Python<'_>, points: Vec<[f64; 2]>) -> PyResult<Bound<'_, PyAny>> {
        Ok(table(py, points)?.into_any())
    }

    fn hand_numbers(py: Python<'_>, numbers: Vec<f64>) -> PyResult<Bound<'_, PyAny>> {
        Ok(numbers.into_pyarray(py).into_any())
    }
}

impl Kind for BigRational {
    fn ends(crossing: Crossing<BigRational>) -> Ends {
        Ends::Exact(Box::new(crossing))
    }

    fn hand(py: Python<'_>, points: Vec<[BigRational; 2]>) -> PyResult<Bound<'_, PyAny>> {
        Ok(Bound::new(py, ExactPoints { points })?.into_any())
    }

    fn hand_numbers(py: Python<'_>, numbers: Vec<BigRational>) -> PyResult<Bound<'_, PyAny>> {
        let numbers: Vec<(BigInt, BigInt)> = numbers.into_iter().map(BigRational::into).collect();
        numbers.into_pyobject(py)
    }
}

/// All crossings of an input.
#[pyfunction]
pub(crate) fn crossings(py: Python<'_>, input: Input<'_>) -> PyResult<Crossings> {
    let graph = input.graph()?;
    with_graph!(&graph, |graph| found(py, graph))
}

fn found<S: Kind>(py: Python<'_>, graph: &Graph<'_, S>) -> PyResult<Crossings> {
    call(py, graph.edges.len(), 1, |_| {
        let list = sweep_cdt::crossings::crossings(graph.points, graph.edges)?;
        let named = |crossing: Crossing<S>| Found {
            edges: crossing.edges,
            near: crossing.point_f64(),
            ends: S::ends(crossing),
        };
        Ok(Crossings {
            list: list.into_iter().map(named).collect(),
        })
    })
}

#[pymethods]
impl Crossings {
    fn __len__(&self) -> usize {
        self.list.len()
    }

    /// The two edges of each crossing.
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<usize>>> {
        table(py, self.list.iter().map(|found| found.edges).collect())
    }

    /// The double nearest to the place of each.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        table(py, self.list.iter().map(|found| found.near).collect())
    }

    /// The exact place of one: numerators and denominators of x and y.
    fn exact(&self, number: usize) -> PyResult<[(BigInt, BigInt); 2]> {
        let found = self.list.get(number);
        let found = found.ok_or_else(|| PyIndexError::new_err("there is no such crossing"))?;
        let point = match &found.ends {
            Ends::Doubles(crossing) => crossing.point(),
            Ends::Exact(crossing) => crossing.point(),
        };
        Ok(point.map(BigRational::into_raw))
    }
}

/// Edges split at their crossings.
type Pieces<'py> = (
    Bound<'py, PyAny>,
    Bound<'py, PyArray2<usize>>,
    Bound<'py, PyArray1<usize>>,
    usize,
    f64,
    Option<Bound<'py, PyArray1<f64>>>,
    Remarks,
);

/// Splits edges where they cross: points, pieces, the edge of each piece, rounds, displacement, heights and remarks.
#[pyfunction]
pub(crate) fn split<'py>(py: Python<'py>, input: Input<'_>) -> PyResult<Pieces<'py>> {
    let heights = input.heights()?;
    let graph = input.graph()?;
    with_graph!(&graph, |graph| pieces(py, graph, heights))
}

fn pieces<'py, S: Kind + Coordinate>(
    py: Python<'py>,
    graph: &Graph<'_, S>,
    heights: Option<&[f64]>,
) -> PyResult<Pieces<'py>> {
    let (mut file, splitting) = call(py, graph.edges.len(), 1, |_| {
        let whole = Pslg {
            points: graph.points.to_vec(),
            edges: graph.edges.to_vec(),
            ..Pslg::default()
        };
        let heights = heights.map(|heights| Column::heights(heights.to_vec()));
        let file = GraphFile {
            columns: heights.into_iter().collect(),
            ..whole.into()
        };
        Ok(file.split_crossings()?)
    })?;
    let heights = file.columns.pop().map(|column| column.values);
    Ok((
        S::hand(py, file.graph.points)?,
        table(py, file.graph.edges)?,
        file.pieces_of.into_pyarray(py),
        splitting.rounds,
        splitting.displacement,
        heights.map(|heights| heights.into_pyarray(py)),
        Remarks(file.remarks),
    ))
}
