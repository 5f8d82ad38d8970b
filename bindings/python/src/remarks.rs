//! Remarks on an input or a result, as objects of `sweep_cdt._remarks`: the sentence of the engine, and its numbers.

use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use sweep_cdt::interior::Interior;
use sweep_cdt::{Pslg, Triangulation};
use sweep_cdt_formats::{Column, Coordinate, CoordinateSystem, GraphFile, Polygons, Remark};

use crate::input::{Graph, rows};

/// The remark on so many things that are ignored, if there are any, with the name of one and of many.
#[pyfunction]
pub(crate) fn ignored(count: usize, one: &str, many: &str) -> Remarks {
    let remark = (count > 0).then(|| Remark::ignored(count, one, many));
    Remarks(remark.into_iter().collect())
}

/// The remark on places without a value, if there are any.
#[pyfunction]
pub(crate) fn off_terrain(missing: usize, places: usize) -> Remarks {
    let remark = (missing > 0).then_some(Remark::OffTerrain { missing, places });
    Remarks(remark.into_iter().collect())
}

/// The remark on edges that span more than half of all longitudes, if there are any; the edges end at points.
#[pyfunction]
pub(crate) fn half_of_the_globe(
    points: PyReadonlyArray2<'_, f64>,
    edges: PyReadonlyArray2<'_, usize>,
) -> PyResult<Remarks> {
    let sides = rows(&edges)?.iter().copied();
    let remark = Remark::half_of_the_globe(rows(&points)?, sides);
    Ok(Remarks(remark.into_iter().collect()))
}

/// The remark on features whose height is a property or column of this name.
#[pyfunction]
pub(crate) fn height_property(name: String, count: usize) -> Remarks {
    Remarks(vec![Remark::HeightProperty { name, count }])
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
        let loads = py.import("json")?.getattr("loads")?;
        let made = self.0.into_iter().map(|remark| {
            let numbers = loads.call1((remark.numbers().to_string(),))?;
            let mut words = remark.to_string();
            match (&remark, remark.setting()) {
                // Arrays have another way to say so than files.
                (Remark::Void { .. }, _) => words += " (NaN or a mask would say so)",
                (_, Some((argument, does))) => words += &format!(" (argument {argument}: {does})"),
                (_, None) => {}
            }
            class.call1((remark.name(), words, remark.is_loss(), numbers))
        });
        let made = made.collect::<PyResult<Vec<_>>>()?;
        made.into_pyobject(py)
    }
}

/// The remarks of the engine on a triangulation and its interior, unless that is the hull.
pub(crate) fn of_result<S: Coordinate>(
    graph: &Graph<'_, S>,
    heights: Option<&[f64]>,
    result: &Triangulation,
    interior: Option<&Interior<'_>>,
) -> Vec<Remark> {
    let asks = |domain: &Interior<'_>| domain.is_of_polygons() || domain.inside().len() == 0;
    if !result.is_empty() && !interior.is_some_and(asks) {
        // There is nothing to say, so that nothing is copied.
        return Vec::new();
    }
    let mut file = as_file(graph, heights);
    file.graph.holes = graph.holes.to_vec();
    sweep_cdt_engine::remarks(&file, result, interior)
}

/// The input as a file of the engine, without seeds.
pub(crate) fn as_file<S: Coordinate>(
    graph: &Graph<'_, S>,
    heights: Option<&[f64]>,
) -> GraphFile<S> {
    let heights = heights.map(|heights| Column::heights(heights.to_vec()));
    GraphFile {
        columns: heights.into_iter().collect(),
        polygons: Polygons {
            rings: graph.rings.clone(),
            ring_of: graph.ring_of.clone(),
            ..Polygons::default()
        },
        ..Pslg {
            points: graph.points.to_vec(),
            edges: graph.edges.to_vec(),
            ..Pslg::default()
        }
        .into()
    }
}

/// The remark on vertices without a height, if others have one.
#[pyfunction]
pub(crate) fn without_heights(heights: PyReadonlyArray1<'_, f64>) -> Remarks {
    let remark = sweep_cdt_engine::without_heights(&of_heights(&heights));
    Remarks(remark.into_iter().collect())
}

/// The remarks on heights that often mean that there is none.
#[pyfunction]
pub(crate) fn voids(heights: PyReadonlyArray1<'_, f64>) -> Remarks {
    Remarks(of_heights(&heights).with_voids_said().remarks)
}

/// Whether the member `crs` of a document names a system of longitudes and latitudes.
#[pyfunction]
pub(crate) fn is_of_degrees(name: &str) -> bool {
    CoordinateSystem::named(name).is_of_degrees()
}

/// A file of the engine whose vertices have heights and no places.
fn of_heights(heights: &PyReadonlyArray1<'_, f64>) -> GraphFile<()> {
    let heights = heights.as_array().to_vec();
    GraphFile {
        graph: Pslg {
            points: vec![[(); 2]; heights.len()],
            ..Pslg::default()
        },
        columns: vec![Column::heights(heights)],
        ..GraphFile::default()
    }
}
