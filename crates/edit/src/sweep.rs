//! A region of triangles is swept anew: the operation behind every edit but a vertex that comes into a closed
//! [region](crate::star), and an edge that pierces one [side](crate::walk).
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

use sweep_cdt::Error;
use sweep_cdt::scalar::{Scalar, orient2d};

use crate::error::EditError;
use crate::mesh::{NONE, number};
use crate::placed::Placed;
use crate::region::{Piece, outlined};
use crate::triangulation::DynamicTriangulation;

/// The place in a call of a vertex that goes.
const GONE: u32 = NONE - 1;

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Sweeps the region anew, without the vertices `gone` (sorted), with the vertices `new` and the parts `pieces` of new
    /// edges. Returns the new triangles, and the sides across the border. The region is empty afterwards.
    pub(crate) fn sweep(
        &mut self,
        gone: &[u32],
        new: &[u32],
        pieces: &[Piece],
    ) -> Result<[Vec<u32>; 2], EditError> {
        let (border, old) = outlined(&self.mesh, &self.region);
        let mut all = if gone.is_empty() {
            old
        } else {
            self.joined(old, gone)
        };
        all.extend(pieces);

        // The vertices of the call, each once, old ones first.
        self.local.resize(self.points.bound(), NONE);
        let triangles = self.region.triangles.iter();
        let corners = triangles.filter_map(|&t| self.mesh.triangle(t)).flatten();
        let corners = corners.chain(border.iter().flat_map(|side| side.ends));
        for v in corners.clone().chain(new.iter().copied()) {
            self.local[v as usize] = NONE;
        }
        for &v in gone {
            self.local[v as usize] = GONE;
        }
        let mut vertices =
            Vec::with_capacity(self.region.triangles.len() + border.len() + new.len());
        for v in corners.chain(new.iter().copied()) {
            if self.local[v as usize] == NONE {
                self.local[v as usize] = number(vertices.len());
                vertices.push(v);
            }
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
        let placed = Placed::new(swept, vertices.len(), &border, local);
        let found = placed.put(&mut self.mesh, &self.region, &vertices, &border, &all);
        for &v in new {
            let first = vertices[swept.representative(local(v))];
            if first != v {
                self.same.insert(v, first);
            }
        }
        for v in &mut vertices {
            *v = self.same.get(v).copied().unwrap_or(*v);
        }
        self.sweeps.push((vertices, edges));
        self.region.clear();
        self.swept.extend(&found);
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
