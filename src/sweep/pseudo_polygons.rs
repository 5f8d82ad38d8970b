//! Removes the triangles that an edge pierces and triangulates the two pseudo-polygons left and right
//! of it (section 3.4.2, figure 12).
//!
//! The border of a pseudo-polygon is a chain of open sides while its inside is made ([`super::fill`]),
//! and joined to what lies outside afterwards. A hanging edge, both of whose triangles were pierced,
//! is on the chain twice, once from either side: its two open sides are joined to each other.
//!
//! Why it is right: the new triangles are legalized among themselves; the border was legal and remains
//! so, because the edge only takes visibility away.
//!
//! Cost: O(k log k) for k pierced triangles, beyond the legalization.
//!
//! Differs from the paper: see [`super::fill`].

use std::cmp::Ordering;

use super::Sweep;
use super::fill::Corner;
use super::traverse::{Border, Spoke};
use crate::Scalar;
use crate::front::FrontSearch;
use crate::mesh::{Link, VertexId, next, prev};
use crate::probe::Probe;
use crate::trace::{Event, PseudoPolygon, Why};

/// The open sides around both pseudo-polygons, by number.
#[derive(Debug, Default)]
struct Seams {
    /// With what lies across.
    outer: Vec<(u32, Link)>,
    /// Hanging edges: the pierced triangle's side that it was, and the one across.
    hanging: Vec<(Link, Link, u32)>,
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Makes the part from `from` to `to`, which has just been traversed, a fixed side. Returns a
    /// triangle at either end, to the right of it.
    pub(super) fn retriangulate(&mut self, from: VertexId, to: VertexId) -> [Spoke; 2] {
        let open = self.mesh.open_sides();
        let traversal = std::mem::take(&mut self.traversal);
        self.predicates
            .probe
            .count(|c| c.pierced += traversal.pierced.len() as u64);
        for &t in &traversal.pierced {
            let vertices = [0, 1, 2].map(|i| self.mesh.get(t).vertex(i));
            self.tell(|name| Event::Pierced {
                vertices: vertices.map(name),
            });
            self.mesh.mark(t);
        }
        let mut seams = Seams::default();
        let mut right: Vec<Corner> = Vec::with_capacity(traversal.right.len() + 1);
        for &border in &traversal.right {
            let side = self.open_seam(border, &mut seams);
            right.push(Corner {
                vertex: border.0,
                side,
            });
        }
        right.push(Corner {
            vertex: to,
            side: 0,
        });
        let mut left: Vec<Corner> = Vec::with_capacity(traversal.left.len() + 1);
        // The left chain runs the other way, so that its inside is to its left too.
        let mut vertex = to;
        for &border in traversal.left.iter().rev() {
            let side = self.open_seam(border, &mut seams);
            left.push(Corner { vertex, side });
            vertex = border.0;
        }
        left.push(Corner {
            vertex: from,
            side: 0,
        });
        self.mesh.remove(&traversal.pierced);
        self.traversal = traversal;

        let (left_polygon, right_polygon) = match self.predicates.compare_x(from, to) {
            Ordering::Greater => (PseudoPolygon::Lower, PseudoPolygon::Upper),
            _ => (PseudoPolygon::Upper, PseudoPolygon::Lower),
        };
        for (chain, polygon) in [(&mut left, left_polygon), (&mut right, right_polygon)] {
            for corner in chain.iter() {
                self.tell(|name| Event::Border {
                    polygon,
                    vertex: name(corner.vertex),
                });
            }
            self.fill(chain, Why::PseudoPolygon);
            self.legalize();
            assert!(
                chain.len() == 2,
                "a pseudo-polygon is visible from its edge"
            );
        }
        self.close_seams(&mut seams);
        let link = self.mesh.open(right[0].side);
        self.mesh.connect(link.fix(), self.mesh.open(left[0].side));
        self.tell(|name| Event::Fixed {
            side: [from, to].map(name),
        });
        self.mesh.close(open);
        let [from, to] = [prev(link.corner()), next(link.corner())];
        [from, to].map(|corner| Spoke {
            triangle: link.triangle(),
            corner,
        })
    }

    /// Opens the side of a pierced triangle that borders on a pseudo-polygon.
    fn open_seam(&mut self, (_, inner): Border, seams: &mut Seams) -> u32 {
        let number = self.mesh.open_side();
        let outer = self.mesh.get(inner.triangle()).link(inner.corner());
        if !outer.is_open() && self.mesh.is_marked(outer.triangle()) {
            seams.hanging.push((inner, outer, number));
        } else {
            seams.outer.push((number, outer));
        }
        number
    }

    /// Joins the new triangles to what lies outside, or to each other across hanging edges.
    fn close_seams(&mut self, seams: &mut Seams) {
        for &(number, outer) in &seams.outer {
            self.mesh.connect(self.mesh.open(number), outer);
        }
        seams.hanging.sort_unstable_by_key(|&(inner, ..)| inner);
        for &(inner, outer, number) in &seams.hanging {
            // Each pair once, from its lower side.
            if inner < outer.unfixed() {
                let twin = seams
                    .hanging
                    .binary_search_by_key(&outer.unfixed(), |&(side, ..)| side);
                let (_, _, twin) = seams.hanging[twin.expect("a hanging edge has two sides")];
                self.mesh
                    .connect(self.mesh.open(number).fixed_as(outer), self.mesh.open(twin));
            }
        }
    }
}
