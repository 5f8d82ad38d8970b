//! Points as text with other heights: all else stays as it is, rows and names, comments, quotes and ends of lines.
//!
//! A height takes the place of the field in the column of heights. Where there is none, it follows the last column, and its
//! name `z` follows the last name. Rows that are short have the fields before it empty.

use super::rows::Separator;
use super::{Begin, Names};
use crate::Coordinate;
use crate::read::edited::Edited;
use crate::read::source::{ReadError, Source};

/// The text of a file with these heights, one for each row, NaN where there is none.
pub(in crate::read) fn raised(source: &Source, heights: &[f64]) -> Result<Vec<u8>, ReadError> {
    let Begin {
        mut rows,
        mut fields,
        header,
        names,
        z,
        ..
    } = Begin::of(source)?;
    let (separator, none) = match rows.separator() {
        Separator::Semicolon => (b';', &b""[..]),
        Separator::Tab => (b'\t', &b""[..]),
        Separator::Comma => (b',', &b""[..]),
        // Nothing is no field there.
        Separator::Blanks => (b' ', &b"nan"[..]),
    };
    let width = header.names.len();
    let mut edited = Edited::new(source);
    let mut put = |fields: &[&[u8]], z: Option<usize>, text: &[u8]| {
        let at = z.unwrap_or(width);
        if z.is_some()
            && let Some(field) = fields.get(at)
        {
            return edited.replace(field, text);
        }
        // Behind the last field before it, or behind empty ones that are missing.
        let last = fields.len().min(at);
        let mut behind = Vec::new();
        for _ in last..at {
            behind.push(separator);
            behind.extend_from_slice(none);
        }
        behind.push(separator);
        behind.extend_from_slice(text);
        if let Some(field) = fields[..last].last() {
            edited.insert_behind(field, &behind);
        }
    };
    let is_named = header.names.iter().any(|name| name == "z");
    let name = if is_named { &b"height"[..] } else { &b"z"[..] };
    match (names, z) {
        (Names::FirstRow, None) => put(&fields, None, name),
        (Names::Comment, None) => put(&rows.comment(), None, name),
        _ => {}
    }
    let mut heights = heights.iter();
    let mut row = |fields: &[&[u8]]| {
        let mut text = Vec::new();
        match heights.next() {
            Some(height) if !height.is_nan() => height.write_text(&mut text),
            _ => text.extend_from_slice(none),
        }
        put(fields, z, &text);
    };
    if names != Names::FirstRow {
        row(&fields);
    }
    while rows.next_row(&mut fields)?.is_some() {
        row(&fields);
    }
    Ok(edited.into_text())
}
