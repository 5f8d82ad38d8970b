//! Readers given bytes, and files with a generated input and its triangulation, whole and damaged.

use std::fmt::Write;
use std::ops::Range;

use sweep_cdt::triangulate;
use sweep_cdt_formats::{Format, GraphFile, write_node};

use super::again::{self, INPUTS, RESULTS};

/// One of the readers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Reader {
    Input(Format),
    Result(Format),
    Trace,
    Numbers,
}

/// All of them.
pub(super) const READERS: [Reader; 8] = [
    Reader::Input(Format::Node),
    Reader::Input(Format::Poly),
    Reader::Input(Format::Json),
    Reader::Result(Format::Ele),
    Reader::Result(Format::Json),
    Reader::Result(Format::Obj),
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
            Reader::Input(format) | Reader::Result(format) => format.name(),
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

/// The file in several formats, each read back; and one of these files, with what reads it, and the vertices of a file
/// that has none after a zero byte.
pub(super) fn written<S: again::Exact>(
    file: &GraphFile<S>,
    which: usize,
    share: usize,
) -> (Reader, Vec<u8>) {
    again::write(file, share);
    let mut node = Vec::new();
    write_node(file, &mut node).expect("memory takes all that is written");
    let edges = edges(file);
    let whole = [node.as_slice(), b"# edges\n", edges.as_bytes()].concat();
    let split = [b"0 2 0 0\n", edges.as_bytes()].concat();
    if !file.graph.points.is_empty() {
        again::assert_reads(Format::Poly, &whole, None, file);
    }
    again::assert_reads(Format::Poly, &split, Some(&node), file);
    let Some(result) = triangulate(&file.graph.points, &file.graph.edges).ok() else {
        return early(which % EARLY, whole, &split, node);
    };
    // The others are not written, which takes longer than all that is read.
    let later = EARLY + 4;
    match which % (later + RESULTS.len() + INPUTS.len()) {
        which @ 0..EARLY => early(which, whole, &split, node),
        which if which < later => {
            let results = again::files(file, &result, &node);
            match which - EARLY {
                0 => (Reader::Input(Format::Json), results[1].1.clone()),
                which => {
                    let (format, bytes) = results[which - 1].clone();
                    (Reader::Result(format), bytes)
                }
            }
        }
        which => match RESULTS.get(which - later) {
            Some(&format) => (
                Reader::Result(format),
                again::result_text(format, file, &result),
            ),
            None => {
                let format = INPUTS[which - later - RESULTS.len()];
                (Reader::Input(format), again::graph_text(format, file))
            }
        },
    }
}

/// How many files [`early`] chooses from.
const EARLY: usize = 3;

/// One of the files of points and edges alone.
fn early(which: usize, whole: Vec<u8>, split: &[u8], node: Vec<u8>) -> (Reader, Vec<u8>) {
    match which {
        0 => (Reader::Input(Format::Poly), whole),
        1 => (Reader::Input(Format::Poly), [split, &node].join(&0)),
        _ => (Reader::Input(Format::Node), node),
    }
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
