//! The contents of a file, with coordinates still as text.
//!
//! Whether a file holds doubles or fractions is known only when all of it is read: in a file with a
//! fraction, `0.1` is one tenth. So the readers only find where each coordinate stands, and
//! [`Vertices::points`] converts them all, first to doubles and, where it meets a fraction, once more to
//! rationals.

use std::borrow::Cow;

use crate::formats::read::source::{ReadError, Source, quoted};
use crate::formats::{Coordinate, CoordinateError, on_all_cores};

/// The vertices of a file.
pub(super) struct Vertices<'a> {
    pub(super) source: &'a Source,
    pub(super) syntax: Syntax,
    /// Where the coordinates stand: pieces of the source.
    pub(super) coordinates: Vec<[&'a [u8]; 2]>,
    /// The file's number of the first vertex.
    pub(super) first: usize,
}

/// How coordinates stand in a file.
#[derive(Clone, Copy)]
pub(super) enum Syntax {
    /// As they are.
    Plain,
    /// As JSON's numbers and strings; errors name their columns.
    Json,
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
            vertices,
            edges,
            first,
        }
    }
}

impl<'a> Vertices<'a> {
    /// None, of a file that numbers them from `first`.
    pub(super) fn none(source: &'a Source, first: usize) -> Vertices<'a> {
        Vertices {
            source,
            syntax: Syntax::Plain,
            coordinates: Vec::new(),
            first,
        }
    }

    /// The coordinates as values of a type; or the error of the first one that is not such a value.
    pub(super) fn points<S: Coordinate>(
        &self,
    ) -> Result<Vec<[S; 2]>, (CoordinateError, ReadError)> {
        const CHUNK: usize = 1 << 13;
        let value = |piece| S::from_text(&self.syntax.text(piece)).map_err(|error| (error, piece));
        let points = |pieces: &[[&'a [u8]; 2]]| {
            let point = |&[x, y]: &[&'a [u8]; 2]| Ok([value(x)?, value(y)?]);
            pieces.iter().map(point).collect::<Result<Vec<_>, _>>()
        };
        let mut list = Vec::with_capacity(self.coordinates.len());
        for points in on_all_cores(self.coordinates.chunks(CHUNK).collect(), points) {
            list.append(&mut points.map_err(|(error, piece)| (error, self.error(piece, error)))?);
        }
        Ok(list)
    }

    /// A coordinate as it is written.
    pub(super) fn text(&self, vertex: usize, axis: usize) -> Cow<'_, str> {
        self.syntax.text(self.coordinates[vertex][axis])
    }

    /// What messages call a vertex: the file, the line, and its number there.
    pub(super) fn name(&self, vertex: usize) -> (String, usize, usize) {
        let (line, _) = self.source.position(self.coordinates[vertex][0]);
        (self.source.name.clone(), line, self.first + vertex)
    }

    fn error(&self, piece: &[u8], error: CoordinateError) -> ReadError {
        let (line, column) = self.source.position(piece);
        let shown = match self.syntax {
            Syntax::Plain => quoted(piece),
            Syntax::Json => quoted(self.syntax.text(piece).as_bytes()),
        };
        ReadError {
            column: matches!(self.syntax, Syntax::Json).then_some(column),
            ..self.source.error_in_line(line, format!("{shown} {error}"))
        }
    }
}

impl Syntax {
    /// The text of a coordinate.
    fn text(self, piece: &[u8]) -> Cow<'_, str> {
        match self {
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
