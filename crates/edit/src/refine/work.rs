//! The rounds of a refinement: parts are split, then triangles get new vertices.

use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;

use crate::bounds::{Bounds, Broken, compare_angle, compare_side, scalar_product, squared_cosine};
use crate::edits::{Change, Edits};
use crate::error::EditError;
use crate::mesh::{number, turned};
use crate::refine::candidate::Candidate;
use crate::refine::labels::OUTSIDE;
use crate::refine::parts::{Kind, Part, Split};
use crate::refine::{Left, Reason, RefineError, Refined, Refinement};
use crate::triangulation::DynamicTriangulation;

/// A refinement at work.
pub(super) struct Work<'w, 'a, S> {
    how: &'w Refinement<'a>,
    pub(super) mesh: DynamicTriangulation<S>,
    /// The label of each triangle.
    pub(super) labels: Vec<u32>,
    /// All parts, by their numbers as edges of the mesh.
    pub(super) parts: Vec<Part>,
    /// The parts that are not split, by their ends in ascending order.
    pub(super) parts_by_ends: BTreeMap<[u32; 2], u32>,
    /// How many parts there were at first.
    first_parts: usize,
    /// For each edge of the input its parts at first, and whether each goes along it.
    chains: Vec<Vec<(u32, bool)>>,
    /// For each point where it lies.
    pub(super) kinds: Vec<Kind>,
    /// How many points went again.
    gone: usize,
    /// How far from its shortest side a triangle's new vertex comes, in lengths of the side.
    pub(super) off_center: f64,
    /// The squared cosine of the angle at which a vertex encroaches a part that it sees.
    lens: f64,
    /// Parts to be split.
    waiting: BTreeSet<u32>,
    /// Triangles that break a bound.
    bad: Vec<Bad>,
    /// Triangles that stay, by their vertices from the lowest on.
    stays: BTreeMap<[usize; 3], Reason>,
    /// For each triangle the last round in which a new vertex took it.
    taken: Vec<u32>,
}

/// A triangle that breaks a bound.
#[derive(Clone, Copy)]
pub(super) struct Bad {
    pub(super) t: u32,
    vertices: [u32; 3],
    pub(super) bound: Broken,
    /// The greater, the worse.
    badness: f64,
}

/// The angle of lenses where no angle is asked for.
const ANGLE_OF_LENSES: f64 = 20.0;

impl<'w, 'a, S: Exact> Work<'w, 'a, S> {
    pub(super) fn new(
        how: &'w Refinement<'a>,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        inside: &Interior<'_>,
    ) -> Result<Work<'w, 'a, S>, RefineError> {
        let result = inside.triangulation();
        let count = result.sweep_order().len() + result.duplicates().len();
        if count != points.len() || result.edge_count() != edges.len() {
            return Err(RefineError::OtherInput);
        }
        let label = |t: usize| match (inside.is_inside(t), inside.region(t)) {
            (false, _) => OUTSIDE,
            (true, None) => 1,
            (true, Some(region)) => number(region) + 2,
        };
        // Sides that edges cover, and those of the hull that bound the inside.
        let mut parts = Vec::new();
        let mut parts_by_ends = BTreeMap::new();
        for t in 0..result.len() {
            for k in 0..3 {
                let beyond = result.neighbor(t, k);
                let is_part =
                    result.is_constrained(t, k) || beyond.is_none() && inside.is_inside(t);
                if is_part && beyond.is_none_or(|beyond| t < beyond) {
                    let ends = result.side(t, k).map(number);
                    let [a, b] = ends;
                    parts_by_ends.insert([a.min(b), a.max(b)], number(parts.len()));
                    let labels = [label(t), beyond.map_or(OUTSIDE, label)];
                    let is_sharp = [false; 2];
                    parts.push(Part {
                        ends,
                        labels,
                        is_sharp,
                        halves: None,
                        is_whole: None,
                    });
                }
            }
        }
        let chain = |e: usize| {
            let chain: Vec<usize> = result.edge_chain(e).collect();
            let parts = chain.windows(2).map(|pair| {
                let [a, b] = [number(pair[0]), number(pair[1])];
                let part: u32 = parts_by_ends[&[a.min(b), a.max(b)]];
                (part, parts[part as usize].ends == [a, b])
            });
            parts.collect()
        };
        let chains = (0..edges.len()).map(chain).collect();
        let mut mesh = DynamicTriangulation::new();
        let sides = parts
            .iter()
            .map(|part: &Part| part.ends.map(|v| v as usize));
        let all = Edits {
            points: points.to_vec(),
            edges: sides.collect(),
            ..Edits::default()
        };
        mesh.edit(all, false)?;
        let angle = how.bounds.least_angle.filter(|&angle| angle > 0.0);
        let cosine = angle.map(|angle| angle.to_radians().cos());
        let mut work = Work {
            how,
            mesh,
            labels: Vec::new(),
            first_parts: parts.len(),
            parts,
            parts_by_ends,
            chains,
            kinds: vec![Kind::Given; points.len()],
            gone: 0,
            off_center: cosine.map_or(f64::INFINITY, |c| 0.5 * ((1.0 + c) / (1.0 - c)).sqrt()),
            lens: squared_cosine(2.0 * angle.unwrap_or(ANGLE_OF_LENSES)),
            waiting: BTreeSet::new(),
            bad: Vec::new(),
            stays: BTreeMap::new(),
            taken: Vec::new(),
        };
        work.find_sharp_corners();
        work.settle();
        Ok(work)
    }

    pub(super) fn name(&self, v: u32) -> u32 {
        number(self.mesh.points.name(v))
    }

    /// The numbers of two vertices in ascending order.
    pub(super) fn names(&self, ends: [u32; 2]) -> [u32; 2] {
        let [a, b] = ends.map(|v| self.name(v));
        [a.min(b), a.max(b)]
    }

    pub(super) fn vertex(&self, point: u32) -> u32 {
        self.mesh
            .points
            .vertex(point as usize)
            .expect("a point that is there")
    }

    /// The part between two points.
    pub(super) fn part_between(&self, a: u32, b: u32) -> u32 {
        self.parts_by_ends[&[a.min(b), a.max(b)]]
    }

    /// The part on a side that one covers.
    pub(super) fn part_at(&self, side: u32) -> u32 {
        self.parts_by_ends[&self.names(self.mesh.mesh.ends(side))]
    }

    /// Refines until nothing is left to do.
    pub(super) fn run(mut self) -> Result<Refined<S>, RefineError> {
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
                    self.waiting.insert(self.part_at(side));
                }
            }
            let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
            let corners = vertices.map(|v| self.mesh.points.place(v));
            if let Some(bound) = self.bounds_of(t).broken(corners) {
                let badness = badness(corners, bound);
                self.bad.push(Bad {
                    t,
                    vertices,
                    bound,
                    badness,
                });
            }
        }
    }

    /// The bounds of a triangle.
    fn bounds_of(&self, t: u32) -> Bounds {
        let mut bounds = self.how.bounds;
        let mut bound = |area: f64| {
            bounds.greatest_area = Some(bounds.greatest_area.map_or(area, |other| other.min(area)));
        };
        if let Some(region) = self.labels[t as usize].checked_sub(2)
            && let Some(&area) = self.how.region_areas.get(region as usize)
        {
            bound(area);
        }
        if let Some(area_at) = self.how.area_at {
            let corners = self.mesh.mesh.triangle(t).expect("a triangle");
            let near = corners.map(|v| self.mesh.points.place(v).each_ref().map(S::approx));
            bound(area_at(
                [0, 1].map(|i| near.iter().map(|corner| corner[i] / 3.0).sum()),
            ));
        }
        bounds
    }

    /// Whether the part on a side must be split: it is too long, or the corner opposite encroaches it.
    fn must_split(&self, side: u32) -> bool {
        let apex = self.mesh.points.place(self.mesh.mesh.apex(side));
        let ends = self.mesh.mesh.ends(side).map(|v| self.mesh.points.place(v));
        let is_long = |most| compare_side(ends, most).is_gt();
        self.how.bounds.greatest_side.is_some_and(is_long) || self.is_encroached(side, apex)
    }

    /// Whether a place that sees a side sees it at an angle that is too obtuse.
    pub(super) fn is_encroached(&self, side: u32, place: &[S; 2]) -> bool {
        let [a, b] = self.mesh.mesh.ends(side).map(|v| self.mesh.points.place(v));
        scalar_product([a, b, place]).is_lt() && compare_angle([a, b, place], self.lens).is_ge()
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
        let mut splits = Vec::new();
        for part in std::mem::take(&mut self.waiting) {
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

    /// Why a part cannot be split, if that is known.
    pub(super) fn why_whole(&self, part: u32) -> Option<Reason> {
        let part = &self.parts[part as usize];
        let is_kept = self.how.keeps_boundary && part.labels.contains(&OUTSIDE);
        part.is_whole.or(is_kept.then_some(Reason::Boundary))
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

    /// Inserts vertices for the triangles that break a bound, the worst first.
    fn insert(&mut self, round: u32) -> Result<(), EditError> {
        let mut bad = std::mem::take(&mut self.bad);
        bad.retain(|bad| self.is_waiting(bad));
        bad.sort_by(|a, b| a.bound.cmp(&b.bound).then(b.badness.total_cmp(&a.badness)));
        self.taken.resize(self.labels.len(), 0);
        let mut points = Vec::new();
        for bad in bad {
            let candidate = if points.len() < self.room() {
                self.candidate(&bad)
            } else {
                self.bad.push(bad);
                break;
            };
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

    fn key(&self, vertices: [u32; 3]) -> [usize; 3] {
        turned(vertices.map(|v| self.mesh.points.name(v)))
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

    /// The mesh as its user has it.
    fn refined(self) -> Refined<S> {
        // Vertices that went again have no numbers in the mesh that is returned.
        let points: Vec<usize> = self.mesh.points().collect();
        let mut new = vec![usize::MAX; self.kinds.len()];
        for (i, &point) in points.iter().enumerate() {
            new[point] = i;
        }
        let places = points.iter().map(|&point| {
            let v = self.vertex(number(point));
            self.mesh.points.place(v).clone()
        });
        let (mut edges, mut edge_of) = (Vec::new(), Vec::new());
        let mut is_of_edge = vec![false; self.first_parts];
        let mut push = |chain: &[usize], edge: Option<usize>| {
            for pair in chain.windows(2) {
                edges.push([new[pair[0]], new[pair[1]]]);
                edge_of.push(edge);
            }
        };
        for (edge, parts) in self.chains.iter().enumerate() {
            let mut chain = Vec::new();
            for &(part, is_forward) in parts {
                is_of_edge[part as usize] = true;
                self.follow(part, is_forward, &mut chain);
            }
            push(&chain, Some(edge));
        }
        for part in (0..self.first_parts).filter(|&part| !is_of_edge[part]) {
            let mut chain = Vec::new();
            self.follow(number(part), true, &mut chain);
            push(&chain, None);
        }
        let inside = self
            .mesh
            .mesh
            .all()
            .filter(|&t| self.labels[t as usize] != OUTSIDE);
        let mut triangles: Vec<([usize; 3], u32)> = inside
            .map(|t| {
                let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
                (turned(vertices.map(|v| new[self.mesh.points.name(v)])), t)
            })
            .collect();
        triangles.sort_unstable();
        let region = |&(_, t): &([usize; 3], u32)| {
            self.labels[t as usize]
                .checked_sub(2)
                .map(|region| region as usize)
        };
        let left = triangles.iter().enumerate().filter_map(|(i, &(_, t))| {
            let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
            let bound = self
                .bounds_of(t)
                .broken(vertices.map(|v| self.mesh.points.place(v)))?;
            let reason = self
                .stays
                .get(&self.key(vertices))
                .copied()
                .unwrap_or(Reason::Limit);
            Some(Left {
                triangle: i,
                bound,
                reason,
            })
        });
        Refined {
            points: places.collect(),
            edges,
            edge_of,
            regions: triangles.iter().map(region).collect(),
            left: left.collect(),
            triangles: triangles.iter().map(|&(triangle, _)| triangle).collect(),
        }
    }
}

/// How bad a triangle is that breaks this bound.
fn badness<S: Exact>(corners: [&[S; 2]; 3], bound: Broken) -> f64 {
    let near = corners.map(|corner| corner.each_ref().map(S::approx));
    let [a, b, c] = near;
    let squared = |[x, y]: [f64; 2], [z, w]: [f64; 2]| (z - x).powi(2) + (w - y).powi(2);
    let sides = [squared(a, b), squared(b, c), squared(c, a)];
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    match bound {
        // The sine of the least angle is the area by the two longer sides.
        Broken::Angle => {
            sides.iter().product::<f64>()
                / (area * area * sides.iter().copied().fold(f64::INFINITY, f64::min))
        }
        Broken::Area => area,
        Broken::Side => sides.iter().copied().fold(0.0, f64::max),
    }
}
