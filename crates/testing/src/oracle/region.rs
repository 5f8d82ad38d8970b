//! Domains by their definition, and answers in them: is a set of triangles right for a level?
//!
//! Rays say what is inside. An answer is then compared with the canonical triangles inside and outside: it must be
//! disjoint from all of those outside, and have the area of those inside. Everything is compared with everything.

use std::cmp::Ordering::Greater;
use std::str::FromStr;

use sweep_cdt::verify::Level;

use super::naive::{Triangle, are_delaunay, is_on, is_within, separates, sides};
use super::numbers::{Number, Point, cross, orient, vector};
use crate::names::{name_of, value_of};

/// What triangles must fill, as `docs/command.md` has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// The convex hull of the points.
    Hull,
    /// What the outlines of polygons cover, each without its own holes.
    Polygons,
    /// What a path from outside enters by crossing an odd number of edges and sides of rings.
    EvenOdd,
    /// What edges and rings go round more often in one direction than in the other.
    NonZero,
}

impl Domain {
    /// All of them, and their names.
    pub const ALL: [(Domain, &str); 4] = [
        (Domain::Hull, "hull"),
        (Domain::Polygons, "polygons"),
        (Domain::EvenOdd, "even-odd"),
        (Domain::NonZero, "nonzero"),
    ];

    /// The name.
    pub fn name(self) -> &'static str {
        name_of(&Domain::ALL, &self)
    }

    /// Whether a triangle is inside, where `edges` are all edges and each polygon is a list of the sides of its rings,
    /// the outline first.
    pub fn holds<N: Number>(
        self,
        points: &[Point<N>],
        edges: &[[usize; 2]],
        polygons: &[Vec<Vec<[usize; 2]>>],
        triangle: [usize; 3],
    ) -> bool {
        let is_odd = |sides: &[[usize; 2]]| windings(points, sides, triangle).0 % 2 == 1;
        match self {
            Domain::Hull => true,
            Domain::EvenOdd => is_odd(edges),
            Domain::NonZero => windings(points, edges, triangle).1 != 0,
            Domain::Polygons => polygons.iter().any(|rings| {
                let mut rings = rings.iter().map(|ring| is_odd(ring));
                rings.next() == Some(true) && !rings.any(|is_in| is_in)
            }),
        }
    }
}

impl FromStr for Domain {
    type Err = String;

    fn from_str(name: &str) -> Result<Domain, String> {
        value_of(&Domain::ALL, name)
    }
}

/// How many edges a ray from the middle of a triangle to the right crosses, and how many more of them go up than down.
///
/// The middle is on no edge, where edges are sides of triangles.
pub fn windings<N: Number>(
    points: &[Point<N>],
    edges: &[[usize; 2]],
    triangle: [usize; 3],
) -> (u32, i32) {
    let sum = |terms: [&N; 3]| terms.into_iter().fold(N::zero(), |sum, x| sum + x.clone());
    // Three times as large, the middle has whole coordinates.
    let middle = [0, 1].map(|axis| sum(triangle.map(|v| &points[v][axis])));
    let (mut crossed, mut winding) = (0, 0);
    for edge in edges {
        let [a, b] = edge.map(|v| [0, 1].map(|axis| sum([&points[v][axis]; 3])));
        // An end on the height of the ray counts as above it.
        let (low, high, direction) = match (a[1] < middle[1], b[1] < middle[1]) {
            (true, false) => (&a, &b, 1),
            (false, true) => (&b, &a, -1),
            _ => continue,
        };
        if orient(low, high, &middle) == Greater {
            crossed += 1;
            winding += direction;
        }
    }
    (crossed, winding)
}

/// Whether a ring runs counter-clockwise, by its area; nothing, if it has none.
pub fn turns_left<N: Number>(ring: &[&Point<N>]) -> Option<bool> {
    let next = |i: usize| ring[(i + 1) % ring.len()];
    let area = (0..ring.len()).fold(N::zero(), |sum, i| sum + cross(ring[i], next(i)));
    (!area.is_zero()).then(|| area.is_positive())
}

/// The canonical triangles inside and outside of a domain, and the edges.
pub struct Region<'a, N> {
    /// The points.
    pub points: &'a [Point<N>],
    /// The edges, which cross nowhere.
    pub edges: &'a [[usize; 2]],
    /// The canonical triangles inside.
    pub inside: &'a [[usize; 3]],
    /// The canonical triangles outside.
    pub outside: &'a [[usize; 3]],
}

impl<N: Number> Region<'_, N> {
    /// Whether triangles, all of one orientation, keep what this level promises.
    pub fn is_filled_by(&self, triangles: &[[usize; 3]], level: Level) -> bool {
        let place = |t: &[usize; 3]| t.map(|v| &self.points[v]);
        let mut corners: Vec<Triangle<'_, N>> = triangles.iter().map(place).collect();
        if corners
            .first()
            .is_some_and(|[a, b, c]| orient(a, c, b) == Greater)
        {
            corners.iter_mut().for_each(|t| t.swap(1, 2));
        }
        let inside: Vec<Triangle<'_, N>> = self.inside.iter().map(place).collect();
        let drawn: Vec<_> = corners.iter().copied().flat_map(sides).collect();
        let mut vertices = inside.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        corners.iter().all(|[a, b, c]| orient(a, b, c) == Greater)
            && self.is_tiled(&corners, &inside)
            && !drawn
                .iter()
                .any(|&side| vertices.iter().any(|v| is_within(side, v)))
            && (level < Level::Constrained || self.has_edges(&drawn, &inside))
            && (level < Level::Delaunay || are_delaunay(&corners, &self.sides()))
            && (level < Level::Canonical || {
                let is_one = |t: &Triangle<'_, N>| {
                    let turned = |k: usize| [0, 1, 2].map(|i| t[(i + k) % 3]);
                    (0..3).any(|k| inside.contains(&turned(k)))
                };
                corners.iter().all(is_one)
            })
    }

    /// Whether triangles that turn left are disjoint, avoid what is outside, have the area of what is inside, and have
    /// all vertices there for corners.
    fn is_tiled(&self, corners: &[Triangle<'_, N>], inside: &[Triangle<'_, N>]) -> bool {
        let are_disjoint = |one: Triangle<'_, N>, other: Triangle<'_, N>| {
            are_apart(one, other) || separates(one, other) || separates(other, one)
        };
        let area = |list: &[Triangle<'_, N>]| {
            let area = |[a, b, c]: &Triangle<'_, N>| cross(&vector(a, b), &vector(a, c));
            list.iter().map(area).fold(N::zero(), |sum, x| sum + x)
        };
        let mut outside = self.outside.iter().map(|t| t.map(|v| &self.points[v]));
        area(corners) == area(inside)
            && (0..corners.len()).all(|i| (0..i).all(|j| are_disjoint(corners[i], corners[j])))
            && outside.all(|t| corners.iter().all(|&own| are_disjoint(own, t)))
            && inside
                .as_flattened()
                .iter()
                .all(|v| corners.as_flattened().contains(v))
    }

    fn sides(&self) -> Vec<[&Point<N>; 2]> {
        self.edges
            .iter()
            .map(|edge| edge.map(|v| &self.points[v]))
            .collect()
    }

    /// Whether the parts of edges that are sides of triangles inside are sides.
    fn has_edges(&self, drawn: &[[&Point<N>; 2]], inside: &[Triangle<'_, N>]) -> bool {
        let wanted: Vec<[&Point<N>; 2]> = inside.iter().copied().flat_map(sides).collect();
        let is_drawn = |[a, b]: [&Point<N>; 2]| drawn.contains(&[a, b]) || drawn.contains(&[b, a]);
        let edges = self.sides();
        wanted.into_iter().all(|side| {
            let is_piece_of = |&edge: &[&Point<N>; 2]| side.iter().all(|end| is_on(edge, end));
            is_drawn(side) || !edges.iter().any(is_piece_of)
        })
    }
}

/// Whether a vertical or a horizontal line has one on each side: quicker than [`separates`], and true of most pairs.
fn are_apart<N: Number>(one: Triangle<'_, N>, other: Triangle<'_, N>) -> bool {
    (0..2).any(|axis| {
        let is_before = |one: Triangle<'_, N>, other: Triangle<'_, N>| {
            one.iter().all(|v| other.iter().all(|w| v[axis] <= w[axis]))
        };
        is_before(one, other) || is_before(other, one)
    })
}
