//! Pictures, as SVG, of a result and of what is wrong with one; and of the steps of a trace, as SVG or as
//! a page for a browser.

mod caption;
mod circle;
mod legend;
mod mesh_style;
mod palette;
mod panels;
mod plane;
mod result;
mod steps;
mod svg;
mod trails;
mod violations;
mod window;

pub use result::ResultPicture;
pub use steps::{StepsPage, StepsSheet};
pub use violations::ViolationsPicture;
