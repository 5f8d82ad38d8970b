//! What was read, written and read again.

use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Triangulation, triangulate};
use sweep_cdt_formats::{
    Column, Coordinate, Graph, Input, InputFormat, OutputFormat, ResultFormat, Source, read,
    read_result, write_graph, write_node,
};

use sweep_cdt_testing::oracle::canonical;

/// Inputs that are written whole have so many points at most.
const POINTS: usize = 64;
/// And coordinates of so many characters, so that fractions are soon added.
const CHARACTERS: usize = 2000;

/// The formats of inputs that came later.
pub(super) const INPUTS: [InputFormat; 8] = [
    InputFormat::Obj,
    InputFormat::Off,
    InputFormat::Ply,
    InputFormat::Vtk,
    InputFormat::Vtu,
    InputFormat::Msh,
    InputFormat::Geojson,
    InputFormat::Wkt,
];

/// The formats of results that came later.
pub(super) const RESULTS: [ResultFormat; 8] = [
    ResultFormat::Off,
    ResultFormat::Ply,
    ResultFormat::Vtk,
    ResultFormat::Vtu,
    ResultFormat::Msh,
    ResultFormat::Stl,
    ResultFormat::Geojson,
    ResultFormat::Wkt,
];

/// So many coordinates are read as numbers of each kind.
const NUMBERS: usize = 4;

/// A coordinate of files that can be compared by all its bits.
pub(super) trait Exact: Coordinate + std::fmt::Debug {
    /// What was read, in this type.
    fn graph(input: Input) -> Graph<Self>;
    fn is_same(&self, other: &Self) -> bool;
}

impl Exact for f64 {
    fn graph(input: Input) -> Graph<f64> {
        match input {
            Input::Doubles(graph) => graph,
            Input::Rationals(_) => panic!("doubles are read as fractions"),
        }
    }

    fn is_same(&self, other: &f64) -> bool {
        self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
    }
}

/// A file whose fractions are all doubles may hold none.
impl Exact for BigRational {
    fn graph(input: Input) -> Graph<BigRational> {
        match input {
            Input::Rationals(graph) => graph,
            Input::Doubles(graph) => Graph {
                points: graph
                    .points
                    .iter()
                    .map(|p| {
                        p.map(|x| BigRational::from_float(x).expect("only fractions were written"))
                    })
                    .collect(),
                columns: graph.columns,
                edges: graph.edges,
                first_vertex: graph.first_vertex,
                first_edge: graph.first_edge,
                ..Graph::default()
            },
        }
    }

    fn is_same(&self, other: &BigRational) -> bool {
        self == other
    }
}

/// Writes a graph that was read, and its triangulation if it has one, and reads all of that.
pub(super) fn write<S: Exact>(graph: &Graph<S>) {
    let coordinates = graph.points.as_flattened().iter();
    coordinates.take(NUMBERS).for_each(|x| number(&x.text()));
    let mut node = Vec::new();
    write_node(graph, &mut node).expect("memory takes all that is written");
    let vertices = Graph {
        edges: Vec::new(),
        ..graph.clone()
    };
    assert_reads(InputFormat::Node, &node, None, &vertices);
    let length = |x: &S| x.text().len();
    let is_short = graph
        .points
        .iter()
        .flatten()
        .all(|x| length(x) <= CHARACTERS);
    if graph.points.len() <= POINTS && graph.edges.len() <= POINTS && is_short {
        match triangulate(&graph.points, &graph.edges) {
            Ok(result) => write_result(graph, &result, &node),
            Err(error) => assert!(!graph.as_numbered(error).to_string().is_empty()),
        }
    }
}

/// Panics unless the file reads as the graph. What has no vertices, or edges, has no first one.
pub(super) fn assert_reads<S: Exact>(
    format: InputFormat,
    file: &[u8],
    node: Option<&[u8]>,
    graph: &Graph<S>,
) {
    let input = read(format, &source(file), node.map(source).as_ref());
    let again = S::graph(input.unwrap_or_else(|error| panic!("{format:?}: {error}")));
    let is_same = again.points.len() == graph.points.len()
        && again
            .points
            .as_flattened()
            .iter()
            .zip(graph.points.as_flattened())
            .all(|(x, y)| x.is_same(y));
    assert!(is_same, "{format:?}: {again:?} for {graph:?}");
    assert_eq!(again.edges, graph.edges, "{format:?}");
    if format != InputFormat::Node {
        assert_eq!(heights(&again), heights(graph), "{format:?}");
    } else if !graph.points.is_empty() {
        // The first column is read as heights, whatever it was. Without vertices there are no lines for columns.
        let values = |graph: &Graph<S>| -> Vec<Vec<f64>> {
            graph
                .columns
                .iter()
                .map(|column| column.values.clone())
                .collect()
        };
        assert_eq!(values(&again), values(graph));
    }
    let counts = |graph: &Graph<S>| {
        [
            (graph.points.len(), graph.first_vertex),
            (graph.edges.len(), graph.first_edge),
        ]
        .map(|(count, first)| if count == 0 { 0 } else { first })
    };
    if format != InputFormat::Json {
        assert_eq!(counts(&again), counts(graph), "{format:?}");
    }
}

/// The height of each vertex, 0 where there is none.
pub(super) fn heights<S>(graph: &Graph<S>) -> Vec<f64> {
    let mut columns = graph.columns.iter();
    let column = columns.find(|column| column.name == Column::HEIGHT);
    let mut heights = column.map_or_else(Vec::new, |column| column.values.clone());
    heights.resize(graph.points.len(), 0.0);
    heights
}

/// Each format of results, and the file of it with the triangulation; the vertices of an `ele` follow
/// after a zero byte.
pub(super) fn files<S: Coordinate>(
    graph: &Graph<S>,
    result: &Triangulation,
    node: &[u8],
) -> [(ResultFormat, Vec<u8>); 3] {
    let text = |format| {
        let mut text = Vec::new();
        sweep_cdt_formats::write(format, graph, result, &mut text)
            .expect("memory takes all that is written");
        text
    };
    let ele = [&text(OutputFormat::Ele), node].join(&0);
    [
        (ResultFormat::Ele, ele),
        (ResultFormat::Json, text(OutputFormat::Json)),
        (ResultFormat::Obj, text(OutputFormat::Obj)),
    ]
}

/// A result in one of the formats that came later.
pub(super) fn result_text<S: Coordinate>(
    format: ResultFormat,
    graph: &Graph<S>,
    result: &Triangulation,
) -> Vec<u8> {
    let format: OutputFormat = <&str>::from(format).parse().expect("the same name");
    let mut text = Vec::new();
    sweep_cdt_formats::write(format, graph, result, &mut text)
        .expect("memory takes all that is written");
    text
}

/// A graph in one of the formats that came later.
pub(super) fn graph_text<S: Coordinate>(format: InputFormat, graph: &Graph<S>) -> Vec<u8> {
    let mut text = Vec::new();
    write_graph(format, graph, &mut text).expect("memory takes all that is written");
    text
}

/// The triangles of a result that must be readable.
fn triangles<S: Exact>(
    format: ResultFormat,
    file: &[u8],
    node: Option<&Source>,
    graph: &Graph<S>,
) -> Vec<[usize; 3]> {
    let triangles = read_result(format, &source(file), node, graph);
    triangles
        .unwrap_or_else(|error| panic!("{format:?}: {error}"))
        .list
}

fn write_result<S: Exact>(graph: &Graph<S>, result: &Triangulation, node: &[u8]) {
    let [(_, ele), (_, json), (_, obj)] = &files(graph, result, node);
    assert_reads(InputFormat::Json, json, None, graph);
    let reads = |format, file: &[u8], node: Option<&Source>| {
        let list = triangles(format, file, node, graph);
        assert_eq!(list, result.canonical_triangles(), "{format:?}");
    };
    let ele = &ele[..ele.len() - node.len() - 1];
    reads(ResultFormat::Ele, ele, None);
    reads(ResultFormat::Ele, ele, Some(&source(node)));
    reads(ResultFormat::Json, json, None);
    // Fractions are rounded in the others.
    if S::APPROX_IS_EXACT {
        reads(ResultFormat::Obj, obj, None);
        for format in RESULTS {
            reads(format, &result_text(format, graph, result), None);
        }
        for format in INPUTS {
            let has_vertices = !matches!(format, InputFormat::Geojson | InputFormat::Wkt);
            if has_vertices || result.duplicates().len() == 0 {
                let counted = Graph {
                    first_vertex: first_of(format),
                    first_edge: first_of(format),
                    ..graph.clone()
                };
                assert_reads(format, &graph_text(format, graph), None, &counted);
            }
        }
    }
    assert_matches(graph, result);
    let mut picture = Vec::new();
    sweep_cdt_draw::Output::Svg
        .write(graph, result, &mut picture)
        .expect("memory takes all that is written");
    assert_picture(picture);
}

/// Where a format of meshes begins to count.
fn first_of(format: InputFormat) -> usize {
    usize::from(matches!(format, InputFormat::Obj | InputFormat::Msh))
}

/// Panics unless a result whose vertices stand in another order is read as the same.
fn assert_matches<S: Exact>(graph: &Graph<S>, result: &Triangulation) {
    let last = graph.points.len().wrapping_sub(1);
    let reversed = Graph {
        points: graph.points.iter().rev().cloned().collect(),
        edges: graph
            .edges
            .iter()
            .map(|edge| edge.map(|v| last - v))
            .collect(),
        ..graph.clone()
    };
    let mut node = Vec::new();
    write_node(&reversed, &mut node).expect("memory takes all that is written");
    let again = triangulate(&reversed.points, &reversed.edges).expect("the order does not matter");
    let [(_, ele), _, (_, obj)] = &files(&reversed, &again, &node);
    let ele = &ele[..ele.len() - node.len() - 1];
    let reads = |format, file: &[u8], node: Option<&Source>| {
        let list = canonical(result, &triangles(format, file, node, graph));
        assert_eq!(list, result.canonical_triangles(), "{format:?}, reversed");
    };
    reads(ResultFormat::Ele, ele, Some(&source(&node)));
    if S::APPROX_IS_EXACT {
        reads(ResultFormat::Obj, obj, None);
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
    Source {
        name: "file".to_owned(),
        bytes: bytes.to_vec(),
    }
}
