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
//! Where no side goes straight on, a chain [beside](super::bent) the edge up to the next vertex on it is one step of the
//! tree, which is found again by its first vertex and the direction of its end.
//! Cost: O((n + m) log n) for n sides and m edges. The neighbours of a vertex are sorted when the first edge passes it.

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::bent::{self, Pass};
use super::depth::Depth;
use super::report::Record;
use super::runs::Run;
use super::sides::{Sides, range};
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// Checks the edges, given by number and the ranks of their ends, and constrains their sides. The runs are those of the
/// boundary that pass added points.
pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &mut Sides,
    edges: &[(usize, [u32; 2])],
    runs: &[Run],
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
    let forward = |[a, b]: [u32; 2]| soup.order(a, b);
    split.sort_unstable_by(|&(_, one), &(_, other)| {
        let direction = forward(one);
        let farther = soup.order(other[1], one[1]);
        direction.cmp(&forward(other)).then(if direction.is_lt() {
            farther
        } else {
            farther.reverse()
        })
    });
    let mut chains = EdgeChains::new(soup, sides, runs);
    let mut passes: Vec<Pass> = runs.iter().flat_map(Run::passes).collect();
    let (mut missing, mut bent) = (Vec::new(), Vec::new());
    for (edge, ends) in split {
        let walk = chains.follow(soup, sides, ends);
        for (side, is_beside) in walk.sides {
            fix(sides, side[0], side[1]);
            if soup.is_added(side[1]) {
                passes.push(Pass {
                    vertex: side[1],
                    line: ends,
                    edge: Some(edge),
                    is_beside,
                });
            }
        }
        if walk.reached != ends[1] {
            missing.push((edge, soup.name(walk.reached)));
            continue;
        }
        record.report.split_edges += usize::from(walk.passes_added);
        let farthest = walk.farthest;
        bent.extend(farthest.map(|(v, distance)| (edge, soup.name(v), distance)));
    }
    let pinched = bent::pinched(soup, passes).into_iter();
    missing.extend(pinched.map(|(edge, v)| (edge, soup.name(v))));
    missing.sort_unstable();
    missing.dedup_by_key(|(edge, _)| *edge);
    for (edge, after) in missing {
        record.findings.add(Violation::MissingEdge { edge, after });
    }
    bent.sort_unstable_by_key(|&(edge, ..)| edge);
    for (edge, vertex, distance) in bent {
        let depth = Depth::new(distance);
        record.findings.add(Violation::BentEdge {
            edge,
            vertex,
            depth,
        });
    }
}

/// In place of a step: the side is not walked yet.
const NEW: u32 = u32::MAX;

/// The sides that leave each vertex, and the steps of those that were walked.
#[derive(Debug)]
struct EdgeChains<'a> {
    /// The neighbours of the vertex of rank `v` are `neighbors[starts[v]..starts[v + 1]]`. Once sorted, those after it
    /// in the order (x, y) come first, then those before it, each half counter-clockwise, then nearest first.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
    sorted: Vec<bool>,
    /// For each of `neighbors` the step to it, or [`NEW`].
    step: Vec<u32>,
    steps: Vec<Step>,
    /// The runs of the boundary that are not straight, by each of their vertices on their lines.
    runs: BTreeMap<u32, Vec<&'a Run>>,
    /// The steps beside lines that leave a vertex right of one of its neighbours: the leftmost line first.
    beside: BTreeMap<[u32; 2], Vec<u32>>,
}

/// A side that was walked, or a chain beside the edge.
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
    /// How many added points this step passes, and those that follow.
    added: u32,
}

/// How an edge was followed.
#[derive(Debug, Default)]
struct Walk {
    /// How far sides lead along the edge: to its other end, if it is a chain of sides.
    reached: u32,
    /// Whether they pass an added point.
    passes_added: bool,
    /// The sides that were not walked before, each with whether it ends beside the edge.
    sides: Vec<([u32; 2], bool)>,
    /// The farthest vertex beside the edge on them, and its distance; but for runs of the boundary.
    farthest: Option<(u32, f64)>,
}

impl<'a> EdgeChains<'a> {
    fn new<S: Scalar>(soup: &Soup<'_, S>, sides: &Sides, runs: &'a [Run]) -> EdgeChains<'a> {
        let (starts, neighbors) = sides.neighbors();
        let mut by_vertex: BTreeMap<u32, Vec<&Run>> = BTreeMap::new();
        for run in runs.iter().filter(|run| run.is_bent()) {
            for v in run.on_line(soup) {
                by_vertex.entry(v).or_default().push(run);
            }
        }
        EdgeChains {
            sorted: vec![false; starts.len() - 1],
            step: vec![NEW; neighbors.len()],
            steps: Vec::new(),
            starts,
            neighbors,
            runs: by_vertex,
            beside: BTreeMap::new(),
        }
    }

    /// Follows an edge from one end to the other.
    fn follow<S: Scalar>(&mut self, soup: &Soup<'_, S>, sides: &Sides, edge: [u32; 2]) -> Walk {
        let [a, b] = edge;
        let forward = soup.order(a, b);
        let is_past = |v| soup.order(b, v) == forward;
        let first_new = self.steps.len();
        let mut walk = Walk::default();
        let mut known = None;
        let mut at = a;
        while at != b && known.is_none() {
            let own = index(self.steps.len());
            let chain = match self.straight_on(soup, at, b) {
                Ok(place) => {
                    if is_past(self.neighbors[place]) {
                        break;
                    }
                    if self.step[place] != NEW {
                        known = Some(self.step[place]);
                        continue;
                    }
                    self.step[place] = own;
                    vec![at, self.neighbors[place]]
                }
                Err(around) => {
                    let place = match self.place_beside(soup, [at, b], around[1]) {
                        Ok(step) if is_past(self.steps[step as usize].end) => break,
                        Ok(step) => {
                            known = Some(step);
                            continue;
                        }
                        Err(place) => place,
                    };
                    let on_boundary =
                        || self.on_boundary(soup, edge, at).map(|chain| (chain, None));
                    let inside = || {
                        let bend = bent::beside(soup, sides, edge, at, around)?;
                        Some((bend.vertices, Some(bend.farthest)))
                    };
                    let found = on_boundary().or_else(inside);
                    let found = found.filter(|(chain, _)| !is_past(chain[chain.len() - 1]));
                    let Some((chain, farthest)) = found else {
                        break;
                    };
                    let steps = self.beside.entry([at, around[1]]).or_default();
                    steps.insert(place, own);
                    let most = walk.farthest.map_or(0.0, |(_, most)| most);
                    let is_farther = |&(_, distance): &(u32, f64)| distance > most;
                    walk.farthest = farthest.filter(is_farther).or(walk.farthest);
                    chain
                }
            };
            at = chain[chain.len() - 1];
            let added = chain[1..].iter().filter(|&&v| soup.is_added(v));
            self.steps.push(Step {
                end: at,
                next: 0,
                jump: 0,
                depth: 0,
                added: index(added.count()),
            });
            let passed = chain.windows(2).map(|side| [side[0], side[1]]);
            walk.sides.extend(passed.map(|side| (side, side[1] != at)));
        }
        let first = if first_new < self.steps.len() {
            Some(index(first_new))
        } else {
            known
        };
        self.link(first_new, known);
        walk.reached = a;
        if let Some(first) = first {
            let last = self.last(first, is_past);
            let [of_first, of_last] = [first, last].map(|at| self.steps[at as usize]);
            walk.reached = of_last.end;
            let after = self.steps[of_last.next as usize];
            let rest = if of_last.next == last { 0 } else { after.added };
            walk.passes_added = of_first.added > rest;
        }
        walk
    }

    /// The step beside the line from a vertex to another, or where it would be: `left` is the neighbour left of the line.
    fn place_beside<S: Scalar>(
        &self,
        soup: &Soup<'_, S>,
        [at, to]: [u32; 2],
        left: u32,
    ) -> Result<u32, usize> {
        let steps = self.beside.get(&[at, left]).map_or(&[][..], Vec::as_slice);
        let turn = |step: u32| {
            let end = self.steps[step as usize].end;
            soup.turn([at, end, to])
        };
        let place = steps.partition_point(|&step| turn(step).is_lt());
        let step = steps.get(place).filter(|&&step| turn(step).is_eq());
        step.copied().ok_or(place)
    }

    /// The run of the boundary from a vertex along an edge.
    fn on_boundary<S: Scalar>(
        &self,
        soup: &Soup<'_, S>,
        [a, b]: [u32; 2],
        at: u32,
    ) -> Option<Vec<u32>> {
        let runs = self.runs.get(&at)?.iter();
        let mut chains = runs.flat_map(|run| run.both_ways(at));
        let leads_on = |end| {
            let turn = soup.turn([a, b, end]);
            turn.is_eq() && soup.order(at, end) == soup.order(a, b)
        };
        chains.find(|chain| leads_on(chain[chain.len() - 1]))
    }

    /// The position of the side that leaves a vertex in the direction of another. If there is none, the neighbours right
    /// and left of that direction.
    fn straight_on<S: Scalar>(
        &mut self,
        soup: &Soup<'_, S>,
        at: u32,
        to: u32,
    ) -> Result<usize, [u32; 2]> {
        let around = range(&self.starts, at);
        let neighbors = &mut self.neighbors[around.clone()];
        let half = |v| soup.order(at, v);
        let compare = |v, w| half(v).cmp(&half(w)).then_with(|| soup.turn([at, w, v]));
        if !core::mem::replace(&mut self.sorted[at as usize], true) {
            neighbors.sort_unstable_by(|&v, &w| {
                let nearer = || match half(v) {
                    Ordering::Less => soup.order(v, w),
                    _ => soup.order(w, v),
                };
                compare(v, w).then_with(nearer)
            });
        }
        let place = neighbors.partition_point(|&v| compare(v, to).is_lt());
        let is_straight = neighbors
            .get(place)
            .is_some_and(|&v| compare(v, to).is_eq());
        if is_straight {
            return Ok(around.start + place);
        }
        let before = (place + neighbors.len().saturating_sub(1)).checked_rem(neighbors.len());
        let beside = [before, place.checked_rem(neighbors.len())];
        Err(beside.map(|place| place.map_or(at, |place| neighbors[place])))
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
