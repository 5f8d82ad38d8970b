//! Lines over the number of points, both axes logarithmic: a panel for each kind of data.

use plotters::chart::ChartBuilder;
use plotters::prelude::IntoLogRange;
use plotters::style::{BLACK, Color, IntoFont, RGBColor, ShapeStyle};

use super::canvas::{Area, DRAWN, FONT, LINES, Place, TEXT, TITLE, fill, line, svg, text, tint};
use super::table::{Entry, distinct, entry};
use super::view::View;
use crate::measure::Row;

/// Pixels of a panel, of the title above, and of a line of the legend.
const PANEL: [u32; 2] = [400, 330];
const TOP: u32 = 40;
const LEGEND: u32 = 22;
/// Panels, and names of the legend, beside each other.
const ACROSS: usize = 2;

pub(super) fn draw(view: &View, rows: &[Row]) -> String {
    let kinds = distinct(rows.iter().map(|row| row.data.as_str()));
    let shown = rows.iter().filter(|row| point(view, row).is_some());
    let variants = distinct(shown.map(|row| row.variant.as_str()));
    let bounds = bounds(view, rows);
    let count = |n: usize| u32::try_from(n).expect("few");
    let panels = [
        count(kinds.len().min(ACROSS)),
        count(kinds.len().div_ceil(ACROSS)),
    ];
    let names = count(variants.len().div_ceil(ACROSS));
    let size = (
        PANEL[0] * panels[0].max(2),
        TOP + PANEL[1] * panels[1] + LEGEND * names + LEGEND,
    );
    svg(size, |area| {
        text(area, view.title, (10, 18), Place::Right, TITLE, BLACK);
        let (_, below) = area.split_vertically(TOP);
        let (upper, lower) = below.split_vertically(PANEL[1] * panels[1]);
        let places = upper.split_evenly((kinds.len().div_ceil(ACROSS), panels[0].max(2) as usize));
        for (kind, place) in kinds.iter().zip(&places) {
            panel(place, kind, view, rows, &variants, bounds);
        }
        legend(&lower, &variants);
    })
}

/// The least and greatest numbers of points, and those shown, all positive.
fn bounds(view: &View, rows: &[Row]) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY, f64::MIN_POSITIVE]; 2];
    for [x, y] in rows.iter().filter_map(|row| point(view, row)) {
        for (bounds, number) in bounds.iter_mut().zip([x, y]) {
            *bounds = [bounds[0].min(number), bounds[1].max(number)];
        }
    }
    bounds.map(|[low, high]| {
        if low < high {
            [low / 1.2, high * 1.2]
        } else {
            [0.1, 10.0]
        }
    })
}

/// Points and number of a row. What is not positive has no place on the axis.
fn point(view: &View, row: &Row) -> Option<[f64; 2]> {
    match entry(view, row) {
        Entry::Number(y) if y > 0.0 => Some([row.points as f64, y]),
        _ => None,
    }
}

fn panel(
    area: &Area<'_>,
    kind: &str,
    view: &View,
    rows: &[Row],
    variants: &[&str],
    [xs, ys]: [[f64; 2]; 2],
) {
    let mut chart = ChartBuilder::on(area)
        .caption(kind, (FONT, TEXT + 2).into_font())
        .margin(12)
        .x_label_area_size(38)
        .y_label_area_size(56)
        .build_cartesian_2d((xs[0]..xs[1]).log_scale(), (ys[0]..ys[1]).log_scale())
        .expect(DRAWN);
    chart
        .configure_mesh()
        .x_desc("points")
        .x_label_formatter(&|x| power(*x))
        .y_label_formatter(&|_| String::new())
        .x_labels(6)
        .y_labels(1)
        .label_style((FONT, TEXT - 1))
        .bold_line_style(tint(BLACK, 0.2))
        .light_line_style(tint(BLACK, 0.05))
        .draw()
        .expect(DRAWN);
    let pixel = |point: &(f64, f64)| {
        let (x, y) = chart.plotting_area().map_coordinate(point);
        let (across, down) = area.get_pixel_range();
        (x - across.start, y - down.start)
    };
    for y in ticks(ys) {
        let [left, right] = xs.map(|x| pixel(&(x, y)));
        line(area, vec![left, right], tint(BLACK, 0.15).stroke_width(1));
        let at = (left.0 - 6, left.1);
        text(area, &y.to_string(), at, Place::Left, TEXT - 2, BLACK);
    }
    for (i, variant) in variants.iter().enumerate() {
        let own = rows
            .iter()
            .filter(|row| row.data == kind && row.variant == *variant);
        let points: Vec<(f64, f64)> = own
            .filter_map(|row| point(view, row))
            .map(|[x, y]| (x, y))
            .collect();
        let points: Vec<(i32, i32)> = points.iter().map(pixel).collect();
        line(area, points.clone(), colour(i).stroke_width(2));
        for point in points {
            mark(area, i, point);
        }
    }
}

/// 1, 2 and 5 times powers of ten; powers alone where these are many.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let steps: &[f64] = if high / low < 1e3 {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0]
    };
    let powers = (-6..12).map(|power| 10_f64.powi(power));
    let all = powers.flat_map(|power| steps.iter().map(move |step| step * power));
    all.filter(|&tick| low <= tick && tick <= high).collect()
}

fn power(x: f64) -> String {
    if x >= 1000.0 {
        format!("{x:e}")
    } else {
        format!("{x}")
    }
}

fn colour(i: usize) -> RGBColor {
    LINES[i % LINES.len()]
}

/// A mark of this number's colour and form.
fn mark(area: &Area<'_>, i: usize, (x, y): (i32, i32)) {
    const R: i32 = 4;
    let style: ShapeStyle = colour(i).stroke_width(2);
    let path = |offsets: &[(i32, i32)]| {
        let points = offsets.iter().map(|&(across, down)| (x + across, y + down));
        line(area, points.collect(), style);
    };
    match i % LINES.len() {
        0 => fill(area, [(x - R, y - R), (x + R, y + R)], colour(i)),
        1 => {
            path(&[(-R, -R), (R, R)]);
            path(&[(-R, R), (R, -R)]);
        }
        2 => path(&[(0, -R - 1), (R, R), (-R, R), (0, -R - 1)]),
        3 => path(&[
            (0, -R - 1),
            (R + 1, 0),
            (0, R + 1),
            (-R - 1, 0),
            (0, -R - 1),
        ]),
        4 => {
            path(&[(-R - 1, 0), (R + 1, 0)]);
            path(&[(0, -R - 1), (0, R + 1)]);
        }
        5 => path(&[(-R, -R), (R, -R), (R, R), (-R, R), (-R, -R)]),
        _ => path(&[(0, R + 1), (R, -R), (-R, -R), (0, R + 1)]),
    }
}

fn legend(area: &Area<'_>, variants: &[&str]) {
    for (i, variant) in variants.iter().enumerate() {
        let across = i32::try_from(i % ACROSS).expect("few");
        let down = i32::try_from(i / ACROSS).expect("few");
        let [width, height] = [PANEL[0], LEGEND].map(|size| i32::try_from(size).expect("small"));
        let at = (60 + across * width, 8 + down * height);
        line(
            area,
            vec![(at.0 - 14, at.1), (at.0 + 14, at.1)],
            colour(i).stroke_width(2),
        );
        mark(area, i, at);
        text(area, variant, (at.0 + 24, at.1), Place::Right, TEXT, BLACK);
    }
}
