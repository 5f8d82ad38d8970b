//! The library on other targets: the same triangles, steps and errors as on this one.
//!
//! The program of this package is built for the target, with the report of this machine in it, and run by
//! an emulator. Where the target's standard library or the emulator is missing, the test prints so and
//! passes; in continuous integration, where `CI` is `true`, it fails.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use sweep_cdt_targets::report;

/// Runs a program for wasm32-unknown-unknown and ends with the status that its `main` returns.
const RUN_WASM: &str = r#"
import { readFile } from "node:fs/promises";

const { instance } = await WebAssembly.instantiate(await readFile(process.argv[1]), {});
process.exitCode = instance.exports.main(0, 0);
"#;

/// 32 bits, and neither a clock nor threads. `rustup target add wasm32-unknown-unknown` installs it.
#[test]
fn wasm_has_the_same_results() {
    let mut node = Command::new("node");
    node.args(["--input-type=module", "--eval", RUN_WASM]);
    compare("wasm32-unknown-unknown", node, ".wasm");
}

/// Bytes in the other order. `rustup target add s390x-unknown-linux-gnu` and Debian's packages
/// `gcc-s390x-linux-gnu`, `libc6-dev-s390x-cross` and `qemu-user` install it.
#[test]
fn a_big_endian_machine_has_the_same_results() {
    let mut qemu = Command::new("qemu-s390x");
    qemu.args(["-L", "/usr/s390x-linux-gnu"]);
    compare("s390x-unknown-linux-gnu", qemu, "");
}

/// Builds the program for `target` and runs it by `emulator`.
#[track_caller]
fn compare(target: &str, mut emulator: Command, extension: &str) {
    if let Some(reason) = missing(target, &emulator) {
        let is_ci = env::var_os("CI").is_some_and(|value| value == "true");
        assert!(!is_ci, "{reason}");
        eprintln!("skipped: {reason}");
        return;
    }
    let report = report();
    let program = build(target, &report).join(format!("sweep-cdt-targets{extension}"));
    let output = emulator.arg(program).output().expect("an emulator");
    let status = output.status.code();
    let line = status.and_then(|line| usize::try_from(line).ok()?.checked_sub(1));
    let case = line.and_then(|line| report.get(line));
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(status, Some(0), "not as here: {case:?}, {said}");
}

/// Why the test cannot run here.
fn missing(target: &str, emulator: &Command) -> Option<String> {
    let program = emulator.get_program();
    if Command::new(program).arg("--version").output().is_err() {
        return Some(format!("{} is not installed", program.display()));
    }
    let query = ["--print", "target-libdir", "--target", target];
    let output = Command::new("rustc").args(query).output();
    let folder = output.expect("there is rustc where there is cargo").stdout;
    let folder = PathBuf::from(String::from_utf8_lossy(&folder).trim());
    (!folder.is_dir()).then(|| format!("the standard library of {target} is not installed"))
}

/// Builds the program with the report in it, and returns the folder that it is in.
fn build(target: &str, report: &[String]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(target);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo.args(["build", "--profile", "test", "--locked", "--target", target]);
    cargo.arg("--target-dir").arg(&folder);
    cargo.env("SWEEP_CDT_EXPECTED", report.join("\n"));
    let linker = "CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER";
    cargo.env(linker, "s390x-linux-gnu-gcc");
    assert!(cargo.status().expect("cargo runs").success(), "cargo build");
    folder.join(target).join("debug")
}
