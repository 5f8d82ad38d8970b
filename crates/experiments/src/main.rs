//! The experiments with the standard structures.

use std::process::ExitCode;

fn main() -> ExitCode {
    sweep_cdt_experiments::main_with([])
}
