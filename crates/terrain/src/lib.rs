//! Contour lines of triangulated terrain, and heights of other points on it.
//!
//! A [`Surface`] is a triangulation, or the part of it that is inside, with a height for each vertex; between vertices
//! it is flat in each triangle. Every decision is exact: which sides a level crosses is a comparison of two heights,
//! where a point lies is the sign of a predicate. Only the coordinates and heights that come out are rounded.
//! [`contours`](Surface::contours) takes time linear in triangles and lines, [`heights_at`](Surface::heights_at)
//! O((n + m) log(n + m)) for n triangles and m points, whatever they are. [`Places`] tells where points lie, or which
//! place on the border is nearest.
//!
//! For terrain that no memory holds, triangles may also pass one by one, each corner a [`Corner`]: [`PassingContours`]
//! joins the same lines of them, and a [`Raster`] gives the cells of a [`Grid`] the same heights.

mod contours;
mod grid;
mod heights;
mod interpolate;
mod levels;
mod passing;
mod places;
mod raster;
mod surface;

pub use contours::{Contour, TooManyPieces};
pub use grid::Grid;
pub use levels::{LevelsError, levels};
pub use passing::{Corner, PassingContours};
pub use places::Places;
pub use raster::Raster;
pub use surface::Surface;

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
