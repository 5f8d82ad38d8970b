//! Polygons with holes among other lines: the union of what each covers.
//!
//! A [`Ring`] is the outline of a polygon or of a hole in it, and each edge is part of one ring or of none. A polygon
//! covers what its outline goes round and none of its holes does, by crossing parity, so that it does not matter which
//! way a ring runs, whether a hole sticks out, or what other polygons do. Edges of no ring bound nothing.
//!
//! ```text
//!      +-----------------+
//!      | A      +--------|-----+      A with the hole h, which sticks out, and B over both:
//!      |   +----|---+    |  B  |      all but the part of h that B leaves is covered.
//!      |   |    | h |    |     |
//!      |   |    +--------|-----+
//!      +---|--------|----+
//!          +--------+
//! ```
//!
//! Why it is right: the edges cut the hull into faces. From one face to the next the parity of a ring changes if an odd
//! number of its edges run between them, and because rings are closed, all ways to a face agree. So one tree of steps,
//! with its root outside, reaches each face once. A walk around the tree takes each step forth and back, and changes the
//! parities as it goes: at each face they are known, with the polygons that cover it.
//!
//! Cost: O(n + m log m), where m is the sum of the lengths of all chains, and O(log p) for each ring in a step, of p
//! polygons. Equal edges make one step of many rings, and the tree takes the steps of the fewest rings first, so that
//! faces behind a stack of equal edges are entered through it once.

use alloc::collections::{BTreeSet, BinaryHeap};
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;
use core::ops::Range;

use super::error::InteriorError;
use super::holes::faces;
use super::labels::Interior;
use crate::ids::narrow;
use crate::triangulation::Triangulation;

/// A closed chain of edges around a polygon, or around a hole in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ring {
    /// The number of the polygon.
    pub polygon: usize,
    /// Whether the ring takes away what it goes round.
    pub is_hole: bool,
}

impl Triangulation {
    /// The interior that polygons cover together: outlines without their holes. `ring_of` has for each edge the ring that
    /// it is part of, as a position in `rings`, or `None` for a line that bounds nothing. A polygon may have several
    /// outlines and any number of holes; a ring may run either way, and touch, cross and repeat others.
    /// [`Interior::depth`] is the number of polygons that cover a triangle, and [`Interior::region`] the lowest of them.
    ///
    /// # Errors
    /// [`InteriorError::OpenAtVertex`], if a ring is not closed; [`InteriorError::UnknownRing`], if `ring_of` is not as long
    /// as the list of edges that were triangulated, or names a ring that there is not.
    ///
    /// ```
    /// use sweep_cdt::interior::Ring;
    ///
    /// // A square with a square hole that sticks out of it on the right.
    /// let points = [[0, 0], [4, 0], [4, 1], [6, 1], [6, 3], [4, 3], [4, 4], [0, 4], [2, 1], [2, 3]];
    /// let outline = [[0, 1], [1, 6], [6, 7], [7, 0]];
    /// let hole = [[8, 3], [3, 4], [4, 9], [9, 8]];
    /// let rings = [Ring { polygon: 0, is_hole: false }, Ring { polygon: 0, is_hole: true }];
    /// let ring_of = [[Some(0); 4], [Some(1); 4]].concat();
    /// let result = sweep_cdt::triangulate(&points, &[outline, hole].concat())?;
    /// let interior = result.interior_of_polygons(&rings, &ring_of)?;
    /// let area = |[a, b, c]: [usize; 3]| {
    ///     let [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
    ///     (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    /// };
    /// assert_eq!(interior.triangles().map(area).sum::<i32>(), 2 * (4 * 4 - 2 * 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn interior_of_polygons(
        &self,
        rings: &[Ring],
        ring_of: &[Option<usize>],
    ) -> Result<Interior<'_>, InteriorError> {
        let is_known = |ring: &Option<usize>| ring.is_none_or(|ring| ring < rings.len());
        let count = self.chains.len();
        if let Some(edge) = ring_of.iter().position(|ring| !is_known(ring)) {
            return Err(InteriorError::UnknownRing { edge });
        }
        if ring_of.len() != count {
            let edge = ring_of.len().min(count);
            return Err(InteriorError::UnknownRing { edge });
        }
        let walls = Walls::new(self, ring_of)?;
        let (faces, count) = faces(self);
        let tree = Tree::new(self, &walls, &faces, count);
        let mut cover = Cover::new(rings);
        let (mut depths, mut lowest) = (vec![0; count], vec![None; count]);
        tree.tour(|face, step| {
            cover.cross(walls.rings(step));
            if let Some(face) = face {
                depths[face] = i32::try_from(cover.polygons.len()).unwrap_or(i32::MAX);
                lowest[face] = cover.lowest();
            }
        });
        let of_face = faces.iter().map(|&face| depths[face]).collect();
        let regions = faces.iter().map(|&face| lowest[face]).collect();
        Ok(Interior::new(self, of_face, |depth| depth > 0).with_polygons(regions))
    }
}

/// The rings whose edges run along each side.
struct Walls {
    /// Rings of edges with the same ends, one such group after the other.
    rings: Vec<usize>,
    /// `(side, group)`, lower vertex first, sorted; a group is a range of `rings`.
    sides: Vec<([u32; 2], Range<usize>)>,
}

impl Walls {
    fn new(result: &Triangulation, ring_of: &[Option<usize>]) -> Result<Walls, InteriorError> {
        let edges = ring_of.iter().enumerate();
        let ends = |edge| {
            let [a, b] = result.chains.ends(edge);
            [a.min(b), a.max(b)]
        };
        // The ends of each edge of a ring, the ring, and the edge.
        let mut edges: Vec<([u32; 2], usize, usize)> = edges
            .filter_map(|(edge, ring)| Some((ends(edge), (*ring)?, edge)))
            .filter(|([a, b], ..)| a != b)
            .collect();
        edges.sort_unstable();
        let mut ends: Vec<(u32, usize)> = edges
            .iter()
            .flat_map(|&(ends, ring, _)| ends.map(|end| (end, ring)))
            .collect();
        ends.sort_unstable();
        let mut open = ends
            .chunk_by(|a, b| a == b)
            .filter(|same| same.len() % 2 != 0);
        if let Some(open) = open.next() {
            let vertex = open[0].0 as usize;
            return Err(InteriorError::OpenAtVertex { vertex });
        }
        let (mut rings, mut sides) = (Vec::with_capacity(edges.len()), Vec::new());
        for equal in edges.chunk_by(|a, b| a.0 == b.0) {
            let group = rings.len()..rings.len() + equal.len();
            rings.extend(equal.iter().map(|&(_, ring, _)| ring));
            let chain = result.chains.chain(equal[0].2);
            let pairs = chain.clone().zip(chain.skip(1));
            sides.extend(pairs.map(|(a, b)| ([a.min(b), a.max(b)], group.clone())));
        }
        sides.sort_unstable_by(|(a, group), (b, other)| (a, group.start).cmp(&(b, other.start)));
        Ok(Walls { rings, sides })
    }

    /// The groups along a side, as a range of `sides`.
    fn at(&self, [a, b]: [usize; 2]) -> Range<usize> {
        let side = [narrow(a.min(b)), narrow(a.max(b))];
        let first = self.sides.partition_point(|(other, _)| *other < side);
        let others = self.sides[first..].iter();
        first..first + others.take_while(|(other, _)| *other == side).count()
    }

    /// How many edges run along a side.
    fn weight(&self, side: &Range<usize>) -> usize {
        self.sides[side.clone()]
            .iter()
            .map(|(_, group)| group.len())
            .sum()
    }

    /// The ring of each edge along a side.
    fn rings(&self, side: Range<usize>) -> impl Iterator<Item = usize> + '_ {
        let groups = self.sides[side].iter();
        groups.flat_map(|(_, group)| self.rings[group.clone()].iter().copied())
    }
}

/// The steps from outside to all faces.
struct Tree {
    /// `(from, to, wall)`, sorted: the steps from each face; from outside they come last.
    steps: Vec<(usize, usize, Range<usize>)>,
    /// The number that stands for outside.
    outside: usize,
}

impl Tree {
    /// Of the steps from the faces that are reached, one through the fewest edges comes next.
    fn new(result: &Triangulation, walls: &Walls, faces: &[usize], count: usize) -> Tree {
        let mut borders: Vec<(usize, usize, Range<usize>)> = Vec::new();
        for (t, &face) in faces.iter().enumerate() {
            for side in 0..3 {
                let wall = |is_wall| match is_wall {
                    true => walls.at(result.side(t, side)),
                    false => 0..0,
                };
                let is_wall = result.is_constrained(t, side);
                match result.neighbor(t, side) {
                    None => borders.push((count, face, wall(is_wall))),
                    Some(across) if is_wall => borders.push((face, faces[across], wall(true))),
                    Some(_) => {}
                }
            }
        }
        borders.sort_unstable_by_key(|(from, ..)| *from);
        let starts: Vec<usize> = (0..=count + 1)
            .map(|face| borders.partition_point(|(from, ..)| *from < face))
            .collect();
        let of_face = |face: usize| starts[face]..starts[face + 1];
        let mut waiting = BinaryHeap::new();
        let weighed = |at: usize| Reverse((walls.weight(&borders[at].2), at));
        waiting.extend(of_face(count).map(weighed));
        let (mut is_reached, mut steps) = (vec![false; count], Vec::new());
        while let Some(Reverse((_, at))) = waiting.pop() {
            let face = borders[at].1;
            if !core::mem::replace(&mut is_reached[face], true) {
                steps.push(borders[at].clone());
                waiting.extend(of_face(face).map(weighed));
            }
        }
        steps.sort_unstable_by_key(|&(from, to, _)| (from, to));
        Tree {
            steps,
            outside: count,
        }
    }

    /// Walks around the tree: `on_step` gets the face and the wall of each step forth, and the wall of each step back.
    fn tour(&self, mut on_step: impl FnMut(Option<usize>, Range<usize>)) {
        let first = |face: usize| self.steps.partition_point(|(from, ..)| *from < face);
        // The faces around the present one, each with its next step, and the step that led there.
        let mut way: Vec<(usize, usize, Range<usize>)> =
            vec![(self.outside, first(self.outside), 0..0)];
        while let Some((face, next, wall)) = way.last_mut() {
            match self.steps.get(*next) {
                Some((from, to, wall)) if *from == *face => {
                    *next += 1;
                    on_step(Some(*to), wall.clone());
                    way.push((*to, first(*to), wall.clone()));
                }
                _ => {
                    on_step(None, wall.clone());
                    way.pop();
                }
            }
        }
    }
}

/// What covers a place.
struct Cover<'a> {
    rings: &'a [Ring],
    /// Whether each ring goes round it.
    is_around: Vec<bool>,
    /// The numbers of all polygons, sorted.
    numbers: Vec<usize>,
    /// How many outlines and how many holes of each of them go round it.
    around: Vec<[usize; 2]>,
    /// The polygons that cover it, as positions in `numbers`.
    polygons: BTreeSet<usize>,
}

impl<'a> Cover<'a> {
    /// What covers the outside: nothing.
    fn new(rings: &'a [Ring]) -> Cover<'a> {
        let mut numbers: Vec<usize> = rings.iter().map(|ring| ring.polygon).collect();
        numbers.sort_unstable();
        numbers.dedup();
        Cover {
            rings,
            is_around: vec![false; rings.len()],
            around: vec![[0; 2]; numbers.len()],
            numbers,
            polygons: BTreeSet::new(),
        }
    }

    /// The lowest polygon that covers it.
    fn lowest(&self) -> Option<usize> {
        self.polygons.first().map(|&polygon| self.numbers[polygon])
    }

    /// Crosses an edge of each of these rings.
    fn cross(&mut self, rings: impl Iterator<Item = usize>) {
        for ring in rings {
            let Ring { polygon, is_hole } = self.rings[ring];
            let polygon = self.numbers.partition_point(|&number| number < polygon);
            let around = &mut self.around[polygon];
            let number = &mut around[usize::from(is_hole)];
            self.is_around[ring] = !self.is_around[ring];
            *number = if self.is_around[ring] {
                *number + 1
            } else {
                *number - 1
            };
            if around[0] > 0 && around[1] == 0 {
                self.polygons.insert(polygon);
            } else {
                self.polygons.remove(&polygon);
            }
        }
    }
}
