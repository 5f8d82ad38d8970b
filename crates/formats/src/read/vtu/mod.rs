//! VTK's XML formats `.vtu` and `.vtp`: an `UnstructuredGrid` or a `PolyData` of one piece. Which of them it is says the
//! file, whatever it is called.
//!
//! ```text
//! <VTKFile type="UnstructuredGrid" byte_order=".." header_type=".." compressor="..">
//!   <UnstructuredGrid> <Piece NumberOfPoints="<points>" NumberOfCells="<cells>">
//!     <PointData>  columns: DataArrays of one number for each point
//!     <Points>     one DataArray of x, y and z of each point; numbered from 0
//!     <Cells>      the DataArrays connectivity, offsets (the end of each cell) and types
//! <VTKFile type="PolyData" ..>
//!   <PolyData> <Piece NumberOfPoints=".." NumberOfVerts=".." NumberOfLines=".." NumberOfPolys=".." NumberOfStrips="..">
//!     <Lines>      connectivity and offsets; Verts, Polys and Strips, too
//! ```
//!
//! The numbers of a `DataArray` stand in it as text or in base 64, or in `AppendedData` behind all others, in base 64 or
//! as they are; packed by zlib or not (see `arrays.rs`). Data of the cells are read of two names, `marker` and
//! `region` (see `vtk/cells.rs`). Other data of the cells, and data of several components, are ignored with a remark.
//!
//! What is packed is unpacked into a copy of the file, behind its text. So numbers are pieces of one source here as in
//! all other readers. It costs the memory of the copy, for which there is a limit ([`Source::unpacked_limit`]).

mod arrays;
mod elements;

use std::iter;
use std::ops::Range;

use crate::read::binary::{Kind, Number};
use crate::read::content::{Field, Syntax, Vertices};
use crate::read::mesh::{Cells, Mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, ReadErrorKind, Source, quoted};
use crate::read::vtk;
use crate::read::vtk::cells::CellData;
use crate::read::vtu::arrays::{Fault, Packing, Stored};
use crate::read::vtu::elements::{Array, Elements, Section};

/// A file with its arrays unpacked behind the text.
pub(super) struct Unpacked {
    source: Source,
    points: Numbers,
    sections: Vec<CellArrays>,
    columns: Vec<(String, Numbers)>,
    /// Data of the cells that are read.
    cell_data: Vec<(String, Numbers)>,
    /// The names of arrays that are not.
    others: Vec<String>,
}

/// The cells of a section.
struct CellArrays {
    /// The corners of all cells, one after the other.
    corners: Numbers,
    /// Where the corners of each cell end.
    ends: Numbers,
    types: Types,
}

/// The types of cells, by VTK's numbers.
enum Types {
    Each(Numbers),
    All(usize),
}

/// Where numbers stand, and how.
struct Numbers {
    syntax: Syntax,
    range: Range<usize>,
    count: usize,
}

impl Unpacked {
    /// Finds the arrays that are read, and unpacks them.
    pub(super) fn of(source: &Source) -> Result<Unpacked, ReadError> {
        let elements = Elements::of(source)?;
        let mut unpacked = source.clone();
        let mut unpack = |array: &Array, count: Option<usize>| {
            let numbers = place(&elements.packing, array, source, &mut unpacked)?;
            match count {
                Some(count) if count != numbers.count => {
                    let (name, there) = (quoted(array.name.as_bytes()), numbers.count);
                    let message = format!("the array {name} has {there} numbers, not {count}");
                    Err(source.error_in_line(array.line, message))
                }
                _ => Ok(numbers),
            }
        };
        let array = |section, name| {
            let missing = || {
                let message = format!("there is no array `{name}`");
                ReadError::of_file(&source.name, message)
            };
            elements.array(section, name).ok_or_else(missing)
        };
        let points = array(Section::Points, "Points")?;
        let coordinates = elements.points.checked_mul(3);
        if points.components != 3 || points.kind == Kind::I64 || coordinates.is_none() {
            let message = "a point is not three numbers that are doubles";
            return Err(source.error_in_line(points.line, message));
        }
        let points = unpack(points, coordinates)?;
        let mut sections = Vec::new();
        for &(section, count) in &elements.cells {
            let count = Some(count);
            let kind = match (section, elements.is_poly_data) {
                (Section::Cells, false) => None,
                (Section::Verts, true) => Some(2),
                (Section::Lines, true) => Some(4),
                (Section::Polys, true) => Some(7),
                (Section::Strips, true) => Some(6),
                _ => continue,
            };
            let is_there = elements.array(section, "offsets").is_some();
            if elements.is_poly_data && count == Some(0) && !is_there {
                continue;
            }
            sections.push(CellArrays {
                corners: unpack(array(section, "connectivity")?, None)?,
                ends: unpack(array(section, "offsets")?, count)?,
                types: match kind {
                    Some(kind) => Types::All(kind),
                    None => Types::Each(unpack(array(section, "types")?, count)?),
                },
            });
        }
        let is_column = |array: &&Array| {
            array.components == 1
                && match array.section {
                    Section::PointData => true,
                    Section::CellData => CellData::is_read(array.name.as_bytes()),
                    _ => false,
                }
        };
        let counts = elements.cells.iter().map(|&(_, count)| count);
        let cells = counts.fold(0, usize::saturating_add);
        let (mut columns, mut cell_data) = (Vec::new(), Vec::new());
        for array in elements.arrays.iter().filter(is_column) {
            let (list, count) = match array.section {
                Section::CellData => (&mut cell_data, cells),
                _ => (&mut columns, elements.points),
            };
            list.push((array.name.clone(), unpack(array, Some(count))?));
        }
        let is_data =
            |array: &&Array| matches!(array.section, Section::PointData | Section::CellData);
        let others = elements.arrays.iter();
        let others = others.filter(|array| is_data(array) && !is_column(array));
        let others = others.map(|array| array.name.clone());
        Ok(Unpacked {
            points,
            sections,
            columns,
            cell_data,
            others: others.chain(elements.others.iter().cloned()).collect(),
            source: unpacked,
        })
    }

    /// The contents of the arrays.
    pub(super) fn mesh(&self) -> Result<Mesh<'_>, ReadError> {
        let mut pieces = self.pieces(&self.points);
        let points = iter::from_fn(|| Some([pieces.next()?, pieces.next()?, pieces.next()?]));
        let (coordinates, heights): (Vec<_>, Vec<_>) =
            points.map(|[x, y, z]| ([x, y], Some(z))).unzip();
        let vertices = Vertices {
            syntax: self.points.syntax,
            ..Vertices::plain(&self.source, coordinates, 0)
        };
        let mut vertices = vertices.with_heights(&heights);
        vertices
            .fields
            .extend(self.columns.iter().map(|(name, numbers)| Field {
                name: name.clone(),
                syntax: numbers.syntax,
                pieces: self.pieces(numbers).collect(),
            }));
        let mut remarks = Remarks::default();
        for name in &self.others {
            remarks.ignore_named(1, ["array", "arrays"], name.as_bytes());
        }
        Ok(Mesh {
            vertices,
            cells: self.cells(&mut remarks)?,
            first: 0,
            remarks,
        })
    }

    fn cells(&self, remarks: &mut Remarks) -> Result<Cells, ReadError> {
        let (mut cells, mut data) = (Cells::default(), CellData::default());
        let mut at = 0;
        for section in &self.sections {
            let corners: Vec<usize> = self.indices(&section.corners).collect::<Result<_, _>>()?;
            let types: Box<dyn Iterator<Item = _>> = match &section.types {
                Types::Each(types) => Box::new(self.indices(types)),
                &Types::All(kind) => Box::new(iter::repeat_with(move || Ok(kind))),
            };
            let mut begin = 0;
            for (end, kind) in self.indices(&section.ends).zip(types) {
                let (end, kind) = (end?, kind?);
                let Some(cell) = corners.get(begin..end) else {
                    let message = format!("cell {at}: its corners are not in `connectivity`");
                    return Err(ReadError::of_file(&self.source.name, message));
                };
                vtk::add_cell(&mut cells, kind, cell, &self.source, at);
                data.end_cell(&cells);
                (begin, at) = (end, at + 1);
            }
        }
        for (name, numbers) in &self.cell_data {
            let value = |piece| numbers.syntax.value(piece).unwrap_or(f64::NAN);
            data.add(name.as_bytes(), self.pieces(numbers).map(value).collect());
        }
        Ok(data.given_to(cells, remarks))
    }

    fn indices(&self, numbers: &Numbers) -> impl Iterator<Item = Result<usize, ReadError>> {
        let syntax = numbers.syntax;
        let index = move |piece: &[u8]| {
            let error = || {
                let text = syntax.text(piece);
                let message = format!(
                    "{} in `Cells` is not a whole number",
                    quoted(text.as_bytes())
                );
                ReadError::of_file(&self.source.name, message)
            };
            syntax.index(piece).ok_or_else(error)
        };
        self.pieces(numbers).map(index)
    }

    /// The numbers one by one.
    fn pieces(&self, numbers: &Numbers) -> impl Iterator<Item = &[u8]> {
        let bytes = &self.source.bytes[numbers.range.clone()];
        let size = match numbers.syntax {
            Syntax::Binary(number) => Some(number.kind.size()),
            _ => None,
        };
        let binary = size.map(|size| bytes.chunks_exact(size));
        let text = size.is_none().then(|| words(bytes));
        (binary.into_iter().flatten()).chain(text.into_iter().flatten())
    }
}

/// Where the numbers of an array stand: in the text, or behind it, where they are appended to `unpacked`.
fn place(
    packing: &Packing<'_>,
    array: &Array,
    source: &Source,
    unpacked: &mut Source,
) -> Result<Numbers, ReadError> {
    if let Stored::Text(range) = &array.stored {
        return Ok(Numbers {
            syntax: Syntax::Plain,
            range: range.clone(),
            count: words(&source.bytes[range.clone()]).count(),
        });
    }
    let begin = unpacked.bytes.len();
    let limit = source.most_unpacked();
    let room = limit.saturating_sub((begin - source.bytes.len()) as u64);
    let unpack = packing.unpack(&array.stored, &source.bytes, &mut unpacked.bytes, room);
    unpack.map_err(|fault| {
        let name = quoted(array.name.as_bytes());
        let error = |what| source.error_in_line(array.line, format!("the array {name}: {what}"));
        match fault {
            Fault::Wrong(what) => error(what),
            Fault::NoRoom(bytes) => ReadError {
                kind: ReadErrorKind::UnpackedLimit { limit },
                ..error(format!(
                    "with its {bytes} bytes the file would unpack to more than the limit of {limit} bytes"
                ))
            },
        }
    })?;
    let range = begin..unpacked.bytes.len();
    Ok(Numbers {
        syntax: Syntax::Binary(Number {
            kind: array.kind,
            big_endian: packing.big_endian,
        }),
        count: range.len() / array.kind.size(),
        range,
    })
}

fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}
