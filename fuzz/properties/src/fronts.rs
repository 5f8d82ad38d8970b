//! A front structure may be slow, but never changes a step; and it keeps to its contract alone, too.
//!
//! Half of the inputs are swept with about one in four of the structures of the crate and of the experiments, and of two
//! that name nodes that are as bad as can be: the events must be those of the default structure. The other half is no
//! input of a sweep: points go on and off a front in ways that no sweep would take, and a list of them is the judge
//! (`test_alone`).

use arbitrary::{Result, Unstructured};
use sweep_cdt::Heuristics;
use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, HashTable, SkipList};
use sweep_cdt_experiments::fronts::AnyFront;
use sweep_cdt_experiments::{Contestant, standard};

use crate::file::File;
use crate::reached;
use sweep_cdt_testing::{Input, Random, Steps, generators};

/// One in so many structures is tried with an input of a fuzzer, which tries others with the next one.
const CHOSEN: usize = 4;

/// The property for the choices and the input, or the changes of a front, that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    // Reading is total but for a type that has no values.
    let choices: u64 = bytes.arbitrary().unwrap_or_default();
    if choices & 1 == 0 {
        let input = generators::read(&mut bytes).unwrap_or_default();
        reached::sample(&input);
        judge(&input, choices >> 1);
    } else {
        test_alone(&read_alone(&mut bytes).unwrap_or_default());
    }
}

/// The vertices and changes of a front, if the bytes stand for these.
pub fn files(bytes: &[u8]) -> Vec<File> {
    let mut bytes = Unstructured::new(bytes);
    let choices: u64 = bytes.arbitrary().unwrap_or_default();
    let alone = (choices & 1 != 0).then(|| read_alone(&mut bytes).unwrap_or_default());
    let text = alone.map(|(points, changes)| format!("points {points:?}\n{changes:#?}\n"));
    let file = text.map(|text| ("front.txt".to_owned(), text.into_bytes()));
    file.into_iter().collect()
}

/// The input that the bytes stand for, if it is swept.
pub fn input(bytes: &[u8]) -> Option<Input> {
    let (choices, input) = generators::input_with_choices(bytes);
    (choices & 1 == 0).then_some(input)
}

/// Panics unless the sweep of this input, all of whose coordinates are finite, takes the same steps with
/// each structure that is chosen.
fn judge(Input { points, edges }: &Input, choices: u64) {
    let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
    let heuristics = settings[(choices % 3) as usize];
    let steps = Steps::of(points, edges, heuristics);
    let random = &mut Random::new(choices / 3);
    let is_chosen = |random: &mut Random| random.one_in(CHOSEN);
    for mut front in sweep_cdt_testing::AnyFront::all() {
        if is_chosen(random) {
            let name = front.name();
            steps.assert_same(points, edges, &mut front, name);
        }
    }
    for contestant in standard() {
        if is_chosen(random) {
            let mut front = contestant.front().clone();
            steps.assert_same(points, edges, &mut front, contestant.name());
        }
    }
    if is_chosen(random) {
        let mut astray = Astray::default();
        steps.assert_same(points, edges, &mut astray, "a structure that leads astray");
    }
    if is_chosen(random) {
        steps.assert_same(points, edges, &mut Idle, "a structure that knows nothing");
    }
}

/// Names both ends and all nodes ever inserted in turn, as far as they are on the front.
#[derive(Clone, Default)]
struct Astray {
    nodes: Vec<FrontNode>,
    turn: usize,
}

impl FrontSearch for Astray {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.nodes.clear();
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        self.turn += 1;
        match self.turn % 3 {
            0 => front.left_end(),
            1 => front.right_end(),
            _ => {
                let node = self.nodes[self.turn % self.nodes.len()];
                if front.contains(node) {
                    node
                } else {
                    front.right_end()
                }
            }
        }
    }

    fn inserted(&mut self, node: FrontNode, _: f64) {
        self.nodes.push(node);
    }
}

/// Names the same end always.
#[derive(Clone, Default)]
struct Idle;

impl FrontSearch for Idle {
    fn begin(&mut self, input: FrontInput<'_>) {
        let count = input.len();
        assert_eq!(input.is_empty(), count == 0);
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.right_end()
    }
}

/// As many vertices at most without a sweep.
const VERTICES: usize = 100;

/// Coordinates that are drawn often without a sweep.
const SPECIAL: [f64; 12] = [
    0.0,
    -0.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    5e-324,
    -5e-324,
    1.0,
    1.0 + f64::EPSILON,
    1e9,
    -1e300,
];

/// An operation on a front without a sweep.
#[derive(Clone, Copy, Debug)]
enum Change {
    /// The next vertex goes on the front, before some of the equal ones.
    Insert(usize),
    /// One of the nodes goes off it.
    Remove(usize),
    Search(f64),
}

/// Points, and what happens to their front.
type Alone = (Vec<[f64; 2]>, Vec<Change>);

/// A byte for the number of vertices, their x, and then one change or search after the other.
fn read_alone(bytes: &mut Unstructured<'_>) -> Result<Alone> {
    let n = usize::from(bytes.arbitrary::<u8>()?) % (VERTICES + 1);
    let (mut points, mut changes) = Alone::default();
    for _ in 0..n {
        points.push([coordinate(bytes)?, 0.0]);
    }
    while !bytes.is_empty() {
        let place = usize::from(bytes.arbitrary::<u8>()?);
        changes.push(match place % 4 {
            0 => Change::Remove(place / 4),
            1 => Change::Search(coordinate(bytes)?),
            _ => Change::Insert(place / 4),
        });
    }
    Ok((points, changes))
}

/// Structures without a sweep, against a list.
///
/// The list holds the nodes of the front from left to right, and finds a place by looking at all. Doubles
/// near the coordinates may be equal where the coordinates are not, and infinite, so both are drawn here
/// and equal ones lie in any order.
fn test_alone((points, changes): &Alone) {
    let mut model = Model::new(points);
    for &change in changes {
        match change {
            Change::Remove(choice) if !model.nodes.is_empty() => model.remove(choice),
            Change::Search(x) => model.search(x),
            Change::Remove(choice) | Change::Insert(choice) => model.insert(choice),
        }
    }
}

/// A small integer, or one of the special numbers.
fn coordinate(bytes: &mut Unstructured<'_>) -> Result<f64> {
    let byte: i8 = bytes.arbitrary()?;
    let special = SPECIAL.get(usize::from(byte.unsigned_abs() / 4));
    Ok(match special {
        Some(&x) if byte % 2 == 0 => x,
        _ => f64::from(byte / 4),
    })
}

/// The nodes of the front, and the structures, which must know them.
struct Model<'a> {
    points: &'a [[f64; 2]],
    inserted: usize,
    /// From left to right.
    nodes: Vec<FrontNode>,
    front: Front,
    structures: Vec<(String, AnyFront)>,
}

/// The structures, the crate's two that count their work as those that do not, too.
fn structures() -> Vec<(String, AnyFront)> {
    let named = |contestant: Contestant| (contestant.name().to_owned(), contestant.front().clone());
    let mut structures: Vec<_> = standard().into_iter().map(named).collect();
    let hash_table = AnyFront::new(HashTable::default());
    structures.push(("hash table without counts".to_owned(), hash_table));
    let skip_list = AnyFront::new(SkipList::default());
    structures.push(("skip list without counts".to_owned(), skip_list));
    structures
}

impl Model<'_> {
    fn new(points: &[[f64; 2]]) -> Model<'_> {
        let input = FrontInput::new(points);
        let mut model = Model {
            points,
            inserted: 0,
            nodes: Vec::new(),
            front: Front::new(points.len()),
            structures: structures(),
        };
        for (_, structure) in &mut model.structures {
            structure.begin(input);
        }
        model
    }

    fn x(&self, node: FrontNode) -> f64 {
        self.points[node.rank()][0]
    }

    /// How many nodes have an x of at most this.
    fn place(&self, x: f64) -> usize {
        self.nodes.iter().filter(|&&node| self.x(node) <= x).count()
    }

    /// The node before a place on the list.
    fn before(&self, place: usize) -> FrontNode {
        place
            .checked_sub(1)
            .map_or(self.front.left_end(), |i| self.nodes[i])
    }

    /// Puts the next vertex on the front, before some of the equal ones.
    fn insert(&mut self, choice: usize) {
        let Some(&[x, _]) = self.points.get(self.inserted) else {
            return;
        };
        let node = FrontNode::from_rank(self.inserted);
        self.inserted += 1;
        let equal = self.nodes.iter().filter(|&&other| self.x(other) == x);
        let place = self.place(x) - choice % (equal.count() + 1);
        self.front.insert(node, self.before(place));
        self.nodes.insert(place, node);
        for (_, structure) in &mut self.structures {
            structure.inserted(node, x);
        }
        self.check();
    }

    fn remove(&mut self, choice: usize) {
        let node = self.nodes.remove(choice % self.nodes.len());
        let x = self.x(node);
        self.front.remove(node);
        for (_, structure) in &mut self.structures {
            structure.removed(node, x);
        }
        self.check();
    }

    /// Whether each structure names a node, from which the walk ends where the list says.
    fn search(&mut self, x: f64) {
        let expected = self.before(self.place(x));
        let structures = self.structures.iter_mut();
        let starts: Vec<_> = structures.map(|(_, s)| s.locate(x, &self.front)).collect();
        for ((name, _), start) in self.structures.iter().zip(starts) {
            assert!(
                self.front.contains(start),
                "{name}: {start:?} is not on the front"
            );
            assert_eq!(
                self.walk(start, x),
                expected,
                "{name}: from {start:?} (left) to {x}"
            );
        }
    }

    /// The last node whose x is at most this, from any node on.
    fn walk(&self, start: FrontNode, x: f64) -> FrontNode {
        let is_after = |&node: &FrontNode| {
            node == self.front.right_end() || (node != self.front.left_end() && self.x(node) > x)
        };
        let mut at = start;
        while is_after(&at) {
            at = self.front.before(at).expect("the left end is before all");
        }
        while let Some(next) = self.front.after(at).filter(|next| !is_after(next)) {
            at = next;
        }
        at
    }

    /// Whether the front is the list, in both directions.
    fn check(&self) {
        let ends = [self.front.left_end(), self.front.right_end()];
        let mut expected = vec![ends[0]];
        expected.extend(&self.nodes);
        expected.push(ends[1]);
        for pair in expected.windows(2) {
            assert_eq!(self.front.after(pair[0]), Some(pair[1]), "after");
            assert_eq!(self.front.before(pair[1]), Some(pair[0]), "before");
        }
        assert_eq!(self.front.before(ends[0]), None, "before the left end");
        assert_eq!(self.front.after(ends[1]), None, "after the right end");
        let on_front = (0..self.points.len()).map(FrontNode::from_rank);
        let count = on_front.filter(|&node| self.front.contains(node)).count();
        assert_eq!(count, self.nodes.len(), "vertices on the front");
    }
}
