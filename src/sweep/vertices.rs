//! Initialization (section 3.3): duplicates merged, vertices in sweep order, edges at their upper
//! endpoints.
//!
//! Sweep order is by y, then x. Every distinct point gets its *rank* in that order and everything
//! after works on ranks: neighbours in the sweep are neighbours in memory. Equal points merge into the
//! one with the lowest input index. An edge is listed at its endpoint of higher rank, where the sweep
//! line has passed all of it.
//!
//! Why it is right: the order is exact ([`crate::order`]), so equal points are neighbours in it, and
//! the lowest index comes first.
//!
//! Cost: that of the order, and O(n) for n points and edges: both are counted into place.
//!
//! Differs from the paper: the upper end of a horizontal edge is the one with larger x, since it is
//! swept last (the paper says smaller, against its own sort); the artificial points have no
//! coordinates (see [`crate::predicates`]).

use crate::mesh::{Link, VertexId, index};
use crate::order::{self, Order};
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
        let uppers = 0..index(self.first.len().saturating_sub(1));
        uppers.flat_map(|v| {
            self.at(v)
                .iter()
                .map(move |&(lower, edge)| (v, lower, edge))
        })
    }
}

/// Sorts and merges the points.
pub(crate) fn vertices<S: Scalar>(points: &[[S; 2]]) -> Result<Vertices, Error> {
    check_count(points.len(), |given, limit| Error::TooManyPoints {
        given,
        limit,
    })?;
    if let Some(vertex) = points
        .iter()
        .position(|p| !(p[0].is_finite() && p[1].is_finite()))
    {
        return Err(Error::NonFiniteCoordinate { vertex });
    }
    let approximation = |p: &[S; 2]| [p[0].approx(), p[1].approx()];
    // Where they are the values, they are quickly had again.
    let stored: Vec<[f64; 2]> = if S::APPROX_IS_EXACT {
        Vec::new()
    } else {
        points.iter().map(approximation).collect()
    };
    let near = |input: u32| match stored.get(input as usize) {
        Some(near) => *near,
        None => approximation(&points[input as usize]),
    };
    let all = (0..index(points.len())).flat_map(near);
    let scale = Scale::of(all, S::APPROX_IS_EXACT);
    let near = |input| scale.near(near(input));

    let Order {
        mut near,
        mut input,
    } = order::sort(points, near, scale);

    let mut duplicates = Vec::new();
    let mut kept = 0;
    for i in 0..input.len() {
        let site = (near[i], input[i]);
        if kept > 0 {
            let before = (near[kept - 1], input[kept - 1]);
            if order::compare(points, scale, &before, &site).is_eq() {
                duplicates.push((site.1, before.1));
                continue;
            }
        }
        (near[kept], input[kept]) = site;
        kept += 1;
    }
    near.truncate(kept);
    input.truncate(kept);
    duplicates.sort_unstable();
    Ok(Vertices {
        near,
        input,
        duplicates,
        scale,
    })
}

/// Lists the edges at their upper ends, by rank, and their ends by input edge.
pub(crate) fn edges(
    vertices: &Vertices,
    points: usize,
    edges: &[[usize; 2]],
) -> Result<(Edges, Vec<[u32; 2]>), Error> {
    check_count(edges.len(), |given, limit| Error::TooManyEdges {
        given,
        limit,
    })?;
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
        list[first[upper as usize] as usize] = (lower, index(edge));
    }
    for end in ends.as_flattened_mut() {
        *end = vertices.input[*end as usize];
    }
    Ok((Edges { first, list }, ends))
}

fn check_count(given: usize, error: fn(usize, usize) -> Error) -> Result<(), Error> {
    // Twice as many triangles as points, and some for the artificial ones.
    let limit = Link::LIMIT / 2 - 4;
    if given > limit {
        Err(error(given, limit))
    } else {
        Ok(())
    }
}
