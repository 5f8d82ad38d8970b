//! Pictures, as SVG, of a result and of what is wrong with one; and of the steps of a trace, as SVG or as
//! a page for a browser.

mod close_up;
mod panels;
mod result;
mod steps;
mod style;
mod svg;
mod violations;
mod window;

pub use result::ResultPicture;
pub use steps::{StepsPage, StepsSheet};
pub use violations::ViolationsPicture;
