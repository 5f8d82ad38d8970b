//! Initialization (section 3.3): duplicates merged, vertices in sweep order, edges at their upper
//! endpoints.
//!
//! Sweep order is by y, then x. Every distinct point gets its *rank* in that order and everything
//! after works on ranks: neighbours in the sweep are neighbours in memory. Equal points merge into the
//! one with the lowest input index. An edge is listed at its endpoint of higher rank, where the sweep
//! line has passed all of it.
//!
//! Why it is right: a coarse key, monotone in y, is sorted by counting; then every run of equal keys
//! is sorted exactly. Since the key never decreases where y grows, that is the exact order.
//!
//! Cost: O(n) where the points spread over y, O(n log n) at worst (all in one run); 40 bytes a point
//! for a moment.
//!
//! Differs from the paper: the upper end of a horizontal edge is the one with larger x, since it is
//! swept last (the paper says smaller, against its own sort); the artificial points have no
//! coordinates (see [`crate::predicates`]).

use std::cmp::Ordering;

use crate::mesh::{Link, VertexId};
use crate::predicates::Scale;
use crate::{Error, Scalar};

/// The distinct points in sweep order.
#[derive(Debug)]
pub(crate) struct Vertices {
    /// By rank: doubles near the coordinates, scaled by one power of two.
    pub(crate) near: Vec<[f64; 2]>,
    /// By rank: the input index that stands for the vertex.
    pub(crate) input: Vec<u32>,
    /// `(point, representative)` of each duplicate, by point.
    pub(crate) duplicates: Vec<(u32, u32)>,
    pub(crate) scale: Scale,
}

/// A point on its way to its rank.
#[derive(Clone, Copy)]
struct Site {
    near: [f64; 2],
    input: u32,
}

/// The input edges at their upper endpoints.
#[derive(Debug, Default)]
pub(crate) struct Edges {
    /// The edges whose upper end is `v` are `list[first[v]..first[v + 1]]`; empty without edges.
    first: Vec<u32>,
    /// The lower end and the input index.
    list: Vec<(VertexId, u32)>,
}

impl Edges {
    /// The edges with upper end `v`, as lower ends and input indices.
    pub(crate) fn at(&self, v: VertexId) -> &[(VertexId, u32)] {
        match self.first.get(v as usize..v as usize + 2) {
            Some(&[from, to]) => &self.list[from as usize..to as usize],
            _ => &[],
        }
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.first.capacity() * size_of::<u32>() + self.list.capacity() * size_of::<(u32, u32)>()
    }

    /// All edges: upper end, lower end, input index.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (VertexId, VertexId, u32)> + '_ {
        let uppers = 0..self.first.len().saturating_sub(1) as VertexId;
        uppers.flat_map(|v| {
            self.at(v)
                .iter()
                .map(move |&(lower, edge)| (v, lower, edge))
        })
    }
}

/// Sorts and merges the points.
pub(crate) fn vertices<S: Scalar>(points: &[[S; 2]]) -> Result<Vertices, Error> {
    check_count(points.len())?;
    if let Some(vertex) = points
        .iter()
        .position(|p| !(p[0].is_finite() && p[1].is_finite()))
    {
        return Err(Error::NonFiniteCoordinate { vertex });
    }
    let scale = Scale::of(points);
    let sites = sort(points, &scale);

    let mut near = Vec::with_capacity(sites.len() + 2);
    let mut input = Vec::with_capacity(sites.len());
    let mut duplicates = Vec::new();
    let mut before: Option<Site> = None;
    for site in sites {
        match before {
            Some(first) if compare_sites(points, &scale, &first, &site).is_eq() => {
                duplicates.push((site.input, first.input));
            }
            _ => {
                near.push(site.near);
                input.push(site.input);
                before = Some(site);
            }
        }
    }
    duplicates.sort_unstable();
    Ok(Vertices {
        near,
        input,
        duplicates,
        scale,
    })
}

/// Lists the edges at their upper ends, by rank, and their ends by input edge.
#[expect(clippy::type_complexity, reason = "one use")]
pub(crate) fn edges(
    vertices: &Vertices,
    points: usize,
    edges: &[[usize; 2]],
) -> Result<(Edges, Vec<[u32; 2]>), Error> {
    check_count(edges.len())?;
    if edges.is_empty() {
        return Ok((Edges::default(), Vec::new()));
    }
    let mut ranks = vec![0; points];
    for (rank, &v) in (0..).zip(&vertices.input) {
        ranks[v as usize] = rank;
    }
    for &(duplicate, representative) in &vertices.duplicates {
        ranks[duplicate as usize] = ranks[representative as usize];
    }

    let mut first = vec![0_u32; vertices.input.len() + 1];
    let mut ends: Vec<[u32; 2]> = Vec::with_capacity(edges.len());
    for (edge, &[a, b]) in edges.iter().enumerate() {
        let rank = |vertex: usize| match ranks.get(vertex) {
            Some(&rank) => Ok(rank),
            None => Err(Error::EdgeOutOfRange { edge, vertex }),
        };
        let (a, b): (u32, u32) = (rank(a)?, rank(b)?);
        ends.push([a.max(b), a.min(b)]);
        first[a.max(b) as usize] += 1;
    }
    // Counts become the ends of the ranges, and each edge put in moves its range's end to its start.
    let mut sum = 0;
    for count in &mut first {
        sum += *count;
        *count = sum;
    }
    let mut list = vec![(0, 0); edges.len()];
    for (edge, &[upper, lower]) in ends.iter().enumerate().rev() {
        first[upper as usize] -= 1;
        list[first[upper as usize] as usize] = (lower, edge as u32);
    }
    for end in ends.as_flattened_mut() {
        *end = vertices.input[*end as usize];
    }
    Ok((Edges { first, list }, ends))
}

fn check_count(given: usize) -> Result<(), Error> {
    // Twice as many triangles as points, and some for the artificial ones.
    let limit = Link::LIMIT / 2 - 4;
    if given > limit {
        Err(Error::TooManyPoints { given, limit })
    } else {
        Ok(())
    }
}

/// Exact sweep order of two sites, equal ones by input index.
fn compare_sites<S: Scalar>(points: &[[S; 2]], scale: &Scale, a: &Site, b: &Site) -> Ordering {
    let axis = |i: usize| match a.near[i].partial_cmp(&b.near[i]) {
        Some(Ordering::Equal) | None if !scale.is_exact() => {
            points[a.input as usize][i].compare(&points[b.input as usize][i])
        }
        order => order.unwrap_or(Ordering::Equal),
    };
    axis(1).then_with(|| axis(0))
}

/// All points in exact sweep order; of equal ones the lowest index first.
fn sort<S: Scalar>(points: &[[S; 2]], scale: &Scale) -> Vec<Site> {
    let site = |input: u32| {
        let point = &points[input as usize];
        Site {
            near: [scale.near(&point[0]), scale.near(&point[1])],
            input,
        }
    };
    let keyed = counting_sort(points, scale);
    let mut sites: Vec<Site> = keyed.iter().map(|&packed| site(packed as u32)).collect();
    let order =
        |a: &Site, b: &Site| compare_sites(points, scale, a, b).then_with(|| a.input.cmp(&b.input));
    let mut from = 0;
    for run in keyed.chunk_by(|a, b| a >> 32 == b >> 32) {
        if run.len() > 1 {
            sites[from..from + run.len()].sort_unstable_by(order);
        }
        from += run.len();
    }
    sites
}

/// The points by a coarse key that never decreases with y: `key << 32 | index`.
///
/// About two keys a point, so that runs of equal keys are short where y is spread; two counting
/// passes of half the key's bits each.
fn counting_sort<S: Scalar>(points: &[[S; 2]], scale: &Scale) -> Vec<u64> {
    let half = (usize::BITS - points.len().leading_zeros()).div_ceil(2) + 1;
    let mask = (1_u64 << half) - 1;
    let (low, high) = points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
            let y = scale.near(&p[1]);
            (low.min(y), high.max(y))
        });
    let keys = (1_u64 << (2 * half)) as f64;
    let factor = keys / (high - low);
    // Differences, products and the cast never decrease where y grows; NaN, for no extent, casts to 0.
    let key = |p: &[S; 2]| (((scale.near(&p[1]) - low) * factor) as u64).min(keys as u64 - 1);
    let mut packed: Vec<u64> = (0..).zip(points).map(|(i, p)| key(p) << 32 | i).collect();
    let mut sorted = vec![0; packed.len()];
    for shift in [32, 32 + half] {
        let mut place = vec![0_u32; 1 << half];
        for item in &packed {
            place[(item >> shift & mask) as usize] += 1;
        }
        let mut sum = 0;
        for count in &mut place {
            sum += *count;
            *count = sum - *count;
        }
        for &item in &packed {
            let at = &mut place[(item >> shift & mask) as usize];
            sorted[*at as usize] = item;
            *at += 1;
        }
        std::mem::swap(&mut packed, &mut sorted);
    }
    packed
}
