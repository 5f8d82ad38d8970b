//! The points and edges of a request.

use std::error::Error;

use sweep_cdt_formats::{Column, Format, GraphFile, Input, Source, read as read_file};
use sweep_cdt_generate::Kind;

use super::request::Given;

/// Reads files, one after the other in `files`, or generates data.
pub(crate) fn read(given: Given, mut files: Vec<u8>) -> Result<Input, Box<dyn Error>> {
    match given {
        Given::File {
            name,
            format,
            bytes,
            node,
        } => {
            let format = named(&format, Format::INPUTS)?;
            let rest = files.split_off(bytes.min(files.len()));
            let source = Source::new(name, files);
            let node =
                node.map(|(name, bytes)| Source::new(name, rest[..bytes.min(rest.len())].to_vec()));
            Ok(match read_file(format, &source, node.as_ref())? {
                Input::Doubles(file) => Input::Doubles(file.with_voids_said()),
                Input::Rationals(file) => Input::Rationals(file.with_voids_said()),
            })
        }
        Given::Generated { kind, points, seed } => {
            let kind = Kind::named(&kind).ok_or_else(|| format!("there is no kind `{kind}`"))?;
            let (graph, heights) = kind.graph_and_heights(points, seed);
            let columns = heights.into_iter().map(Column::heights).collect();
            let file = GraphFile {
                columns,
                ..graph.into()
            };
            Ok(Input::Doubles(file))
        }
    }
}

/// The format of this name, one of these.
pub(crate) fn named(name: &str, formats: &[Format]) -> Result<Format, String> {
    Format::named(name, formats).ok_or_else(|| format!("there is no format `{name}`"))
}
