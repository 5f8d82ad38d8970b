//! The tests of the library as one program, so that what they share is compiled once.
//!
//! * `cases`: small named inputs. `hard`: inputs that broke other programs. `random`: generated ones. Each
//!   goes through `runs` (every scalar with every front and setting of the heuristics) and is compared with
//!   the oracle of `sweep_cdt_testing`, which is itself tested in `random`. `limits`: the largest numbers,
//!   what is refused, and scalars that are not exact, which end in a panic that says so.
//! * `conformance`: the suite of conformance in `tests/conformance`, against the answers that it names.
//! * `trace`: the steps of the paper's figures, which are snapshots; the
//!   steps are the same for every scalar and front, and a replay returns the result.
//! * `slant`, `waiting`: edges that pierce many triangles, in any order.
//! * `work`: how much work larger inputs take, as a snapshot; no family of inputs takes more than its share of
//!   work, and none that is abandoned by the sweep has another result.
//! * `crossings`: edges that cross, and how the search for them grows.
//! * `location`: where points lie, and what is around a vertex. `input`: points and edges in other forms.
//!   `serialized`: results as data.
//! * `statistics`: what a run reports of itself and its progress. `fronts`: the steps that search structures
//!   leave. `bands`: the sweep on all cores. `picture`: the one of the documentation.
//! * `scalars`, `domain` and `verify`: the exact predicates, what is inside, and the verifier.
//!
//! `SWEEP_CDT_CASES` sets how many random inputs are tried, `SWEEP_CDT_SEED` where they begin,
//! `SWEEP_CDT_DOMAINS` how many rings, and `SWEEP_CDT_HARD` names a folder of further hard inputs. docs/testing.md
//! has more.
//!
//! Snapshots are plain text in `snapshots/`, to be read with the paper at hand.
//! `INSTA_UPDATE=always cargo test --test library` writes them anew; then a person must look at what has changed.

mod bands;
mod cases;
mod conformance;
mod crossings;
#[path = "../domain/mod.rs"]
mod domain;
mod fronts;
mod hard;
mod input;
mod limits;
mod location;
mod order;
mod picture;
mod random;
mod runs;
#[path = "../scalars/mod.rs"]
mod scalars;
mod serialized;
mod slant;
mod statistics;
mod trace;
#[path = "../verify/mod.rs"]
mod verify;
mod waiting;
mod work;

use std::collections::BTreeSet;

use sweep_cdt_testing::data;

/// Compares with the snapshot of this name.
fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// The snapshots in the folder are those that the tests use.
#[test]
fn every_snapshot_is_used() {
    let found: BTreeSet<String> = data::files(&data::path("snapshots"), "snap")
        .iter()
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    let names = trace::NAMES.iter().chain(work::NAMES);
    let used: BTreeSet<String> = names.map(|name| (*name).to_owned()).collect();
    assert_eq!(found, used, "(left: the folder, right: the tests)");
}
