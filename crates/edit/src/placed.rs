//! What of a call's result lies inside the border of a region, and its way into the mesh.
//!
//! Why it is right: a side of the border is an edge of the call, so it is a side of the result. What is reached from its
//! left without crossing the border is inside. Cost: O(k log k) for k triangles of the result.

use sweep_cdt::Triangulation;

use crate::mesh::{Mesh, NONE, next, prev, side_of};
use crate::region::{Border, Piece, Region};

/// The result of a call, and what of it lies inside the border.
pub(crate) struct Placed<'a> {
    swept: &'a Triangulation,
    /// The constrained sides by the vertex on their right end, as the other end and where they stand; those of one vertex
    /// sorted.
    sides: Vec<(usize, [usize; 2])>,
    /// For each vertex where its constrained sides begin in the list.
    first: Vec<usize>,
    /// For each side of the border its ends in the call, and where the triangle inside it stands.
    border: Vec<([usize; 2], Option<[usize; 2]>)>,
    is_kept: Vec<bool>,
}

impl<'a> Placed<'a> {
    pub(crate) fn new(
        swept: &'a Triangulation,
        vertices: usize,
        border: &[Border],
        local: impl Fn(u32) -> usize,
    ) -> Placed<'a> {
        let sides = (0..swept.len()).flat_map(|t| [0, 1, 2].map(|k| [t, k]));
        let constrained = sides.filter(|&[t, k]| swept.is_constrained(t, k));
        // Where the sides of each vertex end, and then, as they come from behind, where they begin.
        let mut first = vec![0; vertices + 1];
        for [t, k] in constrained.clone() {
            first[swept.side(t, k)[0]] += 1;
        }
        for v in 0..vertices {
            first[v + 1] += first[v];
        }
        let mut sides = vec![(0, [0; 2]); first[vertices]];
        for [t, k] in constrained {
            let [a, b] = swept.side(t, k);
            first[a] -= 1;
            sides[first[a]] = (b, [t, k]);
        }
        for of_vertex in first.windows(2).filter(|of| of[1] - of[0] > 1) {
            sides[of_vertex[0]..of_vertex[1]].sort_unstable();
        }
        let mut placed = Placed {
            swept,
            sides,
            first,
            border: Vec::new(),
            is_kept: vec![border.is_empty(); swept.len()],
        };
        let ends = border.iter().map(|side| side.ends.map(&local));
        placed.border = ends.map(|ends| (ends, placed.side(ends))).collect();
        placed.flood();
        placed
    }

    /// The triangle and the side with these ends on its left, if it is constrained.
    fn side(&self, [a, b]: [usize; 2]) -> Option<[usize; 2]> {
        let sides = &self.sides[self.first[a]..self.first[a + 1]];
        let found = sides.binary_search_by_key(&b, |&(end, _)| end);
        found.ok().map(|i| sides[i].1)
    }

    fn flood(&mut self) {
        let mut is_closed = vec![[false; 3]; self.swept.len()];
        let mut waiting = Vec::with_capacity(self.swept.len());
        for [t, k] in self.border.iter().filter_map(|&(_, inner)| inner) {
            is_closed[t][k] = true;
            waiting.push(t);
        }
        while let Some(t) = waiting.pop() {
            if std::mem::replace(&mut self.is_kept[t], true) {
                continue;
            }
            for (k, is_closed) in is_closed[t].into_iter().enumerate() {
                waiting.extend(self.swept.neighbor(t, k).filter(|_| !is_closed));
            }
        }
    }

    /// Puts the triangles that are kept in the place of the region. Returns their numbers.
    pub(crate) fn put(
        &self,
        mesh: &mut Mesh,
        region: &Region,
        vertices: &[u32],
        border: &[Border],
        pieces: &[Piece],
    ) -> Vec<u32> {
        let swept = self.swept;
        for &t in &region.triangles {
            mesh.kill(t);
        }
        let kept = || (0..swept.len()).filter(|&t| self.is_kept[t]);
        let mut slot = vec![NONE; swept.len()];
        for t in kept() {
            slot[t] = mesh.add(swept.triangle(t).map(|v| vertices[v]));
        }
        // A corner at each vertex; beyond the border, if all of its triangles are there.
        let mut at = vec![NONE; vertices.len()];
        for (side, &([a, b], inner)) in border.iter().zip(&self.border) {
            let inner = inner.map_or(NONE, |[t, k]| side_of(slot[t], k));
            if side.across != NONE {
                at[a] = prev(side.across);
                at[b] = next(side.across);
                mesh.set_twin(side.across, inner);
            }
            if inner != NONE {
                mesh.begin(inner, side.across, side.covers);
            }
        }
        for t in kept() {
            for (k, v) in swept.triangle(t).into_iter().enumerate() {
                let side = side_of(slot[t], k);
                at[v] = side;
                if let Some((across, twin)) = swept.twin(t, k).filter(|&(t, _)| self.is_kept[t]) {
                    mesh.begin(side, side_of(slot[across], twin), 0);
                }
            }
        }
        for (&v, corner) in vertices.iter().zip(at) {
            mesh.set_at(v, corner);
        }
        for (i, piece) in pieces.iter().enumerate() {
            let chain: Vec<usize> = swept.edge_chain(border.len() + i).collect();
            for pair in chain.windows(2) {
                for ends in [[pair[0], pair[1]], [pair[1], pair[0]]] {
                    if let Some([t, k]) = self.side(ends).filter(|&[t, _]| self.is_kept[t]) {
                        let side = side_of(slot[t], k);
                        mesh.begin(side, mesh.twin(side), mesh.covers(side) + piece.covers);
                    }
                }
            }
        }
        slot.retain(|&t| t != NONE);
        slot
    }
}
