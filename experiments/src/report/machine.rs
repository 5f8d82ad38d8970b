//! Where and with what was measured.

use std::fs;
use std::process::Command;
use std::thread::available_parallelism;

/// The processor, the system and the compiler, as far as they can be told.
pub(super) fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_owned())
    });
    let cores = available_parallelism().map_or(1, usize::from);
    let (system, architecture) = (std::env::consts::OS, std::env::consts::ARCH);
    let model = model.unwrap_or_else(|| "an unknown processor".to_owned());
    format!("{model}, {cores} cores, {architecture}, {system}")
}

/// The compiler of this program.
pub(super) fn compiler() -> &'static str {
    env!("COMPILER")
}

/// The commit of the sources, if they are in a repository and Git is there.
pub(crate) fn commit() -> String {
    let output = Command::new("git")
        .args(["describe", "--always", "--dirty", "--abbrev=12"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    match output {
        Ok(output) if output.status.success() => {
            String::from_utf8_lossy(&output.stdout).trim().to_owned()
        }
        _ => "unknown".to_owned(),
    }
}
