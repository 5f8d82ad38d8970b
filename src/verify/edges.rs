//! Check 7: every input edge is a side, or a chain of sides where vertices lie on it.
//!
//! Most edges are a side. The others are followed along the straight chains of sides. At each vertex at most one side
//! goes straight on: the shortest in the direction of the edge (in a triangulation there is only one). So the sides of
//! one direction form trees, in which the *next* side is the parent. An edge is a chain of sides if its lower end
//! starts a side from which a path leads to one that ends at its upper end.
//!
//! ```text
//!        a --> u --> v --> b --> w          The edge a-b: from the side a-u two steps lead to b.
//! ```
//!
//! Edges may overlap, so that many share the same long chain. No side is walked twice: what was walked is a tree with
//! Myers' jump pointers (An applicative random-access stack, Information Processing Letters 17, 1983), in which the
//! last side that does not pass the edge's end is found in O(log n) steps. A tree cannot grow at its root, and need
//! not, because the edges that reach farthest in their direction come first.
//! Cost: O((n + m) log n) for n sides and m edges. The neighbours of a vertex are sorted when the first edge passes it.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::report::Record;
use super::sides::{Sides, range};
use super::soup::{Soup, Tally};
use super::violation::Violation;
use crate::scalar::Scalar;

/// Checks the edges, given by number and the ranks of their ends, and constrains their sides.
pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &mut Sides,
    edges: &[(usize, [u32; 2])],
    record: &mut Record,
) {
    // Points on a line have no triangles, and check 4 has judged them.
    if soup.triangles.is_empty() {
        return;
    }
    let fixed = &mut record.report.constrained_sides;
    let mut fix = |sides: &mut Sides, a, b| {
        let is_new = sides.fix(a, b);
        *fixed += usize::from(is_new == Some(true));
        is_new.is_some()
    };
    let mut split = Vec::new();
    for &(edge, [a, b]) in edges {
        if !fix(sides, a, b) {
            split.push((edge, [a, b]));
        }
    }
    if split.is_empty() {
        return;
    }

    // The edges that reach farthest in their direction come first, as the trees ask.
    let forward = |[a, b]: [u32; 2]| soup.predicates.order(a, b);
    split.sort_unstable_by(|&(_, one), &(_, other)| {
        let direction = forward(one);
        let farther = soup.predicates.order(other[1], one[1]);
        direction.cmp(&forward(other)).then(if direction.is_lt() {
            farther
        } else {
            farther.reverse()
        })
    });
    let mut chains = EdgeChains::new(sides);
    let mut missing = Vec::new();
    for (edge, ends) in split {
        let (reached, passes_added) = chains.follow(soup, ends, |a, b| {
            fix(sides, a, b);
        });
        if reached != ends[1] {
            missing.push((edge, soup.predicates.name(reached)));
        } else if passes_added {
            record.report.split_edges += 1;
        }
    }
    missing.sort_unstable();
    for (edge, after) in missing {
        record.findings.add(Violation::MissingEdge { edge, after });
    }
}

/// In place of a step: the side is not walked yet.
const NEW: u32 = u32::MAX;

/// The sides that leave each vertex, and the steps of those that were walked.
#[derive(Debug)]
struct EdgeChains {
    /// The neighbours of the vertex of rank `v` are `neighbors[starts[v]..starts[v + 1]]`. Once sorted, those after it
    /// in the order (x, y) come first, then those before it, each half counter-clockwise, then nearest first.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
    sorted: Vec<bool>,
    /// For each of `neighbors` the step to it, or [`NEW`].
    step: Vec<u32>,
    steps: Vec<Step>,
}

/// A side that was walked.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// The vertex at its end.
    end: u32,
    /// The step after this one; itself where the walk ended.
    next: u32,
    /// A later step, or itself where the walk ended.
    jump: u32,
    /// How many steps follow.
    depth: u32,
    /// How many steps from this one on end at added points.
    added: u32,
}

impl EdgeChains {
    pub(super) fn new(sides: &Sides) -> EdgeChains {
        let (starts, neighbors) = sides.neighbors();
        EdgeChains {
            sorted: vec![false; starts.len() - 1],
            step: vec![NEW; neighbors.len()],
            steps: Vec::new(),
            starts,
            neighbors,
        }
    }

    /// Follows an edge from one end to the other. Returns how far sides lead along it (to its other end if it is a
    /// chain of sides), and whether they pass an added point. Calls `walk` with each side not walked before.
    fn follow<S: Scalar>(
        &mut self,
        soup: &Soup<'_, S>,
        [a, b]: [u32; 2],
        mut walk: impl FnMut(u32, u32),
    ) -> (u32, bool) {
        let forward = soup.predicates.order(a, b);
        let is_past = |v| soup.predicates.order(b, v) == forward;
        let first_new = self.steps.len();
        let mut known = None;
        let mut at = a;
        while at != b && known.is_none() {
            let Some(place) = self.straight_on(soup, at, b) else {
                break;
            };
            let end = self.neighbors[place];
            if is_past(end) {
                break;
            }
            if self.step[place] == NEW {
                self.step[place] = index(self.steps.len());
                self.steps.push(Step {
                    end,
                    next: 0,
                    jump: 0,
                    depth: 0,
                    added: u32::from(soup.predicates.is_added(end)),
                });
                walk(at, end);
                at = end;
            } else {
                known = Some(self.step[place]);
            }
        }
        let first = if first_new < self.steps.len() {
            Some(index(first_new))
        } else {
            known
        };
        self.link(first_new, known);
        let Some(first) = first else {
            return (a, false);
        };
        let [first, last] = [first, self.last(first, is_past)].map(|at| self.steps[at as usize]);
        (last.end, first.added > last.added)
    }

    /// The position of the side that leaves a vertex in the direction of another.
    fn straight_on<S: Scalar>(&mut self, soup: &Soup<'_, S>, at: u32, to: u32) -> Option<usize> {
        let predicates = &soup.predicates;
        let around = range(&self.starts, at);
        let neighbors = &mut self.neighbors[around.clone()];
        // Not counted: how many signs a sort or a search takes is up to the standard library.
        let turn = |v, w| predicates.orient2d([at, v, w], &mut Tally::default());
        let half = |v| predicates.order(at, v);
        let compare = |v, w| half(v).cmp(&half(w)).then_with(|| turn(w, v));
        if !core::mem::replace(&mut self.sorted[at as usize], true) {
            neighbors.sort_unstable_by(|&v, &w| {
                let nearer = || match half(v) {
                    Ordering::Less => predicates.order(v, w),
                    _ => predicates.order(w, v),
                };
                compare(v, w).then_with(nearer)
            });
        }
        let place = neighbors.partition_point(|&v| compare(v, to).is_lt());
        let is_straight = neighbors
            .get(place)
            .is_some_and(|&v| compare(v, to).is_eq());
        is_straight.then_some(around.start + place)
    }

    /// Links the steps from `first` on, each to the one after it, and the last to `after`.
    fn link(&mut self, first: usize, mut after: Option<u32>) {
        for own in (first..self.steps.len()).rev() {
            let own_index = index(own);
            let (next, jump, depth, added) = match after {
                None => (own_index, own_index, 0, 0),
                Some(next) => {
                    let one = self.steps[next as usize];
                    let two = self.steps[one.jump as usize];
                    let three = self.steps[two.jump as usize];
                    let is_even = one.depth - two.depth == two.depth - three.depth;
                    let jump = if is_even { two.jump } else { next };
                    (next, jump, one.depth + 1, one.added)
                }
            };
            let step = &mut self.steps[own];
            (step.next, step.jump, step.depth) = (next, jump, depth);
            step.added += added;
            after = Some(own_index);
        }
    }

    /// The last step from `from` on that does not pass the end of the edge.
    fn last(&self, from: u32, is_past: impl Fn(u32) -> bool) -> u32 {
        let step = |at: u32| self.steps[at as usize];
        let mut at = from;
        loop {
            let Step { next, jump, .. } = step(at);
            at = if !is_past(step(jump).end) && jump != at {
                jump
            } else if !is_past(step(next).end) && next != at {
                next
            } else {
                return at;
            };
        }
    }
}

fn index(step: usize) -> u32 {
    u32::try_from(step).expect("there are fewer sides")
}
