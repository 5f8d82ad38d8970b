//! Finalization (section 3.5, figure 15): the hull is completed and the artificial triangles go.
//!
//! The upper hull is one Graham pass over the front from its first to its last real node
//! ([`super::fill`]); those are the leftmost and the rightmost vertex, the upper ones of several. The
//! lower hull is there already: the artificial triangles around P-1 and then P-2 border on it, one side
//! each, and following them from P-1 to P-2 names its vertices. Then every triangle with an artificial
//! vertex is taken out, and ranks become input indices.
//!
//! Cost: O(h) orientation tests for h nodes of the front, O(n) to number the vertices.
//!
//! Differs from the paper: the lower hull (figures 15b and c) needs no pass, since edges to the
//! artificial points are legalized all along (see [`crate::predicates`]).

use super::Sweep;
use crate::front::FrontSearch;
use crate::mesh::{Link, Mesh, Triangle, index, next, prev};
use crate::probe::Probe;
use crate::trace::{Event, Why};
use crate::{Scalar, Triangulation};

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Completes the triangulation and hands it over.
    pub(super) fn finalize(mut self) -> (Triangulation, P) {
        self.tell(|_| Event::Finalization);
        let hull = self.complete_hull();
        let mesh = std::mem::replace(&mut self.mesh, Mesh::new(0, 0));
        let mut triangles = mesh.into_triangles();
        self.remove_artificial(&mut triangles);
        self.tell(|_| Event::Finished {
            triangles: index(triangles.len()),
        });

        let mut chains = self.chains;
        chains.split.sort_unstable();
        let result = Triangulation {
            hull: if triangles.is_empty() {
                Vec::new()
            } else {
                hull
            },
            triangles,
            duplicates: self.predicates.vertices.duplicates,
            chains,
        };
        (result, self.predicates.probe)
    }

    /// Fills the front up to the upper hull; returns all vertices on the hull, counter-clockwise from
    /// the leftmost, as input indices.
    fn complete_hull(&mut self) -> Vec<u32> {
        let (left, right) = (self.predicates.left, self.predicates.right);
        let (first, last) = (self.front.next(left), self.front.prev(right));
        if first == right {
            return Vec::new();
        }
        let added = self.fill_front(first, last, Why::Hull);
        self.predicates.probe.count(|c| c.hull_triangles += added);

        let input = &self.predicates.vertices.input;
        let mut hull = vec![input[first as usize]];
        // Around P-1 from the front down to P-2, then around P-2 up to the front.
        let mut link = self.mesh.open(left);
        let mut pivot = left;
        while !link.is_open() {
            let record = self.mesh.get(link.triangle());
            let v = record.vertex(link.corner());
            if v == right {
                pivot = right;
                link = record.link(prev(link.corner()));
            } else {
                hull.push(input[v as usize]);
                link = record.link(next(link.corner()));
            }
        }
        debug_assert!(pivot == right && link == Link::open(last));
        let mut at = self.front.prev(last);
        while at != first && at != left {
            hull.push(input[at as usize]);
            at = self.front.prev(at);
        }
        hull
    }

    /// Takes out the artificial triangles and turns ranks into input indices.
    fn remove_artificial(&mut self, triangles: &mut Vec<Triangle>) {
        let mut t = 0;
        while t < triangles.len() {
            let record = triangles[t];
            let vertices = [0, 1, 2].map(|i| record.vertex(i));
            let input = &self.predicates.vertices.input;
            if vertices.iter().all(|&v| !self.predicates.is_artificial(v)) {
                for i in 0..3 {
                    triangles[t].set_vertex(i, input[vertices[i as usize] as usize]);
                    if record.link(i).is_open() {
                        triangles[t].set_link(i, Link::open(0).fixed_as(record.link(i)));
                    }
                }
                t += 1;
                continue;
            }
            self.tell(|name| Event::Removed {
                vertices: vertices.map(name),
            });
            for i in 0..3 {
                relink(triangles, record.link(i), Link::open(0));
            }
            // The last one takes its place; it was not looked at yet.
            triangles.swap_remove(t);
            if let Some(&moved) = triangles.get(t) {
                for i in 0..3 {
                    relink(triangles, moved.link(i), Link::new(index(t), i));
                }
            }
        }
    }
}

/// Says what lies across the side that `link` leads to.
fn relink(triangles: &mut [Triangle], link: Link, target: Link) {
    if !link.is_open() {
        triangles[link.triangle() as usize].set_link(link.corner(), target.fixed_as(link));
    }
}
