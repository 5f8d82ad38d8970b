//! Refinement: a mesh within bounds, as the engine makes it of a triangulation.

use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt_edit::{Bounds, Broken, Refinement};
use sweep_cdt_engine::{Inside, RefinedFile, bounds_or_default, region_areas};
use sweep_cdt_formats::Coordinate;

use crate::calls::{Watch, call};
use crate::crossings::Kind;
use crate::errors::Fault;
use crate::input::{Graph, Input, with_graph};
use crate::remarks::{Remarks, as_file};
use crate::rule::{named, unknown};
use crate::triangulation::{Core, table};

/// How a mesh is refined.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct How {
    bounds: Limits,
    /// The greatest area of regions or features, by their numbers.
    region_areas: Vec<(usize, f64)>,
    /// The greatest area at a place: a function of x and y.
    area_at: Option<Py<PyAny>>,
    most_points: Option<usize>,
    keep_boundary: bool,
    /// A function of the numbers of points, and of triangles that wait.
    progress: Option<Py<PyAny>>,
}

/// Bounds as Python passes them.
#[derive(Clone, Copy, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Limits {
    min_angle: Option<f64>,
    max_area: Option<f64>,
    max_side: Option<f64>,
}

impl Limits {
    pub(crate) fn bounds(self) -> Bounds {
        Bounds {
            least_angle: self.min_angle,
            greatest_area: self.max_area,
            greatest_side: self.max_side,
        }
    }
}

/// The name of a bound.
fn name(bound: Broken) -> &'static str {
    match bound {
        Broken::Angle => "min_angle",
        Broken::Area => "max_area",
        _ => "max_side",
    }
}

/// A triangle that breaks a bound still: its corners, the bound and the reason.
type Left = ([usize; 3], &'static str, String);

/// A mesh: points, edges, the edge of each part, seeds of regions, heights, the triangles that stay, and remarks.
type Mesh<'py> = (
    Bound<'py, PyAny>,
    Bound<'py, PyArray2<usize>>,
    Bound<'py, PyArray1<usize>>,
    Bound<'py, PyAny>,
    Option<Bound<'py, PyArray1<f64>>>,
    Vec<Left>,
    Remarks,
);

/// Refines what is inside a triangulation of an input by a rule.
#[pyfunction]
pub(crate) fn refine<'py>(
    py: Python<'py>,
    input: Input<'_>,
    core: &Bound<'_, Core>,
    rule: &str,
    how: How,
) -> PyResult<Mesh<'py>> {
    let rule = named(rule)?;
    let heights = input.heights()?;
    let graph = input.graph()?;
    let core = core.get();
    with_graph!(&graph, |graph| refined(
        py, graph, core, rule, &how, heights
    ))
}

fn refined<'py, S: Kind + Coordinate>(
    py: Python<'py>,
    graph: &Graph<'_, S>,
    core: &Core,
    rule: Inside,
    how: &How,
    heights: Option<&[f64]>,
) -> PyResult<Mesh<'py>> {
    let mut file = as_file(graph, heights);
    file.polygons.features.clone_from(&graph.features);
    file.graph.regions.clone_from(&graph.regions);
    file.region_areas = graph.areas.to_vec();
    let inside = rule.interior(&graph.asked(), &core.result);
    let inside = inside.map_err(|error| Fault::from(error).raise(py))?;
    let areas = region_areas(&file, rule, &inside, &how.region_areas);
    let (areas, unused) = areas.map_err(unknown)?;
    let has_areas = how.area_at.is_some() || areas.iter().any(|area| area.is_finite());
    let bounds = bounds_or_default(how.bounds.bounds(), has_areas);
    let (mesh, seeds) = call(py, usize::MAX, 1, |watch| {
        let area_at = |[x, y]: [f64; 2]| {
            let area = how.area_at.as_ref();
            area.map_or(f64::INFINITY, |area| {
                asked_of(watch, |py| area.call1(py, (x, y))?.extract(py))
            })
        };
        let progress = |points: usize, waiting: usize| {
            watch.look();
            if let Some(progress) = &how.progress {
                asked_of(watch, |py| progress.call1(py, (points, waiting)).map(drop));
            }
        };
        let mut refinement = Refinement::new(bounds)
            .region_areas(&areas)
            .progress(&progress);
        if how.area_at.is_some() {
            refinement = refinement.area_at(&area_at);
        }
        if let Some(most) = how.most_points {
            refinement = refinement.most_points(most);
        }
        if how.keep_boundary {
            refinement = refinement.keep_boundary();
        }
        let mesh = RefinedFile::new(&file, &inside, &refinement)?;
        let seeds = seeds(graph, &mesh, &inside);
        Ok((mesh, seeds))
    })?;
    let left = mesh.left.iter().map(|left| {
        let corners = mesh.triangles[left.triangle];
        (corners, name(left.bound), left.reason.to_string())
    });
    let remarks = unused.into_iter().chain(mesh.remarks());
    let (left, remarks) = (left.collect(), Remarks(remarks.collect()));
    let mut file = mesh.file;
    let heights = file.columns.pop().map(|column| column.values);
    Ok((
        S::hand(py, file.graph.points)?,
        table(py, file.graph.edges)?,
        file.pieces_of.into_pyarray(py),
        S::hand(py, seeds)?,
        heights.map(|heights| heights.into_pyarray(py)),
        left,
        remarks,
    ))
}

/// What a function of the user returns. An exception of it ends the work.
fn asked_of<T>(watch: &Watch, ask: impl FnOnce(Python<'_>) -> PyResult<T>) -> T {
    Python::attach(ask).unwrap_or_else(|error| watch.end(error))
}

/// For each region a seed in the middle of its largest triangle, since new vertices may lie on the old seed. A region
/// without triangles keeps its seed.
fn seeds<S: Coordinate>(
    graph: &Graph<'_, S>,
    mesh: &RefinedFile<S>,
    inside: &Interior<'_>,
) -> Vec<[S; 2]> {
    let mut seeds: Vec<[S; 2]> = graph.regions.iter().map(|r| r.seed.clone()).collect();
    if inside.is_of_polygons() {
        return seeds;
    }
    let mut largest = vec![0.0; seeds.len()];
    for (corners, region) in mesh.triangles.iter().zip(&mesh.regions) {
        let Some(region) = *region else { continue };
        let places = corners.map(|v| &mesh.file.graph.points[v]);
        let area = sweep_cdt_engine::size(Broken::Area, places);
        if area > largest[region] {
            largest[region] = area;
            seeds[region] = middle(places);
        }
    }
    seeds
}

fn middle<S: Exact>(corners: [&[S; 2]; 3]) -> [S; 2] {
    [0, 1].map(|axis| {
        let [a, b, c] = corners.map(|corner| corner[axis].to_fraction());
        S::nearest(&((a + b + c) / num_bigint::BigInt::from(3)))
    })
}
