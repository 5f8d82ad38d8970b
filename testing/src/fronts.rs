//! Fronts that are chosen when the program runs.
//!
//! The compiler makes a sweep for each scalar with each front, which takes most of the time that the tests
//! need to compile. With [`AnyFront`] it makes one for each scalar.

use std::cell::Cell;

use sweep_cdt::trace::Event;
use sweep_cdt::{
    Domain, Error, Front, FrontNode, FrontSearch, HashTable, Heuristics, Linear, Scalar, SkipList,
    Triangulation, Triangulator,
};

/// One of the crate's search structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrontKind {
    /// [`HashTable`], the default.
    HashTable,
    /// [`SkipList`].
    SkipList,
    /// [`Linear`].
    Linear,
}

impl FrontKind {
    /// Each of them, with its name.
    pub const ALL: [(&str, FrontKind); 3] = [
        ("hash table", FrontKind::HashTable),
        ("skip list", FrontKind::SkipList),
        ("linear", FrontKind::Linear),
    ];
}

thread_local! {
    /// What [`AnyFront::new`] makes on this thread.
    static KIND: Cell<FrontKind> = const { Cell::new(FrontKind::HashTable) };
}

/// Any of the crate's search structures.
enum AnyFront {
    HashTable(HashTable),
    SkipList(SkipList),
    Linear(Linear),
}

impl FrontSearch for AnyFront {
    fn new(domain: Domain<'_>) -> AnyFront {
        match KIND.get() {
            FrontKind::HashTable => AnyFront::HashTable(HashTable::new(domain)),
            FrontKind::SkipList => AnyFront::SkipList(SkipList::new(domain)),
            FrontKind::Linear => AnyFront::Linear(Linear::new(domain)),
        }
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        match self {
            AnyFront::HashTable(search) => search.locate(x, front),
            AnyFront::SkipList(search) => search.locate(x, front),
            AnyFront::Linear(search) => search.locate(x, front),
        }
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        match self {
            AnyFront::HashTable(search) => search.inserted(node, x),
            AnyFront::SkipList(search) => search.inserted(node, x),
            AnyFront::Linear(search) => search.inserted(node, x),
        }
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        match self {
            AnyFront::HashTable(search) => search.removed(node, x),
            AnyFront::SkipList(search) => search.removed(node, x),
            AnyFront::Linear(search) => search.removed(node, x),
        }
    }
}

/// Triangulates with this front.
///
/// # Errors
/// As [`Triangulator::triangulate`].
pub fn triangulate<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    front: FrontKind,
    heuristics: Heuristics,
) -> Result<Triangulation, Error> {
    KIND.set(front);
    Triangulator::new()
        .front::<AnyFront>()
        .heuristics(heuristics)
        .triangulate(points, edges)
}

/// The same, and passes every step to `observer`.
///
/// # Errors
/// As [`Triangulator::triangulate_observed`].
pub fn observe<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    front: FrontKind,
    heuristics: Heuristics,
    observer: &mut dyn FnMut(Event),
) -> Result<Triangulation, Error> {
    KIND.set(front);
    observe_with::<S, AnyFront>(points, edges, heuristics, observer)
}

/// The same with a front of any type.
///
/// # Errors
/// As [`Triangulator::triangulate_observed`].
pub fn observe_with<S: Scalar, F: FrontSearch>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    heuristics: Heuristics,
    observer: &mut dyn FnMut(Event),
) -> Result<Triangulation, Error> {
    Triangulator::new()
        .front::<F>()
        .heuristics(heuristics)
        .triangulate_observed(points, edges, observer)
}
