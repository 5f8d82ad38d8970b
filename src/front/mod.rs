//! The advancing front (sections 3.1 and 3.4.1): a doubly linked list of vertices from P-1 to P-2, and
//! the search structures that find a place in it.
//!
//! The front is strictly x-monotone and every vertex is on it at most once, so a vertex is its own
//! node: segment `v` of the front runs from vertex `v` to the next one. A vertex that has left the
//! front never comes back.
//!
//! A search structure ([`FrontSearch`]) only has to name *some* vertex of the front, good or bad: the
//! sweep walks on from there by exact comparisons until it stands on the segment under the new point.
//! So a structure cannot make a result wrong, only slow, and all of them give the same trace.
//!
//! | structure | finds a place in | good for |
//! |---|---|---|
//! | [`HashTable`] | O(1) expected | everything measured; the default |
//! | [`SkipList`] | O(log n) expected | fronts of any shape |
//! | [`Linear`] | O(n) | showing what a structure must do |
//!
//! A structure can be tested without a sweep: [`Front`], [`FrontNode`] and [`Domain`] can be made and
//! changed by hand.
//!
//! Differs from the paper: the paper's structure is the hash table; the others are for comparison.

mod hash_table;
mod linear;
mod skip_list;

pub use hash_table::HashTable;
pub use linear::Linear;
pub use skip_list::SkipList;

use crate::mesh::{VertexId, index};

/// A vertex of the advancing front, by its rank in the sweep order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FrontNode(VertexId);

impl FrontNode {
    pub(crate) fn new(vertex: VertexId) -> Self {
        FrontNode(vertex)
    }

    /// The vertex of this rank, for tests of a structure.
    ///
    /// # Panics
    /// If the rank does not fit in 32 bits.
    pub fn from_rank(rank: usize) -> Self {
        FrontNode(index(rank))
    }

    pub(crate) fn vertex(self) -> VertexId {
        self.0
    }

    /// The rank in the sweep order: 0 for the first vertex swept.
    pub fn rank(self) -> usize {
        self.0 as usize
    }
}

/// What a search structure may know of the vertices before the sweep starts.
#[derive(Clone, Copy, Debug)]
pub struct Domain<'a> {
    near: &'a [[f64; 2]],
}

impl<'a> Domain<'a> {
    /// Of the vertices with these coordinates `[x, y]`, by rank.
    pub fn new(near: &'a [[f64; 2]]) -> Self {
        Domain { near }
    }

    /// How many vertices will be swept.
    pub fn len(&self) -> usize {
        self.near.len()
    }

    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.near.is_empty()
    }

    /// The x of the vertex of this rank, as the `x` of [`FrontSearch`] are given: a double near the
    /// coordinate, possibly scaled by a power of two, or infinite.
    pub fn x(&self, rank: usize) -> f64 {
        self.near[rank][0]
    }
}

/// A structure that finds a place on the advancing front near a given x.
///
/// One function does the work; the others tell the structure what happens to the front, and may be
/// left out. A structure of one's own is one file:
///
/// ```
/// use sweep_cdt::{Domain, Front, FrontNode, FrontSearch, Triangulator};
///
/// /// Always starts at the left end.
/// struct LeftEnd;
///
/// impl FrontSearch for LeftEnd {
///     fn new(_: Domain<'_>) -> Self {
///         LeftEnd
///     }
///     fn locate(&mut self, _x: f64, front: &Front) -> FrontNode {
///         front.left_end()
///     }
/// }
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
/// assert_eq!(Triangulator::new().front::<LeftEnd>().triangulate(&points, &[])?.len(), 1);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub trait FrontSearch {
    /// Makes the structure for a front that has no vertex yet but its two artificial ends.
    fn new(domain: Domain<'_>) -> Self;

    /// A node of `front`, best the last one whose x is at most `x`.
    ///
    /// The sweep panics if the node is not on the front.
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode;

    /// `node`, whose x is `x`, has been put on the front.
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }

    /// `node`, whose x is `x`, has left the front, forever.
    fn removed(&mut self, node: FrontNode, x: f64) {
        let _ = (node, x);
    }
}

const NONE: VertexId = VertexId::MAX;

#[derive(Clone, Copy, Debug)]
struct Neighbors {
    prev: VertexId,
    next: VertexId,
}

/// The advancing front: which vertices are on it, and their neighbours left and right.
///
/// The sweep keeps the one that a structure gets to see. To test a structure alone, keep one by hand:
///
/// ```
/// use sweep_cdt::{Domain, Front, FrontNode, FrontSearch, SkipList};
///
/// let points = [[0.0, 0.0], [6.0, 0.0], [3.0, 1.0]];
/// let mut front = Front::new(points.len());
/// let mut structure = SkipList::new(Domain::new(&points));
/// let [a, b, c] = [0, 1, 2].map(FrontNode::from_rank);
/// for (node, left) in [(a, front.left_end()), (b, a), (c, a)] {
///     front.insert(node, left);
///     structure.inserted(node, points[node.rank()][0]);
/// }
/// assert!(front.contains(structure.locate(4.0, &front)));
///
/// front.remove(c);
/// structure.removed(c, 3.0);
/// assert!(front.contains(structure.locate(4.0, &front)));
/// assert_eq!((front.after(a), front.before(a)), (Some(b), Some(front.left_end())));
/// ```
#[derive(Debug)]
pub struct Front {
    nodes: Vec<Neighbors>,
    left_end: VertexId,
}

impl Front {
    /// The front of `vertices` vertices before the first of them: P-1 and P-2 only.
    ///
    /// # Panics
    /// If the vertices and these two cannot be numbered in 32 bits.
    pub fn new(vertices: usize) -> Front {
        let mut nodes = vec![
            Neighbors {
                prev: NONE,
                next: NONE
            };
            vertices + 2
        ];
        let left_end = index(vertices);
        nodes[vertices].next = left_end + 1;
        nodes[vertices + 1].prev = left_end;
        Front { nodes, left_end }
    }

    /// The artificial left end P-1, which is always on the front; its x is minus infinity.
    pub fn left_end(&self) -> FrontNode {
        FrontNode(self.left_end)
    }

    /// The artificial right end P-2, which is always on the front; its x is infinity.
    pub fn right_end(&self) -> FrontNode {
        FrontNode(self.left_end + 1)
    }

    /// Whether a node is on the front now.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn contains(&self, node: FrontNode) -> bool {
        let Neighbors { prev, next } = self.nodes[node.rank()];
        prev != NONE || next != NONE
    }

    /// The node to the right of one on the front; `None` after the right end.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn after(&self, node: FrontNode) -> Option<FrontNode> {
        let next = self.nodes[node.rank()].next;
        (next != NONE).then_some(FrontNode(next))
    }

    /// The node to the left of one on the front; `None` before the left end.
    ///
    /// # Panics
    /// If there is no such vertex.
    pub fn before(&self, node: FrontNode) -> Option<FrontNode> {
        let prev = self.nodes[node.rank()].prev;
        (prev != NONE).then_some(FrontNode(prev))
    }

    #[inline(always)]
    pub(crate) fn next(&self, v: VertexId) -> VertexId {
        self.nodes[v as usize].next
    }

    #[inline(always)]
    pub(crate) fn prev(&self, v: VertexId) -> VertexId {
        self.nodes[v as usize].prev
    }

    /// Puts `node` between `left` and the node to the right of it.
    ///
    /// The front does not know coordinates: that x ascends from left to right is for the caller to see
    /// to.
    ///
    /// # Panics
    /// If `node` is none of the vertices or on the front already, or `left` is not on the front or its
    /// right end.
    pub fn insert(&mut self, node: FrontNode, left: FrontNode) {
        assert!(node < self.left_end(), "there is no such vertex");
        assert!(!self.contains(node), "the node is on the front already");
        assert!(
            self.contains(left) && left != self.right_end(),
            "nothing can be put behind this node"
        );
        self.put(node.0, left.0);
    }

    /// Takes `node` off.
    ///
    /// # Panics
    /// If `node` is not on the front or one of its ends.
    pub fn remove(&mut self, node: FrontNode) {
        assert!(
            node < self.left_end() && self.contains(node),
            "the node cannot be taken off the front"
        );
        self.take(node.0);
    }

    /// Puts `v` between `left` and its next.
    #[inline(always)]
    pub(crate) fn put(&mut self, v: VertexId, left: VertexId) {
        let right = self.next(left);
        self.nodes[v as usize] = Neighbors {
            prev: left,
            next: right,
        };
        self.nodes[left as usize].next = v;
        self.nodes[right as usize].prev = v;
    }

    /// Takes `v` off.
    #[inline(always)]
    pub(crate) fn take(&mut self, v: VertexId) {
        let Neighbors { prev, next } = self.nodes[v as usize];
        self.nodes[v as usize] = Neighbors {
            prev: NONE,
            next: NONE,
        };
        self.nodes[prev as usize].next = next;
        self.nodes[next as usize].prev = prev;
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.nodes.capacity() * size_of::<Neighbors>()
    }
}
