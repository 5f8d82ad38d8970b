//! Questions out of bytes, within the claims of a program.
//!
//! The first byte says how coordinates are moved into the numbers that the program takes: left where they are, or
//! stretched to the limit of these numbers, and some of them to the next number. Eight bytes are the seed of what is
//! left to chance. The others are those of [`generators`](crate::generators). What a program is never asked is left out
//! where that can be: points equal to others, edges that cross. Every sequence of bytes is a question, or one that may
//! not be asked.

use std::collections::{BTreeSet, HashMap};

use arbitrary::{Result, Unstructured};

use super::claims::{Asked, Claims};
use super::question::{Operation, Question, Special, straight_corner};
use crate::generators::{Rings, polygons, read_named};
use crate::oracle::Graph;
use crate::with_integers;
use sweep_cdt_generate::Random;

/// The kind of a question, and the question that the bytes stand for, unless it may not be asked.
pub fn question(claims: &Claims, bytes: &[u8]) -> (&'static str, Option<Question>) {
    // Reading is total but for a type that has no values.
    let Ok((kind, question)) = read(claims, &mut Unstructured::new(bytes)) else {
        return ("none", None);
    };
    (
        kind,
        Some(question).filter(|question| claims.allows(question)),
    )
}

fn read(claims: &Claims, bytes: &mut Unstructured<'_>) -> Result<(&'static str, Question)> {
    let (style, seed): (u8, u64) = bytes.arbitrary()?;
    let mut question = Question {
        domain: claims.domain,
        level: claims.level,
        ..Question::new(&[], &[])
    };
    let kind = match claims.asked {
        Asked::Polygons | Asked::Lines => with_polygons(claims, &mut question, bytes)?,
        Asked::Points | Asked::Edges | Asked::Operations => {
            with_points(claims, &mut question, bytes)?
        }
    };
    let stretch = [None, None, Some(0), Some(style >> 5)][usize::from(style & 3)];
    claims.numbers.fit(&mut question.points, stretch);
    if style & 0b1_1100 == 0b1_1100 {
        nudge(claims, &mut question, &mut Random::new(seed));
    }
    if claims.asked == Asked::Lines {
        add_lines(&mut question, &mut Random::new(seed));
    }
    leave_out(claims, &mut question);
    Ok((kind, question))
}

/// Some coordinates become the next number up or down.
fn nudge(claims: &Claims, question: &mut Question, random: &mut Random) {
    for x in question.points.as_flattened_mut() {
        if random.one_in(6) {
            *x = claims.numbers.next(*x, random.one_in(2));
        }
    }
}

fn with_points(
    claims: &Claims,
    question: &mut Question,
    bytes: &mut Unstructured<'_>,
) -> Result<&'static str> {
    // Of a sequence, one byte in three.
    let steps = match claims.asked {
        Asked::Operations => bytes.bytes(bytes.len() / 3)?,
        _ => &[],
    };
    let (shape, mut input) = read_named(bytes)?;
    input.points.truncate(claims.most);
    let exists = |edge: &[usize; 2]| edge.iter().all(|&v| v < input.points.len());
    if claims.asked == Asked::Edges {
        question.edges = input
            .edges
            .into_iter()
            .filter(|edge| exists(edge))
            .collect();
    }
    question.points = input.points;
    if claims.asked == Asked::Operations {
        operate(question, steps);
    }
    Ok(shape)
}

/// Inserts the points in their order, those removed before once more, and removes one now and then. Equal points are
/// kept apart when the question is complete ([`leave_out`]).
fn operate(question: &mut Question, steps: &[u8]) {
    let n = question.points.len();
    let (mut present, mut absent) = (Vec::new(), (0..n).rev().collect::<Vec<usize>>());
    let more = steps
        .iter()
        .copied()
        .chain(std::iter::repeat_n(0, n.saturating_sub(steps.len())));
    for step in more {
        let place = usize::from(step >> 2);
        if step & 3 == 3 && !present.is_empty() {
            let v = present.remove(place % present.len());
            absent.insert(0, v);
            question.operations.push(Operation::Remove(v));
        } else if let Some(v) = absent.pop() {
            present.push(v);
            question.operations.push(Operation::Insert(v));
        }
    }
}

fn with_polygons(
    claims: &Claims,
    question: &mut Question,
    bytes: &mut Unstructured<'_>,
) -> Result<&'static str> {
    let is_asked = |special| !claims.never.contains(&special);
    let shape = Rings::of(bytes.arbitrary()?, is_asked(Special::OverlappingRings));
    let may_touch = is_asked(Special::TouchingRings) && is_asked(Special::EqualPoints);
    (question.points, question.polygons) = polygons(shape, may_touch, claims.most, bytes)?;
    if !is_asked(Special::Holes) {
        question
            .polygons
            .iter_mut()
            .for_each(|rings| rings.truncate(1));
    }
    if !is_asked(Special::StraightCorners) {
        leave_out_straight_corners(question);
    }
    if !is_asked(Special::Holes) || !is_asked(Special::StraightCorners) {
        leave_out_points(question);
    }
    let style: u8 = bytes.arbitrary()?;
    if is_asked(Special::RingsEitherWay) && style & 1 == 1 {
        let rings = question.polygons.iter_mut().flatten();
        rings
            .zip(0..8)
            .filter(|(_, at)| style >> at & 1 == 1)
            .for_each(|(ring, _)| ring.reverse());
    }
    if is_asked(Special::FlatRings) && style & 2 == 2 {
        add_flat_rings(question, &mut Random::new(style.into()));
    }
    Ok(shape.name())
}

/// Leaves out straight corners, and rings that have no others.
fn leave_out_straight_corners(question: &mut Question) {
    let Question {
        points, polygons, ..
    } = question;
    with_integers!(points, |exact| {
        for ring in polygons.iter_mut().flatten() {
            while let Some(at) = straight_corner(ring, &exact) {
                ring.remove(at);
            }
        }
    });
    polygons.retain_mut(|rings| {
        let has_outline = rings.first().is_some_and(|ring| !ring.is_empty());
        rings.retain(|ring| !ring.is_empty());
        has_outline
    });
}

/// Leaves out points that are on no ring.
fn leave_out_points(question: &mut Question) {
    let used: BTreeSet<usize> = question.rings().flatten().copied().collect();
    let place = |v: &mut usize| *v = used.range(..*v).count();
    question
        .polygons
        .iter_mut()
        .flatten()
        .flatten()
        .for_each(place);
    question.points = used.iter().map(|&v| question.points[v]).collect();
}

/// Holes of one or two points: at the place of a vertex, or between two vertices.
fn add_flat_rings(question: &mut Question, random: &mut Random) {
    let n = question.points.len();
    for _ in 0..if n == 0 { 0 } else { 1 + random.below(2) } {
        let mut hole = Vec::new();
        for _ in 0..1 + random.below(2) {
            let [p, q] = [0; 2].map(|_| question.points[random.below(n)]);
            hole.push(question.points.len());
            question
                .points
                .push([0, 1].map(|i| p[i] / 2.0 + q[i] / 2.0));
        }
        let at = random.below(question.polygons.len());
        question.polygons[at].push(hole);
    }
}

/// Points above and beside others, and edges between any two.
fn add_lines(question: &mut Question, random: &mut Random) {
    let n = question.points.len();
    if n == 0 {
        return;
    }
    for _ in 0..random.below(4) {
        let [[x, _], [_, y]] = [0; 2].map(|_| question.points[random.below(n)]);
        question.points.push([x, y]);
    }
    let n = question.points.len();
    for _ in 0..random.below(6) {
        question.edges.push([random.below(n), random.below(n)]);
    }
}

/// Leaves out what a program is never asked, as far as points and edges can be left out. What is left of polygons that
/// must not be asked says [`Claims::allows`].
fn leave_out(claims: &Claims, question: &mut Question) {
    let is_never = |special| claims.never.contains(&special);
    if is_never(Special::EqualPoints) && question.polygons.is_empty()
        || claims.asked == Asked::Operations
    {
        merge(question);
    }
    let is_left_out = with_integers!(&question.points, |exact| {
        let edges = question.all_edges();
        let graph = Graph::new(&exact, &edges);
        let lines = question.edges.len();
        let mut out: BTreeSet<usize> = BTreeSet::new();
        if is_never(Special::CrossingEdges) {
            for [e, f] in graph.crossings() {
                // Of two lines the later one; never a side of a ring.
                match (f < lines, out.contains(&e)) {
                    (true, false) => drop(out.insert(f)),
                    (false, _) if e < lines => drop(out.insert(e)),
                    _ => {}
                }
            }
        }
        let mut pieces = BTreeSet::new();
        for e in (lines..edges.len()).chain(0..lines) {
            let chain = &graph.chains[e];
            let own = chain
                .windows(2)
                .map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])]);
            let own: Vec<[usize; 2]> = own.collect();
            if chain.len() == 1 && is_never(Special::EdgesWithoutLength)
                || chain.len() > 2 && is_never(Special::PointsOnEdges)
                || is_never(Special::OverlappingEdges)
                    && own.iter().any(|piece| pieces.contains(piece))
            {
                out.insert(e);
            } else if !out.contains(&e) {
                pieces.extend(own);
            }
        }
        out
    });
    let mut number = 0..;
    question
        .edges
        .retain(|_| !is_left_out.contains(&number.next().unwrap_or(0)));
}

/// Leaves out all points that are equal to others, and what is done to them.
fn merge(question: &mut Question) {
    let mut first: HashMap<[u64; 2], usize> = HashMap::new();
    // For each point the new number of the first equal one, and whether it is that one.
    let mut names: Vec<(usize, bool)> = Vec::new();
    for point in std::mem::take(&mut question.points) {
        // A zero may have lost its sign.
        let key = point.map(|x| (x + 0.0).to_bits());
        let name = *first.entry(key).or_insert(question.points.len());
        let is_first = name == question.points.len();
        question.points.extend(is_first.then_some(point));
        names.push((name, is_first));
    }
    for edge in &mut question.edges {
        *edge = edge.map(|v| names[v].0);
    }
    question.operations.retain_mut(|operation| match operation {
        Operation::Insert(v) | Operation::Remove(v) => {
            let (name, is_first) = names[*v];
            *v = name;
            is_first
        }
    });
}
