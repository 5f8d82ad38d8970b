//! The tables as plain text, row by row.

use super::{COLUMNS, columns, entry};
use crate::measure::Row;

const WIDTHS: [usize; COLUMNS.len()] = [26, 12, 8, 18, 12, 12, 8, 9, 7, 6];

/// A row, below the names of the columns if it is the first, and above each program's time.
pub(crate) fn text(row: &Row, is_first: bool) -> String {
    let mut text = String::new();
    if is_first {
        text.push_str(&line(&COLUMNS.map(str::to_owned)));
    }
    text.push_str(&line(&columns(row)));
    for cell in &row.cells {
        text.push_str(&format!("    {:16} {}\n", cell.program, entry(cell)));
    }
    text
}

fn line(columns: &[String]) -> String {
    let columns = columns.iter().zip(WIDTHS).enumerate();
    let columns = columns.map(|(i, (text, width))| match i {
        0 => format!("{text:width$}"),
        _ => format!(" {text:>width$}"),
    });
    columns.chain(["\n".to_owned()]).collect()
}
