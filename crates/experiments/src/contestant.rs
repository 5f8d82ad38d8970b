//! The structures that take part in the experiments, each with a name.

use std::fmt;
use std::rc::Rc;

use sweep_cdt::front::{HashTable, Linear, SkipList};
use sweep_cdt::{Algorithm, Error, Heuristics, Stats, Triangulator, Watch};
use sweep_cdt_testing::Input;

use crate::fronts::{
    AnyFront, BTree, BitSet, Finger, FixedTable, FromEnd, LearnedTable, RankTable, SampleTree,
    SampledUniverse, SortedArray, Structure, Treap, TwoFingers, UniformTable, VanEmdeBoas,
};

/// A run of the sweep whose time counts.
type Run = dyn Fn(&Input, Algorithm, Heuristics) -> Result<Stats, Error>;

/// A search structure with a name.
#[derive(Clone)]
pub struct Contestant {
    name: String,
    front: AnyFront,
    run: Rc<Run>,
    is_linear: bool,
}

impl Contestant {
    /// A structure under a name that no other contestant has.
    ///
    /// The sweep calls it through `dyn`, which costs a vertex some three indirect calls.
    pub fn new(name: &str, structure: impl Structure) -> Contestant {
        Contestant {
            name: name.to_owned(),
            front: AnyFront::new(structure.clone()),
            run: Rc::new(move |input, algorithm, heuristics| {
                let triangulator = Triangulator::new()
                    .algorithm(algorithm)
                    .heuristics(heuristics);
                let (mut front, mut stats) = (structure.clone(), Stats::default());
                let watch = Watch::new().front(&mut front).stats(&mut stats);
                triangulator.run(&input.points, &input.edges, watch)?;
                Ok(stats)
            }),
            is_linear: false,
        }
    }

    /// Counts the contestant's work with another structure, which takes the same steps and counts them: for a
    /// structure that is timed without counts.
    #[must_use]
    pub fn counted_by(self, structure: impl Structure) -> Contestant {
        Contestant {
            front: AnyFront::new(structure),
            ..self
        }
    }

    /// Says that searches or updates take time that grows with the length of the front: the contestant is left
    /// out where that would take very long.
    #[must_use]
    pub fn linear(self) -> Contestant {
        Contestant {
            is_linear: true,
            ..self
        }
    }

    /// The name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The structure.
    pub fn front(&self) -> &AnyFront {
        &self.front
    }

    /// Whether its time grows with the length of the front.
    pub fn is_linear(&self) -> bool {
        self.is_linear
    }

    /// Sweeps with the structure whose time counts.
    ///
    /// # Errors
    /// As [`Triangulator::triangulate`].
    pub fn run(
        &self,
        input: &Input,
        algorithm: Algorithm,
        heuristics: Heuristics,
    ) -> Result<Stats, Error> {
        (self.run)(input, algorithm, heuristics)
    }
}

impl fmt::Debug for Contestant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Contestant").field(&self.name).finish()
    }
}

/// The seed of the structures that draw random numbers.
const SEED: u64 = 1;

/// All structures of the crate and of this one; the crate's default is the first.
pub fn standard() -> Vec<Contestant> {
    vec![
        Contestant::new("hash table (default)", HashTable::default())
            .counted_by(HashTable::counting()),
        // A control: what it costs to count while the time counts, as most others do.
        Contestant::new("hash table, counting", HashTable::counting()),
        Contestant::new(
            "uniform table, 2 sqrt(n)",
            UniformTable::new(|n| 2 * n.isqrt()),
        ),
        Contestant::new("uniform table, n/10", UniformTable::new(|n| n / 10)),
        Contestant::new("uniform table, n/100", UniformTable::new(|n| n / 100)),
        Contestant::new("hash over ranks", RankTable::default()),
        Contestant::new("learned table", LearnedTable::default()),
        Contestant::new("fixed table, 1024", FixedTable::<1024>::default()).linear(),
        Contestant::new("fixed table, 32", FixedTable::<32>::default()).linear(),
        Contestant::new("bit set over ranks", BitSet::default()),
        Contestant::new("van Emde Boas tree", VanEmdeBoas::default()),
        Contestant::new("sampled universe", SampledUniverse::default()),
        Contestant::new("skip list", SkipList::default()).counted_by(SkipList::counting()),
        Contestant::new("treap", Treap::new(SEED)),
        Contestant::new("B-tree", BTree::default()),
        Contestant::new("splay tree, 10 % sample", SampleTree::new(10, SEED)),
        Contestant::new("sorted array", SortedArray::default()).linear(),
        Contestant::new("finger", Finger::default()).linear(),
        Contestant::new("two fingers", TwoFingers::default()).linear(),
        Contestant::new("walk from the last node", Linear::default()).linear(),
        Contestant::new("walk from the end", FromEnd).linear(),
    ]
}
