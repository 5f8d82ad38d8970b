//! Results of any program: triangles, and whose vertices they name.

use std::collections::HashSet;

use crate::formats::read::{ReadError, Source, Stop, ele, json, matching, obj};
use crate::formats::{Coordinate, Graph};
use crate::verify::{Offenders, Violation};

/// What [`read_result`] understands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ResultFormat {
    /// Triangle's triangles.
    Ele,
    /// An object with `triangles`.
    Json,
    /// Wavefront's vertices and faces.
    Obj,
}

impl ResultFormat {
    /// All of them.
    pub const ALL: [ResultFormat; 3] = [ResultFormat::Ele, ResultFormat::Json, ResultFormat::Obj];

    /// The name, which is the extension of its files.
    pub fn name(self) -> &'static str {
        match self {
            ResultFormat::Ele => "ele",
            ResultFormat::Json => "json",
            ResultFormat::Obj => "obj",
        }
    }
}

/// Triangles of a file, by vertices of the input.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Triangles {
    /// The corners, as positions in the input's points. Those that are no vertices of the input follow:
    /// `points.len() + i` stands for `strangers[i]`.
    pub list: Vec<[usize; 3]>,
    /// The file's number of the first triangle.
    pub first: usize,
    /// The file's numbers of corners that are no vertices of the input.
    pub strangers: Vec<usize>,
    /// How the vertices of the file were found among those of the input.
    pub matching: Matching,
}

/// How the vertices of a result are those of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matching {
    /// Those of the same number.
    Numbers,
    /// Those with exactly the same coordinates.
    Coordinates,
}

/// A result as it stands in a file.
pub(super) struct Content<S> {
    /// The corners as the file numbers them.
    pub(super) triangles: Vec<[usize; 3]>,
    pub(super) first_triangle: usize,
    pub(super) first_vertex: usize,
    /// The vertices, where the file has any.
    pub(super) points: Option<Vec<[S; 2]>>,
}

/// Reads a triangulation of `input`; `node` is the `.node` beside a `.ele`.
///
/// Vertices of the file are those of the input with the same coordinates, where there is one for each
/// or where their counts differ; otherwise (if the file has rounded coordinates or none) those with the
/// same numbers. Corners may be out of range: that is for the verifier to say.
///
/// ```
/// use sweep_cdt::formats::{Graph, ResultFormat, Source, read_result};
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let input = Graph { points, ..Graph::default() };
/// let bytes = b"v 0 1 0\nv 0 0 0\nv 1 0 0\nf 1 2 3".to_vec();
/// let source = Source { name: "example".to_owned(), bytes };
/// let triangles = read_result(ResultFormat::Obj, &source, None, &input)?;
/// assert_eq!(triangles.list, [[2, 0, 1]]);
/// # Ok::<(), sweep_cdt::formats::ReadError>(())
/// ```
///
/// # Errors
/// See [`ReadError`].
pub fn read_result<S: Coordinate>(
    format: ResultFormat,
    source: &Source,
    node: Option<&Source>,
    input: &Graph<S>,
) -> Result<Triangles, ReadError> {
    let content = match format {
        ResultFormat::Ele => ele::read(source, node),
        ResultFormat::Json => json::read_triangles(source),
        ResultFormat::Obj => obj::read(source),
    };
    match content {
        Ok(content) => Ok(of_input(content, input)),
        Err(Stop::Bad(error)) => Err(error),
        Err(Stop::Fraction) => {
            let with_points = node.unwrap_or(source);
            let message = "has fractions, and the input has none";
            Err(ReadError::of_file(&with_points.name, message))
        }
    }
}

fn of_input<S: Coordinate>(content: Content<S>, input: &Graph<S>) -> Triangles {
    let count = input.points.len();
    let places = content
        .points
        .filter(|points| *points != input.points)
        .map(|points| matching::places(&points, &input.points))
        .filter(|places| places.len() != count || places.iter().all(Option::is_some));
    let mut strangers = Vec::new();
    let mut vertex = |number: usize| {
        let listed = number.checked_sub(content.first_vertex);
        let place = listed.and_then(|at| match &places {
            Some(places) => places.get(at).copied().flatten(),
            None => Some(at).filter(|&at| at < count),
        });
        place.unwrap_or_else(|| {
            strangers.push(number);
            count + strangers.len() - 1
        })
    };
    let corners = content.triangles.into_iter();
    Triangles {
        list: corners.map(|triangle| triangle.map(&mut vertex)).collect(),
        first: content.first_triangle,
        strangers,
        matching: match places {
            Some(_) => Matching::Coordinates,
            None => Matching::Numbers,
        },
    }
}

impl Triangles {
    /// The vertices of the input that a violation is about: those that it names, then the corners of its
    /// triangles and the ends of its edges, each once.
    pub fn vertices_of<S>(&self, input: &Graph<S>, violation: Violation) -> Vec<usize> {
        let Offenders {
            mut vertices,
            edges,
            triangles,
            ..
        } = violation.offenders();
        vertices.extend(triangles.into_iter().flat_map(|t| self.list[t]));
        vertices.extend(edges.into_iter().flat_map(|e| input.edges[e]));
        let mut seen = HashSet::new();
        vertices.retain(|&v| v < input.points.len() && seen.insert(v));
        vertices
    }

    /// The same violation with all things numbered as in their files.
    pub fn as_numbered<S>(&self, input: &Graph<S>, violation: Violation) -> Violation {
        let names_end = matches!(violation, Violation::EdgeOutOfRange { .. });
        let vertex_number = |vertex: usize| {
            let stranger = vertex
                .checked_sub(input.points.len())
                .filter(|_| !names_end);
            stranger.map_or(vertex.saturating_add(input.first_vertex), |at| {
                self.strangers[at]
            })
        };
        violation.renumbered(
            vertex_number,
            |edge| edge + input.first_edge,
            |triangle| triangle + self.first,
        )
    }
}
