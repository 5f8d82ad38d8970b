//! A graph with its edges split where they cross: [`split`] for points and edges, and what else a file says of them.
//!
//! Vertices of the input keep their numbers and columns. A new vertex takes its number in a column from the first
//! edge through it, in proportion between that edge's ends; where an end has none, or they differ by more than the
//! largest double, it takes that of the first end.
//!
//! Cost: that of [`split`], and the pieces times the columns.

use crate::{Column, Coordinate, GraphFile};
use sweep_cdt::Pslg;
use sweep_cdt::crossings::{Exact, Split, SplitError, split};

/// The outcome of [`GraphFile::split_crossings`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Splitting {
    /// How many vertices are new.
    pub vertices: usize,
    /// How many edges there were, and how many pieces there are.
    pub edges: [usize; 2],
    /// How many rounds it took, as [`Split::rounds`].
    pub rounds: usize,
    /// How far an edge moved at most, as [`Split::displacement`].
    pub displacement: f64,
}

impl<S: Coordinate + Exact> GraphFile<S> {
    /// The graph with its edges [split] where they cross, and what the file says of it.
    ///
    /// # Errors
    /// Errors of [`split`], with vertices and edges by their positions.
    ///
    /// ```
    /// use sweep_cdt::Pslg;
    /// use sweep_cdt_formats::{Column, GraphFile};
    ///
    /// let points = vec![[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0]];
    /// let heights = Column { name: Column::HEIGHT.to_owned(), values: vec![0.0, 10.0, 0.0, 0.0] };
    /// let edges = vec![[0, 1], [2, 3]];
    /// let graph = Pslg { points, edges, ..Pslg::default() };
    /// let file = GraphFile { columns: vec![heights], ..graph.into() };
    /// let (file, splitting) = file.split_crossings()?;
    /// assert_eq!(file.graph.points[4], [1.0, 1.0]);
    /// assert_eq!(file.columns[0].values[4], 5.0);
    /// assert_eq!(file.pieces_of, [0, 0, 1, 1]);
    /// assert_eq!((splitting.vertices, splitting.edges), (1, [2, 4]));
    /// # Ok::<(), sweep_cdt::crossings::SplitError>(())
    /// ```
    pub fn split_crossings(&self) -> Result<(GraphFile<S>, Splitting), SplitError> {
        let graph = &self.graph;
        let split = split(&graph.points, &graph.edges)?;
        let splitting = Splitting {
            vertices: split.points.len() - graph.points.len(),
            edges: [graph.edges.len(), split.edges.len()],
            rounds: split.rounds,
            displacement: split.displacement,
        };
        let columns = self.columns.iter();
        let columns = columns.map(|column| extended(column, graph, &split));
        let file = GraphFile {
            columns: columns.collect(),
            graph: Pslg {
                points: split.points,
                edges: split.edges,
                holes: graph.holes.clone(),
                regions: graph.regions.clone(),
            },
            pieces_of: split.pieces_of,
            numbering: self.numbering,
        };
        Ok((file, splitting))
    }
}

/// A column with the numbers of new vertices, from the first edge through each that has numbers at both ends.
fn extended<S: Coordinate>(column: &Column, graph: &Pslg<S>, split: &Split<S>) -> Column {
    let mut values = column.values.clone();
    values.resize(split.points.len(), f64::NAN);
    let near = |v: usize| split.points[v].each_ref().map(S::approx);
    for (piece, &edge) in split.edges.iter().zip(&split.pieces_of) {
        let [a, b] = graph.edges[edge];
        let [from, to] = [a, b].map(near);
        let direction = [to[0] - from[0], to[1] - from[1]];
        let axis = usize::from(direction[1].abs() > direction[0].abs());
        // Points of the input keep what they have, or have not.
        let is_new = |&&v: &&usize| v >= column.values.len();
        for &v in piece.iter().filter(is_new) {
            if values[v].is_nan() {
                let share = (near(v)[axis] - from[axis]) / direction[axis];
                let value = values[a] + share * (values[b] - values[a]);
                let is_known = !values[a].is_nan() && !values[b].is_nan();
                values[v] = if value.is_finite() || !is_known {
                    value
                } else {
                    values[a]
                };
            }
        }
    }
    Column {
        name: column.name.clone(),
        values,
    }
}
