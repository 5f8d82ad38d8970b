//! One record of the mesh: three vertices and the twins of the three sides, in 24 bytes. A fourth element in both
//! arrays would take the bounds check from an index that is masked to 0..=3, and 3 % of the instructions. But the pages
//! for it, which a first run must get from the system, take longer.

use super::half_edge::HalfEdge;
use crate::ids::VertexId;

/// Three vertices, counter-clockwise, and for each side `i`, opposite vertex `i`, its twin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    vertices: [VertexId; 3],
    twins: [HalfEdge; 3],
}

impl Triangle {
    /// A removed triangle: its vertices have a number above all others.
    pub(super) const RETIRED: Triangle = Triangle {
        vertices: [VertexId::new(u32::MAX); 3],
        twins: [HalfEdge::NOTHING; 3],
    };

    pub(super) fn new(vertices: [VertexId; 3], twins: [HalfEdge; 3]) -> Triangle {
        Triangle { vertices, twins }
    }

    /// The triangle with all numbers higher. A retired triangle stays one: its vertices cannot be numbered higher.
    #[cfg(feature = "parallel")]
    pub(super) fn moved(self, vertices: u32, triangles: u32) -> Triangle {
        let vertex = |v: VertexId| VertexId::new(v.number().saturating_add(vertices));
        Triangle {
            vertices: self.vertices.map(vertex),
            twins: self.twins.map(|side| side.moved(triangles)),
        }
    }

    #[inline(always)]
    pub(crate) fn vertex(&self, corner: u32) -> VertexId {
        self.vertices[corner as usize]
    }

    pub(crate) fn vertices(&self) -> [VertexId; 3] {
        self.vertices
    }

    #[inline(always)]
    pub(crate) fn vertices_from(&self, corner: u32) -> [VertexId; 3] {
        let [a, b, c] = self.vertices;
        match corner {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        }
    }

    #[inline(always)]
    pub(crate) fn twin(&self, corner: u32) -> HalfEdge {
        self.twins[corner as usize]
    }

    #[inline(always)]
    pub(crate) fn set_vertex(&mut self, corner: u32, vertex: VertexId) {
        self.vertices[corner as usize] = vertex;
    }

    #[inline(always)]
    pub(crate) fn set_twin(&mut self, corner: u32, side: HalfEdge) {
        self.twins[corner as usize] = side;
    }
}
