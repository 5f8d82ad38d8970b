//! The fuzz targets without a fuzzer: every property on its seeds (`fuzz/seeds`), on the inputs of past
//! findings (`fuzz/regressions`), and on random bytes.

use std::fs;

use sweep_cdt_properties::{TARGETS, seeds};
use sweep_cdt_testing::{Random, data};

/// Random inputs for each property.
const INPUTS: u64 = 500;

#[test]
fn every_property_holds_for_its_seeds() {
    for target in TARGETS {
        let seeds = seeds::read(&seeds::path(target.name)).expect("a file of seeds");
        assert!(!seeds.is_empty(), "{} has no seeds", target.name);
        for (bytes, name) in seeds {
            // Shown if the property does not hold.
            println!("{}: {bytes:02x?} {name}", target.name);
            (target.test)(&bytes);
        }
    }
}

#[test]
fn every_property_holds_for_past_findings() {
    for target in TARGETS {
        let entries = fs::read_dir(data::path("fuzz/regressions").join(target.name));
        for entry in entries.into_iter().flatten() {
            let file = entry.expect("an entry").path();
            println!("{}", file.display());
            (target.test)(&fs::read(file).expect("a readable file"));
        }
    }
}

#[test]
fn every_property_holds_for_random_bytes() {
    for target in TARGETS {
        for seed in 0..INPUTS {
            let mut random = Random::new(seed);
            let length = 4 + random.below(128);
            let bytes = random.bytes(length);
            println!("{}: {bytes:02x?}", target.name);
            (target.test)(&bytes);
        }
    }
}

#[test]
fn every_property_is_a_fuzz_target() {
    let manifest = include_str!("../../Cargo.toml");
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
