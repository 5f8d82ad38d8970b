//! Lines over the number of points with their fits, a panel for each kind of data; or over an angle, a line for each
//! kind. All axes are logarithmic.

use plotters::chart::ChartBuilder;
use plotters::prelude::IntoLogRange;
use plotters::style::{BLACK, Color, IntoFont, RGBColor, ShapeStyle};

use super::canvas::{Area, DRAWN, FONT, LINES, Place, TEXT, TITLE, fill, line, svg, text, tint};
use super::fit::Fit;
use super::table::{Entry, distinct, entry};
use super::view::{Shape, View};
use crate::measure::Row;

/// Pixels of a panel, of the title above, and of a line of the legend.
const PANEL: [u32; 2] = [400, 330];
const TOP: u32 = 40;
const LEGEND: u32 = 22;
/// Panels, and names of the legend, beside each other.
const ACROSS: usize = 2;

/// A panel: its title, and the points of each line, which has the same number in all panels.
struct Panel {
    title: String,
    lines: Vec<(usize, Vec<[f64; 2]>)>,
}

pub(super) fn draw(view: &View, rows: &[Row]) -> String {
    let is_angles = view.shape == Shape::Angles;
    // The kinds of data make the panels and the variants the lines, or the other way round.
    let panel_of = |row: &Row| {
        if is_angles {
            angle(row).map(|(setting, _)| setting)
        } else {
            Some(row.data.clone())
        }
    };
    let line_of = |row: &Row| {
        if is_angles {
            row.data.clone()
        } else {
            row.variant.clone()
        }
    };
    let x_of = |row: &Row| {
        if is_angles {
            angle(row).map(|(_, degrees)| degrees)
        } else {
            Some(row.points as f64)
        }
    };
    let is_shown = |row: &&Row| {
        panel_of(row).is_some() && matches!(entry(view, &[row]), Entry::Number(y) if y > 0.0)
    };
    let greatest = rows.iter().map(|row| row.size).max();
    let shown: Vec<&Row> = rows
        .iter()
        .filter(is_shown)
        .filter(|row| !is_angles || Some(row.size) == greatest)
        .collect();
    let names = distinct(shown.iter().map(|row| line_of(row)));
    let titles = distinct(shown.iter().filter_map(|row| panel_of(row)));
    let panel = |title: String| {
        let points = |name: &String| {
            let own: Vec<&Row> = shown
                .iter()
                .copied()
                .filter(|row| line_of(row) == *name && panel_of(row).as_ref() == Some(&title))
                .collect();
            let xs = distinct(own.iter().filter_map(|row| x_of(row)));
            let at = xs.into_iter().filter_map(|x| {
                let there: Vec<&Row> = own
                    .iter()
                    .copied()
                    .filter(|row| x_of(row) == Some(x))
                    .collect();
                match entry(view, &there) {
                    Entry::Number(y) => Some([x, y]),
                    _ => None,
                }
            });
            at.collect()
        };
        Panel {
            lines: names.iter().map(points).enumerate().collect(),
            title,
        }
    };
    let panels: Vec<Panel> = titles.into_iter().map(panel).collect();
    let bounds = bounds(
        panels
            .iter()
            .flat_map(|panel| &panel.lines)
            .flat_map(|(_, points)| points),
        is_angles,
    );
    let count = |n: usize| u32::try_from(n).expect("few");
    let down = panels.len().div_ceil(ACROSS);
    let size = (
        PANEL[0] * count(ACROSS),
        TOP + PANEL[1] * count(down) + LEGEND * count(names.len().div_ceil(ACROSS)) + LEGEND,
    );
    svg(size, |area| {
        text(area, view.title, (10, 18), Place::Right, TITLE, BLACK);
        let (_, below) = area.split_vertically(TOP);
        let (upper, lower) = below.split_vertically(PANEL[1] * count(down));
        for (panel, place) in panels.iter().zip(&upper.split_evenly((down, ACROSS))) {
            draw_panel(place, panel, bounds, is_angles);
        }
        legend(&lower, &names);
    })
}

/// The setting and the angle in the name of a variant such as "one corner up to 104°".
fn angle(row: &Row) -> Option<(String, f64)> {
    let (setting, degrees) = row.variant.split_once(" up to ")?;
    Some((setting.to_owned(), degrees.strip_suffix('°')?.parse().ok()?))
}

/// The least and greatest x and y, which are positive, with a margin.
fn bounds<'a>(points: impl Iterator<Item = &'a [f64; 2]>, is_angles: bool) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY, f64::MIN_POSITIVE]; 2];
    for point in points {
        for (bounds, &number) in bounds.iter_mut().zip(point) {
            *bounds = [bounds[0].min(number), bounds[1].max(number)];
        }
    }
    let margins = if is_angles { [1.01, 1.2] } else { [1.2, 1.2] };
    let around = |i: usize| match bounds[i] {
        [low, high] if low < high => [low / margins[i], high * margins[i]],
        _ => [0.1, 10.0],
    };
    [around(0), around(1)]
}

fn draw_panel(area: &Area<'_>, panel: &Panel, [xs, ys]: [[f64; 2]; 2], is_angles: bool) {
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, (FONT, TEXT + 2).into_font())
        .margin(12)
        .x_label_area_size(38)
        .y_label_area_size(56)
        .build_cartesian_2d((xs[0]..xs[1]).log_scale(), (ys[0]..ys[1]).log_scale())
        .expect(DRAWN);
    let unit = if is_angles { "degrees" } else { "points" };
    chart
        .configure_mesh()
        .x_desc(unit)
        .x_label_formatter(&|x| if is_angles { String::new() } else { power(*x) })
        .y_label_formatter(&|_| String::new())
        .x_labels(6)
        .y_labels(1)
        .label_style((FONT, TEXT - 1))
        .bold_line_style(tint(BLACK, 0.2))
        .light_line_style(tint(BLACK, 0.05))
        .draw()
        .expect(DRAWN);
    let pixel = |[x, y]: [f64; 2]| {
        let (x, y) = chart.plotting_area().map_coordinate(&(x, y));
        let (across, down) = area.get_pixel_range();
        (x - across.start, y - down.start)
    };
    for y in ticks(ys) {
        let [left, right] = xs.map(|x| pixel([x, y]));
        line(area, vec![left, right], tint(BLACK, 0.15).stroke_width(1));
        let at = (left.0 - 6, left.1);
        text(area, &y.to_string(), at, Place::Left, TEXT - 2, BLACK);
    }
    if is_angles {
        for x in (90..=180)
            .step_by(5)
            .map(f64::from)
            .filter(|x| xs[0] <= *x && *x <= xs[1])
        {
            let (across, down) = pixel([x, ys[0]]);
            text(
                area,
                &x.to_string(),
                (across, down + 10),
                Place::Middle,
                TEXT - 2,
                BLACK,
            );
        }
    }
    for (i, points) in &panel.lines {
        let pixels: Vec<(i32, i32)> = points.iter().map(|&point| pixel(point)).collect();
        match Fit::of(points) {
            // The line is the fit, so that the residuals are seen.
            Some(fit) if !is_angles => {
                let ends = [points[0][0], points[points.len() - 1][0]];
                line(
                    area,
                    ends.map(|x| pixel([x, fit.at(x)])).to_vec(),
                    colour(*i).stroke_width(1),
                );
            }
            _ => line(area, pixels.clone(), colour(*i).stroke_width(2)),
        }
        for point in pixels {
            mark(area, *i, point);
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

fn legend(area: &Area<'_>, variants: &[String]) {
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
