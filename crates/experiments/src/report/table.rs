//! Tables: a number for each variant and kind of data, or variant and size.

use super::view::{View, size as short_size};
use crate::measure::Row;

#[derive(Clone, Debug)]
pub(super) struct Table {
    pub(super) title: String,
    /// The size of its rows, if it is one.
    pub(super) size: usize,
    pub(super) columns: Vec<String>,
    pub(super) lines: Vec<Line>,
}

#[derive(Clone, Debug)]
pub(super) struct Line {
    pub(super) variant: String,
    pub(super) cells: Vec<Entry>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Entry {
    Number(f64),
    /// The variant was left out, as it would have taken too long.
    LeftOut,
    /// Not counted, or not measured.
    Unknown,
}

impl Table {
    /// Each number divided by that of the first line in its column.
    pub(super) fn ratios(&self) -> Table {
        let first = self.lines.first().map(|line| line.cells.clone());
        let mut table = self.clone();
        table.title += ", as ratios to the first row";
        for line in &mut table.lines {
            for (entry, first) in line.cells.iter_mut().zip(first.iter().flatten()) {
                *entry = match (*entry, *first) {
                    (Entry::Number(x), Entry::Number(one)) => Entry::Number(x / one),
                    (other, _) => other,
                };
            }
        }
        table
    }
}

/// A table of variants and data for each size.
pub(super) fn by_size(view: &View, rows: &[Row]) -> Vec<Table> {
    // Files have no size: they are all in one table.
    let sizes = distinct(rows.iter().map(|row| row.size));
    let table = |size: usize| {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.size == size).collect();
        let points = if size == 0 {
            "files".to_owned()
        } else {
            format!("{} points", short_size(size))
        };
        let columns = distinct(rows.iter().map(|row| row.data.clone()));
        Table {
            title: format!("{} ({points})", view.title),
            size,
            lines: lines(&rows, &columns, |row, column| {
                (row.data == *column).then(|| entry(view, row))
            }),
            columns,
        }
    };
    sizes.into_iter().map(table).collect()
}

/// A table of variants and sizes for each kind of data.
pub(super) fn by_data(view: &View, rows: &[Row]) -> Vec<Table> {
    let table = |data: String| {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.data == data).collect();
        let sizes = distinct(rows.iter().map(|row| row.points));
        let lines = lines(&rows, &sizes, |row, size| {
            (row.points == *size).then(|| entry(view, row))
        });
        Table {
            title: format!("{} ({data})", view.title),
            size: 0,
            columns: sizes.into_iter().map(short_size).collect(),
            lines,
        }
    };
    let kinds = distinct(rows.iter().map(|row| row.data.clone()));
    kinds.into_iter().map(table).collect()
}

/// A table of variants and data with the exponents of growth over all sizes.
pub(super) fn exponents(view: &View, rows: &[Row]) -> Table {
    let rows: Vec<&Row> = rows.iter().collect();
    let columns = distinct(rows.iter().map(|row| row.data.clone()));
    let lines = lines(&rows, &columns, |row, column| {
        if row.data != *column {
            return None;
        }
        let same = rows
            .iter()
            .filter(|other| (&other.data, &other.variant) == (&row.data, &row.variant));
        let entries = same.map(|row| (row.points as f64, entry(view, row)));
        Some(exponent(entries))
    });
    Table {
        title: view.title.to_owned(),
        size: 0,
        columns,
        lines,
    }
}

/// The slope of the line through the logarithms of positive numbers over those of points, by least squares.
/// What never rises above one is constant.
fn exponent(entries: impl Iterator<Item = (f64, Entry)>) -> Entry {
    let mut at = Vec::new();
    for (points, entry) in entries {
        match entry {
            // A hundredth of a step more or less is no growth.
            Entry::Number(x) => at.push([points.ln(), x.max(1.0).ln()]),
            Entry::Unknown => return Entry::Unknown,
            Entry::LeftOut => {}
        }
    }
    let count = at.len() as f64;
    let mean = [0, 1].map(|i| at.iter().map(|p| p[i]).sum::<f64>() / count);
    let sum = |i: usize, j: usize| -> f64 {
        at.iter().map(|p| (p[i] - mean[i]) * (p[j] - mean[j])).sum()
    };
    if at.len() < 2 || sum(0, 0) == 0.0 {
        return Entry::Unknown;
    }
    Entry::Number(sum(0, 1) / sum(0, 0))
}

/// The number of a row.
pub(super) fn entry(view: &View, row: &Row) -> Entry {
    if row.is_left_out {
        return Entry::LeftOut;
    }
    (view.measure)(row).map_or(Entry::Unknown, Entry::Number)
}

/// A line for each variant, with what `find` makes of the first row that fits each column.
fn lines<C>(rows: &[&Row], columns: &[C], find: impl Fn(&Row, &C) -> Option<Entry>) -> Vec<Line> {
    let cells = |variant: &String| {
        let cell = |column| {
            let mut own = rows.iter().filter(|row| row.variant == *variant);
            own.find_map(|row| find(row, column))
                .unwrap_or(Entry::Unknown)
        };
        columns.iter().map(cell).collect()
    };
    let variants = distinct(rows.iter().map(|row| row.variant.clone()));
    let line = |variant: String| Line {
        cells: cells(&variant),
        variant,
    };
    variants.into_iter().map(line).collect()
}

/// Each once, in the order of their first appearance.
pub(super) fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut kept = Vec::new();
    for one in all {
        if !kept.contains(&one) {
            kept.push(one);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::{Entry, exponent};

    #[test]
    fn exponents_of_powers() {
        let grown = |power: i32| {
            let sizes = [10.0_f64, 100.0, 1000.0];
            exponent(
                sizes
                    .map(|n| (n, Entry::Number(3.0 * n.powi(power))))
                    .into_iter(),
            )
        };
        for power in [0, 1, 2] {
            let Entry::Number(found) = grown(power) else {
                panic!("three sizes are enough");
            };
            assert!((found - f64::from(power)).abs() < 1e-9);
        }
        let one = exponent([(10.0, Entry::Number(1.0))].into_iter());
        assert_eq!(one, Entry::Unknown);
    }
}
