//! Pseudo-polygons (section 3.4.2, figure 12): the triangles that an edge pierces are removed, and the two polygons
//! left and right of it are triangulated. If only two triangles are pierced, their common side is swapped.
//!
//! ```text
//!            from                 The edge runs from `from` down to `to` (dotted). Seen along it, the
//!          /  :  \                chain of r1 and r2 is on the right, that of l1, l2 and h on the left.
//!        r1   :   l2              A chain has its inside to its left: the right one runs down, from,
//!         |   :    |              r1, r2, to; the left one runs up, to, l1, h, l1, l2, from.
//!         | R : L  |              [`super::fill`] fills R and L up to the edge. Then the new triangles
//!         |   : h  |              are joined to those outside.
//!         |   :  \ |
//!        r2   :   l1              l1-h is a *hanging edge*: the triangles on both sides of it were
//!          \  :  /                pierced. The left chain passes it twice, once on each side, and the
//!            to                   two border half-edges are joined to each other.
//! ```
//!
//! Why it is right: the new triangles are legalized among themselves. The sides on the border were legal and remain so,
//! because the edge blocks views and opens none. Cost: O(k log k) for k pierced triangles, beyond the filling.
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::mem::take;

use super::Delaunay;
use super::fill::ChainVertex;
use crate::ids::{BorderId, TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::sweep::traversal::Traversed;
use crate::trace::{Event, PseudoPolygon, Why};

#[derive(Debug, Default)]
pub(in crate::sweep) struct Polygons {
    right: PseudoPolygonChain,
    left: PseudoPolygonChain,
    seams: Seams,
}

/// The chain of a pseudo-polygon, from one end of the edge to the other, with the inside to its left.
#[derive(Debug, Default)]
pub(super) struct PseudoPolygonChain {
    pub(super) corners: Vec<ChainVertex>,
    /// For each corner but the last, a vertex across the edge that shared a pierced triangle with it. Unless the corner is
    /// an end of the edge, the edge pierced the side between the two.
    pub(super) beyond: Vec<VertexId>,
}

/// The border half-edges of both pseudo-polygons, and the sides to which they will be joined.
#[derive(Debug, Default)]
struct Seams {
    /// The pierced triangles, ascending.
    pierced: Vec<TriangleId>,
    /// Each border half-edge with its twin outside.
    outer: Vec<(BorderId, HalfEdge)>,
    /// Hanging edges: the pierced triangle's side, its twin, and the border half-edge in its place.
    hanging: Vec<(HalfEdge, HalfEdge, BorderId)>,
}

impl Seams {
    /// Begins with these pierced triangles, whose records are needed until all border half-edges are made.
    fn begin(&mut self, pierced: &[TriangleId]) {
        self.pierced.clear();
        self.pierced.extend_from_slice(pierced);
        self.pierced.sort_unstable();
        self.outer.clear();
        self.hanging.clear();
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Makes the part just traversed a side. Returns the side opposite `from` of the triangle on its right.
    pub(in crate::sweep) fn replace_pierced(
        &mut self,
        from: VertexId,
        to: VertexId,
        traversed: &Traversed,
    ) -> HalfEdge {
        self.note_pierced(&traversed.pierced);
        // An edge that runs down to the left has the upper pseudo-polygon on its right.
        let polygons = match self.predicates.compare_x(from, to) {
            Ordering::Greater => [PseudoPolygon::Lower, PseudoPolygon::Upper],
            _ => [PseudoPolygon::Upper, PseudoPolygon::Lower],
        };
        let [left, right] = if traversed.pierced.len() == 2 {
            self.replace_two([from, to], polygons, traversed)
        } else {
            self.replace_many([from, to], polygons, traversed)
        };
        self.mesh.connect(right.constrain(), left);
        self.report(|name| Event::Fixed {
            side: [from, to].map(name),
        });
        self.flip_limit.reset();
        right.prev()
    }

    /// Reports and counts the pierced triangles.
    fn note_pierced(&mut self, pierced: &[TriangleId]) {
        self.probe.count(|c| c.pierced += pierced.len() as u64);
        for &t in pierced {
            let vertices = self.mesh.get(t).vertices();
            self.report(|name| Event::Pierced {
                vertices: vertices.map(name),
            });
        }
    }

    /// Replaces two triangles. Returns the two sides at the edge, left and right.
    fn replace_two(
        &mut self,
        [from, to]: [VertexId; 2],
        polygons: [PseudoPolygon; 2],
        traversed: &Traversed,
    ) -> [HalfEdge; 2] {
        // As in the chains: from one end over the vertex beside the edge to the other.
        let left = [traversed.left[1], traversed.left[0]];
        let right = [traversed.right[0], traversed.right[1]];
        let new = [(to, left, from), (from, right, to)].map(|(first, sides, last)| {
            let [_, beside, _] = self.mesh.around(sides[1]);
            let [before, after] = sides.map(|side| self.mesh.twin(side));
            ([first, beside, last], [HalfEdge::NOTHING, before, after])
        });
        self.mesh.remove(&traversed.pierced);
        let [left, right] = new;
        [(left, polygons[0]), (right, polygons[1])].map(|((corners, twin), polygon)| {
            self.report_border(polygon, corners);
            self.flip_limit.grant_for_chain(corners.len());
            let [first, beside, last] = corners;
            let t = self.add_triangle([beside, last, first], twin, Why::PseudoPolygon);
            HalfEdge::new(t, 0)
        })
    }

    /// Replaces any number of triangles. Returns the two sides at the edge, left and right.
    fn replace_many(
        &mut self,
        [from, to]: [VertexId; 2],
        [left_polygon, right_polygon]: [PseudoPolygon; 2],
        traversed: &Traversed,
    ) -> [HalfEdge; 2] {
        let kept = self.mesh.border_count();
        let mut polygons = take(self.polygons);
        let Polygons { right, left, seams } = &mut polygons;
        seams.begin(&traversed.pierced);
        self.border(right, traversed.right.iter(), to, seams);
        // The left chain runs the other way, so that its inside is to its left too.
        self.border(left, traversed.left.iter().rev(), from, seams);
        self.mesh.remove(&traversed.pierced);

        self.fill_polygon(left, left_polygon);
        self.fill_polygon(right, right_polygon);
        self.close_seams(seams);
        let sides = [left, right].map(|chain| self.mesh.border_twin(chain.corners[0].border));
        *self.polygons = polygons;
        self.mesh.truncate_borders(kept);
        sides
    }

    /// Replaces the given sides of pierced triangles by border half-edges: a `chain` that ends at `last`.
    fn border<'s>(
        &mut self,
        PseudoPolygonChain { corners, beyond }: &mut PseudoPolygonChain,
        sides: impl Iterator<Item = &'s HalfEdge>,
        last: VertexId,
        seams: &mut Seams,
    ) {
        corners.clear();
        beyond.clear();
        for &side in sides {
            let [opposite, vertex, _] = self.mesh.around(side);
            let border = self.add_border_of(side, seams);
            corners.push(ChainVertex { vertex, border });
            beyond.push(opposite);
        }
        corners.push(ChainVertex {
            vertex: last,
            border: BorderId::new(0),
        });
    }

    /// Fills a pseudo-polygon. Of its chain only the part of the edge is left.
    fn fill_polygon(&mut self, chain: &mut PseudoPolygonChain, polygon: PseudoPolygon) {
        self.report_border(polygon, chain.corners.iter().map(|corner| corner.vertex));
        if !self.fill_in_random_order(chain) {
            self.fill(&mut chain.corners, Why::PseudoPolygon);
        }
        self.legalize();
        assert!(
            chain.corners.len() == 2,
            "a pseudo-polygon is visible from its edge"
        );
    }

    fn report_border(
        &mut self,
        polygon: PseudoPolygon,
        vertices: impl IntoIterator<Item = VertexId>,
    ) {
        if self.is_observed() {
            for vertex in vertices {
                self.report(|name| Event::Border {
                    polygon,
                    vertex: name(vertex),
                });
            }
        }
    }

    /// Makes a border half-edge for a side of a pierced triangle that borders on a pseudo-polygon.
    fn add_border_of(&mut self, inner: HalfEdge, seams: &mut Seams) -> BorderId {
        let border = self.mesh.add_border();
        let outer = self.mesh.twin(inner);
        if !outer.is_border() && seams.pierced.binary_search(&outer.triangle()).is_ok() {
            seams.hanging.push((inner, outer, border));
        } else {
            seams.outer.push((border, outer));
        }
        border
    }

    /// Joins the new triangles to their neighbours outside, or to each other across hanging edges.
    fn close_seams(&mut self, seams: &mut Seams) {
        for &(border, outer) in &seams.outer {
            self.mesh.connect(self.mesh.border_twin(border), outer);
        }
        seams.hanging.sort_unstable_by_key(|&(inner, ..)| inner);
        for &(inner, outer, border) in &seams.hanging {
            // Each pair once, from its lower side.
            if inner < outer.unconstrained() {
                let twin = seams
                    .hanging
                    .binary_search_by_key(&outer.unconstrained(), |&(side, ..)| side);
                let (_, _, twin) = seams.hanging[twin.expect("a hanging edge has two sides")];
                let side = self.mesh.border_twin(border).constrained_as(outer);
                self.mesh.connect(side, self.mesh.border_twin(twin));
            }
        }
    }
}
