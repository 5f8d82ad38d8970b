//! The rounds of a refinement: parts are split, then triangles get new vertices.
//!
//! Cost: a round costs its edits, and a sort of the triangles that wait.

use std::collections::BTreeSet;

use sweep_cdt::crossings::Exact;

use crate::bounds::Broken;
use crate::edits::{Change, Edits};
use crate::error::EditError;
use crate::measure::{compare_side, scalar_product};
use crate::mesh::number;
use crate::refine::candidate::Candidate;
use crate::refine::parts::Split;
use crate::refine::work::{Bad, Kind, OUTSIDE, Part, Work};
use crate::refine::{Reason, RefineError, Refined};

impl<S: Exact> Work<'_, '_, S> {
    /// Refines until nothing is left to do.
    pub(super) fn run(mut self) -> Result<Refined<S>, RefineError> {
        self.find_sharp_corners();
        self.settle();
        for round in 1.. {
            while !self.waiting.is_empty() {
                self.split_parts()?;
            }
            if self.bad.is_empty() || self.room() == 0 {
                break;
            }
            self.insert(round)?;
            if let Some(progress) = self.how.progress {
                progress(self.count(), self.bad.len());
            }
        }
        Ok(self.refined())
    }

    /// How many points there are.
    fn count(&self) -> usize {
        self.kinds.len() - self.gone
    }

    /// How many points may come yet.
    fn room(&self) -> usize {
        let most = self.how.most_points.unwrap_or(usize::MAX);
        most.saturating_sub(self.count())
    }

    /// Looks at the triangles of the last edit.
    fn settle(&mut self) {
        for t in self.relabel() {
            for side in 3 * t..3 * t + 3 {
                if self.mesh.mesh.covers(side) > 0 && self.must_split(side) {
                    let part = self.part_at(side);
                    if self.why_whole(part).is_none() {
                        self.waiting.insert(part);
                    }
                }
            }
            let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
            let corners = vertices.map(|v| self.mesh.points.place(v));
            if let Some(bound) = self.bounds_of(t).broken(corners) {
                let rank = rank(corners, bound);
                self.bad.push(Bad {
                    t,
                    vertices,
                    bound,
                    rank,
                });
            }
        }
    }

    /// Whether the part on a side must be split: it is too long, or the corner opposite encroaches it.
    fn must_split(&self, side: u32) -> bool {
        let apex = self.mesh.points.place(self.mesh.mesh.apex(side));
        let ends = self.mesh.mesh.ends(side).map(|v| self.mesh.points.place(v));
        let is_long = |most| compare_side(ends, most).is_gt();
        self.how.bounds.greatest_side.is_some_and(is_long) || self.is_encroached(side, apex)
    }

    /// Splits the parts that wait, after vertices of ours in the circles over them are gone.
    fn split_parts(&mut self) -> Result<(), EditError> {
        loop {
            let gone: BTreeSet<usize> = self
                .waiting
                .iter()
                .flat_map(|&part| self.free_over(part))
                .collect();
            if gone.is_empty() {
                break;
            }
            self.gone += gone.len();
            let remove_points = gone.into_iter().collect();
            self.mesh.edit(
                Edits {
                    remove_points,
                    ..Edits::default()
                },
                false,
            )?;
            self.settle();
        }
        // Parts that take a sweep come together, after all others.
        let mut rest = Vec::new();
        for part in std::mem::take(&mut self.waiting) {
            if self.room() == 0 {
                self.keep(part, Reason::Limit);
                continue;
            }
            match self.halfway(part) {
                Ok(split) => {
                    if !self.split_by_star(&split) {
                        rest.push(part);
                    }
                }
                Err(reason) => self.keep(part, reason),
            }
        }
        self.settle();
        let mut splits = Vec::new();
        for part in rest {
            self.waiting.remove(&part);
            let split = if splits.len() < self.room() {
                self.split(part)
            } else {
                Err(Reason::Limit)
            };
            match split {
                Ok(split) => splits.push(split),
                Err(reason) => self.keep(part, reason),
            }
        }
        if self.try_split(&splits).is_ok() {
            return Ok(());
        }
        // Two new points are in each other's way: one after the other.
        for split in splits {
            if self.try_split(std::slice::from_ref(&split)).is_err() {
                self.keep(split.part, Reason::Rounding);
            }
        }
        Ok(())
    }

    fn keep(&mut self, part: u32, reason: Reason) {
        self.parts[part as usize].is_whole = Some(reason);
    }

    /// The vertex of ours, if it is one, in the circle over a part, on either side.
    fn free_over(&self, part: u32) -> Vec<usize> {
        let mesh = &self.mesh.mesh;
        let over = |side: u32| {
            let apex = mesh.apex(side);
            let [a, b] = mesh.ends(side).map(|v| self.mesh.points.place(v));
            let point = self.name(apex) as usize;
            let is_free =
                self.labels[side as usize / 3] != OUTSIDE && self.kinds[point] == Kind::Free;
            (is_free && scalar_product([a, b, self.mesh.points.place(apex)]).is_lt())
                .then_some(point)
        };
        self.sides_of(part).into_iter().filter_map(over).collect()
    }

    /// Splits a part without a sweep, where that can be.
    fn split_by_star(&mut self, split: &Split<S>) -> bool {
        let &[side, _] = self.sides_of(split.part).as_slice() else {
            return false;
        };
        let change = self.mesh.split(split.part as usize, side, &split.place);
        if let Some(change) = &change {
            self.halve(std::slice::from_ref(split), change);
        }
        change.is_some()
    }

    /// Splits these parts at once, or none of them.
    fn try_split(&mut self, splits: &[Split<S>]) -> Result<(), EditError> {
        let first = self.mesh.points.next();
        let points = splits.iter().map(|split| split.place.clone()).collect();
        let halves = |(i, split): (usize, &Split<S>)| {
            let [a, b] = self.parts[split.part as usize].ends.map(|v| v as usize);
            [[a, first + i], [first + i, b]]
        };
        let edges = splits.iter().enumerate().flat_map(halves).collect();
        // The halves come before the part goes: so no view opens across it.
        let change = self.mesh.edit(
            Edits {
                points,
                edges,
                ..Edits::default()
            },
            false,
        )?;
        let mut swept = std::mem::take(&mut self.mesh.swept);
        let remove_edges = splits.iter().map(|split| split.part as usize).collect();
        self.mesh.edit(
            Edits {
                remove_edges,
                ..Edits::default()
            },
            false,
        )?;
        swept.append(&mut self.mesh.swept);
        self.mesh.swept = swept;
        self.halve(splits, &change);
        self.settle();
        Ok(())
    }

    /// Puts halves in the place of parts.
    fn halve(&mut self, splits: &[Split<S>], change: &Change) {
        for (i, split) in splits.iter().enumerate() {
            let [first, second] = [2 * i, 2 * i + 1].map(|i| number(change.edges.start + i));
            let middle = number(change.points.start + i);
            self.kinds.push(split.kind);
            let part = self.parts[split.part as usize].clone();
            let ([a, b], [is_sharp, is_sharp_after]) = (part.ends, part.is_sharp);
            let half = |ends, is_sharp| Part {
                ends,
                is_sharp,
                ..part.clone()
            };
            self.parts.push(half([a, middle], [is_sharp, false]));
            self.parts.push(half([middle, b], [false, is_sharp_after]));
            self.parts[split.part as usize].halves = Some((middle, [first, second]));
            self.parts_by_ends.remove(&[a.min(b), a.max(b)]);
            self.parts_by_ends.insert([a, middle], first);
            self.parts_by_ends.insert([b, middle], second);
        }
    }

    /// Inserts vertices for the triangles that break a bound, in the order of their ranks.
    fn insert(&mut self, round: u32) -> Result<(), EditError> {
        let mut bad = std::mem::take(&mut self.bad);
        bad.retain(|bad| self.is_waiting(bad));
        bad.sort_by(|a, b| a.bound.cmp(&b.bound).then(b.rank.total_cmp(&a.rank)));
        self.taken.resize(self.labels.len(), 0);
        let mut points = Vec::new();
        for bad in bad {
            if points.len() >= self.room() {
                self.bad.push(bad);
                break;
            }
            // A triangle that goes, or whose neighbours go, is looked at in the next round.
            if self.taken[bad.t as usize] == round {
                self.bad.push(bad);
                continue;
            }
            let candidate = self.candidate(&bad);
            match candidate {
                Candidate::Stays(reason) => self.stay(&bad, reason),
                Candidate::Parts(parts) => self.split_instead(&bad, &parts),
                Candidate::Place(place, triangles) => {
                    if triangles.iter().any(|&t| self.taken[t as usize] == round) {
                        self.bad.push(bad);
                        continue;
                    }
                    for t in triangles {
                        self.taken[t as usize] = round;
                    }
                    points.push(place);
                    self.bad.push(bad);
                }
            }
        }
        self.kinds
            .resize(self.kinds.len() + points.len(), Kind::Free);
        self.mesh.edit(
            Edits {
                points,
                ..Edits::default()
            },
            false,
        )?;
        self.settle();
        Ok(())
    }

    /// Whether a triangle is still there and inside, and nothing says that it stays.
    fn is_waiting(&self, bad: &Bad) -> bool {
        self.mesh.mesh.triangle(bad.t) == Some(bad.vertices)
            && self.labels[bad.t as usize] != OUTSIDE
            && !self.stays.contains_key(&self.key(bad.vertices))
    }

    fn stay(&mut self, bad: &Bad, reason: Reason) {
        self.stays.insert(self.key(bad.vertices), reason);
    }

    /// Has parts split that are in the way of a new vertex.
    fn split_instead(&mut self, bad: &Bad, parts: &[u32]) {
        if let Some(reason) = parts.iter().find_map(|&part| self.why_whole(part)) {
            self.stay(bad, reason);
        } else {
            self.waiting.extend(parts);
            self.bad.push(*bad);
        }
    }
}

/// How soon a triangle that breaks this bound gets a vertex.
fn rank<S: Exact>(corners: [&[S; 2]; 3], bound: Broken) -> f64 {
    let near = corners.map(|corner| corner.each_ref().map(S::approx));
    let [a, b, c] = near;
    let squared = |[x, y]: [f64; 2], [z, w]: [f64; 2]| (z - x).powi(2) + (w - y).powi(2);
    let sides = [squared(a, b), squared(b, c), squared(c, a)];
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    match bound {
        // Small triangles first: what comes for them often mends the larger ones beside them.
        Broken::Angle => sides.iter().copied().fold(f64::INFINITY, f64::min).recip(),
        Broken::Area => area,
        Broken::Side => sides.iter().copied().fold(0.0, f64::max),
    }
}
