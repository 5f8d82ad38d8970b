//! The colours of every picture, each defined here and nowhere else.
//!
//! Most are from Okabe and Ito's palette, which colour-blind readers can tell apart. Lines of different
//! kinds also differ in width or dashes, so that no picture depends on colour alone.

/// Text, vertices, and what a step points at.
pub(super) const INK: &str = "#1B1F23";
/// Sides of triangles.
pub(super) const GREY: &str = "#848E98";
/// Frames of panels.
pub(super) const MIST: &str = "#C9CED3";
/// The inside of the triangulation.
pub(super) const SAND: &str = "#F6F5F1";
/// The background.
pub(super) const PAPER: &str = "#FFF";
/// Input edges.
pub(super) const BLUE: &str = "#0072B2";
/// The hull.
pub(super) const ORANGE: &str = "#E69F00";
/// Violations.
pub(super) const RED: &str = "#D5190B";
