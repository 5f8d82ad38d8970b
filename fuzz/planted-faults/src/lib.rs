//! Faults planted on purpose, to see which fuzz target finds which, and how soon.
//!
//! The tables in `faults`, one for each kind, name each fault, the right text of the source and the wrong
//! one. All of them are planted at once into a *copy* of the crate, as `if has(7) { wrong } else { right }`.
//! An environment variable chooses the one that a process has, so that one build serves all. The crate
//! itself knows nothing of this.
//!
//! A right text is an expression, or statements without a `let`, that occurs once in its file outside of
//! constants.

mod copy;
mod page;

use std::path::{Path, PathBuf};

use serde::Deserialize;

pub use copy::copy;
pub use page::{Find, Row, page, table};

/// Names the chosen fault in the environment, by its place in the list of all.
pub const CHOICE: &str = "SWEEP_CDT_FAULT";

const TABLES: [&str; 13] = [
    include_str!("../faults/order.toml"),
    include_str!("../faults/signs.toml"),
    include_str!("../faults/point.toml"),
    include_str!("../faults/fill.toml"),
    include_str!("../faults/divide.toml"),
    include_str!("../faults/bands.toml"),
    include_str!("../faults/edge.toml"),
    include_str!("../faults/mesh.toml"),
    include_str!("../faults/front.toml"),
    include_str!("../faults/scalar.toml"),
    include_str!("../faults/trace.toml"),
    include_str!("../faults/verify.toml"),
    include_str!("../faults/formats.toml"),
];

#[derive(Deserialize)]
struct Table {
    kind: String,
    fault: Vec<Fault>,
}

/// One row of a table.
#[derive(Clone, Debug, Deserialize)]
pub struct Fault {
    /// What its table is about.
    #[serde(skip)]
    pub kind: String,
    /// A short name.
    pub name: String,
    /// The file under `src`.
    pub file: PathBuf,
    /// What is wrong with it.
    pub what: String,
    /// The right text.
    pub right: String,
    /// What stands there instead.
    pub wrong: String,
}

/// All faults, those of one kind after the other.
///
/// # Panics
/// If a table cannot be read.
pub fn faults() -> Vec<Fault> {
    let mut faults = Vec::new();
    for text in TABLES {
        let Table { kind, fault } = toml::from_str(text).expect("a table of faults");
        let of_kind = |fault| Fault {
            kind: kind.clone(),
            ..fault
        };
        faults.extend(fault.into_iter().map(of_kind));
    }
    faults
}

/// The folder of the crate.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).expect("it lies in fuzz")
}

/// A source file with all of its faults planted.
///
/// # Errors
/// Says which right text does not occur exactly once.
pub fn plant(file: &Path, source: &str, faults: &[Fault]) -> Result<String, String> {
    let mut places = Vec::new();
    for (number, fault) in faults.iter().enumerate() {
        if fault.file != file {
            continue;
        }
        let found: Vec<usize> = source.match_indices(&fault.right).map(|m| m.0).collect();
        let [place] = found[..] else {
            let (name, times) = (&fault.name, found.len());
            return Err(format!("{name}: its text occurs {times} times, not once"));
        };
        places.push((place, place + fault.right.len(), number));
    }
    places.sort_unstable();
    if let Some(pair) = places.windows(2).find(|pair| pair[0].1 > pair[1].0) {
        let [a, b] = [pair[0].2, pair[1].2].map(|number| &faults[number].name);
        return Err(format!("{a} and {b} overlap"));
    }
    let mut planted = source.to_owned();
    for &(from, to, number) in places.iter().rev() {
        let Fault { right, wrong, .. } = &faults[number];
        let choice = format!("if crate::planted::has({number}) {{ {wrong} }} else {{ {right} }}");
        let is_statement = right.ends_with([';', '}']);
        let text = if is_statement {
            choice
        } else {
            format!("({choice})")
        };
        planted.replace_range(from..to, &text);
    }
    Ok(planted)
}
