//! The colours of every picture, each defined here and nowhere else.
//!
//! Most are from Okabe and Ito's palette, which colour-blind readers can tell apart. Lines of different
//! kinds also differ in width or dashes, so that no picture depends on colour alone.

/// Text, vertices, and what a step points at.
pub(super) const INK: &str = "#1B1F23";
/// Secondary text, and pierced triangles.
pub(super) const SLATE: &str = "#5B646D";
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
/// The hull, and the advancing front.
pub(super) const ORANGE: &str = "#E69F00";
/// What appears, and what is legal.
pub(super) const GREEN: &str = "#009E73";
/// What disappears, and what is illegal.
pub(super) const VERMILION: &str = "#D55E00";
/// The sweep line.
pub(super) const PURPLE: &str = "#CC79A7";
/// The upper pseudo-polygon.
pub(super) const SKY: &str = "#56B4E9";
/// The lower pseudo-polygon.
pub(super) const OCHRE: &str = "#B8A500";
/// Violations.
pub(super) const RED: &str = "#D5190B";

/// The colours that the page of steps names: `var(--ink)` in its style sheet, `colour("ink")` in its script.
pub(super) const OF_PAGE: [(&str, &str); 7] = [
    ("ink", INK),
    ("slate", SLATE),
    ("grey", GREY),
    ("mist", MIST),
    ("paper", PAPER),
    ("blue", BLUE),
    ("orange", ORANGE),
];
