//! The verifier: are these triangles a constrained Delaunay triangulation of this input?
//!
//! By the hull the triangles are verified as they are. By another rule the input is triangulated here, and that
//! triangulation is proven right first: it tells the boundary of the interior and the edges in it, for which the verifier
//! then asks the result, as the command does.

use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sweep_cdt::Triangulator;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Depths, Level, Report, Verifier, Violation, Violations};
use sweep_cdt_formats::locate_seeds;

use crate::calls::{Watch, call};
use crate::errors::{Fault, refused};
use crate::input::{Graph, Input, rows, with_graph};
use crate::rule::Rule;

type Answer = Result<Report, Violations>;

/// What is asked of the triangles.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Question {
    rule: String,
    level: String,
    /// How many points are the input's own, if there are others.
    added_from: Option<usize>,
    all_depths: bool,
    limit: usize,
    /// The attribute of each triangle, and of each region of the input.
    attributes: Option<(Vec<f64>, Vec<f64>)>,
    threads: usize,
}

/// Verifies. Returns counts, depths and violations by name.
#[pyfunction]
pub(crate) fn verify<'py>(
    py: Python<'py>,
    input: Input<'_>,
    triangles: PyReadonlyArray2<'_, usize>,
    question: Question,
) -> PyResult<Bound<'py, PyDict>> {
    let rule = Rule::named(&question.rule)?;
    let level = level(&question.level)?;
    let triangles = rows(&triangles)?;
    let graph = input.graph()?;
    let answer = with_graph!(&graph, |graph| {
        let size = graph.points.len() + triangles.len();
        call(py, size, question.threads, |watch| {
            let progress = |_, _| watch.look();
            let verifier = Verifier::new()
                .accept_clockwise(true)
                .level(level)
                .all_depths(question.all_depths)
                .limit(question.limit)
                .progress(&progress);
            let verifier = match question.added_from {
                Some(own) => verifier.added_from(own),
                None => verifier,
            };
            match rule {
                Rule::Hull => Ok(run(
                    verifier,
                    graph.points,
                    graph.edges,
                    triangles,
                    &question,
                )),
                rule => inside(rule, graph, triangles, verifier, &question, watch),
            }
        })
    })?;
    describe(py, answer)
}

fn level(name: &str) -> PyResult<Level> {
    let found = Level::ALL.into_iter().find(|level| level.name() == name);
    found.ok_or_else(|| {
        let names = Level::ALL.map(Level::name).join(", ");
        refused(format!("level {name:?} is not one of {names}"))
    })
}

fn run<S: Scalar + Sync>(
    verifier: Verifier<'_>,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
    question: &Question,
) -> Answer {
    match question.threads {
        1 => verifier.verify(points, edges, triangles),
        _ => verifier.verify_parallel(points, edges, triangles),
    }
}

/// Verifies that triangles fill the interior by a rule.
fn inside<S: Scalar + Sync + Clone>(
    rule: Rule,
    graph: &Graph<'_, S>,
    triangles: &[[usize; 3]],
    verifier: Verifier<'_>,
    question: &Question,
    watch: &Watch,
) -> Result<Answer, Fault> {
    // The hull of the input's own points, proven right.
    let own = question.added_from.unwrap_or(graph.points.len());
    let points = &graph.points[..own.min(graph.points.len())];
    let mut progress = |_, _| watch.look();
    let shown = sweep_cdt::Watch::new().progress(&mut progress);
    let hull = Triangulator::new().run(points, graph.edges, shown)?;
    let own_triangles: Vec<[usize; 3]> = hull.triangles().collect();
    let proof = run(
        Verifier::new(),
        points,
        graph.edges,
        &own_triangles,
        question,
    );
    assert!(proof.is_ok(), "the triangulation of the input is right");

    let interior = rule.interior(graph, &hull)?;
    let boundary = interior.boundary();
    let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    let mut sides: Vec<[usize; 2]> = interior.constrained_sides().map(sorted).collect();
    sides.sort_unstable();
    let is_in = |side: &[usize; 2]| sides.binary_search(&sorted(*side)).is_ok();
    // The edges in it; of an edge that is in it in part, these parts. And the number of the edge of each.
    let (mut edges, mut numbers) = (Vec::new(), Vec::new());
    for (number, &edge) in graph.edges.iter().enumerate() {
        let chain: Vec<usize> = hull.edge_chain(number).collect();
        let parts = chain.windows(2).map(|part| [part[0], part[1]]);
        if parts.clone().all(|part| is_in(&part)) {
            edges.push(edge);
            numbers.push(number);
        } else {
            edges.extend(parts.filter(is_in));
            numbers.resize(edges.len(), number);
        }
    }

    let verifier = verifier.boundary(&boundary);
    let is_seeded = matches!(rule, Rule::Holes | Rule::HullWithoutHoles);
    let mut answer = match &question.attributes {
        Some((of_triangles, of_regions)) if is_seeded && !graph.regions.is_empty() => {
            let places = locate_seeds(graph.points, triangles, graph.regions).into_iter();
            let seeds = places.zip(of_regions);
            let seeds: Vec<(usize, f64)> = seeds
                .filter_map(|(place, &attribute)| Some((place?, attribute)))
                .collect();
            let verifier = verifier.regions(of_triangles, &seeds);
            run(verifier, graph.points, &edges, triangles, question)
        }
        _ => run(verifier, graph.points, &edges, triangles, question),
    };
    let report = match &mut answer {
        Ok(report) => report,
        Err(violations) => {
            for violation in &mut violations.list {
                if let Violation::MissingEdge { edge, .. } | Violation::BentEdge { edge, .. } =
                    violation
                {
                    *edge = numbers[*edge];
                }
            }
            &mut *violations.report
        }
    };
    report.edges = graph.edges.len();
    Ok(answer)
}

/// The answer as a dictionary.
fn describe(py: Python<'_>, answer: Answer) -> PyResult<Bound<'_, PyDict>> {
    let is_right = answer.is_ok();
    let (report, list, found, depths) = match answer {
        Ok(report) => (report, Vec::new(), 0, Depths::default()),
        Err(violations) => {
            let Violations {
                list,
                found,
                depths,
                report,
                ..
            } = violations;
            (*report, list, found, depths)
        }
    };
    let counts = PyDict::new(py);
    for (name, count) in [
        ("points", report.points),
        ("distinct_points", report.distinct_points),
        ("edges", report.edges),
        ("triangles", report.triangles),
        ("boundary_sides", report.boundary_sides),
        ("constrained_sides", report.constrained_sides),
        ("free_sides", report.free_sides),
        ("cocircular_sides", report.cocircular_sides),
        ("uncanonical_sides", report.uncanonical_sides),
        ("added_points", report.added_points),
        ("split_edges", report.split_edges),
    ] {
        counts.set_item(name, count)?;
    }
    let violations = list.into_iter().map(|violation| {
        let offenders = violation.offenders();
        (
            violation.name(),
            violation.to_string(),
            violation.depth().map(sweep_cdt::verify::Depth::get),
            offenders.vertices,
            offenders.edges,
            offenders.triangles,
        )
    });
    let result = PyDict::new(py);
    result.set_item("is_right", is_right)?;
    result.set_item("is_canonical", is_right && report.is_canonical())?;
    result.set_item("is_clockwise", report.clockwise)?;
    result.set_item("reached", report.level.map(Level::name))?;
    result.set_item("counts", counts)?;
    result.set_item("signs", (report.filtered, report.exact))?;
    result.set_item("found", found)?;
    result.set_item("measured", depths.measured())?;
    result.set_item(
        "deepest",
        depths.greatest.map(sweep_cdt::verify::Depth::get),
    )?;
    result.set_item("decades", depths.decades)?;
    result.set_item("violations", violations.collect::<Vec<_>>())?;
    Ok(result)
}
