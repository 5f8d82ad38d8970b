//! The tests of the library as one program: every run (scalar, front, heuristics) against an oracle.
//!
//! * `oracle`: what the result must be, written for clarity, in exact integers, from the definition.
//! * `runs`: the table of scalars, fronts and heuristics. A new one is one line there.
//! * `cases`: small named inputs. `hard`: inputs that broke other programs. `random`: generated ones.
//! * `statistics`: what a run tells of itself.
//! * `trace`: the steps are the same for every scalar and front, and replaying them gives the result.
//!
//! `SWEEP_CDT_CASES` sets how many random inputs are tried, `SWEEP_CDT_SEED` where they begin, and
//! `SWEEP_CDT_HARD` names a folder of further hard inputs.

mod cases;
mod generators;
mod hard;
mod limits;
mod oracle;
mod random;
mod runs;
mod statistics;
mod trace;
