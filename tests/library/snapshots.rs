//! Snapshots: plain text in `snapshots/`, to be read with the paper at hand.
//!
//! `INSTA_UPDATE=always cargo test --test library` writes them anew; then a person must look at what has
//! changed.

use std::collections::BTreeSet;

use sweep_cdt_testing::data;

use super::draw::{pictures, story};
use super::trace::figures;
use super::work;

/// Compares with the snapshot of this name.
pub(crate) fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

#[test]
fn every_snapshot_is_used() {
    let found: BTreeSet<String> = data::files(&data::path("snapshots"), "snap")
        .iter()
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    let names = figures::NAMES.iter().chain(work::NAMES);
    let names = names.chain(pictures::NAMES).chain(story::NAMES);
    let used: BTreeSet<String> = names.map(|name| (*name).to_owned()).collect();
    assert_eq!(found, used, "(left: the folder, right: the tests)");
}
