//! The picture after a step.

use std::collections::BTreeSet;

use super::change::{Change, changes};
use crate::trace::{Event, PseudoPolygon, Vertex};

/// The state of the sweep, without any coordinate.
#[derive(Debug)]
pub(super) struct Scene {
    /// Triangles, each with its least vertex first.
    pub(super) triangles: BTreeSet<[Vertex; 3]>,
    /// The front, from P-1 to P-2.
    pub(super) front: Vec<Vertex>,
    pub(super) fixed: BTreeSet<[Vertex; 2]>,
    pub(super) sweep: Option<Vertex>,
    pub(super) is_swept: bool,
    /// The edge being inserted, and the triangles that it pierces.
    pub(super) edge: Option<[Vertex; 2]>,
    pub(super) pierced: Vec<[Vertex; 3]>,
    /// The borders of the upper and lower pseudo-polygon.
    pub(super) borders: [Vec<Vertex>; 2],
    /// What the last step changed.
    pub(super) step: Vec<Change>,
}

impl Scene {
    /// Before the first step.
    pub(super) fn new() -> Scene {
        Scene {
            triangles: BTreeSet::new(),
            front: vec![Vertex::Left, Vertex::Right],
            fixed: BTreeSet::new(),
            sweep: None,
            is_swept: false,
            edge: None,
            pierced: Vec::new(),
            borders: [Vec::new(), Vec::new()],
            step: Vec::new(),
        }
    }

    /// Applies the changes of an event.
    pub(super) fn advance(&mut self, event: &Event) {
        self.step = changes(event);
        for at in 0..self.step.len() {
            self.change(self.step[at]);
        }
    }

    /// The changes that rebuild this scene from an empty one.
    pub(super) fn changes_since_new(&self) -> Vec<Change> {
        let mut all = Vec::new();
        all.extend(self.triangles.iter().copied().map(Change::Add));
        let inner = self
            .front
            .windows(2)
            .filter(|pair| pair[1] != Vertex::Right);
        all.extend(inner.map(|pair| Change::Join(pair[1], pair[0])));
        all.extend(self.fixed.iter().copied().map(Change::Fix));
        all.extend(self.sweep.map(Change::Sweep));
        all.extend(self.is_swept.then_some(Change::Swept));
        all.extend(self.edge.map(Change::Edge));
        all.extend(self.pierced.iter().copied().map(Change::Pierce));
        let polygons = [PseudoPolygon::Upper, PseudoPolygon::Lower];
        for (polygon, border) in polygons.into_iter().zip(&self.borders) {
            all.extend(border.iter().map(|&vertex| Change::Border(polygon, vertex)));
        }
        all
    }

    fn change(&mut self, change: Change) {
        match change {
            Change::Sweep(vertex) => {
                self.sweep = Some(vertex);
                self.edge = None;
            }
            Change::Swept => (self.sweep, self.edge, self.is_swept) = (None, None, true),
            Change::End => self.front.clear(),
            Change::Add(corners) => {
                self.triangles.insert(from_least(corners));
            }
            Change::Remove(corners) => {
                self.triangles.remove(&from_least(corners));
            }
            Change::Pierce(corners) => {
                self.triangles.remove(&from_least(corners));
                self.pierced.push(corners);
            }
            Change::Join(vertex, after) => {
                if let Some(at) = self.front.iter().position(|&v| v == after) {
                    self.front.insert(at + 1, vertex);
                }
            }
            Change::Leave(vertex) => self.front.retain(|&v| v != vertex),
            Change::Edge(ends) => {
                self.edge = Some(ends);
                self.forget_polygons();
            }
            Change::Border(polygon, vertex) => self.borders[polygon as usize].push(vertex),
            Change::Fix(mut ends) => {
                ends.sort_unstable();
                self.fixed.insert(ends);
                self.forget_polygons();
            }
            Change::Vertex(_) | Change::Line(_) | Change::Gone(_) | Change::Test(..) => {}
        }
    }

    fn forget_polygons(&mut self) {
        self.pierced.clear();
        self.borders.iter_mut().for_each(Vec::clear);
    }
}

fn from_least(mut corners: [Vertex; 3]) -> [Vertex; 3] {
    let least = (0..3).min_by_key(|&corner| corners[corner]);
    corners.rotate_left(least.unwrap_or(0));
    corners
}
