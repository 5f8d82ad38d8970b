//! The triangles made so far and their neighbours: topology only, without any coordinates.
//!
//! A triangle is three vertices in counter-clockwise order; across its side `i`, opposite vertex `i`, it
//! names the neighbour's side. That [`Side`] is a half-edge: a triangle and the corner opposite. So two
//! reads give the quadrilateral around a side.
//!
//! Invariants: neighbours name each other. If the side of `u` lies across a side of `t`, then the side of
//! `t` lies across that of `u`, and both carry the same fixed bit. Likewise the side that [`Mesh::below`]
//! names has the open side across it. [`Mesh::flip`] and [`Mesh::flip_in_fan`] keep these invariants.
//!
//! Cost: 24 bytes a triangle.
//!
//! No differences: the paper leaves the structure open.

mod side;
mod triangle;

pub(crate) use side::{Side, next, prev};
pub(crate) use triangle::Triangle;

#[cfg(feature = "parallel")]
use crate::ids::narrow;
use crate::ids::{OpenId, TriangleId, VertexId};

/// The triangles and the open sides.
#[derive(Debug, Default)]
pub(crate) struct Mesh {
    triangles: Vec<Triangle>,
    /// For each open side the triangle's side below it, or [`Side::NO_TRIANGLE`].
    open: Vec<Side>,
    /// Removed triangles, whose places are used again.
    removed: Vec<TriangleId>,
}

impl Mesh {
    /// Becomes an empty mesh with room for `triangles` and with `open` open sides that border on no triangle.
    pub(crate) fn begin(&mut self, triangles: usize, open: usize) {
        self.clear();
        self.triangles.reserve_exact(triangles);
        self.renew_open(open);
    }

    /// Makes room for so many more triangles.
    #[cfg(feature = "parallel")]
    pub(crate) fn reserve(&mut self, triangles: usize) {
        self.triangles.reserve_exact(triangles);
    }

    /// Removes all triangles.
    pub(crate) fn clear(&mut self) {
        self.triangles.clear();
        self.removed.clear();
    }

    /// How many places of triangles there are, removed ones included.
    pub(crate) fn len(&self) -> usize {
        self.triangles.len()
    }

    #[inline(always)]
    pub(crate) fn get(&self, t: TriangleId) -> &Triangle {
        &self.triangles[t.index()]
    }

    /// What lies across a side of a triangle.
    #[inline(always)]
    pub(crate) fn across(&self, side: Side) -> Side {
        self.get(side.triangle()).across(side.corner())
    }

    /// The vertex opposite a side of a triangle.
    #[inline(always)]
    pub(crate) fn opposite(&self, side: Side) -> VertexId {
        self.get(side.triangle()).vertex(side.corner())
    }

    /// The vertex opposite a side, and the two ends of the side: the triangle, counter-clockwise.
    #[inline(always)]
    pub(crate) fn around(&self, side: Side) -> [VertexId; 3] {
        self.get(side.triangle()).vertices_from(side.corner())
    }

    /// Replaces the vertex opposite a side.
    pub(crate) fn set_opposite(&mut self, side: Side, v: VertexId) {
        self.triangles[side.triangle().index()].set_vertex(side.corner(), v);
    }

    /// Puts nothing across a side of a triangle.
    pub(crate) fn detach(&mut self, side: Side) {
        self.triangles[side.triangle().index()].set_across(side.corner(), Side::NOTHING);
    }

    /// The side of the triangle below an open side.
    #[inline(always)]
    pub(crate) fn below(&self, open: OpenId) -> Side {
        self.open[open.index()]
    }

    /// Whether a triangle borders on an open side.
    #[inline(always)]
    pub(crate) fn has_below(&self, open: OpenId) -> bool {
        self.below(open) != Side::NO_TRIANGLE
    }

    /// Sets what lies across `side`, fixed if `side` is.
    #[inline(always)]
    fn relink(&mut self, side: Side, across: Side) {
        let across = across.unfixed().fixed_as(side);
        if side.is_open() {
            if side != Side::NOTHING {
                self.open[side.open_id().index()] = across;
            }
        } else {
            self.triangles[side.triangle().index()].set_across(side.corner(), across);
        }
    }

    /// Makes two sides neighbours, fixed if one of them is.
    #[inline(always)]
    pub(crate) fn connect(&mut self, a: Side, b: Side) {
        self.relink(a.fixed_as(b), b);
        self.relink(b.fixed_as(a), a);
    }

    /// Puts the hull of a result across the side below an open side.
    pub(crate) fn close(&mut self, open: OpenId) {
        let side = self.below(open);
        self.relink(side, Side::HULL);
    }

    /// Marks a side of a triangle as a constrained edge, from both sides of it.
    #[inline(always)]
    pub(crate) fn fix(&mut self, side: Side) {
        self.connect(side.fix(), self.across(side));
    }

    /// Adds the triangle `v`; across its side opposite corner `i` lies `across[i]`.
    #[inline(always)]
    pub(crate) fn add(&mut self, v: [VertexId; 3], across: [Side; 3]) -> TriangleId {
        let record = Triangle::new(v, across);
        let t = if let Some(t) = self.removed.pop() {
            self.triangles[t.index()] = record;
            t
        } else {
            self.triangles.push(record);
            TriangleId::at(self.triangles.len() - 1)
        };
        self.relink(across[0], Side::new(t, 0));
        self.relink(across[1], Side::new(t, 1));
        self.relink(across[2], Side::new(t, 2));
        t
    }

    /// Removes a triangle that nothing borders on any more.
    pub(crate) fn retire(&mut self, t: TriangleId) {
        self.triangles[t.index()] = Triangle::RETIRED;
        self.removed.push(t);
    }

    /// The places of removed triangles that are not in use.
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
    /// Returns the side across which `t` lay: side `j` of `u`.
    #[inline(always)]
    pub(crate) fn flip(&mut self, side: Side) -> Side {
        let (t, i) = (side.triangle(), side.corner());
        let upper = self.get(t);
        let (p, across, bp) = (upper.vertex(i), upper.across(i), upper.across(next(i)));
        let (u, j) = (across.triangle(), across.corner());
        let lower = self.get(u);
        let (q, aq) = (lower.vertex(j), lower.across(next(j)));
        let record = &mut self.triangles[t.index()];
        record.set_vertex(prev(i), q);
        record.set_across(i, aq);
        record.set_across(next(i), Side::new(u, next(j)));
        let record = &mut self.triangles[u.index()];
        record.set_vertex(prev(j), p);
        record.set_across(j, bp);
        record.set_across(next(j), Side::new(t, next(i)));
        self.relink(aq, Side::new(t, i));
        self.relink(bp, Side::new(u, j));
        across
    }

    /// Swaps side 0 of `t`, whose corner 0 is the vertex of a fan. Both triangles have it for corner 0 afterwards.
    ///
    /// ```text
    ///        p                 p            t = p a b becomes p a q, u = q b a becomes p q b.
    ///      / 0 \             / | \           Sides a-q, q-b and b-p change hands.
    ///     a-----b    ->    a  |  b
    ///      \ j /             \ | /
    ///        q                 q
    /// ```
    ///
    /// Returns the side across which `t` lay, and the ends of the new side.
    #[inline(always)]
    pub(crate) fn flip_in_fan(&mut self, t: TriangleId) -> (Side, [VertexId; 2]) {
        let upper = self.get(t);
        let across = upper.across(0);
        let (p, b, bp) = (upper.vertex(0), upper.vertex(2), upper.across(1));
        let (u, j) = (across.triangle(), across.corner());
        let record = &mut self.triangles[u.index()];
        let (q, aq, qb) = (
            record.vertex(j),
            record.across(next(j)),
            record.across(prev(j)),
        );
        *record = Triangle::new([p, q, b], [qb, bp, Side::new(t, 1)]);
        let record = &mut self.triangles[t.index()];
        record.set_vertex(2, q);
        record.set_across(0, aq);
        record.set_across(1, Side::new(u, 2));
        self.relink(aq, Side::new(t, 0));
        self.relink(qb, Side::new(u, 0));
        self.relink(bp, Side::new(u, 1));
        (across, [p, q])
    }

    /// Makes a new open side, on which no triangle borders yet; [`Mesh::forget_open`] removes it.
    pub(crate) fn add_open(&mut self) -> OpenId {
        let open = OpenId::at(self.open.len());
        self.open.push(Side::NO_TRIANGLE);
        open
    }

    /// Makes room for so many new open sides.
    pub(crate) fn reserve_open(&mut self, more: usize) {
        self.open.reserve(more);
    }

    /// How many open sides there are.
    pub(crate) fn count_open(&self) -> usize {
        self.open.len()
    }

    /// Forgets all open sides but the first `kept`; nothing may border on the others any more.
    pub(crate) fn forget_open(&mut self, kept: usize) {
        self.open.truncate(kept);
    }

    /// Adds the triangles of another mesh, none of which borders on an open side other than nothing. Its
    /// vertices are numbered higher by so much; its triangles follow those here. Runs on all threads.
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

    /// Forgets the open sides, on which nothing may border, and makes so many new ones.
    pub(crate) fn renew_open(&mut self, open: usize) {
        self.open.clear();
        self.open.resize(open, Side::NO_TRIANGLE);
    }

    /// Hands out the triangles, and is empty afterwards.
    pub(crate) fn take_triangles(&mut self) -> Vec<Triangle> {
        std::mem::take(&mut self.triangles)
    }

    /// Takes the memory of these triangles for those to come.
    pub(crate) fn reuse(&mut self, triangles: Vec<Triangle>) {
        self.triangles = triangles;
        self.clear();
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.triangles.capacity() * size_of::<Triangle>() + self.open.capacity() * size_of::<Side>()
    }
}
