//! The snapshots in the folder are those that the tests use.

use std::collections::BTreeSet;

use sweep_cdt_testing::data;

use super::draw::{pictures, story};
use super::trace::figures;
use super::work;

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
