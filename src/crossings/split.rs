//! Edges split where they cross, so that the crossing points become vertices.
//!
//! In rounds: all crossings of the pieces are found; each crossing point is rounded to the nearest number of the scalar
//! (a fraction is its own) and is a vertex from now on. Each piece goes through all vertices of edges that it passes
//! ([`cells`](super::cells)), the new ones among them, and through points that lie on it exactly. A piece that is bent so
//! may cross others, which the next round finds. When none cross, the pieces have a triangulation.
//!
//! ```text
//!      a     d                 a     d
//!       \   /                   \   /            The edges a-b and c-d go through v, a double near the place
//!        \ /                     \ /             where they cross. It may be an end of one of them, or any
//!        /.\      becomes         v              other vertex.
//!       /   \                    / \
//!      c     b                  c   b
//! ```
//!
//! Why it ends: rounding is monotone and keeps the ends, so what a piece passes lies in its box. Hence a chain never
//! turns back along x or y, and stays in the box of its edge. Two pieces that cross have no end in common, so each
//! round gives some chain a new vertex, and there are only so many numbers in a box. Evenly spaced numbers need one
//! round: this is snap rounding (Hobby 1999; Guibas and Marimont 1998), after which nothing crosses. Doubles are closer
//! to each other near zero, which may take more rounds. More than [`ROUNDS_OF_SPLITTING`] are an error.
//!
//! A round moves each point of a chain by at most half a unit in x and y, so [`displacement()`] is at most half the number
//! of rounds. Cost: in each round, to find the crossings and the vertices that pieces pass. Differs from snap rounding:
//! input points stay where they are, and edges that cross nothing are bent only if others cross.

use alloc::collections::BTreeSet;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::Range;

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::cells::passed;
use super::effort::Effort;
use super::enclosure::Enclosure;
use super::error::SplitError;
use super::exact::{Exact, distance, distance_at_most, spacing};
use super::find::find;
use super::vertices::Vertices;
use crate::scalar::orient2d;
use crate::triangulation::Triangulation;
use crate::tuning::ROUNDS_OF_SPLITTING;

/// An input whose edges are split where they cross: triangulate [`points`](Split::points) with [`edges`](Split::edges).
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Split<S> {
    /// The points given, and then those where edges cross, each once.
    pub points: Vec<[S; 2]>,
    /// The pieces of the edges, as positions in `points`; the pieces of one edge follow each other from its first end
    /// to its second. Of equal points the first one stands for all.
    pub edges: Vec<[usize; 2]>,
    /// For each piece its edge. Each edge has at least one piece.
    pub pieces_of: Vec<usize>,
    /// How many rounds of splitting and rounding it took: none if no edges cross, one if nothing is rounded.
    pub rounds: usize,
    /// How many units in the last place an edge moved at most: zero if nothing is rounded, at most half of `rounds`. A
    /// unit is the distance of the numbers around the largest coordinate of the edge, along x and y each.
    pub displacement: f64,
}

impl<S> Split<S> {
    /// Where the pieces of edge `e` stand in `edges`.
    pub fn pieces(&self, e: usize) -> Range<usize> {
        let first = |e| self.pieces_of.partition_point(|&of| of < e);
        first(e)..first(e + 1)
    }

    /// The vertices along edge `e` in the triangulation of the pieces, from its first end to its second, with those
    /// where it crosses others and those that it passes through. A single vertex, if the ends are equal.
    ///
    /// # Panics
    /// If `result` has fewer edges than there are pieces.
    pub fn chain(&self, e: usize, result: &Triangulation) -> Vec<usize> {
        let pieces = self.pieces(e);
        let mut chain: Vec<usize> = pieces.flat_map(|piece| result.edge_chain(piece)).collect();
        // Each piece begins where the last one ends.
        chain.dedup();
        chain
    }
}

/// Splits edges where they cross at points that are none of `points`; these become vertices.
///
/// Fractions are split exactly. With doubles each crossing point is rounded to the nearest double, each edge goes
/// through all vertices of edges to which a point of it is rounded, and on through all points that it passed exactly.
/// Edges that then cross are split again, until none do. So [`triangulate`](crate::triangulate) does not refuse the result with
/// [`Error::CrossingEdges`](crate::Error::CrossingEdges).
///
/// # Errors
/// [`SplitError`]: as [`crossings`](super::crossings()), or that edges still cross after 100 rounds.
///
/// ```
/// use sweep_cdt::{crossings::split, triangulate};
///
/// let points = [[0.0, 0.0], [3.0, 1.0], [0.0, 1.0], [3.0, 0.0]];
/// let edges = [[0, 1], [2, 3]];
/// let split = split(&points, &edges)?;
/// assert_eq!(split.points[4..], [[1.5, 0.5]]);
/// assert_eq!(split.edges, [[0, 4], [4, 1], [2, 4], [4, 3]]);
/// assert_eq!((split.rounds, split.displacement), (1, 0.0));
///
/// let result = triangulate(&split.points, &split.edges)?;
/// assert_eq!(split.chain(1, &result), [2, 4, 3]);
/// assert!(result.with_points(&split.points).verify(&split.edges).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn split<S: Exact>(points: &[[S; 2]], edges: &[[usize; 2]]) -> Result<Split<S>, SplitError> {
    split_with(points, edges, &mut Effort::default())
}

/// As [`split`], with bounds of its own and a count of its work: for tests.
#[doc(hidden)]
pub fn split_with<S: Exact>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    effort: &mut Effort,
) -> Result<Split<S>, SplitError> {
    let mut vertices = Vertices::new(points)?;
    vertices.check(edges)?;
    let mut points = points.to_vec();
    let number = |vertices: &mut Vertices<S>, points: &mut Vec<[S; 2]>, v: usize| {
        let point = points[v].clone();
        vertices.number(point, points)
    };
    let mut chains: Vec<Vec<usize>> = Vec::with_capacity(edges.len());
    for ends in edges {
        chains.push(ends.map(|v| number(&mut vertices, &mut points, v)).to_vec());
    }
    for rounds in 0..=ROUNDS_OF_SPLITTING {
        let pieces = pieces(&chains);
        let found = find(&points, &vertices, &pieces, effort)?;
        if found.is_empty() {
            let displacement = displacement(&points, &chains);
            return Ok(finished(points, &chains, rounds, displacement));
        }
        let mut on_edges = chains.concat();
        for (_, place) in found {
            on_edges.push(vertices.number(place, &mut points));
        }
        on_edges.sort_unstable();
        on_edges.dedup();
        if rounds == 0 {
            let mut others = vertices.all();
            others.retain(|v| on_edges.binary_search(v).is_err());
            on_edges.extend(inside(&points, &pieces, &others, effort));
        }
        // Each piece with a vertex that it passes.
        let mut cuts = passed(&points, &pieces, &on_edges, effort);
        cuts.sort_unstable_by(|&(piece, v), &(other, w)| {
            let along = || along(&points, pieces[piece], v, w);
            piece.cmp(&other).then_with(along)
        });
        for chain in &mut chains {
            *chain = cut(chain, &pieces, &cuts);
        }
    }
    Err(SplitError::TooManyRounds {
        limit: ROUNDS_OF_SPLITTING,
    })
}

/// Which of these vertices lie inside pieces, exactly.
fn inside<S: Exact>(
    points: &[[S; 2]],
    pieces: &[[usize; 2]],
    vertices: &[usize],
    effort: &mut Effort,
) -> BTreeSet<usize> {
    let passed = passed(points, pieces, vertices, effort).into_iter();
    let inside = passed.filter(|&(piece, v)| {
        let [a, b] = pieces[piece].map(|end| &points[end]);
        orient2d(a, b, &points[v]).is_eq()
    });
    inside.map(|(_, v)| v).collect()
}

/// All pairs of neighbours in the chains, lower one first, sorted, each once.
fn pieces(chains: &[Vec<usize>]) -> Vec<[usize; 2]> {
    let pairs = chains.iter().flat_map(|chain| chain.windows(2));
    let mut pieces: Vec<[usize; 2]> = pairs.map(|pair| sorted([pair[0], pair[1]])).collect();
    pieces.sort_unstable();
    pieces.dedup();
    pieces
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// The order of two vertices along a piece. Neither x nor y turns back along it, so comparing both is enough. Of two
/// approximations that differ the order is that of the values.
fn along<S: Exact>(points: &[[S; 2]], [a, b]: [usize; 2], v: usize, w: usize) -> Ordering {
    let compare = |v: usize, w: usize, i: usize| {
        let [x, y] = [v, w].map(|v| &points[v][i]);
        let near = x.approx().partial_cmp(&y.approx());
        near.expect("approximations are numbers")
            .then_with(|| x.compare(y))
    };
    let forward = |i: usize| match compare(a, b, i) {
        Ordering::Less => compare(v, w, i),
        _ => compare(w, v, i),
    };
    forward(0).then_with(|| forward(1))
}

/// A chain with the new vertices of its pieces. The cuts are sorted by piece, and along each piece.
fn cut(chain: &[usize], pieces: &[[usize; 2]], cuts: &[(usize, usize)]) -> Vec<usize> {
    let mut longer = vec![chain[0]];
    for pair in chain.windows(2) {
        let piece = pieces.binary_search(&sorted([pair[0], pair[1]]));
        let piece = piece.expect("all neighbours are listed");
        let first = |piece| cuts.partition_point(|&(of, _)| of < piece);
        let vertices = cuts[first(piece)..first(piece + 1)].iter().map(|&(_, v)| v);
        if pair[0] < pair[1] {
            longer.extend(vertices);
        } else {
            longer.extend(vertices.rev());
        }
        longer.push(pair[1]);
    }
    longer
}

/// The greatest distance of a vertex from the edge whose chain it is on, in units of that edge.
///
/// All vertices of a chain lie in the box of the edge, so a unit, along x or y, is the distance of the numbers around the
/// larger one (in size) of the ends' coordinates. A vertex is `d` units away if `d` is the least number such that some
/// point of the edge differs from the vertex by at most `d` units in each coordinate. Only a distance that may be the
/// greatest is computed in fractions.
fn displacement<S: Exact>(points: &[[S; 2]], chains: &[Vec<usize>]) -> f64 {
    let mut greatest = 0.0_f64;
    for chain in chains {
        let [first, inner @ .., last] = &chain[..] else {
            continue;
        };
        if inner.is_empty() {
            continue;
        }
        let ends = [first, last].map(|&v| &points[v]);
        let unit = |i: usize| {
            let [one, other] = ends.map(|end| spacing(&end[i]));
            one.max(other)
        };
        let units: [BigRational; 2] = [unit(0), unit(1)];
        if units.iter().all(Zero::is_zero) {
            continue;
        }
        let doubles = units.each_ref().map(Enclosure::of);
        for &v in inner {
            let at_most = match &doubles {
                [Some(x), Some(y)] => distance_at_most(&points[v], ends, &[*x, *y]),
                _ => None,
            };
            if at_most.is_none_or(|at_most| at_most > greatest) {
                let moved = distance(&points[v], ends, &units);
                greatest = greatest.max(moved.to_f64().unwrap_or(f64::INFINITY));
            }
        }
    }
    greatest
}

fn finished<S>(
    points: Vec<[S; 2]>,
    chains: &[Vec<usize>],
    rounds: usize,
    displacement: f64,
) -> Split<S> {
    let (mut edges, mut pieces_of) = (Vec::new(), Vec::new());
    for (edge, chain) in chains.iter().enumerate() {
        edges.extend(chain.windows(2).map(|pair| [pair[0], pair[1]]));
        pieces_of.resize(edges.len(), edge);
    }
    Split {
        points,
        edges,
        pieces_of,
        rounds,
        displacement,
    }
}
