//! Points as text, a row for each: the names of the columns, and then the numbers.

use std::io::{self, Write};

use super::rows::write_rows;
use crate::{Column, Coordinate, GraphFile};

/// Writes the vertices with all columns, and this sign between two numbers. Coordinates are exact.
pub(super) fn write<S: Coordinate>(
    file: &GraphFile<S>,
    separator: u8,
    out: &mut impl Write,
) -> io::Result<()> {
    let is_height = |column: &&Column| column.name == Column::HEIGHT;
    let heights = file.columns.iter().filter(is_height);
    let others = file.columns.iter().filter(|column| !is_height(column));
    let columns: Vec<&Column> = heights.chain(others).collect();
    out.write_all(&[b'x', separator, b'y'])?;
    for column in &columns {
        out.write_all(&[separator])?;
        out.write_all(name(&column.name, separator).as_bytes())?;
    }
    out.write_all(b"\n")?;
    write_rows(out, file.graph.points.len(), |vertex, text| {
        let [x, y] = &file.graph.points[vertex];
        x.write_text(text);
        text.push(separator);
        y.write_text(text);
        for column in &columns {
            text.push(separator);
            column.of(vertex).write_text(text);
        }
        text.push(b'\n');
    })
}

/// A name, in quotes where it would not be read as one field, and another one where it would be that of a coordinate.
fn name(name: &str, separator: u8) -> String {
    if ["x", "y"].contains(&name.to_lowercase().as_str()) {
        return format!("{name}_2");
    }
    let is_odd = |sign: char| {
        sign.is_ascii_control() || " \"#".contains(sign) || sign == char::from(separator)
    };
    if name.is_empty() || name.contains(is_odd) {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name.to_owned()
    }
}
