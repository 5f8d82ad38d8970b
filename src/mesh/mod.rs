//! The triangles made so far and their neighbours: topology only, without coordinates. A triangle is three vertices in
//! counter-clockwise order and, for each side `i`, opposite vertex `i`, the [`HalfEdge`] across. So two reads give the
//! quadrilateral around a side. Cost: 24 bytes a triangle.
//!
//! Invariants: twins name each other and carry the same constrained bit; the half-edge that [`Mesh::border_twin`] names
//! has the border half-edge for its twin. [`Mesh::flip`] and [`Mesh::flip_in_fan`] keep the invariants.

mod half_edge;
mod triangle;

pub(crate) use half_edge::{HalfEdge, next, prev};
pub(crate) use triangle::Triangle;

#[cfg(feature = "parallel")]
use crate::ids::narrow;
use crate::ids::{BorderId, TriangleId, VertexId};
use alloc::vec::Vec;

#[derive(Debug, Default)]
pub(crate) struct Mesh {
    triangles: Vec<Triangle>,
    /// For each border half-edge its twin, or [`HalfEdge::NO_TRIANGLE`].
    borders: Vec<HalfEdge>,
    /// Removed triangles, whose places are used again.
    removed: Vec<TriangleId>,
}

impl Mesh {
    /// Becomes an empty mesh with room for `triangles` triangles, and with `border` border half-edges without a twin.
    pub(crate) fn begin(&mut self, triangles: usize, border: usize) {
        self.clear();
        self.triangles.reserve_exact(triangles);
        self.reset_borders(border);
    }

    #[cfg(feature = "parallel")]
    pub(crate) fn reserve(&mut self, triangles: usize) {
        self.triangles.reserve_exact(triangles);
    }

    pub(crate) fn clear(&mut self) {
        self.triangles.clear();
        self.removed.clear();
    }

    /// How many places of triangles there are, those of removed ones included.
    pub(crate) fn len(&self) -> usize {
        self.triangles.len()
    }

    #[inline(always)]
    pub(crate) fn get(&self, t: TriangleId) -> &Triangle {
        &self.triangles[t.index()]
    }

    #[inline(always)]
    pub(crate) fn twin(&self, side: HalfEdge) -> HalfEdge {
        self.get(side.triangle()).twin(side.corner())
    }

    #[inline(always)]
    pub(crate) fn opposite(&self, side: HalfEdge) -> VertexId {
        self.get(side.triangle()).vertex(side.corner())
    }

    /// The vertex opposite a half-edge, and its two ends: the triangle, counter-clockwise.
    #[inline(always)]
    pub(crate) fn around(&self, side: HalfEdge) -> [VertexId; 3] {
        self.get(side.triangle()).vertices_from(side.corner())
    }

    pub(crate) fn set_opposite(&mut self, side: HalfEdge, v: VertexId) {
        self.triangles[side.triangle().index()].set_vertex(side.corner(), v);
    }

    /// Removes the twin of a half-edge.
    pub(crate) fn detach(&mut self, side: HalfEdge) {
        self.triangles[side.triangle().index()].set_twin(side.corner(), HalfEdge::NOTHING);
    }

    /// The half-edge of the triangle below a border half-edge.
    #[inline(always)]
    pub(crate) fn border_twin(&self, border: BorderId) -> HalfEdge {
        self.borders[border.index()]
    }

    #[inline(always)]
    pub(crate) fn has_border_twin(&self, border: BorderId) -> bool {
        self.border_twin(border) != HalfEdge::NO_TRIANGLE
    }

    /// Sets the twin of `side`, constrained if `side` is.
    #[inline(always)]
    fn relink(&mut self, side: HalfEdge, twin: HalfEdge) {
        let twin = twin.unconstrained().constrained_as(side);
        if side.is_border() {
            if side != HalfEdge::NOTHING {
                self.borders[side.border_id().index()] = twin;
            }
        } else {
            self.triangles[side.triangle().index()].set_twin(side.corner(), twin);
        }
    }

    /// Makes two half-edges twins, constrained if one of them is.
    #[inline(always)]
    pub(crate) fn connect(&mut self, a: HalfEdge, b: HalfEdge) {
        self.relink(a.constrained_as(b), b);
        self.relink(b.constrained_as(a), a);
    }

    /// Puts the hull of a result across the side below a border half-edge.
    pub(crate) fn close(&mut self, border: BorderId) {
        let side = self.border_twin(border);
        self.relink(side, HalfEdge::HULL);
    }

    /// Marks a side as a constrained edge, in both half-edges.
    #[inline(always)]
    pub(crate) fn constrain(&mut self, side: HalfEdge) {
        self.connect(side.constrain(), self.twin(side));
    }

    /// Adds the triangle `v`; its side opposite corner `i` has the twin `twins[i]`.
    #[inline(always)]
    pub(crate) fn add(&mut self, v: [VertexId; 3], twins: [HalfEdge; 3]) -> TriangleId {
        let record = Triangle::new(v, twins);
        let t = if let Some(t) = self.removed.pop() {
            self.triangles[t.index()] = record;
            t
        } else {
            self.triangles.push(record);
            TriangleId::at(self.triangles.len() - 1)
        };
        self.relink(twins[0], HalfEdge::new(t, 0));
        self.relink(twins[1], HalfEdge::new(t, 1));
        self.relink(twins[2], HalfEdge::new(t, 2));
        t
    }

    /// Removes a triangle that nothing borders on any more.
    pub(crate) fn retire(&mut self, t: TriangleId) {
        self.triangles[t.index()] = Triangle::RETIRED;
        self.removed.push(t);
    }

    pub(crate) fn unused(&self) -> &[TriangleId] {
        &self.removed
    }

    /// Removes the triangles of `list`. New triangles take their places.
    pub(crate) fn remove(&mut self, list: &[TriangleId]) {
        self.removed.extend_from_slice(list);
    }

    /// Swaps the diagonal of the quadrilateral around a side of triangle `t` (figure 3).
    ///
    /// ```text
    ///        p                 p            t = p a b becomes p a q, corner i stays p;
    ///      / i \             / | \           u = q b a becomes q b p, corner j stays q.
    ///     a-----b    ->    a  |  b         Sides a-q and b-p change hands.
    ///      \ j /             \ | /
    ///        q                 q
    /// ```
    ///
    /// Returns the old twin of the side: side `j` of `u`.
    #[inline(always)]
    pub(crate) fn flip(&mut self, side: HalfEdge) -> HalfEdge {
        let (t, i) = (side.triangle(), side.corner());
        let upper = self.get(t);
        let (p, twin, bp) = (upper.vertex(i), upper.twin(i), upper.twin(next(i)));
        let (u, j) = (twin.triangle(), twin.corner());
        let lower = self.get(u);
        let (q, aq) = (lower.vertex(j), lower.twin(next(j)));
        let record = &mut self.triangles[t.index()];
        record.set_vertex(prev(i), q);
        record.set_twin(i, aq);
        record.set_twin(next(i), HalfEdge::new(u, next(j)));
        let record = &mut self.triangles[u.index()];
        record.set_vertex(prev(j), p);
        record.set_twin(j, bp);
        record.set_twin(next(j), HalfEdge::new(t, next(i)));
        self.relink(aq, HalfEdge::new(t, i));
        self.relink(bp, HalfEdge::new(u, j));
        twin
    }

    /// Swaps side 0 of `t`, whose corner 0 is the vertex of a fan, and afterwards corner 0 of both triangles.
    ///
    /// ```text
    ///        p                 p            t = p a b becomes p a q, u = q b a becomes p q b.
    ///      / 0 \             / | \           Sides a-q, q-b and b-p change hands.
    ///     a-----b    ->    a  |  b
    ///      \ j /             \ | /
    ///        q                 q
    /// ```
    ///
    /// Returns the old twin of the side, and the ends of the new side.
    #[inline(always)]
    pub(crate) fn flip_in_fan(&mut self, t: TriangleId) -> (HalfEdge, [VertexId; 2]) {
        let upper = self.get(t);
        let twin = upper.twin(0);
        let (p, b, bp) = (upper.vertex(0), upper.vertex(2), upper.twin(1));
        let (u, j) = (twin.triangle(), twin.corner());
        let record = &mut self.triangles[u.index()];
        let (q, aq, qb) = (record.vertex(j), record.twin(next(j)), record.twin(prev(j)));
        *record = Triangle::new([p, q, b], [qb, bp, HalfEdge::new(t, 1)]);
        let record = &mut self.triangles[t.index()];
        record.set_vertex(2, q);
        record.set_twin(0, aq);
        record.set_twin(1, HalfEdge::new(u, 2));
        self.relink(aq, HalfEdge::new(t, 0));
        self.relink(qb, HalfEdge::new(u, 0));
        self.relink(bp, HalfEdge::new(u, 1));
        (twin, [p, q])
    }

    /// Makes a new border half-edge, on which no triangle borders yet; [`Mesh::truncate_borders`] removes it.
    pub(crate) fn add_border(&mut self) -> BorderId {
        self.add_border_to(HalfEdge::NO_TRIANGLE)
    }

    /// Makes a new border half-edge with this twin, which is no side of a triangle yet.
    #[inline(always)]
    pub(crate) fn add_border_to(&mut self, twin: HalfEdge) -> BorderId {
        let border = BorderId::at(self.borders.len());
        self.borders.push(twin);
        border
    }

    pub(crate) fn reserve_borders(&mut self, more: usize) {
        self.borders.reserve(more);
    }

    pub(crate) fn border_count(&self) -> usize {
        self.borders.len()
    }

    /// Forgets all border half-edges but the first `kept`; nothing may border on the others any more.
    pub(crate) fn truncate_borders(&mut self, kept: usize) {
        self.borders.truncate(kept);
    }

    /// Adds the triangles of another mesh, on all threads, after those here; their vertices are numbered higher by
    /// `vertices`. None may have a border half-edge other than nothing for a twin.
    #[cfg(feature = "parallel")]
    pub(crate) fn append(&mut self, other: &Mesh, vertices: u32) {
        use rayon::prelude::*;
        let before = narrow(self.len());
        let removed = other.removed.iter();
        self.removed
            .extend(removed.map(|t| TriangleId::new(t.number() + before)));
        let others = other.triangles.par_iter();
        self.triangles
            .par_extend(others.map(|record| record.moved(vertices, before)));
    }

    /// Forgets the border half-edges, on which nothing may border, and makes `border` new ones.
    pub(crate) fn reset_borders(&mut self, border: usize) {
        self.borders.clear();
        self.borders.resize(border, HalfEdge::NO_TRIANGLE);
    }

    pub(crate) fn take_triangles(&mut self) -> Vec<Triangle> {
        core::mem::take(&mut self.triangles)
    }

    /// Uses the memory of `triangles` for new triangles.
    pub(crate) fn reuse(&mut self, triangles: Vec<Triangle>) {
        self.triangles = triangles;
        self.clear();
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        self.triangles.capacity() * size_of::<Triangle>()
            + self.borders.capacity() * size_of::<HalfEdge>()
    }
}
