//! One record of the mesh: three vertices and what lies across the three sides, in 32 bytes.
//!
//! The arrays have a fourth element so that an index masked to 0..=3 needs no bounds check. The fourth
//! vertex serves as a mark; the fourth side is never used.

use super::side::Side;
use crate::ids::VertexId;

/// In the place of the fourth vertex: the triangle is about to be removed.
const MARK: VertexId = VertexId::new(u32::MAX);

/// Three vertices, counter-clockwise, and across side `i`, opposite vertex `i`, the neighbour's side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    vertices: [VertexId; 4],
    across: [Side; 4],
}

impl Triangle {
    /// A triangle that stands for none: its vertices have a number above all others.
    pub(super) const RETIRED: Triangle = Triangle {
        vertices: [VertexId::new(u32::MAX); 4],
        across: [Side::NOTHING; 4],
    };

    pub(super) fn new(v: [VertexId; 3], across: [Side; 3]) -> Triangle {
        Triangle {
            vertices: [v[0], v[1], v[2], VertexId::new(0)],
            across: [across[0], across[1], across[2], Side::NOTHING],
        }
    }

    /// The same triangle with its vertices and all triangles numbered higher by so much; a retired one stays
    /// one, because its vertices cannot be numbered higher.
    #[cfg(feature = "parallel")]
    pub(super) fn moved(self, vertices: u32, triangles: u32) -> Triangle {
        let vertex = |v: VertexId| VertexId::new(v.number().saturating_add(vertices));
        Triangle {
            vertices: self.vertices.map(vertex),
            across: self.across.map(|side| side.moved(triangles)),
        }
    }

    #[inline(always)]
    pub(crate) fn vertex(&self, corner: u32) -> VertexId {
        self.vertices[(corner & 3) as usize]
    }

    pub(crate) fn vertices(&self) -> [VertexId; 3] {
        [0, 1, 2].map(|corner| self.vertex(corner))
    }

    /// What lies across the side opposite `corner`.
    #[inline(always)]
    pub(crate) fn across(&self, corner: u32) -> Side {
        self.across[(corner & 3) as usize]
    }

    #[inline(always)]
    pub(crate) fn set_vertex(&mut self, corner: u32, vertex: VertexId) {
        self.vertices[(corner & 3) as usize] = vertex;
    }

    #[inline(always)]
    pub(crate) fn set_across(&mut self, corner: u32, side: Side) {
        self.across[(corner & 3) as usize] = side;
    }

    pub(super) fn mark(&mut self) {
        self.vertices[3] = MARK;
    }

    pub(super) fn is_marked(&self) -> bool {
        self.vertices[3] == MARK
    }
}
