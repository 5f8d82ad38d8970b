//! The command line, and what it asks for: cells of a plan that have not run are run, and the report is
//! written.

use std::error::Error;
use std::fs::File;
use std::path::{Path, PathBuf};

use clap::{Args, Parser};
use indicatif::{ProgressBar, ProgressStyle};
use sweep_cdt_generate::{KINDS, Kind};

use crate::contestant::Contestant;
use crate::experiments::{self, Experiment, cells};
use crate::measure::{Cell, Row, Source, Variant};
use crate::plan::{Plan, Store, read_rows};
use crate::report::{self, Method};
use crate::study;

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
    /// Sizes of the kinds of --data; without it the experiment's cells of these sizes alone.
    #[arg(long, value_delimiter = ',')]
    sizes: Vec<usize>,
    /// A `.poly` file besides, without edges that cross; may be repeated.
    #[arg(long)]
    file: Vec<PathBuf>,
    /// Runs Triangle too, Shewchuk's program, which is here (table1 only).
    #[arg(long, value_name = "PROGRAM")]
    triangle: Option<PathBuf>,
    /// The first seed of the kinds of --data; of a --file the images, 1 to 8, under the symmetries of the square.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many seeds.
    #[arg(long, default_value_t = 1)]
    seeds: u64,
    /// How often each variant is timed on each input: an odd number has a median, 0 only counts.
    #[arg(long, default_value_t = 3)]
    repetitions: usize,
    /// Counts instructions, mispredicted branches and cache misses of one turn, too, by Valgrind's Cachegrind.
    #[arg(long)]
    cachegrind: bool,
    /// Compares all counts with a CSV file of counts that an earlier run wrote.
    #[arg(long, value_name = "CSV")]
    compare: Option<PathBuf>,
    /// Lists the cells with their numbers.
    #[arg(long)]
    cells: bool,
    /// Runs this cell alone, and writes no report.
    #[arg(long, conflicts_with = "cells")]
    cell: Option<usize>,
    /// Writes the report of cells that have run before, maybe at another commit.
    #[arg(long, conflicts_with_all = ["cells", "cell"])]
    merge: bool,
    /// Of `turn`, which Cachegrind runs.
    #[arg(long, hide = true)]
    variant: Option<String>,
    #[arg(long, hide = true, default_value_t = 1)]
    turns: usize,
}

/// All experiments.
const ALL: &[Experiment] = &[
    experiments::FRONTS,
    experiments::HOLD_OUT,
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
        "Experiments:\n{}\n  {:12} {}\n\nKinds of data:\n{}",
        list(experiments.collect()),
        "paper",
        "Numbers and figures of the paper, from the CSV files in --out",
        list(kinds.collect())
    )
}

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Does what the command line says, with these structures.
///
/// # Errors
/// Each is a line for the user.
pub(crate) fn run(command: Command, contestants: &[Contestant]) -> Result<()> {
    let Command { name, options } = command;
    if name == "turn" {
        return turns(&options, contestants);
    }
    let default = || PathBuf::from("target/experiments").join(&name);
    let folder = options.out.clone().unwrap_or_else(default);
    if name == "paper" {
        return study::write_all(&folder);
    }
    let experiment = ALL.iter().find(|experiment| experiment.name == name);
    let experiment = experiment.ok_or(format!("no experiment {name}; --help lists them"))?;
    let mut variants = (experiment.variants)(contestants);
    if let Some(program) = &options.triangle {
        if name != experiments::TABLE_1.name {
            return Err("only table1 takes --triangle".into());
        }
        variants.push(Variant::triangle(program));
    }
    let plan = Plan {
        experiment: *experiment,
        cells: chosen_cells(experiment, &options)?,
        variants,
        repetitions: options.repetitions,
        cachegrind: options.cachegrind,
        commit: report::commit(),
    };
    if plan.cells.is_empty() {
        return Err(format!("{name} has no such input; holdout needs --file").into());
    }
    if options.cells {
        for (number, cell) in plan.cells.iter().enumerate() {
            println!("{number} {}", Plan::line(cell));
        }
        return Ok(());
    }
    if options.merge {
        let (store, commit) = Store::reopen(&folder, &plan)?;
        write_report(&Plan { commit, ..plan }, &store)?;
    } else {
        let store = Store::open(&folder, &plan)?;
        match options.cell {
            Some(number) => return run_cell(&plan, &store, number),
            None => run_all(&plan, &store)?,
        }
    }
    match options.compare {
        Some(path) => compare(&read_rows(&folder.join(format!("{name}.csv")))?, &path),
        None => Ok(()),
    }
}

/// Runs a structure so many times on one input, for [`Cell::cachegrind`].
fn turns(options: &Options, contestants: &[Contestant]) -> Result<()> {
    let name = options.variant.as_deref().unwrap_or_default();
    let contestant = contestants
        .iter()
        .find(|contestant| contestant.name() == name);
    let variant = Variant::structure(contestant.ok_or(format!("no structure {name}"))?);
    let cell = own_cells(options)?.pop().ok_or("no input")?;
    let input = cell.input();
    for _ in 0..options.turns {
        variant.time(&input)?;
    }
    Ok(())
}

/// Compares the counts of these rows with those in a file, which may have more rows.
fn compare(rows: &[Row], path: &Path) -> Result<()> {
    let kept = read_rows(path)?;
    let key = |row: &Row| (row.data.clone(), row.size, row.seed, row.variant.clone());
    for row in rows {
        let of_platform = |row: &Row| Row {
            turns: Vec::new(),
            instructions: None,
            mispredicted: None,
            first_misses: None,
            second_misses: None,
            built: String::new(),
            ..row.clone()
        };
        let found = kept.iter().find(|other| key(other) == key(row));
        let found = found.map(of_platform);
        if found != Some(of_platform(row)) {
            let Row {
                data,
                size,
                seed,
                variant,
                ..
            } = row;
            let what = if found.is_none() {
                "is not there"
            } else {
                "has other counts"
            };
            return Err(format!(
                "{}: {variant} on {data} {size}, seed {seed}, {what}",
                path.display()
            )
            .into());
        }
    }
    println!(
        "{}: {} rows have the same counts",
        path.display(),
        rows.len()
    );
    Ok(())
}

/// The cells of the command line, or the experiment's with the files of the command line.
fn chosen_cells(experiment: &Experiment, options: &Options) -> Result<Vec<Cell>> {
    let mut chosen = own_cells(options)?;
    if options.data.is_empty() {
        let is_chosen =
            |cell: &Cell| options.sizes.is_empty() || options.sizes.contains(&cell.size);
        let own = (experiment.cells)(options.quick).into_iter();
        chosen.splice(0..0, own.filter(is_chosen));
    }
    Ok(chosen)
}

/// The cells of `--data` with `--sizes`, and of `--file`.
fn own_cells(options: &Options) -> Result<Vec<Cell>> {
    for name in &options.data {
        kind(name)?;
    }
    let names: Vec<&str> = options.data.iter().map(String::as_str).collect();
    let seeds = options.seed..=options.seed.saturating_add(options.seeds.saturating_sub(1));
    let mut chosen = cells(&names, &options.sizes, seeds.clone());
    for path in &options.file {
        // Refused now, not after the other cells have run.
        File::open(path).map_err(|error| format!("{}: {error}", path.display()))?;
        chosen.extend(seeds.clone().map(|seed| Cell {
            source: Source::File(path.clone()),
            size: 0,
            seed,
        }));
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
    let mut rows = cell.run(&plan.variants, plan.repetitions, &plan.commit)?;
    if plan.cachegrind {
        for row in &mut rows {
            cell.cachegrind(row)?;
        }
    }
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
