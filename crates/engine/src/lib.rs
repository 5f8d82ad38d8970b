//! What the front ends of [`sweep_cdt`] share: the command, the package for Python, and the page that computes.
//!
//! A front end reads an input, asks here, and prints. So a rule has one name everywhere, and all front ends give the same
//! verdict and the same advice on the same triangles, and say the same about them ([`remarks()`], [`Remark`]).
//!
//! [`Inside`] is a rule by its name, and finds the interior of an [`Input`]. [`Question`] verifies triangles within a
//! domain, and says what to do where they are wrong ([`Advice`]). [`Settings`] are the algorithm, the front and the
//! heuristics by their names. [`RefinedFile`] is a mesh within bounds with what its file says, and [`violators`] are the
//! triangles that break bounds.

mod advice;
mod bounds;
mod cells;
mod inside;
mod missing;
mod question;
mod refine;
mod remarks;
mod sentence;
mod settings;
mod verdict;
mod wanted;

pub use advice::{Advice, Fit, How, Setting, Several};
pub use bounds::{
    OUT_OF_BOUNDS, Violator, broken, of_mesh, size, size_in_words, violators, with_bounds,
};
pub use cells::{Clip, cells};
pub use inside::{Input, Inside};
pub use missing::{Missing, MissingError};
pub use question::{Question, Triangulate, Verify};
pub use refine::{RefinedFile, bounds_or_default, region_areas};
pub use remarks::{remarks, without_heights};
pub use sentence::Words;
pub use settings::{
    ALGORITHMS, Choice, FRONTS, FrontKind, HEURISTICS, Settings, UnknownName, chosen,
};
pub use sweep_cdt_formats::Remark;
pub use verdict::{Answer, Verdict, counts, headline, nothing_free};

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
