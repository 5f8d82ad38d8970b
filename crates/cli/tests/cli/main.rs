//! The command `sweep-cdt`, run as a user runs it: formats, settings, errors, what is left behind.

mod advice;
mod bands;
mod bent;
mod bounds;
#[cfg(feature = "las")]
mod clouds;
mod crossings;
mod depths;
mod documents;
mod errors;
mod formats;
mod generate;
mod inside;
mod interiors;
mod layers;
mod losses;
mod matching;
mod outputs;
#[cfg(unix)]
mod places;
mod record;
mod refine;
mod refuted;
mod remarks;
mod replay;
mod reported;
mod reports;
mod runs;
mod statistics;
#[cfg(target_os = "linux")]
mod stopped;
mod stream;
mod stream_certificates;
#[cfg(target_os = "linux")]
mod stream_memory;
mod stream_outputs;
mod stream_refused;
mod stream_terrain;
mod stream_tiles;
mod stream_verify;
mod terrain;
mod texts;
mod trace;
mod verify;
mod voronoi;

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

const FORMATS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/formats");
const CONTOURS: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../tests/data/isolines_small.poly"
);

fn sweep_cdt(folder: impl AsRef<Path>, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sweep-cdt"));
    command
        .current_dir(folder)
        .args(arguments.split_whitespace());
    command
}

fn command(folder: impl AsRef<Path>, arguments: &str) -> Command {
    sweep_cdt(folder, &format!("triangulate {arguments}"))
}

fn run(folder: impl AsRef<Path>, arguments: &str) -> Output {
    command(folder, arguments)
        .output()
        .expect("the command starts")
}

fn run_with_input(arguments: &str, input: &[u8]) -> Output {
    feed(&mut command(FORMATS, arguments), input)
}

/// Runs a command with this on its standard input.
fn feed(command: &mut Command, input: &[u8]) -> Output {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    child
        .stdin
        .take()
        .expect("a pipe")
        .write_all(input)
        .expect("the command reads its input");
    child.wait_with_output().expect("the command ends")
}

/// Does what would wait for ever if the command were wrong.
#[cfg(unix)]
#[track_caller]
fn in_time<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    let (send, receive) = std::sync::mpsc::channel();
    std::thread::spawn(move || send.send(work()));
    let done = receive.recv_timeout(std::time::Duration::from_secs(30));
    done.expect("half a minute is enough")
}

/// The words that a successful run prints, which has nothing else to say.
#[track_caller]
fn printed(output: &Output) -> &str {
    assert_eq!(text(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
    text(&output.stdout)
}

/// The words that a successful run prints. Beside them it may note what is ignored or not written.
#[track_caller]
fn printed_despite_losses(output: &Output) -> &str {
    assert_eq!(without_losses(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
    text(&output.stdout)
}

/// What standard error has beside notes about what is ignored or not written.
fn without_losses(stderr: &[u8]) -> String {
    let is_loss = |line: &&str| {
        let is_said = line.contains(": ignored: ") || line.contains(": not written: ");
        line.starts_with("note: ") && is_said
    };
    let others = text(stderr).lines().filter(|line| !is_loss(line));
    others.map(|line| format!("{line}\n")).collect()
}

/// The words that a run prints, which says in a note why it has no triangles.
#[track_caller]
fn printed_without_triangles(output: &Output) -> &str {
    let note = text(&output.stderr);
    assert!(
        note.starts_with("note: ") && note.contains(": no triangles") && note.lines().count() == 1,
        "{note}"
    );
    assert_eq!(output.status.code(), Some(0));
    text(&output.stdout)
}

/// Asserts that a run ends with just this error and exit status 1.
#[track_caller]
fn assert_fails(output: &Output, error: &str) {
    assert_eq!(text(&output.stderr), format!("error: {error}\n"));
    assert_eq!(text(&output.stdout), "");
    assert_eq!(output.status.code(), Some(1));
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("text")
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("a plain name");
    let mut names: Vec<String> = entries
        .map(|entry| name(entry.expect("an entry")))
        .collect();
    names.sort();
    names
}

/// A folder with these files in it.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    for (name, contents) in files {
        fs::write(folder.path().join(name), contents).expect("a file");
    }
    folder
}
