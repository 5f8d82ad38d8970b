//! The verifier: are these triangles a constrained Delaunay triangulation of this input? And what is to be done if not?

use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sweep_cdt::verify::{Depth, Depths, Level, Report, Verifier, Violations};
use sweep_cdt_edit::Bounds;
use sweep_cdt_engine::{
    Advice, Answer, Inside, OUT_OF_BOUNDS, Setting, UnknownName, Verdict, Words, counts, headline,
    nothing_free, of_mesh, violators, with_bounds,
};
use sweep_cdt_formats::Numbering;

use crate::calls::call;
use crate::input::{Input, rows, with_graph};
use crate::refine::Limits;
use crate::remarks::Remarks;
use crate::rule::{named, unknown};
use crate::triangulation::plain;

/// What is asked of the triangles.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Question {
    rule: String,
    level: String,
    max_depth: Option<f64>,
    /// How many points are the input's own, if there are others.
    added_from: Option<usize>,
    limit: usize,
    /// The attribute of each triangle, if the input has regions with attributes.
    attributes: Option<Vec<f64>>,
    /// Whether the input is what the triangles tell.
    is_alone: bool,
    /// Whether nothing but the bounds is asked.
    only_bounds: bool,
    threads: usize,
    bounds: Limits,
}

/// Does work on a question about triangles of an input.
macro_rules! with_question {
    ($py:expr, $input:expr, $triangles:expr, $question:expr, |$name:ident| $body:expr) => {{
        let (rule, level) = (named(&$question.rule)?, level(&$question.level)?);
        let triangles = rows(&$triangles)?;
        let graph = $input.graph()?;
        with_graph!(&graph, |graph| {
            let size = graph.points.len() + triangles.len();
            call($py, size, $question.threads, |watch| {
                let threads = $question.threads;
                let verify =
                    |verifier: Verifier<'_>, points: &[_], edges: &[_], triangles: &[_]| {
                        let progress = |_, _| watch.look();
                        let verifier = verifier.progress(&progress);
                        match threads {
                            1 => verifier.verify(points, edges, triangles),
                            _ => verifier.verify_parallel(points, edges, triangles),
                        }
                    };
                let input = graph.asked();
                let $name = sweep_cdt_engine::Question {
                    input: &input,
                    points: graph.points,
                    added_from: $question.added_from,
                    numbering: Numbering::default(),
                    triangles,
                    first_triangle: 0,
                    strangers: &[],
                    attributes: $question.attributes.as_deref(),
                    domain: rule,
                    level,
                    max_depth: $question.max_depth,
                    limit: $question.limit,
                    triangulate: &|points, edges| plain(points, edges, threads, watch),
                    verify: &verify,
                };
                $body
            })
        })?
    }};
}

/// Verifies. Returns the verdict, counts, depths and violations by name.
#[pyfunction]
pub(crate) fn verify<'py>(
    py: Python<'py>,
    input: Input<'_>,
    triangles: PyReadonlyArray2<'_, usize>,
    question: Question,
) -> PyResult<Bound<'py, PyDict>> {
    let (bounds, only_bounds) = (question.bounds.bounds(), question.only_bounds);
    let (answer, unbounded, broken) = with_question!(py, input, triangles, question, |question| {
        let answer = match only_bounds {
            true => Ok(counted(question.points.len(), question.triangles.len())),
            false => question.answer()?,
        };
        let verdict = question.verdict(&answer);
        let broken = violators(&bounds, question.points, question.triangles)?;
        Ok((answer, verdict, broken))
    });
    let (rule, level) = (named(&question.rule)?, level(&question.level)?);
    let input = match rule {
        Inside::HULL => "the points".to_owned(),
        rule => format!("the interior ({rule})"),
    };
    let corners: &[[usize; 3]] = rows(&triangles)?;
    let mut headline = match only_bounds {
        true => of_mesh("this", corners.len()),
        false => headline(&answer, level, question.max_depth, ["this", &input]),
    };
    let remarks = nothing_free(&answer, level).filter(|_| !only_bounds);
    if bounds != Bounds::default() {
        headline = with_bounds(&headline, sweep_cdt_engine::broken(&broken), corners.len());
    }
    let described = describe(py, answer, unbounded.with_bounds(&broken), |violations| {
        let room = question.limit.saturating_sub(violations.len());
        violations.extend(broken.iter().take(room).map(|violator| {
            let t = violator.triangle;
            let words = violator.words(t);
            let name = violator.name();
            (name, words, None, corners[t].to_vec(), vec![], vec![t])
        }));
        broken.len()
    })?;
    described.set_item("unbounded", unbounded.name())?;
    described.set_item("headline", headline)?;
    described.set_item("remarks", Remarks(remarks.into_iter().collect()))?;
    if only_bounds {
        described.set_item("is_canonical", false)?;
    }
    Ok(described)
}

/// The report on a mesh of which nothing but bounds is asked.
fn counted(points: usize, triangles: usize) -> Report {
    let mut report = Report::default();
    (report.points, report.triangles) = (points, triangles);
    report
}

/// What to do, in words, after triangles have got a verdict, and may run clockwise.
#[pyfunction]
pub(crate) fn advise(
    py: Python<'_>,
    input: Input<'_>,
    triangles: PyReadonlyArray2<'_, usize>,
    question: Question,
    unbounded: &str,
    verdict: &str,
    clockwise: bool,
) -> PyResult<String> {
    if verdict == Verdict::Wrong.name() && unbounded != verdict {
        return Ok(OUT_OF_BOUNDS.to_owned());
    }
    let is_alone = question.is_alone;
    let sentence = with_question!(py, input, triangles, question, |question| {
        let advice = if verdict == Verdict::Correct.name() {
            Advice::Correct { clockwise }
        } else if verdict == Verdict::WithinMaxDepth.name() {
            Advice::Rounded
        } else {
            question.advice(&question.answer()?)
        };
        let words = Words {
            setting: "argument",
            max_depth: "max_depth",
            settings: &arguments,
            refused: &|error| error.to_string(),
            beside_input: is_alone.then_some("verify(input, mesh, steiner=True)"),
            show: "report.plot() shows",
        };
        Ok(question.sentence(advice, &words))
    });
    Ok(sentence)
}

/// Settings as arguments.
fn arguments(settings: &[Setting]) -> String {
    let argument = |setting: &Setting| match setting {
        Setting::Domain(rule) => format!("domain=\"{rule}\""),
        Setting::MaxDepth(depth) => format!("max_depth={depth:e}"),
        Setting::Level(level) => format!("level=\"{}\"", level.name()),
    };
    let arguments: Vec<String> = settings.iter().map(argument).collect();
    arguments.join(", ")
}

fn level(name: &str) -> PyResult<Level> {
    let found = Level::ALL.into_iter().find(|level| level.name() == name);
    let known = Level::ALL.map(Level::name);
    found.ok_or_else(|| unknown(UnknownName::new("level", name, known)))
}

/// A violation: its name, words and depth, and the vertices, edges and triangles that it names.
type Listed = (
    &'static str,
    String,
    Option<f64>,
    Vec<usize>,
    Vec<usize>,
    Vec<usize>,
);

/// The answer as a dictionary. `more` adds to the violations, and returns how many more there are.
fn describe(
    py: Python<'_>,
    answer: Answer,
    verdict: Verdict,
    more: impl FnOnce(&mut Vec<Listed>) -> usize,
) -> PyResult<Bound<'_, PyDict>> {
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
    let by_name = PyDict::new(py);
    for (name, count) in counts(&report) {
        by_name.set_item(name, count)?;
    }
    let violations = list.into_iter().map(|violation| {
        let offenders = violation.offenders();
        (
            violation.name(),
            violation.to_string(),
            violation.depth().map(Depth::get),
            offenders.vertices,
            offenders.edges,
            offenders.triangles,
        )
    });
    let mut violations: Vec<Listed> = violations.collect();
    let found = found + more(&mut violations);
    let result = PyDict::new(py);
    result.set_item("verdict", verdict.name())?;
    result.set_item("is_canonical", is_right && report.is_canonical())?;
    result.set_item("is_clockwise", report.clockwise)?;
    result.set_item("reached", report.level.map(Level::name))?;
    result.set_item("counts", by_name)?;
    result.set_item("signs", (report.filtered, report.exact))?;
    result.set_item("found", found)?;
    result.set_item("deepest", depths.greatest.map(Depth::get))?;
    result.set_item("decades", depths.decades)?;
    result.set_item("violations", violations)?;
    Ok(result)
}
