//! The straight-line graph behind an input: vertices, the pieces of edges between them, crossings.

use std::cell::Cell;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::answer::sorted;
use super::numbers::{Number, Point, orient, sweep};

/// An input with duplicates merged and edges split at the vertices on them.
pub struct Graph<'a, N> {
    /// The points.
    pub points: &'a [Point<N>],
    edges: Vec<[usize; 2]>,
    /// For each point the lowest index of an equal one.
    pub representatives: Vec<usize>,
    /// The points that are their own representatives.
    pub vertices: Vec<usize>,
    /// For each edge the vertices along it, from its first end to its second.
    pub chains: Vec<Vec<usize>>,
    /// All pairs of neighbours in chains, lower index first, each once.
    pub pieces: Vec<[usize; 2]>,
    /// The turns of three points that are known already, if there are few points: each is needed often.
    turns: Vec<Cell<Option<Ordering>>>,
}

/// Turns are kept for up to this many points.
const FEW: usize = 12;

impl<'a, N: Number> Graph<'a, N> {
    /// The graph of these points and edges.
    pub fn new(points: &'a [Point<N>], edges: &[[usize; 2]]) -> Self {
        let representatives = representatives(points);
        let vertices = (0..points.len())
            .filter(|&v| representatives[v] == v)
            .collect();
        let edges = edges
            .iter()
            .map(|edge| edge.map(|v| representatives[v]))
            .collect();
        let mut graph = Graph {
            points,
            edges,
            representatives,
            vertices,
            chains: Vec::new(),
            pieces: Vec::new(),
            turns: vec![
                Cell::default();
                if points.len() > FEW {
                    0
                } else {
                    points.len().pow(3)
                }
            ],
        };
        graph.chains = graph.edges.iter().map(|&edge| graph.chain(edge)).collect();
        let pieces: BTreeSet<[usize; 2]> = graph
            .chains
            .iter()
            .flat_map(|chain| chain.windows(2).map(|pair| sorted([pair[0], pair[1]])))
            .collect();
        graph.pieces = pieces.into_iter().collect();
        graph
    }

    /// `Greater` if three points turn left.
    pub fn orient(&self, a: usize, b: usize, c: usize) -> Ordering {
        let turn = || orient(&self.points[a], &self.points[b], &self.points[c]);
        let n = self.points.len();
        let Some(kept) = self.turns.get((a * n + b) * n + c) else {
            return turn();
        };
        let known = kept.get().unwrap_or_else(turn);
        kept.set(Some(known));
        known
    }

    /// Whether `v` lies on the line segment `edge`, ends included.
    fn on(&self, v: usize, [a, b]: [usize; 2]) -> bool {
        let [p, a_, b_] = [v, a, b].map(|v| &self.points[v]);
        let between = |i: usize| p[i] >= *(&a_[i]).min(&b_[i]) && p[i] <= *(&a_[i]).max(&b_[i]);
        self.orient(a, b, v) == Ordering::Equal && between(0) && between(1)
    }

    /// The vertices on an edge, from its first end to its second.
    fn chain(&self, edge: [usize; 2]) -> Vec<usize> {
        let mut chain: Vec<usize> = self
            .vertices
            .iter()
            .copied()
            .filter(|&v| self.on(v, edge))
            .collect();
        chain.sort_by(|&v, &w| sweep(&self.points[w], &self.points[v]));
        if chain.first() != Some(&edge[0]) {
            chain.reverse();
        }
        chain
    }

    /// Whether two segments cross at one point inside both.
    pub fn cross(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> bool {
        let apart = |x, y| x != Ordering::Equal && y != Ordering::Equal && x != y;
        apart(self.orient(a, b, c), self.orient(a, b, d))
            && apart(self.orient(c, d, a), self.orient(c, d, b))
    }

    /// The pairs of edges that cross at a point that is no vertex.
    pub fn crossings(&self) -> Vec<[usize; 2]> {
        let mut crossings = Vec::new();
        for f in 0..self.edges.len() {
            for e in 0..f {
                let [edge, other] = [self.edges[e], self.edges[f]];
                let meet_at_vertex = || {
                    self.vertices
                        .iter()
                        .any(|&v| self.on(v, edge) && self.on(v, other))
                };
                if self.cross(edge, other) && !meet_at_vertex() {
                    crossings.push([e, f]);
                }
            }
        }
        crossings
    }
}

/// For each point the lowest index of an equal one.
pub(super) fn representatives<N: Number>(points: &[Point<N>]) -> Vec<usize> {
    let mut first = BTreeMap::new();
    points
        .iter()
        .enumerate()
        .map(|(v, point)| *first.entry(point).or_insert(v))
        .collect()
}
