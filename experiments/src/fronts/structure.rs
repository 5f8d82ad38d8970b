//! What the experiments ask of a search structure beyond [`FrontSearch`]: the work it has done.
//!
//! The simplest structure, the walk from the left end, is here too, and so are two that hold another one: one
//! forgets its type, the other watches it and the front.

use std::fmt;

use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch, HashTable, Linear, SkipList, Work};

/// A search structure for the front that can be compared with the others.
///
/// A structure of your own needs [`FrontSearch`] and an empty implementation of this trait:
/// `examples/own_structure.rs`.
pub trait Structure: FrontSearch + Clone + 'static {
    /// The work since the run began, if it is counted. It is counted while time is measured, too: that is an
    /// addition to a field.
    fn work(&self) -> Option<Work> {
        None
    }
}

impl Structure for HashTable {}
impl Structure for SkipList {}

impl Structure for HashTable<Work> {
    fn work(&self) -> Option<Work> {
        Some(HashTable::work(self))
    }
}

impl Structure for SkipList<Work> {
    fn work(&self) -> Option<Work> {
        Some(SkipList::work(self))
    }
}

impl Structure for Linear {
    fn work(&self) -> Option<Work> {
        // It looks at nothing but the node that it names.
        Some(Work::default())
    }
}

/// The walk from the left end: no structure at all, and no memory of the last place either.
///
/// Cost: O(n) for a search on a front of n nodes, all of it steps of the sweep.
#[derive(Clone, Copy, Debug, Default)]
pub struct FromEnd;

impl FrontSearch for FromEnd {
    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.left_end()
    }
}

impl Structure for FromEnd {
    fn work(&self) -> Option<Work> {
        Some(Work::default())
    }
}

/// Any [`Structure`]: its type is chosen when the program runs.
///
/// With it one compiled sweep serves all structures where time does not matter: to count, and in tests.
pub struct AnyFront(Box<dyn Object>);

impl AnyFront {
    /// This structure, its type forgotten.
    pub fn new(structure: impl Structure) -> AnyFront {
        AnyFront(Box::new(structure))
    }
}

impl Clone for AnyFront {
    fn clone(&self) -> AnyFront {
        AnyFront(self.0.copy())
    }
}

impl fmt::Debug for AnyFront {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("AnyFront").field(&self.0.work()).finish()
    }
}

impl FrontSearch for AnyFront {
    fn begin(&mut self, domain: Domain<'_>) {
        self.0.front().begin(domain);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.0.front().locate(x, front)
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.0.front().strayed(steps)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.0.front().inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.0.front().removed(node, x);
    }
}

impl Structure for AnyFront {
    fn work(&self) -> Option<Work> {
        self.0.work()
    }
}

/// A structure whose type is forgotten.
trait Object {
    fn front(&mut self) -> &mut dyn FrontSearch;
    fn work(&self) -> Option<Work>;
    fn copy(&self) -> Box<dyn Object>;
}

impl<S: Structure> Object for S {
    fn front(&mut self) -> &mut dyn FrontSearch {
        self
    }

    fn work(&self) -> Option<Work> {
        Structure::work(self)
    }

    fn copy(&self) -> Box<dyn Object> {
        Box::new(self.clone())
    }
}

/// What a run asked of its structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Seen {
    pub(crate) searches: u64,
    /// Searches that named the node to the left of x, or at it: the sweep takes no step.
    pub(crate) hits: u64,
    /// How often it was told all vertices anew, with places in the place of x.
    pub(crate) rebuilds: u64,
    /// Vertices on the front now, and at most.
    pub(crate) length: u64,
    pub(crate) greatest_length: u64,
    /// The sum of the lengths at all searches.
    pub(crate) lengths: u64,
}

/// A structure, and what can be seen of the front from outside: the same for every structure.
#[derive(Clone, Debug)]
pub(crate) struct Watched<F> {
    pub(crate) structure: F,
    pub(crate) seen: Seen,
    /// The x of each vertex that has joined the front.
    xs: Vec<f64>,
}

impl<F> Watched<F> {
    pub(crate) fn new(structure: F) -> Watched<F> {
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
    fn begin(&mut self, domain: Domain<'_>) {
        // The front is told anew when places take the place of x.
        self.seen.length = 0;
        self.seen.rebuilds += u64::from(!self.xs.is_empty());
        self.xs = vec![0.0; domain.len()];
        self.structure.begin(domain);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.seen.searches += 1;
        self.seen.lengths += self.seen.length;
        let node = self.structure.locate(x, front);
        self.seen.hits += u64::from(self.is_hit(x, node, front));
        node
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.structure.strayed(steps)
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
    use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch};

    use super::{FromEnd, Seen, Watched};

    #[test]
    fn searches_hits_and_lengths_are_counted() {
        let mut watched = Watched::new(FromEnd);
        let points = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]];
        watched.begin(Domain::new(&points));
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
            rebuilds: 0,
            length: 2,
            greatest_length: 3,
            lengths: 1 + 2 + 3 + 2,
        };
        assert_eq!(watched.seen, expected);
        watched.begin(Domain::new(&points));
        assert_eq!((watched.seen.rebuilds, watched.seen.length), (1, 0));
    }
}
