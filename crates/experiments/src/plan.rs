//! A plan: an experiment with its cells, variants, seed and repetitions; and the folder of its results: the
//! plan, a CSV file for each cell that has run, and one of all rows.
//!
//! The plan says what a folder of results holds, so that an interrupted run goes on with what is missing, and
//! never mixes two plans. Files are written under another name and renamed, so that a file that is there is
//! whole, however the program ended. Several programs may work on cells of one folder.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::experiments::Experiment;
use crate::measure::{Cell, Row, Variant};
use crate::report::commit;

#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) experiment: Experiment,
    pub(crate) cells: Vec<Cell>,
    pub(crate) variants: Vec<Variant>,
    pub(crate) seed: u64,
    pub(crate) repetitions: usize,
    pub(crate) commit: String,
}

impl Plan {
    /// The plan of an experiment with these cells and variants, at the present commit.
    pub(crate) fn new(
        experiment: Experiment,
        cells: Vec<Cell>,
        variants: Vec<Variant>,
        seed: u64,
        repetitions: usize,
    ) -> Plan {
        Plan {
            experiment,
            cells,
            variants,
            seed,
            repetitions,
            commit: commit(),
        }
    }

    /// A line for a cell.
    pub(crate) fn line(cell: &Cell) -> String {
        if cell.size == 0 {
            cell.data()
        } else {
            format!("{} {}", cell.data(), cell.size)
        }
    }

    /// The whole plan as text.
    pub(crate) fn text(&self) -> String {
        self.text_at(&self.commit)
    }

    /// The plan's text as it would be at another commit.
    pub(crate) fn text_at(&self, commit: &str) -> String {
        let mut text = format!(
            "experiment {}\ncommit {}\nseed {}\nrepetitions {}\n",
            self.experiment.name, commit, self.seed, self.repetitions
        );
        for variant in &self.variants {
            let _ = writeln!(text, "variant {}", variant.name);
        }
        for cell in &self.cells {
            let _ = writeln!(text, "cell {}", Plan::line(cell));
        }
        text
    }
}

/// The folder of results.
#[derive(Debug)]
pub(crate) struct Store {
    pub(crate) folder: PathBuf,
}

type Result<T> = std::result::Result<T, Box<dyn Error>>;

impl Store {
    /// The results of this plan in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If the folder holds results of another plan.
    pub(crate) fn open(folder: &Path, plan: &Plan) -> Result<Store> {
        let store = Store {
            folder: folder.to_owned(),
        };
        fs::create_dir_all(folder.join("cells"))
            .map_err(|error| format!("{}: {error}", folder.display()))?;
        let path = folder.join("plan.txt");
        match fs::read_to_string(&path) {
            Ok(found) => store.compare(&found, &plan.text())?,
            Err(_) => write_whole(&path, plan.text().as_bytes())?,
        }
        Ok(store)
    }

    /// The results of this plan in a folder where it has run, maybe at another commit, and that commit.
    ///
    /// # Errors
    /// If the folder holds none, or those of another plan.
    pub(crate) fn reopen(folder: &Path, plan: &Plan) -> Result<(Store, String)> {
        let store = Store {
            folder: folder.to_owned(),
        };
        let path = folder.join("plan.txt");
        let found =
            fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let commit = found.lines().find_map(|line| line.strip_prefix("commit "));
        let commit = commit.unwrap_or("unknown").to_owned();
        store.compare(&found, &plan.text_at(&commit))?;
        Ok((store, commit))
    }

    /// Refuses a plan that is not the one found in the folder.
    fn compare(&self, found: &str, text: &str) -> Result<()> {
        if found == text {
            return Ok(());
        }
        let differs = |line: &&str| !found.lines().any(|other| other == *line);
        let line = text.lines().find(differs);
        Err(format!(
            "{} holds results of another plan (now: {}); name another folder or remove it",
            self.folder.display(),
            line.unwrap_or("fewer cells or variants")
        )
        .into())
    }

    fn cell(&self, number: usize) -> PathBuf {
        self.folder.join("cells").join(format!("{number:04}.csv"))
    }

    /// Whether a cell has run.
    pub(crate) fn has(&self, number: usize) -> bool {
        self.cell(number).exists()
    }

    /// Keeps the rows of a cell.
    pub(crate) fn keep(&self, number: usize, rows: &[Row]) -> Result<()> {
        write_rows(&self.cell(number), rows)
    }

    /// The rows of all cells of the plan, which are then in one file, too.
    pub(crate) fn gather(&self, plan: &Plan) -> Result<Vec<Row>> {
        let missing: Vec<String> = (0..plan.cells.len())
            .filter(|&number| !self.has(number))
            .map(|number| number.to_string())
            .collect();
        if !missing.is_empty() {
            return Err(format!("cells that have not run: {}", missing.join(", ")).into());
        }
        let mut rows = Vec::new();
        for number in 0..plan.cells.len() {
            for row in csv::Reader::from_path(self.cell(number))?.deserialize() {
                rows.push(row?);
            }
        }
        let name = format!("{}.csv", plan.experiment.name);
        write_rows(&self.folder.join(name), &rows)?;
        Ok(rows)
    }
}

fn write_rows(path: &Path, rows: &[Row]) -> Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    write_whole(path, &writer.into_inner()?)
}

fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let part = path.with_extension(format!("{}.part", std::process::id()));
    fs::write(&part, bytes)?;
    Ok(fs::rename(part, path)?)
}
