//! Runs the cells of a plan that have not run, shows progress, and writes the report.

use std::error::Error;

use indicatif::{ProgressBar, ProgressStyle};

use crate::measure::Cell;
use crate::plan::{Plan, Store};
use crate::report::{self, Method};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Runs one cell.
pub(crate) fn run_cell(plan: &Plan, store: &Store, number: usize) -> Result<()> {
    let cell = plan.cells.get(number).ok_or_else(|| {
        let last = plan.cells.len() - 1;
        format!("there is no cell {number}: they are 0 to {last}")
    })?;
    let rows = cell.run(&plan.variants, plan.seed, plan.repetitions)?;
    store.keep(number, &rows)
}

/// Runs all cells that have not run, and writes the report.
pub(crate) fn run(plan: &Plan, store: &Store) -> Result<()> {
    // Time goes with points; a file is taken for a small input.
    let weight = |cell: &Cell| cell.size.max(1000) as u64;
    let bar = ProgressBar::new(plan.cells.iter().map(weight).sum());
    let style = "{elapsed_precise} {wide_bar} {percent} %, {eta} left: {msg}";
    bar.set_style(ProgressStyle::with_template(style)?);
    let (missing, done): (Vec<_>, Vec<_>) = plan
        .cells
        .iter()
        .enumerate()
        .partition(|&(number, _)| !store.has(number));
    // What an earlier run has done says nothing about the time that is left.
    bar.set_position(done.iter().map(|(_, cell)| weight(cell)).sum());
    bar.reset_eta();
    for (number, cell) in missing {
        bar.set_message(Plan::line(cell));
        run_cell(plan, store, number)?;
        bar.inc(weight(cell));
    }
    bar.finish_and_clear();
    report(plan, store)
}

/// Gathers the rows of all cells, and writes the report.
pub(crate) fn report(plan: &Plan, store: &Store) -> Result<()> {
    let rows = store.gather(plan)?;
    let method = Method {
        experiment: plan.experiment.name,
        about: plan.experiment.about,
        commit: &plan.commit,
        seed: plan.seed,
        repetitions: plan.repetitions,
    };
    let remarks = (plan.experiment.remarks)(&rows);
    report::write(
        &store.folder,
        &method,
        plan.experiment.views,
        &remarks,
        &rows,
    )?;
    println!("{}", store.folder.join("report.md").display());
    Ok(())
}
