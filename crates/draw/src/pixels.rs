//! The picture of a triangulation as pixels: what the SVG shows, in the same colours and places.

use std::io::{self, Write};

use super::layout::Layout;
use super::png;
use super::raster::Raster;
use super::relief_legend::ReliefLegend;
use super::style::{
    BLUE, GREY, INK, LEGEND_HEIGHT, ON_RELIEF, ORANGE, OUTSIDE, PAPER, RAMP, Rgb, SAMPLE, SAND,
    SLATE, UMBER, legend_places, mesh_width, rgb,
};
use super::window::PIXEL;
use sweep_cdt_formats::Numbering;

/// Draws a picture and writes it as PNG.
pub(super) fn write(layout: &Layout, numbering: Numbering, out: &mut impl Write) -> io::Result<()> {
    let places = &layout.places;
    let mut raster = Raster::new(layout.whole_size(), rgb(PAPER));
    let along = |trail: &[usize]| -> Vec<[i64; 2]> { trail.iter().map(|&v| places[v]).collect() };
    let is_relief = layout.relief.is_some();
    let thinner = if is_relief { ON_RELIEF } else { 1.0 };
    let width = |class, scale: f64| mesh_width(class, layout.spacing * scale) as f64;

    // Areas and lines, from back to front.
    let [outside, dash, gap] = OUTSIDE;
    if let Some(hull) = &layout.outside {
        raster.stroke_dashed(rgb(SLATE), outside, [dash, gap], &along(hull));
    }
    let steps = layout.border.iter().flat_map(|chain| chain.windows(2));
    raster.fill(
        rgb(SAND),
        steps.map(|step| [places[step[0]], places[step[1]]]),
    );
    for chain in &layout.border {
        raster.stroke(rgb(ORANGE), width("hull", 1.0), &along(chain));
    }
    for (colour, sides) in layout.relief.iter().flat_map(|relief| &relief.colours) {
        raster.fill(*colour, sides.iter().map(|ends| ends.map(|v| places[v])));
    }
    for trail in &layout.sides {
        raster.stroke(rgb(GREY), width("side", thinner), &along(trail));
    }
    for trail in &layout.edges {
        raster.stroke(
            edge_colour(is_relief),
            width("edge", thinner),
            &along(trail),
        );
    }
    for &v in &layout.dots {
        raster.dot(rgb(INK), width("vertex", 1.0), places[v]);
    }
    for &v in &layout.numbered {
        let [x, y] = places[v];
        let number = (v + numbering.vertex).to_string();
        raster.text(rgb(INK), [x + 7 * PIXEL, y - 7 * PIXEL], &number);
    }
    draw_legend(&mut raster, layout);
    let (width, pixels) = raster.pixels();
    png::write(&pixels, width, out)
}

fn draw_legend(raster: &mut Raster, layout: &Layout) {
    let [middle, mut top] = [layout.size[0] / 2, layout.size[1]];
    if let Some(relief) = &layout.relief {
        let legend = ReliefLegend::new([middle, top], relief);
        for (colour, corners) in legend.boxes {
            raster.fill_box(colour, corners);
        }
        let ([x, y], low) = legend.low;
        raster.text(rgb(INK), [x - Raster::text_width(&low), y], &low);
        for (place, text) in [legend.high].into_iter().chain(legend.missing) {
            raster.text(rgb(INK), place, &text);
        }
        top += LEGEND_HEIGHT;
    }
    let entries = layout.entries.iter();
    for ((class, text), places) in entries.zip(legend_places([middle, top], layout.entries.len())) {
        let [[x, y], text_place] = places;
        let line = [[x, y], [x + SAMPLE, y]];
        match *class {
            "side" => raster.stroke(rgb(GREY), 120.0, &line),
            "edge" => raster.stroke(edge_colour(layout.relief.is_some()), 300.0, &line),
            "relief" => raster.stroke(RAMP[2], 700.0, &line),
            "hull" => raster.stroke(rgb(ORANGE), 700.0, &line),
            "outside" => {
                let [width, dash, gap] = OUTSIDE;
                raster.stroke_dashed(rgb(SLATE), width, [dash, gap], &line);
            }
            _ => raster.stroke_dashed(rgb(INK), 700.0, [1.0, 1150.0], &line),
        }
        raster.text(rgb(INK), text_place, text);
    }
}

fn edge_colour(is_relief: bool) -> Rgb {
    rgb(if is_relief { UMBER } else { BLUE })
}
