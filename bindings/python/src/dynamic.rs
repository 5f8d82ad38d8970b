//! The triangulation that changes. A lock of its own lets one thread at a time change or read it.

use std::sync::{Mutex, MutexGuard, PoisonError};

use num_rational::BigRational;
use numpy::ndarray::ArrayView2;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use sweep_cdt::crossings::Exact;
use sweep_cdt_edit::{DynamicTriangulation, EditError, Edits};

use crate::calls::{Watch, call};
use crate::crossings::Kind;
use crate::errors::{Fault, refused};
use crate::input::{Points, View, rows};
use crate::triangulation::table;

/// A triangulation that changes.
#[pyclass(frozen, module = "sweep_cdt._native")]
#[derive(Debug)]
pub(crate) struct Dynamic {
    state: Mutex<State>,
}

/// Of which coordinates it is.
#[derive(Debug)]
enum State {
    Doubles(DynamicTriangulation<f64>),
    Exact(DynamicTriangulation<BigRational>),
}

/// Does the same with a triangulation of either arithmetic.
macro_rules! with_state {
    ($state:expr, |$name:ident| $body:expr) => {
        match $state {
            State::Doubles($name) => $body,
            State::Exact($name) => $body,
        }
    };
}

/// The first numbers of new points and edges and the ones after their last, and the triangles that are gone and new.
type Changed<'py> = (
    [usize; 2],
    [usize; 2],
    Bound<'py, PyArray2<usize>>,
    Bound<'py, PyArray2<usize>>,
);

/// The numbers of edges, and their ends.
type Numbered<'py> = (Bound<'py, PyArray1<usize>>, Bound<'py, PyArray2<usize>>);

/// The numbers of points, and their weights.
type Weighted<'py> = (Bound<'py, PyArray1<usize>>, Bound<'py, PyAny>);

fn differ() -> PyErr {
    refused(
        "the points are doubles, and these are not: begin with an exact triangulation".to_owned(),
    )
}

/// Edits with points.
fn with_points<S: Clone>(points: &[[S; 2]], rest: Edits<()>) -> Edits<S> {
    Edits {
        points: points.to_vec(),
        edges: rest.edges,
        remove_points: rest.remove_points,
        remove_edges: rest.remove_edges,
    }
}

#[pymethods]
impl Dynamic {
    #[new]
    fn new(is_exact: bool) -> Dynamic {
        let state = match is_exact {
            true => State::Exact(DynamicTriangulation::new()),
            false => State::Doubles(DynamicTriangulation::new()),
        };
        Dynamic {
            state: Mutex::new(state),
        }
    }

    /// Makes all edits at once, or none. `sides` are edges between the new points, by their positions: they go first.
    fn edit<'py>(
        &self,
        py: Python<'py>,
        points: Points<'_>,
        sides: PyReadonlyArray2<'_, usize>,
        edges: PyReadonlyArray2<'_, usize>,
        remove_points: Vec<usize>,
        remove_edges: Vec<usize>,
    ) -> PyResult<Changed<'py>> {
        let mut state = self.lock(py);
        let [next, _] = with_state!(&*state, |state| state.next_numbers());
        let sides = rows(&sides)?.iter().map(|side| side.map(|v| v + next));
        let edges: Vec<[usize; 2]> = sides.chain(rows(&edges)?.iter().copied()).collect();
        let view = points.view()?;
        let size = view.len() + edges.len() + remove_points.len() + remove_edges.len();
        let rest = Edits {
            points: Vec::new(),
            edges,
            remove_points,
            remove_edges,
        };
        let change = match (&mut *state, view) {
            (State::Doubles(state), View::Doubles(points)) => {
                call(py, size, 1, |_| Ok(state.apply(with_points(points, rest))?))
            }
            (State::Exact(state), View::Exact(points)) => {
                call(py, size, 1, |_| Ok(state.apply(with_points(points, rest))?))
            }
            _ => Err(differ()),
        }?;
        Ok((
            [change.points.start, change.points.end],
            [change.edges.start, change.edges.end],
            table(py, change.gone)?,
            table(py, change.new)?,
        ))
    }

    /// The numbers of the next point and of the next edge.
    fn next_numbers(&self, py: Python<'_>) -> [usize; 2] {
        with_state!(&*self.lock(py), |state| state.next_numbers())
    }

    /// All triangles in canonical order.
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<usize>>> {
        let list = with_state!(&*self.lock(py), |state| state.canonical_triangles());
        table(py, list)
    }

    /// The numbers of the points that are there.
    fn numbers<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<usize>> {
        let numbers: Vec<usize> = with_state!(&*self.lock(py), |state| state.points().collect());
        numbers.into_pyarray(py)
    }

    /// The places of points.
    fn places<'py>(
        &self,
        py: Python<'py>,
        numbers: PyReadonlyArray1<'_, usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        with_state!(&*self.lock(py), |state| {
            let places = numbers.as_array();
            let places = places.iter().map(|&number| {
                let place = state.point(number);
                let missing = EditError::NoPoint { point: number };
                place.cloned().ok_or_else(|| Fault::from(missing).raise(py))
            });
            Kind::hand(py, places.collect::<PyResult<Vec<_>>>()?)
        })
    }

    /// The numbers of the edges that are there, and their ends.
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Numbered<'py>> {
        let (numbers, ends): (Vec<usize>, Vec<[usize; 2]>) =
            with_state!(&*self.lock(py), |state| state.edges().unzip());
        Ok((numbers.into_pyarray(py), table(py, ends)?))
    }

    /// The regions that the last edit swept: the numbers of the vertices of each, and its edges between these.
    fn last_sweeps<'py>(&self, py: Python<'py>) -> PyResult<Vec<Numbered<'py>>> {
        let swept = |state: &State| -> Vec<(Vec<usize>, Vec<[usize; 2]>)> {
            with_state!(state, |state| {
                let sweeps = state.last_sweeps().into_iter();
                sweeps.map(|(graph, v)| (v, graph.edges)).collect()
            })
        };
        let sweeps = swept(&self.lock(py)).into_iter();
        sweeps
            .map(|(numbers, edges)| Ok((numbers.into_pyarray(py), table(py, edges)?)))
            .collect()
    }

    /// The vertices along an edge.
    fn chain(&self, py: Python<'_>, edge: usize) -> PyResult<Vec<usize>> {
        let chain = with_state!(&*self.lock(py), |state| state.edge_chain(edge));
        chain.ok_or_else(|| Fault::from(EditError::NoEdge { edge }).raise(py))
    }

    /// The number of the point nearest to each place, -1 if there is none.
    fn nearest<'py>(
        &self,
        py: Python<'py>,
        places: Points<'_>,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let view = places.view()?;
        let number = |found: Option<usize>| found.map_or(-1, |v| v as i64);
        let found: Vec<i64> = match (&*self.lock(py), view) {
            (State::Doubles(state), View::Doubles(places)) => {
                py.detach(|| places.iter().map(|p| number(state.nearest(p))).collect())
            }
            (State::Exact(state), View::Exact(places)) => {
                py.detach(|| places.iter().map(|p| number(state.nearest(p))).collect())
            }
            _ => return Err(differ()),
        };
        Ok(found.into_pyarray(py))
    }

    /// The natural neighbours of one place, and their weights: exact ones, or the doubles nearest to them.
    fn natural_neighbors<'py>(
        &self,
        py: Python<'py>,
        places: Points<'_>,
    ) -> PyResult<Weighted<'py>> {
        fn weighted<'py, S: Kind>(
            py: Python<'py>,
            state: &DynamicTriangulation<S>,
            place: &[S; 2],
        ) -> PyResult<Weighted<'py>> {
            let found = state.natural_neighbors(place);
            let found = found.map_err(|error| Fault::from(error).raise(py))?;
            let (numbers, weights): (Vec<usize>, Vec<S>) = found.into_iter().unzip();
            Ok((numbers.into_pyarray(py), S::hand_numbers(py, weights)?))
        }
        match (&*self.lock(py), places.view()?) {
            (State::Doubles(state), View::Doubles([place])) => weighted(py, state, place),
            (State::Exact(state), View::Exact([place])) => weighted(py, state, place),
            _ => Err(differ()),
        }
    }

    /// For each place and each column of values, which are by the numbers of points, the sum over natural neighbours;
    /// NaN where there are none.
    fn interpolate<'py>(
        &self,
        py: Python<'py>,
        values: PyReadonlyArray2<'_, f64>,
        places: Points<'_>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        fn sums<S: Exact>(
            state: &DynamicTriangulation<S>,
            values: ArrayView2<'_, f64>,
            places: &[[S; 2]],
            watch: &Watch,
        ) -> Result<Vec<f64>, Fault> {
            let mut found = Vec::with_capacity(places.len() * values.ncols());
            for place in places {
                watch.look();
                let weights = state.natural_neighbors(place)?;
                found.extend(values.columns().into_iter().map(|column| {
                    let weighted = weights
                        .iter()
                        .map(|(v, weight)| weight.approx() * column[*v]);
                    weighted.reduce(|sum, part| sum + part).unwrap_or(f64::NAN)
                }));
            }
            Ok(found)
        }
        let view = places.view()?;
        let values = values.as_array();
        let found = match (&*self.lock(py), view) {
            (State::Doubles(state), View::Doubles(places)) => call(py, usize::MAX, 1, |watch| {
                sums(state, values, places, watch)
            }),
            (State::Exact(state), View::Exact(places)) => call(py, usize::MAX, 1, |watch| {
                sums(state, values, places, watch)
            }),
            _ => Err(differ()),
        }?;
        Ok(found.into_pyarray(py))
    }
}

impl Dynamic {
    /// Waits without the interpreter's lock, which the thread that holds this one may need.
    fn lock(&self, py: Python<'_>) -> MutexGuard<'_, State> {
        use pyo3::sync::MutexExt;
        self.state
            .lock_py_attached(py)
            .unwrap_or_else(PoisonError::into_inner)
    }
}
