//! The table fits the sources.

use std::collections::BTreeSet;
use std::fs;

use sweep_cdt_planted_faults::{faults, plant, root};

#[test]
fn every_right_text_occurs_once() {
    let faults = faults();
    let files: BTreeSet<_> = faults.iter().map(|fault| &fault.file).collect();
    for file in files {
        let source = fs::read_to_string(root().join("src").join(file)).expect("a source file");
        if let Err(message) = plant(file, &source, &faults) {
            panic!("{}: {message}", file.display());
        }
    }
}

#[test]
fn names_are_different() {
    let faults = faults();
    let names: BTreeSet<_> = faults.iter().map(|fault| &fault.name).collect();
    assert_eq!(names.len(), faults.len());
}
