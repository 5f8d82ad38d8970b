//! Outputs in places that only Unix has: links, FIFOs, devices, files of other owners and permissions.

use std::fs::{self, File, Permissions};
use std::io::Write;
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, chown, symlink};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::outputs::{NODE, RIGHT, TRIANGLE, assert_refused, read};
use crate::{
    CONTOURS, assert_fails, command, folder, in_time, names, printed, run, sweep_cdt, text,
};

fn mode(path: &Path) -> u32 {
    fs::metadata(path).expect("a file").mode() & 0o7777
}

#[test]
fn symbolic_links_stay_and_lead_to_the_output() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old")]);
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("folder")).expect("a folder");
    for (target, link) in [
        ("old.svg", "there.svg"),
        ("folder/new.obj", "absent.obj"),
        ("../absent.obj", "folder/again.obj"),
        ("a.json", "input.json"),
        ("loop.svg", "loop.svg"),
    ] {
        symlink(target, path(link)).expect("a link");
    }
    assert_eq!(
        printed(&run(&folder, "a.json -o there.svg -o folder/again.obj")),
        ""
    );
    assert!(read(&folder, "old.svg").starts_with("<svg"));
    assert!(read(&folder, "folder/new.obj").starts_with("v 0 0 0\n"));
    for link in ["there.svg", "absent.obj", "folder/again.obj"] {
        let kind = fs::symlink_metadata(path(link)).expect("a link");
        assert!(kind.is_symlink(), "{link}");
    }
    assert_eq!(names(&path("folder")), ["again.obj", "new.obj"]);
    assert_refused(
        &folder,
        "triangulate a.json -o input.json",
        "input.json is an input and would be overwritten",
    );
    assert_refused(
        &folder,
        "triangulate a.json -o there.svg -o old.svg",
        "there.svg and old.svg are the same file and would both be written",
    );
    let output = run(&folder, "a.json -o loop.svg");
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).starts_with("error: loop.svg: too many levels of symbolic links"));
}

#[test]
fn permissions_are_kept() {
    let folder = folder(&[("a.json", TRIANGLE)]);
    for old in [0o600, 0o640, 0o664, 0o666, 0o777, 0o200] {
        let path = folder.path().join("old.svg");
        fs::write(&path, "old").expect("a file");
        fs::set_permissions(&path, Permissions::from_mode(old)).expect("permissions");
        assert_eq!(printed(&run(&folder, "a.json -o old.svg -o new.svg")), "");
        assert_eq!(mode(&path), old, "{old:o}");
        assert!(fs::metadata(&path).expect("a file").len() > 100);
        // A new file has those of any new file.
        let other = folder.path().join("other");
        fs::write(&other, "").expect("a file");
        assert_eq!(mode(&folder.path().join("new.svg")), mode(&other));
    }
}

#[test]
fn the_owner_is_kept() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old")]);
    let path = folder.path().join("old.svg");
    if chown(&path, Some(1234), Some(4321)).is_err() {
        println!("left out: only root can give a file away");
        return;
    }
    fs::set_permissions(&path, Permissions::from_mode(0o640)).expect("permissions");
    assert_eq!(printed(&run(&folder, "a.json -o old.svg")), "");
    let new = fs::metadata(&path).expect("a file");
    assert!(new.len() > 100);
    assert_eq!((new.uid(), new.gid(), mode(&path)), (1234, 4321, 0o640));
}

#[test]
fn what_standard_input_was_redirected_from_is_not_overwritten() {
    let folder = folder(&[("a.json", TRIANGLE)]);
    let input = File::open(folder.path().join("a.json")).expect("a file");
    let mut command = command(&folder, "- --input-format json -o a.json");
    let output = command.stdin(input).output().expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    let message = "error: a.json is an input and would be overwritten\n";
    assert!(text(&output.stderr).starts_with(message));
    assert_eq!(read(&folder, "a.json"), TRIANGLE);
}

#[test]
fn a_read_only_file_is_refused() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old"), ("r.json", RIGHT)]);
    let path = folder.path().join("old.svg");
    fs::set_permissions(&path, Permissions::from_mode(0o444)).expect("permissions");
    for arguments in [
        "triangulate a.json -o new.svg -o old.svg",
        "trace a.json -o old.svg",
        "verify a.json r.json --record new.json --svg old.svg",
    ] {
        let output = sweep_cdt(&folder, arguments).output();
        assert_fails(
            &output.expect("the command starts"),
            "old.svg: is read-only",
        );
        assert_eq!(read(&folder, "old.svg"), "old");
        assert_eq!(names(folder.path()), ["a.json", "old.svg", "r.json"]);
    }
}

/// The FIFO `f` in a folder.
fn fifo(folder: &Path) {
    let made = Command::new("mkfifo").arg(folder.join("f")).status();
    assert!(made.expect("mkfifo").success());
}

#[test]
fn fifos_are_written_to() {
    let folder = folder(&[("a.json", TRIANGLE), ("r.json", RIGHT)]);
    fifo(folder.path());
    for (arguments, start) in [
        (
            "triangulate a.json --output-format node -o f -o a.svg",
            NODE,
        ),
        (
            "trace a.json --output-format txt -o f",
            "sweep-cdt trace 3\n",
        ),
        ("verify a.json r.json --record f", "{\n"),
    ] {
        let child = sweep_cdt(&folder, arguments).stdout(Stdio::null()).spawn();
        let mut child = child.expect("the command starts");
        let path = folder.path().join("f");
        let contents = in_time(|| fs::read_to_string(path).expect("text"));
        assert!(contents.starts_with(start), "{arguments}");
        assert!(child.wait().expect("the command ends").success());
    }
    let kind = fs::metadata(folder.path().join("f")).expect("a FIFO");
    assert!(kind.file_type().is_fifo());
    assert_eq!(names(folder.path()), ["a.json", "a.svg", "f", "r.json"]);
}

#[test]
fn devices_are_written_to() {
    let folder = folder(&[("a.json", TRIANGLE)]);
    let expected = run(&folder, "a.json -o - --output-format obj");
    let output = run(&folder, "a.json -o /dev/stdout --output-format obj");
    assert_eq!(printed(&output), printed(&expected));
    // Standard output is a file here, which is written on from where it stands.
    let mut file = File::create(folder.path().join("out")).expect("a file");
    file.write_all(b"before\n").expect("a line");
    let mut redirected = command(&folder, "a.json -o /dev/stdout --output-format obj");
    let status = redirected.stdout(file).status();
    assert!(status.expect("the command starts").success());
    assert_eq!(
        read(&folder, "out"),
        format!("before\n{}", printed(&expected))
    );
    let output = run(
        &folder,
        "a.json --output-format obj -o /dev/null -o /dev/null",
    );
    assert_eq!(printed(&output), "");
    let kind = fs::metadata("/dev/null").expect("a device");
    assert!(kind.file_type().is_char_device());
    assert_eq!(names(folder.path()), ["a.json", "out"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_leaves_the_files_as_they_were() {
    let folder = folder(&[("a.json", TRIANGLE), ("old.svg", "old"), ("r.json", RIGHT)]);
    let output = run(
        &folder,
        "a.json -o old.svg -o /dev/full --output-format obj",
    );
    assert_fails(&output, "/dev/full: no space left on device");
    for arguments in [
        "triangulate a.json -o old.svg --stats",
        "triangulate a.json -o old.svg --verify",
        "verify a.json r.json --svg old.svg --record new.json",
    ] {
        let full = File::options().write(true).open("/dev/full");
        let mut command = sweep_cdt(&folder, arguments);
        let output = command.stdout(full.expect("a device")).output();
        let output = output.expect("the command starts");
        assert_fails(&output, "standard output: no space left on device");
        assert_eq!(read(&folder, "old.svg"), "old");
        assert_eq!(names(folder.path()), ["a.json", "old.svg", "r.json"]);
    }
}

/// While nobody reads the rest of the FIFO, the other outputs are complete and wait.
#[test]
fn an_output_that_fails_at_last_names_those_before_it() {
    let folder = folder(&[("old.svg", "old")]);
    fifo(folder.path());
    let outputs = "-o old.svg -o b.obj -o c.ele -o f --output-format json";
    let child = command(&folder, &format!("{CONTOURS} {outputs}"))
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let path = folder.path().join("f");
    let mut reader = in_time(|| File::open(path).expect("a FIFO"));
    fs::create_dir(folder.path().join("b.obj")).expect("a folder");
    in_time(move || std::io::copy(&mut reader, &mut std::io::sink()).expect("the contents"));
    let output = child.wait_with_output().expect("the command ends");
    assert_fails(&output, "b.obj: is a directory; written already: old.svg");
    assert_eq!(names(folder.path()), ["b.obj", "f", "old.svg"]);
}
