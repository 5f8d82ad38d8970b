//! What a report shows of the rows.

use crate::measure::Row;

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

/// A drawing, and its file.
pub(super) struct Plot {
    pub(super) file: String,
    pub(super) about: String,
    pub(super) svg: String,
}
