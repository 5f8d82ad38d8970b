//! A search structure and the front, seen from outside: searches, hits, lengths.
//!
//! The observer holds the structure and passes every call on, so it counts the same for every structure. It costs
//! an array of x, and time: runs whose time counts are made without it.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};

/// The calls that a run made of its structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Seen {
    pub(super) searches: u64,
    /// Searches that named the node to the left of x, or at it: the sweep takes no step.
    pub(super) hits: u64,
    /// Vertices on the front now, and at most.
    pub(super) length: u64,
    pub(super) greatest_length: u64,
    /// The sum of the lengths at all searches.
    pub(super) lengths: u64,
}

/// A structure, and what can be seen of the front from outside: the same for every structure.
#[derive(Clone, Debug)]
pub(super) struct Watched<F> {
    pub(super) structure: F,
    pub(super) seen: Seen,
    /// The x of each vertex that has joined the front.
    xs: Vec<f64>,
}

impl<F> Watched<F> {
    pub(super) fn new(structure: F) -> Watched<F> {
        Watched {
            structure,
            seen: Seen::default(),
            xs: Vec::new(),
        }
    }

    /// Whether the projection of x falls between this node and the next one.
    fn is_hit(&self, x: f64, node: FrontNode, front: &Front) -> bool {
        // Nothing comes after the right end.
        let is_beyond = |next: FrontNode| next == front.right_end() || self.xs[next.rank()] > x;
        let is_left = |node: FrontNode| node == front.left_end() || self.xs[node.rank()] <= x;
        front
            .after(node)
            .is_some_and(|next| is_left(node) && is_beyond(next))
    }
}

impl<F: FrontSearch> FrontSearch for Watched<F> {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.seen.length = 0;
        self.xs = vec![0.0; input.len()];
        self.structure.begin(input);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.seen.searches += 1;
        self.seen.lengths += self.seen.length;
        let node = self.structure.locate(x, front);
        self.seen.hits += u64::from(self.is_hit(x, node, front));
        node
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.seen.length += 1;
        self.seen.greatest_length = self.seen.greatest_length.max(self.seen.length);
        self.xs[node.rank()] = x;
        self.structure.inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.seen.length -= 1;
        self.structure.removed(node, x);
    }
}

#[cfg(test)]
mod tests {
    use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};

    use super::{Seen, Watched};
    use crate::fronts::FromEnd;

    #[test]
    fn searches_hits_and_lengths_are_counted() {
        let mut watched = Watched::new(FromEnd);
        let points = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]];
        watched.begin(FrontInput::new(&points));
        let mut front = Front::new(3);
        let mut left = front.left_end();
        for (rank, [x, _]) in points.into_iter().enumerate() {
            let node = FrontNode::from_rank(rank);
            front.insert(node, left);
            watched.inserted(node, x);
            // It names the left end: right for what lies to the left of all.
            watched.locate(x - 1.0, &front);
            left = node;
        }
        let middle = FrontNode::from_rank(1);
        assert!(watched.is_hit(2.0, middle, &front) && watched.is_hit(3.5, middle, &front));
        assert!(!watched.is_hit(4.0, middle, &front) && !watched.is_hit(1.5, middle, &front));
        assert!(watched.is_hit(4.0, left, &front));
        assert!(!watched.is_hit(4.0, front.right_end(), &front));
        front.remove(middle);
        watched.removed(middle, 2.0);
        watched.locate(-1.0, &front);
        let expected = Seen {
            searches: 4,
            hits: 2,
            length: 2,
            greatest_length: 3,
            lengths: 1 + 2 + 3 + 2,
        };
        assert_eq!(watched.seen, expected);
        watched.begin(FrontInput::new(&points));
        assert_eq!(watched.seen.length, 0);
    }
}
