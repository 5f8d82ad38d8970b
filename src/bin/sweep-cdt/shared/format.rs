//! Picking a format: by an option, or else by the extension of the file.

use std::str::FromStr;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use strum::VariantArray;

use super::failure::Failure;
use super::file_argument::FileArgument;

/// Formats of a kind, each named by the extension of its files.
pub(crate) trait Format:
    FromStr<Err = strum::ParseError> + VariantArray + Into<&'static str> + Copy + Send + Sync + 'static
{
}

impl<F> Format for F where
    F: FromStr<Err = strum::ParseError>
        + VariantArray
        + Into<&'static str>
        + Copy
        + Send
        + Sync
        + 'static
{
}

/// Reads the name of a format that is given by an option.
pub(crate) fn parser<F: Format>() -> impl TypedValueParser<Value = F> {
    PossibleValuesParser::new(names::<F>()).try_map(|name| name.parse())
}

/// The format of an input, which `option` may give.
pub(crate) fn of_input<F: Format>(
    file: &FileArgument,
    option: &str,
    given: Option<F>,
) -> Result<F, Failure> {
    given.or_else(|| by_extension(file)).ok_or_else(|| {
        let (name, known) = (file.input_name(), names::<F>().join(", "));
        Failure::Usage(format!(
            "the format of {name} is not known: add {option} with one of {known}"
        ))
    })
}

/// The format of an output; `given` is that of outputs whose extension tells none.
pub(crate) fn of_output<F: Format>(file: &FileArgument, given: Option<F>) -> Result<F, Failure> {
    by_extension(file).or(given).ok_or_else(|| {
        let known = names::<F>().join(", ");
        let name = match file {
            FileArgument::Standard => "standard output".to_owned(),
            FileArgument::File(path) => path.display().to_string(),
        };
        Failure::Usage(format!(
            "the format of {name} is not known: add --output-format with one of {known}"
        ))
    })
}

fn by_extension<F: Format>(file: &FileArgument) -> Option<F> {
    file.path()?.extension()?.to_str()?.parse().ok()
}

fn names<F: Format>() -> Vec<&'static str> {
    F::VARIANTS.iter().map(|&format| format.into()).collect()
}
