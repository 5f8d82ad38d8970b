//! The rings of a polygon: exactly two edges end at each point.
//!
//! Why it is right: from a point with two edges a walk along the edges comes back to it. So such edges are closed rings,
//! whose points may still be equal, and whose edges may still touch or cross: the sweep finds that. Cost: O(n).

use alloc::vec::Vec;

use crate::ids::{VertexId, narrow};
use crate::sweep::vertices::Vertices;

/// The two neighbours of every vertex along its ring.
#[derive(Debug, Default)]
pub(super) struct Rings {
    /// The neighbours of each point, as input indices: first the one before it, then the one behind it, if each edge
    /// begins where another ends.
    of_points: Vec<[u32; 2]>,
    /// The rank of each point.
    ranks: Vec<u32>,
    /// The neighbours of each vertex, in the same order.
    of_vertices: Vec<[VertexId; 2]>,
}

const NONE: u32 = u32::MAX;

impl Rings {
    /// Takes the edges of these points. Returns whether two of them end at each point; where they are `directed`, one
    /// has to end there, and the other to begin.
    pub(super) fn set(&mut self, points: usize, edges: &[[usize; 2]], directed: bool) -> bool {
        if edges.len() != points {
            return false;
        }
        self.of_points.clear();
        self.of_points.resize(points, [NONE; 2]);
        for &[from, to] in edges {
            if from >= points || to >= points {
                return false;
            }
            for (point, neighbor, place) in [(from, to, 1), (to, from, 0)] {
                let places = &mut self.of_points[point];
                let is_free = [places[0] == NONE, places[1] == NONE];
                if is_free[place] {
                    places[place] = narrow(neighbor);
                } else if is_free[1 - place] && !directed {
                    places[1 - place] = narrow(neighbor);
                } else {
                    return false;
                }
            }
        }
        true
    }

    /// Numbers the points by rank; they are all different.
    pub(super) fn rank(&mut self, vertices: &Vertices) {
        vertices.rank(self.of_points.len(), &mut self.ranks);
        let neighbors = |&point: &u32| {
            let neighbors = self.of_points[point as usize];
            neighbors.map(|neighbor| VertexId::new(self.ranks[neighbor as usize]))
        };
        self.of_vertices.clear();
        self.of_vertices
            .extend(vertices.input.iter().map(neighbors));
    }

    /// The neighbours of a vertex.
    #[inline(always)]
    pub(super) fn neighbors(&self, v: VertexId) -> [VertexId; 2] {
        self.of_vertices[v.index()]
    }
}
