//! What the paper reads: a summary of all experiments in a folder, fits of growth, and figures.
//!
//! The folder has the two CSV files of each experiment (`reproduce` puts them there). From them alone
//! come `summary.csv` (a row for each variant on each kind and size: medians, the ratio to the first variant with its
//! interval, the verdict), `growth.csv` (fits) and the figures. `paper.typ` reads these and has no number of its own.

use std::error::Error;
use std::fs;
use std::path::Path;

use serde::Serialize;

use crate::experiments::{
    ADVERSARIES, Experiment, FRONTS, HEURISTICS, HOLD_OUT, SCALING, TABLE_1, TABLE_2,
};
use crate::measure::{Row, Turn, median};
use crate::plan::{read_rows, write};
use crate::report::{Fit, Ratio, Shape, View, distinct, plots};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// The experiments of the paper.
const STUDY: [Experiment; 7] = [
    FRONTS,
    HOLD_OUT,
    SCALING,
    ADVERSARIES,
    HEURISTICS,
    TABLE_1,
    TABLE_2,
];
/// The file of the cells of [`FRONTS`] that ran under Cachegrind.
const CACHES: &str = "caches";

/// A row of `summary.csv`.
#[derive(Debug, Serialize)]
struct Summary {
    experiment: String,
    data: String,
    size: usize,
    variant: String,
    points: usize,
    seeds: usize,
    turns: usize,
    /// Turns in which the clock ran over a tenth longer than the processor.
    disturbed: usize,
    /// Nanoseconds a point, and of the three parts.
    ns: Option<f64>,
    initialization_ns: Option<f64>,
    sweeping_ns: Option<f64>,
    finalization_ns: Option<f64>,
    ratio: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
    verdict: Option<&'static str>,
    /// Of one turn under Cachegrind, a point.
    instructions: Option<f64>,
    mispredicted: Option<f64>,
    first_misses: Option<f64>,
    second_misses: Option<f64>,
}

/// A row of `growth.csv`.
#[derive(Debug, Serialize)]
struct Growth {
    experiment: &'static str,
    data: String,
    variant: String,
    measure: &'static str,
    factor: f64,
    exponent: f64,
    residual: f64,
}

/// Writes summary, fits and figures into the folder.
///
/// # Errors
/// If a file of the experiments is missing.
pub(crate) fn write_all(folder: &Path) -> Result<()> {
    let mut summaries = Vec::new();
    let mut growths = Vec::new();
    for experiment in &STUDY {
        let rows = read_rows(&folder.join(format!("{}.csv", experiment.name)))?;
        summaries.extend(summaries_of(experiment.name, &rows));
        for view in experiment.views {
            if view.shape == Shape::Growth || view.shape == Shape::Exponents {
                growths.extend(growths_of(experiment.name, view, &rows));
            }
            let is_shown = match view.shape {
                Shape::Angles => true,
                Shape::Ratios => [FRONTS.name, HOLD_OUT.name].contains(&experiment.name),
                Shape::Growth => experiment.name == SCALING.name && view.name == "work",
                _ => false,
            };
            if is_shown {
                draw(folder, experiment.name, view, &rows)?;
            }
        }
    }
    let rows = read_rows(&folder.join(format!("{CACHES}.csv")))?;
    summaries.extend(summaries_of(CACHES, &rows));
    for view in CACHES_VIEWS {
        draw(folder, CACHES, view, &rows)?;
    }
    write(&folder.join("summary.csv"), &summaries)?;
    write(&folder.join("growth.csv"), &growths)?;
    println!("{}", folder.display());
    Ok(())
}

const CACHES_VIEWS: &[View] = &[
    View {
        name: "instructions",
        title: "Instructions, a point",
        about: "",
        measure: |row| per_point(row, row.instructions),
        shape: Shape::Map,
    },
    View {
        name: "misses",
        title: "Misses of the second level, a point",
        about: "",
        measure: |row| per_point(row, row.second_misses),
        shape: Shape::Map,
    },
];

fn per_point(row: &Row, count: Option<u64>) -> Option<f64> {
    Some(count? as f64 / row.points.max(1) as f64)
}

fn draw(folder: &Path, name: &str, view: &View, rows: &[Row]) -> Result<()> {
    for plot in plots(view, rows) {
        fs::write(folder.join(format!("{name}-{}", plot.file)), plot.svg)?;
    }
    Ok(())
}

/// A summary for each variant on each kind and size, over its seeds.
fn summaries_of(experiment: &str, rows: &[Row]) -> Vec<Summary> {
    let mut summaries = Vec::new();
    for (data, size) in distinct(rows.iter().map(|row| (&row.data, row.size))) {
        let cell: Vec<&Row> = rows
            .iter()
            .filter(|row| (&row.data, row.size) == (data, size))
            .collect();
        let variants = distinct(cell.iter().map(|row| &row.variant));
        let of = |variant: &String| {
            cell.iter()
                .copied()
                .filter(|row| row.variant == *variant)
                .collect::<Vec<&Row>>()
        };
        let first = variants
            .first()
            .map(|variant| of(variant))
            .unwrap_or_default();
        for variant in variants {
            let own = of(variant);
            let turns: Vec<&Turn> = own.iter().flat_map(|row| &row.turns).collect();
            let middle = |measure: &dyn Fn(&Row) -> Option<f64>| {
                median(own.iter().filter_map(|row| measure(row)))
            };
            let phase = |i: usize| middle(&|row| Some(row.phases()?[i]));
            let ratio = Ratio::of(&own, &first);
            summaries.push(Summary {
                experiment: experiment.to_owned(),
                data: data.clone(),
                size,
                variant: variant.clone(),
                points: own[0].points,
                seeds: own.len(),
                turns: turns.len(),
                disturbed: turns.iter().filter(|turn| turn.is_disturbed()).count(),
                ns: middle(&Row::ns_per_point),
                initialization_ns: phase(0),
                sweeping_ns: phase(1),
                finalization_ns: phase(2),
                ratio: ratio.map(|ratio| ratio.middle),
                low: ratio.map(|ratio| ratio.low),
                high: ratio.map(|ratio| ratio.high),
                verdict: ratio.and_then(|ratio| ratio.verdict()),
                instructions: middle(&|row| per_point(row, row.instructions)),
                mispredicted: middle(&|row| per_point(row, row.mispredicted)),
                first_misses: middle(&|row| per_point(row, row.first_misses)),
                second_misses: middle(&|row| per_point(row, row.second_misses)),
            });
        }
    }
    summaries
}

/// The fits of a view for each variant on each kind of data.
fn growths_of(experiment: &'static str, view: &View, rows: &[Row]) -> Vec<Growth> {
    let mut growths = Vec::new();
    for (data, variant) in distinct(rows.iter().map(|row| (&row.data, &row.variant))) {
        let own = rows
            .iter()
            .filter(|row| (&row.data, &row.variant) == (data, variant) && !row.is_left_out);
        let at: Option<Vec<[f64; 2]>> = own
            .map(|row| Some([row.points as f64, (view.measure)(row)?]))
            .collect();
        if let Some(fit) = at.and_then(|at| Fit::of(&at)) {
            growths.push(Growth {
                experiment,
                data: data.clone(),
                variant: variant.clone(),
                measure: view.name,
                factor: fit.factor,
                exponent: fit.exponent,
                residual: fit.residual,
            });
        }
    }
    growths
}
