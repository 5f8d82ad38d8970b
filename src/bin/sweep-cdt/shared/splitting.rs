//! Edges split at their crossings before they are triangulated.

use std::io::{self, Write};

use sweep_cdt::Error;
use sweep_cdt::crossings::{Exact, Split, split};
use sweep_cdt::formats::{Column, Coordinate, Graph, Input};

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

/// What the splitting came to.
pub(crate) struct Splitting {
    vertices: usize,
    edges: [usize; 2],
    rounds: usize,
    displacement: f64,
}

impl SplitArgs {
    /// Whether it is asked for.
    pub(crate) fn is_asked(&self) -> bool {
        self.split_crossings
    }

    /// The input called `name` with its edges split.
    pub(crate) fn apply(&self, name: &str, input: Input) -> Result<(Input, Splitting), Failure> {
        Ok(match input {
            Input::Doubles(graph) => {
                let (graph, splitting) = divided(name, graph)?;
                (Input::Doubles(graph), splitting)
            }
            Input::Rationals(graph) => {
                let (graph, splitting) = divided(name, graph)?;
                (Input::Rationals(graph), splitting)
            }
        })
    }

    /// What edges that cross are refused with.
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
    graph: Graph<S>,
) -> Result<(Graph<S>, Splitting), Failure> {
    let split = split(&graph.points, &graph.edges)
        .map_err(|error| Failure::Error(format!("{name}: {}", graph.as_numbered(error))))?;
    let splitting = Splitting {
        vertices: split.points.len() - graph.points.len(),
        edges: [graph.edges.len(), split.edges.len()],
        rounds: split.rounds,
        displacement: split.displacement,
    };
    let columns = graph
        .columns
        .iter()
        .map(|column| extended(column, &graph, &split));
    let graph = Graph {
        columns: columns.collect(),
        points: split.points,
        edges: split.edges,
        pieces_of: split.pieces_of,
        ..graph
    };
    Ok((graph, splitting))
}

/// A column with the numbers of new vertices: each in proportion between the ends of the first edge that goes
/// through it.
fn extended<S: Coordinate>(column: &Column, graph: &Graph<S>, split: &Split<S>) -> Column {
    let mut values = column.values.clone();
    values.resize(split.points.len(), f64::NAN);
    let near = |v: usize| split.points[v].each_ref().map(S::approx);
    for (piece, &edge) in split.edges.iter().zip(&split.pieces_of) {
        let [a, b] = graph.edges[edge];
        let [from, to] = [a, b].map(near);
        let direction = [to[0] - from[0], to[1] - from[1]];
        let axis = usize::from(direction[1].abs() > direction[0].abs());
        for &v in piece {
            if values[v].is_nan() {
                let share = (near(v)[axis] - from[axis]) / direction[axis];
                let value = values[a] + share * (values[b] - values[a]);
                values[v] = if value.is_finite() { value } else { values[a] };
            }
        }
    }
    Column {
        name: column.name.clone(),
        values,
    }
}

impl Splitting {
    /// What was triangulated in place of the input called `name`.
    pub(crate) fn triangulated(&self, name: &str) -> String {
        if self.rounds == 0 {
            name.to_owned()
        } else {
            format!("the split edges of {name}")
        }
    }

    /// Writes it: one line.
    pub(crate) fn write(&self, name: &str, out: &mut impl Write) -> io::Result<()> {
        let Splitting {
            vertices,
            edges: [edges, pieces],
            rounds,
            displacement,
        } = self;
        write!(out, "{name}: {edges} edges split into {pieces}, ")?;
        write!(out, "new vertices {vertices}, rounds {rounds}, ")?;
        let displacement = displacement.text();
        writeln!(
            out,
            "greatest displacement {displacement} units in the last place"
        )
    }
}
