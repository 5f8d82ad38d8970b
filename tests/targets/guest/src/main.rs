//! Runs the cases and compares them with the report of another machine.
//!
//! A program for `wasm32-unknown-unknown` has no output, only the number that `main` returns: 0 if all
//! lines are the same, else the number of the first line that differs, counted from 1.

#[path = "../../cases.rs"]
mod cases;

use std::process::ExitCode;

/// The report of the machine that built this program.
const EXPECTED: &str = include_str!(env!("SWEEP_CDT_EXPECTED"));

fn main() -> ExitCode {
    let found = cases::report();
    let same = found
        .iter()
        .zip(EXPECTED.lines())
        .take_while(|(a, b)| a == b);
    let same = same.count();
    if same == found.len() && same == EXPECTED.lines().count() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(u8::try_from(same + 1).unwrap_or(u8::MAX))
    }
}
