//! Any of the crate's search structures, chosen at run time: an indirect call more, except for the hash table.

use core::any::Any;

use super::hash_table::HashTable;
use super::linear::Linear;
use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};
use super::skip_list::SkipList;

/// One of the crate's search structures, by name or by value.
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt::front::AnyFront;
///
/// let names: Vec<&str> = AnyFront::all().iter().map(AnyFront::name).collect();
/// assert_eq!(names, ["hash", "skip-list", "linear"]);
///
/// let front = AnyFront::named("skip-list").expect("one of the names");
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
/// let run = Triangulator::new().front(front).triangulate_with_stats(&points, &[])?;
/// assert_eq!((run.triangulation.len(), run.front.name()), (1, "skip-list"));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum AnyFront {
    /// The default: `hash`.
    HashTable(HashTable),
    /// `skip-list`.
    SkipList(SkipList),
    /// `linear`.
    Linear(Linear),
}

impl AnyFront {
    /// A new structure of each kind; the default comes first.
    pub fn all() -> [AnyFront; 3] {
        [
            AnyFront::HashTable(HashTable::default()),
            AnyFront::SkipList(SkipList::default()),
            AnyFront::Linear(Linear::default()),
        ]
    }

    /// A new structure of the kind with this [`name`](AnyFront::name), if there is one.
    pub fn named(name: &str) -> Option<AnyFront> {
        AnyFront::all()
            .into_iter()
            .find(|front| front.name() == name)
    }

    /// The name of the structure's kind.
    pub fn name(&self) -> &'static str {
        match self {
            AnyFront::HashTable(_) => "hash",
            AnyFront::SkipList(_) => "skip-list",
            AnyFront::Linear(_) => "linear",
        }
    }

    fn structure(&mut self) -> &mut dyn FrontSearch {
        match self {
            AnyFront::HashTable(structure) => structure,
            AnyFront::SkipList(structure) => structure,
            AnyFront::Linear(structure) => structure,
        }
    }
}

impl Default for AnyFront {
    fn default() -> AnyFront {
        AnyFront::HashTable(HashTable::default())
    }
}

// All functions are forwarded: a default of the trait would stand for a structure that does without it.
impl FrontSearch for AnyFront {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.structure().begin(input);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.structure().locate(x, front)
    }

    fn wants_ranks(&mut self, steps: usize) -> bool {
        self.structure().wants_ranks(steps)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.structure().inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.structure().removed(node, x);
    }

    fn as_any(&mut self) -> Option<&mut dyn Any> {
        self.structure().as_any()
    }
}
