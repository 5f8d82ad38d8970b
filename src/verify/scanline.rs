//! The declared sides from left to right: do they bound a domain, and which points lie in it?
//!
//! A vertical line goes over the plane. It keeps the sides that it crosses, from below, and how often the chains go
//! round what is just above each of them: once more than below it for a side that runs to the right, once less for one
//! to the left. *Left*, *right* and *below* are meant in the order (x, y), so that no side is vertical.
//!
//! ```text
//!             0
//!     .---<---:---.
//!     |       1   |          The numbers on the line: outside, in the domain, in its hole, at the
//!     |  .->--:-. |          vertex v, outside.
//!     |  |    0 | |
//!     |  '--<-:-' |
//!     |       v 1 |
//!     '---->--:---'
//!             0
//! ```
//!
//! The chains bound a domain if that number is 0 or 1 everywhere and no two sides cross. (Sides may meet in vertices,
//! also inside of sides; and two sides that run against each other may overlap.) Sides that cross are next to each
//! other on the line before they do (Shamos and Hoey, Geometric intersection problems, FOCS 1976), so it is enough to
//! compare neighbours. The order on the line is not used after a crossing, so it always holds.
//! Cost: O((n + m) log m) for n points and m sides.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::soup::Soup;
use crate::scalar::Scalar;

/// A declared side.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// The left end.
    from: u32,
    /// The right end.
    to: u32,
    /// Whether it was declared from left to right.
    runs_right: bool,
}

/// An event at a vertex. Events come in this order.
#[derive(Clone, Copy, Debug)]
enum Event {
    End(Side),
    Query,
    Start(Side),
}

/// A place on the line.
#[derive(Clone, Copy, Debug)]
enum Place {
    On(Side),
    /// Just below a vertex.
    Below(u32),
    /// Just above a vertex.
    Above(u32),
}

/// A place as a key, ordered from below.
#[derive(Debug)]
struct Key<'a, S> {
    soup: &'a Soup<'a, S>,
    place: Place,
}

/// The vertical line.
struct Line<'a, S> {
    soup: &'a Soup<'a, S>,
    /// The sides that the line crosses, each with how often the chains go round what is above it.
    sides: BTreeMap<Key<'a, S>, (Side, i32)>,
}

/// The `points` in the domain that the sides bound, or on its boundary, in ascending order. The sides form closed
/// chains. An error is a side where they do not bound a domain.
#[expect(
    clippy::mutable_key_type,
    reason = "the order of places does not depend on how many near-ties were counted"
)]
pub(super) fn inside<'a, S: Scalar>(
    soup: &'a Soup<'a, S>,
    sides: &[[u32; 2]],
    points: impl Iterator<Item = u32>,
) -> Result<Vec<u32>, [u32; 2]> {
    let mut events: Vec<(u32, Event)> = points.map(|v| (v, Event::Query)).collect();
    for &[a, b] in sides {
        let runs_right = soup.order(a, b).is_lt();
        let (from, to) = if runs_right { (a, b) } else { (b, a) };
        let side = Side {
            from,
            to,
            runs_right,
        };
        // A point has no side to its equal.
        if from != to {
            events.push((from, Event::Start(side)));
            events.push((to, Event::End(side)));
        }
    }
    let order = |(v, one): &(u32, Event), (w, other): &(u32, Event)| {
        soup.order(*v, *w).then(one.turn().cmp(&other.turn()))
    };
    events.sort_by(order);

    let sides = BTreeMap::new();
    let mut line = Line { soup, sides };
    let mut inside = Vec::new();
    for at_vertex in events.chunk_by(|a, b| a.0 == b.0) {
        let is_inside = line.pass(at_vertex)?;
        let is_query = |event: &&(u32, Event)| matches!(event.1, Event::Query);
        let queries = at_vertex.iter().filter(is_query);
        inside.extend(queries.filter(|_| is_inside).map(|event| event.0));
    }
    inside.sort_unstable();
    Ok(inside)
}

impl<'a, S: Scalar> Line<'a, S> {
    /// Passes a vertex with all its events. Returns whether it lies in the domain.
    fn pass(&mut self, events: &[(u32, Event)]) -> Result<bool, [u32; 2]> {
        let v = events[0].0;
        let mut is_end = false;
        for &(_, event) in events {
            match event {
                Event::Query => continue,
                Event::End(side) => drop(self.sides.remove(&self.key(Place::On(side)))),
                Event::Start(side) => {
                    let key = self.key(Place::On(side));
                    // Two sides that overlap must have the domain on different sides.
                    if self.sides.insert(key, (side, 0)).is_some() {
                        return Err(side.declared());
                    }
                }
            }
            is_end = true;
        }
        let below = self.sides.range(..self.key(Place::Below(v))).next_back();
        let below = below.map(|(_, &side)| side);
        let mut times = below.map_or(0, |(_, times)| times);
        let through = self.key(Place::Below(v))..self.key(Place::Above(v));
        if !is_end {
            return Ok(times != 0 || self.sides.range(through).next().is_some());
        }

        for (side, above) in self
            .sides
            .range_mut(through)
            .map(|(_, value)| (value.0, &mut value.1))
        {
            times += if side.runs_right { 1 } else { -1 };
            if !(0..=1).contains(&times) {
                return Err(side.declared());
            }
            *above = times;
        }
        // The lowest side at v and the one below have become neighbours, and the highest and the one above.
        let mut last = below.map(|(side, _)| side);
        for (key, &(side, _)) in self.sides.range(self.key(Place::Below(v))..) {
            if last.is_some_and(|last| self.cross(last, side)) {
                return Err(side.declared());
            }
            if *key > self.key(Place::Above(v)) {
                break;
            }
            last = Some(side);
        }
        Ok(true)
    }

    fn key(&self, place: Place) -> Key<'a, S> {
        Key {
            soup: self.soup,
            place,
        }
    }

    /// Whether two sides cross, of which `low` is below.
    fn cross(&self, low: Side, high: Side) -> bool {
        if self.soup.order(low.to, high.to).is_gt() {
            turn(self.soup, low, high.to).is_lt()
        } else {
            turn(self.soup, high, low.to).is_gt()
        }
    }
}

/// Whether a vertex is above a side (`Greater`).
fn turn<S: Scalar>(soup: &Soup<'_, S>, side: Side, v: u32) -> Ordering {
    soup.turn([side.from, side.to, v])
}

impl Side {
    fn declared(self) -> [u32; 2] {
        if self.runs_right {
            [self.from, self.to]
        } else {
            [self.to, self.from]
        }
    }
}

impl Event {
    /// The order of events: sides end before others start.
    fn turn(self) -> u8 {
        match self {
            Event::End(_) => 0,
            Event::Query => 1,
            Event::Start(_) => 2,
        }
    }
}

impl<S: Scalar> Key<'_, S> {
    /// Compares two sides at the later left end, or where they go on; if they overlap, by which has the domain below.
    fn compare_sides(&self, one: Side, other: Side) -> Ordering {
        if self.soup.order(one.from, other.from).is_gt() {
            return self.compare_sides(other, one).reverse();
        }
        turn(self.soup, one, other.from)
            .then_with(|| turn(self.soup, one, other.to))
            .reverse()
            .then_with(|| one.runs_right.cmp(&other.runs_right))
    }
}

impl<S: Scalar> Ord for Key<'_, S> {
    fn cmp(&self, other: &Self) -> Ordering {
        use Place::{Above, Below, On};
        match (self.place, other.place) {
            (On(one), On(other)) => self.compare_sides(one, other),
            (Below(v), On(side)) => turn(self.soup, side, v).then(Ordering::Less),
            (Above(v), On(side)) => turn(self.soup, side, v).then(Ordering::Greater),
            (On(_), _) => other.cmp(self).reverse(),
            // Two places at one vertex.
            (Below(_), Above(_)) => Ordering::Less,
            (Above(_), Below(_)) => Ordering::Greater,
            (Below(_), Below(_)) | (Above(_), Above(_)) => Ordering::Equal,
        }
    }
}

impl<S: Scalar> PartialOrd for Key<'_, S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for Key<'_, S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for Key<'_, S> {}
