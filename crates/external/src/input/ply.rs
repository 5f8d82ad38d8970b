//! Stanford's `.ply`, as text or binary: the elements `vertex` and `edge`, read in pieces.
//!
//! The header is read as for a file in memory. Of the elements that follow, the points are read first, and then the edges:
//! from where the points ended, or from the begin once more where edges stand before the points. All other elements and
//! properties are read over.

use std::path::Path;

use sweep_cdt_formats::ply::{Encoding, Header, Kind, Number};
use sweep_cdt_formats::{Coordinate, ReadError, Source, quoted};

use crate::input::Input;
use crate::input::file::{InputFile, PIECE};
use crate::input::lines::{Lines, coordinate};

/// No header is longer.
const LONGEST_HEADER: usize = 1 << 20;

/// A `.ply`.
#[derive(Debug)]
pub(super) struct Ply {
    body: Body,
    elements: Vec<Element>,
    /// The element that is read, and how many of its records are.
    element: usize,
    record: u64,
    /// The place of the points among the elements.
    vertex: usize,
    /// Where the body begins: the byte, and the lines before it.
    begin: (u64, usize),
    /// Whether edges are read, and no points any more.
    is_at_edges: bool,
}

/// As many records, each with these properties.
#[derive(Debug)]
struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
    /// The places of the two properties that are read.
    pair: Option<[usize; 2]>,
}

/// The type of a value or of the members of a list, and that of the length of the list.
#[derive(Clone, Copy, Debug)]
struct Property {
    kind: Kind,
    length: Option<Kind>,
}

impl Ply {
    pub(super) fn open(path: &Path) -> Result<Ply, ReadError> {
        let mut file = InputFile::open(path)?;
        let mut bytes = Vec::new();
        file.read(LONGEST_HEADER, &mut bytes)?;
        let source = Source::new(&file.name, bytes);
        let (header, lines, length) = Header::read(&source)?;
        let begin = (length as u64, lines);
        let mut elements = Vec::new();
        let mut vertex = None;
        for element in &header.elements {
            let names = match element.name {
                b"vertex" if vertex.is_none() => Some([b"x".as_slice(), b"y"]),
                b"edge" => Some([b"vertex1".as_slice(), b"vertex2"]),
                _ => None,
            };
            let place = |name: &[u8]| {
                let place = element.place(&[name]);
                let place = place.filter(|&place| element.properties[place].length.is_none());
                place.ok_or_else(|| {
                    let [element, property] = [element.name, name].map(quoted);
                    file.error(format!("the element {element} has no property {property}"))
                })
            };
            // Records without properties take no bytes, so that there may be any number of them.
            let names = names.filter(|_| !element.properties.is_empty());
            let pair = match names {
                Some([a, b]) => Some([place(a)?, place(b)?]),
                None => None,
            };
            if element.name == b"vertex" && pair.is_some() {
                vertex = Some(elements.len());
            }
            let properties = element.properties.iter().map(|property| Property {
                kind: property.kind,
                length: property.length,
            });
            elements.push(Element {
                name: String::from_utf8_lossy(element.name).into_owned(),
                count: match element.properties.is_empty() {
                    true => 0,
                    false => element.count as u64,
                },
                properties: properties.collect(),
                pair,
            });
        }
        let Some(vertex) = vertex else {
            return Err(file.error("there is no element `vertex`"));
        };
        let [x, y] = elements[vertex].pair.expect("it has x and y");
        let kind = |at: usize| elements[vertex].properties[at].kind;
        if kind(x) != kind(y) {
            return Err(file.error("x and y have different types"));
        }
        let body = match header.encoding {
            Encoding::Text => Body::Text(Lines::new(file, 0)),
            Encoding::Binary { big_endian } => Body::Binary(Binary {
                file,
                bytes: Vec::new(),
                at: 0,
                big_endian,
            }),
        };
        let mut ply = Ply {
            body,
            elements,
            element: 0,
            record: 0,
            vertex,
            begin,
            is_at_edges: false,
        };
        ply.body.go_to(begin)?;
        Ok(ply)
    }

    /// The pairs of the next records of the element that is read, some of them or all. There is one.
    fn next_pairs<T>(
        &mut self,
        most: u64,
        pairs: &mut Vec<[T; 2]>,
        value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let element = &self.elements[self.element];
        let count = most.min(element.count - self.record);
        match &mut self.body {
            Body::Text(lines) => {
                for at in self.record..self.record + count {
                    read_line(lines, element, at, pairs, &value)?;
                }
            }
            Body::Binary(binary) => binary.read(element, self.record, count, pairs, &value)?,
        }
        self.record += count;
        Ok(())
    }

    /// Goes to the next element of which `is_wanted` is true, or to the end.
    fn go_to_element(
        &mut self,
        is_wanted: impl Fn(usize, &Element) -> bool,
    ) -> Result<(), ReadError> {
        while let Some(element) = self.elements.get(self.element) {
            let is_read = self.record == element.count;
            if !is_read && is_wanted(self.element, element) {
                return Ok(());
            }
            if is_read {
                (self.element, self.record) = (self.element + 1, 0);
            } else {
                self.skip()?;
            }
        }
        Ok(())
    }

    /// Reads over what is left of an element.
    fn skip(&mut self) -> Result<(), ReadError> {
        let element = &self.elements[self.element];
        match &mut self.body {
            Body::Text(lines) => {
                for at in self.record..element.count {
                    read_line::<u64>(lines, element, at, &mut Vec::new(), |_| Ok(0))?;
                }
            }
            Body::Binary(binary) => binary.skip(element, self.record)?,
        }
        self.record = element.count;
        Ok(())
    }
}

impl Input for Ply {
    fn name(&self) -> &str {
        &self.body.file().name
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let vertex = self.vertex;
        self.go_to_element(|at, _| at >= vertex)?;
        if self.element == self.vertex {
            return self.next_pairs(RECORDS, points, |piece| piece.coordinate());
        }
        self.body.file().check()
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        let vertex = self.vertex;
        if !self.is_at_edges {
            self.is_at_edges = true;
            let before = &self.elements[..vertex];
            if before.iter().any(|element| element.pair.is_some()) {
                (self.element, self.record) = (0, 0);
                self.body.go_to(self.begin)?;
            }
        }
        self.go_to_element(|at, element| at != vertex && element.pair.is_some())?;
        if self.element < self.elements.len() {
            return self.next_pairs(RECORDS, edges, |piece| piece.index("a vertex's number"));
        }
        self.body.file().check()
    }

    fn progress(&self) -> (u64, u64) {
        let file = self.body.file();
        (file.at, file.length)
    }
}

/// How many records are read at once.
const RECORDS: u64 = 1 << 13;

/// A number in a record.
struct Piece<'a> {
    bytes: &'a [u8],
    /// How it stands there, if it is no text.
    number: Option<Number>,
    error: &'a dyn Fn(String) -> ReadError,
}

impl Piece<'_> {
    fn coordinate(&self) -> Result<f64, ReadError> {
        match self.number {
            Some(number) => Ok(number.value(self.bytes)),
            None => coordinate(self.bytes, self.error),
        }
    }

    /// The number of a vertex, or how long a list is.
    fn index(&self, what: &str) -> Result<u64, ReadError> {
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
enum Body {
    /// A line for each record.
    Text(Lines),
    Binary(Binary),
}

impl Body {
    fn file(&self) -> &InputFile {
        match self {
            Body::Text(lines) => &lines.file,
            Body::Binary(binary) => &binary.file,
        }
    }

    /// Goes on at this byte, before which there are so many lines.
    fn go_to(&mut self, (byte, lines): (u64, usize)) -> Result<(), ReadError> {
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
fn read_line<T>(
    lines: &mut Lines,
    element: &Element,
    record: u64,
    pairs: &mut Vec<[T; 2]>,
    value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
) -> Result<(), ReadError> {
    let mut line = lines.expect(|| {
        let Element { name, count, .. } = element;
        format!("{name} {} of {count}", record + 1)
    })?;
    let mut found = [None, None];
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
            let place = element
                .pair
                .and_then(|pair| pair.iter().position(|&place| place == at));
            if let Some(place) = place {
                let error = |what| line.error(what);
                let piece = Piece {
                    bytes,
                    number: None,
                    error: &error,
                };
                found[place] = Some(value(&piece)?);
            }
        }
    }
    if let [Some(a), Some(b)] = found {
        pairs.push([a, b]);
    }
    Ok(())
}

/// The bytes of numbers.
#[derive(Debug)]
struct Binary {
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

    /// Reads so many records of an element that has a pair, from this one on.
    fn read<T>(
        &mut self,
        element: &Element,
        first: u64,
        count: u64,
        pairs: &mut Vec<[T; 2]>,
        value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let (Some(stride), Some(pair)) = (element.stride(), element.pair) else {
            return (first..first + count)
                .try_for_each(|at| self.read_record(element, at, pairs, &value));
        };
        let offset = |place: usize| {
            let before = element.properties[..place].iter();
            before.map(|property| property.kind.size()).sum::<usize>()
        };
        let fields = pair.map(|place| {
            let kind = element.properties[place].kind;
            let begin = offset(place);
            let big_endian = self.big_endian;
            (begin..begin + kind.size(), Number { kind, big_endian })
        });
        for at in first..first + count {
            if !self.has(stride)? {
                return Err(element.error(&self.file, at, &element.end()));
            }
            let record = &self.bytes[self.at..self.at + stride];
            let error = |what: String| element.error(&self.file, at, &what);
            let [a, b] = &fields;
            let read = |(range, number): &(std::ops::Range<usize>, Number)| {
                value(&Piece {
                    bytes: &record[range.clone()],
                    number: Some(*number),
                    error: &error,
                })
            };
            pairs.push([read(a)?, read(b)?]);
            self.at += stride;
        }
        Ok(())
    }

    /// Reads over what is left of an element.
    fn skip(&mut self, element: &Element, first: u64) -> Result<(), ReadError> {
        let Some(stride) = element.stride() else {
            return (first..element.count).try_for_each(|at| {
                self.read_record::<u64>(element, at, &mut Vec::new(), &|_| Ok(0))
            });
        };
        let bytes = (element.count - first).checked_mul(stride as u64);
        let left = self.file.left() + (self.bytes.len() - self.at) as u64;
        match bytes {
            Some(bytes) if self.pass(bytes)? => Ok(()),
            _ => {
                let record = first + left / stride as u64;
                Err(element.error(&self.file, record, &element.end()))
            }
        }
    }

    /// Reads a record whose length is known when it is read.
    fn read_record<T>(
        &mut self,
        element: &Element,
        record: u64,
        pairs: &mut Vec<[T; 2]>,
        value: &impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let mut found = [None, None];
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
            let place = element
                .pair
                .and_then(|pair| pair.iter().position(|&place| place == at));
            let members = match (property.length, place) {
                (Some(_), _) => piece.index("the length of a list")?,
                (None, Some(place)) => {
                    found[place] = Some(value(&piece)?);
                    0
                }
                (None, None) => 0,
            };
            self.at += kind.size();
            if !self.pass(members.saturating_mul(property.kind.size() as u64))? {
                return Err(element.error(&self.file, record, &element.end()));
            }
        }
        if let [Some(a), Some(b)] = found {
            pairs.push([a, b]);
        }
        Ok(())
    }
}

impl Element {
    fn end(&self) -> String {
        format!("the file ends, and {} are announced", self.count)
    }
}
