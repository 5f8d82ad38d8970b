//! The tests of the library as one program, so that what they share is compiled once.
//!
//! * `cases`: small named inputs. `hard`: inputs that broke other programs. `random`: generated ones. Each
//!   goes through `runs` (every scalar with every front and setting of the heuristics) and is compared with
//!   the oracle of `sweep_cdt_testing`, which is itself tested in `oracle`. `limits`: the largest numbers,
//!   and what is refused.
//! * `trace`: the steps of the paper's figures, which are snapshots; the steps are the same for every scalar
//!   and front, and a replay returns the result.
//! * `draw`: the sentences of the drawn steps, and one picture of each kind, as snapshots.
//! * `work`: how much work larger inputs take, as snapshots. `statistics`: what a run reports of itself.
//! * `bands`: the sweep on all cores.
//! * `growth`: no family of inputs takes more than its share of work, and none that is abandoned by the
//!   sweep has another result. `contradictions`: scalars that are not exact end in a panic that says so.
//! * `fronts`: what a run returns of its front, progress and statistics. `files`: odd files.
//! * `properties`: the bodies of the fuzz targets on their seeds, on past findings and on random bytes.
//! * `scalars`, `domain` and `verify`: the exact predicates, what is inside, and the verifier.
//!
//! `SWEEP_CDT_CASES` sets how many random inputs are tried, `SWEEP_CDT_SEED` where they begin,
//! `SWEEP_CDT_DOMAINS` how many rings, and `SWEEP_CDT_HARD` names a folder of further hard inputs. docs/testing.md has more.
#![cfg(feature = "cli")]

mod bands;
mod cases;
mod contradictions;
#[path = "../domain/mod.rs"]
mod domain;
mod draw;
mod files;
mod fronts;
mod generators;
mod growth;
mod hard;
mod limits;
mod oracle;
mod properties;
mod random;
mod runs;
#[path = "../scalars/mod.rs"]
mod scalars;
mod snapshot_names;
mod snapshots;
mod statistics;
mod trace;
#[path = "../verify/mod.rs"]
mod verify;
mod work;
