//! Runs that are stopped: by signals, by limits, by a full disk. None leaves a file behind.
//!
//! `env`, `kill`, `mkfifo`, `prlimit`, `setpriv` and `unshare` do what no safe Rust can.

use std::fs::{self, File};
use std::io::{Read, sink};
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Output, Stdio};

use tempfile::TempDir;

use crate::{CONTOURS, assert_fails, folder, in_time, names, text, without_losses};

const TRIANGLE: &str = r#"{"points": [[0, 0], [1, 0], [0, 1]]}"#;
const SIGNALS: [(&str, i32); 4] = [("HUP", 1), ("INT", 2), ("QUIT", 3), ("TERM", 15)];

/// The command, run by a program of the system, which gets these arguments.
fn by(program: &str, own: &[&str], folder: &TempDir, arguments: &str) -> Command {
    let mut command = Command::new(program);
    command
        .current_dir(folder)
        .args(own)
        .arg(env!("CARGO_BIN_EXE_sweep-cdt"))
        .args(arguments.split_whitespace())
        .env("RUST_BACKTRACE", "0");
    command
}

fn output(mut command: Command) -> Output {
    command.output().expect("a program of the system")
}

/// A run that has completed its files, and writes to a FIFO that is read no further than its first byte.
fn waiting(folder: &TempDir, signals: &str) -> (Child, File) {
    let fifo = folder.path().join("f");
    let made = Command::new("mkfifo").arg(&fifo).status();
    assert!(made.expect("mkfifo").success());
    let arguments =
        format!("triangulate {CONTOURS} -o old.svg -o new.ele -o f --output-format json");
    let child = by("prlimit", &["--core=0", "env", signals], folder, &arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let reader = in_time(|| {
        let mut reader = File::open(fifo).expect("a FIFO");
        reader.read_exact(&mut [0]).expect("a byte");
        reader
    });
    (child, reader)
}

fn send(signal: &str, child: &Child) {
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-s", signal, &id]).status();
    assert!(sent.expect("kill").success());
}

fn assert_unchanged(folder: &TempDir, others: &[&str]) {
    let old = fs::read_to_string(folder.path().join("old.svg"));
    assert_eq!(old.expect("a file"), "old");
    let mut expected = [others, &["old.svg"]].concat();
    expected.sort_unstable();
    assert_eq!(names(folder.path()), expected);
}

#[test]
fn a_signal_ends_a_run_in_one_line_and_leaves_no_file() {
    for (name, number) in SIGNALS {
        let folder = folder(&[("old.svg", "old")]);
        let (child, reader) = waiting(&folder, "--default-signal");
        send(name, &child);
        let output = child.wait_with_output().expect("the command ends");
        drop(reader);
        assert_eq!(output.status.signal(), Some(number), "{name}");
        let message = format!("error: stopped by SIG{name}; no file was changed\n");
        assert_eq!(text(&output.stderr), message);
        assert_unchanged(&folder, &["f"]);
    }
}

#[test]
fn a_run_that_is_killed_leaves_no_file() {
    let folder = folder(&[("old.svg", "old")]);
    let (child, reader) = waiting(&folder, "--default-signal");
    send("KILL", &child);
    let output = child.wait_with_output().expect("the command ends");
    drop(reader);
    assert_eq!(output.status.signal(), Some(9));
    assert_unchanged(&folder, &["f"]);
}

/// Whether a process has an open file without a name in this folder.
fn has_unnamed_file(child: &Child, folder: &TempDir) -> bool {
    let open = fs::read_dir(format!("/proc/{}/fd", child.id()));
    let links = open.into_iter().flatten().flatten();
    let mut files = links.filter_map(|link| fs::read_link(link.path()).ok());
    files.any(|file| {
        let is_unnamed = file.to_string_lossy().ends_with(" (deleted)");
        is_unnamed && file.starts_with(folder)
    })
}

/// A stream that is ended while it writes a file: all of the file is there, or nothing.
#[test]
fn a_stream_that_is_ended_leaves_no_file() {
    for (name, number) in [("TERM", 15), ("KILL", 9)] {
        let folder = folder(&[("old.u64", "old")]);
        fs::create_dir(folder.path().join("temporary")).expect("a folder");
        let options = "--memory 600K --temporary temporary --window 100";
        let arguments = format!("stream {CONTOURS} {options} -o old.u64");
        let mut child = by("env", &["--default-signal"], &folder, &arguments)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        while !has_unnamed_file(&child, &folder) && matches!(child.try_wait(), Ok(None)) {
            std::thread::yield_now();
        }
        send(name, &child);
        let output = child.wait_with_output().expect("the command ends");
        assert_eq!(names(folder.path()), ["old.u64", "temporary"]);
        assert_eq!(names(&folder.path().join("temporary")), [""; 0]);
        let left = fs::read(folder.path().join("old.u64")).expect("a file");
        if output.status.success() {
            assert!(left.len() > 1_000_000 && left.len().is_multiple_of(24));
        } else {
            assert_eq!(output.status.signal(), Some(number));
            assert_eq!(left, b"old");
        }
    }
}

#[test]
fn signals_that_are_ignored_stay_so() {
    let folder = folder(&[("old.svg", "old")]);
    let (child, mut reader) = waiting(&folder, "--ignore-signal=HUP,INT");
    send("HUP", &child);
    send("INT", &child);
    in_time(move || std::io::copy(&mut reader, &mut sink()).expect("the rest"));
    let output = child.wait_with_output().expect("the command ends");
    assert_eq!(text(&output.stderr), "");
    assert!(output.status.success());
    assert_eq!(
        names(folder.path()),
        ["f", "new.ele", "new.node", "old.svg"]
    );
}

#[test]
fn a_file_beyond_the_limit_of_size_is_an_error() {
    let folder = folder(&[("old.svg", "old")]);
    for outputs in [
        "-o small.node -o old.svg",
        "-o old.svg -o new.json",
        "-o new.ele",
    ] {
        let arguments = format!("triangulate {CONTOURS} {outputs}");
        let output = output(by("prlimit", &["--fsize=10000"], &folder, &arguments));
        let error = text(&output.stderr);
        assert!(error.ends_with(": file too large\n"), "{error}");
        assert!(error.starts_with("error: "), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert_eq!(output.status.code(), Some(1));
        assert_unchanged(&folder, &[]);
    }
}

/// Runs a script in a folder where a small file system is mounted, if the system allows that.
fn on_a_small_disk(script: &str) -> Option<Output> {
    let folder = folder(&[]);
    let mount = format!("mount -t tmpfs -o size=64k none . && cd \"$PWD\" && {script}");
    for own in ["--mount", "-rm"] {
        let mut probe = Command::new("unshare");
        let probe = probe
            .args([own, "mount", "-t", "tmpfs", "none"])
            .arg(folder.path());
        if probe.output().is_ok_and(|output| output.status.success()) {
            let mut command = Command::new("unshare");
            command.current_dir(&folder).args([own, "sh", "-c", &mount]);
            return Some(output(command));
        }
    }
    println!("left out: no file system can be mounted here");
    None
}

#[test]
fn a_full_disk_leaves_the_files_as_they_were() {
    let command = env!("CARGO_BIN_EXE_sweep-cdt");
    for outputs in ["-o old.svg -o new.json", "-o new.obj -o new.ele -o old.svg"] {
        let script = format!(
            "echo old > old.svg; {command} triangulate {CONTOURS} {outputs}; echo $?; ls -A; cat old.svg"
        );
        let Some(output) = on_a_small_disk(&script) else {
            return;
        };
        let error = text(&output.stderr);
        assert!(error.starts_with("error: "), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert!(error.ends_with(": no space left on device\n"), "{error}");
        assert_eq!(text(&output.stdout), "1\nold.svg\nold\n");
    }
}

/// The output of a stream, and its temporary files, of which each alone fills the disk.
#[test]
fn a_stream_that_fills_the_disk_leaves_the_files_as_they_were() {
    let command = env!("CARGO_BIN_EXE_sweep-cdt");
    let bytes = "bytes of temporary files; another folder may have room for them";
    for (options, fault) in [
        ("", "error: old.u32: no space left on device\n"),
        ("--memory 200K --temporary .", bytes),
    ] {
        let stream = format!("{command} stream {CONTOURS} --window 1000 {options} -o old.u32");
        let script = format!("echo old > old.u32; {stream}; echo $?; ls -A; cat old.u32");
        let Some(output) = on_a_small_disk(&script) else {
            return;
        };
        let error = without_losses(&output.stderr);
        assert!(error.contains(fault), "{error}");
        assert!(error.contains(": no space left on device"), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
        assert_eq!(text(&output.stdout), "1\nold.u32\nold\n");
    }
}

/// Without `/proc` a file without a name cannot get one, and is copied.
#[test]
fn outputs_are_copied_where_no_name_can_be_given() {
    let command = env!("CARGO_BIN_EXE_sweep-cdt");
    let script = format!(
        "echo '{TRIANGLE}' > a.json; echo old > old.obj; chmod 640 old.obj; umask 027; \
         mount -t tmpfs none /proc; {command} triangulate a.json -o old.obj -o new.node; \
         stat -c '%a %n' *; cat old.obj new.node"
    );
    let Some(output) = on_a_small_disk(&script) else {
        return;
    };
    assert_eq!(text(&output.stderr), "");
    let expected = "644 a.json\n640 new.node\n640 old.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\
                    3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";
    assert_eq!(text(&output.stdout), expected);
}

/// What the command says where it fails in so many megabytes, which grow until it succeeds: one line each, and no file
/// appears or goes.
fn said_under_limits(
    folder: &TempDir,
    arguments: &str,
    megabytes: impl Iterator<Item = u64>,
) -> Vec<String> {
    let before = names(folder.path());
    let mut said = Vec::new();
    for megabytes in megabytes {
        let limit = format!("--as={}", megabytes << 20);
        let output = output(by("prlimit", &[&limit], folder, arguments));
        if output.status.success() {
            break;
        }
        assert_eq!(names(folder.path()), before);
        if output.status.code() == Some(1) {
            let error = text(&output.stderr);
            assert_eq!(error.lines().count(), 1, "{error}");
            said.push(error.to_owned());
        }
    }
    said
}

#[test]
fn a_run_without_memory_says_so() {
    let folder = folder(&[("old.svg", "old")]);
    let points: String = (0..200_000)
        .map(|i| format!("{i} {i} {}\n", i64::from(i).pow(2) % 1009))
        .collect();
    fs::write(folder.path().join("a.node"), format!("200000 2\n{points}")).expect("a file");
    // From less than the program itself needs to more than enough.
    let said = said_under_limits(&folder, "triangulate a.node", (16..160).step_by(4));
    for message in [
        "error: a.node: out of memory\n",
        "error: a.node: out of memory: it takes some 20 MB more\n",
    ] {
        assert!(said.iter().any(|error| error == message), "{said:?}");
    }
}

/// The lists of a `.json` take more memory than the triangulation.
#[test]
fn an_output_without_memory_says_so() {
    let folder = folder(&[]);
    let square = |i: u32| i64::from(i).pow(2) % 200_003;
    let points: String = (0..200_000)
        .map(|i| format!("{i} {i} {}\n", square(i)))
        .collect();
    fs::write(folder.path().join("a.node"), format!("200000 2\n{points}")).expect("a file");
    let arguments = "triangulate a.node -o a.json --threads 1";
    let said = said_under_limits(&folder, arguments, (40..300).step_by(10));
    let message = "error: a.json: out of memory\n";
    assert!(said.iter().any(|error| error == message), "{said:?}");
}

#[test]
fn a_run_that_cannot_make_threads_ends_well() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old")]);
    let is_root = fs::metadata("/proc/self").is_ok_and(|own| own.uid() == 0);
    // For root there is no such limit, and nobody must be able to write here.
    let everybody = std::os::unix::fs::PermissionsExt::from_mode(0o777);
    fs::set_permissions(folder.path(), everybody).expect("permissions");
    let limit = ["prlimit", "--nproc=1"];
    let nobody = ["setpriv", "--reuid=65534", "--clear-groups"];
    let words = match is_root {
        true => [nobody.as_slice(), &limit].concat(),
        false => limit.to_vec(),
    };
    let run = |words: &[&str], arguments: &str| {
        let (program, own) = words.split_first().expect("a program");
        output(by(program, own, &folder, arguments))
    };
    if is_root && !run(&nobody, "--version").status.success() {
        println!("left out: nobody cannot run the command");
        return;
    }
    let run = |arguments: &str| run(&words, arguments);
    for arguments in [
        "triangulate a.json -o a.svg --stats",
        "triangulate a.json -o a.svg --threads 2",
        "trace a.json -o a.txt",
    ] {
        let output = run(arguments);
        assert_eq!(text(&output.stderr), "");
        assert!(output.status.success(), "{arguments}");
    }
    assert_fails(
        &run("replay a.json"),
        "a.json:1: is not the header of a trace of version 3",
    );
    assert_eq!(
        names(folder.path()),
        ["a.json", "a.svg", "a.txt", "old.svg"]
    );
}
