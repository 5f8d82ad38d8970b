//! Runs that are counted: with a front, heuristics and an algorithm by name.

use std::fmt::Write;

use pyo3::prelude::*;
use sweep_cdt::front::{FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Heuristics, Stats, Triangulation};
use sweep_cdt_engine::{FRONTS, FrontKind, HEURISTICS, Settings, chosen};

use crate::calls::Watch;
use crate::errors::Fault;
use crate::input::Graph;
use crate::rule::unknown;

/// The names of the fronts; the default comes first.
#[pyfunction]
pub(crate) fn fronts() -> Vec<&'static str> {
    FRONTS.map(|front| front.name).to_vec()
}

/// The heuristics of a name.
pub(crate) fn heuristics(name: &str) -> PyResult<Heuristics> {
    chosen("heuristics", &HEURISTICS, name).map_err(unknown)
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
        let triangulator = settings.triangulator();
        let result = triangulator.run(graph.points, graph.edges, watch)?;
        Ok::<_, Fault>((result, stats))
    };
    let (mut table, mut list) = (HashTable::counting(), SkipList::counting());
    let ((result, stats), work) = match settings.front {
        FrontKind::Hash => (run(&mut table)?, Some(table.work())),
        FrontKind::SkipList => (run(&mut list)?, Some(list.work())),
        FrontKind::Linear => (run(&mut Linear::default())?, None),
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
