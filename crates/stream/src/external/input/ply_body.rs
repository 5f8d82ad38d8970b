//! The records of a `.ply`, in lines of text or as the bytes of numbers: of each a row of the numbers that are wanted.

use std::ops::Range;

use sweep_cdt_formats::ply::{Encoding, Kind, Number};
use sweep_cdt_formats::{Coordinate, ReadError, quoted};

use crate::external::input::file::{InputFile, PIECE};
use crate::external::input::lines::{Lines, coordinate};

/// As many records, each with these properties.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    /// The places of the two properties that are read in any case.
    pub(super) pair: Option<[usize; 2]>,
}

/// The type of a value or of the members of a list, and that of the length of the list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Property {
    pub(super) kind: Kind,
    pub(super) length: Option<Kind>,
}

/// A number in a record.
pub(super) struct Piece<'a> {
    bytes: &'a [u8],
    /// How it stands there, if it is no text.
    number: Option<Number>,
    error: &'a dyn Fn(String) -> ReadError,
}

impl Piece<'_> {
    pub(super) fn coordinate(&self) -> Result<f64, ReadError> {
        match self.number {
            Some(number) => Ok(number.value(self.bytes)),
            None => coordinate(self.bytes, self.error),
        }
    }

    /// The number of a vertex, or how long a list is.
    pub(super) fn index(&self, what: &str) -> Result<u64, ReadError> {
        let (index, text) = match self.number {
            Some(number) => (
                number.index(self.bytes).map(|index| index as u64),
                number.value(self.bytes).text(),
            ),
            None => {
                let text = String::from_utf8_lossy(self.bytes).into_owned();
                (text.parse().ok(), text)
            }
        };
        index.ok_or_else(|| {
            let shown = quoted(text.as_bytes());
            (self.error)(format!("{shown} is not {what}"))
        })
    }
}

impl Element {
    /// How many bytes a record takes, if all take as many.
    fn stride(&self) -> Option<usize> {
        let sizes = self
            .properties
            .iter()
            .map(|property| match property.length {
                None => Some(property.kind.size()),
                Some(_) => None,
            });
        sizes.sum()
    }

    /// The error of a record.
    fn error(&self, file: &InputFile, record: u64, what: &str) -> ReadError {
        file.error(format!("{} {record}: {what}", self.name))
    }
}

/// What follows the header.
#[derive(Debug)]
pub(super) enum Body {
    /// A line for each record.
    Text(Lines),
    Binary(Binary),
}

impl Body {
    pub(super) fn new(file: InputFile, encoding: Encoding) -> Body {
        match encoding {
            Encoding::Text => Body::Text(Lines::new(file, 0)),
            Encoding::Binary { big_endian } => Body::Binary(Binary {
                file,
                bytes: Vec::new(),
                at: 0,
                big_endian,
            }),
        }
    }

    /// Reads so many records of an element, from this one on: of each the properties at these places.
    pub(super) fn read<T: Copy + Default>(
        &mut self,
        (element, places): (&Element, &[usize]),
        first: u64,
        count: u64,
        rows: &mut Vec<T>,
        value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        match self {
            Body::Text(lines) => (first..first + count)
                .try_for_each(|at| read_line(lines, (element, places), at, rows, &value)),
            Body::Binary(binary) => binary.read((element, places), first, count, rows, &value),
        }
    }

    /// Reads over what is left of an element, from this record on.
    pub(super) fn skip(&mut self, element: &Element, first: u64) -> Result<(), ReadError> {
        match self {
            Body::Text(lines) => (first..element.count).try_for_each(|at| {
                read_line::<u64>(lines, (element, &[]), at, &mut Vec::new(), |_| Ok(0))
            }),
            Body::Binary(binary) => binary.skip(element, first),
        }
    }

    pub(super) fn file(&self) -> &InputFile {
        match self {
            Body::Text(lines) => &lines.file,
            Body::Binary(binary) => &binary.file,
        }
    }

    /// Goes on at this byte, before which there are so many lines.
    pub(super) fn go_to(&mut self, (byte, lines): (u64, usize)) -> Result<(), ReadError> {
        match self {
            Body::Text(text) => text.go_to(byte, lines),
            Body::Binary(binary) => {
                binary.bytes.clear();
                binary.at = 0;
                binary.file.go_to(byte)
            }
        }
    }
}

/// Reads a record of a text.
fn read_line<T: Copy + Default>(
    lines: &mut Lines,
    (element, places): (&Element, &[usize]),
    record: u64,
    rows: &mut Vec<T>,
    value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
) -> Result<(), ReadError> {
    let mut line = lines.expect(|| {
        let Element { name, count, .. } = element;
        format!("{name} {} of {count}", record + 1)
    })?;
    let found = rows.len();
    rows.resize(found + places.len(), T::default());
    for (at, property) in element.properties.iter().enumerate() {
        let count = match property.length {
            None => 1,
            Some(_) => {
                let bytes = line.expect("a number")?;
                let error = |what| line.error(what);
                let piece = Piece {
                    bytes,
                    number: None,
                    error: &error,
                };
                piece.index("the length of a list")?
            }
        };
        for _ in 0..count {
            let bytes = line.expect("a number")?;
            if let Some(place) = places.iter().position(|&place| place == at) {
                let error = |what| line.error(what);
                let piece = Piece {
                    bytes,
                    number: None,
                    error: &error,
                };
                rows[found + place] = value(&piece)?;
            }
        }
    }
    Ok(())
}

/// The bytes of numbers.
#[derive(Debug)]
pub(super) struct Binary {
    file: InputFile,
    bytes: Vec<u8>,
    at: usize,
    big_endian: bool,
}

impl Binary {
    /// Makes so many bytes the next ones in memory, and tells whether there are so many.
    fn has(&mut self, count: usize) -> Result<bool, ReadError> {
        let there = self.bytes.len() - self.at;
        if there < count {
            if self.file.left() < (count - there) as u64 {
                return Ok(false);
            }
            self.bytes.drain(..self.at);
            self.at = 0;
            self.file
                .read((count - there).max(PIECE), &mut self.bytes)?;
        }
        Ok(true)
    }

    /// Reads over so many bytes, and tells whether there are so many.
    fn pass(&mut self, count: u64) -> Result<bool, ReadError> {
        let there = (self.bytes.len() - self.at) as u64;
        match usize::try_from(count) {
            Ok(count) if count as u64 <= there => self.at += count,
            _ if count - there <= self.file.left() => {
                self.bytes.clear();
                self.at = 0;
                self.file.go_to(self.file.at + (count - there))?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Reads so many records of an element, from this one on: of each the properties at these places.
    fn read<T: Copy + Default>(
        &mut self,
        (element, places): (&Element, &[usize]),
        first: u64,
        count: u64,
        rows: &mut Vec<T>,
        value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let Some(stride) = element.stride() else {
            return (first..first + count)
                .try_for_each(|at| self.read_record((element, places), at, rows, &value));
        };
        if first == 0 {
            // A file that is cut off is refused before the work on it.
            self.check_length(element, first, stride)?;
        }
        let offset = |place: usize| {
            let before = element.properties[..place].iter();
            before.map(|property| property.kind.size()).sum::<usize>()
        };
        let field = |&place: &usize| {
            let kind = element.properties[place].kind;
            let begin = offset(place);
            let big_endian = self.big_endian;
            (begin..begin + kind.size(), Number { kind, big_endian })
        };
        let fields: Vec<(Range<usize>, Number)> = places.iter().map(field).collect();
        for at in first..first + count {
            if !self.has(stride)? {
                return Err(element.error(&self.file, at, &element.end()));
            }
            let record = &self.bytes[self.at..self.at + stride];
            let error = |what: String| element.error(&self.file, at, &what);
            let read = |(range, number): &(Range<usize>, Number)| {
                value(&Piece {
                    bytes: &record[range.clone()],
                    number: Some(*number),
                    error: &error,
                })
            };
            for field in &fields {
                rows.push(read(field)?);
            }
            self.at += stride;
        }
        Ok(())
    }

    /// Reads over what is left of an element.
    fn skip(&mut self, element: &Element, first: u64) -> Result<(), ReadError> {
        let Some(stride) = element.stride() else {
            return (first..element.count).try_for_each(|at| {
                self.read_record::<u64>((element, &[]), at, &mut Vec::new(), &|_| Ok(0))
            });
        };
        let bytes = self.check_length(element, first, stride)?;
        self.pass(bytes)?;
        Ok(())
    }

    /// Checks that the file is long enough for all records from this one on, and returns how many bytes they take.
    fn check_length(&self, element: &Element, first: u64, stride: usize) -> Result<u64, ReadError> {
        let stride = stride as u64;
        let left = self.file.left() + (self.bytes.len() - self.at) as u64;
        let bytes = (element.count - first).checked_mul(stride);
        bytes
            .filter(|&bytes| bytes <= left)
            .ok_or_else(|| element.error(&self.file, first + left / stride, &element.end()))
    }

    /// Reads a record whose length is known when it is read.
    fn read_record<T: Copy + Default>(
        &mut self,
        (element, places): (&Element, &[usize]),
        record: u64,
        rows: &mut Vec<T>,
        value: &impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let found = rows.len();
        rows.resize(found + places.len(), T::default());
        for (at, property) in element.properties.iter().enumerate() {
            let kind = property.length.unwrap_or(property.kind);
            if !self.has(kind.size())? {
                return Err(element.error(&self.file, record, &element.end()));
            }
            let error = |what: String| element.error(&self.file, record, &what);
            let piece = Piece {
                bytes: &self.bytes[self.at..self.at + kind.size()],
                number: Some(Number {
                    kind,
                    big_endian: self.big_endian,
                }),
                error: &error,
            };
            let place = places.iter().position(|&place| place == at);
            let members = match (property.length, place) {
                (Some(_), _) => piece.index("the length of a list")?,
                (None, Some(place)) => {
                    rows[found + place] = value(&piece)?;
                    0
                }
                (None, None) => 0,
            };
            self.at += kind.size();
            if !self.pass(members.saturating_mul(property.kind.size() as u64))? {
                return Err(element.error(&self.file, record, &element.end()));
            }
        }
        Ok(())
    }
}

impl Element {
    fn end(&self) -> String {
        format!("the file ends, and {} are announced", self.count)
    }
}
