//! The triangulation, and its parts as arrays, which NumPy takes over without a copy.

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Bands, Error, Location, Triangulation, Triangulator};
use sweep_cdt_engine::{Inside as Rule, Settings};
use sweep_cdt_formats::{Remark, edges_along};
use sweep_cdt_terrain::{Places, Surface};

use crate::calls::{Watch, call};
use crate::errors::refused;
use crate::input::{Input, Points, View, with_graph};
use crate::measure;
use crate::remarks::{Remarks, of_result};
use crate::rule::{named, unknown};

/// A triangulation, and which of its triangles are inside.
#[pyclass(frozen, module = "sweep_cdt._native")]
#[derive(Debug)]
pub(crate) struct Core {
    pub(crate) result: Triangulation,
    /// `None`, if all triangles are inside.
    inside: Option<Inside>,
    /// Statistics as JSON, if they were asked for.
    #[pyo3(get)]
    stats: Option<String>,
    /// The remarks of the engine on the result.
    remarks: Vec<Remark>,
}

/// What a rule says of each triangle.
#[derive(Debug)]
struct Inside {
    is_inside: Vec<bool>,
    depths: Vec<i32>,
    /// -1, where there is none.
    regions: Vec<i32>,
}

/// A number of a vertex or triangle as NumPy gets it. All fit: there are at most 134 million points.
#[inline]
fn small(index: usize) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}

impl Inside {
    fn of(interior: &Interior<'_>) -> Inside {
        let all = 0..interior.triangulation().len();
        let regions = match interior.has_regions() {
            true => all
                .clone()
                .map(|t| interior.region(t).map_or(-1, small))
                .collect(),
            false => Vec::new(),
        };
        Inside {
            is_inside: all.clone().map(|t| interior.is_inside(t)).collect(),
            depths: all.map(|t| interior.depth(t)).collect(),
            regions,
        }
    }
}

/// Triangulates. `settings` are the front, the heuristics and the algorithm, if the run is to be counted.
#[pyfunction]
#[pyo3(signature = (input, rule, threads, settings=None))]
pub(crate) fn triangulate(
    py: Python<'_>,
    input: Input<'_>,
    rule: &str,
    threads: usize,
    settings: Option<(String, String, String)>,
) -> PyResult<Core> {
    let rule = named(rule)?;
    let settings = settings
        .map(|(front, heuristics, algorithm)| Settings::named(&algorithm, &front, &heuristics))
        .transpose()
        .map_err(unknown)?;
    let heights = input.heights()?;
    let graph = input.graph()?;
    with_graph!(&graph, |graph| {
        let size = graph.points.len() + graph.edges.len();
        call(py, size, threads, |watch| {
            let (result, stats) = match &settings {
                Some(settings) => {
                    let (result, stats) = measure::run(graph, settings, watch)?;
                    (result, Some(stats))
                }
                None => (plain(graph.points, graph.edges, threads, watch)?, None),
            };
            let asked = graph.asked();
            let interior = match rule {
                Rule::HULL => None,
                rule => Some(rule.interior(&asked, &result)?),
            };
            let remarks = of_result(graph, heights, &result, interior.as_ref());
            let inside = interior.as_ref().map(Inside::of);
            drop(interior);
            Ok(Core {
                result,
                inside,
                stats,
                remarks,
            })
        })
    })
}

/// The triangles inside, where nothing else is asked for, in canonical order.
#[pyfunction]
pub(crate) fn triangulate_inside<'py>(
    py: Python<'py>,
    input: Input<'_>,
    rule: &str,
) -> PyResult<Bound<'py, PyArray2<i32>>> {
    let Rule::Edges(rule) = named(rule)? else {
        return Err(refused(format!(
            "the rule {rule:?} asks for more than edges"
        )));
    };
    let graph = input.graph()?;
    let list = with_graph!(&graph, |graph| {
        let size = graph.points.len() + graph.edges.len();
        call(py, size, 1, |_| {
            let list = sweep_cdt::triangulate_inside(graph.points, graph.edges, rule)?;
            Ok(list.into_iter().map(|t| t.map(small)).collect())
        })?
    });
    table(py, list)
}

pub(crate) fn plain<S: Scalar + Sync>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    threads: usize,
    watch: &Watch,
) -> Result<Triangulation, Error> {
    if threads != 1 {
        return Triangulator::new().triangulate_parallel(points, edges, Bands::new());
    }
    let mut progress = |_, _| watch.look();
    let shown = sweep_cdt::Watch::new().progress(&mut progress);
    Triangulator::new().run(points, edges, shown)
}

/// An array of `N` columns.
pub(crate) fn table<'py, T: numpy::Element, const N: usize>(
    py: Python<'py>,
    rows: Vec<[T; N]>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let count = rows.len();
    rows.into_flattened().into_pyarray(py).reshape([count, N])
}

#[pymethods]
impl Core {
    fn __len__(&self) -> usize {
        self.result.len()
    }

    /// The corners of each triangle, counter-clockwise.
    fn simplices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let list = || self.result.triangles().map(|t| t.map(small)).collect();
        let list = py.detach(list);
        table(py, list)
    }

    /// The corners in canonical order; of the triangles inside alone, if `inside`.
    fn canonical<'py>(&self, py: Python<'py>, inside: bool) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let list = py.detach(|| {
            let keep = self.inside.as_ref().filter(|_| inside);
            let mut list = match keep {
                None => self.result.canonical_triangles(),
                Some(keep) => {
                    let all = self.result.triangles().zip(&keep.is_inside);
                    let kept = all.filter(|&(_, &is_inside)| is_inside);
                    kept.map(|(corners, _)| lowest_first(corners)).collect()
                }
            };
            if keep.is_some() {
                list.sort_unstable();
            }
            list.into_iter().map(|t| t.map(small)).collect()
        });
        table(py, list)
    }

    /// The triangle opposite each corner, -1 where there is none.
    fn neighbors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let of = |t| self.result.neighbors(t).map(|t| t.map_or(-1, small));
        let list = py.detach(|| (0..self.result.len()).map(of).collect());
        table(py, list)
    }

    /// Whether the side opposite each corner is an edge or a piece of one.
    fn constrained<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<bool>>> {
        let of = |t| [0, 1, 2].map(|side| self.result.is_constrained(t, side));
        let list = py.detach(|| (0..self.result.len()).map(of).collect());
        table(py, list)
    }

    /// The sides that are edges or pieces of them.
    fn constrained_sides<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let list = || {
            let sides = self.result.constrained_sides();
            sides.map(|side| side.map(small)).collect()
        };
        let list = py.detach(list);
        table(py, list)
    }

    /// The vertices of the hull, counter-clockwise.
    fn hull<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        let hull: Vec<i32> = self.result.hull().map(small).collect();
        hull.into_pyarray(py)
    }

    /// The points that equal one of a lower index, and that one.
    fn duplicates<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let list = self.result.duplicates().map(|pair| pair.map(small));
        table(py, list.collect())
    }

    /// The vertices along the edges `first..last`, which Python knows to be there: each begins where the last one ends.
    fn chain<'py>(&self, py: Python<'py>, first: usize, last: usize) -> Bound<'py, PyArray1<i32>> {
        let chains = (first..last).flat_map(|edge| self.result.edge_chain(edge));
        let mut chain: Vec<i32> = chains.map(small).collect();
        chain.dedup();
        chain.into_pyarray(py)
    }

    /// For each side the first of these edges that runs along it, -1 where none does. Python knows the edges to be there.
    fn edges_along<'py>(
        &self,
        py: Python<'py>,
        edges: PyReadonlyArray1<'_, usize>,
        sides: PyReadonlyArray2<'_, i32>,
    ) -> Bound<'py, PyArray1<i64>> {
        let sides = sides.as_array();
        // A negative number is no vertex.
        let number = |v: i32| usize::try_from(v).unwrap_or(usize::MAX);
        let sides: Vec<_> = sides
            .rows()
            .into_iter()
            .map(|side| [number(side[0]), number(side[1])])
            .collect();
        let edges = edges.as_array().to_vec();
        let found = py.detach(|| edges_along(&self.result, edges, &sides));
        let found = found
            .into_iter()
            .map(|edge| edge.map_or(-1, |edge| edge as i64));
        found.collect::<Vec<i64>>().into_pyarray(py)
    }

    /// Whether each triangle is inside.
    fn inside<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<bool>> {
        let inside = self.inside.as_ref();
        let whole = || vec![true; self.result.len()];
        inside
            .map_or_else(whole, |inside| inside.is_inside.clone())
            .into_pyarray(py)
    }

    /// The remarks of the engine on the result.
    fn remarks(&self) -> Remarks {
        Remarks(self.remarks.clone())
    }

    /// How deep each triangle lies.
    fn depth<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i32>> {
        let inside = self.inside.as_ref();
        let whole = || vec![1; self.result.len()];
        inside
            .map_or_else(whole, |inside| inside.depths.clone())
            .into_pyarray(py)
    }

    /// The region or polygon of each triangle, -1 where there is none; `None` without regions.
    fn region<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<i32>>> {
        let regions = &self.inside.as_ref()?.regions;
        (regions.len() == self.result.len()).then(|| regions.clone().into_pyarray(py))
    }

    /// The closed chains around what is inside.
    fn boundary<'py>(
        &self,
        py: Python<'py>,
        input: Input<'_>,
        rule: &str,
    ) -> PyResult<Vec<Bound<'py, PyArray1<i32>>>> {
        let rule = named(rule)?;
        let graph = input.graph()?;
        let chains = with_graph!(&graph, |graph| call(py, self.result.len(), 1, |_| {
            Ok(rule.interior(&graph.asked(), &self.result)?.boundary())
        })?);
        let array = |chain: Vec<usize>| {
            let chain: Vec<i32> = chain.into_iter().map(small).collect();
            chain.into_pyarray(py)
        };
        Ok(chains.into_iter().map(array).collect())
    }

    /// For each query a triangle that holds it, -1 outside of the hull; `points` are those of the input.
    fn locate<'py>(
        &self,
        py: Python<'py>,
        points: Points<'_>,
        queries: Points<'_>,
    ) -> PyResult<Bound<'py, PyArray1<i32>>> {
        let found = match (points.view()?, queries.view()?) {
            (View::Doubles(points), View::Doubles(queries)) => self.located(py, points, queries)?,
            (View::Exact(points), View::Exact(queries)) => self.located(py, points, queries)?,
            _ => return Err(refused("points and queries differ in type".to_owned())),
        };
        Ok(found.into_pyarray(py))
    }

    /// Values at queries, those of each query one after the other; NaN outside of what is inside by a rule, and farther from
    /// it than `within`. `points` are those of the input, of the type of the queries.
    fn interpolate<'py>(
        &self,
        py: Python<'py>,
        input: Input<'_>,
        rule: &str,
        values: PyReadonlyArray2<'_, f64>,
        places: (Points<'_>, Points<'_>),
        within: Option<f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let rule = named(rule)?;
        let graph = input.graph()?;
        let interior = with_graph!(&graph, |graph| {
            let asked = graph.asked();
            call(py, self.result.len(), 1, |_| {
                Ok(rule.interior(&asked, &self.result)?)
            })?
        });
        let columns = values.as_array();
        let columns: Vec<Vec<f64>> = columns.columns().into_iter().map(|c| c.to_vec()).collect();
        let (points, queries) = places;
        let found = match (points.view()?, queries.view()?) {
            (View::Doubles(points), View::Doubles(queries)) => {
                values_at(py, points, &interior, &columns, (queries, within))?
            }
            (View::Exact(points), View::Exact(queries)) => {
                values_at(py, points, &interior, &columns, (queries, within))?
            }
            _ => return Err(refused("points and queries differ in type".to_owned())),
        };
        Ok(found.into_pyarray(py))
    }
}

/// A triangle with its lowest corner first.
fn lowest_first(mut corners: [usize; 3]) -> [usize; 3] {
    let least = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
    corners.rotate_left(least);
    corners
}

/// So many points are located at once, or as many as there are triangles; a signal ends the call between.
const PART: usize = 1 << 16;

/// What `found` gives for queries, part by part.
fn by_parts<S: Sync, T: Send>(
    py: Python<'_>,
    result: &Triangulation,
    queries: &[[S; 2]],
    mut found: impl FnMut(&[[S; 2]]) -> Vec<T> + Send,
) -> PyResult<Vec<T>> {
    call(py, queries.len(), 1, |watch| {
        let mut all = Vec::with_capacity(queries.len());
        // A part takes as long as the triangles are many, at least.
        for part in queries.chunks(result.len().max(PART)) {
            watch.look();
            all.extend(found(part));
        }
        Ok(all)
    })
}

impl Core {
    fn located<S: Exact + Sync>(
        &self,
        py: Python<'_>,
        points: &[[S; 2]],
        queries: &[[S; 2]],
    ) -> PyResult<Vec<i32>> {
        let mut stars = None;
        let mut triangle = |place| match place {
            Location::Triangle(triangle) | Location::Side { triangle, .. } => small(triangle),
            Location::Vertex(v) => {
                let stars = stars.get_or_insert_with(|| self.result.vertex_stars());
                let first = stars.star(v).next();
                first.map_or(-1, |(triangle, _)| small(triangle))
            }
            Location::Outside => -1,
        };
        let view = self.result.with_points(points);
        by_parts(py, &self.result, queries, |part| {
            view.locate_all(part)
                .into_iter()
                .map(&mut triangle)
                .collect()
        })
    }
}

/// The values at each query, one after the other.
fn values_at<S: Exact + Sync>(
    py: Python<'_>,
    points: &[[S; 2]],
    interior: &Interior<'_>,
    columns: &[Vec<f64>],
    (queries, within): (&[[S; 2]], Option<f64>),
) -> PyResult<Vec<f64>> {
    let surface = |values: &Vec<f64>| Surface::new(points, interior, values);
    let surfaces: Vec<_> = columns.iter().map(surface).collect();
    by_parts(py, interior.triangulation(), queries, |part| {
        let places = Places::new(points, interior, part, within);
        let values = surfaces.iter().map(|s| s.heights_of(&places));
        let values: Vec<Vec<Option<f64>>> = values.collect();
        let row = |query: usize| values.iter().map(move |column| column[query]);
        let rows = (0..part.len()).flat_map(row);
        rows.map(|value| value.unwrap_or(f64::NAN)).collect()
    })
}
