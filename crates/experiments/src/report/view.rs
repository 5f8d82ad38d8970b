//! Views of the rows in a report: their plots, and numbers as text, with about three digits.

use crate::measure::Row;

/// A view of the rows: a number of each, as tables and plots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// The names of the view's files begin so.
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
    /// A map of ratios of times to the first variant, with intervals.
    Ratios,
    /// A map of the exponents of growth with the number of points.
    Exponents,
    /// Lines over the number of points, for each kind of data.
    Growth,
    /// Lines over the angle in the names of the variants, one for each kind of data.
    Angles,
    /// Bars of the three parts of the algorithm.
    Phases,
}

/// A drawing, and its file.
pub(crate) struct Plot {
    pub(crate) file: String,
    pub(super) about: String,
    pub(crate) svg: String,
}

/// The number with three digits, or all digits before the point.
pub(super) fn short(x: f64) -> String {
    match x.abs() {
        size if size >= 99_999.5 => format!("{x:.1e}"),
        size if size >= 99.95 => format!("{x:.0}"),
        size if size >= 9.995 => format!("{x:.1}"),
        // What rounds to nothing has no sign.
        size if size < 0.005 => "0.00".to_owned(),
        _ => format!("{x:.2}"),
    }
}

/// A size: 1000 as `1e3`, 23262 as it is.
pub(super) fn size(n: usize) -> String {
    let zeros = n
        .to_string()
        .bytes()
        .rev()
        .take_while(|&c| c == b'0')
        .count();
    let factor = 10_usize.pow(u32::try_from(zeros).unwrap_or(0));
    if zeros >= 3 && n != 0 {
        format!("{}e{zeros}", n / factor)
    } else {
        n.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::{short, size};

    #[test]
    fn about_three_digits() {
        let numbers = [
            0.0, -0.001, 0.01, 0.123, 1.5, 12.345, 99.96, 281.4, 5128.0, 1.25e5,
        ];
        let texts = [
            "0.00", "0.00", "0.01", "0.12", "1.50", "12.3", "100", "281", "5128", "1.2e5",
        ];
        assert_eq!(numbers.map(short), texts);
    }

    #[test]
    fn sizes_are_short_where_they_are_round() {
        assert_eq!(
            [1000, 64_000, 23_262, 0].map(size),
            ["1e3", "64e3", "23262", "0"]
        );
    }
}
