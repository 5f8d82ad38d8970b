//! The elements of a `.vtu` or `.vtp`: what it says of itself, and which arrays there are.

use std::borrow::Cow;
use std::str::FromStr;

use quick_xml::Reader;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};

use crate::read::binary::Kind;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::vtu::arrays::{Appended, Packing, Stored};

/// The contents of the elements.
pub(super) struct Elements<'a> {
    pub(super) packing: Packing<'a>,
    /// Whether it is a `PolyData`, and no `UnstructuredGrid`.
    pub(super) is_poly_data: bool,
    /// How many points there are, if the piece is there.
    pub(super) points: usize,
    /// How many cells there are in each section, if the piece is there.
    pub(super) cells: Vec<(Section, usize)>,
    pub(super) arrays: Vec<Array>,
    /// The names of arrays of points and cells that are no numbers.
    pub(super) others: Vec<String>,
}

/// A `DataArray` of numbers.
pub(super) struct Array {
    pub(super) section: Section,
    pub(super) name: String,
    pub(super) kind: Kind,
    pub(super) components: usize,
    pub(super) stored: Stored,
    /// The line that it begins in.
    pub(super) line: usize,
}

/// The things that an array belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Section {
    PointData,
    CellData,
    Points,
    /// The cells of an `UnstructuredGrid`; the sections below hold those of a `PolyData`.
    Cells,
    Verts,
    Lines,
    Polys,
    Strips,
}

impl Section {
    /// The sections that hold cells, in the order of the data of cells, each with the attribute that says how many.
    const CELLS: [(Section, &str); 5] = [
        (Section::Cells, "NumberOfCells"),
        (Section::Verts, "NumberOfVerts"),
        (Section::Lines, "NumberOfLines"),
        (Section::Strips, "NumberOfStrips"),
        (Section::Polys, "NumberOfPolys"),
    ];
}

/// An element that is open.
enum Open {
    Section(Section),
    Array,
    Other,
}

impl<'a> Elements<'a> {
    pub(super) fn of(source: &'a Source) -> Result<Elements<'a>, ReadError> {
        let bytes = source.text()?;
        // What is appended may be any bytes.
        let end = memchr::memmem::find(bytes, b"<AppendedData");
        let (text, tail) = bytes.split_at(end.unwrap_or(bytes.len()));
        let Ok(text) = std::str::from_utf8(text) else {
            return Err(ReadError::of_file(
                &source.name,
                "the elements are not UTF-8",
            ));
        };
        let mut scan = Scan {
            source,
            pieces: 0,
            open: Vec::new(),
            elements: Elements {
                packing: Packing {
                    big_endian: false,
                    has_wide_headers: false,
                    is_zlib: false,
                    appended: None,
                },
                is_poly_data: false,
                points: 0,
                cells: Vec::new(),
                arrays: Vec::new(),
                others: Vec::new(),
            },
        };
        scan.read(text)?;
        if scan.pieces == 0 {
            return Err(ReadError::of_file(
                &source.name,
                "there is no `Piece` of a `VTKFile`",
            ));
        }
        if !tail.is_empty() {
            scan.elements.packing.appended = Some(scan.appended(tail)?);
        }
        Ok(scan.elements)
    }

    /// The array of this name in a section; that of the points may have any name.
    pub(super) fn array(&self, section: Section, name: &str) -> Option<&Array> {
        let is_meant = |array: &&Array| {
            array.section == section && (section == Section::Points || array.name == name)
        };
        self.arrays.iter().find(is_meant)
    }
}

struct Scan<'a> {
    source: &'a Source,
    elements: Elements<'a>,
    pieces: usize,
    /// From the outermost element on.
    open: Vec<Open>,
}

impl<'a> Scan<'a> {
    fn read(&mut self, text: &str) -> Result<(), ReadError> {
        let mut reader = Reader::from_str(text);
        loop {
            match reader.read_event() {
                Err(error) => {
                    let at = usize::try_from(reader.error_position()).unwrap_or(0);
                    let (_, piece) = text.as_bytes().split_at(at.min(text.len()));
                    return Err(self.error(piece, error.to_string()));
                }
                Ok(Event::Eof) => return Ok(()),
                Ok(Event::Start(element)) => {
                    let open = self.enter(&element)?;
                    self.open.push(open);
                }
                Ok(Event::Empty(element)) => {
                    self.enter(&element)?;
                }
                Ok(Event::End(_)) => drop(self.open.pop()),
                Ok(Event::Text(text)) => self.add_text(&text)?,
                Ok(_) => {}
            }
        }
    }

    /// Takes what an element says.
    fn enter(&mut self, element: &BytesStart<'_>) -> Result<Open, ReadError> {
        let section = match element.name().as_ref() {
            "VTKFile" => return self.enter_file(element),
            "Piece" => return self.enter_piece(element),
            "DataArray" => return self.enter_array(element),
            "PointData" => Section::PointData,
            "CellData" => Section::CellData,
            "Points" => Section::Points,
            "Cells" => Section::Cells,
            "Verts" => Section::Verts,
            "Lines" => Section::Lines,
            "Polys" => Section::Polys,
            "Strips" => Section::Strips,
            _ => return Ok(Open::Other),
        };
        Ok(Open::Section(section))
    }

    fn enter_file(&mut self, element: &BytesStart<'_>) -> Result<Open, ReadError> {
        let kind = self.choose(element, "type", &["UnstructuredGrid", "PolyData"])?;
        self.elements.is_poly_data = kind == 1;
        let order = self.choose(element, "byte_order", &["LittleEndian", "BigEndian"])?;
        let header = self.choose(element, "header_type", &["UInt32", "UInt64"])?;
        let compressor = self.choose(element, "compressor", &["", "vtkZLibDataCompressor"])?;
        let packing = &mut self.elements.packing;
        (packing.big_endian, packing.has_wide_headers) = (order == 1, header == 1);
        packing.is_zlib = compressor == 1;
        Ok(Open::Other)
    }

    fn enter_piece(&mut self, element: &BytesStart<'_>) -> Result<Open, ReadError> {
        self.pieces += 1;
        if self.pieces > 1 {
            return Err(self.error(element.as_bytes(), "more than one `Piece` is not read"));
        }
        self.elements.points = self.number(element, "NumberOfPoints")?.unwrap_or(0);
        for (section, attribute) in Section::CELLS {
            let count = self.number(element, attribute)?.unwrap_or(0);
            self.elements.cells.push((section, count));
        }
        Ok(Open::Other)
    }

    fn enter_array(&mut self, element: &BytesStart<'_>) -> Result<Open, ReadError> {
        let Some(&Open::Section(section)) = self.open.last() else {
            return Ok(Open::Other);
        };
        let kind = self.attribute(element, "type")?;
        let Some(kind) = kind_of(&kind) else {
            if matches!(section, Section::PointData | Section::CellData) {
                let name = self.attribute(element, "Name")?;
                self.elements.others.push(name.into_owned());
                return Ok(Open::Other);
            }
            let message = format!("{} is not a type that is read", quoted(kind.as_bytes()));
            return Err(self.error(element.as_bytes(), message));
        };
        const STORED: [&str; 3] = ["ascii", "binary", "appended"];
        let stored = match self.choose(element, "format", &STORED)? {
            0 => Stored::Text(0..0),
            1 => Stored::Base64(0..0),
            _ => {
                let offset = self.number(element, "offset")?;
                let missing = || self.error(element.as_bytes(), "the array has no `offset`");
                Stored::Appended(offset.ok_or_else(missing)?)
            }
        };
        self.elements.arrays.push(Array {
            section,
            name: self.attribute(element, "Name")?.into_owned(),
            kind,
            components: self.number(element, "NumberOfComponents")?.unwrap_or(1),
            stored,
            line: self.source.position(element.as_bytes()).0,
        });
        Ok(Open::Array)
    }

    /// Takes a text, which belongs to the array that is open.
    fn add_text(&mut self, text: &str) -> Result<(), ReadError> {
        if !matches!(self.open.last(), Some(Open::Array)) || text.trim_ascii().is_empty() {
            return Ok(());
        }
        let begin = text.as_ptr().addr() - self.source.bytes.as_ptr().addr();
        let array = self.elements.arrays.last_mut();
        match array.map(|array| &mut array.stored) {
            Some(Stored::Text(range) | Stored::Base64(range)) if *range == (0..0) => {
                *range = begin..begin + text.len();
                Ok(())
            }
            _ => Err(self.error(text.as_bytes(), "the text does not belong here")),
        }
    }

    /// `AppendedData`, from its beginning on.
    fn appended(&self, tail: &'a [u8]) -> Result<Appended<'a>, ReadError> {
        const BEGIN: &str = "`AppendedData` has no `_` before its data";
        let end = memchr::memchr(b'>', tail).ok_or_else(|| self.error(tail, BEGIN))?;
        let tag = std::str::from_utf8(&tail[1..end]).unwrap_or_default();
        let element = BytesStart::from_content(tag, "AppendedData".len().min(tag.len()));
        let encoding = self.choose(&element, "encoding", &["base64", "raw"])?;
        let data = tail[end + 1..].trim_ascii_start().strip_prefix(b"_");
        let data = data.ok_or_else(|| self.error(tail, BEGIN))?;
        let is_base64 = encoding == 0;
        let end = memchr::memchr(b'<', data).filter(|_| is_base64);
        let offset = |array: &Array| match array.stored {
            Stored::Appended(offset) => Some(offset),
            Stored::Text(_) | Stored::Base64(_) => None,
        };
        let mut offsets: Vec<usize> = self.elements.arrays.iter().filter_map(offset).collect();
        offsets.sort_unstable();
        Ok(Appended {
            bytes: &data[..end.unwrap_or(data.len())],
            is_base64,
            offsets,
        })
    }

    /// The place of an attribute's value among those that it may have; it has the first one if it is not there.
    fn choose(
        &self,
        element: &BytesStart<'_>,
        name: &str,
        values: &[&str],
    ) -> Result<usize, ReadError> {
        let value = self.attribute(element, name)?;
        let place = values.iter().position(|&known| known == value);
        if value.is_empty() {
            return Ok(0);
        }
        place.ok_or_else(|| {
            let known = values.iter().filter(|known| !known.is_empty());
            let known: Vec<String> = known.map(|known| format!("`{known}`")).collect();
            let value = quoted(value.as_bytes());
            let message = format!(
                "the attribute `{name}` is {value}, not {}",
                known.join(" or ")
            );
            self.error(element.as_bytes(), message)
        })
    }

    /// An attribute that is a whole number, if it is there.
    fn number(&self, element: &BytesStart<'_>, name: &str) -> Result<Option<usize>, ReadError> {
        let value = self.attribute(element, name)?;
        if value.is_empty() {
            return Ok(None);
        }
        usize::from_str(value.trim_ascii()).map(Some).map_err(|_| {
            let message = format!("the attribute `{name}` is {}", quoted(value.as_bytes()));
            self.error(element.as_bytes(), format!("{message}, not a whole number"))
        })
    }

    /// An attribute, or nothing.
    fn attribute<'e>(
        &self,
        element: &'e BytesStart<'_>,
        name: &str,
    ) -> Result<Cow<'e, str>, ReadError> {
        let error =
            |error: &dyn std::fmt::Display| self.error(element.as_bytes(), error.to_string());
        let attribute = element.try_get_attribute(name);
        match attribute.map_err(|e| error(&e))? {
            None => Ok(Cow::Borrowed("")),
            Some(attribute) => {
                let value = attribute.normalized_value(XmlVersion::Implicit1_0);
                value.map_err(|e| error(&e))
            }
        }
    }

    /// The fault of a piece of the file.
    fn error(&self, piece: &[u8], message: impl Into<String>) -> ReadError {
        let (line, _) = self.source.position(piece);
        self.source.error_in_line(line, message)
    }
}

fn kind_of(name: &str) -> Option<Kind> {
    Some(match name {
        "Int8" => Kind::I8,
        "UInt8" => Kind::U8,
        "Int16" => Kind::I16,
        "UInt16" => Kind::U16,
        "Int32" => Kind::I32,
        "UInt32" => Kind::U32,
        "Int64" | "UInt64" => Kind::I64,
        "Float32" => Kind::F32,
        "Float64" => Kind::F64,
        _ => return None,
    })
}
