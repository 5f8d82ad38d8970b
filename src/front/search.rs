//! The duties of a search structure for the advancing front (section 3.4.1).

use super::list::{Front, FrontNode};

/// All that a search structure may know of the vertices before the sweep starts.
#[derive(Clone, Copy, Debug)]
pub struct FrontInput<'a> {
    approx: &'a [[f64; 2]],
}

impl<'a> FrontInput<'a> {
    /// The vertices with these approximate coordinates `[x, y]`, by rank in the sweep order.
    pub fn new(approx: &'a [[f64; 2]]) -> Self {
        FrontInput { approx }
    }

    /// How many vertices will be swept.
    pub fn len(&self) -> usize {
        self.approx.len()
    }

    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.approx.is_empty()
    }

    /// The approximate x of the vertex of this rank. Like every `x` that a [`FrontSearch`] gets, it may be scaled by a
    /// power of two, or infinite. Panics if there is no such vertex.
    pub fn x(&self, rank: usize) -> f64 {
        self.approx[rank][0]
    }
}

/// A structure that finds a place on the advancing front near a given x.
///
/// [`locate`](FrontSearch::locate) does the work, and [`begin`](FrontSearch::begin) clears what an earlier run left.
/// [`inserted`](FrontSearch::inserted) and [`removed`](FrontSearch::removed) tell what happens to the front, and may be
/// left out. A structure is a value: it may carry parameters, a seed and counters.
///
/// From left to right on the front, the x that a structure gets never falls. It may repeat: where a new vertex comes
/// straight above another, and where two coordinates have one approximation. So a structure keyed by x needs the node
/// in its key too. No x is NaN, so `partial_cmp` answers; `total_cmp` sets -0.0 before 0.0, which are one number here. Of nodes of equal x the one of the lesser exact coordinate stands left, whatever their ranks; of two
/// one above the other the lower one does, and leaves the front before the next search.
///
/// To measure a structure take [`Algorithm::Sweep`](crate::Algorithm::Sweep): `Auto` abandons a sweep whose walks add up,
/// and [`Stats::is_divided`](crate::Stats::is_divided) says so. [`Counters::front_steps`](crate::Counters::front_steps)
/// says how good the answers were.
///
/// ```
/// use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
/// use sweep_cdt::{Algorithm, Stats, Triangulator, Watch, triangulate};
///
/// /// The nodes by x, and how many searches there were.
/// #[derive(Default)]
/// struct Sorted {
///     nodes: Vec<(f64, FrontNode)>,
///     searches: usize,
/// }
///
/// impl FrontSearch for Sorted {
///     fn begin(&mut self, _: FrontInput<'_>) {
///         self.nodes.clear();
///     }
///
///     fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
///         self.searches += 1;
///         let place = self.nodes.partition_point(|&(other, _)| other <= x);
///         self.nodes[..place].last().map_or(front.left_end(), |&(_, node)| node)
///     }
///
///     fn inserted(&mut self, node: FrontNode, x: f64) {
///         let place = self.nodes.partition_point(|&other| other < (x, node));
///         self.nodes.insert(place, (x, node));
///     }
///
///     fn removed(&mut self, node: FrontNode, x: f64) {
///         let place = self.nodes.partition_point(|&other| other < (x, node));
///         self.nodes.remove(place);
///     }
/// }
///
/// let points: Vec<_> = (0..1000).map(|i| [i * i % 997, i]).collect();
/// let (mut front, mut stats) = (Sorted::default(), Stats::default());
/// let watch = Watch::new().front(&mut front).stats(&mut stats);
/// let result = Triangulator::new().algorithm(Algorithm::Sweep).run(&points, &[], watch)?;
/// println!("{} searches, {} steps", front.searches, stats.counters.front_steps);
/// let expected = triangulate(&points, &[])?.canonical_triangles();
/// assert_eq!(result.canonical_triangles(), expected);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub trait FrontSearch {
    /// A run begins. The structure must clear its nodes, and keeps its counters if it likes. `inserted` follows for each
    /// node that the front has between its two artificial ends; it and `removed` never name these.
    fn begin(&mut self, input: FrontInput<'_>);

    /// A node of `front`, best the last one whose x is at most `x`. Every node on the front is a legal answer,
    /// [`Front::left_end`] and [`Front::right_end`] too. The sweep panics if the node is not on the front. Called once for
    /// each point event; the first vertex needs no search, and edges search nothing.
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode;

    /// `node`, whose x is `x`, has joined the front.
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }

    /// `node` has left the front, forever. Its `x` is that of [`inserted`](FrontSearch::inserted), bit for bit, so that it
    /// may be a key.
    fn removed(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }
}
