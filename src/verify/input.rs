//! The caller's arrays, checked and renumbered: distinct points get ranks in the order in which the
//! triangles name them, so that the later passes find neighbours near each other in memory.

use std::cmp::Ordering;

use super::findings::Findings;
use super::points;
use super::report::Violation;
use super::sides::NONE;
use super::signs::{Signs, Tally};
use crate::scalar::Scalar;

/// The triangulation by rank.
#[derive(Debug)]
pub(super) struct Mesh<'a, S> {
    pub(super) signs: Signs<'a, S>,
    /// Numbered as the caller's; [`NONE`] three times where one is not fit for further checks.
    pub(super) triangles: Vec<[u32; 3]>,
}

/// What the caller gave, as far as it is in range.
#[derive(Debug)]
pub(super) struct Input<'a, S> {
    pub(super) mesh: Mesh<'a, S>,
    /// Edges with two different ends, by number.
    pub(super) edges: Vec<(usize, [u32; 2])>,
    /// The sides of the caller's chains.
    pub(super) declared: Vec<[u32; 2]>,
    /// Vertices of this rank and above are in no triangle.
    pub(super) used: u32,
}

/// Reports what is not finite or out of range, and renumbers the rest.
pub(super) fn read<'a, S: Scalar>(
    points: &'a [[S; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
    chains: &[Vec<usize>],
    findings: &mut Findings,
) -> Input<'a, S> {
    let mut ranks = Ranks::new(points, findings);
    let kept = triangles.iter().enumerate().map(|(triangle, corners)| {
        if let Some(&vertex) = corners.iter().find(|&&v| v >= points.len()) {
            findings.add(Violation::TriangleOutOfRange { triangle, vertex });
        }
        ranks.of(corners).unwrap_or([NONE; 3])
    });
    let triangles = kept.collect();
    let used = ranks.count();
    for v in 0..points.len() {
        ranks.of(&[v]);
    }

    let mut kept = Vec::with_capacity(edges.len());
    for (edge, ends) in edges.iter().enumerate() {
        if let Some(&vertex) = ends.iter().find(|&&v| v >= points.len()) {
            findings.add(Violation::EdgeOutOfRange { edge, vertex });
        }
        kept.extend(
            ranks
                .of(ends)
                .filter(|[a, b]| a != b)
                .map(|ends| (edge, ends)),
        );
    }
    let mut declared = Vec::new();
    for chain in chains {
        for (i, &from) in chain.iter().enumerate() {
            let side = [from, chain[(i + 1) % chain.len()]];
            match ranks.of(&side) {
                Some(side) => declared.push(side),
                None => findings.add(Violation::MissingBoundary { side }),
            }
        }
    }
    Input {
        mesh: Mesh {
            signs: ranks.signs,
            triangles,
        },
        edges: kept,
        declared,
        used,
    }
}

/// Ranks as they are given out.
struct Ranks<'a, S> {
    signs: Signs<'a, S>,
    /// Of each point: its rank, or one of these two.
    rank: Vec<u32>,
    /// For each point the lowest index of a point equal to it, unless all differ.
    representative: Option<Vec<u32>>,
    near: Vec<[f64; 2]>,
}

/// No rank yet.
const NEW: u32 = u32::MAX - 1;
/// Not finite.
const UNFIT: u32 = u32::MAX;

impl<'a, S: Scalar> Ranks<'a, S> {
    fn new(points: &'a [[S; 2]], findings: &mut Findings) -> Ranks<'a, S> {
        let mut rank = vec![NEW; points.len()];
        let mut near = Vec::with_capacity(points.len());
        for (vertex, (point, rank)) in points.iter().zip(&mut rank).enumerate() {
            if point.iter().all(S::is_finite) {
                near.push([point[0].approx(), point[1].approx()]);
            } else {
                findings.add(Violation::NonFiniteCoordinate { vertex });
                *rank = UNFIT;
                near.push([0.0; 2]);
            }
        }
        let usable = |v: u32| rank[v as usize] == NEW;
        let representative = points::representatives(points, &near, usable);
        let signs = Signs {
            points,
            vertex: Vec::with_capacity(points.len()),
            near: Vec::with_capacity(points.len()),
        };
        Ranks {
            signs,
            rank,
            representative,
            near,
        }
    }

    fn count(&self) -> u32 {
        u32::try_from(self.signs.vertex.len()).expect("the size was checked")
    }

    /// The ranks of vertices, new ones if need be; `None` if one is out of range or not finite.
    #[inline]
    fn of<const N: usize>(&mut self, vertices: &[usize; N]) -> Option<[u32; N]> {
        let mut result = [0; N];
        for (to, &given) in result.iter_mut().zip(vertices) {
            if *self.rank.get(given)? == UNFIT {
                return None;
            }
            *to = u32::try_from(given).expect("the size was checked");
        }
        for to in &mut result {
            if let Some(representative) = &self.representative {
                *to = representative[*to as usize];
            }
            let v = *to as usize;
            if self.rank[v] == NEW {
                self.rank[v] = self.count();
                self.signs.vertex.push(*to);
                self.signs.near.push(self.near[v]);
            }
            *to = self.rank[v];
        }
        Some(result)
    }
}

impl<S: Scalar> Mesh<'_, S> {
    /// How many vertices there are.
    pub(super) fn count(&self) -> u32 {
        u32::try_from(self.signs.vertex.len()).expect("the size was checked")
    }

    /// If the first triangle that is not flat is clockwise, turns all round.
    pub(super) fn turn_if_clockwise(&mut self, tally: &mut Tally) -> bool {
        let kept = self.triangles.iter().filter(|t| t[0] != NONE);
        let mut turns = kept.map(|&t| self.signs.orient2d(t, tally));
        let clockwise = turns.find(|turn| turn.is_ne()) == Some(Ordering::Less);
        if clockwise {
            for triangle in &mut self.triangles {
                triangle.swap(1, 2);
            }
        }
        clockwise
    }

    /// Without triangles all vertices must lie on one line.
    pub(super) fn check_collinear(&self, tally: &mut Tally, findings: &mut Findings) {
        let off = (2..self.count()).find(|&v| self.signs.orient2d([0, 1, v], tally).is_ne());
        if let Some(v) = off {
            let vertices = [0, 1, v].map(|v| self.signs.name(v));
            findings.add(Violation::NoTriangles { vertices });
        }
    }
}

impl<S> Mesh<'_, S> {
    /// The ends of side `3 t + i`.
    pub(super) fn side(&self, side: u32) -> [u32; 2] {
        let (triangle, i) = (self.triangles[side as usize / 3], side as usize % 3);
        [triangle[i], triangle[(i + 1) % 3]]
    }
}
