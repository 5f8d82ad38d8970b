//! The border: the sides with one triangle must be one convex polygon, passed once.
//!
//! Why it is right: a closed chain that never turns right, and goes up once and down once, goes round once. Going up is
//! by y, then by x, so that each side goes either up or down.

use std::cmp::Ordering;

use super::records::{Map, Open, Vertex, Vertices};
use super::violation::StreamViolation;
use sweep_cdt::scalar::{Scalar, orient2d};

/// By y, then by x.
pub(super) fn upward<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[1].compare(&b[1]).then_with(|| a[0].compare(&b[0]))
}

/// How many sides the border has, if it is a convex polygon.
pub(super) fn convex<S: Scalar>(
    open: &Map<[usize; 2], Open<S>>,
    vertices: &Vertices<S>,
) -> Result<u64, StreamViolation> {
    let mut next = Map::default();
    let mut least = u64::MAX;
    // The least vertex at which two sides of the border begin.
    let mut pinched: Option<u64> = None;
    for (slots, side) in open {
        let [low, high] = slots.map(|slot| vertices.at(slot).number);
        let (from, to) = if side.is_upward {
            (low, high)
        } else {
            (high, low)
        };
        least = least.min(from);
        if next.insert(from, to).is_some() {
            pinched = pinched.into_iter().chain([from]).min();
        }
    }
    if let Some(vertex) = pinched {
        return Err(StreamViolation::NotConvex { vertex });
    }
    let mut at = least;
    let mut chain: Vec<u64> = Vec::new();
    while let Some(to) = next.remove(&at) {
        chain.push(at);
        at = to;
    }
    // Another closed chain is left, or this one does not end where it began.
    let stray = next.keys().copied().min().or((at != least).then_some(at));
    if let Some(vertex) = stray {
        return Err(StreamViolation::NotConvex { vertex });
    }
    let count = chain.len();
    let mut peaks = 0;
    for i in 0..count {
        let numbers = [0, 1, 2].map(|k| chain[(i + k) % count]);
        let corners = numbers.map(|v| vertices.get(v).expect("an end of a side"));
        let [a, b, c] = corners.map(|vertex| &vertex.point);
        let (first, second) = (upward(a, b), upward(b, c));
        let turn = orient2d(a, b, c);
        let is_back = turn.is_eq() && first != second;
        if turn.is_lt() || is_back {
            return Err(StreamViolation::NotConvex { vertex: numbers[1] });
        }
        peaks += usize::from(first.is_lt() && second.is_gt());
    }
    match peaks {
        1 => Ok(count as u64),
        _ => Err(StreamViolation::NotConvex { vertex: least }),
    }
}

/// Without triangles, all vertices must lie on one line.
pub(super) fn all_on_one_line<S: Scalar>(vertices: &Vertices<S>) -> Result<(), StreamViolation> {
    let order = |a: &&Vertex<S>, b: &&Vertex<S>| upward(&a.point, &b.point);
    let (Some(low), Some(high)) = (vertices.iter().min_by(order), vertices.iter().max_by(order))
    else {
        return Ok(());
    };
    let beside = |vertex: &&Vertex<S>| orient2d(&low.point, &high.point, &vertex.point).is_ne();
    let beside = vertices.iter().filter(beside);
    match beside.map(|vertex| vertex.number).min() {
        Some(vertex) => Err(StreamViolation::NoTriangle { vertex }),
        None => Ok(()),
    }
}
