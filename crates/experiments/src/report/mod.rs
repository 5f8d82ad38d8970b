//! The report: tables in Markdown and plots in SVG, of all rows of an experiment.

mod boxes;
mod canvas;
mod fit;
mod growth;
mod markdown;
mod ratio;
mod table;
mod view;

use std::fs;
use std::io;
use std::path::Path;

use crate::measure::Row;
pub(crate) use fit::Fit;
pub(crate) use markdown::{Method, commit};
pub(crate) use ratio::Ratio;
pub(crate) use table::distinct;
pub(crate) use view::{Plot, Shape, View};

/// Writes the report and its plots into a folder.
///
/// # Errors
/// A line for the user if a file cannot be written.
pub(crate) fn write(
    folder: &Path,
    method: &Method<'_>,
    views: &[View],
    remarks: &str,
    rows: &[Row],
) -> io::Result<()> {
    let mut text = markdown::head(method, rows);
    for view in views.iter().filter(|view| is_known(view, rows)) {
        let (tables, plots) = show(view, rows);
        text.push_str(&markdown::section(view, &tables, &plots));
        for plot in plots {
            fs::write(folder.join(plot.file), plot.svg)?;
        }
    }
    text.push_str(remarks);
    fs::write(folder.join("report.md"), text)
}

/// Whether a view has any number: times may not have been measured.
fn is_known(view: &View, rows: &[Row]) -> bool {
    rows.iter().any(|row| (view.measure)(row).is_some())
}

/// The plots of a view.
pub(crate) fn plots(view: &View, rows: &[Row]) -> Vec<Plot> {
    show(view, rows).1
}

/// The tables and plots of a view.
fn show(view: &View, rows: &[Row]) -> (Vec<table::Table>, Vec<Plot>) {
    let plot = |file: String, about: &str, svg| Plot {
        file: file + ".svg",
        about: about.to_owned(),
        svg,
    };
    match view.shape {
        Shape::Map | Shape::Ratios => {
            let tables = table::by_size(view, rows);
            let plots = tables.iter().map(|table| {
                let scale = if view.shape == Shape::Map {
                    boxes::Scale::of(table)
                } else {
                    boxes::Scale::Ratios
                };
                let file = format!("{}-{}", view.name, table.size);
                plot(file, &table.title, boxes::map(table, scale))
            });
            let plots = plots.collect();
            (tables, plots)
        }
        Shape::Exponents => {
            let table = table::exponents(view, rows);
            let svg = boxes::map(&table, boxes::Scale::Exponents);
            let plot = plot(view.name.to_owned(), &table.title, svg);
            (vec![table], vec![plot])
        }
        Shape::Growth | Shape::Angles => {
            let svg = growth::draw(view, rows);
            let plot = plot(view.name.to_owned(), view.title, svg);
            (table::by_data(view, rows), vec![plot])
        }
        Shape::Phases => {
            let svg = boxes::phases(view, rows);
            let plot = plot(view.name.to_owned(), view.title, svg);
            (table::by_size(view, rows), vec![plot])
        }
    }
}
