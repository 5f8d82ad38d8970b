//! The programs, and what each is asked.
//!
//! A program is a command that is called with the file of a data set, the number of times to triangulate it and, if the
//! answer is wanted, the file to write it to. It prints a line for each input each time: nanoseconds, and bytes if it
//! has measured them. Crates run in a process of this executable.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use sweep_cdt_testing::{Input, binary};

use crate::cgal;
use crate::crates::{self, Answer, Stopwatch};
use crate::data::Kind;

/// A program.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    /// The program's version, or the number of the crate in Cargo.lock.
    pub(crate) version: String,
    /// How it is called.
    pub(crate) command: Vec<String>,
    /// The kinds of data that it takes.
    pub(crate) kinds: &'static [Kind],
    /// Whether its answer to a polygon covers the polygon, and not the hull.
    pub(crate) is_inside: bool,
    /// Whether it decides by exact predicates, on doubles or integers.
    pub(crate) is_exact: bool,
}

/// Triangulates an input, or says why not.
pub(crate) type Call = fn(&Input, &mut Stopwatch) -> Answer;

/// A crate behind one signature.
pub(crate) struct Crate {
    name: &'static str,
    pub(crate) package: &'static str,
    kinds: &'static [Kind],
    pub(crate) is_inside: bool,
    is_exact: bool,
    pub(crate) call: Call,
}

impl Crate {
    /// The crate of this name; ends the process where there is none.
    pub(crate) fn named(name: &str) -> &'static Crate {
        CRATES
            .iter()
            .find(|entry| entry.name == name)
            .unwrap_or_else(|| {
                let names = CRATES.map(|entry| entry.name).join(", ");
                eprintln!("no crate is called {name}; there are {names}");
                std::process::exit(2)
            })
    }
}

const ALL: &[Kind] = &[Kind::Points, Kind::Edges, Kind::Polygons];
const POINTS: &[Kind] = &[Kind::Points];
const POLYGONS: &[Kind] = &[Kind::Polygons];
/// Only tests/programs asks for these.
const UNTIMED: &[Kind] = &[];

/// The name of the first program: this crate.
pub(crate) const OURS: &str = "sweep-cdt";
/// Our library in memory that is kept from one call to the next.
pub(crate) const OURS_KEPT: &str = "sweep-cdt kept";

/// Our library in memory that is kept, asked for the inside of a polygon alone.
pub(crate) const OURS_INSIDE: &str = "sweep-cdt inside";

#[rustfmt::skip]
const CRATES: [Crate; 16] = [
    Crate { name: OURS, package: "sweep-cdt", kinds: ALL, is_inside: false, is_exact: true, call: crates::ours },
    Crate { name: OURS_KEPT, package: "sweep-cdt", kinds: ALL, is_inside: false, is_exact: true, call: crates::ours_kept },
    Crate { name: OURS_INSIDE, package: "sweep-cdt", kinds: POLYGONS, is_inside: true, is_exact: true, call: crates::ours_inside },
    Crate { name: "spade", package: "spade", kinds: ALL, is_inside: false, is_exact: true, call: crates::spade },
    Crate { name: "delaunator", package: "delaunator", kinds: POINTS, is_inside: false, is_exact: false, call: crates::delaunator },
    Crate { name: "cdt", package: "cdt", kinds: POINTS, is_inside: false, is_exact: true, call: crates::cdt },
    Crate { name: "ghx", package: "ghx_constrained_delaunay", kinds: POINTS, is_inside: false, is_exact: false, call: crates::ghx },
    Crate { name: "cdt inside", package: "cdt", kinds: POLYGONS, is_inside: true, is_exact: true, call: crates::cdt_inside },
    Crate { name: "ghx inside", package: "ghx_constrained_delaunay", kinds: POLYGONS, is_inside: true, is_exact: false, call: crates::ghx_inside },
    Crate { name: "i_triangle", package: "i_triangle", kinds: POLYGONS, is_inside: true, is_exact: true, call: crates::i_triangle },
    Crate { name: "earcut", package: "earcut", kinds: POLYGONS, is_inside: true, is_exact: false, call: crates::earcut },
    Crate { name: "earcut refined", package: "earcut", kinds: POLYGONS, is_inside: true, is_exact: false, call: crates::earcut_refined },
    Crate { name: "poly2tri-rs", package: "poly2tri-rs", kinds: POLYGONS, is_inside: true, is_exact: false, call: crates::poly2tri },
    Crate { name: "i_triangle grid", package: "i_triangle", kinds: UNTIMED, is_inside: true, is_exact: false, call: crates::i_triangle_grid },
    Crate { name: "geo", package: "geo", kinds: UNTIMED, is_inside: true, is_exact: true, call: crates::geo },
    Crate { name: "earcutr", package: "earcutr", kinds: UNTIMED, is_inside: true, is_exact: false, call: crates::earcutr },
];

/// All programs that are timed and can run here; this crate is the first. `folder` takes what is compiled.
pub(crate) fn all(folder: &Path, python: &Path) -> Vec<Program> {
    let this = std::env::current_exe().expect("this program");
    let timed = CRATES.iter().filter(|entry| !entry.kinds.is_empty());
    let crates = timed.map(|entry| Program {
        name: entry.name,
        version: locked_version(entry.package),
        command: [this.to_string_lossy().as_ref(), "cell", entry.name]
            .map(str::to_owned)
            .to_vec(),
        kinds: entry.kinds,
        is_inside: entry.is_inside,
        is_exact: entry.is_exact,
    });
    let external = [cgal(folder), triangle(python)];
    crates.chain(external.into_iter().flatten()).collect()
}

/// The version of a package in Cargo.lock.
pub(crate) fn locked_version(package: &str) -> String {
    let name = format!("name = \"{package}\"");
    let mut lines = include_str!("../Cargo.lock").lines();
    lines.find(|&line| line == name).expect("a dependency");
    let version = lines.next().and_then(|line| line.split('"').nth(1));
    version.expect("a version").to_owned()
}

/// Runs a crate on a data set, so many times: what a process does. The answer is the last one.
pub(crate) fn run(name: &str, input: &Path, calls: usize, answer: Option<&Path>) {
    let call = Crate::named(name).call;
    let inputs = binary::read_inputs(input).expect("a data set");
    let mut stopwatch = Stopwatch::default();
    let (mut lines, mut triangles) = (String::new(), Vec::new());
    for left in (0..calls).rev() {
        for input in &inputs {
            let result = call(input, &mut stopwatch).expect("an input that the program takes");
            let memory = stopwatch.memory.take();
            let memory = memory.map_or(String::new(), |bytes| bytes.to_string());
            lines.push_str(&format!("{} {memory}\n", stopwatch.time.as_nanos()));
            if answer.is_some() && left == 0 {
                triangles.push(result);
            }
        }
    }
    if let Some(answer) = answer {
        binary::write_answer(answer, &triangles).expect("a file for the answer");
    }
    print!("{lines}");
}

/// CGAL, if it can be compiled here.
fn cgal(folder: &Path) -> Option<Program> {
    let program = cgal::compile(folder)?.to_string_lossy().into_owned();
    Some(Program {
        name: "CGAL",
        version: output([program.as_str()].into_iter())?,
        command: vec![program],
        kinds: ALL,
        is_inside: false,
        is_exact: true,
    })
}

/// Triangle, if this Python imports it.
fn triangle(python: &Path) -> Option<Program> {
    let python = python.to_string_lossy().into_owned();
    let script = source("with_triangle.py").to_string_lossy().into_owned();
    Some(Program {
        name: "Triangle",
        version: output([python.as_str(), script.as_str()].into_iter())?,
        command: vec![python, script],
        kinds: ALL,
        is_inside: false,
        is_exact: true,
    })
}

/// The output of a command, if it succeeds.
fn output<'a>(mut words: impl Iterator<Item = &'a str> + 'a) -> Option<String> {
    let output = Command::new(words.next()?).args(words).output();
    let Output { status, stdout, .. } = output.ok()?;
    let text = String::from_utf8_lossy(&stdout).trim().to_owned();
    status.success().then_some(text)
}

/// A file of this package.
fn source(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}
