//! Parts that the tests, the benchmarks and the fuzz targets share, and that tests of other programs can use
//! (README.md).
//!
//! * [`generators`] turn bytes into inputs that are degenerate nearly every time; [`Random`] makes bytes
//!   and numbers from a seed.
//! * [`asked`] says of which kinds a question is.
//! * [`families`] are inputs that grow, the attacks on every promise about time; [`clouds`] and
//!   [`segments()`] are the usual ones.
//! * [`data`] reads the test data; [`binary`] writes inputs for other programs.
//! * [`oracle`] computes what the result must be, in exact integers and without any code of the crate.
//! * [`conformance`](mod@conformance) tests a scalar of your own.
//! * [`judge`] decides with the oracle and the verifier whether another program is right; [`suite`] has inputs with their
//!   one right answer.
//! * [`runs`] lists every scalar with every front and setting of the heuristics; [`Steps`] records one run
//!   step by step; [`fronts`] lets both choose a front when the program runs.
//! * [`tuned`] triangulates small inputs as if they were large, every second one by a hash.
//! * `edits` (with the feature of this name) compares histories of edits with fresh runs.
//! * [`streams`] pushes an input vertex by vertex, and puts together what comes out.
//! * [`boundary`] finds the closed chains around a set of triangles.
//! * [`page`] reads a page of steps as its script does.
//! * [`minimize`] makes a failing input small; [`names`] reads words of the command.
//! * `peers` (with the feature of this name) calls other crates that triangulate.
//!
//! docs/testing.md describes the tests that are made of this.

pub mod any_front;
pub mod asked;
pub mod binary;
pub mod clouds;
pub mod conformance;
pub mod counted;
pub mod data;
#[cfg(feature = "edits")]
pub mod edits;
pub mod families;
pub mod fronts;
pub mod generators;
pub mod judge;
pub mod minimize;
pub mod names;
pub mod oracle;
pub mod page;
#[cfg(feature = "peers")]
pub mod peers;
pub mod runs;
mod samples;
pub mod streams;
pub mod suite;
pub mod tuned;

pub use any_front::AnyFront;
pub use arbitrary;
pub use clouds::segments;
pub use counted::{counted, watched};
pub use data::Input;
pub use fronts::Steps;
pub use oracle::boundary;
pub use sweep_cdt_generate::Random;
