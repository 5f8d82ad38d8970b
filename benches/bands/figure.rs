//! Time against workers, as SVG: a panel for each number of points. Marks tell the lines apart without colours.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::measure::Band;
use crate::simulate::{Plan, Run, best};

const SIZE: (u32, u32) = (1000, 470);
const WORKERS: [usize; 10] = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const FONT: &str = "sans-serif";

/// A line: what it shows, its colour, how its runs differ, which of their times it takes.
type Line = (&'static str, RGBColor, fn(Plan) -> Plan, fn(&Run) -> f64);

const LINES: [Line; 4] = [
    (
        "one machine sorts",
        RGBColor(213, 94, 0),
        |plan| Plan {
            sorted_by_one: true,
            ..plan
        },
        Run::total,
    ),
    (
        "all sort, one file system",
        RGBColor(0, 0, 0),
        |plan| plan,
        Run::total,
    ),
    (
        "all sort, a disk each",
        RGBColor(0, 114, 178),
        |plan| Plan {
            served: plan.workers,
            ..plan
        },
        Run::total,
    ),
    (
        "of it: joins alone",
        RGBColor(0, 158, 115),
        |plan| Plan {
            served: plan.workers,
            ..plan
        },
        |run| run.joins,
    ),
];

/// The figure of the two largest inputs.
pub(crate) fn svg(all: &[Vec<Band>], sort: f64) -> String {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    let panels = root.split_evenly((1, 2));
    root.fill(&WHITE).expect("a plot in memory");
    for (panel, bands) in panels.iter().zip(&all[all.len() - 2..]) {
        draw(panel, bands, sort).expect("a plot in memory");
    }
    root.present().expect("a plot in memory");
    drop((panels, root));
    svg
}

fn draw<'a>(
    area: &DrawingArea<SVGBackend<'a>, Shift>,
    bands: &[Band],
    sort: f64,
) -> Result<(), Box<dyn Error + 'a>> {
    let mut chart = ChartBuilder::on(area)
        .caption(format!("{:.0e} points", bands[0].total as f64), (FONT, 20))
        .margin(10)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((0.9..1200.0).log_scale(), (0.5..200_000.0).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("workers")
        .y_desc("seconds")
        .label_style((FONT, 16))
        .x_label_formatter(&|x| format!("{x:.0}"))
        .y_label_formatter(&|y| format!("{y:.0}"))
        .draw()?;
    for (i, (name, color, of, time)) in LINES.into_iter().enumerate() {
        // Told apart without colours.
        let (size, style) = match i {
            0 => (3, color.filled()),
            1 => (5, color.filled()),
            2 => (6, color.stroke_width(2)),
            _ => (4, color.stroke_width(1)),
        };
        let mark = |at| Circle::new(at, size, style);
        let point = |w: &usize| (*w as f64, time(&best(bands, sort, of(Plan::of(*w)))));
        let points: Vec<(f64, f64)> = WORKERS.iter().map(point).collect();
        chart.draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?;
        chart
            .draw_series(points.into_iter().map(mark))?
            .label(name)
            .legend(move |(x, y)| Circle::new((x + 13, y), size, style));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE)
        .label_font((FONT, 15))
        .draw()?;
    Ok(())
}
