//! The advancing front of a replay: a doubly linked list by vertex.
//!
//! Every segment has a triangle below it and none above. That is not so for a moment, when triangles above
//! the front have been added and the vertices that they cover have not yet left it. So segments that
//! change are listed, and checked when the step is complete.

use std::collections::HashMap;

use super::super::Vertex;
use super::mesh::{Mesh, Side};

#[derive(Debug)]
pub(super) struct Front {
    next: HashMap<Vertex, Vertex>,
    prev: HashMap<Vertex, Vertex>,
    /// Left ends of segments that have changed or been covered.
    changed: Vec<Vertex>,
}

impl Front {
    /// From P-1 straight to P-2.
    pub(super) fn new() -> Front {
        Front {
            next: HashMap::from([(Vertex::Left, Vertex::Right)]),
            prev: HashMap::from([(Vertex::Right, Vertex::Left)]),
            changed: Vec::new(),
        }
    }

    /// The vertex after `v`, if `v` is on the front and not its end.
    pub(super) fn next(&self, v: Vertex) -> Option<Vertex> {
        self.next.get(&v).copied()
    }

    /// The vertex before `v`, if `v` is on the front and not its start.
    pub(super) fn prev(&self, v: Vertex) -> Option<Vertex> {
        self.prev.get(&v).copied()
    }

    /// Whether this is a segment, left end first.
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
