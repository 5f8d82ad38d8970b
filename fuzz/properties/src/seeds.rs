//! Seeds: the inputs that a fuzz target begins with, one text file for each target.
//!
//! `fuzz/seeds/TARGET.hex` holds one seed a line, its bytes in hexadecimal. After a `#` there may be a name.
//! The lines are sorted and no two stand for the same bytes, so that a change of the seeds is a change of
//! some lines. libFuzzer takes a folder with a file for each seed, which `fuzz/build.rs` makes and [`pack`]
//! turns into text again.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// The bytes of each seed, and its name or an empty text.
pub type Seeds = BTreeMap<Vec<u8>, String>;

/// The file of a target.
pub fn path(target: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../seeds");
    folder.join(target).with_extension("hex")
}

/// Reads such a file.
///
/// # Errors
/// If there is no such file, or if a line is not in hexadecimal.
pub fn read(path: &Path) -> io::Result<Seeds> {
    let text = fs::read_to_string(path)?;
    let numbered = (1..).zip(text.lines());
    let seed = |(number, line): (usize, &str)| {
        let (digits, name) = line.split_once('#').unwrap_or((line, ""));
        let seed = bytes(digits.trim()).map(|bytes| (bytes, name.trim().to_owned()));
        let message = || format!("{}:{number}: not in hexadecimal", path.display());
        seed.ok_or_else(|| io::Error::other(message()))
    };
    numbered.map(seed).collect()
}

/// The bytes that these digits stand for.
fn bytes(digits: &str) -> Option<Vec<u8>> {
    let (pairs, rest) = digits.as_bytes().as_chunks::<2>();
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let byte = |[high, low]: &[u8; 2]| u8::try_from(digit(*high)? << 4 | digit(*low)?).ok();
    rest.is_empty().then(|| pairs.iter().map(byte).collect())?
}

/// The text of a file.
fn text(seeds: &Seeds) -> String {
    let mut text = String::new();
    for (bytes, name) in seeds {
        for byte in bytes {
            write!(text, "{byte:02x}").expect("memory takes it");
        }
        if !name.is_empty() {
            write!(text, "  # {name}").expect("memory takes it");
        }
        text.push('\n');
    }
    text
}

/// Adds the content of each file of a folder to the seeds. Returns how many of them are new.
///
/// An empty file is left out: libFuzzer tries no bytes at all in any case.
///
/// # Errors
/// If the folder or the file cannot be read, or the file not be written.
pub fn pack(folder: &Path, file: &Path) -> io::Result<usize> {
    let mut seeds = if file.exists() {
        read(file)?
    } else {
        Seeds::new()
    };
    let before = seeds.len();
    for entry in fs::read_dir(folder)? {
        let bytes = fs::read(entry?.path())?;
        if !bytes.is_empty() {
            seeds.entry(bytes).or_default();
        }
    }
    fs::write(file, text(&seeds))?;
    Ok(seeds.len() - before)
}

#[test]
fn what_is_packed_is_read() {
    let folder = std::env::temp_dir().join(format!("seeds-{}", std::process::id()));
    let (file, more) = (folder.join("some.hex"), folder.join("more"));
    fs::create_dir_all(&more).expect("a folder");
    fs::write(&file, "00ff  # a name\n10\n").expect("a file");
    fs::write(more.join("more"), [1]).expect("a file");
    fs::write(more.join("again"), [0, 255]).expect("a file");
    assert_eq!(pack(&more, &file).expect("a good folder"), 1);
    let text = fs::read_to_string(&file).expect("a file");
    assert_eq!(text, "00ff  # a name\n01\n10\n");
    fs::write(&file, "0\n").expect("a file");
    assert!(read(&file).is_err());
    fs::remove_dir_all(folder).expect("a folder");
}
