//! The boundary from one point of the input to the next through added points, a *run*: straight, or beside the line, as
//! [`bent`](super::bent) has it.
//!
//! Why a bent run is right but for its depth: the lines of all runs are the hull or the declared domain, and the boundary as
//! it is goes round each place once or not at all, so the triangles cover what it bounds once. No point of the input is
//! between a run and its line: of those that are corners this is seen here; and those that are not are missed by check
//! 5, if they are in the domain or within the boundary as it is.

use alloc::vec::Vec;

use super::bent::{self, Bend, Pass};
use super::depth::Depth;
use super::sides::Sides;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// A run that passes an added point.
#[derive(Debug)]
pub(super) struct Run {
    /// The vertices of the run, as the boundary runs.
    chain: Vec<u32>,
    /// If it is not straight, its farthest vertex with the distance, or else a vertex that it goes round.
    bend: Option<(u32, Option<f64>)>,
}

impl Run {
    /// The run, if the chain passes an added point and goes forward.
    pub(super) fn of<S: Scalar>(soup: &Soup<'_, S>, sides: &Sides, chain: &[u32]) -> Option<Run> {
        let [first, .., last] = *chain else {
            return None;
        };
        let chain = chain.to_vec();
        if chain.len() == 2 {
            return None;
        }
        if bent::is_straight(soup, &chain) {
            return Some(Run { chain, bend: None });
        }
        let Bend { vertices, farthest } = Bend::of(soup, [first, last], chain)?;
        let (farthest, distance) = farthest;
        let bend = match bent::between(soup, sides, [first, last], &vertices) {
            Some(vertex) => (vertex, None),
            None => (farthest, Some(distance)),
        };
        Some(Run {
            chain: vertices,
            bend: Some(bend),
        })
    }

    pub(super) fn is_bent(&self) -> bool {
        self.bend.is_some()
    }

    pub(super) fn ends(&self) -> [u32; 2] {
        [self.chain[0], self.chain[self.chain.len() - 1]]
    }

    /// The vertices that are on the line, the ends among them.
    pub(super) fn on_line<S: Scalar>(&self, soup: &Soup<'_, S>) -> impl Iterator<Item = u32> {
        let [a, b] = self.ends();
        let turn = move |v: u32| soup.turn([a, b, v]);
        self.chain.iter().copied().filter(move |&v| turn(v).is_eq())
    }

    /// The vertices from one of them to both of its ends.
    pub(super) fn both_ways(&self, from: u32) -> [Vec<u32>; 2] {
        let at = self.chain.iter().position(|&v| v == from);
        let (before, after) = self.chain.split_at(at.expect("it is one of them"));
        let back = [from].into_iter().chain(before.iter().rev().copied());
        [after.to_vec(), back.collect()]
    }

    /// The added points that it passes.
    pub(super) fn passes(&self) -> impl Iterator<Item = Pass> {
        let inner = self.chain[1..self.chain.len() - 1].iter();
        inner.map(|&vertex| Pass {
            vertex,
            line: self.ends(),
            edge: None,
            is_beside: self.is_bent(),
        })
    }

    /// What is wrong with it, if it is not straight. It has no depth unless the boundary is `simple`.
    pub(super) fn violation<S: Scalar>(
        &self,
        soup: &Soup<'_, S>,
        is_simple: bool,
    ) -> Option<Violation> {
        let (vertex, distance) = self.bend?;
        Some(Violation::BentBoundary {
            side: soup.names(self.ends()),
            vertex: soup.name(vertex),
            depth: distance.filter(|_| is_simple).and_then(Depth::new),
        })
    }
}

/// The runs of a closed chain, and the chain without the added points beside the lines of its runs.
pub(super) fn of_chain<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    chain: &[u32],
) -> (Vec<Run>, Vec<u32>) {
    let is_own = |&v: &u32| !soup.is_added(v);
    let (mut runs, mut frame) = (Vec::new(), Vec::new());
    let Some(first) = chain.iter().position(is_own) else {
        return (runs, chain.to_vec());
    };
    let mut closed = chain.to_vec();
    closed.rotate_left(first);
    closed.push(closed[0]);
    let mut at = 0;
    while at + 1 < closed.len() {
        let own = closed[at + 1..].iter().position(is_own);
        let next = at + 1 + own.expect("the chain ends at its first vertex");
        let run = Run::of(soup, sides, &closed[at..=next]);
        let is_bent = run.as_ref().is_some_and(Run::is_bent);
        frame.extend(&closed[at..if is_bent { at + 1 } else { next }]);
        runs.extend(run);
        at = next;
    }
    (runs, frame)
}
