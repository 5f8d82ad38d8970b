//! Reading a planar straight-line graph.

use num_rational::BigRational;

use crate::order::is_finite;
use crate::read::content::{Edges, Vertices};
use crate::read::matching::find;
use crate::read::numpy::Arrays;
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source};
use crate::read::vtu::Unpacked;
use crate::read::{geojson, msh, ply, vtk, wkt};
use crate::read::{json, obj, off, points, triangle};
use crate::{Column, Coordinate, CoordinateError, GraphFile, Numbering};
use sweep_cdt::{Pslg, Region};

named! {
    /// A format that [`read()`] understands, named by the extension of its files.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum InputFormat {
        /// Triangle's vertices.
        Node = "node",
        /// Triangle's vertices and edges.
        Poly = "poly",
        /// An object with `points` and `edges`, or `vertices` and `segments`.
        Json = "json",
        /// Wavefront's vertices and lines.
        Obj = "obj",
        /// Geomview's vertices, and faces of two corners.
        Off = "off",
        /// Points, a row for each, with or without the names of columns.
        Csv = "csv",
        /// Points as in `.csv`.
        Xyz = "xyz",
        /// Points as in `.csv`.
        Txt = "txt",
        /// Stanford's vertices and edges, as text or binary.
        Ply = "ply",
        /// VTK's points and lines, as text or binary.
        Vtk = "vtk",
        /// VTK's points and lines, as XML.
        Vtu = "vtu",
        /// VTK's points and lines of polygons, as XML.
        Vtp = "vtp",
        /// Gmsh's nodes and lines, as text or binary.
        Msh = "msh",
        /// Points, lines and polygons of maps, as JSON.
        Geojson = "geojson",
        /// Points, lines and polygons as text.
        Wkt = "wkt",
        /// Points as an array of NumPy.
        Npy = "npy",
        /// Points and edges as arrays of NumPy.
        Npz = "npz",
    }
}

impl InputFormat {
    /// Whether every vertex has a height in it.
    fn is_spatial(self) -> bool {
        use InputFormat::{Msh, Obj, Off, Ply, Vtk, Vtp, Vtu};
        matches!(self, Obj | Off | Ply | Vtk | Vtu | Vtp | Msh)
    }

    /// Whether it has no list of vertices, but coordinates wherever a vertex is meant.
    fn is_without_vertices(self) -> bool {
        matches!(self, InputFormat::Geojson | InputFormat::Wkt)
    }
}

/// The contents of a file: rationals if any coordinate in it is a fraction `p/q`, doubles otherwise.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt_formats::{Coordinate, Input, InputFormat, Source, read};
///
/// let bytes = br#"{"points": [[0.1, "1/3"]]}"#.to_vec();
/// let source = Source::new("example", bytes);
/// let Input::Rationals(file) = read(InputFormat::Json, &source, None)? else {
///     unreachable!("there is a fraction in the file")
/// };
/// assert_eq!(file.graph.points[0].each_ref().map(BigRational::text), ["1/10", "1/3"]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// All coordinates are decimals, each read as the nearest double.
    Doubles(GraphFile<f64>),
    /// Some coordinate is a fraction; all are read exactly.
    Rationals(GraphFile<BigRational>),
}

/// Reads a file. `node` is the `.node` beside a `.poly`; it is read only if the `.poly` holds no vertices.
///
/// ```
/// use sweep_cdt_formats::{Input, InputFormat, Source, read};
///
/// let bytes = br#"{"points": [[0, 0], [1, 0.5]], "edges": [[0, 1]]}"#.to_vec();
/// let source = Source::new("example", bytes);
/// let Input::Doubles(file) = read(InputFormat::Json, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.graph.points, [[0.0, 0.0], [1.0, 0.5]]);
/// assert_eq!(file.graph.edges, [[0, 1]]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
///
/// # Errors
/// See [`ReadError`].
pub fn read(
    format: InputFormat,
    source: &Source,
    node: Option<&Source>,
) -> Result<Input, ReadError> {
    let content = match format {
        InputFormat::Node => {
            let mut remarks = Remarks::default();
            let vertices = triangle::read_node(source, &mut remarks)?;
            Edges {
                remarks,
                ..without_edges(vertices)
            }
        }
        InputFormat::Poly => triangle::read_poly(source, node)?,
        InputFormat::Json => match json::read(source) {
            Err(_) if geojson::is_in(source) => return read(InputFormat::Geojson, source, node),
            content => content?,
        },
        InputFormat::Obj => obj::read(source)?.into_graph()?,
        InputFormat::Off => off::read(source)?.into_graph()?,
        InputFormat::Csv | InputFormat::Xyz | InputFormat::Txt => points::read(source)?,
        InputFormat::Ply => ply::read(source)?.into_graph()?,
        InputFormat::Vtk => vtk::read(source)?.into_graph()?,
        InputFormat::Vtu | InputFormat::Vtp => {
            let unpacked = Unpacked::of(source)?;
            return input(format, unpacked.mesh()?.into_graph()?);
        }
        InputFormat::Msh => msh::read(source)?.into_graph()?,
        InputFormat::Geojson => geojson::read(source)?.into_graph(),
        InputFormat::Wkt => wkt::read(source)?.into_graph(),
        InputFormat::Npy => return input(format, Arrays::of_points(source)?.graph()?),
        InputFormat::Npz => return input(format, Arrays::of_archive(source)?.graph()?),
    };
    input(format, content)
}

/// The contents of a file, with their numbers.
fn input(format: InputFormat, content: Edges<'_>) -> Result<Input, ReadError> {
    // First as doubles; if a coordinate is a fraction, all once more as rationals.
    let is_exact = |error| match error {
        CoordinateError::Fraction => true,
        // No double, but perhaps a fraction after it says that there need be none.
        CoordinateError::TooLarge => has_fraction(&content),
        _ => false,
    };
    match graph(&content) {
        Ok(doubles) => Ok(Input::Doubles(file(format, content, doubles)?)),
        Err((error, _)) if is_exact(error) => {
            let exact = graph(&content).map_err(|(_, error)| error)?;
            Ok(Input::Rationals(file(format, content, exact)?))
        }
        Err((_, error)) => Err(error),
    }
}

/// A file with this graph, which has no edges yet; where coordinates stand for vertices, equal points are one.
fn file<S: Coordinate>(
    format: InputFormat,
    content: Edges<'_>,
    graph: Pslg<S>,
) -> Result<GraphFile<S>, ReadError> {
    let mut columns = columns(format, &content.vertices)?;
    columns.extend(markers(&content));
    let is_marked = content.markers.iter().any(|&marker| marker != 0);
    let file = GraphFile {
        columns,
        numbering: Numbering {
            vertex: content.vertices.first,
            edge: content.first,
            hole: content.holes.first,
            region: content.regions.first,
        },
        edge_markers: if is_marked {
            content.markers
        } else {
            Vec::new()
        },
        polygons: content.polygons,
        edge_features: content.features,
        faces: content.faces,
        system: content.system,
        remarks: content.remarks.into_list(),
        ..GraphFile::from(Pslg {
            edges: content.edges,
            ..graph
        })
    };
    Ok(if format.is_without_vertices() {
        merged(file)
    } else {
        file
    })
}

/// A file with one vertex for equal points: the first of them. In each column it has the first number that any of these
/// points has. Graphs with points that are not finite stay as they are; nothing is made of them.
fn merged<S: Coordinate>(file: GraphFile<S>) -> GraphFile<S> {
    if !file.graph.points.iter().all(is_finite) {
        return file;
    }
    let GraphFile {
        graph,
        columns,
        mut remarks,
        ..
    } = file;
    let firsts = find(&graph.points, &graph.points);
    let is_first = |v: &usize| firsts[*v] == Some(*v);
    let kept: Vec<usize> = (0..graph.points.len()).filter(is_first).collect();
    let place = |v: usize| {
        let first = firsts[v].expect("every point equals itself");
        kept.binary_search(&first).expect("the first one is kept")
    };
    let places: Vec<usize> = (0..graph.points.len()).map(place).collect();
    let gathered = columns.into_iter().map(|column| {
        let values = places
            .iter()
            .enumerate()
            .map(|(v, &place)| (place, column.of(v)));
        let (column, conflict) = column.gathered(kept.len(), values);
        remarks.extend(conflict);
        column
    });
    GraphFile {
        columns: gathered.collect(),
        merged: graph.points.len() - kept.len(),
        remarks,
        graph: Pslg {
            edges: graph.edges.iter().map(|edge| edge.map(place)).collect(),
            points: kept.iter().map(|&v| graph.points[v].clone()).collect(),
            ..graph
        },
        ..file
    }
}

/// The columns of the vertices. Where every vertex must have a height, heights that are all 0 or missing say that there
/// are none. So do heights that are all missing, but for the attributes of Triangle's files.
fn columns(format: InputFormat, vertices: &Vertices<'_>) -> Result<Vec<Column>, ReadError> {
    let mut columns = vertices.columns()?;
    if !matches!(format, InputFormat::Node | InputFormat::Poly) {
        let says_nothing = |height: f64| height.is_nan() || height == 0.0 && format.is_spatial();
        columns.retain(|column| {
            let mut values = column.values.iter();
            column.name != Column::HEIGHT || !values.all(|&height| says_nothing(height))
        });
    }
    Ok(columns)
}

/// The markers of vertices that are given one by one, if any are.
fn markers(content: &Edges<'_>) -> Option<Column> {
    let mut values = vec![f64::NAN; content.vertices.coordinates.len()];
    for &(vertex, marker) in &content.vertex_markers {
        if let Some(value) = values.get_mut(vertex) {
            *value = marker as f64;
        }
    }
    let name = Column::MARKER.to_owned();
    let column = Column { name, values };
    (column.missing() < column.values.len()).then_some(column)
}

/// The graph without its edges, with coordinates as values of a type.
fn graph<S: Coordinate>(content: &Edges<'_>) -> Result<Pslg<S>, (CoordinateError, ReadError)> {
    let attributes = content.attributes.iter();
    let regions = content.regions.points()?.into_iter().zip(attributes);
    Ok(Pslg {
        points: content.vertices.points()?,
        edges: Vec::new(),
        holes: content.holes.points()?,
        regions: regions
            .map(|(seed, &attribute)| Region { seed, attribute })
            .collect(),
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
