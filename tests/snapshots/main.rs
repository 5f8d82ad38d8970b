//! Snapshots: the steps of small inputs, one for each figure of the paper and each degenerate family,
//! and the amount of work for larger ones.
//!
//! They lie in `snapshots/`, plain text to be read with the paper at hand. `INSTA_UPDATE=always cargo
//! test --test snapshots` writes them anew; what changed must then be looked at by a person.
#![cfg(feature = "formats")]

mod figures;
mod work;

use std::collections::BTreeSet;
use std::path::Path;

/// Compares with the snapshot of this name.
fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

#[test]
fn every_snapshot_is_used() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let entries = std::fs::read_dir(folder).expect("a folder");
    let name = |entry: std::fs::DirEntry| entry.file_name().into_string().expect("a plain name");
    let found: BTreeSet<String> = entries
        .map(|entry| name(entry.expect("an entry")))
        .collect();
    let names = figures::NAMES.iter().chain(work::NAMES);
    let used: BTreeSet<String> = names.map(|name| format!("{name}.snap")).collect();
    assert_eq!(found, used, "(left: the folder, right: the tests)");
}
