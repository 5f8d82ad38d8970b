//! Colours that can be told apart without red and green, on paper and on a screen.

use plotters::style::RGBColor;

/// For lines: those of Okabe and Ito (2008), without yellow, which is faint on white.
pub(super) const LINES: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
];

/// What was left out.
pub(super) const GREY: RGBColor = RGBColor(225, 225, 225);
/// The two ends of maps, on either side of white.
pub(super) const BLUE: RGBColor = RGBColor(8, 64, 129);
pub(super) const ORANGE: RGBColor = RGBColor(204, 85, 0);

/// A part of the way from white to a colour.
pub(super) fn tint(colour: RGBColor, part: f64) -> RGBColor {
    let mix = |channel: u8| {
        let mixed = 255.0 + part.clamp(0.0, 1.0) * (f64::from(channel) - 255.0);
        mixed.round() as u8
    };
    RGBColor(mix(colour.0), mix(colour.1), mix(colour.2))
}

/// Black or white, whichever is read more easily on a colour.
pub(super) fn ink(on: RGBColor) -> RGBColor {
    let light = 0.299 * f64::from(on.0) + 0.587 * f64::from(on.1) + 0.114 * f64::from(on.2);
    if light > 140.0 {
        RGBColor(0, 0, 0)
    } else {
        RGBColor(255, 255, 255)
    }
}
