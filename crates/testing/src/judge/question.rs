//! What a program is asked: points, edges, polygons with holes, or points that come and go; the domain that it fills,
//! and what its triangles promise.

use std::collections::BTreeSet;
use std::str::FromStr;

use sweep_cdt::verify::Level;

use crate::generators::ring_sides;
use crate::names::{name_of, value_of};
use crate::oracle::{Domain, Graph, Number, Point, turns_left, windings};
use crate::with_integers;

/// A question to a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// Edges besides those of rings, as positions in `points`.
    pub edges: Vec<[usize; 2]>,
    /// Polygons, each a list of rings: the outline first, then its holes. A ring lists positions in `points`, each
    /// once.
    pub polygons: Vec<Vec<Vec<usize>>>,
    /// What happens to the points, one after the other; without any, all of them are there.
    pub operations: Vec<Operation>,
    /// What the triangles must fill.
    pub domain: Domain,
    /// What the triangles promise.
    pub level: Level,
}

/// A step of a sequence. At its end the points are asked for that were inserted and not removed after that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// The point of this number is inserted. No equal point is there.
    Insert(usize),
    /// The point of this number, which is there, is removed.
    Remove(usize),
}

impl Question {
    /// A question about these points and edges: the constrained Delaunay triangulation of their hull.
    pub fn new(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Question {
        Question {
            points: points.to_vec(),
            edges: edges.to_vec(),
            polygons: Vec::new(),
            operations: Vec::new(),
            domain: Domain::Hull,
            level: Level::Delaunay,
        }
    }

    /// All rings, one polygon after the other.
    pub fn rings(&self) -> impl Iterator<Item = &Vec<usize>> {
        self.polygons.iter().flatten()
    }

    /// The edges, and after them the sides of all rings.
    pub fn all_edges(&self) -> Vec<[usize; 2]> {
        let sides = self.rings().flat_map(|ring| ring_sides(ring));
        self.edges.iter().copied().chain(sides).collect()
    }

    /// The points that are there after the first `steps` operations, in ascending order.
    pub fn present(&self, steps: usize) -> Vec<usize> {
        let mut present = BTreeSet::new();
        for operation in &self.operations[..steps] {
            match *operation {
                Operation::Insert(v) => present.insert(v),
                Operation::Remove(v) => present.remove(&v),
            };
        }
        present.into_iter().collect()
    }

    /// The question about the points that are there after the first `steps` operations, without operations.
    pub fn after(&self, steps: usize) -> Question {
        let present = self.present(steps).into_iter();
        Question {
            points: present.map(|v| self.points[v]).collect(),
            operations: Vec::new(),
            ..self.clone()
        }
    }

    /// Whether all numbers are those of points, and each operation can be done.
    pub fn is_sound(&self) -> bool {
        let exists = |v: &usize| *v < self.points.len();
        let mut present = BTreeSet::new();
        let equal = |v: usize, w: &usize| self.points[v] == self.points[*w];
        let can_be_done = |operation: &Operation| match operation {
            Operation::Insert(v) => {
                exists(v) && !present.iter().any(|w| equal(*v, w)) && present.insert(*v)
            }
            Operation::Remove(v) => present.remove(v),
        };
        self.points.iter().flatten().all(|x| x.is_finite())
            && self.edges.iter().flatten().all(exists)
            && self.rings().flatten().all(exists)
            && self.operations.iter().all(can_be_done)
    }

    /// What is special about the question.
    pub fn specials(&self) -> BTreeSet<Special> {
        with_integers!(&self.points, |exact| Specials::of(self, &exact))
    }
}

/// The place in a ring of a corner that is on the line through the corners before and after it.
pub(super) fn straight_corner<N: Number>(ring: &[usize], points: &[Point<N>]) -> Option<usize> {
    let n = ring.len();
    let corner = |at: usize| [n - 1, 0, 1].map(|step| &points[ring[(at + step) % n]]);
    (0..n).find(|&at| turns_left(&corner(at)).is_none())
}

/// What may be special about a question, so that a program may refuse it, or does not say what it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Special {
    /// Two points are equal.
    EqualPoints,
    /// All points lie on one line, or there are less than three.
    Flat,
    /// A point lies on an edge, or on a side of a ring, between its ends.
    PointsOnEdges,
    /// Two edges share more than a point, or are equal.
    OverlappingEdges,
    /// The ends of an edge are equal.
    EdgesWithoutLength,
    /// Two edges cross at a point that is none of the input.
    CrossingEdges,
    /// Rings meet in a point, or a ring meets itself.
    TouchingRings,
    /// A ring has no area, as one of a single point.
    FlatRings,
    /// A place is covered by two polygons or by two holes of one, a hole leaves its outline, or a ring goes through
    /// itself.
    OverlappingRings,
    /// An outline runs clockwise, or a hole counter-clockwise.
    RingsEitherWay,
    /// A polygon has a hole.
    Holes,
    /// A ring has a corner on the line through the corners before and after it.
    StraightCorners,
}

impl Special {
    /// All of them, and their names.
    pub const ALL: [(Special, &str); 12] = [
        (Special::EqualPoints, "equal-points"),
        (Special::Flat, "flat"),
        (Special::PointsOnEdges, "points-on-edges"),
        (Special::OverlappingEdges, "overlapping-edges"),
        (Special::EdgesWithoutLength, "edges-without-length"),
        (Special::CrossingEdges, "crossing-edges"),
        (Special::TouchingRings, "touching-rings"),
        (Special::FlatRings, "flat-rings"),
        (Special::OverlappingRings, "overlapping-rings"),
        (Special::RingsEitherWay, "rings-either-way"),
        (Special::Holes, "holes"),
        (Special::StraightCorners, "straight-corners"),
    ];

    /// What is asked only of a program that says so: no triangulation is right, or programs differ in what it means.
    pub const UNUSUAL: [Special; 5] = [
        Special::EdgesWithoutLength,
        Special::CrossingEdges,
        Special::FlatRings,
        Special::OverlappingRings,
        Special::RingsEitherWay,
    ];

    /// The name.
    pub fn name(self) -> &'static str {
        name_of(&Special::ALL, &self)
    }
}

impl FromStr for Special {
    type Err = String;

    fn from_str(name: &str) -> Result<Special, String> {
        value_of(&Special::ALL, name)
    }
}

/// The search for what is special, in exact numbers.
struct Specials<'a, N> {
    question: &'a Question,
    points: &'a [Point<N>],
    graph: Graph<'a, N>,
}

impl<N: Number> Specials<'_, N> {
    fn of(question: &Question, points: &[Point<N>]) -> BTreeSet<Special> {
        let edges = question.all_edges();
        let graph = Graph::new(points, &edges);
        let specials = Specials {
            question,
            points,
            graph,
        };
        let is_special = |special: &Special| specials.has(*special);
        let all = Special::ALL.iter().map(|(special, _)| *special);
        all.filter(is_special).collect()
    }

    fn has(&self, special: Special) -> bool {
        let Specials { graph, .. } = self;
        let vertices = &graph.vertices;
        match special {
            Special::EqualPoints => vertices.len() < self.points.len(),
            Special::Flat => vertices
                .iter()
                .skip(2)
                .all(|&v| graph.orient(vertices[0], vertices[1], v) == std::cmp::Ordering::Equal),
            Special::PointsOnEdges => graph.chains.iter().any(|chain| chain.len() > 2),
            Special::OverlappingEdges => {
                let pieces = graph.chains.iter().map(|chain| chain.len() - 1);
                pieces.sum::<usize>() > graph.pieces.len()
            }
            Special::EdgesWithoutLength => graph.chains.iter().any(|chain| chain.len() == 1),
            Special::CrossingEdges => !graph.crossings().is_empty(),
            Special::TouchingRings => self.touch(),
            Special::FlatRings => self.question.rings().any(|ring| self.turn(ring).is_none()),
            Special::OverlappingRings => self.overlap(),
            Special::RingsEitherWay => self.question.polygons.iter().any(|rings| {
                let mut runs = rings.iter().map(|ring| self.turn(ring)).enumerate();
                runs.any(|(at, turn)| turn == Some(at > 0))
            }),
            Special::Holes => self.question.polygons.iter().any(|rings| rings.len() > 1),
            Special::StraightCorners => {
                let mut rings = self.question.rings();
                rings.any(|ring| straight_corner(ring, self.points).is_some())
            }
        }
    }

    /// Whether a ring runs counter-clockwise by its area, if it has one.
    fn turn(&self, ring: &[usize]) -> Option<bool> {
        let corners: Vec<&Point<N>> = ring.iter().map(|&v| &self.points[v]).collect();
        turns_left(&corners)
    }

    /// Whether a vertex is on rings twice.
    fn touch(&self) -> bool {
        let sides: usize = self.question.rings().map(Vec::len).sum();
        let first = self.graph.chains.len() - sides;
        // Of each side of a ring the vertices without the last one.
        let mut met = BTreeSet::new();
        let mut at = first;
        for ring in self.question.rings() {
            for &v in ring {
                let from = self.graph.representatives[v];
                let chain = &self.graph.chains[at];
                let without_end = chain
                    .iter()
                    .filter(|&&w| w == from || (w != chain[0] && w != chain[chain.len() - 1]));
                for &w in without_end {
                    if !met.insert(w) {
                        return true;
                    }
                }
                at += 1;
            }
        }
        false
    }

    /// Whether rings cover a place in a way that polygons must not. Looked for in each triangle of the hull, so without
    /// an answer where edges cross.
    fn overlap(&self) -> bool {
        if self.question.polygons.is_empty() || self.has(Special::CrossingEdges) {
            return false;
        }
        let Ok(result) = sweep_cdt::triangulate(&self.question.points, &self.question.all_edges())
        else {
            return false;
        };
        let rings: Vec<Vec<[usize; 2]>> = self
            .question
            .rings()
            .map(|r| ring_sides(r).collect())
            .collect();
        let around = |t| {
            rings
                .iter()
                .map(|sides| windings(self.points, sides, t).1)
                .collect()
        };
        let triangles: Vec<Vec<i32>> = result.triangles().map(around).collect();
        let goes_through_itself = |ring: usize| {
            let has = |sign: i32| triangles.iter().any(|around| around[ring].signum() == sign);
            has(1) && has(-1)
        };
        let is_wrong = |around: &Vec<i32>| {
            let (mut ring, mut covers) = (0, 0);
            for polygon in &self.question.polygons {
                let own = &around[ring..ring + polygon.len()];
                ring += polygon.len();
                let times = |list: &[i32]| list.iter().map(|w| w.unsigned_abs()).sum::<u32>();
                let (outline, holes) = (
                    times(&own[..own.len().min(1)]),
                    times(own) - times(&own[..own.len().min(1)]),
                );
                if outline > 1 || holes > outline {
                    return true;
                }
                covers += outline - holes;
            }
            covers > 1
        };
        (0..rings.len()).any(goes_through_itself) || triangles.iter().any(is_wrong)
    }
}
