//! Tables of names and numbers.

use std::io::{self, Write};

/// The width of the names.
pub(crate) const NAME: usize = 26;
/// The width of the numbers, which end in one column.
pub(crate) const NUMBER: usize = 12;

/// Writes names and numbers in columns.
pub(crate) fn rows(out: &mut impl Write, rows: &[(&str, u64)]) -> io::Result<()> {
    for (name, number) in rows {
        writeln!(out, "{name:NAME$}{:>NUMBER$}", grouped(*number))?;
    }
    Ok(())
}

/// A number with commas between its thousands.
fn grouped(number: u64) -> String {
    if number < 1000 {
        return number.to_string();
    }
    format!("{},{:03}", grouped(number / 1000), number % 1000)
}
