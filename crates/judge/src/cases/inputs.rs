//! Inputs of random numbers: points of a shape with edges of a pattern, and polygons.

use std::ops::RangeInclusive;

use sweep_cdt_testing::arbitrary::Unstructured;
use sweep_cdt_testing::generators::{POINTS, Pattern, Rings, Shape, around, polygons, read_shape};
use sweep_cdt_testing::judge::Question;
use sweep_cdt_testing::{Input, Random};

/// A made input has at most so many points: the oracle tries everything.
pub(super) const MOST: usize = 14;

pub(super) fn no_edges(_: &mut Random) -> Pattern {
    Pattern::None
}

pub(super) fn pairs(_: &mut Random) -> Pattern {
    Pattern::Pairs
}

pub(super) fn some_pattern(random: &mut Random) -> Pattern {
    random.pick(&Pattern::ALL)
}

/// Points of a shape and edges of a pattern that do not cross; `head` are the bytes that the shape begins with.
pub(super) fn plain(
    random: &mut Random,
    shape: Shape,
    pattern: fn(&mut Random) -> Pattern,
    head: &[u8],
) -> Question {
    shaped(random, shape, pattern, head, false)
}

pub(super) fn shaped(
    random: &mut Random,
    shape: Shape,
    pattern: fn(&mut Random) -> Pattern,
    head: &[u8],
    may_cross: bool,
) -> Question {
    let pattern = pattern(random);
    let place = Pattern::ALL
        .iter()
        .position(|&other| other == pattern)
        .unwrap_or(0);
    let n = 4 + random.below(9);
    // Bits 3 and 4: whether edges that cross are left out. No disguise.
    let style = place | if may_cross { 0 } else { 1 << 3 };
    let mut bytes = vec![small(style), small(n)];
    bytes.extend(head);
    // As many bytes as the points take, and some for edges.
    let edges = if pattern == Pattern::None {
        0
    } else {
        3 + random.below(14)
    };
    bytes.extend(random.bytes(n * bytes_of_a_point(shape) + edges));
    // Reading is total but for a type that has no values.
    let Input { points, edges } =
        read_shape(shape, &mut Unstructured::new(&bytes)).unwrap_or_default();
    Question::new(&points, &edges)
}

fn bytes_of_a_point(shape: Shape) -> usize {
    match shape {
        Shape::Raw => 16,
        Shape::General => 4,
        Shape::Nudged | Shape::OnSegments | Shape::Magnitudes => 2,
        _ => 1,
    }
}

fn small(number: usize) -> u8 {
    u8::try_from(number).unwrap_or(u8::MAX)
}

/// A small lattice with edges, multiplied by a power of two.
pub(super) fn scaled(random: &mut Random, by: f64) -> Question {
    let mut question = plain(random, Shape::Lattice, some_pattern, &[6]);
    question
        .points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|x| *x *= by);
    question
}

/// Polygons of a shape, a few vertices each.
pub(super) fn ringed(random: &mut Random, shape: Rings, may_touch: bool) -> Question {
    of_polygons(random, shape, may_touch, MOST)
}

/// Polygons of which one has so many holes.
pub(super) fn pierced(
    random: &mut Random,
    may_touch: bool,
    holes: RangeInclusive<usize>,
) -> Question {
    let most = match holes.end() {
        0..=3 => MOST,
        // The outline, and three vertices a hole.
        4..=9 => 4 + 3 * holes.end(),
        _ => POINTS,
    };
    loop {
        let question = of_polygons(random, Rings::Sieves, may_touch, most);
        let found = question.polygons.iter().map(|rings| rings.len() - 1).max();
        if found.is_some_and(|found| holes.contains(&found)) {
            return question;
        }
    }
}

/// A question with holes that touch or not.
pub(super) fn holes(random: &mut Random, holes: RangeInclusive<usize>) -> Question {
    let may_touch = random.one_in(2);
    pierced(random, may_touch, holes)
}

/// Polygons in the holes of others.
pub(super) fn islands(random: &mut Random) -> Question {
    let may_touch = random.one_in(2);
    loop {
        let question = pierced(random, may_touch, 1..=2);
        // More polygons than one, of which the first one has a hole.
        if question.polygons.len() > 1 && question.polygons[0].len() > 1 {
            return question;
        }
    }
}

/// Four or five rings, each within the one before.
pub(super) fn deep(random: &mut Random) -> Question {
    let depth = if random.one_in(3) { 4 } else { 5 };
    let may_touch = random.one_in(2);
    loop {
        let question = of_polygons(random, Rings::Stars, may_touch, 30);
        if question.rings().count() == depth {
            return question;
        }
    }
}

/// Nine edges or more from one point to places on a circle about it.
pub(super) fn spokes(random: &mut Random) -> Question {
    let mut ends: Vec<[f64; 2]> = Vec::new();
    for place in around(25) {
        let far = random.pick(&[1.0, 1.0, 2.0, 3.0]);
        ends.push(place.map(|x| far * f64::from(x)));
    }
    for at in 1..ends.len() {
        ends.swap(at, random.below(at + 1));
    }
    let mut points = ends[random.below(4)..].to_vec();
    let hub = random.below(points.len() + 1);
    points.insert(hub, [0.0, 0.0]);
    let others = (0..points.len()).filter(|&end| end != hub);
    let edges: Vec<[usize; 2]> = others
        .map(|end| {
            if random.one_in(2) {
                [hub, end]
            } else {
                [end, hub]
            }
        })
        .collect();
    Question::new(&points, &edges)
}

fn of_polygons(random: &mut Random, shape: Rings, may_touch: bool, most: usize) -> Question {
    let bytes = random.bytes(80);
    let made = polygons(shape, may_touch, most, &mut Unstructured::new(&bytes));
    let (points, polygons) = made.unwrap_or_default();
    Question {
        polygons,
        ..Question::new(&points, &[])
    }
}
