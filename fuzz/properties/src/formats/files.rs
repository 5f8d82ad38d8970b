//! Readers given bytes, and files with a generated input and its triangulation, whole and damaged.

use std::fmt::Write;
use std::ops::Range;

use sweep_cdt::triangulate;
use sweep_cdt_formats::{GraphFile, InputFormat, Named, ResultFormat, write_node};

use super::again::{self, INPUTS, RESULTS};

/// One of the readers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Reader {
    Input(InputFormat),
    Result(ResultFormat),
    Trace,
    Numbers,
}

/// All of them.
pub(super) const READERS: [Reader; 8] = [
    Reader::Input(InputFormat::Node),
    Reader::Input(InputFormat::Poly),
    Reader::Input(InputFormat::Json),
    Reader::Result(ResultFormat::Ele),
    Reader::Result(ResultFormat::Json),
    Reader::Result(ResultFormat::Obj),
    Reader::Trace,
    Reader::Numbers,
];

/// The readers of formats that came later.
pub(super) fn others() -> Vec<Reader> {
    let inputs = INPUTS.map(Reader::Input).into_iter();
    inputs.chain(RESULTS.map(Reader::Result)).collect()
}

impl Reader {
    /// Into how many files a zero byte divides what it reads: files that may be no text are one.
    pub(super) fn parts(self) -> usize {
        let binary = ["ply", "vtk", "vtu", "vtp", "stl", "msh", "npy", "npz"];
        let may_be_binary = binary.contains(&self.extension());
        if may_be_binary { 1 } else { 2 }
    }

    /// The extension by which the command knows such a file.
    pub(super) fn extension(self) -> &'static str {
        match self {
            Reader::Input(format) => format.name(),
            Reader::Result(format) => format.name(),
            Reader::Trace | Reader::Numbers => "txt",
        }
    }
}

/// The text that damage puts in.
const TOKENS: [&str; 16] = [
    "",
    "\n",
    " ",
    "0",
    "1",
    "-1",
    "\"",
    "[",
    "]",
    ",",
    "/",
    "1/3",
    "1e999",
    "nan",
    "#",
    "18446744073709551615",
];

/// The file in every format, each read back; with what reads it, and the vertices of a file that has
/// none after a zero byte.
pub(super) fn written<S: again::Exact>(file: &GraphFile<S>) -> Vec<(Reader, Vec<u8>)> {
    again::write(file);
    let mut node = Vec::new();
    write_node(file, &mut node).expect("memory takes all that is written");
    let edges = edges(file);
    let whole = [node.as_slice(), b"# edges\n", edges.as_bytes()].concat();
    let split = [b"0 2 0 0\n", edges.as_bytes()].concat();
    if !file.graph.points.is_empty() {
        again::assert_reads(InputFormat::Poly, &whole, None, file);
    }
    again::assert_reads(InputFormat::Poly, &split, Some(&node), file);
    let mut files = vec![
        (Reader::Input(InputFormat::Poly), whole),
        (
            Reader::Input(InputFormat::Poly),
            [split.as_slice(), &node].join(&0),
        ),
        (Reader::Input(InputFormat::Node), node.clone()),
    ];
    if let Ok(result) = triangulate(&file.graph.points, &file.graph.edges) {
        let results = again::files(file, &result, &node);
        files.push((Reader::Input(InputFormat::Json), results[1].1.clone()));
        files.extend(results.map(|(format, bytes)| (Reader::Result(format), bytes)));
        files.extend(RESULTS.map(|format| {
            let text = again::result_text(format, file, &result);
            (Reader::Result(format), text)
        }));
        files.extend(INPUTS.map(|format| (Reader::Input(format), again::graph_text(format, file))));
    }
    files
}

/// The edges as they stand in a `.poly`, markers and holes after them.
fn edges<S>(file: &GraphFile<S>) -> String {
    let mut text = format!("{} 1\n\n", file.graph.edges.len());
    for (e, edge) in file.graph.edges.iter().enumerate() {
        let [a, b] = edge.map(|v| v + file.numbering.vertex);
        writeln!(text, "\t{} {a}  {b} 7\r", e + file.numbering.edge).expect("memory takes it");
    }
    text + "0\n"
}

/// The file with a few bytes replaced, removed or put in: where, how many, by what. The few are as many as
/// it says, or one of the words, or one of the first few words, which are the counts of lines.
pub(super) fn damaged(file: &[u8], damage: &[[u8; 4]]) -> Vec<u8> {
    let mut file = file.to_vec();
    for &[high, low, length, token] in damage {
        let place = usize::from(u16::from_be_bytes([high, low]));
        let range = match length >> 6 {
            0 | 1 => {
                let at = place % (file.len() + 1);
                at..(at + usize::from(length % 8)).min(file.len())
            }
            2 => word(&file, place),
            _ => word(&file, place % 4),
        };
        let token = match TOKENS.get(usize::from(token % 32)) {
            Some(token) => token.as_bytes(),
            None => &[token],
        };
        file.splice(range, token.iter().copied());
    }
    file
}

/// Where one of the words is.
fn word(file: &[u8], number: usize) -> Range<usize> {
    let is_end = |byte: &u8| byte.is_ascii_whitespace() || b",:[]{}".contains(byte);
    let words = file.split(is_end).filter(|word| !word.is_empty());
    let Some(word) = words.clone().nth(number % words.count().max(1)) else {
        return 0..0;
    };
    let from = word.as_ptr().addr() - file.as_ptr().addr();
    from..from + word.len()
}
