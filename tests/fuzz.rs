//! The fuzz targets without a fuzzer: every property on the seeds that are checked in, on the inputs of
//! past findings (`fuzz/regressions`), and on bytes by chance.

use std::fs;
use std::path::{Path, PathBuf};

use sweep_cdt_properties::{TARGETS, Target};

/// Chance inputs for each property.
const CHANCES: u64 = 500;

fn files(folder: &str, target: &Target) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fuzz")
        .join(folder);
    let entries = fs::read_dir(folder.join(target.name));
    let mut files: Vec<PathBuf> = entries
        .map(|entries| {
            entries
                .map(|entry| entry.expect("an entry").path())
                .collect()
        })
        .unwrap_or_default();
    files.sort();
    files
}

fn replay(folder: &str, target: &Target) -> usize {
    let files = files(folder, target);
    for file in &files {
        // Shown if the property does not hold.
        println!("{}", file.display());
        (target.test)(&fs::read(file).expect("a readable file"));
    }
    files.len()
}

#[test]
fn every_property_holds_for_its_seeds() {
    for target in TARGETS {
        assert!(replay("seeds", target) > 0, "{} has no seeds", target.name);
    }
}

#[test]
fn every_property_holds_for_past_findings() {
    for target in TARGETS {
        replay("regressions", target);
    }
}

#[test]
fn every_property_holds_for_bytes_by_chance() {
    for target in TARGETS {
        let mut state = 1_u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state.to_le_bytes()
        };
        for _ in 0..CHANCES {
            let length = 4 + usize::from(next()[3]) / 2;
            let bytes: Vec<u8> = (0..length).map(|_| next()[4]).collect();
            println!("{}: {bytes:?}", target.name);
            (target.test)(&bytes);
        }
    }
}

#[test]
fn every_property_is_a_fuzz_target() {
    let manifest = include_str!("../fuzz/Cargo.toml");
    let is_target = |line: &&str| line.starts_with("path = \"fuzz_targets/");
    let listed: Vec<&str> = manifest.lines().filter(is_target).collect();
    let expected: Vec<String> = TARGETS
        .iter()
        .map(|target| format!("path = \"fuzz_targets/{}.rs\"", target.name))
        .collect();
    assert_eq!(
        listed, expected,
        "fuzz/Cargo.toml, in the order of TARGETS (right)"
    );
}
