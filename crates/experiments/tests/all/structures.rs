//! Each structure without a sweep: random nodes join and leave, and a sorted list says where a search ends. In
//! a sweep every structure takes the same steps to the same triangles, those of the crate's default.

use sweep_cdt::Heuristics;
use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
use sweep_cdt_experiments::fronts::Structure;
use sweep_cdt_experiments::standard;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::{Input, Random, Steps, generators};

/// The nodes of the front, from left to right, and a structure that must know them.
struct Model<'a, F> {
    points: &'a [[f64; 2]],
    nodes: Vec<FrontNode>,
    front: Front,
    structure: F,
}

impl<F: Structure> Model<'_, F> {
    fn x(&self, node: FrontNode) -> f64 {
        self.points[node.rank()][0]
    }

    /// How many nodes have an x of at most this.
    fn place(&self, x: f64) -> usize {
        self.nodes.partition_point(|&node| self.x(node) <= x)
    }

    fn insert(&mut self, rank: usize) {
        let (node, x) = (FrontNode::from_rank(rank), self.points[rank][0]);
        let place = self.place(x);
        let left = place.checked_sub(1).map(|i| self.nodes[i]);
        self.front
            .insert(node, left.unwrap_or(self.front.left_end()));
        self.nodes.insert(place, node);
        self.structure.inserted(node, x);
    }

    fn remove(&mut self, place: usize) {
        let node = self.nodes.remove(place);
        self.front.remove(node);
        self.structure.removed(node, self.x(node));
    }

    /// The steps from the node that the structure names to the last one whose x is at most this.
    fn steps(&mut self, x: f64) -> usize {
        let found = self.structure.locate(x, &self.front);
        assert!(self.front.contains(found), "{found:?} is not on the front");
        // The left end is before all nodes, the right end after them.
        let index = match found {
            end if end == self.front.left_end() => 0,
            end if end == self.front.right_end() => self.nodes.len() + 1,
            node => 1 + self.nodes.iter().position(|&n| n == node).expect("a node"),
        };
        index.abs_diff(self.place(x))
    }
}

/// Steps a search that each structure may need on average, if its promise is worth something.
fn allowed(name: &str, nodes: usize) -> f64 {
    match name {
        "walk from the last node" | "walk from the end" => nodes as f64,
        "hash table (default)" | "hash table, counting" => 8.0,
        "hash over ranks" | "learned table" => 8.0,
        _ if name.starts_with("fixed table") => 8.0,
        "splay tree, 10 % sample" => 25.0,
        // Of equal x any node may be named.
        _ => 1.0,
    }
}

/// Comparisons and words looked at that a search or an update may need on average among so many nodes.
fn allowed_work(name: &str, nodes: usize) -> f64 {
    let halvings = (nodes as f64 + 1.0).log2();
    match name {
        // What they need grows with the crowd in an interval, or with the empty ones.
        _ if name.starts_with("uniform table") => f64::INFINITY,
        // As many as there are intervals.
        "fixed table, 1024" => 1024.0,
        "fixed table, 32" => 32.0,
        "hash over ranks" | "learned table" => 64.0,
        // An entry, sixteen on either side of it, and the last node.
        "hash table (default)" | "hash table, counting" => 34.0,
        // A search anywhere halves the ranks of all vertices.
        "bit set over ranks" | "van Emde Boas tree" | "sampled universe" => 16.0,
        "treap" | "skip list" => 4.0 + 2.0 * halvings,
        _ => 4.0 + 1.5 * halvings,
    }
}

fn test_alone(points: &[[f64; 2]], longest: usize) {
    for contestant in standard() {
        let mut random = Random::new(7);
        let mut model = Model {
            points,
            nodes: Vec::new(),
            front: Front::new(points.len()),
            structure: contestant.front().clone(),
        };
        // Begun twice: what it knew of the first time must be gone.
        for n in [points.len() / 2, points.len()] {
            model.nodes.clear();
            model.front = Front::new(points.len());
            model.structure.begin(FrontInput::new(&points[..n]));
            let (mut steps, mut searches, mut updates) = (0, 0, 0);
            for rank in 0..n {
                model.insert(rank);
                while model.nodes.len() > longest || random.one_in(4) && !model.nodes.is_empty() {
                    model.remove(random.below(model.nodes.len()));
                    updates += 1;
                }
                updates += 1;
                let next = points.get(rank + 1).map_or(0.5, |point| point[0]);
                let anywhere = random.pick(points)[0];
                for x in [next, anywhere, random.unit(), -1.0, 2.0] {
                    steps += model.steps(x);
                    searches += 1;
                }
            }
            let mean = steps as f64 / f64::from(searches);
            let name = contestant.name();
            let allowed = allowed(name, longest);
            assert!(mean <= allowed, "{name}: {mean} steps a search");
            if let Some(work) = model.structure.work() {
                let count = work.comparisons.max(work.visited) as f64;
                let mean = count / f64::from(searches + updates);
                let allowed = allowed_work(name, longest);
                assert!(
                    mean <= allowed,
                    "{name}: {mean} > {allowed} among {longest}"
                );
            }
        }
    }
}

/// Whether a structure names the right node itself, so that no step is left.
fn is_exact(name: &str) -> bool {
    allowed(name, 100) <= 1.0
}

#[test]
fn a_search_ends_near_its_place() {
    let points = Random::new(1).points(3000);
    for longest in [1, 2, 60, 400] {
        test_alone(&points, longest);
    }
}

#[test]
fn equal_and_infinite_x_are_borne_and_the_upper_node_found() {
    let mut random = Random::new(2);
    let mut points: Vec<[f64; 2]> = (0..1000)
        .map(|_| [random.integer(3), random.unit()])
        .collect();
    points[20][0] = f64::INFINITY;
    points[30][0] = f64::NEG_INFINITY;
    for contestant in standard() {
        let mut structure = contestant.front().clone();
        structure.begin(FrontInput::new(&points));
        let mut front = Front::new(points.len());
        // One node of each x, as the sweep keeps them.
        let mut nodes: Vec<FrontNode> = Vec::new();
        for (rank, &[x, _]) in points.iter().enumerate() {
            let node = FrontNode::from_rank(rank);
            let x_of = |node: FrontNode| points[node.rank()][0];
            let place = nodes.partition_point(|&other| x_of(other) <= x);
            let left = place.checked_sub(1).map(|i| nodes[i]);
            front.insert(node, left.unwrap_or(front.left_end()));
            nodes.insert(place, node);
            structure.inserted(node, x);
            if let Some(left) = left.filter(|&left| x_of(left) == x) {
                front.remove(left);
                nodes.remove(place - 1);
                structure.removed(left, x);
            }
            if is_exact(contestant.name()) {
                let found = structure.locate(x, &front);
                assert_eq!(found, node, "{}: the node of this x", contestant.name());
            }
            for x in [x, f64::NEG_INFINITY, f64::INFINITY, 0.5] {
                let found = structure.locate(x, &front);
                assert!(front.contains(found), "{}", contestant.name());
            }
        }
    }
}

/// Random inputs, and bytes for each.
const CASES: u64 = 400;
const BYTES: usize = 160;

fn assert_same_steps(Input { points, edges }: &Input, heuristics: Heuristics, from: &str) {
    let steps = Steps::of(points, edges, heuristics);
    for contestant in standard() {
        let name = format!("{} on {from}", contestant.name());
        steps.assert_same(points, edges, &mut contestant.front().clone(), &name);
    }
}

#[test]
fn a_structure_without_points_names_an_end() {
    for contestant in standard() {
        let mut structure = contestant.front().clone();
        structure.begin(FrontInput::new(&[]));
        let front = Front::new(0);
        let found = structure.locate(0.5, &front);
        assert!(front.contains(found), "{}", contestant.name());
    }
}

#[test]
fn on_inputs_that_broke_other_programs() {
    let own = Hard::own();
    assert!(own.len() > 100, "there are hard inputs");
    for hard in own.iter().chain(&Hard::further()) {
        assert_same_steps(&hard.input, Heuristics::FAST, &hard.name);
    }
}

#[test]
fn on_random_degenerate_inputs() {
    for seed in 0..CASES {
        let input = generators::input(&Random::new(seed).bytes(BYTES));
        let heuristics = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
        let heuristics = heuristics[(seed % 3) as usize];
        assert_same_steps(&input, heuristics, &format!("random input {seed}"));
    }
}
