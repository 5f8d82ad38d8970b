//! What the verifier of streams keeps: vertices that may still be named, and sides with one triangle.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use foldhash::fast::RandomState;

use super::violation::StreamViolation;
use sweep_cdt::scalar::{Scalar, orient2d};

/// A map by number. Its hashes are seeded at random, so that no choice of numbers makes it slow.
pub(super) type Map<K, V> = std::collections::HashMap<K, V, RandomState>;

/// The vertices that are kept. Each has a slot, which another one may have later: while a side waits, its ends are kept,
/// so sides name slots. All else names numbers.
pub(super) struct Vertices<S> {
    slots: Map<u64, usize>,
    kept: Vec<Option<Vertex<S>>>,
    free: Vec<usize>,
}

impl<S> Vertices<S> {
    pub(super) fn new() -> Self {
        Vertices {
            slots: Map::default(),
            kept: Vec::new(),
            free: Vec::new(),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.slots.len()
    }

    pub(super) fn slot(&self, number: u64) -> Option<usize> {
        self.slots.get(&number).copied()
    }

    pub(super) fn get(&self, number: u64) -> Option<&Vertex<S>> {
        self.kept[self.slot(number)?].as_ref()
    }

    pub(super) fn get_mut(&mut self, number: u64) -> Option<&mut Vertex<S>> {
        let slot = self.slot(number)?;
        self.kept[slot].as_mut()
    }

    /// The vertex in a slot, which has one.
    pub(super) fn at(&self, slot: usize) -> &Vertex<S> {
        self.kept[slot].as_ref().expect("a vertex that is kept")
    }

    pub(super) fn at_mut(&mut self, slot: usize) -> &mut Vertex<S> {
        self.kept[slot].as_mut().expect("a vertex that is kept")
    }

    /// Keeps a vertex whose number is new.
    pub(super) fn insert(&mut self, vertex: Vertex<S>) {
        let slot = self.free.pop().unwrap_or(self.kept.len());
        self.slots.insert(vertex.number, slot);
        match self.kept.get_mut(slot) {
            Some(free) => *free = Some(vertex),
            None => self.kept.push(Some(vertex)),
        }
    }

    pub(super) fn remove(&mut self, number: u64) -> Option<Vertex<S>> {
        let slot = self.slots.remove(&number)?;
        self.free.push(slot);
        self.kept[slot].take()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Vertex<S>> + Clone {
        self.kept.iter().flatten()
    }
}

/// A vertex that may still be named.
pub(super) struct Vertex<S> {
    pub(super) number: u64,
    pub(super) point: [S; 2],
    /// The numbers of the vertices that are declared to equal it.
    pub(super) duplicates: Vec<u64>,
    /// Sides of triangles that have come, and whose other triangle has not.
    pub(super) open: u32,
    /// Sides that an edge must take, and none has.
    pub(super) unclaimed: u32,
    /// Whether a triangle has this corner.
    pub(super) is_used: bool,
    /// The runs up from here that edges may take.
    pub(super) up: BTreeMap<Towards<S>, Up<S>>,
    /// The lower ends of the runs that end here.
    pub(super) down: BTreeMap<Towards<S>, u64>,
    /// The edges that begin or pass here, and wait for a side.
    pub(super) waiting: BTreeMap<Towards<S>, Ends<S>>,
}

/// The upper ends of edges in one direction, and the edges that end there.
pub(super) type Ends<S> = BTreeMap<Place<S>, Vec<u64>>;

/// A place, in the order of the sweep: by y, then by x.
#[derive(Clone)]
pub(super) struct Place<S>(pub(super) [S; 2]);

/// A direction from a place, counter-clockwise. Directions are compared from one place alone, and either all lead up or
/// all lead down.
pub(super) struct Towards<S> {
    pub(super) from: [S; 2],
    pub(super) to: [S; 2],
}

impl<S: Clone> Towards<S> {
    pub(super) fn new(from: &[S; 2], to: &[S; 2]) -> Self {
        let (from, to) = (from.clone(), to.clone());
        Towards { from, to }
    }
}

impl<S: Scalar> Ord for Place<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        let ([ax, ay], [bx, by]) = (&self.0, &other.0);
        ay.compare(by).then_with(|| ax.compare(bx))
    }
}

impl<S: Scalar> Ord for Towards<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        orient2d(&self.from, &self.to, &other.to).reverse()
    }
}

impl<S> Vertex<S> {
    /// A vertex that nothing has named.
    pub(super) fn new(number: u64, point: [S; 2]) -> Self {
        Vertex {
            number,
            point,
            duplicates: Vec::new(),
            open: 0,
            unclaimed: 0,
            is_used: false,
            up: BTreeMap::new(),
            down: BTreeMap::new(),
            waiting: BTreeMap::new(),
        }
    }
}

/// A run up from a vertex: a side, or sides in one line, joined where the vertices between them are forgotten.
pub(super) struct Up<S> {
    pub(super) high: u64,
    pub(super) point: [S; 2],
    /// Whether an edge has taken the run.
    pub(super) is_taken: bool,
    /// What is wrong if none does.
    pub(super) unless_taken: Option<StreamViolation>,
}

/// A side with one triangle.
pub(super) struct Open<S> {
    /// The corner opposite, and where it is.
    pub(super) apex: [S; 2],
    /// Whether the triangle passes the side from the lower slot to the higher.
    pub(super) is_upward: bool,
    /// Whether the triangle says that the side is constrained, if it says.
    pub(super) is_constrained: Option<bool>,
}

impl<S: Scalar> PartialOrd for Place<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for Place<S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for Place<S> {}

impl<S: Scalar> PartialOrd for Towards<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for Towards<S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for Towards<S> {}
