//! The mesh of a replay: for each directed side of a triangle the vertex opposite.
//!
//! No side can belong to two triangles on the same side of it, so a triangle is there if one of its
//! directed sides leads to its third vertex, and the mesh needs neither numbers nor links.

use std::collections::{HashMap, HashSet};

use super::super::Vertex;

/// A side, seen from the triangle to its left.
pub(super) type Side = [Vertex; 2];

#[derive(Debug, Default)]
pub(super) struct Mesh {
    opposite: HashMap<Side, Vertex>,
    /// Constrained sides, in both directions; they stay fixed while no triangle borders on them.
    fixed: HashSet<Side>,
}

/// The sides of a triangle.
pub(super) fn sides([a, b, c]: [Vertex; 3]) -> [Side; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The same side from across.
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

    /// Checks that the triangles fill one simple polygon with these vertices as corners and all fixed
    /// sides as sides.
    ///
    /// A set of triangles without a side in common on the same side of it is a surface with borders.
    /// If each vertex is on the border once at most, the border is one cycle, and Euler's formula for a
    /// disc holds, it is a disc.
    pub(super) fn check_disc(&self, vertices: &[Vertex]) -> Result<(), String> {
        if self.opposite.is_empty() {
            return Ok(());
        }
        // The sides on the border, by start: each vertex starts one at most.
        let on_border = self
            .opposite
            .keys()
            .filter(|&&side| !self.has(across(side)));
        let mut border: HashMap<Vertex, Vertex> = HashMap::new();
        for &[a, b] in on_border {
            if border.insert(a, b).is_some() {
                return Err(format!("the border passes vertex {a} twice"));
            }
        }

        // The length of the cycle through one of them.
        let start = *border.keys().min().ok_or("there is no border")?;
        let (mut length, mut at) = (1, border[&start]);
        while at != start {
            at = *border.get(&at).ok_or("the border is not closed")?;
            length += 1;
        }

        // All vertices are corners, the cycle is the whole border, and Euler's formula holds.
        let corners: HashSet<Vertex> = self.opposite.keys().map(|side| side[0]).collect();
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
