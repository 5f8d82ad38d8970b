//! Tables: a number for each variant and kind of data, or variant and size.

use super::fit::Fit;
use super::ratio::Ratio;
use super::view::{Shape, View, size as short_size};
use crate::measure::{Row, median};

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
    /// The time over that of the first variant.
    Ratio(Ratio),
    /// The variant was left out, as it would have taken too long.
    LeftOut,
    /// Not counted, or not measured.
    Unknown,
}

/// A table of variants and data for each size: medians over the seeds, or ratios to the first variant.
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
            lines: lines(&rows, &columns, |own, column| {
                let own = of_data(own, column);
                if view.shape != Shape::Ratios || own.iter().any(|row| row.is_left_out) {
                    return entry(view, &own);
                }
                let first: Vec<&Row> = rows
                    .iter()
                    .copied()
                    .filter(|row| row.variant == rows[0].variant)
                    .collect();
                let ratio = Ratio::of(&own, &of_data(&first, column));
                ratio.map_or(Entry::Unknown, Entry::Ratio)
            }),
            columns,
        }
    };
    sizes.into_iter().map(table).collect()
}

fn of_data<'a>(rows: &[&'a Row], data: &str) -> Vec<&'a Row> {
    rows.iter()
        .copied()
        .filter(|row| row.data == data)
        .collect()
}

/// A table of variants and sizes for each kind of data.
pub(super) fn by_data(view: &View, rows: &[Row]) -> Vec<Table> {
    let table = |data: String| {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.data == data).collect();
        let sizes = distinct(rows.iter().map(|row| row.points));
        let lines = lines(&rows, &sizes, |own, size| {
            let own: Vec<&Row> = own
                .iter()
                .copied()
                .filter(|row| row.points == *size)
                .collect();
            entry(view, &own)
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
    let lines = lines(&rows, &columns, |own, column| {
        let own = own.iter().filter(|row| row.data == *column);
        exponent(own.map(|row| (row.points as f64, entry(view, &[row]))))
    });
    Table {
        title: view.title.to_owned(),
        size: 0,
        columns,
        lines,
    }
}

/// The number of rows that differ in the seed alone: the median.
pub(super) fn entry(view: &View, rows: &[&Row]) -> Entry {
    if rows.iter().any(|row| row.is_left_out) {
        return Entry::LeftOut;
    }
    let numbers = rows.iter().filter_map(|row| (view.measure)(row));
    median(numbers).map_or(Entry::Unknown, Entry::Number)
}

/// A line for each variant, with what `find` makes of its rows for each column.
fn lines<C>(rows: &[&Row], columns: &[C], find: impl Fn(&[&Row], &C) -> Entry) -> Vec<Line> {
    let line = |variant: String| {
        let own: Vec<&Row> = rows
            .iter()
            .copied()
            .filter(|row| row.variant == variant)
            .collect();
        Line {
            cells: columns.iter().map(|column| find(&own, column)).collect(),
            variant,
        }
    };
    let variants = distinct(rows.iter().map(|row| row.variant.clone()));
    variants.into_iter().map(line).collect()
}

/// Each once, in the order of their first appearance.
pub(crate) fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut kept = Vec::new();
    for one in all {
        if !kept.contains(&one) {
            kept.push(one);
        }
    }
    kept
}

/// The exponent of numbers over points. What never rises above one is constant: a hundredth of a step more or less is no
/// growth.
fn exponent(entries: impl Iterator<Item = (f64, Entry)>) -> Entry {
    let mut at = Vec::new();
    for (points, entry) in entries {
        match entry {
            Entry::Number(x) => at.push([points, x.max(1.0)]),
            Entry::Unknown | Entry::Ratio(_) => return Entry::Unknown,
            Entry::LeftOut => {}
        }
    }
    Fit::of(&at).map_or(Entry::Unknown, |fit| Entry::Number(fit.exponent))
}

#[cfg(test)]
mod tests {
    use super::{Entry, exponent};

    #[test]
    fn exponents_of_what_is_counted() {
        let grown = |power: i32| {
            let sizes = [10.0_f64, 100.0, 1000.0].map(|n| (n, Entry::Number(3.0 * n.powi(power))));
            match exponent(sizes.into_iter().chain([(1e4, Entry::LeftOut)])) {
                Entry::Number(found) => found,
                other => panic!("{other:?}"),
            }
        };
        for power in [0, 1, 2] {
            assert!((grown(power) - f64::from(power)).abs() < 1e-9);
        }
        let one = exponent([(10.0, Entry::Number(1.0))].into_iter());
        assert_eq!(one, Entry::Unknown);
    }
}
