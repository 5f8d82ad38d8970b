//! The requests of the page. The names of formats and kinds are the names that the command has for them.

use serde::Deserialize;
use sweep_cdt::Algorithm;

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

/// How it is triangulated.
#[derive(Clone, Copy, Deserialize)]
pub(crate) struct Settings {
    pub(crate) method: Method,
    pub(crate) front: Front,
    pub(crate) heuristics: Preset,
    pub(crate) inside: Inside,
    /// Whether edges are split where they cross.
    pub(crate) split: bool,
}

/// The algorithm.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Method {
    Auto,
    Sweep,
    DivideAndConquer,
}

impl From<Method> for Algorithm {
    fn from(method: Method) -> Algorithm {
        match method {
            Method::Auto => Algorithm::Auto,
            Method::Sweep => Algorithm::Sweep,
            Method::DivideAndConquer => Algorithm::DivideAndConquer,
        }
    }
}

/// The search structure of the front.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Front {
    Hash,
    SkipList,
    Linear,
}

/// The heuristics.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Preset {
    Fast,
    Paper,
    Off,
}

/// Which triangles are inside.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Inside {
    /// Holes for an input with holes, otherwise hull, as the command has it.
    Default,
    Hull,
    EvenOdd,
    Nonzero,
    Holes,
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
