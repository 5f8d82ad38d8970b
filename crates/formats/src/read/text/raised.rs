//! Points as text with other heights: all else stays as it is, rows and names, comments, quotes and ends of lines.
//!
//! A height takes the place of the field in the column of heights. Where there is none, it follows the last column, and its
//! name `z` follows the last name. Rows that are short have the fields before it empty.

use std::collections::HashMap;

use serde_json::Value;
use serde_json::value::RawValue;

use super::rows::{Separator, text};
use super::{Begin, Names, is_double, is_missing};
use crate::Coordinate;
use crate::properties::Properties;
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

/// The fields of each row but x, y and the height, as the properties of a feature: numbers as they stand, all else in quotes,
/// and `null` for what is missing.
pub(in crate::read) fn properties(source: &Source) -> Result<Properties, ReadError> {
    let Begin {
        mut rows,
        mut fields,
        header,
        names,
        z,
        ..
    } = Begin::of(source)?;
    let others = header.names.iter().enumerate();
    let others = others.filter(|&(at, _)| ![Some(header.x), Some(header.y), z].contains(&Some(at)));
    let mut seen: HashMap<&str, usize> = HashMap::new();
    let others = others.map(|(at, name)| {
        let count = seen.entry(name).or_default();
        *count += 1;
        let name = match (&name[..], *count) {
            ("", _) => format!("column{}", at + 1),
            (_, 1) => name.clone(),
            (_, count) => format!("{name}_{count}"),
        };
        (at, name)
    });
    let others: Vec<(usize, String)> = others.collect();
    let mut properties = Properties::default();
    let mut feature = 0;
    let mut row = |fields: &[&[u8]]| {
        feature += 1;
        let values = others.iter().map(|(at, name)| {
            let field = fields.get(*at).copied().unwrap_or_default();
            (name.clone(), as_json(field))
        });
        let values: Vec<(String, Box<RawValue>)> = values.collect();
        let members = values.iter().map(|(name, value)| (name.clone(), &**value));
        properties.set(feature, &members.collect::<Vec<_>>(), |_| true);
    };
    if names != Names::FirstRow {
        row(&fields);
    }
    while rows.next_row(&mut fields)?.is_some() {
        row(&fields);
    }
    Ok(properties)
}

/// A field as a value of JSON.
fn as_json(field: &[u8]) -> Box<RawValue> {
    let word = text(field);
    let is_json = || serde_json::from_str::<&RawValue>(&word).is_ok();
    let json = match field {
        _ if is_missing(field) => "null".to_owned(),
        _ if is_double(field) && is_json() => word,
        _ => Value::from(word).to_string(),
    };
    RawValue::from_string(json).expect("a value of JSON")
}
