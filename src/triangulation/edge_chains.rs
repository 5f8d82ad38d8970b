//! The vertices along each input edge: noted while the edges are inserted, looked up in the result.
//!
//! Edges are inserted from their upper ends down, and their vertices noted in this order. Whether an edge runs up, from
//! its first end to its second, is kept in a bit of its ends that no number of a point needs.

use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::error::Error;
use crate::ids::narrow;

/// How many vertices all edges together may pass through.
const LIMIT: usize = 1 << 28;

/// The mark of an edge that runs up, in the number of its upper end.
const RUNS_UP: u32 = 1 << 31;

/// The ends of an edge as representatives, upper end first, and whether the edge runs up.
#[inline]
pub(crate) fn marked([upper, lower]: [u32; 2], runs_up: bool) -> [u32; 2] {
    [upper | if runs_up { RUNS_UP } else { 0 }, lower]
}

/// The ends of a marked edge, upper end first.
fn unmarked([upper, lower]: [u32; 2]) -> [u32; 2] {
    [upper & !RUNS_UP, lower]
}

/// The notes of the insertion of edges. Vertices are input indices.
#[derive(Debug, Default)]
pub(crate) struct EdgeChainBuilder {
    /// The [`marked`] ends of each edge.
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
    /// The [`marked`] ends of each edge.
    ends: Vec<[u32; 2]>,
    /// `(edge, from, to)`, sorted: the vertices inside the edge are `inside[from..to]`, upper ones first. Equal edges
    /// share a range.
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
        unmarked(self.ends[a as usize]) == unmarked(self.ends[b as usize])
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
    /// The chains of edges with these vertices along them, at least one each; `None` if they are too many. There are no
    /// coordinates, so each edge counts as one that runs down.
    #[cfg(feature = "serde")]
    pub(crate) fn of(lists: &[Vec<u32>]) -> Option<EdgeChains> {
        if lists.len() > LIMIT {
            return None;
        }
        let ends = lists
            .iter()
            .map(|list| Some([*list.first()?, *list.last()?]));
        let mut notes = EdgeChainBuilder::new(Arc::new(ends.collect::<Option<_>>()?));
        for (list, edge) in lists.iter().zip(0..) {
            let inside = list.get(1..list.len() - 1).unwrap_or(&[]);
            for &vertex in inside {
                notes.pass(edge, vertex).ok()?;
            }
        }
        Some(notes.finish())
    }

    pub(crate) fn into_ends(self) -> Vec<[u32; 2]> {
        self.ends
    }

    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The ends of edge `e`, from its first to its second.
    pub(crate) fn ends(&self, e: usize) -> [u32; 2] {
        let [upper, lower] = unmarked(self.ends[e]);
        if self.runs_up(e) {
            [lower, upper]
        } else {
            [upper, lower]
        }
    }

    fn runs_up(&self, e: usize) -> bool {
        self.ends[e][0] & RUNS_UP != 0
    }

    /// The vertices along edge `e`, from its first end to its second: a single one, if the ends are equal.
    pub(crate) fn chain(&self, e: usize) -> impl ExactSizeIterator<Item = u32> + Clone + '_ {
        let [first, last] = self.ends(e);
        let edge = |&(edge, ..): &(u32, u32, u32)| edge as usize;
        let inside = match self.split.binary_search_by_key(&e, edge) {
            Ok(at) => &self.inside[self.split[at].1 as usize..self.split[at].2 as usize],
            Err(_) => &[],
        };
        let runs_up = self.runs_up(e);
        let length = inside.len() + if first == last { 1 } else { 2 };
        (0..length).map(move |at| match at {
            0 => first,
            at if at + 1 == length => last,
            at if runs_up => inside[inside.len() - at],
            at => inside[at - 1],
        })
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
