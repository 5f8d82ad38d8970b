//! Faults of other programs: how many of each kind, and small inputs that show them.
//!
//! With the environment variable `SWEEP_CDT_PEER_FAULTS` set to a folder, each process writes its counts
//! there from time to time, and for the first inputs of each kind a row of the table of cases, minimized.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use super::quiet::quietly;
use sweep_cdt_testing::Input;
use sweep_cdt_testing::minimize::minimize;

/// So many inputs of a kind are written.
const SHOWN: u64 = 3;
/// So many answers pass between two writings of the counts.
const WRITE: u64 = 4096;

/// How often each program had each fault, or none.
static COUNTS: Mutex<BTreeMap<(&str, &str), u64>> = Mutex::new(BTreeMap::new());

/// Counts an answer, and shows its fault if `SWEEP_CDT_PEER_FAULTS` asks for it; `again` finds the fault
/// of smaller inputs.
pub(super) fn count(
    input: &Input,
    program: &'static str,
    fault: Option<&'static str>,
    again: &dyn Fn(&Input) -> Option<&'static str>,
) {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder =
        FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_PEER_FAULTS").map(PathBuf::from));
    let (Some(folder), Ok(mut counts)) = (folder, COUNTS.lock()) else {
        return;
    };
    let count = counts
        .entry((program, fault.unwrap_or("right")))
        .or_default();
    *count += 1;
    // A report that cannot be written must not stop a campaign.
    if let Some(fault) = fault
        && *count <= SHOWN
    {
        let is_other = |input: &Input| assert_ne!(again(input), Some(fault));
        let least = quietly(|| minimize(&is_other, input));
        let _ = show(folder, program, fault, &least);
    }
    if counts.values().sum::<u64>() % WRITE == 1 {
        let rows = counts.iter();
        let text: String = rows
            .map(|((program, fault), count)| format!("{program}\t{fault}\t{count}\n"))
            .collect();
        let _ = fs::write(folder.join(format!("{}.tsv", std::process::id())), text);
    }
}

/// Adds a row to the file of this kind.
fn show(folder: &Path, program: &str, fault: &str, least: &Input) -> std::io::Result<()> {
    let name = format!("{program}-{fault}-{}.txt", std::process::id());
    let mut file = fs::File::options()
        .append(true)
        .create(true)
        .open(folder.join(name))?;
    writeln!(file, "{least}")
}
