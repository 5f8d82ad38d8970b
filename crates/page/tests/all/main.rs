//! The page that computes: the same files as the command writes, and what a visitor does, in a real browser.
//!
//! The program is built first, for `wasm32-wasip1`. Where that target, `node` or Chromium is missing, the tests that
//! need it print so and pass; in continuous integration, where `CI` is `true`, they fail.

#[expect(dead_code, reason = "the tests of the page of steps use all of it")]
#[path = "../../../draw/tests/page/browser.rs"]
mod browser;
mod bytes;
mod visit;
mod visitor;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use sweep_cdt_page::TARGET;

/// The program, built once; nothing where the target is not installed.
fn program() -> Option<&'static Path> {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    let build = || {
        let query = ["--print", "target-libdir", "--target", TARGET];
        let output = Command::new("rustc").args(query).output();
        let folder = output.expect("there is rustc where there is cargo").stdout;
        if !Path::new(String::from_utf8_lossy(&folder).trim()).is_dir() {
            return skipped(&format!(
                "the standard library of {TARGET} is not installed"
            ));
        }
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/page");
        Some(sweep_cdt_page::build_program(&folder).expect("the program builds"))
    };
    PROGRAM.get_or_init(build).as_deref()
}

/// Nothing, and the reason printed.
fn skipped<T>(reason: &str) -> Option<T> {
    let is_ci = std::env::var_os("CI").is_some_and(|value| value == "true");
    assert!(!is_ci, "{reason}");
    eprintln!("skipped: {reason}");
    None
}

/// The command, run in the folder of the repository's examples of files.
fn command(folder: &Path, arguments: &str) -> Vec<u8> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../Cargo.toml");
    let output = Command::new(env!("CARGO"))
        .current_dir(folder)
        .args([
            "run",
            "--quiet",
            "--locked",
            "--profile",
            "test",
            "--bin",
            "sweep-cdt",
        ])
        .arg("--manifest-path")
        .args([manifest.as_os_str(), "--".as_ref()])
        .args(arguments.split_whitespace())
        .output()
        .expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stderr);
    // Steps up to a crossing are written, and then it fails.
    let is_written = output.status.success() || !output.stdout.is_empty();
    assert!(is_written, "{arguments}: {said}");
    output.stdout
}
