//! Parts that several structures are made of: the ranks of x for [`super::number_set`] and
//! [`super::rank_table`], equal intervals of x for [`super::uniform_table`] and [`super::fixed_table`], the nodes of a
//! tree and numbers that look random for [`super::treap`] and [`super::sample_tree`].

use sweep_cdt::front::{FrontInput, FrontNode, Work};

/// The ranks of x: the different x of all vertices, numbered from left to right before the sweep starts.
///
/// A structure that keeps ranks compares no coordinates. The rank of a vertex on the front is read from an
/// array. A search names x only; but nearly always it is for the vertex after the last one that joined the
/// front, so that is tried first. If x differs, binary search finds the rank.
///
/// Cost: a sort at the start, 12 bytes a vertex, O(1) for a rank in a sweep, and O(log n) otherwise.
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
    pub(super) fn new(input: FrontInput<'_>, work: &mut Work) -> XRanks {
        let n = u32::try_from(input.len()).expect("vertices are numbered in 32 bits");
        let mut order: Vec<(f64, u32)> = (0..n).map(|v| (input.x(v as usize), v)).collect();
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

/// Equal intervals between the least and the greatest finite x.
#[derive(Clone, Debug, Default)]
pub(super) struct EqualIntervals {
    count: usize,
    /// `x` lies in interval number `(x - low) * factor`.
    low: f64,
    factor: f64,
}

impl EqualIntervals {
    /// So many intervals, one at least.
    pub(super) fn new(input: FrontInput<'_>, count: usize) -> EqualIntervals {
        let xs = (0..input.len()).map(|v| input.x(v));
        let ends = xs
            .filter(|x| x.is_finite())
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                [low.min(x), high.max(x)]
            });
        let mut intervals = EqualIntervals {
            count,
            ..EqualIntervals::default()
        };
        let factor = count as f64 / (ends[1] - ends[0]);
        if factor.is_finite() && factor > 0.0 {
            (intervals.low, intervals.factor) = (ends[0], factor);
        }
        intervals
    }

    /// The number of the interval of `x`.
    pub(super) fn number(&self, x: f64) -> usize {
        // Saturates; what is no number is 0.
        let number = ((x - self.low) * self.factor) as usize;
        number.min(self.count - 1)
    }
}

/// The head, and no child.
pub(super) const NONE: u32 = 0;
/// The two sides of a node.
pub(super) const LEFT: usize = 0;
pub(super) const RIGHT: usize = 1;

/// A node of the front with its x, in the order of the tree.
pub(super) type Key = (f64, FrontNode);

#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub(super) key: Key,
    pub(super) children: [u32; 2],
}

/// The nodes of a binary search tree in one array.
///
/// Place 0 is no node but the head: its right child is the root, and 0 as a child means none. Places of
/// nodes that were taken out are used again.
#[derive(Clone, Debug)]
pub(super) struct Arena {
    branches: Vec<Branch>,
    free: Vec<u32>,
}

impl Default for Arena {
    fn default() -> Arena {
        let head = Branch {
            key: (f64::NEG_INFINITY, FrontNode::from_rank(0)),
            children: [NONE; 2],
        };
        Arena {
            branches: vec![head],
            free: Vec::new(),
        }
    }
}

impl Arena {
    /// All places ever used, the head among them.
    pub(super) fn len(&self) -> usize {
        self.branches.len()
    }

    /// A place for a node without children.
    pub(super) fn add(&mut self, key: Key) -> u32 {
        let branch = Branch {
            key,
            children: [NONE; 2],
        };
        if let Some(place) = self.free.pop() {
            self.branches[place as usize] = branch;
            return place;
        }
        self.branches.push(branch);
        u32::try_from(self.branches.len() - 1).expect("no more nodes than vertices")
    }

    /// Forgets a node, which no other has as its child.
    pub(super) fn free(&mut self, place: u32) {
        self.free.push(place);
    }

    pub(super) fn key(&self, place: u32) -> Key {
        self.branches[place as usize].key
    }

    pub(super) fn child(&self, place: u32, side: usize) -> u32 {
        self.branches[place as usize].children[side]
    }

    pub(super) fn set_child(&mut self, place: u32, side: usize, child: u32) {
        self.branches[place as usize].children[side] = child;
    }

    pub(super) fn root(&self) -> u32 {
        self.child(NONE, RIGHT)
    }

    pub(super) fn set_root(&mut self, root: u32) {
        self.set_child(NONE, RIGHT, root);
    }
}

/// A number that looks random, from the rank of a node and a seed: the same one in every run (the finalizer of Steele, Lea and Flood's `SplitMix64`).
pub(super) fn mixed(node: FrontNode, seed: u64) -> u64 {
    let mut z = (node.rank() as u64 + 1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(seed);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
