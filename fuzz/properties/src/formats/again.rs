//! Data read, written and read again.

use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Pslg, Triangulation, triangulate};
use sweep_cdt_formats::{
    Column, Coordinate, Format, GraphFile, Input, Source, read, read_result, write_graph,
    write_node,
};

use sweep_cdt_testing::oracle::canonical;

/// Inputs that are written whole have so many points at most.
const POINTS: usize = 64;
/// And coordinates of so many characters, so that fractions are soon added.
const CHARACTERS: usize = 2000;

/// The formats of inputs that came later.
pub(super) const INPUTS: [Format; 12] = [
    Format::Obj,
    Format::Off,
    Format::Ply,
    Format::Vtk,
    Format::Vtu,
    Format::Msh,
    Format::Geojson,
    Format::Wkt,
    Format::Csv,
    Format::Vtp,
    Format::Npy,
    Format::Npz,
];

/// The formats of results that came later.
pub(super) const RESULTS: [Format; 11] = [
    Format::Off,
    Format::Ply,
    Format::Vtk,
    Format::Vtu,
    Format::Msh,
    Format::Stl,
    Format::Geojson,
    Format::Wkt,
    Format::Vtp,
    Format::Npy,
    Format::Npz,
];

/// So many coordinates are read as numbers of each kind.
const NUMBERS: usize = 4;

/// A coordinate of files that can be compared by all its bits.
pub(super) trait Exact: Coordinate + std::fmt::Debug {
    /// The data that were read, in this type.
    fn file(input: Input) -> GraphFile<Self>;
    fn is_same(&self, other: &Self) -> bool;
}

impl Exact for f64 {
    fn file(input: Input) -> GraphFile<f64> {
        match input {
            Input::Doubles(file) => file,
            Input::Rationals(_) => panic!("doubles are read as fractions"),
        }
    }

    fn is_same(&self, other: &f64) -> bool {
        self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
    }
}

/// A file whose fractions are all doubles may hold none.
impl Exact for BigRational {
    fn file(input: Input) -> GraphFile<BigRational> {
        match input {
            Input::Rationals(file) => file,
            Input::Doubles(file) => {
                let exact = |x| BigRational::from_float(x).expect("only fractions were written");
                let GraphFile {
                    graph,
                    columns,
                    numbering,
                    ..
                } = file;
                let graph = Pslg {
                    points: graph.points.iter().map(|p| p.map(exact)).collect(),
                    edges: graph.edges,
                    ..Pslg::default()
                };
                GraphFile {
                    columns,
                    numbering,
                    ..graph.into()
                }
            }
        }
    }

    fn is_same(&self, other: &BigRational) -> bool {
        self == other
    }
}

/// So many of the formats that came later are there for each one that a file is written in.
const SHARE: usize = 8;

/// Writes a file that was read, and its triangulation if it has one, and reads all of that. The share chooses what is
/// among that: some of the formats that came later, and the result in another order or as a picture.
pub(super) fn write<S: Exact>(file: &GraphFile<S>, share: usize) {
    let graph = &file.graph;
    let coordinates = graph.points.as_flattened().iter();
    coordinates.take(NUMBERS).for_each(|x| number(&x.text()));
    let mut node = Vec::new();
    write_node(file, &mut node).expect("memory takes all that is written");
    let mut vertices = file.clone();
    vertices.graph.edges.clear();
    assert_reads(Format::Node, &node, None, &vertices);
    let length = |x: &S| x.text().len();
    let is_short = graph
        .points
        .iter()
        .flatten()
        .all(|x| length(x) <= CHARACTERS);
    if graph.points.len() <= POINTS && graph.edges.len() <= POINTS && is_short {
        match triangulate(&graph.points, &graph.edges) {
            Ok(result) => write_result(file, &result, &node, share),
            Err(error) => assert!(!file.as_numbered(error).to_string().is_empty()),
        }
    }
}

/// Panics unless the bytes read as the file. What has no vertices, or edges, has no first one.
pub(super) fn assert_reads<S: Exact>(
    format: Format,
    bytes: &[u8],
    node: Option<&[u8]>,
    file: &GraphFile<S>,
) {
    let input = read(format, &source(bytes), node.map(source).as_ref());
    let again = S::file(input.unwrap_or_else(|error| panic!("{format:?}: {error}")));
    let is_same = again.graph.points.len() == file.graph.points.len()
        && again
            .graph
            .points
            .as_flattened()
            .iter()
            .zip(file.graph.points.as_flattened())
            .all(|(x, y)| x.is_same(y));
    assert!(is_same, "{format:?}: {again:?} for {file:?}");
    assert_eq!(again.graph.edges, file.graph.edges, "{format:?}");
    // A `.poly` of ours has markers of its own.
    let has_edge_markers = matches!(
        format,
        Format::Json | Format::Ply | Format::Vtk | Format::Vtu | Format::Vtp | Format::Msh
    );
    if has_edge_markers {
        assert_eq!(again.edge_markers, file.edge_markers, "{format:?}");
    }
    if has_edge_markers || matches!(format, Format::Node | Format::Poly) {
        let marked = |file: &GraphFile<S>| {
            let markers = file.vertex_markers().unwrap_or_default();
            markers.iter().any(|&marker| marker != 0).then_some(markers)
        };
        assert_eq!(marked(&again), marked(file), "{format:?}");
    }
    if format != Format::Node {
        assert_eq!(heights(&again), heights(file), "{format:?}");
    } else if !file.graph.points.is_empty() {
        // The first column is read as heights, whatever it was. Without vertices there are no lines for columns.
        let without_names = |file: &GraphFile<S>| -> Vec<Column> {
            let columns = file.columns.iter().cloned();
            // A vertex without a marker has 0 in a `.node`, if the markers are whole numbers. Markers of 0 alone are read
            // as none.
            let has_markers = file.vertex_markers().is_some();
            let unnamed = |mut column: Column| {
                if has_markers && column.name == Column::MARKER {
                    let missing = column.values.iter_mut().filter(|value| value.is_nan());
                    missing.for_each(|value| *value = 0.0);
                }
                let is_none = has_markers
                    && column.name == Column::MARKER
                    && column.values.iter().all(|&value| value == 0.0);
                column.name = String::new();
                (!is_none).then_some(column)
            };
            columns.filter_map(unnamed).collect()
        };
        assert_eq!(without_names(&again), without_names(file));
    }
    let counts = |file: &GraphFile<S>| {
        [
            (file.graph.points.len(), file.numbering.vertex),
            (file.graph.edges.len(), file.numbering.edge),
        ]
        .map(|(count, first)| if count == 0 { 0 } else { first })
    };
    if format != Format::Json {
        assert_eq!(counts(&again), counts(file), "{format:?}");
    }
}

/// The height of each vertex of a file, as [`as_heights`] has them.
pub(super) fn heights<S>(file: &GraphFile<S>) -> Column {
    let column = file.heights().cloned().unwrap_or_default();
    as_heights(column.values, file.graph.points.len())
}

/// Heights as a column, which compares them; 0 for all points where no height is given but 0.
pub(super) fn as_heights(mut values: Vec<f64>, points: usize) -> Column {
    let is_given = |height: &f64| !height.is_nan() && *height != 0.0;
    if !values.iter().any(is_given) {
        values = vec![0.0; points];
    }
    Column {
        name: Column::HEIGHT.to_owned(),
        values,
    }
}

/// Each format of results, and the file of it with the triangulation; the vertices of an `ele` follow
/// after a zero byte.
pub(super) fn files<S: Coordinate>(
    file: &GraphFile<S>,
    result: &Triangulation,
    node: &[u8],
) -> [(Format, Vec<u8>); 3] {
    let text = |format| {
        let mut text = Vec::new();
        sweep_cdt_formats::write(format, file, result, &mut text)
            .expect("memory takes all that is written");
        text
    };
    let ele = [&text(Format::Ele), node].join(&0);
    [
        (Format::Ele, ele),
        (Format::Json, text(Format::Json)),
        (Format::Obj, text(Format::Obj)),
    ]
}

/// A result in one of the formats that came later.
pub(super) fn result_text<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    result: &Triangulation,
) -> Vec<u8> {
    let mut text = Vec::new();
    sweep_cdt_formats::write(format, file, result, &mut text)
        .expect("memory takes all that is written");
    text
}

/// A graph in one of the formats that came later.
pub(super) fn graph_text<S: Coordinate>(format: Format, file: &GraphFile<S>) -> Vec<u8> {
    let mut text = Vec::new();
    write_graph(format, file, &mut text).expect("memory takes all that is written");
    text
}

/// The triangles of a result that must be readable.
fn triangles<S: Exact>(
    format: Format,
    bytes: &[u8],
    node: Option<&Source>,
    input: &GraphFile<S>,
) -> Vec<[usize; 3]> {
    let triangles = read_result(format, &source(bytes), node, input);
    triangles
        .unwrap_or_else(|error| panic!("{format:?}: {error}"))
        .list
}

fn write_result<S: Exact>(file: &GraphFile<S>, result: &Triangulation, node: &[u8], share: usize) {
    let [(_, ele), (_, json), (_, obj)] = &files(file, result, node);
    assert_reads(Format::Json, json, None, file);
    let reads = |format, bytes: &[u8], node: Option<&Source>| {
        let list = triangles(format, bytes, node, file);
        assert_eq!(list, result.canonical_triangles(), "{format:?}");
    };
    let ele = &ele[..ele.len() - node.len() - 1];
    reads(Format::Ele, ele, None);
    reads(Format::Ele, ele, Some(&source(node)));
    reads(Format::Json, json, None);
    // Fractions are rounded in the others.
    if S::APPROX_IS_EXACT {
        reads(Format::Obj, obj, None);
        for format in RESULTS.into_iter().skip(share % SHARE).step_by(SHARE) {
            reads(format, &result_text(format, file, result), None);
        }
        for format in INPUTS.into_iter().skip(share % SHARE).step_by(SHARE) {
            let has_vertices = !matches!(format, Format::Geojson | Format::Wkt);
            if has_vertices || result.duplicates().len() == 0 {
                assert_reads(
                    format,
                    &graph_text(format, file),
                    None,
                    &counted(format, file),
                );
            }
        }
    }
    let format = [Format::Csv, Format::Txt][share / SHARE % 2];
    let counted = counted(format, file);
    assert_reads(format, &graph_text(format, file), None, &counted);
    if (share / (2 * SHARE)).is_multiple_of(2) {
        assert_matches(file, result);
        return;
    }
    let mut picture = Vec::new();
    sweep_cdt_draw::write(Format::Svg, file, result, &mut picture)
        .expect("memory takes all that is written");
    assert_picture(picture);
}

/// A file as a format of meshes or of points counts it, without edges where that has none.
fn counted<S: Exact>(format: Format, file: &GraphFile<S>) -> GraphFile<S> {
    let mut counted = file.clone();
    counted.numbering.vertex = first_of(format);
    counted.numbering.edge = first_of(format);
    if matches!(format, Format::Csv | Format::Txt | Format::Npy) {
        counted.graph.edges.clear();
    }
    counted
}

/// Where a format of meshes begins to count.
fn first_of(format: Format) -> usize {
    usize::from(matches!(format, Format::Obj | Format::Msh))
}

/// Panics unless a result whose vertices stand in another order is read as the same.
fn assert_matches<S: Exact>(file: &GraphFile<S>, result: &Triangulation) {
    let last = file.graph.points.len().wrapping_sub(1);
    let mut reversed = file.clone();
    reversed.graph.points.reverse();
    let edges = reversed.graph.edges.iter_mut();
    edges.for_each(|edge| *edge = edge.map(|v| last - v));
    let mut node = Vec::new();
    write_node(&reversed, &mut node).expect("memory takes all that is written");
    let again = triangulate(&reversed.graph.points, &reversed.graph.edges);
    let again = again.expect("the order does not matter");
    let [(_, ele), _, (_, obj)] = &files(&reversed, &again, &node);
    let ele = &ele[..ele.len() - node.len() - 1];
    let reads = |format, bytes: &[u8], node: Option<&Source>| {
        let list = canonical(result, &triangles(format, bytes, node, file));
        assert_eq!(list, result.canonical_triangles(), "{format:?}, reversed");
    };
    reads(Format::Ele, ele, Some(&source(&node)));
    if S::APPROX_IS_EXACT {
        reads(Format::Obj, obj, None);
    }
}

/// Panics if a picture has coordinates that are no numbers.
pub(super) fn assert_picture(picture: Vec<u8>) {
    let text = String::from_utf8(picture).expect("pictures are text");
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
}

/// Reads a number as a double and as a fraction, and each again as it is written.
pub(super) fn number(token: &str) {
    let double = f64::from_text(token);
    if let Ok(x) = double {
        assert!(
            f64::from_text(&x.text()).is_ok_and(|y| y.is_same(&x)),
            "{token}"
        );
    }
    let Ok(fraction) = BigRational::from_text(token) else {
        return;
    };
    let text = fraction.text();
    assert_eq!(
        BigRational::from_text(&text),
        Ok(fraction.clone()),
        "{token}"
    );
    if let Ok(x) = double
        && x.is_normal()
    {
        let near = fraction.approx();
        let is_near = (near - x).abs() <= x.abs() * f64::EPSILON || near.is_infinite();
        assert!(is_near, "{token}: {x} and {near}");
    }
}

/// Bytes as a file.
pub(super) fn source(bytes: &[u8]) -> Source {
    Source::new("file", bytes.to_vec())
}
