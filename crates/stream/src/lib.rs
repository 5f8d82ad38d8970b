//! Triangulations of inputs larger than memory, with [`sweep_cdt`]: points and edges sorted in external memory, a
//! triangulation that passes on triangles as soon as they are final, and a verifier that reads a result once.
//!
//! - `external` brings an input of any length into the order of the sweep (with the feature `external`, a default).
//! - [`Stream`] takes vertices in the order of the sweep, and passes on triangles that are final.
//! - [`Cut`] and [`Rest`] do that with the bands of an input, each apart from the others, on any machine; [`settle_all`] with
//!   all of them, on all cores.
//! - [`StreamVerifier`] judges triangles that come in any order.

#[cfg(feature = "external")]
pub mod external;
mod stream;
mod verify;

pub use stream::{
    Alive, Carried, Cut, Final, Rest, RestError, Stream, StreamError, StreamStats, settle_all,
};
pub use verify::{StreamReport, StreamVerifier, StreamViolation};

/// The example of the README, as a test.
#[cfg(all(doctest, feature = "external"))]
#[doc = include_str!("../README.md")]
struct Readme;
