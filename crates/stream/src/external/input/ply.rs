//! Stanford's `.ply`, as text or binary: the elements `vertex` and `edge`, read in pieces.
//!
//! The header is read as for a file in memory. Of the elements that follow, the points are read first, and then the edges:
//! from where the points ended, or from the begin once more where edges stand before the points. Of a vertex x, y and
//! perhaps z are read. All other elements and properties are read over.

use std::path::Path;

use sweep_cdt_formats::ply::Header;
use sweep_cdt_formats::{ReadError, Remark, Source, quoted};

use crate::external::input::Input;
use crate::external::input::file::InputFile;
use crate::external::input::ply_body::{Body, Element, Piece, Property};

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
    /// The place of z among the properties of a vertex, if heights are asked for, and what came last.
    z: Option<usize>,
    places: Vec<[f64; 3]>,
    heights: Vec<f64>,
}

impl Ply {
    pub(super) fn open(path: &Path, heights: bool) -> Result<Ply, ReadError> {
        let mut file = InputFile::open(path)?;
        let mut bytes = Vec::new();
        file.read(LONGEST_HEADER, &mut bytes)?;
        let source = Source::new(&file.name, bytes);
        let (header, lines, length) = Header::read(&source)?;
        let begin = (length as u64, lines);
        let mut elements = Vec::new();
        let mut vertex = None;
        let mut z = None;
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
                    .filter(|&z| heights && element.properties[z].length.is_none());
            }
            let name = quoted(element.name);
            match pair {
                Some(pair) => {
                    let others = element.properties.iter().enumerate();
                    let is_height = |at| element.name == b"vertex" && z == Some(at);
                    let others = others.filter(|&(at, _)| !pair.contains(&at) && !is_height(at));
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
            places: Vec::new(),
            heights: Vec::new(),
        };
        ply.body.go_to(begin)?;
        Ok(ply)
    }

    /// The properties at these places of the next records of the element that is read, some of them or all.
    fn next_rows<T, const N: usize>(
        &mut self,
        places: [usize; N],
        rows: &mut Vec<[T; N]>,
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
        if self.element != self.vertex {
            return self.body.file().check();
        }
        let [x, y] = self.elements[vertex].pair.expect("it has x and y");
        let Some(z) = self.z else {
            return self.next_rows([x, y], points, |piece| piece.coordinate());
        };
        let mut places = std::mem::take(&mut self.places);
        places.clear();
        self.next_rows([x, y, z], &mut places, |piece| piece.coordinate())?;
        points.extend(places.iter().map(|&[x, y, _]| [x, y]));
        self.heights.extend(places.iter().map(|&[.., z]| z));
        self.places = places;
        Ok(())
    }

    fn heights(&self) -> Option<&[f64]> {
        self.z.map(|_| &self.heights[..])
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
            Some(ends) => self.next_rows(ends, edges, |end| end.index("a vertex's number")),
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
