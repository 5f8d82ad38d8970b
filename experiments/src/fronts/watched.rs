//! A structure, and what can be seen of the front from outside: the same for every structure.

use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch};

/// What a run asked of its structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Seen {
    pub(crate) searches: u64,
    /// Vertices on the front now, and at most.
    pub(crate) length: u64,
    pub(crate) greatest_length: u64,
    /// The sum of the lengths at all searches.
    pub(crate) lengths: u64,
}

/// A structure that is watched.
#[derive(Clone, Debug)]
pub(crate) struct Watched<F> {
    pub(crate) structure: F,
    pub(crate) seen: Seen,
}

impl<F> Watched<F> {
    pub(crate) fn new(structure: F) -> Watched<F> {
        Watched {
            structure,
            seen: Seen::default(),
        }
    }
}

impl<F: FrontSearch> FrontSearch for Watched<F> {
    fn begin(&mut self, domain: Domain<'_>) {
        // The front is told anew when places take the place of x.
        self.seen.length = 0;
        self.structure.begin(domain);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.seen.searches += 1;
        self.seen.lengths += self.seen.length;
        self.structure.locate(x, front)
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.structure.strayed(steps)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.seen.length += 1;
        self.seen.greatest_length = self.seen.greatest_length.max(self.seen.length);
        self.structure.inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.seen.length -= 1;
        self.structure.removed(node, x);
    }
}

#[cfg(test)]
mod tests {
    use sweep_cdt::front::{Front, FrontNode, FrontSearch};

    use super::{Seen, Watched};
    use crate::fronts::FromEnd;

    #[test]
    fn searches_and_lengths_are_counted() {
        let mut watched = Watched::new(FromEnd);
        let front = Front::new(3);
        for rank in 0..3 {
            watched.inserted(FrontNode::from_rank(rank), 0.0);
            watched.locate(0.0, &front);
        }
        watched.removed(FrontNode::from_rank(1), 0.0);
        watched.locate(0.0, &front);
        let expected = Seen {
            searches: 4,
            length: 2,
            greatest_length: 3,
            lengths: 1 + 2 + 3 + 2,
        };
        assert_eq!(watched.seen, expected);
    }
}
