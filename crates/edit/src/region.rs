//! A region of triangles is swept anew: the one operation behind every edit.
//!
//! **Why it is right.** Declaring a side of the canonical triangulation an edge changes nothing: the circle of every
//! triangle stays empty, and the rule for ties looks at the corners of one circle alone. Edges are the only way in which
//! one part depends on another. So if a change leaves all triangles outside of a region right, those inside are the
//! canonical triangulation of the region's vertices with its edges and its border, cut back to the inside of the border.
//! An edit finds such a region; the sweep does the rest, and no flip is made here. The result is that of a fresh run,
//! since there is only one.
//!
//! ```text
//!      .-----.            .-----.         The border (double) holds. The sweep triangulates the hull of all vertices
//!     / \   / \          /|\   /||        there; what is reached from the left of the border, without crossing it, is
//!    /___\ /___\   -->  / | \ / ||        kept. Sides of the hull that a new point sees count as triangles of the
//!    \   / \   /        \ |  x  ||        region (`beyond`): there the border is open, and ends at the new hull.
//!     \ /___\ /          \|_/_\_||
//! ```
//!
//! **Cost.** One call of a [`Session`](sweep_cdt::Session) on the region's vertices, and O(k log k) for k triangles to
//! put its result in place.

use std::collections::BTreeMap;

use sweep_cdt::scalar::{Scalar, orient2d};
use sweep_cdt::{Error, Triangulation};

use crate::error::EditError;
use crate::mesh::{Mesh, NONE, next, number, prev, side_of};
use crate::triangulation::DynamicTriangulation;

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
struct Border {
    ends: [u32; 2],
    across: u32,
    covers: u32,
}

/// The border of a region, and the parts of edges inside it.
fn outlined(mesh: &Mesh, region: &Region) -> (Vec<Border>, Vec<Piece>) {
    let (mut border, mut pieces) = (Vec::new(), Vec::new());
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

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Sweeps the region anew, without the vertices `gone` (sorted), with the vertices `new` and the parts `pieces` of new edges.
    /// Returns the new triangles, and the sides across the border. The region is empty afterwards.
    pub(crate) fn sweep(
        &mut self,
        gone: &[u32],
        new: &[u32],
        pieces: &[Piece],
    ) -> Result<[Vec<u32>; 2], EditError> {
        let (border, old) = outlined(&self.mesh, &self.region);
        let mut all: Vec<Piece> = self.joined(old, gone);
        all.extend(pieces);

        // The vertices of the call, old ones first.
        let mut vertices = Vec::new();
        let triangles = self.region.triangles.iter();
        let corners = triangles.filter_map(|&t| self.mesh.triangle(t)).flatten();
        vertices.extend(corners.chain(border.iter().flat_map(|side| side.ends)));
        vertices.sort_unstable();
        vertices.dedup();
        vertices.retain(|v| gone.binary_search(v).is_err());
        vertices.extend(new);
        self.local.resize(self.points.bound(), NONE);
        for (i, &v) in vertices.iter().enumerate() {
            self.local[v as usize] = number(i);
        }
        let local = |v: u32| self.local[v as usize] as usize;
        let points: Vec<[S; 2]> = vertices
            .iter()
            .map(|&v| self.points.place(v).clone())
            .collect();
        let ends = border.iter().map(|side| side.ends);
        let edges = ends.chain(all.iter().map(|piece| piece.ends));
        let edges: Vec<[usize; 2]> = edges.map(|ends| ends.map(local)).collect();

        let swept = match self.session.triangulate(&points, &edges) {
            Ok(swept) => swept,
            Err(Error::CrossingEdges { edges }) => {
                let pieces = edges.map(|e| match e.checked_sub(border.len()) {
                    Some(piece) => all[piece],
                    None => Piece {
                        ends: border[e].ends,
                        covers: 1,
                        edge: None,
                    },
                });
                let [a, b] = pieces.map(|piece| self.edge_over(piece));
                return Err(EditError::crossing(a, b));
            }
            Err(error) => return Err(EditError::Refused { error }),
        };
        let placed = Placed::new(swept, &border, local);
        let found = placed.put(&mut self.mesh, &self.region, &vertices, &border, &all);
        for &v in new {
            let first = vertices[swept.representative(local(v))];
            if first != v {
                self.same.insert(v, first);
            }
        }
        self.region.clear();
        let across = border
            .iter()
            .map(|side| side.across)
            .filter(|&side| side != NONE);
        Ok([found, across.collect()])
    }

    /// Joins the parts of edges that pass through vertices that go.
    fn joined(&self, pieces: Vec<Piece>, gone: &[u32]) -> Vec<Piece> {
        let is_gone = |v: u32| gone.binary_search(&v).is_ok();
        let (broken, mut whole): (Vec<Piece>, Vec<Piece>) = pieces
            .into_iter()
            .partition(|piece| piece.ends.into_iter().any(is_gone));
        let mut beside: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &Piece { ends: [a, b], .. } in &broken {
            beside.entry(a).or_default().push(b);
            beside.entry(b).or_default().push(a);
        }
        for &piece in &broken {
            for [from, mut at] in [piece.ends, [piece.ends[1], piece.ends[0]]] {
                if is_gone(from) {
                    continue;
                }
                // No edge ends at a vertex that goes, so it goes straight on.
                while is_gone(at) {
                    let onward = beside[&at]
                        .iter()
                        .find(|&&to| self.is_between(from, at, to));
                    at = *onward.expect("an edge goes on");
                }
                if from < at {
                    whole.push(Piece {
                        ends: [from, at],
                        ..piece
                    });
                }
            }
        }
        whole
    }

    /// Whether a vertex lies on the line between two others.
    fn is_between(&self, from: u32, at: u32, to: u32) -> bool {
        let [a, b, c] = [from, at, to].map(|v| self.points.place(v));
        let is_ahead = self.points.order(from, at) == self.points.order(at, to);
        to != from && is_ahead && orient2d(a, b, c).is_eq()
    }
}

/// The result of a call, and what of it lies inside the border.
struct Placed<'a> {
    swept: &'a Triangulation,
    /// The constrained sides with their ends, sorted.
    sides: Vec<([usize; 2], [usize; 2])>,
    /// For each side of the border, as ends in the call, where the triangle inside it stands.
    border: Vec<[usize; 2]>,
    is_kept: Vec<bool>,
}

impl<'a> Placed<'a> {
    fn new(
        swept: &'a Triangulation,
        border: &[Border],
        local: impl Fn(u32) -> usize,
    ) -> Placed<'a> {
        let sides = (0..swept.len()).flat_map(|t| [0, 1, 2].map(|k| (swept.side(t, k), [t, k])));
        let mut sides: Vec<_> = sides
            .filter(|&(_, [t, k])| swept.is_constrained(t, k))
            .collect();
        sides.sort_unstable();
        let mut placed = Placed {
            swept,
            sides,
            border: border.iter().map(|side| side.ends.map(&local)).collect(),
            is_kept: vec![border.is_empty(); swept.len()],
        };
        placed.flood();
        placed
    }

    /// The triangle and the side with these ends on its left, if it is constrained.
    fn side(&self, ends: [usize; 2]) -> Option<[usize; 2]> {
        let found = self.sides.binary_search_by_key(&ends, |&(ends, _)| ends);
        found.ok().map(|i| self.sides[i].1)
    }

    fn flood(&mut self) {
        let sides = self.border.iter().filter_map(|&ends| self.side(ends));
        let closed: Vec<[usize; 2]> = sides.collect();
        let mut is_closed = vec![[false; 3]; self.swept.len()];
        for &[t, k] in &closed {
            is_closed[t][k] = true;
        }
        let mut waiting: Vec<usize> = closed.into_iter().map(|[t, _]| t).collect();
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
    fn put(
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
        let mut slot = vec![NONE; swept.len()];
        let mut found = Vec::new();
        for t in (0..swept.len()).filter(|&t| self.is_kept[t]) {
            slot[t] = mesh.add(swept.triangle(t).map(|v| vertices[v]));
            found.push(slot[t]);
        }
        for t in (0..swept.len()).filter(|&t| self.is_kept[t]) {
            for k in 0..3 {
                if let Some((across, side)) = swept.twin(t, k).filter(|&(t, _)| self.is_kept[t]) {
                    mesh.set_twin(side_of(slot[t], k), side_of(slot[across], side));
                }
            }
        }
        // A corner at each vertex; beyond the border, if all of its triangles are there.
        let mut at = vec![NONE; vertices.len()];
        for (side, &[a, b]) in border.iter().zip(&self.border) {
            if side.across != NONE {
                at[a] = prev(side.across);
                at[b] = next(side.across);
                mesh.set_twin(side.across, NONE);
            }
        }
        for t in (0..swept.len()).filter(|&t| self.is_kept[t]) {
            for (k, v) in swept.triangle(t).into_iter().enumerate() {
                at[v] = side_of(slot[t], k);
            }
        }
        for (&v, corner) in vertices.iter().zip(at) {
            mesh.set_at(v, corner);
        }
        for (side, &ends) in border.iter().zip(&self.border) {
            let Some([t, k]) = self.side(ends) else {
                continue;
            };
            let inner = side_of(slot[t], k);
            mesh.set_twin(inner, side.across);
            mesh.set_covers(inner, side.covers);
            if side.across != NONE {
                mesh.set_twin(side.across, inner);
            }
        }
        for (i, piece) in pieces.iter().enumerate() {
            let chain: Vec<usize> = swept.edge_chain(border.len() + i).collect();
            for pair in chain.windows(2) {
                for ends in [[pair[0], pair[1]], [pair[1], pair[0]]] {
                    let Some([t, k]) = self.side(ends).filter(|&[t, _]| self.is_kept[t]) else {
                        continue;
                    };
                    let side = side_of(slot[t], k);
                    mesh.set_covers(side, mesh.covers(side) + piece.covers);
                }
            }
        }
        found
    }
}
