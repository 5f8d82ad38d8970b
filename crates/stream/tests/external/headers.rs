//! A header is believed only as far as the file is long: whatever number of a small file is made large, reading ends in a
//! result or an error, and takes little memory. So for every reader of whole files and of files in pieces.
//!
//! The files are read in a process of their own, whose address space is limited. Where more is asked for, it ends, and the
//! last file is shown.

use std::fs::{self, File};
use std::os::unix::fs::FileExt;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use sweep_cdt::Pslg;
use sweep_cdt_formats::{Format, GraphFile, Source, read, read_result};
use sweep_cdt_stream::external::{FORMATS, open};

/// What reading a file may take, of which none has more than three kilobytes.
const ROOM: u64 = 64 << 20;
/// The folder of the process that reads.
const FOLDER: &str = "SWEEP_CDT_HEADERS";

/// A right file of a format.
struct Seed {
    format: String,
    bytes: Vec<u8>,
}

fn seeds() -> Vec<Seed> {
    let listed = [
        include_str!("../../../formats/tests/data/meshes.jsonl"),
        include_str!("../data/arrays.jsonl"),
    ];
    let listed = listed.iter().flat_map(|list| list.lines());
    let listed = listed.filter_map(|line| {
        let seed: serde_json::Value = serde_json::from_str(line).expect("JSON");
        let bytes = STANDARD.decode(seed["base64"].as_str()?).expect("base 64");
        let format = seed["format"].as_str().expect("a format").to_owned();
        Some(Seed { format, bytes })
    });
    let texts = [
        ("node", "3 2 1 1\n1 0 0 5 0\n2 1 0 6 1\n3 0 1 7 2\n"),
        (
            "poly",
            "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 1\n1 1 2 4\n2 2 3 5\n1\n1 .2 .2\n1\n1 .3 .3 2 .1\n",
        ),
        ("ele", "2 3 1\n1 1 2 3 8\n2 1 3 4 9\n"),
        ("csv", "x,y,3\n1,2,3\n4,5,6\n"),
        (
            "json",
            "{\"points\": [[0, 0], [1, 0], [0, 1]], \"edges\": [[0, 1]], \"triangles\": [[0, 1, 2]]}",
        ),
    ];
    let texts = texts.into_iter().map(|(format, text)| Seed {
        format: format.to_owned(),
        bytes: text.into(),
    });
    #[cfg(not(feature = "las"))]
    let clouds = [];
    #[cfg(feature = "las")]
    let clouds = crate::clouds::small().map(|(format, bytes)| Seed {
        format: format.to_owned(),
        bytes,
    });
    listed.chain(texts).chain(clouds).collect()
}

/// Writes numbers in the place of those that begin at a byte: of 32 and of 64 bits, in both orders.
fn with_large_numbers(bytes: &[u8], at: usize, mut take: impl FnMut(&[u8])) {
    let mut take = |number: &[u8], reversed: &[u8]| {
        for number in [number, reversed] {
            let mut altered = bytes.to_vec();
            if let Some(place) = altered.get_mut(at..at + number.len()) {
                place.copy_from_slice(number);
                take(&altered);
            }
        }
    };
    for number in [1 << 26, i32::MAX as u32, u32::MAX] {
        take(&number.to_le_bytes(), &number.to_be_bytes());
    }
    for number in [1 << 40, i64::MAX as u64] {
        take(&number.to_le_bytes(), &number.to_be_bytes());
    }
}

/// Runs of bytes of one kind.
fn runs(bytes: &[u8], is_of_kind: impl Fn(&u8) -> bool) -> Vec<std::ops::Range<usize>> {
    let runs = bytes.chunk_by(|a, b| is_of_kind(a) == is_of_kind(b));
    let mut at = 0;
    runs.map(|run| {
        at += run.len();
        at - run.len()..at
    })
    .filter(|run| bytes.get(run.start).is_some_and(&is_of_kind))
    .collect()
}

/// A file with one number after the other made large: numbers in text, in bytes, and in bytes as text.
fn altered(bytes: &[u8], mut take: impl FnMut(&[u8])) {
    for run in runs(bytes, u8::is_ascii_digit) {
        for number in [
            "67108864",
            "2147483647",
            "4294967295",
            "1099511627776",
            "9223372036854775807",
        ] {
            take(&[&bytes[..run.start], number.as_bytes(), &bytes[run.end..]].concat());
        }
    }
    // Small numbers have a byte of zeros, and text has none. Of many zeros, the first and the last places stand for all.
    for at in 0..bytes.len().saturating_sub(3) {
        let around = &bytes[at.saturating_sub(4)..bytes.len().min(at + 8)];
        if bytes[at..at + 4].contains(&0) && around.iter().any(|&byte| byte != 0) {
            with_large_numbers(bytes, at, &mut take);
        }
    }
    let is_base64 = |byte: &u8| byte.is_ascii_alphanumeric() || b"+/=".contains(byte);
    for run in runs(bytes, is_base64) {
        // The header is a text of its own, or the begin of one.
        let text = &bytes[run.clone()];
        let end = text.iter().position(|&byte| byte == b'=');
        let end = end
            .map_or(text.len(), |end| (end + 4) / 4 * 4)
            .min(text.len());
        let Ok(decoded) = STANDARD.decode(&text[..end]) else {
            continue;
        };
        for at in (0..decoded.len().min(40)).step_by(4) {
            with_large_numbers(&decoded, at, |number| {
                let text = STANDARD.encode(number);
                let (before, after) = (&bytes[..run.start], &bytes[run.start + end..]);
                take(&[before, text.as_bytes(), after].concat());
            });
        }
    }
}

/// Reads a file in all ways that its format has. What comes of it is of no interest.
fn read_all(seed: &Seed, bytes: &[u8], input: &GraphFile<f64>, folder: &Path) {
    let source = Source::new("file", bytes);
    if let Some(format) = Format::named(&seed.format, Format::INPUTS) {
        drop(read(format, &source, None));
    }
    if let Some(format) = Format::named(&seed.format, Format::RESULTS) {
        drop(read_result(format, &source, None, input));
    }
    let Some(format) = Format::named(&seed.format, FORMATS) else {
        return;
    };
    let path = folder.join("file");
    fs::write(&path, bytes).expect("room");
    let Ok(mut input) = open(&path, format, None) else {
        return;
    };
    let (mut points, mut edges) = (Vec::new(), Vec::new());
    while input.next_points(&mut points).is_ok() && !points.is_empty() {
        points.clear();
    }
    while input.next_edges(&mut edges).is_ok() && !edges.is_empty() {
        edges.clear();
    }
}

/// Lets this process take so much more memory.
fn limit_memory() {
    let status = fs::read_to_string("/proc/self/status").expect("what Linux tells");
    let size = status.lines().find_map(|line| {
        let kilobytes = line.strip_prefix("VmSize:")?.trim().strip_suffix(" kB")?;
        kilobytes.parse::<u64>().ok()
    });
    let most = (size.expect("a size") << 10) + ROOM;
    let Rlimit { maximum, .. } = getrlimit(Resource::As);
    let current = Some(most);
    setrlimit(Resource::As, Rlimit { current, maximum }).expect("a limit below that of before");
}

/// Reads all altered files, and has the last one in a file of the folder.
fn read_altered(folder: &Path) -> usize {
    let points = vec![[0.0, 0.0], [4.0, 0.1], [4.3, 3.7], [-0.2, 3.3]];
    let input = Pslg {
        points,
        ..Pslg::default()
    };
    let input = input.into();
    let seeds = seeds();
    // What is made once is made before.
    for seed in &seeds {
        read_all(seed, &seed.bytes, &input, folder);
    }
    limit_memory();
    let last = File::create(folder.join("last")).expect("a file");
    let mut count = 0;
    for seed in &seeds {
        altered(&seed.bytes, |bytes| {
            count += 1;
            let shown = [seed.format.as_bytes(), b"\n", bytes, b"\nEND\n"].concat();
            last.write_all_at(&shown, 0).expect("room");
            read_all(seed, bytes, &input, folder);
        });
    }
    count
}

#[test]
fn headers_are_believed_as_far_as_the_file_is_long() {
    if let Some(folder) = std::env::var_os(FOLDER) {
        let count = read_altered(&PathBuf::from(folder));
        assert!(count > 20_000, "{count}");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut child = Command::new(std::env::current_exe().expect("this test"));
    child.args([
        "--exact",
        "headers::headers_are_believed_as_far_as_the_file_is_long",
    ]);
    child.args(["--nocapture", "--test-threads=1"]);
    // A heap for each thread would take address space that nobody uses, and a backtrace has no memory where this ends.
    child
        .env("MALLOC_ARENA_MAX", "1")
        .env("RAYON_NUM_THREADS", "2")
        .env("RUST_BACKTRACE", "0");
    let output = child
        .env(FOLDER, folder.path())
        .output()
        .expect("a process");
    let last = fs::read(folder.path().join("last")).unwrap_or_default();
    let said = String::from_utf8_lossy(&output.stderr);
    let last = last.escape_ascii();
    assert!(output.status.success(), "{said}\nthe last file: {last}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("1 passed"));
}
