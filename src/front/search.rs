//! What a search structure for the advancing front must do (section 3.4.1), and when it asks for x-ranks.

use core::any::Any;

use super::list::{Front, FrontNode};

/// What a search structure may know of the vertices before the sweep starts.
#[derive(Clone, Copy, Debug)]
pub struct FrontInput<'a> {
    approx: &'a [[f64; 2]],
}

impl<'a> FrontInput<'a> {
    /// The domain of vertices with these coordinates `[x, y]`, by rank in the sweep order.
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

    /// The x of the vertex of this rank: a double near the coordinate. Like every `x` that [`FrontSearch`]
    /// gets, it may be scaled by a power of two, and it may be infinite.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn x(&self, rank: usize) -> f64 {
        self.approx[rank][0]
    }
}

/// A walk of more than this many steps from where a structure sent it is reported to the structure.
pub const LONG_WALK: usize = 32;

/// A structure that finds a place on the advancing front near a given x.
///
/// [`locate`](FrontSearch::locate) does the work. The other functions report what happens to the front,
/// and may be left out; so may [`wants_ranks`](FrontSearch::wants_ranks), by which a structure can ask for better
/// keys than x. A structure is a value: it may carry parameters, a seed and counters of its own.
/// Each run of a [`Triangulator`](crate::Triangulator) works on a clone of the value it was given and
/// returns that clone in [`Run::front`](crate::Run::front). The sweep calls it through `dyn`.
///
/// From left to right on the front, the x that a structure gets never falls. It may repeat: where a new
/// vertex comes straight above another, and where two coordinates have the same approximation. So a
/// structure keyed by x needs the node in its key too.
///
/// Your own structure takes a few lines:
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt::front::{Front, FrontNode, FrontSearch};
///
/// /// Always starts at the left end, and counts how often it is asked.
/// #[derive(Clone, Default)]
/// struct LeftEnd {
///     searches: usize,
/// }
///
/// impl FrontSearch for LeftEnd {
///     fn locate(&mut self, _x: f64, front: &Front) -> FrontNode {
///         self.searches += 1;
///         front.left_end()
///     }
/// }
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
/// let triangulator = Triangulator::new().front(LeftEnd::default());
/// let run = triangulator.triangulate_with_stats(&points, &[])?;
/// assert_eq!((run.triangulation.len(), run.front.searches), (1, 2));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub trait FrontSearch {
    /// A run begins: the front has no vertex yet but its two artificial ends, which `inserted` and
    /// `removed` never name.
    ///
    /// What an earlier run left in the structure must be forgotten here.
    fn begin(&mut self, input: FrontInput<'_>) {
        let _ = input;
    }

    /// A node of `front`, best the last one whose x is at most `x`.
    ///
    /// The sweep panics if the node is not on the front.
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode;

    /// The walk from the node that [`locate`](FrontSearch::locate) named took this many steps, more than
    /// [`LONG_WALK`]. Returns whether the structure wants *x-ranks* for x from now on.
    ///
    /// If so, the sweep numbers all vertices from left to right by exact comparison, 0 for the first. It calls
    /// [`begin`](FrontSearch::begin) with these numbers as x, and `inserted` for each node that is on the
    /// front, from left to right. Every later `x` is a place too. No two vertices have the same one, and
    /// they are spread evenly, whatever the coordinates. That takes O(n log n) once. Nothing is asked
    /// afterwards.
    ///
    /// ```
    /// use sweep_cdt::Triangulator;
    /// use sweep_cdt::front::{FrontInput, Front, FrontNode, FrontSearch, LONG_WALK};
    ///
    /// /// The nodes by place. Until x-ranks are given, walks start at the left end.
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

    /// `node`, whose x is `x`, has left the front, forever.
    fn removed(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }

    /// The structure with its type, by which the sweep knows the default hash table and calls it directly.
    #[doc(hidden)]
    fn as_any(&mut self) -> Option<&mut dyn Any> {
        None
    }
}

/// How many steps of long walks are borne, for each vertex: they take about as long as finding the x-ranks.
const STEPS: usize = 4;

/// The steps that are still borne.
///
/// A structure asks for x-ranks instead of x after long walks of more than a few steps a vertex in all.
///
/// So all long walks together take O(n) steps before it asks, as many as finding the x-ranks costs, and
/// inputs on which the structure finds its way never pay for them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WalkBudget {
    left: usize,
    has_ended: bool,
}

impl WalkBudget {
    /// That with a front of so many vertices in all.
    pub(super) fn with(vertices: usize) -> WalkBudget {
        WalkBudget {
            left: STEPS * vertices,
            has_ended: false,
        }
    }

    /// Whether it has ended: the structure begins again, with x-ranks.
    pub(super) fn has_ended(self) -> bool {
        self.has_ended
    }

    /// Whether it ends with a walk of so many steps.
    pub(super) fn ends(&mut self, steps: usize) -> bool {
        self.has_ended = steps > self.left;
        self.left = self.left.saturating_sub(steps);
        self.has_ended
    }
}
