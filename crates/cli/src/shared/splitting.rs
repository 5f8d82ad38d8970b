//! Edges split at their crossings before they are triangulated.

use std::io::{self, Write};

use sweep_cdt::Error;
use sweep_cdt::crossings::Exact;
use sweep_cdt_formats::{Coordinate, GraphFile, Input, Splitting};

use super::failure::Failure;

/// Arguments that ask for it.
#[derive(clap::Args)]
pub(crate) struct SplitArgs {
    /// Make vertices of the points where edges cross
    ///
    /// The vertices of the input keep their numbers, the new ones follow. The edges of the output are the
    /// pieces, in order; the list `split` of a .json has the vertices along each edge of the input. A new vertex
    /// takes its height and other numbers from the first edge through it, in proportion. Rationals are split
    /// exactly. Of doubles, each crossing moves to the nearest doubles. That bends the edges; where they now
    /// cross again, they are split again. Each edge goes through all vertices that are within its rounding. A
    /// line says how far an edge moved at most, along x or y. The unit is the distance between neighbouring
    /// doubles at the largest coordinate of that edge.
    #[arg(long)]
    split_crossings: bool,
}

impl SplitArgs {
    /// Whether it is asked for.
    pub(crate) fn is_asked(&self) -> bool {
        self.split_crossings
    }

    /// The input called `name` with its edges split.
    pub(crate) fn apply(&self, name: &str, input: Input) -> Result<(Input, Splitting), Failure> {
        Ok(match input {
            Input::Doubles(file) => {
                let (file, splitting) = divided(name, &file)?;
                (Input::Doubles(file), splitting)
            }
            Input::Rationals(file) => {
                let (file, splitting) = divided(name, &file)?;
                (Input::Rationals(file), splitting)
            }
        })
    }

    /// The message with which edges that cross are refused.
    pub(crate) fn advice(error: &Error) -> &'static str {
        match error {
            Error::CrossingEdges { .. } => {
                " (`sweep-cdt crossings` lists all that do, --split-crossings makes vertices of them)"
            }
            _ => "",
        }
    }
}

fn divided<S: Coordinate + Exact>(
    name: &str,
    file: &GraphFile<S>,
) -> Result<(GraphFile<S>, Splitting), Failure> {
    file.split_crossings()
        .map_err(|error| Failure::Error(format!("{name}: {}", file.split_as_numbered(error))))
}

/// The graph that was triangulated in place of the input called `name`.
pub(crate) fn triangulated(splitting: &Splitting, name: &str) -> String {
    if splitting.rounds == 0 {
        name.to_owned()
    } else {
        format!("the split edges of {name}")
    }
}

/// Writes what the splitting came to: one line.
pub(crate) fn write_splitting(
    splitting: &Splitting,
    name: &str,
    out: &mut impl Write,
) -> io::Result<()> {
    let [edges, pieces] = splitting.edges;
    let (vertices, rounds) = (splitting.vertices, splitting.rounds);
    write!(out, "{name}: {edges} edges split into {pieces}, ")?;
    write!(out, "new vertices {vertices}, rounds {rounds}, ")?;
    let displacement = splitting.displacement.text();
    writeln!(
        out,
        "greatest displacement {displacement} units in the last place"
    )
}
