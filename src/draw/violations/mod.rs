//! The picture of what is wrong with a triangulation: an overview, then close-ups of the first violations.

mod background;
mod close_up;
mod overview;
mod picture;

pub use picture::ViolationsPicture;
