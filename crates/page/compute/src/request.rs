//! The requests of the page. All names are those that the command has.

use serde::Deserialize;

/// An input, how it is to be triangulated, and what of it is wanted.
#[derive(Deserialize)]
pub(crate) struct Request {
    pub(crate) input: Given,
    pub(crate) settings: Settings,
    pub(crate) wanted: Wanted,
}

/// Where the points and edges come from.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Given {
    /// A file, and the `.node` beside a `.poly`, if there is one: so many bytes each.
    File {
        name: String,
        format: String,
        bytes: usize,
        node: Option<(String, usize)>,
    },
    /// Generated data.
    Generated {
        kind: String,
        points: usize,
        seed: u64,
    },
}

impl Given {
    /// The name in messages.
    pub(crate) fn name(&self) -> String {
        match self {
            Given::File { name, .. } => name.clone(),
            Given::Generated { kind, points, seed } => format!("{kind} {points} --seed {seed}"),
        }
    }
}

/// How it is triangulated: the algorithm, the front, the heuristics and the rule for the inside by their names.
#[derive(Deserialize)]
pub(crate) struct Settings {
    pub(crate) method: String,
    pub(crate) front: String,
    pub(crate) heuristics: String,
    /// `default` for the rule that an input has by itself.
    pub(crate) inside: String,
    /// Whether edges are split where they cross.
    pub(crate) split: bool,
}

/// The contents of the answer.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Wanted {
    /// The part that the page draws and says.
    Picture,
    /// The file that `sweep-cdt triangulate -o` writes, in this format.
    Result(String),
    /// The points and edges as a file of this format.
    Graph(String),
    /// The file that `sweep-cdt trace -o` writes.
    Trace(Trace),
}

/// The formats of traces.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Trace {
    Txt,
    Jsonl,
    Html,
}
