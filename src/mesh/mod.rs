//! The triangles swept so far and how they hang together: topology only, no coordinate in sight.
//!
//! A triangle is three vertices in counter-clockwise order and three links; link `i` leads across the
//! side opposite vertex `i`. A [`Link`] names the triangle on the other side *and* the vertex of it
//! that lies opposite, in one number, so that the quadrilateral around a side is two reads. One bit of
//! it says that the side is fixed (a constrained edge, section 3.4.2), another that there is no
//! triangle yet: the side is *open*, a segment of the advancing front or of a pseudo-polygon. "Must
//! this side stay?" is then one comparison ([`Link::is_blocked`]).
//!
//! Invariants: if triangle `t` links across a side to `u`, then `u` links back to `t` across the same
//! side, and both carry the same fixed bit; an open side of number `k` is the one that
//! [`Mesh::open`]`(k)` leads to. [`Mesh::flip`] keeps them, moving four links.
//!
//! Cost: 32 bytes a triangle. The arrays have a fourth element so that an index masked to 0..=3 needs
//! no bounds check; the fourth vertex serves as a mark, the fourth link is never used.
//!
//! Differs from the paper: nothing; the paper leaves the structure open.

/// What lies across a side of a triangle: a triangle and its vertex opposite, or an open side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Link(u32);

/// Index of a triangle in its [`Mesh`].
pub(crate) type TriangleId = u32;
/// Rank of a vertex in the sweep order, or an artificial vertex after all of them.
pub(crate) type VertexId = u32;

/// The one place where a count or position becomes an index of 32 bits; the input's size was checked.
#[inline(always)]
pub(crate) fn index(n: usize) -> u32 {
    u32::try_from(n).expect("the input's size was checked")
}

const FIXED: u32 = 1 << 31;
const OPEN: u32 = 1 << 30;
const MARK: VertexId = VertexId::MAX;

impl Link {
    /// No triangle now or ever: the outside of the hull. Fixed and open, by a number that no side has.
    pub(crate) const OUTSIDE: Link = Link(u32::MAX);
    /// How many triangles a link can number; open sides have as many numbers.
    pub(crate) const LIMIT: usize = 1 << 28;

    pub(crate) fn new(triangle: TriangleId, corner: u32) -> Link {
        Link(triangle << 2 | corner)
    }

    pub(crate) fn open(number: u32) -> Link {
        Link(OPEN | number)
    }

    pub(crate) fn triangle(self) -> TriangleId {
        (self.0 & !FIXED) >> 2
    }

    /// The vertex (0, 1 or 2) opposite the side.
    pub(crate) fn corner(self) -> u32 {
        self.0 & 3
    }

    pub(crate) fn is_open(self) -> bool {
        self.0 & OPEN != 0
    }

    pub(crate) fn is_fixed(self) -> bool {
        self.0 & FIXED != 0
    }

    /// Open or fixed: the side cannot be flipped.
    pub(crate) fn is_blocked(self) -> bool {
        self.0 >= OPEN
    }

    /// The number of an open side.
    pub(crate) fn number(self) -> u32 {
        self.0 & (OPEN - 1)
    }

    pub(crate) fn fix(self) -> Link {
        Link(self.0 | FIXED)
    }

    /// This link, fixed if `other` is.
    pub(crate) fn fixed_as(self, other: Link) -> Link {
        Link(self.0 | other.0 & FIXED)
    }

    /// The same link, not fixed.
    pub(crate) fn unfixed(self) -> Link {
        Link(self.0 & !FIXED)
    }
}

/// The corner after `i`, counter-clockwise.
#[inline(always)]
pub(crate) fn next(i: u32) -> u32 {
    (0b00_10_01 >> (2 * (i & 3))) & 3
}

/// The corner before `i`, counter-clockwise.
#[inline(always)]
pub(crate) fn prev(i: u32) -> u32 {
    (0b01_00_10 >> (2 * (i & 3))) & 3
}

/// One record of the mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    vertices: [VertexId; 4],
    links: [Link; 4],
}

impl Triangle {
    fn new(v: [VertexId; 3], links: [Link; 3]) -> Triangle {
        Triangle {
            vertices: [v[0], v[1], v[2], 0],
            links: [links[0], links[1], links[2], Link::OUTSIDE],
        }
    }

    #[inline(always)]
    pub(crate) fn vertex(&self, corner: u32) -> VertexId {
        self.vertices[(corner & 3) as usize]
    }

    #[inline(always)]
    pub(crate) fn link(&self, corner: u32) -> Link {
        self.links[(corner & 3) as usize]
    }

    #[inline(always)]
    pub(crate) fn set_vertex(&mut self, corner: u32, vertex: VertexId) {
        self.vertices[(corner & 3) as usize] = vertex;
    }

    #[inline(always)]
    pub(crate) fn set_link(&mut self, corner: u32, link: Link) {
        self.links[(corner & 3) as usize] = link;
    }
}

/// The triangles and the open sides.
#[derive(Debug)]
pub(crate) struct Mesh {
    triangles: Vec<Triangle>,
    /// For each open side the triangle below it: side `v` of the advancing front starts at vertex `v`.
    open: Vec<Link>,
    /// Removed triangles, whose places are used again.
    removed: Vec<TriangleId>,
}

impl Mesh {
    /// An empty mesh with room for `triangles` and with `open` open sides that lead nowhere.
    pub(crate) fn new(triangles: usize, open: usize) -> Mesh {
        Mesh {
            triangles: Vec::with_capacity(triangles),
            open: vec![Link::OUTSIDE; open],
            removed: Vec::new(),
        }
    }

    #[inline(always)]
    pub(crate) fn get(&self, t: TriangleId) -> &Triangle {
        &self.triangles[t as usize]
    }

    /// The triangle below open side `number`, as seen from outside: its corner lies opposite the side.
    #[inline(always)]
    pub(crate) fn open(&self, number: u32) -> Link {
        self.open[number as usize]
    }

    /// The vertex opposite the side that `link` crosses.
    #[inline(always)]
    pub(crate) fn opposite(&self, link: Link) -> VertexId {
        self.get(link.triangle()).vertex(link.corner())
    }

    /// Says what lies across the side that `link` leads to; its fixed bit is that of `link`.
    #[inline(always)]
    fn relink(&mut self, link: Link, target: Link) {
        let target = target.unfixed().fixed_as(link);
        if link.is_open() {
            if link != Link::OUTSIDE {
                self.open[link.number() as usize] = target;
            }
        } else {
            self.triangles[link.triangle() as usize].set_link(link.corner(), target);
        }
    }

    /// Makes two sides neighbours, fixed if one of them is.
    #[inline(always)]
    pub(crate) fn connect(&mut self, a: Link, b: Link) {
        self.relink(a.fixed_as(b), b);
        self.relink(b.fixed_as(a), a);
    }

    /// Marks the side that `link` leads to as a constrained edge, on both sides of it.
    pub(crate) fn fix(&mut self, link: Link) {
        let across = self.get(link.triangle()).link(link.corner());
        self.connect(link.fix(), across);
    }

    /// Adds the triangle `v`, whose side opposite corner `i` borders on what `links[i]` names.
    #[inline(always)]
    pub(crate) fn add(&mut self, v: [VertexId; 3], links: [Link; 3]) -> TriangleId {
        let record = Triangle::new(v, links);
        let t = if let Some(t) = self.removed.pop() {
            self.triangles[t as usize] = record;
            t
        } else {
            self.triangles.push(record);
            index(self.triangles.len() - 1)
        };
        self.relink(links[0], Link::new(t, 0));
        self.relink(links[1], Link::new(t, 1));
        self.relink(links[2], Link::new(t, 2));
        t
    }

    /// Marks triangle `t` as one that is about to be removed.
    pub(crate) fn mark(&mut self, t: TriangleId) {
        self.triangles[t as usize].vertices[3] = MARK;
    }

    /// Whether `t` is marked; a new triangle never is.
    pub(crate) fn is_marked(&self, t: TriangleId) -> bool {
        self.triangles[t as usize].vertices[3] == MARK
    }

    /// Removes the triangles of `list`, whose places the next ones take.
    pub(crate) fn remove(&mut self, list: &[TriangleId]) {
        self.removed.extend_from_slice(list);
    }

    /// Swaps the diagonal of the quadrilateral around side `i` of triangle `t` (figure 3).
    ///
    /// ```text
    ///        p                 p            t = p a b becomes p a q, corner i stays p;
    ///      / i \             / | \           u = q b a becomes q b p, corner j stays q.
    ///     a-----b    ->    a  |  b         Sides a-q and b-p change hands.
    ///      \ j /             \ | /
    ///        q                 q
    /// ```
    ///
    /// Returns `u` as the link across side `i` that was.
    #[inline(always)]
    pub(crate) fn flip(&mut self, t: TriangleId, i: u32) -> Link {
        let upper = *self.get(t);
        let across = upper.link(i);
        let (u, j) = (across.triangle(), across.corner());
        let lower = *self.get(u);
        let (aq, bp) = (lower.link(next(j)), upper.link(next(i)));
        let record = &mut self.triangles[t as usize];
        record.set_vertex(prev(i), lower.vertex(j));
        record.set_link(i, aq);
        record.set_link(next(i), Link::new(u, next(j)));
        let record = &mut self.triangles[u as usize];
        record.set_vertex(prev(j), upper.vertex(i));
        record.set_link(j, bp);
        record.set_link(next(j), Link::new(t, next(i)));
        self.relink(aq, Link::new(t, i));
        self.relink(bp, Link::new(u, j));
        across
    }

    /// Opens a new side; closed again by [`Mesh::close`].
    pub(crate) fn open_side(&mut self) -> u32 {
        let number = index(self.open.len());
        self.open.push(Link::OUTSIDE);
        number
    }

    /// How many sides may be open now.
    pub(crate) fn open_sides(&self) -> usize {
        self.open.len()
    }

    /// Forgets the open sides from `number` on; nothing may border on them any more.
    pub(crate) fn close(&mut self, number: usize) {
        self.open.truncate(number);
    }

    /// Hands out the triangles.
    pub(crate) fn into_triangles(self) -> Vec<Triangle> {
        self.triangles
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.triangles.capacity() * size_of::<Triangle>() + self.open.capacity() * size_of::<Link>()
    }
}
