//! Any of the library's search structures, chosen at run time.

use sweep_cdt::Watch;
use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, HashTable, Linear, SkipList};

/// One of the library's search structures, by name or by value.
#[derive(Clone, Debug)]
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

    /// What a run with this structure is given; the default is left to the sweep, which calls its own directly.
    pub fn watch(&mut self) -> Watch<'_> {
        match self {
            AnyFront::HashTable(_) => Watch::new(),
            other => Watch::new().front(other),
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

impl FrontSearch for AnyFront {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.structure().begin(input);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.structure().locate(x, front)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.structure().inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.structure().removed(node, x);
    }
}
