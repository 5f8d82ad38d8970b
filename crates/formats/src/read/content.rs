//! The contents of a file, with coordinates still as text.
//!
//! Whether a file holds doubles or fractions is known only when all of it is read: in a file with a
//! fraction, `0.1` is one tenth. So the readers only find where each coordinate stands, and
//! [`Vertices::points`] converts them all, first to doubles and, where it meets a fraction, once more to
//! rationals.

use std::borrow::Cow;

use crate::read::binary::{Kind, Number};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};
use crate::threads::in_turn;
use crate::{Column, Coordinate, CoordinateError, CoordinateSystem, Faces, Polygons, Properties};

/// Why a number with a comma in it is none.
pub(super) const NO_COMMAS: &str = "commas in numbers are not read, only points, as in 0.5";

/// The vertices of a file.
pub(super) struct Vertices<'a> {
    pub(super) source: &'a Source,
    pub(super) syntax: Syntax,
    /// Where the coordinates stand: pieces of the source.
    pub(super) coordinates: Vec<[&'a [u8]; 2]>,
    /// Further columns of each vertex.
    pub(super) fields: Vec<Field<'a>>,
    /// The file's number of the first vertex.
    pub(super) first: usize,
}

/// A number for each vertex, as pieces of the source.
pub(super) struct Field<'a> {
    pub(super) name: String,
    pub(super) syntax: Syntax,
    pub(super) pieces: Vec<&'a [u8]>,
}

/// How coordinates stand in a file.
#[derive(Clone, Copy)]
pub(super) enum Syntax {
    /// As they are.
    Plain,
    /// As JSON's numbers and strings; errors name their columns.
    Json,
    /// As the bytes of a number.
    Binary(Number),
}

/// Vertices and edges.
pub(super) struct Edges<'a> {
    pub(super) vertices: Vertices<'a>,
    /// Positions in `vertices`.
    pub(super) edges: Vec<[usize; 2]>,
    /// The file's number of the first edge.
    pub(super) first: usize,
    /// The seeds of holes, read as vertices are.
    pub(super) holes: Vertices<'a>,
    /// The seeds of regions.
    pub(super) regions: Vertices<'a>,
    /// The attributes of the regions.
    pub(super) attributes: Vec<f64>,
    /// The greatest areas in the regions, or none.
    pub(super) areas: Vec<f64>,
    /// The markers of the edges, or none.
    pub(super) markers: Vec<i64>,
    /// Vertices with markers, where these are no column.
    pub(super) vertex_markers: Vec<(usize, i64)>,
    pub(super) polygons: Polygons,
    /// The feature of each edge, or none.
    pub(super) edge_features: Vec<u32>,
    /// How many features there are.
    pub(super) features: usize,
    pub(super) properties: Properties,
    pub(super) faces: Faces,
    pub(super) system: Option<CoordinateSystem>,
    pub(super) remarks: Remarks,
}

/// Triangles, and the vertices where the file has any.
pub(super) struct Corners<'a> {
    /// The corners as the file numbers them.
    pub(super) triangles: Vec<[usize; 3]>,
    /// The file's number of the first triangle.
    pub(super) first: usize,
    /// The file's number of the first vertex.
    pub(super) first_vertex: usize,
    pub(super) vertices: Option<Vertices<'a>>,
    /// Whether the file lists no vertices, but the coordinates of each corner: then they have no numbers.
    pub(super) is_soup: bool,
    pub(super) labels: Labels,
}

/// The regions that the triangles of a file lie in, as the file names them.
pub(super) enum Labels {
    Nothing,
    /// The attribute of each triangle.
    Attributes(Vec<f64>),
    /// For each triangle a position in the input's regions.
    Positions(Vec<Option<usize>>),
}

impl<'a> Edges<'a> {
    /// Edges of a file without holes and regions.
    pub(super) fn without_seeds(
        vertices: Vertices<'a>,
        edges: Vec<[usize; 2]>,
        first: usize,
    ) -> Edges<'a> {
        Edges {
            holes: Vertices::none(vertices.source, first),
            regions: Vertices::none(vertices.source, first),
            attributes: Vec::new(),
            areas: Vec::new(),
            markers: Vec::new(),
            vertex_markers: Vec::new(),
            polygons: Polygons::default(),
            edge_features: Vec::new(),
            features: 0,
            properties: Properties::default(),
            faces: Faces::default(),
            system: None,
            remarks: Remarks::default(),
            vertices,
            edges,
            first,
        }
    }
}

impl<'a> Vertices<'a> {
    /// None, of a file that numbers them from `first`.
    pub(super) fn none(source: &'a Source, first: usize) -> Vertices<'a> {
        Vertices::plain(source, Vec::new(), first)
    }

    /// Vertices of a text, with nothing but their coordinates.
    pub(super) fn plain(
        source: &'a Source,
        coordinates: Vec<[&'a [u8]; 2]>,
        first: usize,
    ) -> Vertices<'a> {
        Vertices {
            source,
            syntax: Syntax::Plain,
            coordinates,
            fields: Vec::new(),
            first,
        }
    }

    /// Gives the vertices their heights, if any has one. Those of the others are missing.
    pub(super) fn with_heights(mut self, heights: &[Option<&'a [u8]>]) -> Vertices<'a> {
        if heights.iter().any(Option::is_some) {
            let pieces = heights.iter().map(|height| height.unwrap_or_default());
            self.fields.push(Field {
                name: Column::HEIGHT.to_owned(),
                syntax: self.syntax,
                pieces: pieces.collect(),
            });
        }
        self
    }

    /// The coordinates as values of a type; or the error of the first one that is not such a value.
    pub(super) fn points<S: Coordinate>(
        &self,
    ) -> Result<Vec<[S; 2]>, (CoordinateError, ReadError)> {
        const CHUNK: usize = 1 << 13;
        let value = |piece| self.syntax.value(piece).map_err(|error| (error, piece));
        let points = |pieces: &[[&'a [u8]; 2]]| {
            let point = |&[x, y]: &[&'a [u8]; 2]| Ok([value(x)?, value(y)?]);
            pieces.iter().map(point).collect::<Result<Vec<_>, _>>()
        };
        let mut list = Vec::with_capacity(self.coordinates.len());
        in_turn(self.coordinates.chunks(CHUNK), points, |points| {
            list.append(&mut points.map_err(|(error, piece)| (error, self.error(piece, error)))?);
            Ok(())
        })?;
        Ok(list)
    }

    /// Further columns of the vertices. All numbers must be finite doubles, or missing: an empty piece, NaN, or JSON's
    /// `null`.
    pub(super) fn columns(&self) -> Result<Vec<Column>, ReadError> {
        let column = |field: &Field<'a>| {
            let value = |&piece: &&'a [u8]| {
                if piece.is_empty() || piece == b"null" {
                    return Ok(f64::NAN);
                }
                let value = field.syntax.value(piece).ok();
                value.filter(|x: &f64| !x.is_infinite()).ok_or_else(|| {
                    let mut why = "is not an attribute, a number".to_owned();
                    if piece.contains(&b',') {
                        why = format!("{why}: {NO_COMMAS}");
                    }
                    self.wrong(field.syntax, piece, &why)
                })
            };
            Ok(Column {
                name: field.name.clone(),
                values: field.pieces.iter().map(value).collect::<Result<_, _>>()?,
            })
        };
        self.fields.iter().map(column).collect()
    }

    /// Whether coordinates are binary numbers of single precision.
    pub(super) fn is_single(&self) -> bool {
        matches!(self.syntax, Syntax::Binary(number) if number.kind == Kind::F32)
    }

    /// A coordinate as it is written.
    pub(super) fn text(&self, vertex: usize, axis: usize) -> Cow<'_, str> {
        self.syntax.text(self.coordinates[vertex][axis])
    }

    /// The name of a vertex in messages: the file, the line, and its number there.
    pub(super) fn name(&self, vertex: usize) -> (String, Option<usize>, usize) {
        let line = match self.syntax {
            Syntax::Plain | Syntax::Json => {
                Some(self.source.position(self.coordinates[vertex][0]).0)
            }
            Syntax::Binary(_) => None,
        };
        (self.source.name.clone(), line, self.first + vertex)
    }

    fn error(&self, piece: &[u8], error: CoordinateError) -> ReadError {
        self.wrong(self.syntax, piece, &error.to_string())
    }

    /// The fault of a number.
    fn wrong(&self, syntax: Syntax, piece: &[u8], why: &str) -> ReadError {
        let message = |shown: &[u8]| format!("{} {why}", quoted(shown));
        let text = syntax.text(piece);
        match syntax {
            Syntax::Plain => {
                let (line, _) = self.source.position(piece);
                self.source.error_in_line(line, message(piece))
            }
            Syntax::Json => {
                let (line, column) = self.source.position(piece);
                ReadError {
                    column: Some(column),
                    ..self.source.error_in_line(line, message(text.as_bytes()))
                }
            }
            Syntax::Binary(_) => ReadError::of_file(&self.source.name, message(text.as_bytes())),
        }
    }
}

impl Syntax {
    /// The value of a coordinate.
    pub(super) fn value<S: Coordinate>(self, piece: &[u8]) -> Result<S, CoordinateError> {
        match self {
            Syntax::Binary(number) => S::from_double(number.value(piece)),
            Syntax::Plain => match std::str::from_utf8(piece) {
                Ok(text) => S::from_text(text),
                Err(_) => Err(CoordinateError::NotANumber),
            },
            Syntax::Json => S::from_text(&self.text(piece)),
        }
    }

    /// The number of a vertex, or a count.
    pub(super) fn index(self, piece: &[u8]) -> Option<usize> {
        match self {
            Syntax::Binary(number) => number.index(piece),
            Syntax::Plain | Syntax::Json => std::str::from_utf8(piece).ok()?.parse().ok(),
        }
    }

    /// The text of a coordinate.
    pub(super) fn text(self, piece: &[u8]) -> Cow<'_, str> {
        match self {
            Syntax::Binary(number) => number.value(piece).text().into(),
            Syntax::Json if piece.starts_with(b"\"") => {
                serde_json::from_slice::<String>(piece).map_or("".into(), Cow::Owned)
            }
            _ => match std::str::from_utf8(piece) {
                Ok(text) => text.into(),
                Err(_) => String::from_utf8_lossy(piece),
            },
        }
    }
}
