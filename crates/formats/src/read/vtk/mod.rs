//! VTK's legacy format `.vtk`, as text or binary, of the versions 1 to 5: `POLYDATA` and `UNSTRUCTURED_GRID`.
//!
//! ```text
//! # vtk DataFile Version 3.0
//! <title>
//! ASCII                                        or BINARY: all numbers are bytes, the most significant one first
//! DATASET POLYDATA                             or UNSTRUCTURED_GRID
//! POINTS <points> <type>                       then x, y and z of each; numbered from 0
//! LINES <lines> <numbers>                      then of each the count and the points
//! POLYGONS <polygons> <numbers>                likewise; TRIANGLE_STRIPS too, and CELLS with CELL_TYPES
//! POINT_DATA <points>                          then columns: SCALARS of one component, and such FIELDs
//! ```
//!
//! Version 5 lists `OFFSETS` and `CONNECTIVITY` of cells in place of counts. A line may go through more than two
//! points. Points as cells are read over. Data of the cells are read of two names: `marker` of lines and `region` of
//! triangles. Other data of the cells, data with several components, and data of kinds other than `SCALARS`, `VECTORS`,
//! `NORMALS` and `FIELD` with all that follows, are ignored with a remark.

mod arrays;
pub(super) mod cells;

use crate::read::binary::Kind;
use crate::read::content::{Field, Vertices};
use crate::read::mesh::{Cells, Mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source};
use crate::read::vtk::arrays::Arrays;
use crate::read::vtk::cells::CellData;
use crate::read::words::Words;

/// Reads a `.vtk`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    let mut words = Words::new(source)?;
    let head = words.line();
    let version = head.strip_prefix(b"# vtk DataFile Version ");
    let Some(&version) = version.and_then(|version| version.first()) else {
        return Err(
            source.error_in_line(1, "the file does not begin with `# vtk DataFile Version`")
        );
    };
    words.line();
    let is_binary = match words.expect("`ASCII` or `BINARY`")? {
        b"ASCII" => false,
        b"BINARY" => true,
        other => return Err(words.error(other, "is not `ASCII` or `BINARY`")),
    };
    let mut file = File {
        arrays: Arrays {
            words,
            is_binary,
            has_offsets: version >= b'5',
        },
        data: Data::None,
        vertices: None,
        cells: None,
        lists: Cells::default(),
        cell_data: CellData::default(),
        remarks: Remarks::default(),
    };
    while let Some(keyword) = file.arrays.words.word() {
        if !file.section(source, keyword)? {
            file.remarks
                .ignore_named(1, ["section", "sections"], keyword);
            break;
        }
    }
    if file.cells.is_some() {
        return Err(file.arrays.words.end("`CELL_TYPES`"));
    }
    match file.vertices {
        None => Err(ReadError::of_file(&source.name, "there are no `POINTS`")),
        Some(vertices) => Ok(Mesh {
            cells: file.cell_data.given_to(file.lists, &mut file.remarks),
            vertices,
            first: 0,
            remarks: file.remarks,
        }),
    }
}

struct File<'a> {
    arrays: Arrays<'a>,
    data: Data,
    vertices: Option<Vertices<'a>>,
    /// The corners of cells whose types follow.
    cells: Option<Vec<Vec<usize>>>,
    lists: Cells,
    cell_data: CellData,
    remarks: Remarks,
}

/// The things that the data belong to, and their number.
#[derive(Clone, Copy)]
enum Data {
    None,
    Points(usize),
    Cells(usize),
}

impl Data {
    fn count(self) -> usize {
        match self {
            Data::None => 0,
            Data::Points(count) | Data::Cells(count) => count,
        }
    }
}

impl<'a> File<'a> {
    /// Reads a section; false if it is one that nothing is read of, and cannot be read over.
    fn section(&mut self, source: &'a Source, keyword: &'a [u8]) -> Result<bool, ReadError> {
        match keyword {
            b"DATASET" => {
                let kind = self.arrays.words.expect("a kind of data set")?;
                if ![&b"POLYDATA"[..], b"UNSTRUCTURED_GRID"].contains(&kind) {
                    return Err(self
                        .arrays
                        .words
                        .error(kind, "is not `POLYDATA` or `UNSTRUCTURED_GRID`"));
                }
            }
            b"POINTS" => self.read_points(source)?,
            // The numbers of points, lines, polygons and strips in a grid.
            b"VERTICES" => self.add_cells(source, 2)?,
            b"LINES" => self.add_cells(source, 4)?,
            b"POLYGONS" => self.add_cells(source, 7)?,
            b"TRIANGLE_STRIPS" => self.add_cells(source, 6)?,
            b"CELLS" => self.cells = Some(self.arrays.read_cells()?),
            b"CELL_TYPES" => self.read_types(source)?,
            b"POINT_DATA" => {
                self.data = Data::Points(self.arrays.words.index("a number of points")?);
            }
            b"CELL_DATA" => self.data = Data::Cells(self.arrays.words.index("a number of cells")?),
            b"METADATA" => self.arrays.skip_metadata(),
            b"FIELD" => {
                self.arrays.words.expect("a name")?;
                for _ in 0..self.arrays.words.index("a number of arrays")? {
                    let mut name = self.arrays.words.expect("a name")?;
                    while name == b"METADATA" {
                        self.arrays.skip_metadata();
                        name = self.arrays.words.expect("a name")?;
                    }
                    let components = self.arrays.words.index("a number of components")?;
                    let tuples = self.arrays.words.index("a number of tuples")?;
                    let kind = self.arrays.read_kind()?;
                    self.read_data(name, kind, components.checked_mul(tuples))?;
                }
            }
            b"SCALARS" => {
                let name = self.arrays.words.expect("a name")?;
                let kind = self.arrays.read_kind()?;
                // The number of components may be left out, and the table, too.
                let line = self.arrays.words.clone().line();
                let components = if line.is_empty() {
                    1
                } else {
                    self.arrays.words.index("a number of components")?
                };
                let mut behind = self.arrays.words.clone();
                if behind.word() == Some(b"LOOKUP_TABLE") {
                    behind.expect("the name of a table")?;
                    self.arrays.words = behind;
                }
                self.read_data(name, kind, components.checked_mul(self.data.count()))?;
            }
            b"VECTORS" | b"NORMALS" => {
                let name = self.arrays.words.expect("a name")?;
                let kind = self.arrays.read_kind()?;
                self.read_data(name, kind, self.data.count().checked_mul(3))?;
            }
            _ if matches!(self.data, Data::None) => {
                return Err(self
                    .arrays
                    .words
                    .error(keyword, "is not a section of points or cells"));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Reads cells that are all of one of VTK's types, and adds them.
    fn add_cells(&mut self, source: &'a Source, kind: usize) -> Result<(), ReadError> {
        for (at, cell) in self.arrays.read_cells()?.iter().enumerate() {
            add_cell(&mut self.lists, kind, cell, source, at);
            self.cell_data.end_cell(&self.lists);
        }
        Ok(())
    }

    fn read_points(&mut self, source: &'a Source) -> Result<(), ReadError> {
        let count = self.arrays.words.index("a number of points")?;
        let kind = self.arrays.read_kind()?;
        if kind == Kind::I64 {
            return Err(ReadError::of_file(
                &source.name,
                "coordinates are whole numbers of 64 bits",
            ));
        }
        let pieces = self
            .arrays
            .numbers(kind, count.checked_mul(3), "a coordinate")?;
        let (points, _) = pieces.as_chunks();
        let (coordinates, heights): (Vec<_>, Vec<_>) =
            points.iter().map(|&[x, y, z]| ([x, y], Some(z))).unzip();
        let vertices = Vertices {
            syntax: self.arrays.syntax(kind),
            ..Vertices::plain(source, coordinates, 0)
        };
        self.vertices = Some(vertices.with_heights(&heights));
        Ok(())
    }

    /// Reads what the cells are, and adds them.
    fn read_types(&mut self, source: &'a Source) -> Result<(), ReadError> {
        let count = self.arrays.words.index("a number of cells")?;
        let types = self.arrays.indices(Kind::I32, count)?;
        let cells = self.cells.take().unwrap_or_default();
        if types.len() != cells.len() {
            let message = format!("there are {} cells and types of {count}", cells.len());
            return Err(ReadError::of_file(&source.name, message));
        }
        for (at, (kind, cell)) in types.into_iter().zip(&cells).enumerate() {
            add_cell(&mut self.lists, kind, cell, source, at);
            self.cell_data.end_cell(&self.lists);
        }
        Ok(())
    }

    /// Reads an array of data; of one number for each point it is a column.
    fn read_data(
        &mut self,
        name: &[u8],
        kind: Kind,
        count: Option<usize>,
    ) -> Result<(), ReadError> {
        let pieces = self.arrays.numbers(kind, count, "a number")?;
        let syntax = self.arrays.syntax(kind);
        match (self.data, &mut self.vertices) {
            (Data::Points(count), Some(vertices))
                if pieces.len() == count && count == vertices.coordinates.len() =>
            {
                vertices.fields.push(Field {
                    name: String::from_utf8_lossy(name).into_owned(),
                    syntax,
                    pieces,
                });
            }
            (Data::Cells(_), _) if CellData::is_read(name) => {
                let numbers = pieces
                    .iter()
                    .map(|piece| syntax.value(piece).unwrap_or(f64::NAN));
                self.cell_data.add(name, numbers.collect());
            }
            (Data::Cells(_), _) => {
                self.remarks
                    .ignore_named(1, ["array of cells", "arrays of cells"], name);
            }
            _ => self
                .remarks
                .ignore_named(1, ["array of points", "arrays of points"], name),
        }
        Ok(())
    }
}

/// Adds a cell of one of VTK's types.
pub(super) fn add_cell(
    cells: &mut Cells,
    kind: usize,
    corners: &[usize],
    source: &Source,
    at: usize,
) {
    let error = |what: String| of_cell(source, at, &what);
    match kind {
        1 | 2 => {}
        3 | 4 => cells.add_lines(corners),
        5 | 7 | 8 | 9 => cells.add(corners, error),
        6 => cells.add_strip(corners),
        _ => cells.refuse(|| error(format!("cells of type {kind} are no triangles"))),
    }
}

/// The fault of a cell.
fn of_cell(source: &Source, at: usize, what: &str) -> ReadError {
    ReadError::of_file(&source.name, format!("cell {at}: {what}"))
}
