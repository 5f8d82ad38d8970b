//! A graph with its edges split where they cross: [`split`] for points and edges, and what else a file says of them.
//!
//! Vertices of the input keep their numbers and columns. A new vertex takes its number in a column from the first
//! edge through it that has numbers at both ends, in proportion between them; where they differ by more than the
//! largest double, it takes that of the first end. Where another such edge says otherwise, a remark names the vertex.
//! Pieces keep the marker and the ring of their edge.
//!
//! Cost: that of [`split`], and the pieces times the columns.

use crate::doubts::Conflicts;
use crate::{Column, Coordinate, GraphFile, Remark};
use sweep_cdt::Pslg;
use sweep_cdt::crossings::{SplitError, split};

/// The outcome of [`GraphFile::split_crossings`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Splitting {
    /// How many vertices are new.
    pub vertices: usize,
    /// How many edges there were, and how many pieces there are.
    pub edges: [usize; 2],
    /// How many rounds it took, as [`Split::rounds`](sweep_cdt::crossings::Split::rounds).
    pub rounds: usize,
    /// How far an edge moved at most, as [`Split::displacement`](sweep_cdt::crossings::Split::displacement).
    pub displacement: f64,
}

impl<S: Coordinate> GraphFile<S> {
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
        let mut remarks = self.remarks.clone();
        let columns = self.columns.iter().map(|column| {
            let pieces = split.edges.iter().zip(&split.pieces_of);
            let pieces = pieces.map(|(piece, &edge)| (graph.edges[edge], &piece[..]));
            let (column, conflict) = column.extended(&split.points, pieces);
            remarks.extend(conflict);
            column
        });
        let columns = columns.collect();
        let file = self.with_pieces(split.points, split.edges, &split.pieces_of);
        let file = GraphFile {
            columns,
            remarks,
            ..file
        };
        Ok((file, splitting))
    }

    /// The graph with more points, and with pieces of its edges for edges: `pieces_of` has for each piece its edge.
    /// Pieces keep the marker, the ring and the feature of their edge. Edges that follow are new, and have none. Columns
    /// are those of the old points.
    #[must_use]
    pub fn with_pieces(
        &self,
        points: Vec<[S; 2]>,
        edges: Vec<[usize; 2]>,
        pieces_of: &[usize],
    ) -> GraphFile<S> {
        let marker = |&edge: &usize| self.edge_markers.get(edge).copied();
        let feature = |&edge: &usize| self.edge_features.get(edge).copied();
        let first = |&edge: &usize| self.pieces_of.get(edge).copied().unwrap_or(edge);
        let mut edge_markers: Vec<i64> = pieces_of.iter().filter_map(marker).collect();
        if !edge_markers.is_empty() {
            edge_markers.resize(edges.len(), 0);
        }
        GraphFile {
            columns: self.columns.clone(),
            region_areas: self.region_areas.clone(),
            edge_markers,
            polygons: self.polygons.of_pieces(pieces_of, edges.len()),
            edge_features: pieces_of.iter().filter_map(feature).collect(),
            features: self.features,
            properties: self.properties.clone(),
            faces: self.faces.clone(),
            system: self.system.clone(),
            merged: self.merged,
            remarks: self.remarks.clone(),
            graph: Pslg {
                points,
                edges,
                holes: self.graph.holes.clone(),
                regions: self.graph.regions.clone(),
            },
            pieces_of: pieces_of.iter().map(first).collect(),
            numbering: self.numbering,
            layers: self.layers.clone(),
        }
    }
}

impl Column {
    /// The column with the numbers of new vertices on chains that are given with the ends of their edges: from the first
    /// chain through each that has numbers at both ends. And the first vertex for which two chains have numbers that
    /// differ by more than rounding. Markers of new vertices are missing.
    #[must_use]
    pub fn extended<'a, S: Coordinate>(
        &self,
        points: &[[S; 2]],
        chains: impl Iterator<Item = ([usize; 2], &'a [usize])>,
    ) -> (Column, Option<Remark>) {
        let mut values = self.values.clone();
        values.resize(points.len(), f64::NAN);
        let name = self.name.clone();
        if name == Column::MARKER {
            return (Column { name, values }, None);
        }
        let near = |v: usize| points[v].each_ref().map(S::approx);
        let mut conflicts = Conflicts::new(points.len());
        for ([a, b], chain) in chains {
            if values[a].is_nan() || values[b].is_nan() {
                continue;
            }
            let [from, to] = [a, b].map(near);
            let direction = [to[0] - from[0], to[1] - from[1]];
            let axis = usize::from(direction[1].abs() > direction[0].abs());
            // Points of the input keep what they have, or have not.
            let is_new = |&&v: &&usize| v >= self.values.len();
            for &v in chain.iter().filter(is_new) {
                let share = (near(v)[axis] - from[axis]) / direction[axis];
                let value = values[a] + share * (values[b] - values[a]);
                let value = if value.is_finite() { value } else { values[a] };
                let kept = values[v];
                if kept.is_nan() {
                    values[v] = value;
                } else if is_apart(kept, value, values[a].abs().max(values[b].abs())) {
                    conflicts.add(v, [kept, value]);
                }
            }
        }
        let conflict = conflicts.remark(&name);
        (Column { name, values }, conflict)
    }
}

/// Whether numbers that come from numbers of this size differ by more than rounding, which is far below the last digit
/// that is printed of a height. No triangle depends on it.
fn is_apart(one: f64, other: f64, size: f64) -> bool {
    const ROUNDING: f64 = 1e-9;
    (one - other).abs() > ROUNDING * size.max(one.abs())
}
