//! The vertices of the front, and their neighbours left and right. The front is strictly x-monotone, so a vertex is its
//! own node: segment `v` runs from vertex `v` to the next one. A vertex that has left the front never comes back.

use crate::ids::VertexId;
use alloc::vec::Vec;

/// A vertex of the advancing front, by its rank in the sweep order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FrontNode(VertexId);

impl FrontNode {
    pub(crate) fn new(vertex: VertexId) -> Self {
        FrontNode(vertex)
    }

    /// The vertex of this rank, to test a structure with. Panics if the rank does not fit in 32 bits.
    pub fn from_rank(rank: usize) -> Self {
        FrontNode(VertexId::at(rank))
    }

    pub(crate) fn vertex(self) -> VertexId {
        self.0
    }

    /// The rank in the sweep order: 0 for the first vertex swept.
    pub fn rank(self) -> usize {
        self.0.index()
    }
}

/// A direction along the front. The two are mirror images: functions that take a `Direction` are written once for both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    Left,
    Right,
}

/// No neighbour: a number above all others, artificial vertices included.
const NONE: VertexId = VertexId::new(u32::MAX);

#[derive(Clone, Copy, Debug)]
struct Neighbors {
    prev: VertexId,
    next: VertexId,
}

impl Neighbors {
    const OFF_FRONT: Neighbors = Neighbors {
        prev: NONE,
        next: NONE,
    };
}

/// The advancing front: which vertices are on it, and their neighbours left and right.
///
/// The sweep shows its front to the search structure. To test a structure alone, keep a front by hand. Methods panic if
/// a node that they are given is none of the vertices.
///
/// ```
/// use sweep_cdt::front::{FrontInput, Front, FrontNode, FrontSearch, SkipList};
///
/// let points = [[0.0, 0.0], [6.0, 0.0], [3.0, 1.0]];
/// let mut front = Front::new(points.len());
/// let mut structure = SkipList::default();
/// structure.begin(FrontInput::new(&points));
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
    /// The front before the first of `vertices` vertices: P-1 and P-2 only. Panics if these exceed 32 bits.
    pub fn new(vertices: usize) -> Front {
        let mut front = Front {
            nodes: Vec::new(),
            left_end: VertexId::default(),
        };
        front.begin(vertices);
        front
    }

    /// Becomes [`Front::new`] of `vertices` vertices.
    pub(crate) fn begin(&mut self, vertices: usize) {
        let (left_end, right_end) = (VertexId::at(vertices), VertexId::at(vertices + 1));
        self.left_end = left_end;
        self.nodes.clear();
        self.nodes.resize(vertices + 2, Neighbors::OFF_FRONT);
        self.nodes[left_end.index()].next = right_end;
        self.nodes[right_end.index()].prev = left_end;
    }

    /// The artificial left end P-1, which is always on the front; its x is minus infinity.
    pub fn left_end(&self) -> FrontNode {
        FrontNode(self.left_end)
    }

    /// The artificial right end P-2, which is always on the front; its x is infinity.
    pub fn right_end(&self) -> FrontNode {
        FrontNode(VertexId::new(self.left_end.number() + 1))
    }

    /// Whether a node is on the front now.
    pub fn contains(&self, node: FrontNode) -> bool {
        let Neighbors { prev, next } = self.nodes[node.rank()];
        prev != NONE || next != NONE
    }

    /// The node to the right of one on the front; `None` after the right end.
    pub fn after(&self, node: FrontNode) -> Option<FrontNode> {
        let next = self.nodes[node.rank()].next;
        (next != NONE).then_some(FrontNode(next))
    }

    /// The node to the left of one on the front; `None` before the left end.
    pub fn before(&self, node: FrontNode) -> Option<FrontNode> {
        let prev = self.nodes[node.rank()].prev;
        (prev != NONE).then_some(FrontNode(prev))
    }

    /// Puts `node` between `left` and the node to the right of it. The caller sees to it that x ascends.
    ///
    /// # Panics
    /// If `node` is no vertex or is on the front already, or if `left` is not on the front or is its right end.
    pub fn insert(&mut self, node: FrontNode, left: FrontNode) {
        assert!(node < self.left_end(), "there is no such vertex");
        assert!(!self.contains(node), "the node is on the front already");
        assert!(
            self.contains(left) && left != self.right_end(),
            "nothing can be put behind this node"
        );
        self.link(node.0, left.0);
    }

    /// Takes `node` off the front. Panics if it is not there, or is an end.
    pub fn remove(&mut self, node: FrontNode) {
        assert!(
            node < self.left_end() && self.contains(node),
            "the node cannot be taken off the front"
        );
        self.unlink(node.0);
    }

    /// The neighbour of `v`, which is on the front; [`NONE`] beyond an end.
    #[inline(always)]
    pub(crate) fn neighbor(&self, v: VertexId, direction: Direction) -> VertexId {
        match direction {
            Direction::Left => self.prev(v),
            Direction::Right => self.next(v),
        }
    }

    #[inline(always)]
    pub(crate) fn next(&self, v: VertexId) -> VertexId {
        self.nodes[v.index()].next
    }

    #[inline(always)]
    pub(crate) fn prev(&self, v: VertexId) -> VertexId {
        self.nodes[v.index()].prev
    }

    /// [`Front::insert`] without checks.
    #[inline(always)]
    pub(crate) fn link(&mut self, v: VertexId, left: VertexId) {
        let right = self.next(left);
        self.nodes[v.index()] = Neighbors {
            prev: left,
            next: right,
        };
        self.nodes[left.index()].next = v;
        self.nodes[right.index()].prev = v;
    }

    /// [`Front::remove`] without checks.
    #[inline(always)]
    pub(crate) fn unlink(&mut self, v: VertexId) {
        let Neighbors { prev, next } = self.nodes[v.index()];
        self.nodes[v.index()] = Neighbors::OFF_FRONT;
        self.nodes[prev.index()].next = next;
        self.nodes[next.index()].prev = prev;
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        self.nodes.capacity() * size_of::<Neighbors>()
    }
}
