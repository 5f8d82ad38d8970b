//! A planar straight-line graph as it stands in a file: vertices, edges, seeds of holes and regions, and how the
//! file counts them.

use sweep_cdt::domain::DomainError;
use sweep_cdt::{Error, Pslg, Region};

/// Vertices and edges in the file's order, edges as positions in `points`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Graph<S> {
    /// The vertices.
    pub points: Vec<[S; 2]>,
    /// What else the file says of the vertices: heights, for instance.
    pub columns: Vec<Column>,
    /// The edges, as positions in `points`.
    pub edges: Vec<[usize; 2]>,
    /// For each edge the edge of the file that it is a piece of, in order, where edges were
    /// [split](sweep_cdt::crossings::split) at their crossings. Empty, if they are those of the file.
    pub pieces_of: Vec<usize>,
    /// Points that stand for the holes they lie in.
    pub holes: Vec<[S; 2]>,
    /// Points that stand for the regions they lie in.
    pub regions: Vec<Region<S>>,
    /// The file's number of the first vertex: 0 or 1.
    pub first_vertex: usize,
    /// The file's number of the first edge: 0 or 1.
    pub first_edge: usize,
    /// The file's number of the first hole: 0 or 1.
    pub first_hole: usize,
    /// The file's number of the first region: 0 or 1.
    pub first_region: usize,
}

/// Numbers that go with the vertices of a [`Graph`] and change nothing: one for each.
///
/// ```
/// use sweep_cdt_formats::{Input, InputFormat, Source, read};
///
/// let bytes = b"2 2 1 0\n1 0 0 812.5\n2 1 0.5 790\n".to_vec();
/// let source = Source { name: "hill.node".to_owned(), bytes };
/// let Input::Doubles(graph) = read(InputFormat::Node, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(graph.columns[0].name, "z");
/// assert_eq!(graph.columns[0].values, [812.5, 790.0]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// What the file calls them; `z` are the heights.
    pub name: String,
    /// The number of each vertex.
    pub values: Vec<f64>,
}

impl Column {
    /// The name of the heights.
    pub const HEIGHT: &str = "z";

    /// The number of a vertex, 0 where there is none.
    pub(crate) fn of(&self, vertex: usize) -> f64 {
        self.values.get(vertex).copied().unwrap_or(0.0)
    }
}

impl<S> From<Pslg<S>> for Graph<S> {
    /// The graph of a file that counts from 0 and has no columns.
    fn from(graph: Pslg<S>) -> Graph<S> {
        Graph {
            points: graph.points,
            columns: Vec::new(),
            edges: graph.edges,
            pieces_of: Vec::new(),
            holes: graph.holes,
            regions: graph.regions,
            first_vertex: 0,
            first_edge: 0,
            first_hole: 0,
            first_region: 0,
        }
    }
}

impl<S> Graph<S> {
    /// The heights, if there are any.
    pub fn heights(&self) -> Option<&Column> {
        let mut columns = self.columns.iter();
        columns.find(|column| column.name == Column::HEIGHT)
    }

    /// The numbers that the file gives to edges.
    ///
    /// ```
    /// let graph = sweep_cdt_formats::Graph::<f64> { first_edge: 1, ..Default::default() };
    /// assert_eq!(graph.edges_as_numbered([0, 2]), [1, 3]);
    /// ```
    pub fn edges_as_numbered(&self, edges: [usize; 2]) -> [usize; 2] {
        edges.map(|edge| edge.saturating_add(self.first_edge))
    }

    /// The same error with vertices and edges numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::Error;
    /// use sweep_cdt_formats::Graph;
    ///
    /// let graph = Graph::<f64> { first_edge: 1, ..Graph::default() };
    /// let error = graph.as_numbered(Error::CrossingEdges { edges: [0, 1] });
    /// assert_eq!(error.to_string(), "edges 1 and 2 cross");
    /// ```
    pub fn as_numbered(&self, error: Error) -> Error {
        error.renumbered(
            |vertex| vertex.saturating_add(self.first_vertex),
            |edge| edge.saturating_add(self.first_edge),
        )
    }

    /// The same error with vertices, edges, holes and regions numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::domain::{DomainError, Seed};
    /// use sweep_cdt_formats::Graph;
    ///
    /// let graph = Graph::<f64> { first_hole: 1, ..Graph::default() };
    /// let error = DomainError::SeedOutside { seed: Seed::Hole(0) };
    /// let error = graph.domain_as_numbered(error);
    /// assert_eq!(error.to_string(), "the seed of hole 1 lies outside of the hull");
    /// ```
    pub fn domain_as_numbered(&self, error: DomainError) -> DomainError {
        error.renumbered(
            |vertex| vertex.saturating_add(self.first_vertex),
            |edge| edge.saturating_add(self.first_edge),
            |hole| hole.saturating_add(self.first_hole),
            |region| region.saturating_add(self.first_region),
        )
    }
}

/// Pairs of vertices, sorted, with the lower vertex of each pair first.
pub fn sorted_pairs(pairs: impl Iterator<Item = [usize; 2]>) -> Vec<[usize; 2]> {
    let mut sorted: Vec<[usize; 2]> = pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sorted.sort_unstable();
    sorted
}
