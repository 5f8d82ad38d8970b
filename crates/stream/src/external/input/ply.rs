//! Stanford's `.ply`, as text or binary: the elements `vertex` and `edge`, read in pieces.
//!
//! The header is read as for a file in memory. Of the elements that follow, the points are read first, and then the edges:
//! from where the points ended, or from the begin once more where edges stand before the points. Of a vertex x and y
//! are read, and what is chosen of z and the other numbers. All other elements and properties are read over.

use std::mem;

use sweep_cdt_formats::ply::Header;
use sweep_cdt_formats::{Column, ReadError, Remark, Source, quoted};

use crate::external::input::file::InputFile;
use crate::external::input::ply_body::{Body, Element, Piece, Property};
use crate::external::input::{Choice, Input, MOST_COLUMNS};

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
    left_out: Vec<Remark>,
    has_heights: bool,
    /// The place of z among the properties of a vertex, if heights are asked for.
    z: Option<usize>,
    /// The places of all properties that are read of a vertex: x, y, perhaps z, and others.
    places: Vec<usize>,
    /// The rows that came last, and their heights and other columns.
    rows: Vec<f64>,
    heights: Vec<f64>,
    columns: Vec<Column>,
}

impl Ply {
    pub(super) fn new(mut file: InputFile, choice: &Choice) -> Result<Ply, ReadError> {
        let mut bytes = Vec::new();
        file.read(LONGEST_HEADER, &mut bytes)?;
        let source = Source::new(&file.name, bytes);
        let (header, lines, length) = Header::read(&source)?;
        let begin = (length as u64, lines);
        let mut elements = Vec::new();
        let mut vertex = None;
        let mut z = None;
        let (mut columns, mut places) = (Vec::new(), Vec::new());
        let mut left_out = Vec::new();
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
                z = element
                    .place(&[b"z"])
                    .filter(|&z| choice.heights && element.properties[z].length.is_none());
                places.extend(pair.into_iter().flatten().chain(z));
                let properties = element.properties.iter().enumerate();
                let others = properties.filter(|(at, property)| {
                    property.length.is_none() && property.name != b"z" && !places.contains(at)
                });
                let most = if choice.others { MOST_COLUMNS } else { 0 };
                let others: Vec<(usize, Column)> = others
                    .take(most)
                    .map(|(at, property)| {
                        let name = String::from_utf8_lossy(property.name).into_owned();
                        let values = Vec::new();
                        (at, Column { name, values })
                    })
                    .collect();
                for (at, column) in others {
                    places.push(at);
                    columns.push(column);
                }
            }
            let name = quoted(element.name);
            match pair {
                Some(pair) => {
                    let others = element.properties.iter().enumerate();
                    let is_read = |at| match element.name {
                        b"vertex" => places.contains(&at),
                        _ => pair.contains(&at),
                    };
                    let others = others.filter(|&(at, _)| !is_read(at));
                    left_out.extend(others.map(|(_, property)| {
                        let what = format!("property {} of {name}", quoted(property.name));
                        Remark::Ignored { count: 1, what }
                    }));
                }
                None if element.count > 0 => {
                    let [one, many] =
                        ["record", "records"].map(|what| format!("{what} of the element {name}"));
                    left_out.push(Remark::ignored(element.count, &one, &many));
                }
                None => {}
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
        let has_heights = header.elements[vertex].place(&[b"z"]).is_some();
        let kind = |at: usize| elements[vertex].properties[at].kind;
        if kind(x) != kind(y) {
            return Err(file.error("x and y have different types"));
        }
        let mut ply = Ply {
            body: Body::new(file, header.encoding),
            elements,
            element: 0,
            record: 0,
            vertex,
            begin,
            is_at_edges: false,
            left_out,
            has_heights,
            z,
            places,
            rows: Vec::new(),
            heights: Vec::new(),
            columns,
        };
        ply.body.go_to(begin)?;
        Ok(ply)
    }

    /// The properties at these places of the next records of the element that is read, some of them or all.
    fn next_rows<T: Copy + Default>(
        &mut self,
        places: &[usize],
        rows: &mut Vec<T>,
        value: impl Fn(&Piece<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let element = &self.elements[self.element];
        let count = RECORDS.min(element.count - self.record);
        self.body
            .read((element, places), self.record, count, rows, value)?;
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
        self.body.skip(element, self.record)?;
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
        self.heights.clear();
        for column in &mut self.columns {
            column.values.clear();
        }
        if self.element != self.vertex {
            return self.body.file().check();
        }
        let (places, mut rows) = (mem::take(&mut self.places), mem::take(&mut self.rows));
        rows.clear();
        let read = self.next_rows(&places, &mut rows, |piece| piece.coordinate());
        for row in rows.chunks_exact(places.len()) {
            let [x, y, others @ ..] = row else { continue };
            points.push([*x, *y]);
            let (height, others) = others.split_at(usize::from(self.z.is_some()));
            self.heights.extend(height);
            for (column, &value) in self.columns.iter_mut().zip(others) {
                column.values.push(value);
            }
        }
        (self.places, self.rows) = (places, rows);
        read
    }

    fn heights(&self) -> Option<&[f64]> {
        self.z.map(|_| &self.heights[..])
    }

    fn columns(&self) -> &[Column] {
        &self.columns
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
        match self.elements.get(self.element).and_then(|edge| edge.pair) {
            Some(ends) => {
                let mut corners = Vec::new();
                self.next_rows(&ends, &mut corners, |end| end.index("a vertex's number"))?;
                edges.extend_from_slice(corners.as_chunks().0);
                Ok(())
            }
            None => self.body.file().check(),
        }
    }

    fn remarks(&self) -> Vec<Remark> {
        self.left_out.clone()
    }

    fn has_heights(&self) -> bool {
        self.has_heights
    }

    fn progress(&self) -> (u64, u64) {
        let file = self.body.file();
        (file.at, file.length)
    }
}

/// How many records are read at once.
const RECORDS: u64 = 1 << 13;
