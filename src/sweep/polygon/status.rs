//! The status of the sweep line: the edges that it crosses, from left to right, and what lies between them.
//!
//! Outside and inside take turns: on the right of the first edge is an *interval* inside, on the right of the second
//! edge one outside. An edge that ends gives its place to the next one of its ring, so that only a vertex with two edges
//! above it is looked for. This walk begins where the last one ended.
//!
//! Cost: O(1), but for the walks. They may take a constant number of steps for each vertex, all together: then the sweep
//! is given up. Polygons with many teeth side by side are the only ones known to take more.

use alloc::vec::Vec;
use core::cmp::Ordering::{self, Equal, Greater, Less};

use super::chains::Chain;
use crate::ids::{VertexId, narrow};
use crate::sweep::delaunay::Delaunay;

/// The number of an edge that the sweep line crosses.
pub(super) type Crossed = u32;

/// Beyond the first and the last edge.
pub(super) const END: Crossed = 0;

/// An edge that the sweep line crosses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// The lower end and the upper end.
    ends: [VertexId; 2],
    /// The edges on the left and on the right.
    pub(super) beside: [Crossed; 2],
    /// Whether the interval on the right is inside.
    pub(super) is_left_of_inside: bool,
    /// Whether the edge runs upwards along its ring.
    pub(super) runs_up: bool,
    /// The chain of the interval on the right, if that is inside.
    pub(super) chain: Chain,
}

/// The status. Edges keep their numbers.
#[derive(Debug, Default)]
pub(super) struct Status {
    edges: Vec<Edge>,
    /// The edges that end at each vertex.
    ending: Vec<[Crossed; 2]>,
    /// Where the last walk ended.
    hint: Crossed,
    /// How many steps the walks may still take.
    steps: usize,
}

/// How many steps the walks may take for each vertex.
const STEPS: usize = 16;

impl Status {
    /// Begins below all of so many vertices.
    pub(super) fn begin(&mut self, vertices: usize) {
        let nowhere = Edge {
            ends: [VertexId::new(0); 2],
            beside: [END; 2],
            is_left_of_inside: false,
            runs_up: false,
            chain: Chain::default(),
        };
        self.edges.clear();
        self.edges.push(nowhere);
        self.ending.clear();
        self.ending.resize(vertices, [END; 2]);
        self.hint = END;
        self.steps = STEPS * vertices;
    }

    #[inline(always)]
    pub(super) fn edge(&self, edge: Crossed) -> &Edge {
        &self.edges[edge as usize]
    }

    #[inline(always)]
    pub(super) fn edge_mut(&mut self, edge: Crossed) -> &mut Edge {
        &mut self.edges[edge as usize]
    }

    /// The edges that end at a vertex: first two, or one, or none.
    #[inline(always)]
    pub(super) fn ending(&self, v: VertexId) -> [Crossed; 2] {
        self.ending[v.index()]
    }

    /// Puts an edge of the ring on the right of another one.
    pub(super) fn insert(&mut self, left: Crossed, ends: [VertexId; 2], runs_up: bool) -> Crossed {
        let edge = narrow(self.edges.len());
        let right = self.edge(left).beside[1];
        self.edges.push(Edge {
            ends,
            beside: [left, right],
            is_left_of_inside: !self.edge(left).is_left_of_inside,
            runs_up,
            chain: Chain::default(),
        });
        self.edge_mut(left).beside[1] = edge;
        self.edge_mut(right).beside[0] = edge;
        self.lead_on(edge, ends);
        self.hint = edge;
        edge
    }

    /// Puts the edge with these ends in the place of one that ends.
    #[inline(always)]
    pub(super) fn lead_on(&mut self, edge: Crossed, ends: [VertexId; 2]) {
        self.edge_mut(edge).ends = ends;
        let ending = &mut self.ending[ends[1].index()];
        ending[usize::from(ending[0] != END)] = edge;
    }

    /// Removes two edges, the left one first, from between their neighbours.
    pub(super) fn remove(&mut self, pair: [Crossed; 2]) {
        let [left, right] = [0, 1].map(|side| self.edge(pair[side]).beside[side]);
        self.edge_mut(left).beside[1] = right;
        self.edge_mut(right).beside[0] = left;
        self.hint = left;
    }

    /// Whether a vertex with these approximations lies between two edges, and on neither.
    #[inline(always)]
    pub(super) fn is_between(
        &self,
        [left, right]: [Crossed; 2],
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) -> bool {
        (left == END || self.side(left, v, approx, delaunay) == Less)
            && (right == END || self.side(right, v, approx, delaunay) == Greater)
    }

    /// The edge next to a vertex with these approximations, on the left; `None` if the vertex lies on an edge, or if the
    /// walks have taken too many steps.
    pub(super) fn find(
        &mut self,
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) -> Option<Crossed> {
        let mut at = self.hint;
        while at != END {
            self.steps = self.steps.checked_sub(1)?;
            match self.side(at, v, approx, delaunay) {
                Greater => at = self.edge(at).beside[0],
                Equal => return None,
                Less => break,
            }
        }
        loop {
            let right = self.edge(at).beside[1];
            if right == END {
                return Some(at);
            }
            self.steps = self.steps.checked_sub(1)?;
            match self.side(right, v, approx, delaunay) {
                Greater => return Some(at),
                Equal => return None,
                Less => at = right,
            }
        }
    }

    /// The side of an edge, seen upwards, that a vertex with these approximations is on: `Greater` for left.
    #[inline(always)]
    fn side(
        &self,
        edge: Crossed,
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) -> Ordering {
        let [lower, upper] = self.edge(edge).ends;
        let ends = [lower, upper].map(|end| delaunay.predicates.approx(end));
        delaunay.orient2d_approx([lower, upper, v], [ends[0], ends[1], approx])
    }
}
