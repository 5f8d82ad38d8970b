//! Runs that are counted: with a front, heuristics and an algorithm by name.

use std::fmt::Write;

use pyo3::prelude::*;
use sweep_cdt::front::{FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Heuristics, Stats, Triangulation, Triangulator};

use crate::calls::Watch;
use crate::errors::{Fault, refused};
use crate::input::Graph;

/// The names of the fronts; the default comes first.
#[pyfunction]
pub(crate) fn fronts() -> Vec<&'static str> {
    FRONTS.map(|(name, _)| name).to_vec()
}

const FRONTS: [(&str, Front); 3] = [
    ("hash", Front::Hash),
    ("skip-list", Front::SkipList),
    ("linear", Front::Linear),
];

#[derive(Clone, Copy, Debug)]
enum Front {
    Hash,
    SkipList,
    Linear,
}

/// What a run is made with.
#[derive(Debug)]
pub(crate) struct Settings {
    front: Front,
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
        let named = |&(name, kind)| (name == front).then_some(kind);
        let found = FRONTS.iter().find_map(named);
        Ok(Settings {
            front: found.ok_or_else(|| unknown("front", &front, &fronts()))?,
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
    let run = |front: &mut dyn FrontSearch| {
        let (mut stats, mut progress) = (Stats::default(), |_, _| watch.look());
        let watch = sweep_cdt::Watch::new();
        let watch = watch.front(front).stats(&mut stats).progress(&mut progress);
        let result = Triangulator::new()
            .heuristics(settings.heuristics)
            .algorithm(settings.algorithm)
            .run(graph.points, graph.edges, watch)?;
        Ok::<_, Fault>((result, stats))
    };
    let (mut table, mut list) = (HashTable::counting(), SkipList::counting());
    let ((result, stats), work) = match settings.front {
        Front::Hash => (run(&mut table)?, Some(table.work())),
        Front::SkipList => (run(&mut list)?, Some(list.work())),
        Front::Linear => (run(&mut Linear::default())?, None),
    };
    let mut text = serde_json::to_string(&stats).expect("numbers by name are JSON");
    if let Some(work) = work {
        // The object goes on.
        text.pop();
        write!(
            text,
            r#","front":{{"comparisons":{},"visited":{},"updates":{},"rearranged":{},"bytes":{}}}}}"#,
            work.comparisons, work.visited, work.updates, work.rearranged, work.bytes
        )
        .expect("strings grow");
    }
    Ok((result, text))
}
