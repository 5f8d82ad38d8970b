//! The input edges at their upper ends (section 3.3, figure 5): an edge is listed at its end of higher rank, where the
//! sweep line has passed all of it. Cost: O(n) for n points and edges, by a counting sort.
//!
//! Differs from the paper: the upper end of a horizontal edge is the one with larger x, since it is swept last. (The
//! paper says the one with smaller x, against its own sort.)

use super::vertices::Vertices;
use crate::error::Error;
use crate::ids::{VertexId, narrow};
use crate::triangulation::edge_chains::marked;
use alloc::vec::Vec;

#[derive(Debug, Default)]
pub(super) struct Edges {
    /// The edges whose upper end is `v` are `list[first[v]..first[v + 1]]`. Empty if there are no edges.
    first: Vec<u32>,
    /// The lower end and the input index of each edge.
    list: Vec<(VertexId, u32)>,
}

impl Edges {
    /// Lists the edges of an input of `points` points. Sets `ends` to the [`marked`] input indices of their ends.
    pub(super) fn set(
        &mut self,
        vertices: &Vertices,
        points: usize,
        edges: &[[usize; 2]],
        ends: &mut Vec<[u32; 2]>,
    ) -> Result<(), Error> {
        ends.clear();
        if edges.is_empty() {
            self.clear();
            return Ok(());
        }
        // The buffer of the ranks will be that of `first`.
        let ranks = &mut self.first;
        ranks.clear();
        ranks.reserve_exact(points + 1);
        vertices.rank(points, ranks);
        ends.reserve_exact(edges.len());
        for (edge, given) in edges.iter().enumerate() {
            let rank = |vertex: usize| match ranks.get(vertex) {
                Some(&rank) => Ok(rank),
                None => Err(Error::EdgeOutOfRange { edge, vertex }),
            };
            ends.push([rank(given[0])?, rank(given[1])?]);
        }
        let upper_first = |&[a, b]: &[u32; 2]| [a.max(b), a.min(b)].map(VertexId::new);
        let numbered = ends.iter().enumerate();
        self.list(
            vertices.len(),
            numbered.map(|(edge, ends)| (narrow(edge), upper_first(ends))),
        );
        if vertices.duplicates.is_empty() {
            // Each vertex stands for the input point itself.
            for (ends, given) in ends.iter_mut().zip(edges) {
                let runs_up = ends[1] > ends[0];
                let upper = usize::from(runs_up);
                *ends = marked([given[upper], given[1 - upper]].map(narrow), runs_up);
            }
        } else {
            for ends in ends {
                let downwards = upper_first(ends).map(|v| vertices.input_index(v));
                *ends = marked(downwards, ends[1] > ends[0]);
            }
        }
        Ok(())
    }

    /// Lists edges at their upper ends. Each comes with its input index and its ends, upper one first.
    pub(super) fn list(
        &mut self,
        vertices: usize,
        edges: impl DoubleEndedIterator<Item = (u32, [VertexId; 2])> + Clone,
    ) {
        self.clear();
        if edges.clone().next().is_none() {
            return;
        }
        let Edges { first, list } = self;
        first.reserve_exact(vertices + 1);
        first.resize(vertices + 1, 0);
        for (_, [upper, _]) in edges.clone() {
            first[upper.index()] += 1;
        }
        // Counts become ends of the ranges. Each edge goes before the end of its range, which moves down to the start.
        let mut sum = 0;
        for count in &mut *first {
            sum += *count;
            *count = sum;
        }
        list.reserve_exact(sum as usize);
        list.resize(sum as usize, (VertexId::default(), 0));
        for (edge, [upper, lower]) in edges.rev() {
            let place = &mut first[upper.index()];
            *place -= 1;
            list[*place as usize] = (lower, edge);
        }
    }

    fn clear(&mut self) {
        self.first.clear();
        self.list.clear();
    }

    /// The edges with upper end `v`, as lower ends and input indices.
    #[inline(always)]
    pub(super) fn at(&self, v: VertexId) -> &[(VertexId, u32)] {
        match self.first.get(v.index()..v.index() + 2) {
            Some(&[from, to]) => &self.list[from as usize..to as usize],
            _ => &[],
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// All edges: upper end, lower end, input index.
    pub(super) fn iter(&self) -> impl Iterator<Item = (VertexId, VertexId, u32)> + '_ {
        let uppers = (0..self.first.len().saturating_sub(1)).map(VertexId::at);
        uppers.flat_map(|v| {
            self.at(v)
                .iter()
                .map(move |&(lower, edge)| (v, lower, edge))
        })
    }

    pub(super) fn heap_bytes(&self) -> usize {
        self.first.capacity() * size_of::<u32>()
            + self.list.capacity() * size_of::<(VertexId, u32)>()
    }
}
