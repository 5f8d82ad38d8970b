//! The report: tables in Markdown and plots in SVG, of all rows of an experiment.

mod canvas;
mod growth;
mod machine;
mod map;
mod markdown;
mod number;
mod palette;
mod phases;
mod table;

use std::fs;
use std::io;
use std::path::Path;

use crate::measure::Row;
pub(crate) use machine::commit;
pub(crate) use markdown::Method;

/// What is shown of the rows: a number of each, as tables and plots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Its files begin so.
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) about: &'static str,
    pub(crate) measure: fn(&Row) -> Option<f64>,
    pub(crate) shape: Shape,
}

/// How the numbers are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A map of variants and data for each size, dark where the number is large.
    Map,
    /// The same of ratios to the first variant: blue where it is slower, orange where it is faster.
    Ratios,
    /// A map of the exponents of growth with the number of points.
    Exponents,
    /// Lines over the number of points, for each kind of data.
    Growth,
    /// Bars of the three parts of the algorithm.
    Phases,
}

/// Writes the report and its plots into a folder.
///
/// # Errors
/// Those of the files.
pub(crate) fn write(
    folder: &Path,
    method: &Method<'_>,
    views: &[View],
    remarks: &str,
    rows: &[Row],
) -> io::Result<()> {
    let mut text = markdown::head(method, rows);
    for view in views {
        let (tables, plots) = show(view, rows);
        text.push_str(&markdown::section(view, &tables, &plots));
        for plot in plots {
            fs::write(folder.join(plot.file), plot.svg)?;
        }
    }
    text.push_str(remarks);
    fs::write(folder.join("report.md"), text)
}

/// A drawing, and its file.
struct Plot {
    file: String,
    about: String,
    svg: String,
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
                let (shown, scale) = if view.shape == Shape::Map {
                    (table.clone(), map::Scale::of(table))
                } else {
                    (table.ratios(), map::Scale::Ratios)
                };
                let file = format!("{}-{}", view.name, table.size);
                plot(file, &table.title, map::draw(&shown, scale))
            });
            let plots = plots.collect();
            (tables, plots)
        }
        Shape::Exponents => {
            let table = table::exponents(view, rows);
            let svg = map::draw(&table, map::Scale::Exponents);
            let plot = plot(view.name.to_owned(), &table.title, svg);
            (vec![table], vec![plot])
        }
        Shape::Growth => {
            let svg = growth::draw(view, rows);
            let plot = plot(view.name.to_owned(), view.title, svg);
            (table::by_data(view, rows), vec![plot])
        }
        Shape::Phases => {
            let svg = phases::draw(view, rows);
            let plot = plot(view.name.to_owned(), view.title, svg);
            (table::by_size(view, rows), vec![plot])
        }
    }
}
