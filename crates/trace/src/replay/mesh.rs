//! The mesh of a replay: for each directed side of a triangle the vertex opposite. Also the advancing front, a list.
//!
//! A directed side has one triangle at most. So a triangle is there if one of its directed sides leads to its third
//! vertex, and the mesh needs neither numbers nor links. Every segment of the front has a triangle below it and none
//! above, except when triangles above the front have been added and the vertices that they cover have not yet left it.
//! So segments that change are listed, and checked when the step is complete.

use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::trace::Vertex;

/// A side, seen from the triangle to its left.
pub(super) type Side = [Vertex; 2];

#[derive(Debug, Default)]
pub(super) struct Mesh {
    opposite: BTreeMap<Side, Vertex>,
    /// Constrained sides, in both directions, which stay while no triangle borders on them.
    fixed: BTreeSet<Side>,
}

pub(super) fn sides([a, b, c]: [Vertex; 3]) -> [Side; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The side seen from the triangle on the other side.
pub(super) fn across([a, b]: Side) -> Side {
    [b, a]
}

impl Mesh {
    /// Whether there is a triangle to the left of the side.
    pub(super) fn has(&self, side: Side) -> bool {
        self.opposite.contains_key(&side)
    }

    pub(super) fn is_fixed(&self, side: Side) -> bool {
        self.fixed.contains(&side)
    }

    pub(super) fn fix(&mut self, side: Side) {
        self.fixed.extend([side, across(side)]);
    }

    /// Whether the side has triangles with these vertices to its left and right.
    pub(super) fn is_between(&self, side: Side, [left, right]: [Vertex; 2]) -> bool {
        self.opposite.get(&side) == Some(&left) && self.opposite.get(&across(side)) == Some(&right)
    }

    pub(super) fn add(&mut self, [a, b, c]: [Vertex; 3]) -> Result<(), String> {
        if a == b || b == c || c == a {
            return Err(format!("a vertex twice in triangle {a} {b} {c}"));
        }
        if let Some([a, b]) = sides([a, b, c]).into_iter().find(|&side| self.has(side)) {
            return Err(format!("side {a} {b} has its triangle already"));
        }
        self.opposite
            .extend([([a, b], c), ([b, c], a), ([c, a], b)]);
        Ok(())
    }

    pub(super) fn remove(&mut self, [a, b, c]: [Vertex; 3]) -> Result<(), String> {
        if self.opposite.get(&[a, b]) != Some(&c) {
            return Err(format!("there is no triangle {a} {b} {c}"));
        }
        for side in sides([a, b, c]) {
            self.opposite.remove(&side);
        }
        Ok(())
    }

    /// All triangles, each begun with its lowest vertex, in order.
    pub(super) fn triangles(&self) -> Vec<[Vertex; 3]> {
        let corners = self.opposite.iter().map(|(&[a, b], &c)| [a, b, c]);
        let mut list: Vec<_> = corners.filter(|&[a, b, c]| a < b && a < c).collect();
        list.sort_unstable();
        list
    }

    /// Checks that the triangles fill one simple polygon, with all vertices as corners and all constrained sides as
    /// sides. Triangles of which no two share a directed side are a surface with borders. If each vertex is on the
    /// border once at most, the border is one cycle, and Euler's formula for a disc holds, the surface is a disc.
    pub(super) fn check_disc(&self, vertices: &[Vertex]) -> Result<(), String> {
        if self.opposite.is_empty() {
            return Ok(());
        }
        // The sides on the border, by start: each vertex starts one at most.
        let on_border = self
            .opposite
            .keys()
            .filter(|&&side| !self.has(across(side)));
        let mut border: BTreeMap<Vertex, Vertex> = BTreeMap::new();
        for &[a, b] in on_border {
            if border.insert(a, b).is_some() {
                return Err(format!("the border passes vertex {a} twice"));
            }
        }

        // The length of the cycle through one border vertex.
        let start = *border.keys().min().ok_or("there is no border")?;
        let (mut length, mut at) = (1, border[&start]);
        while at != start {
            at = *border.get(&at).ok_or("the border is not closed")?;
            length += 1;
        }

        // All vertices are corners, the cycle is the whole border, and Euler's formula holds.
        let corners: BTreeSet<Vertex> = self.opposite.keys().map(|side| side[0]).collect();
        if let Some(v) = vertices.iter().find(|v| !corners.contains(v)) {
            return Err(format!("vertex {v} is no corner of a triangle"));
        }
        if length != border.len() || self.opposite.len() / 3 + 2 + length != 2 * vertices.len() {
            return Err("the triangles do not fill a polygon".to_owned());
        }
        let is_side = |&&side: &&Side| self.has(side) || self.has(across(side));
        match self.fixed.iter().find(|side| !is_side(side)) {
            Some([a, b]) => Err(format!("the fixed edge {a} {b} is no side")),
            None => Ok(()),
        }
    }
}

#[derive(Debug)]
pub(super) struct Front {
    next: BTreeMap<Vertex, Vertex>,
    prev: BTreeMap<Vertex, Vertex>,
    /// The left ends of segments that have changed or been covered.
    changed: Vec<Vertex>,
}

impl Front {
    /// The front from P-1 straight to P-2.
    pub(super) fn new() -> Front {
        Front {
            next: BTreeMap::from([(Vertex::Left, Vertex::Right)]),
            prev: BTreeMap::from([(Vertex::Right, Vertex::Left)]),
            changed: Vec::new(),
        }
    }

    fn next(&self, v: Vertex) -> Option<Vertex> {
        self.next.get(&v).copied()
    }

    pub(super) fn prev(&self, v: Vertex) -> Option<Vertex> {
        self.prev.get(&v).copied()
    }

    /// Whether the two vertices are a segment, left end first.
    pub(super) fn is_segment(&self, [left, right]: Side) -> bool {
        self.next(left) == Some(right)
    }

    /// Notes that there is a new triangle to the left of the side.
    pub(super) fn cover(&mut self, side: Side) {
        if self.is_segment(side) {
            self.changed.push(side[0]);
        }
    }

    pub(super) fn insert(&mut self, v: Vertex, after: Vertex) -> Result<(), String> {
        if self.prev.contains_key(&v) {
            return Err(format!("vertex {v} is on the front already"));
        }
        let right = self.next(after);
        let right = right.ok_or_else(|| format!("vertex {after} is not on the front"))?;
        self.link(after, v);
        self.link(v, right);
        Ok(())
    }

    pub(super) fn remove(&mut self, v: Vertex) -> Result<(), String> {
        let (Some(left), Some(right)) = (self.prev(v), self.next(v)) else {
            return Err(format!("vertex {v} is not inside the front"));
        };
        self.next.remove(&v);
        self.prev.remove(&v);
        self.link(left, right);
        Ok(())
    }

    fn link(&mut self, left: Vertex, right: Vertex) {
        self.next.insert(left, right);
        self.prev.insert(right, left);
        self.changed.push(left);
    }

    /// Checks the segments that have changed: a triangle below, none above.
    pub(super) fn settle(&mut self, mesh: &Mesh) -> Result<(), String> {
        for left in std::mem::take(&mut self.changed) {
            let Some(right) = self.next(left) else {
                continue;
            };
            if !mesh.has([right, left]) {
                return Err(format!("no triangle under front segment {left} {right}"));
            }
            if mesh.has([left, right]) {
                return Err(format!("a triangle above front segment {left} {right}"));
            }
        }
        Ok(())
    }
}
