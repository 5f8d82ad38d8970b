//! An input has one triangulation, and what must not change it does not.
//!
//! The input is triangulated again by divide and conquer; in bands; in memory that was kept; with other heuristics;
//! scaled by a power of two, and moved, both exactly; in another order of points, edges and ends; and with sides of the
//! result as further edges: the answer is the same. Mirrored or turned by 90 degrees, the rule for four vertices on a
//! circle draws other diagonals, but all other sides are the same. Where edges cross, every one of these says so. The
//! inside alone is the inside of the whole: of the edges, of a ring through all points, and of one through some of them
//! in any order. A fuzzer's bytes choose [`CHOSEN`] of these ways.
//!
//! The judge is the crate itself, which takes other ways on the other input: filters fail elsewhere, other
//! sides are flipped, left and right change places. The oracle, which shares no code with the crate, says
//! what mirrors may change, and whether edges cross.

use std::cmp::Ordering;

use sweep_cdt::interior::{FillRule, InteriorError, Ring};
use sweep_cdt::scalar::orient2d;
use sweep_cdt::{Algorithm, Bands, Corners, Error, Heuristics, Triangulation};
use sweep_cdt_testing::tuned::{triangulate, triangulator};

use crate::reached;
use sweep_cdt_testing::Random;
use sweep_cdt_testing::oracle::{
    Answer, check_found, check_links, crosses, firm_sides, found, sorted,
};
use sweep_cdt_testing::runs::ALGORITHMS;
use sweep_cdt_testing::{Input, generators};

/// A way that must lead to the same answer: panics unless it does, from an input with this answer.
type Way = fn(&Input, Option<&Answer>, &mut Random);

const WAYS: [Way; 12] = [
    judge_heuristics,
    judge_an_algorithm,
    |input, here, _| judge_kept_memory(input, here),
    |input, _, random| judge_rules(&input.points, &input.edges, random),
    judge_scaled,
    judge_moved,
    judge_order,
    judge_turn,
    judge_sides,
    judge_bands,
    |input, _, random| judge_ring(input, random),
    |input, _, random| judge_tangle(input, random),
];

/// How many ways are tried with an input of a fuzzer, which tries other ways with the next one: more inputs find a fault
/// sooner than more ways.
const CHOSEN: usize = 2;

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    let mut random = Random::new(choices);
    let mut ways = WAYS;
    random.shuffle(&mut ways);
    try_ways(&input, &ways[..CHOSEN], &mut random);
}

/// Panics unless the result for this input, all of whose coordinates are finite, is the same in all the
/// ways that follow from `choices`.
pub fn judge(input: &Input, choices: u64) {
    try_ways(input, &WAYS, &mut Random::new(choices));
}

fn try_ways(input: &Input, ways: &[Way], random: &mut Random) {
    let here = answer(input);
    for way in ways {
        way(input, here.as_ref(), random);
    }
}

/// By other heuristics.
fn judge_heuristics(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let heuristics = heuristics(random);
    assert_eq!(
        answer_by(input, heuristics).as_ref(),
        here,
        "{heuristics:?}"
    );
}

/// Scaled by a power of two, unless that overflows or loses digits.
fn judge_scaled(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let limit = random.pick(&[60, 900]);
    let scale = random.integer(limit).exp2();
    if let Some(there) = mapped(input, |x, _| (x * scale / scale == x).then_some(x * scale)) {
        assert_eq!(answer(&there).as_ref(), here, "scaled by {scale:e}");
    }
}

/// Moved, if that is exact.
fn judge_moved(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let offset = offset(input, random);
    if let Some(there) = mapped(input, |x, axis| exact_sum(x, offset[axis])) {
        assert_eq!(answer(&there).as_ref(), here, "moved by {offset:?}");
    }
}

/// The answer of the default run.
fn answer(input: &Input) -> Option<Answer> {
    answer_by(input, Heuristics::default())
}

/// The answer, unless edges cross.
fn answer_by(input: &Input, heuristics: Heuristics) -> Option<Answer> {
    let Input { points, edges } = input;
    let run = triangulator(points, edges).heuristics(heuristics);
    match run.triangulate(points, edges) {
        Ok(result) => Some(found(&result, points.len(), edges.len())),
        Err(Error::CrossingEdges { edges: pair }) => {
            assert!(crosses(points, edges, pair), "{pair:?} do not cross");
            None
        }
        Err(error) => panic!("no reason for: {error}"),
    }
}

/// Another algorithm gives the same answer, and of several crossings it names the same one as the sweep.
fn judge_an_algorithm(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let Input { points, edges } = input;
    let by = |algorithm| {
        let run = triangulator(points, edges).algorithm(algorithm);
        let result = run.triangulate(points, edges);
        result.map(|result| found(&result, points.len(), edges.len()))
    };
    let (name, algorithm) = random.pick(ALGORITHMS);
    let there = by(algorithm);
    assert_eq!(there.as_ref().ok(), here, "{name}");
    if let Err(error) = there {
        let swept = by(Algorithm::Sweep);
        assert_eq!(swept, Err(error), "{name}: the sweep names others");
    }
}

/// In memory that another input has used the answer is the same.
fn judge_kept_memory(Input { points, edges }: &Input, here: Option<&Answer>) {
    let mut session = triangulator(points, edges).session();
    // All points but the last, each of them twice, with the edges between them.
    let most = points.len().saturating_sub(1);
    let others = [&points[..most], &points[..most]].concat();
    let between: Vec<[usize; 2]> = edges
        .iter()
        .copied()
        .filter(|edge| edge.iter().all(|&v| v < most))
        .collect();
    for _ in 0..2 {
        // What it says of crossing edges is judged elsewhere.
        let _ = session.triangulate(&others, &between);
        let there = session.triangulate(points, edges);
        let there = there.map(|result| found(result, points.len(), edges.len()));
        assert_eq!(there.ok().as_ref(), here, "in memory that was kept");
    }
}

/// The inside of a ring that runs counter-clockwise, by some rules and as a polygon.
fn judge_ring(Input { points, .. }: &Input, random: &mut Random) {
    let ring = ring(points);
    judge_polygons(points, &ring);
    judge_rules(points, &ring, random);
    // Of the ring run the other way, positive and negative change places.
    let back: Vec<[usize; 2]> = ring.iter().map(|&[v, w]| [w, v]).collect();
    let Ok(result) = triangulate(points, &ring) else {
        return;
    };
    let turned = triangulate(points, &back).expect("the edges are those of the ring");
    let inside = |result: &Triangulation, rule| {
        let interior = result.interior(rule).expect("closed rings");
        interior.canonical_triangles()
    };
    let all = inside(&result, FillRule::NonZero);
    let expected = [all.clone(), Vec::new(), Vec::new(), all];
    let found = [
        inside(&result, FillRule::Positive),
        inside(&result, FillRule::Negative),
        inside(&turned, FillRule::Positive),
        inside(&turned, FillRule::Negative),
    ];
    assert_eq!(found, expected, "which way round");
}

/// The inside of a ring through some of the points in any order. Most such rings cross themselves.
fn judge_tangle(Input { points, .. }: &Input, random: &mut Random) {
    let mut corners = order(points.len(), random);
    corners.truncate(3 + random.below(6));
    let next = corners.iter().cycle().skip(1);
    let ring: Vec<[usize; 2]> = corners.iter().zip(next).map(|(&v, &w)| [v, w]).collect();
    judge_rules(points, &ring, random);
    // Without the other points it is simple more often.
    let alone: Vec<[f64; 2]> = corners.iter().map(|&v| points[v]).collect();
    let sides = (0..alone.len()).map(|v| [v, (v + 1) % alone.len()]);
    judge_rules(&alone, &sides.collect::<Vec<_>>(), random);
}

/// A ring that goes from the leftmost point to the rightmost below the line between them, and back above it.
fn ring(points: &[[f64; 2]]) -> Vec<[usize; 2]> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a].partial_cmp(&points[b]).expect("finite"));
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    for &v in &order {
        let ends = [order[0], order[order.len() - 1]].map(|v| &points[v]);
        match orient2d(ends[0], ends[1], &points[v]) {
            Ordering::Greater => upper.push(v),
            _ => lower.push(v),
        }
    }
    let corners: Vec<usize> = lower.into_iter().chain(upper.into_iter().rev()).collect();
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&v, &w)| [v, w]).collect()
}

/// How many of the five rules are tried at a time.
const RULES: usize = 2;

/// The inside alone is the inside of the whole by some rules: the same triangles, or the same error.
fn judge_rules(points: &[[f64; 2]], edges: &[[usize; 2]], random: &mut Random) {
    let mut session = triangulator(points, edges).session();
    let whole = triangulate(points, edges).map_err(|error| InteriorError::Refused { error });
    let mut rules = [
        FillRule::EvenOdd,
        FillRule::NonZero,
        FillRule::Positive,
        FillRule::Negative,
        FillRule::AtLeast(2),
    ];
    random.shuffle(&mut rules);
    for &rule in &rules[..RULES] {
        let whole = whole.as_ref().map_err(|error| *error);
        let inside = whole.and_then(|whole| Ok(whole.interior(rule)?.canonical_triangles()));
        let there = session.triangulate_inside(points, edges, rule);
        assert_eq!(there, inside.as_deref().map_err(|error| *error), "{rule:?}");
    }
}

/// The ring as a polygon, and as one that is its own hole: all that the ring goes round is covered, by the first alone.
fn judge_polygons(points: &[[f64; 2]], ring: &[[usize; 2]]) {
    let edges = [ring, ring, ring].concat();
    let Ok(result) = triangulate(points, &edges) else {
        return;
    };
    let ring_of: Vec<Option<usize>> = (0..edges.len()).map(|e| Some(e / ring.len())).collect();
    let rings = [(7, false), (9, false), (9, true)];
    let rings = rings.map(|(polygon, is_hole)| Ring { polygon, is_hole });
    let covered = result.interior_of_polygons(&rings, &ring_of);
    let covered = covered.expect("closed rings");
    let inside = result.interior(FillRule::EvenOdd).expect("closed rings");
    for t in 0..result.len() {
        let expected = inside.is_inside(t);
        assert_eq!(covered.depth(t), i32::from(expected), "triangle {t}");
        assert_eq!(covered.region(t), expected.then_some(7), "triangle {t}");
    }
}

/// In bands the answer is the same, and of several crossings the same one is named.
fn judge_bands(Input { points, edges }: &Input, here: Option<&Answer>, random: &mut Random) {
    let bands = 2 + random.below(4);
    let run = triangulator(points, edges);
    let there = run.triangulate_parallel(points, edges, Bands::new().count(bands));
    let answer = there.map(|result| {
        check_links(&result);
        found(&result, points.len(), edges.len())
    });
    assert_eq!(answer.as_ref().ok(), here, "in {bands} bands");
    if let Err(error) = answer {
        let one = run.triangulate(points, edges);
        assert_eq!(one.err(), Some(error), "one thread names others");
    }
}

/// Any setting but the default.
fn heuristics(random: &mut Random) -> Heuristics {
    let mut heuristics = Heuristics::OFF;
    heuristics.corners = random.pick(&[Corners::Off, Corners::RightAngle, Corners::Wide]);
    heuristics.basins = heuristics.corners == Corners::Wide || random.one_in(2);
    heuristics
}

/// The input with other coordinates, by the old one and its axis, if all of them exist.
fn mapped(input: &Input, map: impl Fn(f64, usize) -> Option<f64>) -> Option<Input> {
    let points: Option<_> = input
        .points
        .iter()
        .map(|&[x, y]| Some([map(x, 0)?, map(y, 1)?]))
        .collect();
    Some(Input {
        points: points?,
        edges: input.edges.clone(),
    })
}

/// How far to move: small multiples of a power of two around the largest coordinate.
fn offset(input: &Input, random: &mut Random) -> [f64; 2] {
    let largest = input
        .points
        .iter()
        .flatten()
        .fold(1e-300, |m: f64, x| m.max(x.abs()));
    let unit = (largest.log2().floor() + random.integer(30)).exp2();
    [0, 1].map(|_| random.integer(100) * unit)
}

/// The sum, if it is a double: Knuth's error of a sum is zero.
fn exact_sum(x: f64, y: f64) -> Option<f64> {
    let sum = x + y;
    let of_y = sum - x;
    let error = (x - (sum - of_y)) + (y - of_y);
    (error == 0.0).then_some(sum)
}

fn order(n: usize, random: &mut Random) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    random.shuffle(&mut order);
    order
}

/// Point `order[i]` as point `i`, the edges shuffled, and some from their other end.
fn judge_order(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let order_of = order(input.points.len(), random);
    let edge_order = order(input.edges.len(), random);
    let mut other = input.permuted(&order_of);
    other.edges = edge_order.iter().map(|&e| other.edges[e]).collect();
    let is_turned: Vec<bool> = other.edges.iter().map(|_| random.one_in(2)).collect();
    for (edge, &is_turned) in other.edges.iter_mut().zip(&is_turned) {
        if is_turned {
            edge.reverse();
        }
    }
    let there = answer(&other).map(|answer| {
        // Of equal points another one may have become the representative.
        let name = |v: usize| here.map_or(v, |here| here.representatives[order_of[v]]);
        let mut chains = vec![Vec::new(); answer.chains.len()];
        for ((&e, chain), &is_turned) in edge_order.iter().zip(&answer.chains).zip(&is_turned) {
            chains[e] = chain.iter().copied().map(name).collect();
            if is_turned {
                chains[e].reverse();
            }
        }
        let mut representatives = answer.representatives.clone();
        for (v, &of) in answer.representatives.iter().enumerate() {
            representatives[order_of[v]] = name(of);
        }
        Answer {
            triangles: ordered(answer.triangles.iter().map(|corners| {
                let mut corners = corners.map(name);
                let least = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
                corners.rotate_left(least);
                corners
            })),
            constrained: ordered(answer.constrained.iter().map(|side| sorted(side.map(name)))),
            hull: answer.hull.iter().copied().map(name).collect(),
            representatives,
            chains,
        }
    });
    assert_eq!(there.as_ref(), here, "in the order {order_of:?}");
}

fn ordered<T: Ord>(list: impl Iterator<Item = T>) -> Vec<T> {
    let mut list: Vec<T> = list.collect();
    list.sort_unstable();
    list
}

/// One of the seven mirrors and turns of a square.
fn judge_turn(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let which = 1 + random.below(7);
    let sign = |bit: usize| if which & bit == 0 { 1.0 } else { -1.0 };
    let mut other = input.clone();
    for point in &mut other.points {
        *point = [point[0] * sign(1), point[1] * sign(2)];
        if which & 4 != 0 {
            point.reverse();
        }
    }
    let there = answer(&other);
    assert_eq!(there.is_some(), here.is_some(), "do edges cross?");
    if let (Some(here), Some(there)) = (here, &there) {
        assert_eq!(
            firm_sides(&other.points, there),
            firm_sides(&input.points, here),
            "turned by {which}"
        );
        assert_eq!(there.constrained, here.constrained);
        check_found(&other.points, &other.edges, there);
    }
}

/// Some sides that are there anyway as further edges.
fn judge_sides(input: &Input, here: Option<&Answer>, random: &mut Random) {
    let Some(here) = here else { return };
    let mut more = input.clone();
    for &[a, b, c] in &here.triangles {
        if random.one_in(3) {
            more.edges.push(random.pick(&[[a, b], [c, b], [a, c]]));
        }
    }
    let added = more.edges[input.edges.len()..].iter().copied();
    let constrained = added
        .clone()
        .map(sorted)
        .chain(here.constrained.iter().copied());
    let mut there = answer(&more).expect("sides do not cross");
    let mut expected = here.clone();
    expected.constrained = ordered(constrained);
    expected.constrained.dedup();
    for (chain, edge) in there.chains.split_off(here.chains.len()).iter().zip(added) {
        assert_eq!(chain[..], edge, "the chain of a side");
    }
    assert_eq!(there, expected, "with sides as edges");
}
