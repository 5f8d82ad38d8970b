//! Pictures, as SVG, of a result and of Voronoi cells (also as PNG), of what is wrong with a result, and of edges that
//! cross; and of the steps of a trace, as SVG or as a page for a browser.

mod cells;
mod close_up;
mod crossings;
mod font;
mod layout;
mod output;
mod panels;
mod pixels;
mod png;
mod raster;
mod relief;
mod relief_legend;
mod result;
mod steps;
mod style;
mod svg;
mod trails;
mod violations;
mod window;

pub use cells::CellsPicture;
pub use crossings::CrossingsPicture;
pub use output::{write, write_interior};
pub use result::ResultPicture;
pub use steps::{StepsPage, StepsSheet};
pub use violations::ViolationsPicture;

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
