//! Check 1: all coordinates are finite and all indices in range. What is in range is renumbered.
//! The points are sorted by the first bits of y, and exactly where these are equal. So equal points are neighbours.
//! Triangles are then taken by their lowest corner, whatever their order in the caller's list, and each distinct point
//! gets a rank, in the order in which these triangles name points first. So what the checks visit together is together in
//! memory. Violations have the caller's numbers, and come by them.
//! Cost: a sort of n numbers of 64 bits and one by counting of the triangles; O(n log n) where many y begin alike.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::declared::DeclaredBoundary;
use super::report::Record;
use super::sides::grouped;
use super::soup::{LIMIT, REJECTED, Soup};
use super::violation::Violation;
use crate::scalar::{NearTies, Scalar, recenter};

/// The caller's input by rank, as far as it is in range.
#[derive(Debug)]
pub(super) struct Ranked<'a, S> {
    pub(super) soup: Soup<'a, S>,
    /// Edges with two different ends, with their numbers.
    pub(super) edges: Vec<(usize, [u32; 2])>,
    pub(super) domain: Option<DeclaredBoundary>,
    /// Vertices of this rank and above are in no triangle.
    pub(super) used: u32,
}

/// Reads the caller's arrays; `None` if they are too large to be numbered.
pub(super) fn read<'a, S: Scalar>(
    points: &'a [[S; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
    chains: Option<&[Vec<usize>]>,
    added_from: usize,
    record: &mut Record,
) -> Option<Ranked<'a, S>> {
    record.report.points = points.len().min(added_from);
    record.report.edges = edges.len();
    record.report.triangles = triangles.len();
    let given = points.len().max(triangles.len().saturating_mul(3));
    if given > LIMIT {
        let limit = LIMIT;
        record.findings.add(Violation::TooLarge { given, limit });
        return None;
    }

    // The triangles come first: ranks follow the order in which they name the points.
    let (mut ranks, places) = Ranks::new(points, added_from, record);
    let numbers = from_below(triangles, &places);
    drop(places);
    ranks.soup.triangles = ranks.read_triangles(triangles, &numbers, record);
    ranks.soup.numbers = numbers;
    let used = ranks.soup.vertices();
    // Then the points that are in no triangle.
    for v in 0..points.len() {
        ranks.of([v]);
    }
    let edges = ranks.read_edges(edges, record);
    let domain = chains.map(|chains| ranks.read_chains(chains, record));
    let soup = ranks.soup;
    let added = |up_to: u32| (0..up_to).filter(|&v| soup.is_added(v)).count();
    record.report.added_points = added(used);
    record.report.distinct_points = soup.vertex.len() - added(soup.vertices());
    Some(Ranked {
        soup,
        edges,
        domain,
        used,
    })
}

/// Ranks as they are given out.
struct Ranks<'a, S> {
    soup: Soup<'a, S>,
    /// For each point its rank, [`NEW`] or [`NOT_FINITE`].
    rank: Vec<u32>,
    /// For each point the lowest index of a point equal to it, unless all differ.
    representative: Option<Vec<u32>>,
    /// For each point its approximated coordinates, scaled.
    approximations: Vec<[f64; 2]>,
}

/// In place of a rank: none is given out yet.
const NEW: u32 = u32::MAX - 1;
/// In place of a rank: the point gets none.
const NOT_FINITE: u32 = u32::MAX;

impl<'a, S: Scalar> Ranks<'a, S> {
    /// No ranks yet, and for each point its place from below.
    fn new(
        points: &'a [[S; 2]],
        added_from: usize,
        record: &mut Record,
    ) -> (Ranks<'a, S>, Vec<u32>) {
        let mut rank = vec![NEW; points.len()];
        let mut approximations = Vec::with_capacity(points.len());
        for (vertex, (point, rank)) in points.iter().zip(&mut rank).enumerate() {
            if point.iter().all(S::is_finite) {
                approximations.push([point[0].approx(), point[1].approx()]);
            } else {
                record
                    .findings
                    .add(Violation::NonFiniteCoordinate { vertex });
                *rank = NOT_FINITE;
                approximations.push([0.0; 2]);
            }
        }
        let is_finite = |v: u32| rank[v as usize] == NEW;
        let scale = recenter(points, &mut approximations);
        let (places, representative) = sort(points, &approximations, is_finite);
        let soup = Soup {
            points,
            added_from,
            scale,
            vertex: Vec::with_capacity(points.len()),
            approx: Vec::with_capacity(points.len()),
            near_ties: NearTies::default(),
            triangles: Vec::new(),
            numbers: Vec::new(),
        };
        let ranks = Ranks {
            soup,
            rank,
            representative,
            approximations,
        };
        (ranks, places)
    }

    /// The triangles by rank, in the order of `numbers`.
    fn read_triangles(
        &mut self,
        triangles: &[[usize; 3]],
        numbers: &[u32],
        record: &mut Record,
    ) -> Vec<[u32; 3]> {
        let mut wrong = Vec::new();
        let ranked = numbers.iter().map(|&number| {
            let triangle = number as usize;
            let corners = triangles[triangle];
            if let Some(vertex) = self.out_of_range(&corners) {
                wrong.push((triangle, vertex));
            }
            self.of(corners).unwrap_or(REJECTED)
        });
        let ranked = ranked.collect();
        wrong.sort_unstable();
        for (triangle, vertex) in wrong {
            let violation = Violation::TriangleOutOfRange { triangle, vertex };
            record.findings.add(violation);
        }
        ranked
    }

    fn read_edges(&mut self, edges: &[[usize; 2]], record: &mut Record) -> Vec<(usize, [u32; 2])> {
        let mut ranked = Vec::with_capacity(edges.len());
        for (edge, &ends) in edges.iter().enumerate() {
            if let Some(vertex) = self.out_of_range(&ends) {
                record
                    .findings
                    .add(Violation::EdgeOutOfRange { edge, vertex });
            }
            let ends = self.of(ends).filter(|[a, b]| a != b);
            ranked.extend(ends.map(|ends| (edge, ends)));
        }
        ranked
    }

    fn read_chains(&mut self, chains: &[Vec<usize>], record: &mut Record) -> DeclaredBoundary {
        let mut sides = Vec::new();
        for chain in chains {
            let first = sides.len();
            let mut is_closed = true;
            for (i, &from) in chain.iter().enumerate() {
                let side = [from, chain[(i + 1) % chain.len()]];
                match self.of(side) {
                    Some(side) => sides.push(side),
                    None => {
                        is_closed = false;
                        record.findings.add(Violation::MissingBoundary { side });
                    }
                }
            }
            // Only closed chains bound something.
            if !is_closed {
                sides.truncate(first);
            }
        }
        DeclaredBoundary { sides }
    }

    fn out_of_range(&self, vertices: &[usize]) -> Option<usize> {
        vertices.iter().copied().find(|&v| v >= self.rank.len())
    }

    /// The ranks of vertices, given out now if need be; `None` if one is out of range or not finite.
    #[inline]
    fn of<const N: usize>(&mut self, vertices: [usize; N]) -> Option<[u32; N]> {
        let mut result = [0; N];
        for (to, given) in result.iter_mut().zip(vertices) {
            if *self.rank.get(given)? == NOT_FINITE {
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
                self.rank[v] = self.soup.vertices();
                self.soup.vertex.push(*to);
                self.soup.approx.push(self.approximations[v]);
            }
            *to = self.rank[v];
        }
        Some(result)
    }
}

/// Sorts the finite points from below. Returns for each point its place, and the lowest index of a point equal to it;
/// `None` if all differ.
fn sort<S: Scalar>(
    points: &[[S; 2]],
    approximations: &[[f64; 2]],
    is_finite: impl Fn(u32) -> bool,
) -> (Vec<u32>, Option<Vec<u32>>) {
    let count = u32::try_from(points.len()).expect("the size was checked");
    // A key is the beginning of y, with the index of the point in its low bits.
    let low_bits = u64::from(count.next_power_of_two()) * 2 - 1;
    let mut keys: Vec<u64> = (0..count)
        .filter(|&v| is_finite(v))
        .map(|v| ascending(approximations[v as usize][1]) & !low_bits | u64::from(v))
        .collect();
    keys.sort_unstable();

    let same_y = |a: &u64, b: &u64| a & !low_bits == b & !low_bits;
    let order = |&a: &u32, &b: &u32| {
        let by_approx = {
            let [p, q] = [a, b].map(|v| approximations[v as usize].map(ascending));
            p[1].cmp(&q[1]).then(p[0].cmp(&q[0]))
        };
        let exact = |axis: usize| {
            let [p, q] = [a, b].map(|v| &points[v as usize][axis]);
            p.compare(q)
        };
        by_approx.then_with(|| exact(1)).then_with(|| exact(0))
    };
    let mut places = vec![0; points.len()];
    let mut found: Option<Vec<u32>> = None;
    let mut group = Vec::new();
    let mut place = 0;
    for keys in keys.chunk_by(same_y) {
        group.clear();
        let index = |key: &u64| u32::try_from(key & low_bits).expect("an index");
        group.extend(keys.iter().map(index));
        if group.len() > 1 {
            group.sort_by(order);
            for equal in group.chunk_by(|a, b| order(a, b) == Ordering::Equal) {
                if equal.len() > 1 {
                    let all = found.get_or_insert_with(|| (0..count).collect());
                    // The sort is stable, so the lowest index comes first.
                    for &v in equal {
                        all[v as usize] = equal[0];
                    }
                }
            }
        }
        for &v in &group {
            places[v as usize] = place;
            place += 1;
        }
    }
    (places, found)
}

/// The numbers of the triangles, sorted by the lowest place of their corners; a corner out of range counts as the lowest.
fn from_below(triangles: &[[usize; 3]], places: &[u32]) -> Vec<u32> {
    let lowest = |corners: &[usize; 3]| {
        let places = corners.map(|v| places.get(v).copied().unwrap_or(0));
        places.into_iter().min().unwrap_or(0)
    };
    let numbers = || {
        (0..)
            .zip(triangles)
            .map(|(t, corners)| (lowest(corners), t))
    };
    grouped(numbers, places.len().max(1)).1
}

/// A number that is greater for a greater double, and equal for zeros of both signs.
fn ascending(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    let is_negative = bits >> 63 == 1;
    if is_negative { !bits } else { bits | 1 << 63 }
}
