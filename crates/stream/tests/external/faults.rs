//! What can go wrong: each fault is a typed error that says where it is, and leaves no temporary file.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;

use sweep_cdt_formats::ReadError;
use sweep_cdt_stream::external::{Error, Format, Input, Sorting, open};

use crate::{Made, Random, take};

/// Little memory: 2,343 points are a run.
const LITTLE: u64 = 200_000;

fn uniform(count: u64) -> Vec<[f64; 2]> {
    let mut random = Random(61);
    (0..count)
        .map(|_| [random.share(), random.share()])
        .collect()
}

fn fault(input: &mut dyn Input, memory: u64, folder: &Path) -> Error {
    let sorted = Sorting::new(memory, folder).sort(input).and_then(take);
    sorted.map(|vertices| vertices.len()).expect_err("a fault")
}

#[test]
fn a_coordinate_that_is_not_finite_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in [0, 1] {
            for at in [0, 2342, 2343, 9999] {
                let mut points = uniform(10_000);
                points[at][axis] = value;
                let error = fault(&mut Made::new(points, Vec::new()), LITTLE, folder.path());
                let expected = format!("made: point {at} has a coordinate that is not finite");
                assert_eq!(error.to_string(), expected);
                assert!(matches!(error, Error::NonFinite { point, .. } if point == at as u64));
            }
        }
    }
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

#[test]
fn an_end_that_is_no_point_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    for (count, words) in [
        (0, "there are no points"),
        (1000, "the points are numbered from 0 to 999"),
        (10_000, "the points are numbered from 0 to 9999"),
    ] {
        for point in [count, u64::MAX] {
            for at in [0, 700] {
                let mut edges = match count {
                    0 => vec![[point, point]; 701],
                    _ => vec![[1, 2]; 1000],
                };
                let at = if count == 0 { 0 } else { at };
                edges[at] = [point, point];
                let mut input = Made::new(uniform(count), edges);
                let error = fault(&mut input, LITTLE, folder.path());
                let expected =
                    format!("made: edge {at} ends at point {point}, which does not exist: {words}");
                assert_eq!(error.to_string(), expected);
            }
        }
    }
}

#[test]
fn a_folder_that_is_not_there_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let nowhere = folder.path().join("nowhere");
    let error = fault(
        &mut Made::new(uniform(10_000), Vec::new()),
        LITTLE,
        &nowhere,
    );
    let expected = format!(
        "{}: no such file or directory, after 0 bytes of temporary files; another folder may have room for them",
        nowhere.display()
    );
    assert!(matches!(error, Error::Temporary { .. }));
    if cfg!(unix) {
        assert_eq!(error.to_string(), expected);
    }
    // What needs no temporary file needs no folder.
    let sorted = Sorting::new(1 << 30, nowhere).sort(&mut Made::new(uniform(10_000), Vec::new()));
    assert!(sorted.is_ok());
}

#[test]
fn memory_for_too_few_runs_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(62);
    let others = (0..10).map(|_| (1 + random.below(20_000), random.below(20_000)));
    let counts: Vec<(u64, u64)> = [(10_000, 0), (10_000, 10_000), (50, 10_000)]
        .into_iter()
        .chain(others)
        .collect();
    for (count, edges) in counts {
        let ends = |at: u64| [at * 7 % count, (at * 7 + 1) % count];
        let input = || Made::new(uniform(count), (0..edges).map(ends).collect());
        let too_little = |memory: u64| {
            let error = fault(&mut input(), memory, folder.path());
            match error {
                Error::TooLittleMemory {
                    memory: said,
                    needed,
                } if said == memory => needed,
                _ => panic!("{error}"),
            }
        };
        // What is said to suffice does, and a KiB less does not.
        let needed = too_little(0);
        for memory in [1, needed / 2, needed - 1024] {
            let again = too_little(memory);
            assert!(again <= needed, "{again} {needed}");
        }
        let sorted = Sorting::new(needed, folder.path())
            .sort(&mut input())
            .and_then(take);
        assert_eq!(sorted.expect("no fault").len() as u64, count);
    }
}

/// An input that changes its file while it is read.
struct Changing<'a> {
    input: Box<dyn Input>,
    change: &'a dyn Fn(),
    after: usize,
}

impl Input for Changing<'_> {
    fn name(&self) -> &str {
        self.input.name()
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        if self.after == 0 {
            (self.change)();
        }
        self.after = self.after.wrapping_sub(1);
        self.input.next_points(points)
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        self.input.next_edges(edges)
    }
}

#[test]
fn a_file_that_changes_while_it_is_read_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.f64");
    let points = uniform(100_000);
    let bytes: Vec<u8> = points
        .as_flattened()
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    let longer = || {
        let mut file = OpenOptions::new().append(true).open(&path).expect("a file");
        file.write_all(&[0; 16]).expect("room");
    };
    let shorter = || {
        let file = OpenOptions::new().write(true).open(&path).expect("a file");
        file.set_len(800_000).expect("a shorter file");
    };
    let newer = || {
        let file = OpenOptions::new().write(true).open(&path).expect("a file");
        let long_ago =
            std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(1_000_000);
        file.set_modified(long_ago).expect("another time");
    };
    let longer_and_as_old = || {
        let file = OpenOptions::new().append(true).open(&path);
        let mut file = file.expect("a file");
        let modified = file.metadata().and_then(|metadata| metadata.modified());
        file.write_all(&[0; 16]).expect("room");
        let modified = modified.expect("a time");
        file.set_modified(modified).expect("the same time");
    };
    for change in [&longer as &dyn Fn(), &longer_and_as_old, &shorter, &newer] {
        fs::write(&path, &bytes).expect("a file");
        let input = open(&path, Format::F64, None).expect("a file");
        let mut input = Changing {
            input,
            change,
            after: 2,
        };
        let error = fault(&mut input, LITTLE, folder.path());
        let expected = format!(
            "{}: the file was changed while it was read: run it again when the file is complete",
            path.display()
        );
        assert_eq!(error.to_string(), expected);
    }
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
}

#[test]
fn files_that_are_cut_off_or_none_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.f64");
    let name = path.display();
    let error = |edges: Option<&Path>| {
        let opened = open(&path, Format::F64, edges);
        opened.err().expect("it is refused").to_string()
    };
    assert!(
        error(None).starts_with(&format!("{name}: no such file")),
        "{}",
        error(None)
    );
    fs::write(&path, [0; 40]).expect("a file");
    let words = format!(
        "{name}: the file has 40 bytes, and a point of two doubles takes 16: it is cut off, or holds something else"
    );
    assert_eq!(error(None), words);
    fs::write(&path, [0; 32]).expect("a file");
    let edges = folder.path().join("e.u64");
    fs::write(&edges, [0; 8]).expect("a file");
    let words = format!(
        "{}: the file has 8 bytes, and an edge of two numbers of points takes 16: it is cut off, or holds something else",
        edges.display()
    );
    assert_eq!(error(Some(&edges)), words);
    let folder_itself = open(folder.path(), Format::F64, None);
    let words = folder_itself.err().expect("it is a folder").to_string();
    assert!(
        words.ends_with("is no file: what is read in pieces must be one, not a pipe or a folder"),
        "{words}"
    );
}
