//! A white drawing with texts and boxes, in pixels.

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
