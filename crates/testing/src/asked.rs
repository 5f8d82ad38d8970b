//! What is asked: of which kinds a question is, as a user would name them.
//!
//! Polygons and edges are looked at alike: the edges part the plane into places. How deep a place is says how many edges a
//! path from outside crosses at least. A hole is a place one edge deeper than the odd one around it, so that the sides of
//! rings count as the polygons that they bound.

use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Triangulation, triangulate};

use crate::judge::Question;

/// What is counted of a question.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    points: usize,
    /// The most points at one place.
    equal: usize,
    /// Whether all points are on one line.
    is_flat: bool,
    edges: usize,
    is_crossing: bool,
    has_no_length: bool,
    overlaps: bool,
    /// The most vertices on an edge between its ends.
    on_edge: usize,
    /// The most edges at a vertex.
    at_vertex: usize,
    /// The sizes of sets of four or more vertices on one circle with nothing in it.
    cocircular: Vec<usize>,
    /// The number of polygons; of edges the number of parts that hang together and go round something.
    polygons: usize,
    /// The most holes of a polygon.
    holes: usize,
    depth: usize,
    has_hole_at_outline: bool,
    has_holes_that_touch: bool,
    /// Two polygons meet in a vertex, or in a side.
    has_polygons_that_touch: bool,
}

/// A kind of question, and whether a question is of it.
type Kind = (&'static str, fn(&Facts) -> bool);

/// The kinds.
pub const KINDS: [Kind; 41] = [
    ("up to 2 points", |f| f.points <= 2),
    ("3 to 7 points", |f| (3..=7).contains(&f.points)),
    ("8 to 20 points", |f| (8..=20).contains(&f.points)),
    ("21 points or more", |f| f.points >= 21),
    ("all points on a line", |f| f.is_flat && f.points > 2),
    ("2 equal points", |f| f.equal == 2),
    ("3 equal points or more", |f| f.equal >= 3),
    ("a circle of 4", |f| f.cocircular.contains(&4)),
    ("a circle of 5 or 6", |f| {
        f.cocircular.iter().any(|n| (5..=6).contains(n))
    }),
    ("a circle of 7 or more", |f| {
        f.cocircular.iter().any(|&n| n >= 7)
    }),
    ("2 circles or more", |f| f.cocircular.len() >= 2),
    ("no edges", |f| f.edges == 0),
    ("edges that cross", |f| f.is_crossing),
    ("an edge without length", |f| f.has_no_length),
    ("edges that overlap", |f| f.overlaps),
    ("1 vertex on an edge", |f| f.on_edge == 1),
    ("2 vertices on an edge", |f| f.on_edge == 2),
    ("3 vertices on an edge or more", |f| f.on_edge >= 3),
    ("at most 2 edges at a vertex", |f| {
        (1..=2).contains(&f.at_vertex)
    }),
    ("3 or 4 edges at a vertex", |f| {
        (3..=4).contains(&f.at_vertex)
    }),
    ("5 to 8 edges at a vertex", |f| {
        (5..=8).contains(&f.at_vertex)
    }),
    ("9 edges at a vertex or more", |f| f.at_vertex >= 9),
    ("1 polygon", |f| f.polygons == 1),
    ("2 polygons", |f| f.polygons == 2),
    ("3 polygons or more", |f| f.polygons >= 3),
    ("polygons without holes", |f| f.polygons > 0 && f.holes == 0),
    ("1 hole", |f| f.holes == 1),
    ("2 holes", |f| f.holes == 2),
    ("3 holes", |f| f.holes == 3),
    ("4 holes", |f| f.holes == 4),
    ("5 holes", |f| f.holes == 5),
    ("6 to 9 holes", |f| (6..=9).contains(&f.holes)),
    ("10 to 20 holes", |f| f.holes >= 10),
    ("a hole that touches its outline", |f| f.has_hole_at_outline),
    ("holes that touch", |f| f.has_holes_that_touch),
    ("polygons that touch", |f| f.has_polygons_that_touch),
    ("nested 1 deep", |f| f.depth == 1),
    ("nested 2 deep", |f| f.depth == 2),
    ("nested 3 deep: islands", |f| f.depth == 3),
    ("nested 4 deep", |f| f.depth == 4),
    ("nested 5 deep or more", |f| f.depth >= 5),
];

impl Facts {
    /// What is counted of a question without operations whose points are finite and whose ends exist.
    pub fn of(question: &Question) -> Facts {
        let points = &question.points;
        let edges = question.all_edges();
        let mut places: BTreeMap<[u64; 2], usize> = BTreeMap::new();
        for point in points {
            // A zero may have lost its sign.
            *places
                .entry(point.map(|x| (x + 0.0).to_bits()))
                .or_default() += 1;
        }
        let mut facts = Facts {
            points: points.len(),
            equal: places.into_values().max().unwrap_or(0),
            edges: edges.len(),
            polygons: question.polygons.len(),
            ..Facts::default()
        };
        match triangulate(points, &edges) {
            Ok(result) => facts.look(question, &edges, &result),
            Err(_) => facts.is_crossing = true,
        }
        facts
    }

    fn look(&mut self, question: &Question, edges: &[[usize; 2]], result: &Triangulation) {
        self.is_flat = result.is_empty();
        let chains: Vec<Vec<usize>> = (0..edges.len())
            .map(|e| result.edge_chain(e).collect())
            .collect();
        self.has_no_length = chains.iter().any(|chain| chain.len() < 2);
        self.on_edge = chains
            .iter()
            .map(|chain| chain.len().saturating_sub(2))
            .max()
            .unwrap_or(0);
        let mut pieces = BTreeSet::new();
        let mut links: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for pair in chains.iter().flat_map(|chain| chain.windows(2)) {
            if pieces.insert([pair[0].min(pair[1]), pair[0].max(pair[1])]) {
                links.entry(pair[0]).or_default().push(pair[1]);
                links.entry(pair[1]).or_default().push(pair[0]);
            } else {
                self.overlaps = true;
            }
        }
        self.at_vertex = links.values().map(Vec::len).max().unwrap_or(0);
        if question.polygons.is_empty() {
            self.polygons = closed_parts(&links);
        }
        self.cocircular = circles(&question.points, result);
        Places::of(result).look(self, result);
    }
}

/// How many parts of a graph hang together and have as many edges as vertices.
fn closed_parts(links: &BTreeMap<usize, Vec<usize>>) -> usize {
    let (mut seen, mut count) = (BTreeSet::new(), 0);
    for &start in links.keys() {
        let (mut stack, mut vertices, mut ends) = (vec![start], 0, 0);
        while let Some(v) = stack.pop() {
            if seen.insert(v) {
                vertices += 1;
                ends += links[&v].len();
                stack.extend(&links[&v]);
            }
        }
        count += usize::from(vertices > 0 && ends / 2 >= vertices);
    }
    count
}

/// How many vertices each set of four or more on one circle has whose triangles share sides that are no edges.
fn circles(points: &[[f64; 2]], result: &Triangulation) -> Vec<usize> {
    let is_tie = |t: usize, u: usize| {
        let corners = result.triangle(t);
        let other = result
            .triangle(u)
            .into_iter()
            .find(|v| !corners.contains(v));
        let [a, b, c] = corners.map(|v| &points[v]);
        other.is_some_and(|d| f64::in_circle(a, b, c, &points[d]).is_eq())
    };
    let same = |t: usize, side: usize| {
        let free = !result.is_constrained(t, side);
        result.neighbor(t, side).filter(|&u| free && is_tie(t, u))
    };
    let sizes = flooded(result, same).1;
    sizes
        .into_iter()
        .filter(|n| *n > 1)
        .map(|n| n + 2)
        .collect()
}

/// How many questions were of each kind.
#[derive(Clone, Copy, Debug)]
pub struct Tally {
    /// The questions.
    pub questions: u64,
    /// The counts of each of [`KINDS`].
    pub kinds: [u64; KINDS.len()],
}

impl Tally {
    /// No questions.
    pub const NONE: Tally = Tally {
        questions: 0,
        kinds: [0; KINDS.len()],
    };

    /// Counts a question.
    pub fn add(&mut self, question: &Question) {
        let facts = Facts::of(question);
        self.questions += 1;
        for (count, (_, is_of)) in self.kinds.iter_mut().zip(KINDS) {
            *count += u64::from(is_of(&facts));
        }
    }
}

/// For each triangle the number of its set, and the sizes of the sets: neighbors are in one set where the function says so.
fn flooded(
    result: &Triangulation,
    across: impl Fn(usize, usize) -> Option<usize>,
) -> (Vec<usize>, Vec<usize>) {
    let mut set = vec![usize::MAX; result.len()];
    let mut sizes = Vec::new();
    for start in 0..result.len() {
        if set[start] != usize::MAX {
            continue;
        }
        set[start] = sizes.len();
        let (mut stack, mut size) = (vec![start], 0);
        while let Some(t) = stack.pop() {
            size += 1;
            for u in (0..3).filter_map(|side| across(t, side)) {
                if set[u] == usize::MAX {
                    set[u] = sizes.len();
                    stack.push(u);
                }
            }
        }
        sizes.push(size);
    }
    (set, sizes)
}

/// The places that the edges part: the first one is outside.
struct Places {
    /// The place of each triangle.
    of: Vec<usize>,
    /// The places on the other side of an edge.
    beside: Vec<BTreeSet<usize>>,
    depth: Vec<usize>,
}

impl Places {
    fn of(result: &Triangulation) -> Places {
        let free = |t: usize, side: usize| !result.is_constrained(t, side);
        let (set, sizes) = flooded(result, |t, side| {
            result.neighbor(t, side).filter(|_| free(t, side))
        });
        let sides = || (0..result.len()).flat_map(|t| [0, 1, 2].map(|side| (t, side)));
        let is_open =
            |&(t, side): &(usize, usize)| free(t, side) && result.neighbor(t, side).is_none();
        let open: BTreeSet<usize> = sides().filter(is_open).map(|(t, _)| set[t]).collect();
        let place = |t: usize| {
            if open.contains(&set[t]) {
                0
            } else {
                1 + set[t]
            }
        };
        let mut beside = vec![BTreeSet::new(); 1 + sizes.len()];
        for (t, side) in sides().filter(|&(t, side)| !free(t, side)) {
            let other = result.neighbor(t, side).map_or(0, place);
            beside[place(t)].insert(other);
            beside[other].insert(place(t));
        }
        let mut depth = vec![usize::MAX; beside.len()];
        depth[0] = 0;
        let mut level = vec![0];
        while !level.is_empty() {
            let mut next = Vec::new();
            for at in level {
                for &other in &beside[at] {
                    if depth[other] == usize::MAX {
                        depth[other] = depth[at] + 1;
                        next.push(other);
                    }
                }
            }
            level = next;
        }
        Places {
            of: (0..result.len()).map(place).collect(),
            beside,
            depth,
        }
    }

    fn look(&self, facts: &mut Facts, result: &Triangulation) {
        let depth = |place: usize| self.depth[place];
        for place in 0..self.beside.len() {
            // What is outside for several reasons has the number 0 alone.
            if depth(place) == usize::MAX {
                continue;
            }
            facts.depth = facts.depth.max(depth(place));
            if depth(place) % 2 == 1 {
                let is_hole = |other: &&usize| depth(**other) == depth(place) + 1;
                let holes = self.beside[place].iter().filter(is_hole).count();
                facts.holes = facts.holes.max(holes);
                let shares = |other: &usize| depth(*other) == depth(place);
                facts.has_polygons_that_touch |= self.beside[place].iter().any(shares);
            }
        }
        let stars = result.vertex_stars();
        let vertices: BTreeSet<usize> = result.triangles().flatten().collect();
        for v in vertices {
            self.look_around(facts, result, &stars.star(v).collect::<Vec<_>>());
        }
    }

    /// The places around a vertex, of which one may be there more than once.
    fn look_around(&self, facts: &mut Facts, result: &Triangulation, star: &[(usize, usize)]) {
        let mut around: Vec<usize> = Vec::new();
        for &(t, index) in star {
            // The side that runs counter-clockwise from the vertex parts the triangle from the one before.
            let before = (index + 2) % 3;
            if around.is_empty() || result.is_constrained(t, before) {
                around.push(self.of[t]);
            }
        }
        let &(t, index) = star.last().expect("a vertex of triangles");
        let after = (index + 1) % 3;
        match result.neighbor(t, after) {
            None => around.push(0),
            Some(_) if around.len() > 1 && !result.is_constrained(t, after) => drop(around.pop()),
            Some(_) => {}
        }
        if around.len() > 1 && around.first() == Some(&0) && around.last() == Some(&0) {
            around.pop();
        }
        let distinct: BTreeSet<usize> = around.iter().copied().collect();
        let times = |place: usize| around.iter().filter(|other| **other == place).count();
        for &place in distinct.iter().filter(|&&place| times(place) > 1) {
            let depth = self.depth[place];
            let at = |wanted: usize| {
                distinct
                    .iter()
                    .filter(|&&other| self.depth[other] == wanted)
                    .count()
            };
            if depth % 2 == 1 {
                facts.has_hole_at_outline |= at(depth + 1) > 0 && at(depth - 1) > 0;
                facts.has_holes_that_touch |= at(depth + 1) > 1;
            } else {
                facts.has_polygons_that_touch |= at(depth + 1) > 1;
            }
        }
    }
}

#[test]
fn holes_islands_and_what_touches_are_told() {
    let kinds = |points: &str, rings: &[&[usize]]| -> Vec<&str> {
        let sides = rings
            .iter()
            .flat_map(|ring| crate::generators::ring_sides(ring));
        let points = crate::Input::parse(points, "").points;
        let facts = Facts::of(&Question::new(&points, &sides.collect::<Vec<_>>()));
        let first = KINDS
            .iter()
            .position(|(name, _)| *name == "1 polygon")
            .expect("a kind");
        KINDS[first..]
            .iter()
            .filter(|(_, is_of)| is_of(&facts))
            .map(|(name, _)| *name)
            .collect()
    };
    let square = "0 0, 9 0, 9 9, 0 9";
    assert_eq!(
        kinds(square, &[&[0, 1, 2, 3]]),
        ["1 polygon", "polygons without holes", "nested 1 deep"]
    );
    let two = format!("{square}, 1 1, 3 1, 1 3, 5 5, 7 5, 5 7");
    assert_eq!(
        kinds(&two, &[&[0, 1, 2, 3], &[4, 5, 6], &[7, 8, 9]]),
        ["3 polygons or more", "2 holes", "nested 2 deep"],
        "of edges each ring is a part"
    );
    // The second hole touches the first one, and that one the outline.
    let touching = format!("{square}, 0 0, 3 1, 1 3, 3 1, 5 1, 5 3");
    assert_eq!(
        kinds(&touching, &[&[0, 1, 2, 3], &[4, 5, 6], &[7, 8, 9]]),
        [
            "1 polygon",
            "2 holes",
            "a hole that touches its outline",
            "holes that touch",
            "nested 2 deep"
        ]
    );
    let island = format!("{square}, 1 1, 8 1, 1 8, 2 2, 3 2, 2 3");
    assert_eq!(
        kinds(&island, &[&[0, 1, 2, 3], &[4, 5, 6], &[7, 8, 9]]),
        ["3 polygons or more", "1 hole", "nested 3 deep: islands"]
    );
    assert_eq!(
        kinds("0 0, 2 0, 0 2, -2 0, -2 -2", &[&[0, 1, 2], &[0, 3, 4]]),
        [
            "1 polygon",
            "polygons without holes",
            "polygons that touch",
            "nested 1 deep"
        ]
    );
}
