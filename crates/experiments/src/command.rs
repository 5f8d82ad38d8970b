//! The command line, and what it asks for: cells of a plan that have not run are run, and the report is
//! written.

use std::error::Error;
use std::fs::File;
use std::path::PathBuf;

use clap::{Args, Parser};
use indicatif::{ProgressBar, ProgressStyle};
use sweep_cdt_generate::{KINDS, Kind};

use crate::contestant::Contestant;
use crate::experiments::{self, Experiment, cells};
use crate::measure::{Cell, Source, Variant};
use crate::plan::{Plan, Store};
use crate::report::{self, Method};

/// Compares search structures for the advancing front, heuristics, phases and scalars.
#[derive(Debug, Parser)]
#[command(name = "sweep-cdt-experiments", after_help = names())]
pub(crate) struct Command {
    /// The experiment.
    name: String,
    #[command(flatten)]
    options: Options,
}

#[derive(Debug, Args)]
struct Options {
    /// Small inputs only: ends within a minute.
    #[arg(long)]
    quick: bool,
    /// The folder of the results [default: target/experiments/NAME].
    #[arg(long)]
    out: Option<PathBuf>,
    /// Kinds of data, instead of the experiment's.
    #[arg(long, value_delimiter = ',', requires = "sizes")]
    data: Vec<String>,
    /// Sizes, instead of the experiment's, with the kinds of --data.
    #[arg(long, value_delimiter = ',', requires = "data")]
    sizes: Vec<usize>,
    /// A `.poly` file besides; may be repeated.
    #[arg(long)]
    file: Vec<PathBuf>,
    /// Runs Triangle too, Shewchuk's program, which is here (table1 only).
    #[arg(long, value_name = "PROGRAM")]
    triangle: Option<PathBuf>,
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How often each variant is timed on each input: an odd number has a median, 0 only counts [default: 5, or
    /// 3 with --quick].
    #[arg(long)]
    repetitions: Option<usize>,
    /// Lists the cells with their numbers.
    #[arg(long)]
    cells: bool,
    /// Runs this cell alone, and writes no report.
    #[arg(long, conflicts_with = "cells")]
    cell: Option<usize>,
    /// Writes the report of cells that have run before, maybe at another commit.
    #[arg(long, conflicts_with_all = ["cells", "cell"])]
    merge: bool,
}

/// All experiments.
const ALL: &[Experiment] = &[
    experiments::FRONTS,
    experiments::HEURISTICS,
    experiments::TABLE_1,
    experiments::TABLE_2,
    experiments::SCALARS,
    experiments::SCALING,
    experiments::ADVERSARIES,
];

fn names() -> String {
    let experiments = ALL.iter().map(|e| format!("  {:12} {}", e.name, e.about));
    let kinds = KINDS
        .iter()
        .map(|kind| format!("  {:16} {}", kind.name, kind.about));
    let list = |lines: Vec<String>| lines.join("\n");
    format!(
        "Experiments:\n{}\n\nKinds of data:\n{}",
        list(experiments.collect()),
        list(kinds.collect())
    )
}

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Does what the command line says, with these structures.
///
/// # Errors
/// Each is a line for the user.
pub(crate) fn run(command: Command, contestants: &[Contestant]) -> Result<()> {
    let name = command.name;
    let experiment = ALL.iter().find(|experiment| experiment.name == name);
    let experiment = experiment.ok_or(format!("no experiment {name}; --help lists them"))?;
    let options = command.options;
    let mut variants = (experiment.variants)(contestants);
    if let Some(program) = &options.triangle {
        if name != experiments::TABLE_1.name {
            return Err("only table1 takes --triangle".into());
        }
        variants.push(Variant::triangle(program));
    }
    let plan = Plan::new(
        *experiment,
        chosen_cells(experiment, &options)?,
        variants,
        options.seed,
        options
            .repetitions
            .unwrap_or(if options.quick { 3 } else { 5 }),
    );
    if options.cells {
        for (number, cell) in plan.cells.iter().enumerate() {
            println!("{number} {}", Plan::line(cell));
        }
        return Ok(());
    }
    let default = || PathBuf::from("target/experiments").join(&name);
    let folder = options.out.unwrap_or_else(default);
    if options.merge {
        let (store, commit) = Store::reopen(&folder, &plan)?;
        return write_report(&Plan { commit, ..plan }, &store);
    }
    let store = Store::open(&folder, &plan)?;
    match options.cell {
        Some(number) => run_cell(&plan, &store, number),
        None => run_all(&plan, &store),
    }
}

fn chosen_cells(experiment: &Experiment, options: &Options) -> Result<Vec<Cell>> {
    let mut chosen = if options.data.is_empty() {
        (experiment.cells)(options.quick)
    } else {
        for name in &options.data {
            kind(name)?;
        }
        let names: Vec<&str> = options.data.iter().map(String::as_str).collect();
        cells(&names, &options.sizes)
    };
    for path in &options.file {
        // Refused now, not after the other cells have run.
        File::open(path).map_err(|error| format!("{}: {error}", path.display()))?;
        chosen.push(Cell {
            source: Source::File(path.clone()),
            size: 0,
        });
    }
    Ok(chosen)
}

fn kind(name: &str) -> Result<Kind> {
    Ok(Kind::named(name).ok_or(format!("no kind of data {name}; --help lists them"))?)
}

/// Runs one cell.
fn run_cell(plan: &Plan, store: &Store, number: usize) -> Result<()> {
    let cell = plan.cells.get(number).ok_or_else(|| {
        let last = plan.cells.len() - 1;
        format!("there is no cell {number}: they are 0 to {last}")
    })?;
    let rows = cell.run(&plan.variants, plan.seed, plan.repetitions)?;
    store.keep(number, &rows)
}

/// Runs all cells that have not run, shows progress, and writes the report.
fn run_all(plan: &Plan, store: &Store) -> Result<()> {
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
    write_report(plan, store)
}

/// Gathers the rows of all cells, and writes the report.
fn write_report(plan: &Plan, store: &Store) -> Result<()> {
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
