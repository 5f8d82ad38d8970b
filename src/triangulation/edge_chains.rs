//! The vertices along each input edge: noted while the edges are inserted, looked up in the result.

use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::error::Error;
use crate::ids::narrow;

/// How many vertices all edges together may pass through.
const LIMIT: usize = 1 << 28;

/// The notes of the insertion of edges. Vertices are input indices.
#[derive(Debug, Default)]
pub(crate) struct EdgeChainBuilder {
    /// The ends of each edge, upper end first.
    ends: Arc<Vec<[u32; 2]>>,
    /// `(edge, vertex)` for each vertex inside an edge; for one edge from its upper to its lower end.
    passed: Vec<(u32, u32)>,
    /// `(edge, of)` for each edge equal to one that was inserted before.
    equal: Vec<(u32, u32)>,
    /// [`LIMIT`], but less in tests; 0 without edges.
    limit: usize,
}

/// For each input edge the vertices along it.
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeChains {
    /// The ends of each edge (representatives), upper end first.
    ends: Vec<[u32; 2]>,
    /// `(edge, from, to)`, sorted: the vertices inside the edge are `inside[from..to]`. Equal edges share a range.
    split: Vec<(u32, u32, u32)>,
    inside: Vec<u32>,
}

impl EdgeChainBuilder {
    pub(crate) fn new(ends: Arc<Vec<[u32; 2]>>) -> EdgeChainBuilder {
        EdgeChainBuilder {
            ends,
            limit: LIMIT,
            ..EdgeChainBuilder::default()
        }
    }

    pub(crate) fn clear(&mut self) {
        self.passed.clear();
        self.equal.clear();
    }

    #[cfg(feature = "parallel")]
    pub(crate) fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    pub(crate) fn are_equal(&self, a: u32, b: u32) -> bool {
        self.ends[a as usize] == self.ends[b as usize]
    }

    /// Notes that `edge` equals edge `of`, which has been inserted.
    pub(crate) fn share(&mut self, edge: u32, of: u32) {
        self.equal.push((edge, of));
    }

    /// Notes that `edge` passes through `vertex`, after the vertices noted before.
    pub(crate) fn pass(&mut self, edge: u32, vertex: u32) -> Result<(), Error> {
        if self.passed.len() == self.limit {
            return Err(Error::TooManyVerticesOnEdges { limit: self.limit });
        }
        self.passed.push((edge, vertex));
        Ok(())
    }

    #[cfg(feature = "parallel")]
    pub(crate) fn append(&mut self, mut other: EdgeChainBuilder) -> Result<(), Error> {
        if self.passed.len() + other.passed.len() > self.limit {
            return Err(Error::TooManyVerticesOnEdges { limit: self.limit });
        }
        self.passed.append(&mut other.passed);
        self.equal.append(&mut other.equal);
        Ok(())
    }

    /// The ends of the edges alone, where there is no result.
    pub(crate) fn into_ends(self) -> Vec<[u32; 2]> {
        Arc::unwrap_or_clone(self.ends)
    }

    pub(crate) fn finish(mut self) -> EdgeChains {
        // A stable sort: the vertices of each edge stay in order.
        self.passed.sort_by_key(|&(edge, _)| edge);
        let mut split = Vec::new();
        let mut from = 0;
        for run in self.passed.chunk_by(|a, b| a.0 == b.0) {
            let to = from + narrow(run.len());
            split.push((run[0].0, from, to));
            from = to;
        }
        let own = split.len();
        for &(edge, of) in &self.equal {
            if let Ok(at) = split[..own].binary_search_by_key(&of, |&(edge, ..)| edge) {
                let (_, from, to) = split[at];
                split.push((edge, from, to));
            }
        }
        split.sort_unstable();
        EdgeChains {
            ends: Arc::unwrap_or_clone(self.ends),
            split,
            inside: self.passed.into_iter().map(|(_, vertex)| vertex).collect(),
        }
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        self.ends.capacity() * size_of::<[u32; 2]>()
            + (self.passed.capacity() + self.equal.capacity()) * size_of::<(u32, u32)>()
    }
}

impl EdgeChains {
    /// The chains of edges with these vertices along them, at least one each; `None` if they are too many.
    #[cfg(feature = "serde")]
    pub(crate) fn of(lists: &[Vec<u32>]) -> Option<EdgeChains> {
        let inside: usize = lists.iter().map(|list| list.len().saturating_sub(2)).sum();
        if inside > LIMIT || lists.len() > LIMIT {
            return None;
        }
        let mut chains = EdgeChains::default();
        for (e, list) in lists.iter().enumerate() {
            let ends = [*list.first()?, *list.last()?];
            chains.ends.push(ends);
            if list.len() > 2 {
                let from = narrow(chains.inside.len());
                chains.inside.extend_from_slice(&list[1..list.len() - 1]);
                chains
                    .split
                    .push((narrow(e), from, narrow(chains.inside.len())));
            }
        }
        Some(chains)
    }

    pub(crate) fn into_ends(self) -> Vec<[u32; 2]> {
        self.ends
    }

    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The ends of edge `e`, upper end first.
    pub(crate) fn ends(&self, e: usize) -> [u32; 2] {
        self.ends[e]
    }

    /// The vertices inside edge `e`, from its upper to its lower end.
    pub(crate) fn inside(&self, e: usize) -> &[u32] {
        match self
            .split
            .binary_search_by_key(&e, |&(edge, ..)| edge as usize)
        {
            Ok(at) => &self.inside[self.split[at].1 as usize..self.split[at].2 as usize],
            Err(_) => &[],
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{EdgeChainBuilder, narrow};
    use crate::error::Error;

    const LIMIT: usize = 1 << 10;

    /// Notes for so many equal edges that may not pass through more vertices than [`LIMIT`].
    fn notes_of(edges: usize) -> EdgeChainBuilder {
        EdgeChainBuilder {
            limit: LIMIT,
            ..EdgeChainBuilder::new(Arc::new(vec![[0, 1]; edges]))
        }
    }

    #[test]
    fn more_vertices_than_can_be_held_are_an_error() {
        let limit = Err(Error::TooManyVerticesOnEdges { limit: LIMIT });
        let mut notes = notes_of(2);
        for vertex in 0..narrow(LIMIT) {
            assert_eq!(notes.pass(vertex % 2, vertex), Ok(()));
        }
        assert_eq!(notes.pass(0, 7), limit);
        assert_eq!(notes.pass(1, 7), limit);
        assert_eq!(notes.finish().inside.len(), LIMIT);
    }

    #[cfg(feature = "parallel")]
    #[test]
    fn those_of_all_bands_count() {
        let notes = |count| {
            let mut notes = notes_of(1);
            (0..count).for_each(|vertex| notes.pass(0, vertex).expect("few"));
            notes
        };
        let half = narrow(LIMIT / 2);
        assert_eq!(notes(half).append(notes(half)), Ok(()));
        let limit = Err(Error::TooManyVerticesOnEdges { limit: LIMIT });
        assert_eq!(notes(half).append(notes(half + 1)), limit);
    }
}
