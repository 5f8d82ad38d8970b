//! A white drawing with texts and boxes, in pixels, and its colours: they can be told apart without red and
//! green, on paper and on a screen.

use plotters::coord::Shift;
use plotters::element::{PathElement, Rectangle, Text};
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, IntoFont, RGBColor, ShapeStyle, WHITE};

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The size of letters; a pixel is 1.24 of it.
pub(super) const TEXT: u32 = 16;
pub(super) const TITLE: u32 = 19;
pub(super) const FONT: &str = "sans-serif";

/// Writing to a text does not fail, and all drawings have the size that they say.
pub(super) const DRAWN: &str = "drawn into a text";

/// The SVG of what `draw` draws on an area of this size.
pub(super) fn svg(size: (u32, u32), draw: impl FnOnce(&Area<'_>)) -> String {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    root.fill(&WHITE).expect(DRAWN);
    draw(&root);
    root.present().expect(DRAWN);
    drop(root);
    svg
}

/// Where a text stands as seen from its point, and whether it is turned to run upwards.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Right,
    Left,
    Middle,
    Upwards,
}

pub(super) fn text(
    area: &Area<'_>,
    text: &str,
    at: (i32, i32),
    place: Place,
    size: u32,
    colour: RGBColor,
) {
    let horizontal = match place {
        Place::Right | Place::Upwards => HPos::Left,
        Place::Left => HPos::Right,
        Place::Middle => HPos::Center,
    };
    let turn = match place {
        Place::Upwards => FontTransform::Rotate270,
        _ => FontTransform::None,
    };
    let style = (FONT, size)
        .into_font()
        .transform(turn)
        .color(&colour)
        .pos(Pos::new(horizontal, VPos::Center));
    area.draw(&Text::new(text.to_owned(), at, style))
        .expect(DRAWN);
}

pub(super) fn fill(area: &Area<'_>, corners: [(i32, i32); 2], colour: RGBColor) {
    let style: ShapeStyle = colour.filled();
    area.draw(&Rectangle::new(corners, style)).expect(DRAWN);
}

pub(super) fn line(area: &Area<'_>, points: Vec<(i32, i32)>, style: ShapeStyle) {
    area.draw(&PathElement::new(points, style)).expect(DRAWN);
}

/// Colours for lines: those of Okabe and Ito (2008), without yellow, which is faint on white.
pub(super) const LINES: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
];

/// For what was left out.
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
