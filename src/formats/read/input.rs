//! Reading a planar straight-line graph.

use num_rational::BigRational;

use crate::formats::read::content::{Edges, Vertices};
use crate::formats::read::source::{ReadError, Source};
use crate::formats::read::{json, triangle};
use crate::formats::{CoordinateError, Graph};

/// What [`read()`] understands. Each format is named by the extension of its files.
///
/// ```
/// use strum::VariantArray;
/// use sweep_cdt::formats::InputFormat;
///
/// assert_eq!("poly".parse(), Ok(InputFormat::Poly));
/// let names: Vec<&str> = InputFormat::VARIANTS.iter().map(Into::into).collect();
/// assert_eq!(names, ["node", "poly", "json"]);
/// ```
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantArray,
)]
#[strum(ascii_case_insensitive, serialize_all = "lowercase")]
#[non_exhaustive]
pub enum InputFormat {
    /// Triangle's vertices.
    Node,
    /// Triangle's vertices and edges.
    Poly,
    /// An object with `points` and `edges`.
    Json,
}

/// What a file holds: rationals if any coordinate in it is a fraction `p/q`, doubles otherwise.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt::formats::{Coordinate, Input, InputFormat, Source, read};
///
/// let bytes = br#"{"points": [[0.1, "1/3"]]}"#.to_vec();
/// let source = Source { name: "example".to_owned(), bytes };
/// let Input::Rationals(graph) = read(InputFormat::Json, &source, None)? else {
///     unreachable!("there is a fraction in the file")
/// };
/// assert_eq!(graph.points[0].each_ref().map(BigRational::text), ["1/10", "1/3"]);
/// # Ok::<(), sweep_cdt::formats::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// All coordinates are decimals, each read as the nearest double.
    Doubles(Graph<f64>),
    /// Some coordinate is a fraction; all are read exactly.
    Rationals(Graph<BigRational>),
}

/// Reads a file. `node` is the `.node` beside a `.poly`; it is read only if the `.poly` holds no vertices.
///
/// ```
/// use sweep_cdt::formats::{Input, InputFormat, Source, read};
///
/// let bytes = br#"{"points": [[0, 0], [1, 0.5]], "edges": [[0, 1]]}"#.to_vec();
/// let source = Source { name: "example".to_owned(), bytes };
/// let Input::Doubles(graph) = read(InputFormat::Json, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(graph.points, [[0.0, 0.0], [1.0, 0.5]]);
/// assert_eq!(graph.edges, [[0, 1]]);
/// # Ok::<(), sweep_cdt::formats::ReadError>(())
/// ```
///
/// # Errors
/// See [`ReadError`].
pub fn read(
    format: InputFormat,
    source: &Source,
    node: Option<&Source>,
) -> Result<Input, ReadError> {
    let Edges {
        vertices,
        edges,
        first,
    } = match format {
        InputFormat::Node => triangle::read_node(source).map(without_edges)?,
        InputFormat::Poly => triangle::read_poly(source, node)?,
        InputFormat::Json => json::read(source)?,
    };
    let (first_vertex, first_edge) = (vertices.first, first);
    // First as doubles; if a coordinate is a fraction, all once more as rationals.
    let is_exact = |error| match error {
        CoordinateError::Fraction => true,
        // No double, but perhaps a fraction after it says that there need be none.
        CoordinateError::TooLarge => has_fraction(&vertices),
        _ => false,
    };
    match vertices.points() {
        Ok(points) => Ok(Input::Doubles(Graph {
            points,
            edges,
            first_vertex,
            first_edge,
        })),
        Err((error, _)) if is_exact(error) => Ok(Input::Rationals(Graph {
            points: vertices.points().map_err(|(_, error)| error)?,
            edges,
            first_vertex,
            first_edge,
        })),
        Err((_, error)) => Err(error),
    }
}

/// Whether a coordinate looks like a fraction.
fn has_fraction(vertices: &Vertices<'_>) -> bool {
    let mut coordinates = vertices.coordinates.as_flattened().iter();
    coordinates.any(|piece| piece.contains(&b'/'))
}

/// No edges. They are numbered from 0 or 1 as the vertices are.
fn without_edges(vertices: Vertices<'_>) -> Edges<'_> {
    Edges {
        first: vertices.first,
        vertices,
        edges: Vec::new(),
    }
}
