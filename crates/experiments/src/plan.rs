//! A plan: an experiment with its cells, variants and repetitions; and the folder of its results: the plan, two CSV files
//! for each cell that has run, of counts and of turns, and two of all cells.
//!
//! The plan says what a folder of results holds, so that an interrupted run goes on with what is missing, and
//! never mixes two plans. Files are written under another name and renamed, so that a file that is there is
//! whole, however the program ended. Several programs may work on cells of one folder.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::experiments::Experiment;
use crate::measure::{Cell, Row, Turn, Variant};

#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) experiment: Experiment,
    pub(crate) cells: Vec<Cell>,
    pub(crate) variants: Vec<Variant>,
    pub(crate) repetitions: usize,
    /// Whether a turn of each variant runs under Cachegrind, too.
    pub(crate) cachegrind: bool,
    pub(crate) commit: String,
}

impl Plan {
    /// A line for a cell.
    pub(crate) fn line(cell: &Cell) -> String {
        let size = if cell.size == 0 {
            String::new()
        } else {
            format!(" {}", cell.size)
        };
        format!("{}{size} seed {}", cell.data(), cell.seed)
    }

    /// The whole plan as text.
    pub(crate) fn text(&self) -> String {
        self.text_at(&self.commit)
    }

    /// The plan's text as it would be at another commit.
    pub(crate) fn text_at(&self, commit: &str) -> String {
        let mut text = format!(
            "experiment {}\ncommit {}\nrepetitions {}\ncachegrind {}\n",
            self.experiment.name, commit, self.repetitions, self.cachegrind
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

    /// The file of a cell's counts; that of its turns has `-turns` in its name.
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
            rows.extend(read_rows(&self.cell(number))?);
        }
        let name = format!("{}.csv", plan.experiment.name);
        write_rows(&self.folder.join(name), &rows)?;
        Ok(rows)
    }
}

/// The file of the turns beside a file of counts.
fn turns(path: &Path) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-turns.csv"))
}

/// Rows with their turns.
///
/// # Errors
/// If one of the two files cannot be read.
pub(crate) fn read_rows(path: &Path) -> Result<Vec<Row>> {
    let mut rows: Vec<Row> = read(path)?;
    let mut at = 0;
    for turn in read::<Turn>(&turns(path))? {
        // Turns are in the order of the rows.
        while !turn.is_of(
            rows.get(at)
                .ok_or(format!("{}: a turn of no row", path.display()))?,
        ) {
            at += 1;
        }
        rows[at].turns.push(turn);
    }
    Ok(rows)
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>> {
    let reader =
        csv::Reader::from_path(path).map_err(|error| format!("{}: {error}", path.display()));
    Ok(reader?
        .into_deserialize()
        .collect::<std::result::Result<_, _>>()?)
}

/// Writes the turns first: where the counts are, the turns are, too.
fn write_rows(path: &Path, rows: &[Row]) -> Result<()> {
    write(&turns(path), rows.iter().flat_map(|row| &row.turns))?;
    write(path, rows)
}

/// Writes a CSV file.
pub(crate) fn write<'a, T: Serialize + 'a>(
    path: &Path,
    all: impl IntoIterator<Item = &'a T>,
) -> Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for one in all {
        writer.serialize(one)?;
    }
    write_whole(path, &writer.into_inner()?)
}

fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let part = path.with_extension(format!("{}.part", std::process::id()));
    fs::write(&part, bytes)?;
    Ok(fs::rename(part, path)?)
}
