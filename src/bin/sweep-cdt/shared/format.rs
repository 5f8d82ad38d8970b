//! Formats by name.

use clap::builder::{PossibleValuesParser, TypedValueParser};

/// Reads one of a few values by name.
pub(crate) fn names<T: Copy + Send + Sync + 'static, const N: usize>(
    values: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(values.map(name)).map(move |given| {
        let found = values.into_iter().find(|&value| name(value) == given);
        found.expect("only names of values are let through")
    })
}
