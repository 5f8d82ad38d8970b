//! The ranks of x: the different x of all vertices, numbered from left to right before the sweep starts.
//!
//! A structure that keeps ranks compares no coordinates. The rank of a vertex on the front is read from an
//! array. A search names x only; but nearly always it is for the vertex after the last one that joined the
//! front, so that is tried first. If x differs, binary search finds the rank.
//!
//! Cost: a sort at the start, 12 bytes a vertex, O(1) for a rank in a sweep, and O(log n) otherwise.

use sweep_cdt::front::{Domain, FrontNode};

use super::structure::Work;

#[derive(Clone, Debug, Default)]
pub(super) struct XRanks {
    /// The different x, ascending.
    xs: Vec<f64>,
    /// The rank of x of each vertex.
    of_vertex: Vec<u32>,
    /// The vertex after the last one that joined the front.
    next: usize,
}

impl XRanks {
    pub(super) fn new(domain: Domain<'_>, work: &mut Work) -> XRanks {
        let n = u32::try_from(domain.len()).expect("vertices are numbered in 32 bits");
        let mut order: Vec<(f64, u32)> = (0..n).map(|v| (domain.x(v as usize), v)).collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut ranks = XRanks {
            xs: Vec::new(),
            of_vertex: vec![0; order.len()],
            next: 0,
        };
        for (x, v) in order {
            if ranks.xs.last() != Some(&x) {
                ranks.xs.push(x);
            }
            ranks.of_vertex[v as usize] =
                u32::try_from(ranks.xs.len() - 1).expect("no more than vertices");
        }
        work.bytes += (size_of_val(&ranks.xs[..]) + size_of_val(&ranks.of_vertex[..])) as u64;
        ranks
    }

    /// How many different x there are.
    pub(super) fn len(&self) -> usize {
        self.xs.len()
    }

    /// The rank of a node that joins the front.
    pub(super) fn join(&mut self, node: FrontNode) -> usize {
        self.next = node.rank() + 1;
        self.of(node)
    }

    /// The rank of a node.
    pub(super) fn of(&self, node: FrontNode) -> usize {
        self.of_vertex[node.rank()] as usize
    }

    /// The rank of the greatest x that is at most this one.
    pub(super) fn last_up_to(&self, x: f64, work: &mut Work) -> Option<usize> {
        work.comparisons += 1;
        if let Some(&rank) = self.of_vertex.get(self.next)
            && self.xs[rank as usize] == x
        {
            return Some(rank as usize);
        }
        let place = self.xs.partition_point(|&other| {
            work.comparisons += 1;
            other <= x
        });
        place.checked_sub(1)
    }
}
