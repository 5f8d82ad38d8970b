//! A JSON file piece by piece. Each piece is a part of the file's text, and so has a line and a column.

use std::fmt;

use serde::Deserialize;
use serde::de::{self, Error, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use crate::read::source::{ReadError, Source, quoted};

/// A JSON file, member by member.
pub(crate) struct File<'a> {
    source: &'a Source,
    pub(crate) whole: &'a RawValue,
    /// In their order, and with those that are there twice.
    pub(crate) members: Vec<(String, &'a RawValue)>,
}

impl<'a> File<'a> {
    pub(crate) fn new(source: &'a Source) -> Result<File<'a>, ReadError> {
        let text = source.text()?;
        let whole: Result<&RawValue, _> = serde_json::from_slice(text);
        let whole = whole.map_err(|error| no_json(source, text, &error))?;
        let mut file = File {
            source,
            whole,
            members: Vec::new(),
        };
        match serde_json::from_slice::<Members<'_>>(text) {
            Ok(Members(members)) => file.members = members,
            Err(error) if error.is_data() => {
                let object = "an object such as {\"points\": [[x, y], ...]} should stand here";
                return Err(file.fault(whole, object));
            }
            Err(error) => return Err(no_json(source, text, &error)),
        }
        Ok(file)
    }

    /// A fault of a piece of the file.
    pub(crate) fn fault(&self, piece: &RawValue, message: impl Into<String>) -> ReadError {
        fault(self.source, piece, message)
    }
}

/// A fault of a piece of a file.
pub(crate) fn fault(source: &Source, piece: &RawValue, message: impl Into<String>) -> ReadError {
    let (line, column) = source.position(piece.get().as_bytes());
    ReadError {
        column: Some(column),
        ..source.error_in_line(line, message)
    }
}

/// The JSON texts of a file: one, or several one after the other, each of them after a record separator (RFC 8142) or on
/// lines of its own.
pub(crate) fn texts(source: &Source) -> Result<Vec<&RawValue>, ReadError> {
    const SEPARATOR: u8 = 0x1e;
    let mut texts = Vec::new();
    let mut rest = source.text()?;
    loop {
        let is_between = |byte: &u8| byte.is_ascii_whitespace() || *byte == SEPARATOR;
        let begin = rest.iter().position(|byte| !is_between(byte));
        rest = &rest[begin.unwrap_or(rest.len())..];
        if rest.is_empty() && !texts.is_empty() {
            return Ok(texts);
        }
        let mut stream = serde_json::Deserializer::from_slice(rest).into_iter::<&RawValue>();
        match stream.next() {
            Some(Ok(text)) => texts.push(text),
            Some(Err(error)) => return Err(no_json(source, rest, &error)),
            None => return Err(source.error_in_line(1, EMPTY)),
        }
        rest = &rest[stream.byte_offset()..];
    }
}

const EMPTY: &str = "the file is empty";

/// The error that `text`, the file or the rest of it, is no JSON, or not all of it. Serde counts lines by line feeds alone.
pub(crate) fn no_json(source: &Source, text: &[u8], error: &serde_json::Error) -> ReadError {
    if text.trim_ascii().is_empty() {
        return source.error_in_line(1, EMPTY);
    }
    let (_, last) = text.split_at(text.trim_ascii_end().len());
    if error.is_eof() {
        let (line, _) = source.position(last);
        return source.error_in_line(line, "the file ends where the JSON should go on");
    }
    let before = text.split_inclusive(|&byte| byte == b'\n');
    let before = before.take(error.line().saturating_sub(1));
    let line_start: usize = before.map(<[u8]>::len).sum();
    let word = word_at(text, line_start + error.column().saturating_sub(1));
    let message = error.to_string();
    let message = message.split(" at line ").next().unwrap_or_default();
    let (line, column) = source.position(word);
    ReadError {
        column: Some(column),
        ..source.error_in_line(line, format!("{} is no JSON here: {message}", quoted(word)))
    }
}

/// The word or number around a place in the text, or the byte there.
fn word_at(text: &[u8], at: usize) -> &[u8] {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
    let (before, after) = text.split_at(at.min(text.len()));
    let length = after.iter().take_while(|byte| is_part(byte)).count();
    if length == 0 {
        return &after[..after.len().min(1)];
    }
    let begun = before.iter().rev().take_while(|byte| is_part(byte)).count();
    &text[before.len() - begun..before.len() + length]
}

/// The members of the object that a text is, if it is one.
pub(crate) fn members(text: &[u8]) -> Option<Vec<(String, &RawValue)>> {
    // Serde would take a list for an object without names.
    let text = Some(text.trim_ascii_start()).filter(|text| text.starts_with(b"{"));
    let Members(members) = serde_json::from_slice(text?).ok()?;
    Some(members)
}

/// The members of an object, in their order and with those that are there twice.
struct Members<'a>(Vec<(String, &'a RawValue)>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(MembersVisitor)
    }
}

struct MembersVisitor;

impl<'de> Visitor<'de> for MembersVisitor {
    type Value = Members<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members<'de>, A::Error> {
        let mut members = Vec::new();
        while let Some(member) = map.next_entry()? {
            members.push(member);
        }
        Ok(Members(members))
    }
}

/// Coordinates, and a height if there is one.
pub(crate) struct Position<'a>(
    pub(crate) [&'a RawValue; 2],
    pub(crate) Option<&'a RawValue>,
);

impl<'de: 'a, 'a> Deserialize<'de> for Position<'a> {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PositionVisitor)
    }
}

struct PositionVisitor;

impl<'de> Visitor<'de> for PositionVisitor {
    type Value = Position<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two or three coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Position<'de>, A::Error> {
        let point: [Option<&'de RawValue>; 2] = [seq.next_element()?, seq.next_element()?];
        let [Some(x), Some(y)] = point else {
            return Err(A::Error::custom("coordinates are missing"));
        };
        // What follows a height is an error of the one who reads the list.
        Ok(Position([x, y], seq.next_element()?))
    }
}

/// A position, and how many numbers follow its height.
pub(crate) struct Measured<'a>(pub(crate) Position<'a>, pub(crate) usize);

impl<'de: 'a, 'a> Deserialize<'de> for Measured<'a> {
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(MeasuredVisitor)
    }
}

struct MeasuredVisitor;

impl<'de> Visitor<'de> for MeasuredVisitor {
    type Value = Measured<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two coordinates or more")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Measured<'de>, A::Error> {
        let position = PositionVisitor.visit_seq(&mut seq)?;
        let mut measures = 0;
        while seq.next_element::<f64>()?.is_some() {
            measures += 1;
        }
        Ok(Measured(position, measures))
    }
}
