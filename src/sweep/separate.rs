//! Edges separated by a triangulation: many that do not cross each other, and the rest with all that the rest crosses
//! among them.
//!
//! The edges are inserted in random order, as deferred edges are. An edge that would cross a constrained side is left
//! out, and belongs to the *rest*. Then each edge of the rest is followed through the triangles from end to end. Where
//! it crosses a constrained side, it crosses all edges that this side is a part of.
//!
//! Why it is right: edges that were inserted whole cross each other at vertices only. All their parts are constrained
//! sides, so an edge that is followed from end to end meets every one that it crosses. Where no part of either is
//! in, two edges of the rest cross unseen. So the caller searches the rest again.
//!
//! Cost: that of the insertion ([`super::waiting_edges`]), and one test for each triangle that an edge of the rest
//! passes, where constrained sides are crossed as well. No proof bounds how many other sides it crosses: few in every
//! family measured, because edges in random order leave only narrow gaps between those that are in.

use alloc::vec::Vec;
use core::cmp::Ordering::{Equal, Greater, Less};

use super::Sweep;
use super::contradiction::inexact_scalar;
use super::initialization::{begin, initialize};
use super::state::Scratch;
use super::traversal::{CrossedSide, Departure};
use crate::error::Error;
use crate::ids::VertexId;
use crate::random::Random;
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::{Algorithm, Settings};
use crate::tuning::Tuning;

/// Edges by their positions in the list of all.
#[derive(Debug, Default)]
pub(crate) struct Separated {
    /// Edges that cross others: all crossings that are missing in `pairs` are crossings of two of them.
    pub(crate) rest: Vec<u32>,
    /// Pairs of edges that cross at a point that is no vertex; a pair of two edges of the rest may come twice.
    pub(crate) pairs: Vec<[u32; 2]>,
}

/// Separates edges of distinct ends; gives up with more than `most` pairs.
pub(crate) fn separate<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    most: usize,
) -> Result<Option<Separated>, Error> {
    let scratch = &mut Scratch::default();
    initialize(points, edges, &Tuning::REAL, scratch)?;
    Ok(separate_vertices(&points, most, scratch))
}

#[inline(never)]
fn separate_vertices(
    points: &dyn ExactPoints,
    most: usize,
    scratch: &mut Scratch,
) -> Option<Separated> {
    if scratch.arrays.vertices.len() == 0 {
        return Some(Separated::default());
    }
    let settings = Settings {
        algorithm: Algorithm::DivideAndConquer,
        ..Settings::default()
    };
    let mut sweep = begin(points, settings, None, (), scratch);
    sweep.divide_and_conquer_points();
    sweep.waiting.allow_all();
    sweep.separate(most)
}

/// A part of an edge, upper end first, with the edge.
type Side = ([VertexId; 2], u32);

impl Sweep<'_, ()> {
    fn separate(&mut self, most: usize) -> Option<Separated> {
        let distinct = self
            .lists
            .edges
            .iter()
            .filter(|(upper, lower, _)| upper != lower);
        let mut edges: Vec<Side> = distinct
            .map(|(upper, lower, edge)| ([upper, lower], edge))
            .collect();
        Random::new().shuffle(&mut edges);
        let mut sides = Vec::new();
        let mut rest = Vec::new();
        for (ends, edge) in edges {
            if self.insert_parts(ends, edge, &mut sides).is_err() {
                rest.push((ends, edge));
            }
        }
        sides.sort_unstable();
        let mut separated = Separated::default();
        for (ends, edge) in rest {
            separated.rest.push(edge);
            self.follow(ends, |[a, b]| {
                let side = [a.max(b), a.min(b)];
                let first = sides.partition_point(|&(other, _)| other < side);
                let others = sides[first..]
                    .iter()
                    .take_while(|&&(other, _)| other == side);
                separated
                    .pairs
                    .extend(others.map(|&(_, other)| [edge, other]));
            });
            if separated.pairs.len() > most {
                return None;
            }
        }
        Some(separated)
    }

    /// Inserts the parts of an edge from both of its ends, until one is crossed; each goes into `sides`.
    fn insert_parts(
        &mut self,
        mut open: [VertexId; 2],
        edge: u32,
        sides: &mut Vec<Side>,
    ) -> Result<(), CrossedSide> {
        while open[0] != open[1] {
            let left = self.insert_at_one_end(open)?;
            let part = if left[0] == open[0] {
                [left[1], open[1]]
            } else {
                [open[0], left[0]]
            };
            sides.push((part, edge));
            open = left;
        }
        Ok(())
    }

    /// Follows an edge from end to end; `crosses` gets the constrained sides that it crosses.
    fn follow(&mut self, ends: [VertexId; 2], mut crosses: impl FnMut(CrossedSide)) {
        let ([mut from, to], mut around) = self.nearer_departure(ends);
        let mut passed = 0;
        while from != to {
            from = match self.departure([from, to], around) {
                Departure::Along(part) => part.end,
                Departure::Into(mut side) => loop {
                    passed += 1;
                    if passed > self.delaunay.mesh.len() {
                        inexact_scalar();
                    }
                    let twin = self.delaunay.mesh.twin(side);
                    if twin.is_constrained() {
                        let [_, a, b] = self.delaunay.mesh.around(side);
                        crosses([a, b]);
                    }
                    let entry = twin.unconstrained();
                    let v = self.delaunay.mesh.opposite(entry);
                    side = match self.delaunay.side([from, to], v) {
                        Equal => break v,
                        Greater => entry.next(),
                        Less => entry.prev(),
                    };
                },
                Departure::Above => inexact_scalar(),
            };
            around = self.side_opposite(from);
        }
    }
}
