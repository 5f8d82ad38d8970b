#![doc = include_str!("../README.md")]

mod conflicts;
mod edits;
mod error;
mod hints;
mod locate;
mod mesh;
mod placed;
mod points;
mod region;
mod sweep;
mod triangulation;
mod walk;

pub use edits::{Change, Edits};
pub use error::EditError;
pub use triangulation::DynamicTriangulation;
