//! What Python passes: arrays of doubles as they lie in memory, or exact numbers; and edges, rings and seeds.
//!
//! Why no copy is made: Python passes arrays that are contiguous and of the right type, which are borrowed for the call.
//! NumPy's rule for all its functions holds here too: no other thread may write to an array during the call.

use std::iter;

use num_bigint::BigInt;
use num_rational::BigRational;
use numpy::{Element, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyZeroDivisionError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};
use sweep_cdt::interior::Ring;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Region};
use sweep_cdt_formats::{Coordinate, CoordinateError, MAX_DIGITS, MAX_EXPONENT, quotient};

use crate::errors::{exception, refused};

/// Points whose coordinates are fractions.
#[pyclass(frozen, module = "sweep_cdt._native")]
#[derive(Debug)]
pub(crate) struct ExactPoints {
    pub(crate) points: Vec<[BigRational; 2]>,
}

/// A number that is taken exactly: a numerator and a denominator, or the text of a decimal, whose exponent may be one
/// that no memory holds.
#[derive(FromPyObject)]
enum Number {
    Ratio(BigInt, BigInt),
    Decimal(String),
}

#[pymethods]
impl ExactPoints {
    /// Takes numerators and denominators of all coordinates, as `parts` returns them.
    #[new]
    fn new(numerators: Vec<BigInt>, denominators: Vec<BigInt>) -> PyResult<ExactPoints> {
        if denominators
            .iter()
            .any(|n| n.sign() == num_bigint::Sign::NoSign)
        {
            return Err(PyZeroDivisionError::new_err("a denominator is zero"));
        }
        let fractions = numerators.into_iter().zip(denominators);
        let all: Vec<BigRational> = fractions.map(|(n, d)| BigRational::new(n, d)).collect();
        let pairs = all.as_chunks::<2>().0;
        Ok(ExactPoints {
            points: pairs.to_vec(),
        })
    }

    /// Takes x and y of each point in turn, within the limits of files. Messages begin with `name`.
    #[staticmethod]
    fn of_numbers(py: Python<'_>, numbers: Vec<Number>, name: &str) -> PyResult<ExactPoints> {
        let mut all = Vec::with_capacity(numbers.len());
        for number in numbers {
            let value = match number {
                Number::Ratio(numerator, denominator) => quotient(numerator, denominator),
                Number::Decimal(text) => BigRational::from_text(&text),
            };
            match value {
                Ok(value) => all.push(value),
                Err(error) => return Err(beyond_limit(py, error, name, all.len())),
            }
        }
        Ok(ExactPoints {
            points: all.as_chunks::<2>().0.to_vec(),
        })
    }

    fn __len__(&self) -> usize {
        self.points.len()
    }

    /// For pickles and copies.
    fn __reduce__<'py>(
        slf: &Bound<'py, ExactPoints>,
    ) -> (Bound<'py, PyType>, (Vec<BigInt>, Vec<BigInt>)) {
        (slf.get_type(), slf.get().parts())
    }

    /// The numerators and the denominators.
    fn parts(&self) -> (Vec<BigInt>, Vec<BigInt>) {
        let all = self.points.as_flattened().iter();
        all.map(|x| (x.numer().clone(), x.denom().clone())).unzip()
    }
}

/// The exception for the number at this place, of x and y of each point in turn.
fn beyond_limit(py: Python<'_>, error: CoordinateError, name: &str, at: usize) -> PyErr {
    let attributes = PyDict::new(py);
    let (vertex, axis) = (at / 2, at % 2);
    let limit = match error {
        CoordinateError::TooLong => Some(MAX_DIGITS),
        CoordinateError::ExponentTooLarge => Some(MAX_EXPONENT as usize),
        _ => None,
    };
    let set = || {
        attributes.set_item("vertex", vertex)?;
        attributes.set_item("axis", axis)?;
        attributes.set_item("limit", limit)
    };
    if let Err(error) = set() {
        return error;
    }
    let class = match limit {
        Some(_) => "TooLargeError",
        None => "Error",
    };
    let message = format!("{name}[{vertex}, {axis}] {error}");
    exception(py, class, message, &attributes)
}

/// Points as Python passes them.
#[derive(FromPyObject)]
pub(crate) enum Points<'py> {
    Doubles(PyReadonlyArray2<'py, f64>),
    Exact(Bound<'py, ExactPoints>),
}

/// Borrowed points.
#[derive(Clone, Copy, Debug)]
pub(crate) enum View<'a> {
    Doubles(&'a [[f64; 2]]),
    Exact(&'a [[BigRational; 2]]),
}

impl View<'_> {
    /// How many there are.
    pub(crate) fn len(self) -> usize {
        match self {
            View::Doubles(points) => points.len(),
            View::Exact(points) => points.len(),
        }
    }
}

impl Points<'_> {
    /// Borrows the points.
    pub(crate) fn view(&self) -> PyResult<View<'_>> {
        Ok(match self {
            Points::Doubles(array) => View::Doubles(rows(array)?),
            Points::Exact(points) => View::Exact(&points.get().points),
        })
    }
}

/// An input as Python passes it: an object with these attributes.
#[derive(FromPyObject)]
pub(crate) struct Input<'py> {
    points: Points<'py>,
    edges: PyReadonlyArray2<'py, usize>,
    /// The polygon of each ring, and whether the ring is a hole in it.
    rings: Vec<(usize, bool)>,
    /// For each edge its ring, -1 where it has none; nothing, if there are no rings.
    ring_of: Option<PyReadonlyArray1<'py, i64>>,
    holes: Points<'py>,
    regions: Points<'py>,
    /// The attribute of each region, if they have attributes.
    attributes: Vec<f64>,
    /// The greatest area of each region, if they have any; infinite where one has none.
    areas: Vec<f64>,
    /// The feature of each polygon, if a feature may have several.
    features: Option<Vec<usize>>,
    /// The height of each point, NaN where it is missing.
    heights: Option<PyReadonlyArray1<'py, f64>>,
}

/// A borrowed input.
#[derive(Debug)]
pub(crate) struct Graph<'a, S> {
    pub(crate) points: &'a [[S; 2]],
    pub(crate) edges: &'a [[usize; 2]],
    pub(crate) rings: Vec<Ring>,
    pub(crate) ring_of: Vec<Option<usize>>,
    pub(crate) holes: &'a [[S; 2]],
    pub(crate) regions: Vec<Region<S>>,
    pub(crate) areas: &'a [f64],
    /// The feature of each polygon, or its own number.
    pub(crate) features: Vec<usize>,
}

/// A borrowed input in one of the two arithmetics.
#[derive(Debug)]
pub(crate) enum AnyGraph<'a> {
    Doubles(Graph<'a, f64>),
    Exact(Graph<'a, BigRational>),
}

/// Does the same with a graph of either arithmetic.
macro_rules! with_graph {
    ($graph:expr, |$name:ident| $body:expr) => {
        match $graph {
            $crate::input::AnyGraph::Doubles($name) => $body,
            $crate::input::AnyGraph::Exact($name) => $body,
        }
    };
}
pub(crate) use with_graph;

/// The rows of an array of `N` columns.
pub(crate) fn rows<'a, T: Element, const N: usize>(
    array: &'a PyReadonlyArray2<'_, T>,
) -> PyResult<&'a [[T; N]]> {
    if array.shape()[1] != N {
        let columns = array.shape()[1];
        return Err(refused(format!("an array has {columns} columns, not {N}")));
    }
    let slice = array.as_slice();
    let slice = slice.map_err(|_| refused("an array is not contiguous".to_owned()))?;
    Ok(slice.as_chunks().0)
}

impl Input<'_> {
    /// Borrows the heights.
    pub(crate) fn heights(&self) -> PyResult<Option<&[f64]>> {
        let heights = self.heights.as_ref();
        let slice = heights.map(PyReadonlyArray1::as_slice).transpose();
        slice.map_err(|_| refused("the heights are not contiguous".to_owned()))
    }

    /// Borrows the arrays.
    pub(crate) fn graph(&self) -> PyResult<AnyGraph<'_>> {
        let views = (
            self.points.view()?,
            self.holes.view()?,
            self.regions.view()?,
        );
        match views {
            (View::Doubles(points), View::Doubles(holes), View::Doubles(regions)) => {
                Ok(AnyGraph::Doubles(self.with(points, holes, regions)?))
            }
            (View::Exact(points), View::Exact(holes), View::Exact(regions)) => {
                Ok(AnyGraph::Exact(self.with(points, holes, regions)?))
            }
            _ => Err(refused("points and seeds differ in type".to_owned())),
        }
    }

    /// The graph with these coordinates.
    fn with<'a, S: Clone>(
        &'a self,
        points: &'a [[S; 2]],
        holes: &'a [[S; 2]],
        regions: &'a [[S; 2]],
    ) -> PyResult<Graph<'a, S>> {
        let rings = self.rings.iter();
        let ring = |&(polygon, is_hole)| Ring { polygon, is_hole };
        let ring_of = match &self.ring_of {
            Some(array) => {
                let rings = array.as_array();
                let found = rings.iter().map(|&ring| usize::try_from(ring).ok());
                found.collect()
            }
            None => Vec::new(),
        };
        let attributes = self.attributes.iter().copied().chain(iter::repeat(0.0));
        let regions = regions.iter().cloned().zip(attributes);
        let regions = regions.map(|(seed, attribute)| Region { seed, attribute });
        let own = || (0..self.rings.iter().map(|ring| ring.0 + 1).max().unwrap_or(0)).collect();
        Ok(Graph {
            areas: &self.areas,
            features: self.features.clone().unwrap_or_else(own),
            points,
            edges: rows(&self.edges)?,
            rings: rings.map(ring).collect(),
            ring_of,
            holes,
            regions: regions.collect(),
        })
    }
}

impl<S: Scalar> Graph<'_, S> {
    /// The input as the engine takes it.
    pub(crate) fn asked(&self) -> sweep_cdt_engine::Input<'_, S> {
        sweep_cdt_engine::Input {
            points: self.points,
            edges: self.edges,
            holes: self.holes,
            regions: &self.regions,
            rings: &self.rings,
            ring_of: &self.ring_of,
        }
    }

    /// A copy in doubles, for pictures.
    pub(crate) fn for_pictures(&self) -> Pslg<f64> {
        let doubles = |point: &[S; 2]| point.each_ref().map(S::approx);
        Pslg {
            points: self.points.iter().map(doubles).collect(),
            edges: self.edges.to_vec(),
            ..Pslg::default()
        }
    }
}
