//! Instructions, mispredicted branches and cache misses of a turn, counted by Valgrind's Cachegrind (`--cachegrind`).
//!
//! The program runs itself under Cachegrind twice, with two turns of a structure on the input and with one; the
//! difference is a turn in warm memory, without making the input. Caches are simulated with the sizes of [`CACHES`],
//! whatever the machine has. So the counts depend on the compiler, the C library and the target alone, which are named
//! in their row, and hardly on the machine or its load.

use std::error::Error;
use std::fs;
use std::process::Command;

use super::{Cell, Row, Source};

/// First level of data and of instructions, and second level: bytes, ways, bytes a line.
const CACHES: [&str; 3] = ["--D1=32768,8,64", "--I1=32768,8,64", "--LL=1048576,16,64"];

/// What Cachegrind counted, by the names of its events.
type Events = Vec<(String, u64)>;

impl Cell {
    /// Fills in the columns of this variant's row.
    ///
    /// # Errors
    /// If `valgrind` does not run, or the variant is no structure that this program knows by its name.
    pub(crate) fn cachegrind(&self, row: &mut Row) -> Result<(), Box<dyn Error>> {
        if row.is_left_out {
            return Ok(());
        }
        let [two, one] = [2, 1].map(|turns| self.events(&row.variant, turns));
        let (two, one) = (two?, one?);
        let of = |names: &[&str]| {
            let sum = |events: &Events| -> u64 {
                let counted = events
                    .iter()
                    .filter(|(name, _)| names.contains(&name.as_str()));
                counted.map(|&(_, count)| count).sum()
            };
            Some(sum(&two).saturating_sub(sum(&one)))
        };
        row.instructions = of(&["Ir"]);
        row.mispredicted = of(&["Bcm", "Bim"]);
        row.first_misses = of(&["D1mr", "D1mw"]);
        row.second_misses = of(&["ILmr", "DLmr", "DLmw"]);
        row.built = [
            env!("COMPILER"),
            &library(),
            env!("TARGET"),
            &CACHES.join(" "),
        ]
        .join("; ");
        Ok(())
    }

    /// The events of this program with so many turns.
    fn events(&self, variant: &str, turns: usize) -> Result<Events, Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let out = folder.path().join("out");
        let mut command = Command::new("valgrind");
        command
            .args([
                "--quiet",
                "--tool=cachegrind",
                "--cache-sim=yes",
                "--branch-sim=yes",
            ])
            .args(CACHES)
            .arg(format!("--cachegrind-out-file={}", out.display()))
            .arg(std::env::current_exe()?)
            .args(["turn", "--variant", variant, "--turns", &turns.to_string()])
            .args(["--seed", &self.seed.to_string()]);
        match &self.source {
            Source::Kind(kind) => {
                command.args(["--data", kind.name, "--sizes", &self.size.to_string()])
            }
            Source::File(path) => command.arg("--file").arg(path),
        };
        let output = command
            .output()
            .map_err(|error| format!("valgrind: {error}"))?;
        if !output.status.success() {
            return Err(format!("valgrind: {}", String::from_utf8_lossy(&output.stderr)).into());
        }
        let text = fs::read_to_string(out)?;
        let line = |key: &str| {
            let found = text.lines().find_map(|line| line.strip_prefix(key));
            found.ok_or(format!("Cachegrind wrote no line `{key}`"))
        };
        let counts = line("summary: ")?.split_whitespace().map(str::parse);
        let names = line("events: ")?.split_whitespace().map(str::to_owned);
        Ok(names
            .zip(counts.collect::<Result<Vec<u64>, _>>()?)
            .collect())
    }
}

/// The C library, as far as it can be told.
fn library() -> String {
    let output = Command::new("getconf").arg("GNU_LIBC_VERSION").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.ok()
        .filter(|text| !text.is_empty())
        .unwrap_or_else(|| "an unknown C library".to_owned())
}
