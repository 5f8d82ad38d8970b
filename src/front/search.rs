//! The duties of a search structure for the advancing front (section 3.4.1), and when it asks for x-ranks.

use core::any::Any;

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

/// The sweep reports walks of more than this many steps to the structure whose answer began them.
pub const LONG_WALK: usize = if cfg!(fuzzing) { 2 } else { 32 };

/// A structure that finds a place on the advancing front near a given x.
///
/// [`locate`](FrontSearch::locate) does the work. The other functions may be left out: they report what happens to the
/// front, or let a structure ask for better keys than x ([`wants_ranks`](FrontSearch::wants_ranks)). A structure is a
/// value: it may carry parameters, a seed and counters. The sweep calls structures through `dyn`.
///
/// From left to right on the front, the x that a structure gets never falls. It may repeat: where a new vertex comes
/// straight above another, and where two coordinates have one approximation. So a structure keyed by x needs the node
/// in its key too. Of nodes of equal x the one of the lesser exact coordinate stands left, whatever their ranks; of two
/// one above the other the lower one does, and leaves the front before the next search.
///
/// To measure a structure take [`Algorithm::Sweep`](crate::Algorithm::Sweep), or see whether
/// [`Stats::is_divided`](crate::Stats::is_divided), since `Auto` may abandon the sweep.
/// [`Counters::front_steps`](crate::Counters::front_steps) says how good the answers were. Each run of a
/// [`Triangulator`](crate::Triangulator) works on a clone, which `triangulate_with_stats` and `observe` return in
/// [`Run::front`](crate::Run::front). A clone that a [`Session`](crate::Session) keeps cannot be read.
///
/// ```
/// use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
/// use sweep_cdt::{Algorithm, Triangulator, triangulate};
///
/// /// The nodes by x, and how many searches there were.
/// #[derive(Clone, Default)]
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
/// let triangulator = Triangulator::new().algorithm(Algorithm::Sweep).front(Sorted::default());
/// let run = triangulator.triangulate_with_stats(&points, &[])?;
/// println!("{} searches, {} steps", run.front.searches, run.stats.counters.front_steps);
/// let expected = triangulate(&points, &[])?.canonical_triangles();
/// assert_eq!(run.triangulation.canonical_triangles(), expected);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub trait FrontSearch {
    /// A run begins, or goes on with x-ranks after [`wants_ranks`](FrontSearch::wants_ranks). The structure must clear
    /// its nodes, and keeps its counters if it likes. `inserted` follows for each node that the front has between its
    /// two artificial ends; it and `removed` never name these.
    fn begin(&mut self, input: FrontInput<'_>) {
        let _ = input;
    }

    /// A node of `front`, best the last one whose x is at most `x`. Every node on the front is a legal answer,
    /// [`Front::left_end`] and [`Front::right_end`] too. The sweep panics if the node is not on the front. Called once for
    /// each point event; the first vertex needs no search, and edges search nothing.
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode;

    /// The walk from the node that [`locate`](FrontSearch::locate) named took `steps` steps, more than [`LONG_WALK`].
    /// Returns whether the structure wants *x-ranks* in place of x from now on.
    ///
    /// If so, the sweep numbers all vertices from left to right by exact comparison, from 0, in O(n log n) time. It
    /// calls [`begin`](FrontSearch::begin) with these numbers as x, and `inserted` for each node on the front, from
    /// left to right. Every later `x` is an x-rank too. No two x-ranks are equal, and they are spread evenly, whatever
    /// the coordinates. After `true`, `wants_ranks` is not called again in this run; after `false`, at the next long
    /// walk.
    ///
    /// ```
    /// use sweep_cdt::Triangulator;
    /// use sweep_cdt::front::{FrontInput, Front, FrontNode, FrontSearch, LONG_WALK};
    ///
    /// /// The nodes by x-rank. Until x-ranks are given, walks start at the left end.
    /// #[derive(Clone, Default)]
    /// struct ByPlace {
    ///     nodes: std::collections::BTreeMap<usize, FrontNode>,
    ///     has_ranks: bool,
    /// }
    ///
    /// impl FrontSearch for ByPlace {
    ///     fn wants_ranks(&mut self, steps: usize) -> bool {
    ///         assert!(steps > LONG_WALK);
    ///         self.has_ranks = true;
    ///         true
    ///     }
    ///
    ///     fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
    ///         let last = self.nodes.range(..=x as usize).next_back();
    ///         last.map_or(front.left_end(), |(_, &node)| node)
    ///     }
    ///
    ///     fn inserted(&mut self, node: FrontNode, x: f64) {
    ///         if self.has_ranks {
    ///             self.nodes.insert(x as usize, node);
    ///         }
    ///     }
    ///
    ///     fn removed(&mut self, _: FrontNode, x: f64) {
    ///         if self.has_ranks {
    ///             self.nodes.remove(&(x as usize));
    ///         }
    ///     }
    /// }
    ///
    /// // A row, and points above it from right to left.
    /// let row = (0..100).map(|i| [f64::from(i), 0.0]);
    /// let above = (0..100).map(|i| [99.5 - f64::from(i), 1.0 + f64::from(i)]);
    /// let points: Vec<_> = row.chain(above).collect();
    /// let triangulator = Triangulator::new().front(ByPlace::default());
    /// let run = triangulator.triangulate_with_stats(&points, &[])?;
    /// assert!(run.front.has_ranks);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    fn wants_ranks(&mut self, steps: usize) -> bool {
        let _ = steps;
        false
    }

    /// `node`, whose x is `x`, has joined the front.
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }

    /// `node` has left the front, forever. Its `x` is that of [`inserted`](FrontSearch::inserted), bit for bit, so that it
    /// may be a key.
    fn removed(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }

    /// The structure with its type: the sweep recognizes the default hash table and calls it directly.
    #[doc(hidden)]
    fn as_any(&mut self) -> Option<&mut dyn Any> {
        None
    }
}

/// Steps of long walks that are borne for each vertex: they take about as long as finding the x-ranks.
const STEPS: usize = if cfg!(fuzzing) { 0 } else { 4 };

/// The steps of long walks that a structure still bears before it asks for x-ranks: O(n) in all, as many as finding the
/// x-ranks costs, and inputs on which the structure finds its way never pay for them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WalkBudget {
    left: usize,
    has_ended: bool,
}

impl WalkBudget {
    pub(super) fn with(vertices: usize) -> WalkBudget {
        WalkBudget {
            left: STEPS * vertices,
            has_ended: false,
        }
    }

    /// Whether the budget has ended: the structure begins again, with x-ranks.
    pub(super) fn has_ended(self) -> bool {
        self.has_ended
    }

    /// Takes a walk of `steps` steps from the budget. Returns whether that ends it.
    pub(super) fn ends(&mut self, steps: usize) -> bool {
        self.has_ended = steps > self.left;
        self.left = self.left.saturating_sub(steps);
        self.has_ended
    }
}
