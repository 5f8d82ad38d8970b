//! The end of Triangle's `.poly`: points that stand for holes and regions.

use crate::formats::Coordinate;
use crate::formats::read::content::{Syntax, Vertices};
use crate::formats::read::records::Records;
use crate::formats::read::source::{ReadError, Source, quoted};
use crate::formats::read::token_lines::{Line, Lines};

/// Reads the holes, if the file goes on; they are numbered from 0 or 1, or, if there are none, from `first`.
pub(super) fn read_holes<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    mut first: usize,
) -> Result<Vertices<'a>, ReadError> {
    let records = Records {
        name: "hole",
        number: "a hole's number",
        count: count(lines, "a number of holes")?,
    };
    let coordinates = records.read(lines, &mut first, Line::coordinates)?;
    Ok(seeds(source, coordinates, first))
}

/// Reads the regions, likewise, and their attributes. The area that may follow is not read.
pub(super) fn read_regions<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    mut first: usize,
) -> Result<(Vertices<'a>, Vec<f64>), ReadError> {
    let records = Records {
        name: "region",
        number: "a region's number",
        count: count(lines, "a number of regions")?,
    };
    let regions = records.read(lines, &mut first, |line| {
        Ok((line.coordinates()?, attribute(line)?))
    })?;
    let (coordinates, attributes) = regions.into_iter().unzip();
    Ok((seeds(source, coordinates, first), attributes))
}

/// The number in the next line, or 0 if there is none.
fn count(lines: &mut Lines<'_>, what: &str) -> Result<usize, ReadError> {
    let line = lines.next_line();
    line.map_or(Ok(0), |mut line| line.index(what))
}

/// The attribute of a region, or 0 if the line ends.
fn attribute(line: &mut Line<'_>) -> Result<f64, ReadError> {
    let Some(token) = line.token() else {
        return Ok(0.0);
    };
    let value = f64::from_text(&String::from_utf8_lossy(token)).ok();
    let value = value.filter(|value| value.is_finite());
    value.ok_or_else(|| line.error(format!("{} is not an attribute, a number", quoted(token))))
}

fn seeds<'a>(source: &'a Source, coordinates: Vec<[&'a [u8]; 2]>, first: usize) -> Vertices<'a> {
    Vertices {
        source,
        syntax: Syntax::Plain,
        coordinates,
        first,
    }
}
