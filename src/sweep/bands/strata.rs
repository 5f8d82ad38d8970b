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

/// The ends of each edge, upper end first.
#[derive(Debug, Default)]
pub(super) struct Ends {
    /// Numbered in the whole.
    pub(super) numbers: Vec<[VertexId; 2]>,
    pub(super) inputs: Vec<[u32; 2]>,
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

    /// The ends of each edge, upper end first: numbered in the whole, and the input indices that stand for them.
    /// `None` if one is no point.
    pub(super) fn ends(&self, points: usize, edges: &[[usize; 2]]) -> Option<Ends> {
        let mut ends = Ends::default();
        if edges.is_empty() {
            return Some(ends);
        }
        if edges.par_iter().flatten_iter().any(|&end| end >= points) {
            return None;
        }
        let ranks: Vec<AtomicU32> = (0..points).into_par_iter().map(|_| 0.into()).collect();
        let rank = |input: usize| ranks[input].load(Ordering::Relaxed);
        self.bands
            .par_iter()
            .zip(&self.first)
            .for_each(|(vertices, first)| {
                for (number, &input) in (narrow(*first)..).zip(&vertices.input) {
                    ranks[input as usize].store(number, Ordering::Relaxed);
                }
                for &(duplicate, of) in &vertices.duplicates {
                    ranks[duplicate as usize].store(rank(of as usize), Ordering::Relaxed);
                }
            });
        let has_duplicates = self.bands.iter().any(|band| !band.duplicates.is_empty());
        let both = |&[a, b]: &[usize; 2]| {
            let (upper, lower) = if rank(a) < rank(b) { (b, a) } else { (a, b) };
            let numbers = [upper, lower].map(|end| VertexId::new(rank(end)));
            let inputs = if has_duplicates {
                numbers.map(|v| self.input(v))
            } else {
                [upper, lower].map(narrow)
            };
            (numbers, inputs)
        };
        let edges = edges.par_iter().map(both);
        edges.unzip_into_vecs(&mut ends.numbers, &mut ends.inputs);
        Some(ends)
    }

    /// The input index that stands for a vertex, which is numbered in the whole.
    fn input(&self, v: VertexId) -> u32 {
        let band = self.band(v);
        self.bands[band].input[v.index() - self.first[band]]
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
