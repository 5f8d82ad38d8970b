//! How the coordinates of a result are written. The text tells how they may be rounded, and messages name its line.

use std::borrow::Cow;

use crate::read::content::Vertices;

/// How precise the coordinates of a result are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Precision {
    /// Each may be rounded to the digits that it has.
    Digits,
    /// The numbers have single precision.
    Singles,
    /// Nobody has rounded them.
    Exact,
}

/// Coordinates as they are written.
pub(crate) trait Written {
    /// The text of a coordinate.
    fn text(&self, vertex: usize, axis: usize) -> Cow<'_, str>;

    /// How many decimals it has; `None`, if it has an exponent, or is a fraction.
    fn decimals(&self, vertex: usize, axis: usize) -> Option<usize> {
        let text = self.text(vertex, axis);
        let decimals = text.split_once('.').map_or("", |(_, decimals)| decimals);
        (!text.contains(['e', 'E', '/'])).then_some(decimals.len())
    }

    /// How precise they are.
    fn precision(&self) -> Precision;

    /// The name of the file.
    fn file(&self) -> String {
        String::new()
    }

    /// The name of a vertex in messages: the file, the line, and its number there.
    fn name(&self, vertex: usize) -> (String, Option<usize>, usize) {
        (String::new(), None, vertex)
    }
}

impl Written for Vertices<'_> {
    fn text(&self, vertex: usize, axis: usize) -> Cow<'_, str> {
        Vertices::text(self, vertex, axis)
    }

    fn precision(&self) -> Precision {
        match self.is_single() {
            true => Precision::Singles,
            false => Precision::Digits,
        }
    }

    fn file(&self) -> String {
        self.source.name.clone()
    }

    fn name(&self, vertex: usize) -> (String, Option<usize>, usize) {
        Vertices::name(self, vertex)
    }
}
