//! Voronoi diagrams, and cells that are cut.

use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use sweep_cdt::interior::Interior;
use sweep_cdt_edit::Voronoi;
use sweep_cdt_engine::{Clip, cells as cut};
use sweep_cdt_formats::{Cell, Coordinate};

use crate::calls::call;
use crate::crossings::Kind;
use crate::errors::refused;
use crate::input::{AnyGraph, Graph, Input, with_graph};
use crate::remarks::Remarks;
use crate::rule::named;
use crate::triangulation::{Core, table};

/// A diagram: vertices, the points and the vertices of ridges (-1 for none), their directions, the vertices of all
/// cells, and where the cell of each point begins among them.
type Diagram<'py> = (
    Bound<'py, PyAny>,
    Bound<'py, PyArray2<usize>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyAny>,
    Bound<'py, PyArray1<usize>>,
    Bound<'py, PyArray1<usize>>,
);

/// The Voronoi diagram of the points of a triangulation.
#[pyfunction]
pub(crate) fn voronoi<'py>(
    py: Python<'py>,
    input: Input<'_>,
    core: &Bound<'_, Core>,
) -> PyResult<Diagram<'py>> {
    let graph = input.graph()?;
    let core = core.get();
    with_graph!(&graph, |graph| diagram(py, graph, core))
}

fn diagram<'py, S: Kind + Coordinate>(
    py: Python<'py>,
    graph: &Graph<'_, S>,
    core: &Core,
) -> PyResult<Diagram<'py>> {
    let (found, directions) = call(py, core.result.len(), 1, |_| {
        let found = Voronoi::new(&core.result, graph.points)?;
        let directions = found.ridges.iter().map(|ridge| found.direction(ridge));
        let directions: Vec<[S; 2]> = directions.collect();
        Ok((found, directions))
    })?;
    let number = |end: Option<usize>| end.map_or(-1, |v| v as i64);
    let ends = found.ridges.iter().map(|ridge| ridge.ends.map(number));
    let points = found.ridges.iter().map(|ridge| ridge.points);
    let mut begins = vec![0];
    for cell in &found.cells {
        begins.push(begins[begins.len() - 1] + cell.len());
    }
    Ok((
        S::hand(py, found.vertices)?,
        table(py, points.collect())?,
        table(py, ends.collect())?,
        S::hand(py, directions)?,
        found.cells.concat().into_pyarray(py),
        begins.into_pyarray(py),
    ))
}

/// What cells are cut to: nothing for the box around the points, a box by its corners, or what is inside an input by a
/// rule.
#[derive(FromPyObject)]
pub(crate) enum Within<'py> {
    Box([f64; 4]),
    Domain(Input<'py>, Bound<'py, Core>, String),
}

/// Polygons, each a list of rings.
type Polygons<'py> = Vec<Vec<Bound<'py, PyAny>>>;

/// The point and the polygons of each cell, cut to something, and remarks.
#[pyfunction]
pub(crate) fn cells<'py>(
    py: Python<'py>,
    input: Input<'_>,
    core: &Bound<'_, Core>,
    within: Option<Within<'_>>,
) -> PyResult<(Vec<(usize, Polygons<'py>)>, Remarks)> {
    let graph = input.graph()?;
    let core = core.get();
    let differ = || refused("the points and the domain differ in type".to_owned());
    let domain = match &within {
        Some(Within::Domain(input, core, rule)) => Some((input.graph()?, core.get(), named(rule)?)),
        _ => None,
    };
    let corners = match within {
        Some(Within::Box(corners)) => Some(corners),
        _ => None,
    };
    match (&graph, &domain) {
        (AnyGraph::Doubles(graph), Some((AnyGraph::Doubles(of), result, rule))) => {
            let inside = rule.interior(&of.asked(), &result.result);
            let inside = inside.map_err(|error| crate::errors::Fault::from(error).raise(py))?;
            cut_to(py, graph, core, corners, Some((&inside, of.points)))
        }
        (AnyGraph::Exact(graph), Some((AnyGraph::Exact(of), result, rule))) => {
            let inside = rule.interior(&of.asked(), &result.result);
            let inside = inside.map_err(|error| crate::errors::Fault::from(error).raise(py))?;
            cut_to(py, graph, core, corners, Some((&inside, of.points)))
        }
        (_, Some(_)) => Err(differ()),
        (graph, None) => with_graph!(graph, |graph| cut_to(py, graph, core, corners, None)),
    }
}

fn cut_to<'py, S: Kind + Coordinate>(
    py: Python<'py>,
    graph: &Graph<'_, S>,
    core: &Core,
    corners: Option<[f64; 4]>,
    domain: Option<(&Interior<'_>, &[[S; 2]])>,
) -> PyResult<(Vec<(usize, Polygons<'py>)>, Remarks)> {
    let exactly = |x: f64| {
        let x = num_rational::BigRational::from_float(x);
        let x = x.ok_or_else(|| refused("a corner of the box is not finite".to_owned()));
        x.map(|x| S::nearest(&x))
    };
    let clip = match (corners, domain) {
        (Some([left, low, right, high]), _) => {
            if left >= right || low >= high {
                let message = "the box has no area: x and y of its lower left corner come before the upper right one";
                return Err(refused(message.to_owned()));
            }
            Some(Clip::Box([
                [exactly(left)?, exactly(low)?],
                [exactly(right)?, exactly(high)?],
            ]))
        }
        (None, Some((inside, points))) => Some(Clip::Inside(inside, points)),
        (None, None) => Clip::around(graph.points),
    };
    let Some(clip) = clip else {
        return Ok((Vec::new(), Remarks::default()));
    };
    let (found, shared) = call(py, core.result.len(), 1, |_| {
        let voronoi = Voronoi::new(&core.result, graph.points)?;
        Ok(cut(&voronoi, &core.result, &clip)?)
    })?;
    let cells = found.into_iter().map(|Cell { point, polygons }| {
        let rings = |polygon: Vec<Vec<[S; 2]>>| {
            let rings = polygon.into_iter().map(|ring| S::hand(py, ring));
            rings.collect::<PyResult<Vec<_>>>()
        };
        let polygons = polygons.into_iter().map(rings);
        Ok((point, polygons.collect::<PyResult<Vec<_>>>()?))
    });
    let cells = cells.collect::<PyResult<Vec<_>>>()?;
    Ok((cells, Remarks(shared.into_iter().collect())))
}
