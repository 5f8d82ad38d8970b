//! Reading a planar straight-line graph.

use num_rational::BigRational;

use crate::formats::read::content::{Edges, Vertices};
use crate::formats::read::source::{ReadError, Source};
use crate::formats::read::{json, triangle};
use crate::formats::{Coordinate, CoordinateError, Graph, Region};

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
    let mut content = match format {
        InputFormat::Node => triangle::read_node(source).map(without_edges)?,
        InputFormat::Poly => triangle::read_poly(source, node)?,
        InputFormat::Json => json::read(source)?,
    };
    // First as doubles; if a coordinate is a fraction, all once more as rationals.
    let is_exact = |error| match error {
        CoordinateError::Fraction => true,
        // No double, but perhaps a fraction after it says that there need be none.
        CoordinateError::TooLarge => has_fraction(&content),
        _ => false,
    };
    match graph(&content) {
        Ok(graph) => Ok(Input::Doubles(Graph {
            edges: content.edges,
            ..graph
        })),
        Err((error, _)) if is_exact(error) => {
            let edges = std::mem::take(&mut content.edges);
            let graph = graph(&content).map_err(|(_, error)| error)?;
            Ok(Input::Rationals(Graph { edges, ..graph }))
        }
        Err((_, error)) => Err(error),
    }
}

/// All but the edges, with coordinates as values of a type.
fn graph<S: Coordinate>(content: &Edges<'_>) -> Result<Graph<S>, (CoordinateError, ReadError)> {
    let attributes = content.attributes.iter();
    let regions = content.regions.points()?.into_iter().zip(attributes);
    Ok(Graph {
        points: content.vertices.points()?,
        edges: Vec::new(),
        pieces_of: Vec::new(),
        holes: content.holes.points()?,
        regions: regions
            .map(|(seed, &attribute)| Region { seed, attribute })
            .collect(),
        first_vertex: content.vertices.first,
        first_edge: content.first,
        first_hole: content.holes.first,
        first_region: content.regions.first,
    })
}

/// Whether a coordinate looks like a fraction.
fn has_fraction(content: &Edges<'_>) -> bool {
    let lists = [&content.vertices, &content.holes, &content.regions];
    let mut coordinates = lists
        .iter()
        .flat_map(|list| list.coordinates.as_flattened());
    coordinates.any(|piece| piece.contains(&b'/'))
}

/// No edges. They are numbered from 0 or 1 as the vertices are.
fn without_edges(vertices: Vertices<'_>) -> Edges<'_> {
    let first = vertices.first;
    Edges::without_seeds(vertices, Vec::new(), first)
}
