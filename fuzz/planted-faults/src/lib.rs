//! Faults planted on purpose, to see which fuzz target finds which, and how soon.
//!
//! The tables in `faults`, one for each kind, name each fault, the right text of the source and the wrong
//! one. All of them are planted at once into a *copy* of the crate, as `if has(7) { wrong } else { right }`.
//! An environment variable chooses the one that a process has, so that one build serves all. The crate
//! itself knows nothing of this.
//!
//! A right text is an expression, or statements without a `let`, that occurs once in its file outside of
//! constants.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

use serde::Deserialize;

/// Names the chosen fault in the environment, by its place in the list of all.
pub const CHOICE: &str = "SWEEP_CDT_FAULT";

const FILES: [&str; 10] = [
    include_str!("../faults/point.toml"),
    include_str!("../faults/fill.toml"),
    include_str!("../faults/edge.toml"),
    include_str!("../faults/crossings.toml"),
    include_str!("../faults/scalar.toml"),
    include_str!("../faults/trace.toml"),
    include_str!("../faults/verify.toml"),
    include_str!("../faults/stream.toml"),
    include_str!("../faults/formats.toml"),
    include_str!("../faults/edit.toml"),
];

/// A file of tables.
#[derive(Deserialize)]
struct Tables {
    table: Vec<Table>,
}

/// Faults of one kind.
#[derive(Deserialize)]
struct Table {
    kind: String,
    fault: Vec<Fault>,
}

/// One row of a table.
#[derive(Clone, Debug, Deserialize)]
pub struct Fault {
    /// The subject of its table.
    #[serde(skip)]
    pub kind: String,
    /// A short name.
    pub name: String,
    /// The file, from the root of the repository.
    pub file: PathBuf,
    /// The description of the fault.
    pub what: String,
    /// The right text.
    pub right: String,
    /// The text that stands there instead.
    pub wrong: String,
}

/// All faults, those of one kind after the other.
///
/// # Panics
/// If a table cannot be read.
pub fn faults() -> Vec<Fault> {
    let mut faults = Vec::new();
    for text in FILES {
        let Tables { table } = toml::from_str(text).expect("tables of faults");
        for Table { kind, fault } in table {
            let of_kind = |fault| Fault {
                kind: kind.clone(),
                ..fault
            };
            faults.extend(fault.into_iter().map(of_kind));
        }
    }
    faults
}

/// The folder of the crate.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).expect("it lies in fuzz")
}

/// A source file with all of its faults planted.
///
/// # Errors
/// Says which right text does not occur exactly once.
pub fn plant(file: &Path, source: &str, faults: &[Fault]) -> Result<String, String> {
    let mut places = Vec::new();
    for (number, fault) in faults.iter().enumerate() {
        if fault.file != file {
            continue;
        }
        let found: Vec<usize> = source.match_indices(&fault.right).map(|m| m.0).collect();
        let [place] = found[..] else {
            let (name, times) = (&fault.name, found.len());
            return Err(format!("{name}: its text occurs {times} times, not once"));
        };
        places.push((place, place + fault.right.len(), number));
    }
    places.sort_unstable();
    if let Some(pair) = places.windows(2).find(|pair| pair[0].1 > pair[1].0) {
        let [a, b] = [pair[0].2, pair[1].2].map(|number| &faults[number].name);
        return Err(format!("{a} and {b} overlap"));
    }
    let mut planted = source.to_owned();
    for &(from, to, number) in places.iter().rev() {
        let Fault { right, wrong, .. } = &faults[number];
        let choice = format!("if crate::planted::has({number}) {{ {wrong} }} else {{ {right} }}");
        let is_statement = right.ends_with([';', '}']);
        let text = if is_statement {
            choice
        } else {
            format!("({choice})")
        };
        planted.replace_range(from..to, &text);
    }
    Ok(planted)
}

/// The parts of the crate's folder that a target needs to be built: all that its manifest names.
const NEEDED: [&str; 6] = [
    "Cargo.toml",
    "README.md",
    "benches",
    "crates",
    "examples",
    "src",
];
/// The parts of the fuzz workspace.
const NEEDED_OF_FUZZ: [&str; 5] = [
    "Cargo.toml",
    "Cargo.lock",
    "fuzz_targets",
    "planted-faults",
    "properties",
];

/// The folder of built files, which is not copied.
const BUILT: &str = "target";

/// The source that chooses a fault. Only the copy has it.
const PLANTED: &str = "planted.rs";

/// Copies the crate into this folder with every fault planted. A file that has not changed is not written, so
/// that it is not compiled again; one that the crate no longer has is removed.
///
/// # Errors
/// If files cannot be read or written, or a fault cannot be planted.
pub fn copy(to: &Path, faults: &[Fault]) -> io::Result<()> {
    for name in NEEDED {
        copy_all(Path::new(name), to, faults)?;
    }
    for name in NEEDED_OF_FUZZ {
        copy_all(&Path::new("fuzz").join(name), to, &[])?;
    }
    for source in sources(faults) {
        let chooser = include_str!("planted.rs");
        write(&to.join(source).join(PLANTED), chooser.as_bytes())?;
    }
    Ok(())
}

/// The source folders of the packages that have faults.
fn sources(faults: &[Fault]) -> BTreeSet<PathBuf> {
    let is_source = |folder: &&Path| folder.ends_with("src");
    let source = |fault: &Fault| fault.file.ancestors().find(is_source).map(Path::to_owned);
    faults.iter().filter_map(source).collect()
}

/// Copies a file or a folder, whose path begins at the root of the repository.
fn copy_all(path: &Path, to: &Path, faults: &[Fault]) -> io::Result<()> {
    let (from, target) = (root().join(path), to.join(path));
    if from.is_dir() {
        fs::create_dir_all(&target)?;
        remove_strangers(&from, &target)?;
        for entry in fs::read_dir(from)? {
            let name = entry?.file_name();
            if name != BUILT {
                copy_all(&path.join(&name), to, faults)?;
            }
        }
        return Ok(());
    }
    if let Some(folder) = target.parent() {
        fs::create_dir_all(folder)?;
    }
    let bytes = fs::read(from)?;
    let is_root = sources(faults)
        .iter()
        .any(|source| source.join("lib.rs") == path);
    if !is_root && !faults.iter().any(|fault| fault.file == path) {
        return write(&target, &bytes);
    }
    let source = String::from_utf8(bytes).map_err(io::Error::other)?;
    let mut planted = plant(path, &source, faults).map_err(io::Error::other)?;
    if is_root {
        planted = format!("#![allow(warnings)]\n{planted}\nmod planted;\n");
    }
    write(&target, planted.as_bytes())
}

/// Removes from the second folder what the first does not have.
fn remove_strangers(from: &Path, to: &Path) -> io::Result<()> {
    for entry in fs::read_dir(to)? {
        let (name, path) = entry.map(|entry| (entry.file_name(), entry.path()))?;
        if name == PLANTED || from.join(&name).exists() {
            continue;
        }
        if path.is_dir() {
            fs::remove_dir_all(path)?;
        } else {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

fn write(to: &Path, bytes: &[u8]) -> io::Result<()> {
    if fs::read(to).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    fs::write(to, bytes)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;

    use super::{faults, plant, root};

    #[test]
    fn every_fault_can_be_planted() {
        let faults = faults();
        let files: BTreeSet<_> = faults.iter().map(|fault| &fault.file).collect();
        for file in files {
            let source = fs::read_to_string(root().join(file)).expect("a source file");
            let planted = plant(file, &source, &faults)
                .unwrap_or_else(|message| panic!("{}: {message}", file.display()));
            // A text that is no expression leaves what is not Rust.
            if let Err(error) = syn::parse_file(&planted) {
                let line = planted.lines().nth(error.span().start().line - 1);
                panic!("{}: {error}: {}", file.display(), line.unwrap_or(""));
            }
        }
    }

    #[test]
    fn names_are_different() {
        let faults = faults();
        let names: BTreeSet<_> = faults.iter().map(|fault| &fault.name).collect();
        assert_eq!(names.len(), faults.len());
    }
}
