//! A copy of the crate and its properties with the faults in it.

use std::path::Path;
use std::{fs, io};

use crate::{Fault, plant, root};

/// What of the crate's folder is needed to build a target: all that its manifest names.
const NEEDED: [&str; 7] = [
    "Cargo.toml",
    "README.md",
    "benches",
    "examples",
    "src",
    "testing",
    "tests/targets",
];
/// What of the fuzz workspace.
const NEEDED_OF_FUZZ: [&str; 5] = [
    "Cargo.toml",
    "Cargo.lock",
    "fuzz_targets",
    "planted-faults",
    "properties",
];

/// What was built is not copied.
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
        copy_all(&root().join(name), &to.join(name), Path::new(""), faults)?;
    }
    for name in NEEDED_OF_FUZZ {
        let from = root().join("fuzz").join(name);
        copy_all(&from, &to.join("fuzz").join(name), Path::new(""), &[])?;
    }
    write(
        &to.join("src").join(PLANTED),
        include_str!("planted.rs").as_bytes(),
    )
}

/// Copies a file or a folder; `inside` is its path in the folder of the first call.
fn copy_all(from: &Path, to: &Path, inside: &Path, faults: &[Fault]) -> io::Result<()> {
    if from.is_dir() {
        fs::create_dir_all(to)?;
        remove_strangers(from, to)?;
        for entry in fs::read_dir(from)? {
            let name = entry?.file_name();
            if name == BUILT {
                continue;
            }
            copy_all(
                &from.join(&name),
                &to.join(&name),
                &inside.join(&name),
                faults,
            )?;
        }
        return Ok(());
    }
    let bytes = fs::read(from)?;
    if !faults.iter().any(|fault| fault.file == inside) && inside != Path::new("lib.rs") {
        return write(to, &bytes);
    }
    let source = String::from_utf8(bytes).map_err(io::Error::other)?;
    let mut planted = plant(inside, &source, faults).map_err(io::Error::other)?;
    if inside == Path::new("lib.rs") && !faults.is_empty() {
        planted = format!("#![allow(warnings)]\n{planted}\nmod planted;\n");
    }
    write(to, planted.as_bytes())
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
