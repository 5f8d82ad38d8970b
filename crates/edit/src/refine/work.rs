//! The state of a refinement: the mesh, the parts of edges, labels, and the parts and triangles that wait.

use std::collections::{BTreeMap, BTreeSet};

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;

use crate::bounds::{Bounds, Broken};
use crate::edits::Edits;
use crate::measure::{compare_angle, scalar_product, squared_cosine};
use crate::mesh::{number, turned};
use crate::refine::{Reason, RefineError, Refinement};
use crate::triangulation::DynamicTriangulation;

/// The label of triangles outside; those inside have 1, or 2 more than the number of their region.
pub(super) const OUTSIDE: u32 = 0;
/// No label yet.
pub(super) const UNKNOWN: u32 = u32::MAX;

/// A part of an edge: one side of the triangulation, until it is split.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// The ends of the part, as numbers of points.
    pub(super) ends: [u32; 2],
    /// The labels on its left and on its right.
    pub(super) labels: [u32; 2],
    /// Whether it meets another part at a sharp corner of the input there.
    pub(super) is_sharp: [bool; 2],
    /// The point that splits it, and its halves.
    pub(super) halves: Option<(u32, [u32; 2])>,
    /// Why it cannot be split.
    pub(super) is_whole: Option<Reason>,
}

impl Part {
    pub(super) fn new(ends: [u32; 2], labels: [u32; 2]) -> Part {
        Part {
            ends,
            labels,
            is_sharp: [false; 2],
            halves: None,
            is_whole: None,
        }
    }
}

/// Where a vertex lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// The vertex is a point of the input.
    Given,
    /// The vertex splits an edge, perhaps in a shell around a sharp corner.
    OnPart(Option<Shell>),
    /// The vertex was added to a triangle.
    Free,
}

/// A circle around a sharp corner, by its point and the radius that was meant, which rounding does not touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shell {
    pub(super) corner: u32,
    pub(super) radius: f64,
}

/// A refinement at work.
pub(super) struct Work<'w, 'a, S> {
    pub(super) how: &'w Refinement<'a>,
    pub(super) mesh: DynamicTriangulation<S>,
    /// The label of each triangle.
    pub(super) labels: Vec<u32>,
    /// All parts, by their numbers as edges of the mesh.
    pub(super) parts: Vec<Part>,
    /// The parts that are not split, by their ends in ascending order.
    pub(super) parts_by_ends: BTreeMap<[u32; 2], u32>,
    /// How many parts there were at first.
    pub(super) first_parts: usize,
    /// For each edge of the input its parts at first, and whether each goes along it.
    pub(super) chains: Vec<Vec<(u32, bool)>>,
    /// For each point where it lies.
    pub(super) kinds: Vec<Kind>,
    /// How many points went again.
    pub(super) gone: usize,
    /// How far from its shortest side a triangle's new vertex comes, in lengths of the side.
    pub(super) off_center: f64,
    /// The squared cosine of the angle at which a vertex encroaches a part that it sees.
    pub(super) lens: f64,
    /// Parts to be split.
    pub(super) waiting: BTreeSet<u32>,
    /// Triangles that break a bound.
    pub(super) bad: Vec<Bad>,
    /// Triangles that stay, by their vertices from the lowest on.
    pub(super) stays: BTreeMap<[usize; 3], Reason>,
    /// For each triangle the last round in which a new vertex took it.
    pub(super) taken: Vec<u32>,
}

/// A triangle that breaks a bound.
#[derive(Clone, Copy)]
pub(super) struct Bad {
    pub(super) t: u32,
    pub(super) vertices: [u32; 3],
    pub(super) bound: Broken,
    /// The greater, the sooner it gets a vertex.
    pub(super) rank: f64,
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
                    parts.push(Part::new(ends, labels));
                }
            }
        }
        let chain = |e: usize| {
            let chain: Vec<usize> = result.edge_chain(e).collect();
            let parts = chain.windows(2).map(|pair| {
                let ends = [number(pair[0]), number(pair[1])];
                let [a, b] = ends;
                // Where all points lie on one line, there are no sides yet.
                let part = *parts_by_ends
                    .entry([a.min(b), a.max(b)])
                    .or_insert_with(|| {
                        parts.push(Part::new(ends, [OUTSIDE; 2]));
                        number(parts.len() - 1)
                    });
                (part, parts[part as usize].ends == ends)
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
        if mesh.canonical_triangles() != result.canonical_triangles() {
            return Err(RefineError::OtherInput);
        }
        let angle = how.bounds.least_angle.filter(|&angle| angle > 0.0);
        let cosine = angle.map(|angle| angle.to_radians().cos());
        Ok(Work {
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
        })
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

    /// A vertex by doubles near it.
    pub(super) fn near(&self, v: u32) -> [f64; 2] {
        self.mesh.points.place(v).each_ref().map(S::approx)
    }

    /// The part between two points.
    pub(super) fn part_between(&self, a: u32, b: u32) -> u32 {
        self.parts_by_ends[&[a.min(b), a.max(b)]]
    }

    /// The part on a side that one covers.
    pub(super) fn part_at(&self, side: u32) -> u32 {
        self.parts_by_ends[&self.names(self.mesh.mesh.ends(side))]
    }

    /// The bounds of a triangle.
    pub(super) fn bounds_of(&self, t: u32) -> Bounds {
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
            let near = corners.map(|v| self.near(v));
            let area = area_at([0, 1].map(|i| near.iter().map(|corner| corner[i] / 3.0).sum()));
            if area > 0.0 {
                bound(area);
            }
        }
        bounds
    }

    /// Whether a place that sees a side sees it at an angle that is too obtuse.
    pub(super) fn is_encroached(&self, side: u32, place: &[S; 2]) -> bool {
        let [a, b] = self.mesh.mesh.ends(side).map(|v| self.mesh.points.place(v));
        scalar_product([a, b, place]).is_lt() && compare_angle([a, b, place], self.lens).is_ge()
    }

    /// Why a part cannot be split, if that is known.
    pub(super) fn why_whole(&self, part: u32) -> Option<Reason> {
        let part = &self.parts[part as usize];
        let is_kept = self.how.keeps_boundary && part.labels.contains(&OUTSIDE);
        part.is_whole.or(is_kept.then_some(Reason::Boundary))
    }

    pub(super) fn key(&self, vertices: [u32; 3]) -> [usize; 3] {
        turned(vertices.map(|v| self.mesh.points.name(v)))
    }
}
