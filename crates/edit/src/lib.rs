#![doc = include_str!("../README.md")]

mod bounds;
mod conflicts;
mod edits;
mod error;
mod hints;
mod locate;
mod measure;
mod mesh;
mod natural;
mod nearest;
mod placed;
mod points;
mod refine;
mod region;
mod star;
mod sweep;
mod triangulation;
mod voronoi;
mod walk;

pub use bounds::{Bounds, BoundsError, Broken};
pub use edits::{Change, Edits};
pub use error::EditError;
pub use refine::{Left, Reason, RefineError, Refined, Refinement};
pub use triangulation::DynamicTriangulation;
pub use voronoi::{Ridge, Voronoi, VoronoiError};
