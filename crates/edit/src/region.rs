//! A region: triangles to be swept anew, and sides of the hull beyond which the region goes on; its border, and the parts
//! of edges inside it. Cost: constant time for each triangle; what is emptied costs what it held.

use crate::mesh::{Mesh, NONE};

/// Triangles to be swept anew.
#[derive(Debug, Default)]
pub(crate) struct Region {
    pub(crate) triangles: Vec<u32>,
    /// Sides of the hull: what lies beyond them is part of the region.
    pub(crate) beyond: Vec<u32>,
    /// For each triangle that is in the region `INSIDE`, and `1 << k` if side `k` is in `beyond`.
    marks: Vec<u8>,
}

const INSIDE: u8 = 8;

impl Region {
    pub(crate) fn has(&self, t: u32) -> bool {
        self.marks
            .get(t as usize)
            .is_some_and(|mark| mark & INSIDE != 0)
    }

    fn is_beyond(&self, side: u32) -> bool {
        let mark = self.marks.get(side as usize / 3);
        mark.is_some_and(|mark| mark & 1 << (side % 3) != 0)
    }

    fn mark(&mut self, t: u32, bit: u8) -> bool {
        if self.marks.len() <= t as usize {
            self.marks.resize(t as usize + 1, 0);
        }
        let mark = &mut self.marks[t as usize];
        let is_new = *mark & bit == 0;
        *mark |= bit;
        is_new
    }

    pub(crate) fn add(&mut self, t: u32) {
        if self.mark(t, INSIDE) {
            self.triangles.push(t);
        }
    }

    pub(crate) fn add_beyond(&mut self, side: u32) {
        if self.mark(side / 3, 1 << (side % 3)) {
            self.beyond.push(side);
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.triangles.is_empty() && self.beyond.is_empty()
    }

    /// Empties the region, at the cost of what it held.
    pub(crate) fn clear(&mut self) {
        for t in self.triangles.drain(..) {
            self.marks[t as usize] = 0;
        }
        for side in self.beyond.drain(..) {
            self.marks[side as usize / 3] = 0;
        }
    }
}

/// A part of an edge between two vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) ends: [u32; 2],
    /// How many edges cover it.
    pub(crate) covers: u32,
    /// The number of the edge, if it is new.
    pub(crate) edge: Option<usize>,
}

/// A side of the region's border, with the region on its left, and the side across.
pub(crate) struct Border {
    pub(crate) ends: [u32; 2],
    pub(crate) across: u32,
    pub(crate) covers: u32,
}

/// The border of a region, and the parts of edges inside it.
pub(crate) fn outlined(mesh: &Mesh, region: &Region) -> (Vec<Border>, Vec<Piece>) {
    let most = region.triangles.len() + region.beyond.len() + 2;
    let (mut border, mut pieces) = (Vec::with_capacity(most), Vec::new());
    let sides = region.triangles.iter().flat_map(|&t| 3 * t..3 * t + 3);
    for side in sides {
        let (ends, across, covers) = (mesh.ends(side), mesh.twin(side), mesh.covers(side));
        let is_inside = match across {
            NONE => region.is_beyond(side),
            across => region.has(across / 3),
        };
        if !is_inside {
            border.push(Border {
                ends,
                across,
                covers,
            });
        } else if covers > 0 && (across == NONE || side < across) {
            let edge = None;
            pieces.push(Piece { ends, covers, edge });
        }
    }
    for &side in region.beyond.iter().filter(|&side| !region.has(side / 3)) {
        let [a, b] = mesh.ends(side);
        let (ends, covers) = ([b, a], mesh.covers(side));
        let across = side;
        border.push(Border {
            ends,
            across,
            covers,
        });
    }
    (border, pieces)
}
