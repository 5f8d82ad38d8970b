//! The sorted vertices of all bands before the sweep: their numbers in the whole, and which edges run within each band.
//! Cost: O(n) for n points and edges, divided among the threads.

use alloc::vec;
use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use super::super::vertices::{ApproxPoints, SortBuffers, Vertices};
use super::cut::cut;
use crate::ids::{VertexId, narrow};
use crate::scalar::Scalar;
use crate::threads::on_all_cores;
use crate::triangulation::edge_chains::marked;
use crate::tuning::{CHUNK_OF_BANDS, Tuning};

/// The vertices of each band, from the lowest to the highest.
#[derive(Debug)]
pub(crate) struct Partition {
    pub(super) bands: Vec<Vertices>,
    /// For each band the rank of its first vertex in the whole; then the number of all vertices.
    pub(super) first: Vec<usize>,
}

/// An edge: its input index, and both ends, upper one first.
pub(super) type Edge = (u32, [VertexId; 2]);

/// The edges, by where they run.
#[derive(Debug)]
pub(super) struct SplitEdges {
    /// The input indices that stand for the ends of each edge, upper end first.
    pub(super) inputs: Vec<[u32; 2]>,
    /// For each band lists of the edges within it; ends are numbered in the band.
    pub(super) local: Vec<Vec<Vec<Edge>>>,
    /// The edges from band to band; ends are numbered in the whole.
    pub(super) crossing: Vec<Edge>,
}

impl Partition {
    /// Cuts the points into bands and sorts each. A band has two vertices or more, unless it is the only one.
    pub(super) fn new<S: Scalar + Sync>(
        located: &ApproxPoints<'_, S>,
        bands: usize,
        tuning: &Tuning,
    ) -> Partition {
        let inputs = cut(located, bands).into_iter().enumerate().collect();
        let sorted = on_all_cores(inputs, |(band, inputs): (usize, Vec<u32>)| {
            let mut vertices = Vertices::default();
            if band == 0 {
                // Room for the vertices of the other bands, too.
                vertices.reserve(located.points.len());
            }
            let inputs = inputs.iter().copied();
            vertices.set(located, inputs, &mut SortBuffers::default(), tuning);
            vertices
        });
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
        Partition { bands, first }
    }

    /// Splits the edges into those within a band and those from band to band. `None` if an end is no point.
    pub(super) fn split_edges(&self, points: usize, edges: &[[usize; 2]]) -> Option<SplitEdges> {
        let mut sorted = SplitEdges {
            inputs: vec![[0; 2]; edges.len()],
            local: vec![Vec::new(); self.bands.len()],
            crossing: Vec::new(),
        };
        if edges.is_empty() {
            return Some(sorted);
        }
        if edges.par_iter().flatten_iter().any(|&end| end >= points) {
            return None;
        }
        let ranks = self.ranks(points);
        let inputs = sorted.inputs.par_chunks_mut(CHUNK_OF_BANDS);
        let chunks = edges.par_chunks(CHUNK_OF_BANDS).zip(inputs).enumerate();
        let lists = chunks.map(|(chunk, (edges, inputs))| {
            let edges = (narrow(chunk * CHUNK_OF_BANDS)..).zip(edges);
            self.lists(&ranks, edges, inputs)
        });
        for (local, crossing) in lists.collect::<Vec<_>>() {
            for (lists, list) in sorted.local.iter_mut().zip(local) {
                lists.push(list);
            }
            sorted.crossing.extend(crossing);
        }
        Some(sorted)
    }

    /// Splits a chunk of edges: lists those within each band and those from band to band, and sets `inputs`.
    fn lists<'a>(
        &self,
        ranks: &[AtomicU32],
        edges: impl Iterator<Item = (u32, &'a [usize; 2])>,
        inputs: &mut [[u32; 2]],
    ) -> (Vec<Vec<Edge>>, Vec<Edge>) {
        let has_duplicates = self.bands.iter().any(|band| !band.duplicates.is_empty());
        let (mut local, mut crossing) = (vec![Vec::new(); self.bands.len()], Vec::new());
        for ((edge, &ends), inputs) in edges.zip(inputs) {
            let mut ends = ends.map(|input| (ranks[input].load(Ordering::Relaxed), input));
            let runs_up = ends[1].0 > ends[0].0;
            if runs_up {
                ends.reverse();
            }
            let [upper, lower] = ends.map(|(rank, _)| VertexId::new(rank));
            let downwards = if has_duplicates {
                [upper, lower].map(|v| self.input(v))
            } else {
                ends.map(|(_, input)| narrow(input))
            };
            *inputs = marked(downwards, runs_up);
            let band = self.band(upper);
            let first = self.first[band];
            if lower.index() < first {
                crossing.push((edge, [upper, lower]));
            } else {
                let number = |v: VertexId| VertexId::at(v.index() - first);
                local[band].push((edge, [upper, lower].map(number)));
            }
        }
        (local, crossing)
    }

    /// For each of `points` points the rank of its vertex in the whole.
    fn ranks(&self, points: usize) -> Vec<AtomicU32> {
        let ranks: Vec<AtomicU32> = (0..points).into_par_iter().map(|_| 0.into()).collect();
        let rank = |input: u32| &ranks[input as usize];
        let bands = self.bands.par_iter().zip(&self.first);
        bands.for_each(|(vertices, &first)| {
            for (number, &input) in (narrow(first)..).zip(&vertices.input) {
                rank(input).store(number, Ordering::Relaxed);
            }
            for &(duplicate, of) in &vertices.duplicates {
                rank(duplicate).store(rank(of).load(Ordering::Relaxed), Ordering::Relaxed);
            }
        });
        ranks
    }

    /// The band of a vertex that is numbered in the whole.
    fn band(&self, v: VertexId) -> usize {
        self.first.partition_point(|&first| first <= v.index()) - 1
    }

    /// The input index of a vertex that is numbered in the whole.
    fn input(&self, v: VertexId) -> u32 {
        let band = self.band(v);
        self.bands[band].input[v.index() - self.first[band]]
    }
}
