//! Nanoseconds a point against the number of points, as SVG: a panel for each family of several sizes.

use std::error::Error;

use plotters::prelude::*;

use crate::measure::{Calls, Row, Verdict};
use crate::report::programs;

/// The families with a panel.
const FAMILIES: [&str; 3] = ["uniform", "segments", "polygons"];

const SIZE: (u32, u32) = (1200, 560);

/// The plot; times of programs whose answers are no triangulations are left out.
pub(crate) fn plot(rows: &[Row]) -> String {
    let mut svg = String::new();
    let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    draw(&root, rows).expect("a plot in memory");
    drop(root);
    svg
}

fn draw<D: DrawingBackend>(
    root: &DrawingArea<D, plotters::coord::Shift>,
    rows: &[Row],
) -> Result<(), Box<dyn Error>>
where
    D::ErrorType: 'static,
{
    root.fill(&WHITE)?;
    let programs = programs(rows.iter());
    for (area, family) in root.split_evenly((1, FAMILIES.len())).iter().zip(FAMILIES) {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.family == family).collect();
        let curves: Vec<Vec<(f64, f64)>> = programs.iter().map(|name| curve(&rows, name)).collect();
        let all = || curves.iter().flatten();
        let (Some(least), Some(most)) = (
            all().map(|p| p.0).min_by(f64::total_cmp),
            all().map(|p| p.0).max_by(f64::total_cmp),
        ) else {
            continue;
        };
        let top = all().map(|p| p.1).fold(0.0, f64::max);
        let bottom = all().map(|p| p.1).fold(f64::INFINITY, f64::min);
        // As much room again above the curves, for the names.
        let room = top * (top / bottom);
        let mut chart = ChartBuilder::on(area)
            .caption(family, ("sans-serif", 18))
            .margin(8)
            .x_label_area_size(36)
            .y_label_area_size(48)
            .build_cartesian_2d(
                (least / 1.2..most * 1.2).log_scale(),
                (bottom / 1.3..room).log_scale(),
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .y_labels(6)
            .x_desc("points")
            .y_desc("ns a point")
            .x_label_formatter(&|x| format!("{x:.0e}"))
            .y_label_formatter(&|y| format!("{y:.0}"))
            .draw()?;
        for (i, (name, curve)) in programs.iter().zip(curves).enumerate() {
            if curve.is_empty() {
                continue;
            }
            let color = Palette99::pick(i).to_rgba();
            let style = color.stroke_width(if i == 0 { 3 } else { 1 });
            chart.draw_series(PointSeries::of_element(
                curve.iter().copied(),
                3,
                color.filled(),
                &|p, size, style| Circle::new(p, size, style),
            ))?;
            chart
                .draw_series(LineSeries::new(curve, style))?
                .label(*name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], style));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.8))
            .label_font(("sans-serif", 11))
            .draw()?;
    }
    root.present()?;
    Ok(())
}

/// The points of one program's curve.
fn curve(rows: &[&Row], program: &str) -> Vec<(f64, f64)> {
    let point = |row: &&Row| {
        let cell = row.cells.iter().find(|cell| cell.program == program)?;
        let outcome = cell.outcome.ok()?;
        (outcome.verdict != Verdict::Wrong)
            .then_some((row.size[0] as f64, outcome.time(Calls::First)[0]))
    };
    rows.iter().filter_map(point).collect()
}
