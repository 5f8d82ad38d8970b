//! Reading a planar straight-line graph.

use num_rational::BigRational;

use crate::order::is_finite;
#[cfg(feature = "las")]
use crate::read::cloud;
use crate::read::content::{Edges, Vertices};
use crate::read::matching::find;
use crate::read::numpy::Arrays;
use crate::read::remarks::Remarks;
use crate::read::shapes::{geojson, wkt};
use crate::read::source::{ReadError, Source};
use crate::read::vtu::Unpacked;
use crate::read::{json, obj, off, text, triangle};
use crate::read::{msh, ply, vtk};
use crate::{Column, Coordinate, CoordinateError, Format, GraphFile, Numbering};
use sweep_cdt::{Pslg, Region};

/// Whether every vertex has a height in this format.
fn is_spatial(format: Format) -> bool {
    use Format::{Msh, Obj, Off, Ply, Vtk, Vtp, Vtu};
    matches!(format, Obj | Off | Ply | Vtk | Vtu | Vtp | Msh)
}

/// The contents of a file: rationals if any coordinate in it is a fraction `p/q`, doubles otherwise.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt_formats::{Coordinate, Format, Input, Source, read};
///
/// let bytes = br#"{"points": [[0.1, "1/3"]]}"#.to_vec();
/// let source = Source::new("example", bytes);
/// let Input::Rationals(file) = read(Format::Json, &source, None)? else {
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

/// Reads a file in one of [`Format::INPUTS`]. `node` is the `.node` beside a `.poly`; it is read only if the `.poly` holds no vertices.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Source, read};
///
/// let bytes = br#"{"points": [[0, 0], [1, 0.5]], "edges": [[0, 1]]}"#.to_vec();
/// let source = Source::new("example", bytes);
/// let Input::Doubles(file) = read(Format::Json, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.graph.points, [[0.0, 0.0], [1.0, 0.5]]);
/// assert_eq!(file.graph.edges, [[0, 1]]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
///
/// # Errors
/// See [`ReadError`].
pub fn read(format: Format, source: &Source, node: Option<&Source>) -> Result<Input, ReadError> {
    format.expect_classes(&source.name, &source.classes)?;
    let content = match format {
        Format::Node => {
            let mut remarks = Remarks::default();
            let vertices = triangle::read_node(source, &mut remarks)?;
            Edges {
                remarks,
                ..without_edges(vertices)
            }
        }
        Format::Poly => triangle::read_poly(source, node)?,
        Format::Json => match json::read(source) {
            Err(_) if geojson::is_in(source) => return read(Format::Geojson, source, node),
            content => content.map_err(|error| geojson::foreign(source).unwrap_or(error))?,
        },
        Format::Obj => obj::read(source)?.into_graph()?,
        Format::Off => off::read(source)?.into_graph()?,
        Format::Csv | Format::Xyz | Format::Txt => text::read(source)?,
        Format::Ply => ply::read(source)?.into_graph()?,
        Format::Vtk => vtk::read(source)?.into_graph()?,
        Format::Vtu | Format::Vtp => {
            let unpacked = Unpacked::of(source)?;
            return input(format, unpacked.mesh()?.into_graph()?);
        }
        Format::Msh => msh::read(source)?.into_graph()?,
        Format::Geojson => geojson::read(source)
            .map_err(|error| geojson::foreign(source).unwrap_or(error))?
            .into_graph(),
        Format::Wkt => wkt::read(source)?.into_graph(),
        Format::Npy => return input(format, Arrays::of_points(source)?.graph()?),
        Format::Npz => return input(format, Arrays::of_archive(source)?.graph()?),
        #[cfg(feature = "las")]
        Format::Las | Format::Laz => return Ok(Input::Doubles(cloud::read(source)?)),
        _ => return Err(ReadError::of_file(&source.name, format.lacks("graph"))),
    };
    input(format, content)
}

/// The contents of a file, with their numbers.
fn input(format: Format, content: Edges<'_>) -> Result<Input, ReadError> {
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
    format: Format,
    content: Edges<'_>,
    graph: Pslg<S>,
) -> Result<GraphFile<S>, ReadError> {
    let mut columns = columns(format, &content.vertices)?;
    columns.extend(markers(&content));
    // Triangle's word for no limit is -1.
    let limit = |area: f64| if area > 0.0 { area } else { f64::INFINITY };
    let areas = content.areas.iter().map(|&area| limit(area));
    let has_areas = areas.clone().any(f64::is_finite);
    let is_marked = content.markers.iter().any(|&marker| marker != 0);
    let file = GraphFile {
        columns,
        region_areas: areas.filter(|_| has_areas).collect(),
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
        edge_features: content.edge_features,
        features: content.features,
        properties: content.properties,
        faces: content.faces,
        system: content.system,
        remarks: content.remarks.into_list(),
        ..GraphFile::from(Pslg {
            edges: content.edges,
            ..graph
        })
    };
    // These have no list of vertices, but coordinates wherever a vertex is meant.
    Ok(if matches!(format, Format::Geojson | Format::Wkt) {
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
fn columns(format: Format, vertices: &Vertices<'_>) -> Result<Vec<Column>, ReadError> {
    let mut columns = vertices.columns()?;
    if !matches!(format, Format::Node | Format::Poly) {
        let says_nothing = |height: f64| height.is_nan() || height == 0.0 && is_spatial(format);
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
