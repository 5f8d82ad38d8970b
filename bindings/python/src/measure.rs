//! Runs that are counted: with a front, heuristics and an algorithm by name.

use std::fmt::Write;

use pyo3::prelude::*;
use sweep_cdt::front::{AnyFront, FrontSearch, HashTable, Linear, SkipList, Work};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Heuristics, Triangulation, Triangulator};

use crate::calls::Watch;
use crate::errors::{Fault, refused};
use crate::input::Graph;

/// The names of the fronts; the default comes first.
#[pyfunction]
pub(crate) fn fronts() -> Vec<&'static str> {
    AnyFront::all().iter().map(AnyFront::name).collect()
}

/// What a run is made with.
#[derive(Debug)]
pub(crate) struct Settings {
    front: AnyFront,
    pub(crate) heuristics: Heuristics,
    algorithm: Algorithm,
}

/// The heuristics of a name.
pub(crate) fn heuristics(name: &str) -> PyResult<Heuristics> {
    match name {
        "fast" => Ok(Heuristics::FAST),
        "paper" => Ok(Heuristics::PAPER),
        "off" => Ok(Heuristics::OFF),
        _ => Err(unknown("heuristics", name, &["fast", "paper", "off"])),
    }
}

fn unknown(what: &str, name: &str, known: &[&str]) -> PyErr {
    let known = known.join(", ");
    refused(format!("{what} {name:?} is not one of {known}"))
}

impl Settings {
    /// The settings of the names of a front, heuristics and an algorithm.
    pub(crate) fn named((front, rules, algorithm): (String, String, String)) -> PyResult<Settings> {
        let names = ["auto", "sweep", "divide-and-conquer"];
        Ok(Settings {
            front: AnyFront::named(&front).ok_or_else(|| unknown("front", &front, &fronts()))?,
            heuristics: heuristics(&rules)?,
            algorithm: match &*algorithm {
                "auto" => Algorithm::Auto,
                "sweep" => Algorithm::Sweep,
                "divide-and-conquer" => Algorithm::DivideAndConquer,
                _ => return Err(unknown("algorithm", &algorithm, &names)),
            },
        })
    }
}

/// Triangulates on one thread. Returns the statistics as JSON, with the work of the front where it counts any.
pub(crate) fn run<S: Scalar>(
    graph: &Graph<'_, S>,
    settings: &Settings,
    watch: &Watch,
) -> Result<(Triangulation, String), Fault> {
    match settings.front {
        AnyFront::HashTable(_) => with(graph, settings, watch, HashTable::counting(), |front| {
            Some(front.work())
        }),
        AnyFront::SkipList(_) => with(graph, settings, watch, SkipList::counting(), |front| {
            Some(front.work())
        }),
        _ => with(graph, settings, watch, Linear::default(), |_| None),
    }
}

fn with<S: Scalar, F: FrontSearch + Clone>(
    graph: &Graph<'_, S>,
    settings: &Settings,
    watch: &Watch,
    front: F,
    work: impl Fn(&F) -> Option<Work>,
) -> Result<(Triangulation, String), Fault> {
    let progress = |_, _| watch.look();
    let triangulator = Triangulator::new()
        .front(front)
        .heuristics(settings.heuristics)
        .algorithm(settings.algorithm)
        .progress(&progress);
    let run = triangulator.triangulate_with_stats(graph.points, graph.edges)?;
    let mut text = serde_json::to_string(&run.stats).expect("numbers by name are JSON");
    if let Some(work) = work(&run.front) {
        // The object goes on.
        text.pop();
        write!(
            text,
            r#","front":{{"comparisons":{},"visited":{},"updates":{},"rearranged":{},"bytes":{}}}}}"#,
            work.comparisons, work.visited, work.updates, work.rearranged, work.bytes
        )
        .expect("strings grow");
    }
    Ok((run.triangulation, text))
}
