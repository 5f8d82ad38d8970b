//! No bytes make a reader panic, and what is read and written again reads the same.
//!
//! The first byte picks what the others are: a file of one of the formats as it stands, numbers, a trace,
//! or an input that is written in every format, read back bit for bit, and read once more after some
//! damage; or a file that another program might have written. The judge is equality alone: of coordinates by their
//! bits, of edges and triangles by index.

mod again;
mod files;
mod foreign;

use arbitrary::{Result, Unstructured};
use num_rational::BigRational;
use sweep_cdt::Heuristics;
use sweep_cdt::draw::ViolationsPicture;
use sweep_cdt::formats::{
    Column, Coordinate, Graph, Input, ResultFormat, Source, read, read_result,
};
use sweep_cdt::trace::Trace;
use sweep_cdt::verify::Verifier;

use self::again::source;
use self::files::{READERS, Reader};
use crate::reached;
use sweep_cdt_testing::{Steps, generators};

/// The first byte, but for half of its bits, of a file of which the second byte says who reads it.
const OTHERS: u8 = 12;
/// The same of a file in a form that the crate does not write.
const FOREIGN: u8 = 11;

/// The property for the bytes.
pub fn test(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    match (READERS.get(usize::from(first & 15)), rest.split_first()) {
        (Some(&reader), _) => try_reader(reader, rest),
        (None, Some((&which, rest))) if first & 15 == OTHERS => {
            let others = files::others();
            try_reader(others[usize::from(which) % others.len()], rest);
        }
        // Reading is total but for a type that has no values.
        _ if first & 15 == FOREIGN => {
            foreign::judge(&mut Unstructured::new(rest)).unwrap_or_default();
        }
        _ => structured(first >> 4, &mut Unstructured::new(rest)).unwrap_or_default(),
    }
}

/// A generated input: its trace, or written in every format, read back, and once more with some damage.
fn structured(style: u8, bytes: &mut Unstructured<'_>) -> Result<()> {
    let which: u8 = bytes.arbitrary()?;
    let damage: [[u8; 4]; 3] = bytes.arbitrary()?;
    let input = generators::read(bytes)?;
    reached::sample(&input);
    let has_heights = which & 64 != 0 && !input.points.is_empty();
    let heights = Column {
        name: Column::HEIGHT.to_owned(),
        values: (0..input.points.len()).map(height).collect(),
    };
    let graph = Graph {
        points: input.points,
        columns: has_heights.then_some(heights).into_iter().collect(),
        edges: input.edges,
        first_vertex: usize::from(style & 1),
        first_edge: usize::from(style >> 1 & 1),
        ..Graph::default()
    };
    if which >= 192 {
        run_traced(&graph);
        return Ok(());
    }
    let files = match style >> 2 {
        0 => files::written(&graph),
        1 => files::written(&with_fractions(&graph, "3")),
        2 => files::written(&with_fractions(&graph, "1000000007")),
        // Whole numbers that are no doubles.
        _ => files::written(&with_fractions(&graph, "1/9007199254740993")),
    };
    let (reader, text) = &files[usize::from(which) % files.len()];
    try_reader(*reader, &files::damaged(text, &damage));
    Ok(())
}

/// The height of a vertex.
fn height(v: usize) -> f64 {
    [812.5, 0.0, -1e-7, 3e300][v % 4]
}

/// The same graph, every other vertex divided by a number.
fn with_fractions(graph: &Graph<f64>, divisor: &str) -> Graph<BigRational> {
    let divided = |(v, point): (usize, &[f64; 2])| {
        let divisor = if v % 2 == 0 { divisor } else { "1" };
        point.map(|x| {
            let divisor = BigRational::from_text(divisor).expect("a number");
            BigRational::from_float(x).expect("generated points are finite") / divisor
        })
    };
    Graph {
        points: graph.points.iter().enumerate().map(divided).collect(),
        columns: graph.columns.clone(),
        edges: graph.edges.clone(),
        first_vertex: graph.first_vertex,
        first_edge: graph.first_edge,
        ..Graph::default()
    }
}

/// Reads bytes, a zero byte of which ends the file and begins the `.node` beside it, if it is a text.
fn try_reader(reader: Reader, bytes: &[u8]) {
    let parts = if reader.may_be_binary() { 1 } else { 2 };
    let mut files = bytes.splitn(parts, |&byte| byte == 0).map(source);
    let main = files.next().expect("there is a first part");
    let node = files.next();
    match reader {
        Reader::Input(format) => match read(format, &main, node.as_ref()) {
            Ok(Input::Doubles(graph)) => again::write(&graph),
            Ok(Input::Rationals(graph)) => again::write(&graph),
            Err(error) => assert!(!error.to_string().is_empty()),
        },
        Reader::Result(format) => {
            let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 0.5]];
            let graph = Graph {
                points: corners.to_vec(),
                edges: vec![[0, 2]],
                first_vertex: 1,
                first_edge: 1,
                ..Graph::default()
            };
            try_result(format, &main, node.as_ref(), &graph);
            try_result(format, &main, node.as_ref(), &with_fractions(&graph, "3"));
        }
        Reader::Trace => try_trace(&String::from_utf8_lossy(bytes)),
        Reader::Numbers => {
            let text = String::from_utf8_lossy(bytes);
            text.split_whitespace().take(4).for_each(again::number);
        }
    }
}

/// Reads a result, verifies it, and writes and draws what is wrong with it.
fn try_result<S: Coordinate>(
    format: ResultFormat,
    source: &Source,
    node: Option<&Source>,
    graph: &Graph<S>,
) {
    let Ok(triangles) = read_result(format, source, node, graph) else {
        return;
    };
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let Err(violations) = verdict else { return };
    for &violation in &violations.list {
        let numbered = triangles.as_numbered(graph, violation);
        assert!(!numbered.to_string().is_empty());
        let vertices = triangles.vertices_of(graph, violation);
        assert!(vertices.iter().all(|&v| v < graph.points.len()));
    }
    let mut picture = Vec::new();
    ViolationsPicture::new(graph, &triangles, &violations.list)
        .found(violations.found)
        .write(&mut picture)
        .expect("memory takes all that is written");
    again::assert_picture(picture);
}

/// Reads any text, replays it if it is a trace, and reads it again as it is written.
fn try_trace(text: &str) {
    match Trace::parse(text) {
        Ok(trace) => {
            assert_trace_reads(&trace);
            if let Err(error) = trace.replay() {
                assert!(!error.to_string().is_empty());
            }
        }
        Err(error) => assert!(error.line > 0, "{error}"),
    }
}

/// The trace of a run reads as it was written, and its replay returns the result.
fn run_traced(graph: &Graph<f64>) {
    let steps = Steps::of(&graph.points, &graph.edges, Heuristics::default());
    let Steps { trace, result, .. } = steps;
    assert_trace_reads(&trace);
    if let Ok(result) = result {
        assert_eq!(trace.replay(), Ok(result.canonical_triangles()));
    }
}

fn assert_trace_reads(trace: &Trace) {
    let (mut text, mut lines) = (Vec::new(), Vec::new());
    trace
        .write_text(&mut text)
        .and_then(|()| trace.write_lines(&mut lines))
        .expect("memory takes all that is written");
    for file in [text, lines] {
        let file = String::from_utf8(file).expect("traces are text");
        assert_eq!(Trace::parse(&file).as_ref(), Ok(trace));
    }
}
