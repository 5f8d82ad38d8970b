//! A planar straight-line graph as it stands in a file: the graph, what else the file says of its vertices, and how
//! the file counts.

use sweep_cdt::crossings::SplitError;
use sweep_cdt::interior::InteriorError;
use sweep_cdt::{Error, Pslg};

/// A graph, all in the order of its file, and what the file says beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphFile<S> {
    /// The vertices, the edges, and the seeds of holes and regions.
    pub graph: Pslg<S>,
    /// Further columns of the vertices: heights, for instance.
    pub columns: Vec<Column>,
    /// For each edge the edge of the file that it is a piece of, in order, where edges were
    /// [split](sweep_cdt::crossings::split) at their crossings. Empty, if they are those of the file.
    pub pieces_of: Vec<usize>,
    /// The numbers that the file gives to all of them.
    pub numbering: Numbering,
}

/// How a file counts: its number of the first thing of each kind, 0 or 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Numbering {
    /// The number of the first vertex.
    pub vertex: usize,
    /// The number of the first edge.
    pub edge: usize,
    /// The number of the first hole.
    pub hole: usize,
    /// The number of the first region.
    pub region: usize,
}

impl Numbering {
    /// A file that counts all things from 1.
    pub const FROM_ONE: Numbering = Numbering {
        vertex: 1,
        edge: 1,
        hole: 1,
        region: 1,
    };

    /// The numbers that the file gives to edges.
    ///
    /// ```
    /// use sweep_cdt_formats::Numbering;
    ///
    /// assert_eq!(Numbering::FROM_ONE.edges([0, 2]), [1, 3]);
    /// ```
    #[must_use]
    pub fn edges(self, edges: [usize; 2]) -> [usize; 2] {
        edges.map(|edge| edge.saturating_add(self.edge))
    }
}

/// Numbers that go with the vertices of a [`GraphFile`] and change nothing: one for each.
///
/// ```
/// use sweep_cdt_formats::{Input, InputFormat, Source, read};
///
/// let bytes = b"2 2 1 0\n1 0 0 812.5\n2 1 0.5 790\n".to_vec();
/// let source = Source::new("hill.node", bytes);
/// let Input::Doubles(file) = read(InputFormat::Node, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.columns[0].name, "z");
/// assert_eq!(file.columns[0].values, [812.5, 790.0]);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Column {
    /// The name in the file; `z` are the heights.
    pub name: String,
    /// The number of each vertex; NaN where it is missing.
    pub values: Vec<f64>,
}

impl PartialEq for Column {
    /// Equal columns have the same name and values; missing numbers are equal.
    fn eq(&self, other: &Column) -> bool {
        let is_same = |(x, y): (&f64, &f64)| x == y || x.is_nan() && y.is_nan();
        self.name == other.name
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(is_same)
    }
}

impl Column {
    /// The name of the heights.
    pub const HEIGHT: &str = "z";

    /// The column of these heights.
    pub fn heights(values: Vec<f64>) -> Column {
        Column {
            name: Column::HEIGHT.to_owned(),
            values,
        }
    }

    /// How many vertices have no number.
    pub fn missing(&self) -> usize {
        self.values.iter().filter(|value| value.is_nan()).count()
    }

    /// The number of a vertex, NaN where there is none.
    pub(crate) fn of(&self, vertex: usize) -> f64 {
        self.values.get(vertex).copied().unwrap_or(f64::NAN)
    }
}

impl<S> From<Pslg<S>> for GraphFile<S> {
    /// The graph of a file that counts from 0 and has no columns.
    fn from(graph: Pslg<S>) -> GraphFile<S> {
        GraphFile {
            graph,
            columns: Vec::new(),
            pieces_of: Vec::new(),
            numbering: Numbering::default(),
        }
    }
}

impl<S> Default for GraphFile<S> {
    fn default() -> GraphFile<S> {
        Pslg::default().into()
    }
}

impl<S> GraphFile<S> {
    /// The heights, if there are any.
    pub fn heights(&self) -> Option<&Column> {
        let mut columns = self.columns.iter();
        columns.find(|column| column.name == Column::HEIGHT)
    }

    /// An error with its vertices and edges numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::Error;
    /// use sweep_cdt_formats::{GraphFile, Numbering};
    ///
    /// let file = GraphFile::<f64> { numbering: Numbering::FROM_ONE, ..GraphFile::default() };
    /// let error = file.as_numbered(Error::CrossingEdges { edges: [0, 1] });
    /// assert_eq!(error.to_string(), "edges 1 and 2 cross");
    /// ```
    pub fn as_numbered(&self, error: Error) -> Error {
        let first = self.numbering;
        error.renumbered(
            |vertex| vertex.saturating_add(first.vertex),
            |edge| edge.saturating_add(first.edge),
        )
    }

    /// An error of [`split`](sweep_cdt::crossings::split) or [`crossings`](sweep_cdt::crossings::crossings()) with
    /// vertices and edges numbered as in the file.
    pub fn split_as_numbered(&self, error: SplitError) -> SplitError {
        let Numbering { vertex, edge, .. } = self.numbering;
        error.renumbered(|v| v.saturating_add(vertex), |e| e.saturating_add(edge))
    }

    /// An error of a domain with its vertices, edges, holes and regions numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::interior::{InteriorError, Seed};
    /// use sweep_cdt_formats::{GraphFile, Numbering};
    ///
    /// let file = GraphFile::<f64> { numbering: Numbering::FROM_ONE, ..GraphFile::default() };
    /// let error = InteriorError::SeedOutside { seed: Seed::Hole(0) };
    /// let error = file.interior_as_numbered(error);
    /// assert_eq!(error.to_string(), "the seed of hole 1 lies outside of the hull");
    /// ```
    pub fn interior_as_numbered(&self, error: InteriorError) -> InteriorError {
        let first = self.numbering;
        error.renumbered(
            |vertex| vertex.saturating_add(first.vertex),
            |edge| edge.saturating_add(first.edge),
            |hole| hole.saturating_add(first.hole),
            |region| region.saturating_add(first.region),
        )
    }
}

/// Pairs of vertices, sorted, with the lower vertex of each pair first.
pub fn sorted_pairs(pairs: impl Iterator<Item = [usize; 2]>) -> Vec<[usize; 2]> {
    let mut sorted: Vec<[usize; 2]> = pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sorted.sort_unstable();
    sorted
}
