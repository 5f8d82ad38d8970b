//! The folder of results: the plan, a CSV file for each cell that has run, and one of all rows.
//!
//! Files are written under another name and renamed, so that a file that is there is whole, however the
//! program ended. Several programs may work on cells of one folder.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use crate::measure::Row;
use crate::plan::Plan;

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
        let (path, text) = (folder.join("plan.txt"), plan.text());
        match fs::read_to_string(&path) {
            Ok(found) if found == text => {}
            Ok(found) => {
                let differs = |line: &&str| !found.lines().any(|other| other == *line);
                let line = text
                    .lines()
                    .find(differs)
                    .unwrap_or("fewer cells or variants");
                return Err(format!(
                    "{} holds results of another plan (now: {line}); name another folder or remove it",
                    folder.display()
                )
                .into());
            }
            Err(_) => write_whole(&path, text.as_bytes())?,
        }
        Ok(store)
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
