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
        let name = file.input_name();
        Failure::Usage(format!("the format of {name} is unknown: add {option}"))
    })
}

/// The format of an output; `given` is that of standard output.
pub(crate) fn of_output<F: Format>(file: &FileArgument, given: Option<F>) -> Result<F, Failure> {
    let format = match file {
        FileArgument::Standard => given
            .ok_or_else(|| "the format of standard output is unknown: add --output-format".into()),
        FileArgument::File(path) => by_extension(file)
            .ok_or_else(|| format!("{}: only {} can be written", path.display(), list::<F>())),
    };
    format.map_err(Failure::Usage)
}

fn by_extension<F: Format>(file: &FileArgument) -> Option<F> {
    file.path()?.extension()?.to_str()?.parse().ok()
}

fn names<F: Format>() -> Vec<&'static str> {
    F::VARIANTS.iter().map(|&format| format.into()).collect()
}

/// The extensions, as a list in a sentence.
fn list<F: Format>() -> String {
    let names = names::<F>().join(", .");
    let (first, last) = names.rsplit_once(", ").expect("two formats or more");
    format!(".{first} and {last}")
}
