//! What the verifier of streams keeps: vertices that may still be named, and sides with one triangle.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::violation::StreamViolation;
use crate::scalar::{Scalar, filtered_orient2d};

/// A map by number, which no choice of numbers makes slow.
#[cfg(feature = "std")]
pub(super) type Map<K, V> = std::collections::HashMap<K, V>;
#[cfg(not(feature = "std"))]
pub(super) type Map<K, V> = alloc::collections::BTreeMap<K, V>;

/// A vertex that may still be named.
pub(super) struct Vertex<S> {
    pub(super) point: [S; 2],
    /// Sides of triangles that have come, and whose other triangle has not.
    pub(super) open: u32,
    /// Sides that an edge must take, and none has.
    pub(super) unclaimed: u32,
    /// Whether a triangle has this corner.
    pub(super) is_used: bool,
    /// Whether the vertex was closed when closed ones were last forgotten.
    pub(super) was_closed: bool,
    /// The sides up from here that edges may take.
    pub(super) up: BTreeMap<Towards<S>, Up<S>>,
    /// The edges that begin or pass here, and wait for a side.
    pub(super) waiting: BTreeMap<Towards<S>, Ends<S>>,
}

/// The upper ends of edges in one direction, and the edges that end there.
pub(super) type Ends<S> = BTreeMap<Place<S>, Vec<u64>>;

/// A place, in the order of the sweep: by y, then by x.
#[derive(Clone)]
pub(super) struct Place<S>(pub(super) [S; 2]);

/// A direction up from a place, counter-clockwise. Directions are compared from one place alone.
pub(super) struct Towards<S> {
    pub(super) from: [S; 2],
    pub(super) to: [S; 2],
}

impl<S: Scalar> Ord for Place<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        let ([ax, ay], [bx, by]) = (&self.0, &other.0);
        ay.compare(by).then_with(|| ax.compare(bx))
    }
}

impl<S: Scalar> Ord for Towards<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        filtered_orient2d(&self.from, &self.to, &other.to).reverse()
    }
}

impl<S> Vertex<S> {
    /// Whether nothing that is right can name the vertex.
    pub(super) fn is_closed(&self) -> bool {
        self.is_used && self.open == 0 && self.unclaimed == 0 && self.waiting.is_empty()
    }
}

/// A side up from a vertex.
pub(super) struct Up<S> {
    pub(super) high: u64,
    pub(super) point: [S; 2],
    /// Whether an edge has taken the side.
    pub(super) is_taken: bool,
    /// What is wrong if none does.
    pub(super) unless_taken: Option<StreamViolation>,
}

/// A side with one triangle.
pub(super) struct Open<S> {
    /// The corner opposite, and where it is.
    pub(super) apex: [S; 2],
    /// Whether the triangle passes the side from the lower number to the higher.
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
