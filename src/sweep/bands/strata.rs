//! The sorted vertices of all bands, before they are swept: their numbers in the whole, and which edges run
//! within one band.
//!
//! Cost: O(n) for n points and edges, divided among the threads.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use super::super::located::Located;
use super::super::order::{Order, Workspace};
use super::super::vertices::Vertices;
use super::cut::cut;
use crate::ids::{VertexId, narrow};
use crate::scalar::Scalar;

/// The vertices of each band, from the lowest to the highest.
#[derive(Debug)]
pub(super) struct Strata {
    pub(super) bands: Vec<Vertices>,
    /// For each band the number of its first vertex in the whole, and at last the number of all vertices.
    pub(super) first: Vec<usize>,
}

impl Strata {
    /// Cuts the points into bands and sorts each. A band has two vertices or more, unless it is the only one.
    pub(super) fn new<S: Scalar + Sync>(located: &Located<'_, S>, bands: usize) -> Strata {
        let sorted: Vec<Vertices> = cut(located, bands)
            .into_par_iter()
            .map(|inputs| {
                let inputs = inputs.iter().copied();
                Vertices::new(located, inputs, Order::default(), &mut Workspace::default())
            })
            .collect();
        let mut bands: Vec<Vertices> = Vec::new();
        for vertices in sorted {
            match bands.last_mut() {
                Some(below) if below.len() < 2 || vertices.len() < 2 => below.append(vertices),
                _ => bands.push(vertices),
            }
        }
        let mut first = vec![0];
        for vertices in &bands {
            first.push(first[first.len() - 1] + vertices.len());
        }
        Strata { bands, first }
    }

    /// The band of a vertex, which is numbered in the whole.
    fn band(&self, v: VertexId) -> usize {
        self.first.partition_point(|&first| first <= v.index()) - 1
    }

    /// The input indices that stand for the ends of an edge, which are numbered in the whole.
    pub(super) fn inputs(&self, ends: [VertexId; 2]) -> [u32; 2] {
        ends.map(|v| {
            let band = self.band(v);
            self.bands[band].input[v.index() - self.first[band]]
        })
    }

    /// The ends of each edge, upper end first, numbered in the whole; `None` if one is no point.
    pub(super) fn ends(&self, points: usize, edges: &[[usize; 2]]) -> Option<Vec<[VertexId; 2]>> {
        if edges.is_empty() {
            return Some(Vec::new());
        }
        let ranks: Vec<AtomicU32> = (0..points).into_par_iter().map(|_| 0.into()).collect();
        let rank = |input: usize| Some(ranks.get(input)?.load(Ordering::Relaxed));
        self.bands
            .par_iter()
            .zip(&self.first)
            .for_each(|(vertices, first)| {
                for (number, &input) in (narrow(*first)..).zip(&vertices.input) {
                    ranks[input as usize].store(number, Ordering::Relaxed);
                }
                for &(duplicate, of) in &vertices.duplicates {
                    let number = ranks[of as usize].load(Ordering::Relaxed);
                    ranks[duplicate as usize].store(number, Ordering::Relaxed);
                }
            });
        edges
            .par_iter()
            .map(|&[a, b]| {
                let (a, b) = (rank(a)?, rank(b)?);
                Some([a.max(b), a.min(b)].map(VertexId::new))
            })
            .collect()
    }

    /// The edges from one band to another: input index and both ends.
    pub(super) fn across(&self, ends: &[[VertexId; 2]]) -> Vec<(u32, [VertexId; 2])> {
        let numbered = ends.par_iter().copied().enumerate();
        numbered
            .map(|(edge, ends)| (narrow(edge), ends))
            .filter(|&(_, [upper, lower])| self.band(upper) != self.band(lower))
            .collect()
    }
}
