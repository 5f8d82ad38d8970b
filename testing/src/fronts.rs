//! Fronts that are chosen when the program runs.
//!
//! The compiler makes a sweep for each scalar with each front, which takes most of the time that the tests
//! need to compile. With [`AnyFront`] it makes one for each scalar.

use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Heuristics, Triangulation, Triangulator};

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

/// Any of the crate's search structures.
#[derive(Clone, Debug)]
enum AnyFront {
    HashTable(HashTable),
    SkipList(SkipList),
    Linear(Linear),
}

impl From<FrontKind> for AnyFront {
    fn from(kind: FrontKind) -> AnyFront {
        match kind {
            FrontKind::HashTable => AnyFront::HashTable(HashTable::default()),
            FrontKind::SkipList => AnyFront::SkipList(SkipList::default()),
            FrontKind::Linear => AnyFront::Linear(Linear::default()),
        }
    }
}

impl FrontSearch for AnyFront {
    fn begin(&mut self, domain: Domain<'_>) {
        match self {
            AnyFront::HashTable(search) => search.begin(domain),
            AnyFront::SkipList(search) => search.begin(domain),
            AnyFront::Linear(search) => search.begin(domain),
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

/// What a run chooses, beside the scalar.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The front.
    pub front: FrontKind,
    /// The heuristics.
    pub heuristics: Heuristics,
    /// The algorithm.
    pub algorithm: Algorithm,
    /// How many bands are swept at the same time, if there is more than one.
    #[cfg(feature = "parallel")]
    pub bands: usize,
}

impl Default for Choice {
    fn default() -> Choice {
        Choice {
            front: FrontKind::HashTable,
            heuristics: Heuristics::FAST,
            algorithm: Algorithm::Sweep,
            #[cfg(feature = "parallel")]
            bands: 1,
        }
    }
}

/// Triangulates as chosen.
///
/// # Errors
/// As [`Triangulator::triangulate`].
pub fn triangulate<S: Scalar + Sync>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    choice: Choice,
) -> Result<Triangulation, Error> {
    let triangulator = Triangulator::new()
        .front(AnyFront::from(choice.front))
        .heuristics(choice.heuristics)
        .algorithm(choice.algorithm);
    #[cfg(feature = "parallel")]
    if choice.bands > 1 {
        return triangulator
            .bands(choice.bands)
            .triangulate_parallel(points, edges);
    }
    triangulator.triangulate(points, edges)
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
    observe_with(points, edges, AnyFront::from(front), heuristics, observer)
}

/// The same with a front of any type.
///
/// # Errors
/// As [`Triangulator::triangulate_observed`].
pub fn observe_with<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    front: impl FrontSearch + Clone,
    heuristics: Heuristics,
    observer: &mut dyn FnMut(Event),
) -> Result<Triangulation, Error> {
    let triangulator = Triangulator::new().front(front).heuristics(heuristics);
    let run = triangulator.triangulate_observed(points, edges, observer)?;
    Ok(run.triangulation)
}
