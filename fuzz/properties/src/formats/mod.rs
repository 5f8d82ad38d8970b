//! No bytes make a reader panic, and what is read and written again reads the same.
//!
//! The first byte picks what the others are: a file of one of the formats as it stands, numbers, a trace,
//! or an input that is written in some formats, read back bit for bit, and read once more after some
//! damage; or a file that another program might have written. The judge is equality alone: of coordinates by their
//! bits, of edges and triangles by index.

mod again;
mod files;
mod foreign;

use std::panic::catch_unwind;

use arbitrary::{Result, Unstructured};
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Verifier;
use sweep_cdt::{Heuristics, Pslg};
use sweep_cdt_draw::ViolationsPicture;
use sweep_cdt_formats::{
    Column, Coordinate, Format, GraphFile, Input, Numbering, Source, read, read_result,
};
use sweep_cdt_trace::Trace;
use sweep_cdt_trace::{read_trace, write_trace};

use self::again::source;
use self::files::{READERS, Reader};
use crate::file::{File, json};
use crate::{reached, share};
use sweep_cdt_testing::{Steps, generators};

/// The first byte, but for half of its bits, of a file of which the second byte says who reads it.
const OTHERS: u8 = 12;
/// The first byte of a file in a form that the crate does not write.
const FOREIGN: u8 = 11;

/// A fuzzer makes files of at most so many bytes.
pub const BYTES: usize = 512;

/// The case that the bytes stand for.
enum Case {
    Nothing,
    /// A file, and who reads it.
    File(Reader, Vec<u8>),
    /// A file in a form that the crate does not write.
    Foreign(Vec<u8>),
    /// An input that is traced.
    Traced(Pslg<f64>),
    /// An input that is written in several formats, with these numbers; one file is damaged.
    Written(Box<GraphFile<f64>>, Numbers, u8, [[u8; 4]; 3]),
}

/// The coordinates of an input that is written.
#[derive(Clone, Copy)]
enum Numbers {
    Doubles,
    /// Every other one divided by this.
    Fractions(&'static str),
}

/// The property for the bytes.
pub fn test(bytes: &[u8]) {
    let share = share::of(bytes) as usize;
    match Case::of(bytes) {
        Case::Nothing => {}
        Case::File(reader, file) => try_reader(reader, &file, share),
        Case::Traced(graph) => {
            sample(&graph);
            run_traced(&graph);
        }
        Case::Written(file, numbers, which, damage) => {
            sample(&file.graph);
            let (reader, bytes) = written(&file, numbers, which, damage, share);
            try_reader(reader, &bytes, share);
        }
        // Reading is total but for a type that has no values.
        Case::Foreign(bytes) => foreign::judge(&mut Unstructured::new(&bytes)).unwrap_or_default(),
    }
}

/// The file, with the extension of its format, and the `.node` beside it; the input that is traced or written, and the
/// file that is damaged, if it comes to that.
pub fn files(bytes: &[u8]) -> Vec<File> {
    let share = share::of(bytes) as usize;
    let input = |name: &str, graph: &Pslg<f64>| {
        let json = json(&graph.points, &graph.edges);
        (name.to_owned(), json.into_bytes())
    };
    match Case::of(bytes) {
        Case::Nothing => Vec::new(),
        Case::File(reader, file) => parts(reader, &file),
        // What goes wrong there is told with the file.
        Case::Foreign(_) => Vec::new(),
        Case::Traced(graph) => vec![input("traced.json", &graph)],
        Case::Written(file, numbers, which, damage) => {
            let mut files = vec![input("written.json", &file.graph)];
            let damaged = catch_unwind(|| written(&file, numbers, which, damage, share));
            files
                .extend(damaged.map_or_else(|_| Vec::new(), |(reader, file)| parts(reader, &file)));
            files
        }
    }
}

fn parts(reader: Reader, file: &[u8]) -> Vec<File> {
    let parts = file.splitn(reader.parts(), |&byte| byte == 0);
    let names = [
        format!("file.{}", reader.extension()),
        "beside.node".to_owned(),
    ];
    names.into_iter().zip(parts.map(<[u8]>::to_vec)).collect()
}

impl Case {
    fn of(bytes: &[u8]) -> Case {
        let Some((&first, rest)) = bytes.split_first() else {
            return Case::Nothing;
        };
        match (READERS.get(usize::from(first & 15)), rest.split_first()) {
            (Some(&reader), _) => Case::File(reader, rest.to_vec()),
            (None, Some((&which, rest))) if first & 15 == OTHERS => {
                let others = files::others();
                let reader = others[usize::from(which) % others.len()];
                Case::File(reader, rest.to_vec())
            }
            _ if first & 15 == FOREIGN => Case::Foreign(rest.to_vec()),
            // Reading is total but for a type that has no values.
            _ => generated(first >> 4, &mut Unstructured::new(rest)).unwrap_or(Case::Nothing),
        }
    }
}

/// A generated input: it is traced, or written in several formats, read back, and once more with some damage.
fn generated(style: u8, bytes: &mut Unstructured<'_>) -> Result<Case> {
    let which: u8 = bytes.arbitrary()?;
    let damage: [[u8; 4]; 3] = bytes.arbitrary()?;
    let input = generators::read(bytes)?;
    let has_heights = which & 64 != 0 && !input.points.is_empty();
    let heights = Column {
        name: Column::HEIGHT.to_owned(),
        values: (0..input.points.len()).map(height).collect(),
    };
    let graph = Pslg {
        points: input.points,
        edges: input.edges,
        ..Pslg::default()
    };
    if which >= 192 {
        return Ok(Case::Traced(graph));
    }
    let numbers = match style >> 2 {
        0 => Numbers::Doubles,
        1 => Numbers::Fractions("3"),
        2 => Numbers::Fractions("1000000007"),
        // Whole numbers that are no doubles.
        _ => Numbers::Fractions("1/9007199254740993"),
    };
    // Markers of some vertices and edges.
    let has_markers = which & 32 != 0 && graph.points.len() > 1 && !graph.edges.is_empty();
    let markers = Column {
        name: Column::MARKER.to_owned(),
        values: (0..graph.points.len())
            .map(|v| (v % 3) as f64 * -5.0)
            .collect(),
    };
    let columns = [(has_heights, heights), (has_markers, markers)];
    let edges = 0..graph.edges.len();
    let file = GraphFile {
        edge_markers: edges
            .filter(|_| has_markers)
            .map(|e| 9 - (e % 2) as i64)
            .collect(),
        columns: columns
            .into_iter()
            .filter_map(|(is_there, column)| is_there.then_some(column))
            .collect(),
        numbering: Numbering {
            vertex: usize::from(style & 1),
            edge: usize::from(style >> 1 & 1),
            ..Numbering::default()
        },
        ..graph.into()
    };
    Ok(Case::Written(Box::new(file), numbers, which, damage))
}

/// Writes the input in several formats and reads it back; one of the files, damaged, and who reads it.
fn written(
    file: &GraphFile<f64>,
    numbers: Numbers,
    which: u8,
    damage: [[u8; 4]; 3],
    share: usize,
) -> (Reader, Vec<u8>) {
    let which = usize::from(which);
    let (reader, text) = match numbers {
        Numbers::Doubles => files::written(file, which, share),
        Numbers::Fractions(divisor) => files::written(&with_fractions(file, divisor), which, share),
    };
    (reader, files::damaged(&text, &damage))
}

fn sample(Pslg { points, edges, .. }: &Pslg<f64>) {
    reached::sample(&sweep_cdt_testing::Input {
        points: points.clone(),
        edges: edges.clone(),
    });
}

/// The height of a vertex, which some have not.
fn height(v: usize) -> f64 {
    [812.5, 0.0, -1e-7, 3e300, f64::NAN][v % 5]
}

/// A file with every other vertex divided by a number.
fn with_fractions(file: &GraphFile<f64>, divisor: &str) -> GraphFile<BigRational> {
    let divided = |(v, point): (usize, &[f64; 2])| {
        let divisor = if v % 2 == 0 { divisor } else { "1" };
        point.map(|x| {
            let divisor = BigRational::from_text(divisor).expect("a number");
            BigRational::from_float(x).expect("generated points are finite") / divisor
        })
    };
    let graph = Pslg {
        points: file.graph.points.iter().enumerate().map(divided).collect(),
        edges: file.graph.edges.clone(),
        ..Pslg::default()
    };
    GraphFile {
        columns: file.columns.clone(),
        numbering: file.numbering,
        ..graph.into()
    }
}

/// Reads bytes, a zero byte of which ends the file and begins the `.node` beside it, if it is a text.
fn try_reader(reader: Reader, bytes: &[u8], share: usize) {
    let mut files = bytes.splitn(reader.parts(), |&byte| byte == 0).map(source);
    let main = files.next().expect("there is a first part");
    let node = files.next();
    match reader {
        Reader::Input(format) => match read(format, &main, node.as_ref()) {
            Ok(Input::Doubles(file)) => again::write(&file, share),
            Ok(Input::Rationals(file)) => again::write(&file, share),
            Err(error) => assert!(!error.to_string().is_empty()),
        },
        Reader::Result(format) => {
            let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 0.5]];
            let graph = Pslg {
                points: corners.to_vec(),
                edges: vec![[0, 2]],
                ..Pslg::default()
            };
            let input = GraphFile {
                numbering: Numbering::FROM_ONE,
                ..graph.into()
            };
            try_result(format, &main, node.as_ref(), &input);
            try_result(format, &main, node.as_ref(), &with_fractions(&input, "3"));
        }
        Reader::Trace => try_trace(&String::from_utf8_lossy(bytes)),
        Reader::Numbers => {
            let text = String::from_utf8_lossy(bytes);
            text.split_whitespace().take(4).for_each(again::number);
        }
    }
}

/// Reads a result, verifies it, and writes and draws what is wrong with it.
fn try_result<S: Coordinate + Scalar>(
    format: Format,
    source: &Source,
    node: Option<&Source>,
    input: &GraphFile<S>,
) {
    let Ok(triangles) = read_result(format, source, node, input) else {
        return;
    };
    let graph = &input.graph;
    let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
    let Err(violations) = verdict else { return };
    for &violation in &violations.list {
        let numbered = triangles.as_numbered(input, violation);
        assert!(!numbered.to_string().is_empty());
        let vertices = triangles.vertices_of(graph, violation);
        assert!(vertices.iter().all(|&v| v < graph.points.len()));
    }
    let mut picture = Vec::new();
    ViolationsPicture::new(input, &triangles, &violations.list)
        .found(violations.found)
        .write(&mut picture)
        .expect("memory takes all that is written");
    again::assert_picture(picture);
}

/// Reads any text, replays it if it is a trace, and reads it again as it is written.
fn try_trace(text: &str) {
    match read_trace(text) {
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
fn run_traced(graph: &Pslg<f64>) {
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
        .and_then(|()| write_trace(trace, &mut lines))
        .expect("memory takes all that is written");
    for file in [text, lines] {
        let file = String::from_utf8(file).expect("traces are text");
        assert_eq!(read_trace(&file).as_ref(), Ok(trace));
    }
}
