//! The triangles of a certificate with their neighbours, and what the hints are made from: the chain of points along each
//! edge, the sides that are pieces of edges, an order from below, and what shows that triangles are inside.
//!
//! Sides have no table: half-edges are sorted by counting at the earlier end, and for each end by the later one.

use std::collections::HashMap;
use std::ops::Range;

use sweep_cdt::interior::Ring;
use sweep_cdt::scalar::orient2d;

use crate::Coordinate;
use crate::order::{order, sorted};

/// No half-edge.
const NONE: u32 = u32::MAX;

/// For each triangle what shows whether it is inside, by the rule of a domain that knows no rings.
pub(super) enum Values {
    Hull,
    EvenOdd(Vec<i32>),
    NonZero(Vec<i32>),
}

/// The rings that go round a triangle, and how many polygons cover it.
struct Around {
    /// For each ring the place of its polygon, and whether it is a hole there.
    roles: Vec<(usize, bool)>,
    is_around: Vec<bool>,
    /// How many outlines and how many holes of each polygon go round.
    counts: Vec<[usize; 2]>,
    covering: usize,
}

impl Around {
    /// Outside of all rings.
    fn new(rings: &[Ring]) -> Self {
        let mut places: HashMap<usize, usize> = HashMap::new();
        let roles = rings.iter().map(|ring| {
            let next = places.len();
            (*places.entry(ring.polygon).or_insert(next), ring.is_hole)
        });
        Around {
            roles: roles.collect(),
            is_around: vec![false; rings.len()],
            counts: vec![[0; 2]; places.len()],
            covering: 0,
        }
    }

    /// A ring comes or goes.
    fn flip(&mut self, ring: usize) {
        let (polygon, is_hole) = self.roles[ring];
        let counts = &mut self.counts[polygon];
        let covers = |counts: &[usize; 2]| usize::from(counts[0] > 0 && counts[1] == 0);
        self.covering -= covers(counts);
        let is_around = &mut self.is_around[ring];
        *is_around = !*is_around;
        let count = &mut counts[usize::from(is_hole)];
        *count = if *is_around { *count + 1 } else { *count - 1 };
        self.covering += covers(counts);
    }
}

/// Triangles with their neighbours. A half-edge `3 t + k` runs from corner `k` of triangle `t` to the next one.
pub(super) struct Tiling<'a, S> {
    points: &'a [[S; 2]],
    /// For each point its place among the distinct points, in the order (x, y).
    rank: Vec<u32>,
    /// For each place the first point there.
    point: Vec<u32>,
    /// The ranks of the corners, counterclockwise, the earliest one first.
    corners: Vec<[u32; 3]>,
    /// For each half-edge the one on the other side, or [`NONE`].
    twin: Vec<u32>,
    /// For each half-edge its side, a position in `sides`.
    side: Vec<u32>,
    /// The ranks of the ends of each side, the earlier one first, in ascending order.
    sides: Vec<[u32; 2]>,
    /// For each rank the first side that begins there, and one more.
    first: Vec<u32>,
    /// Of how many edges each side is a piece.
    pieces: Vec<i32>,
    /// How many edges run along each side, from its earlier end, less those that run against it.
    along: Vec<i32>,
    /// The sides of edges that are part of a ring, each with the position of the ring.
    walls: Vec<[u32; 2]>,
    /// For vertices that an edge goes on from: the later vertices beside them, from the right to the left.
    fans: HashMap<u32, Vec<u32>>,
}

impl<'a, S: Coordinate> Tiling<'a, S> {
    /// The triangles by their earliest corners, so that triangles near each other are read one after the other, and for
    /// each its position in the list. `None` if a vertex does not exist or a side has other than one or two triangles, one
    /// on each side.
    pub(super) fn new(points: &'a [[S; 2]], triangles: &[[usize; 3]]) -> Option<(Self, Vec<u32>)> {
        let (rank, point) = ranked(points)?;
        let ranked = |triangle: &[usize; 3]| {
            let mut corners = [0; 3];
            for (corner, &v) in corners.iter_mut().zip(triangle) {
                *corner = *rank.get(v)?;
            }
            let first = (0..3).min_by_key(|&k| corners[k])?;
            corners.rotate_left(first);
            Some(corners)
        };
        let listed: Vec<[u32; 3]> = triangles.iter().map(ranked).collect::<Option<_>>()?;
        let (mut corners, positions) = by_earliest(&listed, point.len())?;
        drop(listed);
        let place = |v: u32| &points[point[v as usize] as usize];
        for [a, b, c] in &mut corners {
            if orient2d(place(*a), place(*b), place(*c)).is_lt() {
                std::mem::swap(b, c);
            }
        }
        let halves = u32::try_from(3 * corners.len())
            .ok()
            .filter(|&halves| halves < NONE)?;

        // Half-edges by the earlier end of each, and for each of these ends by the later one.
        let of_side = |half: u32| {
            let [from, to] = ends(&corners, half);
            [from.min(to), from.max(to)]
        };
        let mut starts = vec![0_u32; point.len() + 1];
        for half in 0..halves {
            starts[of_side(half)[0] as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut sorted = vec![[0; 2]; halves as usize];
        for half in (0..halves).rev() {
            let [low, high] = of_side(half);
            let start = &mut starts[low as usize];
            *start -= 1;
            sorted[*start as usize] = [high, half];
        }
        let (mut twin, mut side) = (vec![NONE; halves as usize], vec![0; halves as usize]);
        let (mut sides, mut first) = (Vec::new(), Vec::with_capacity(starts.len()));
        for (low, bounds) in (0..).zip(starts.windows(2)) {
            first.push(u32::try_from(sides.len()).ok()?);
            let beside = &mut sorted[bounds[0] as usize..bounds[1] as usize];
            beside.sort_unstable();
            for both in beside.chunk_by(|a, b| a[0] == b[0]) {
                for &[_, half] in both {
                    side[half as usize] = u32::try_from(sides.len()).ok()?;
                }
                sides.push([low, both[0][0]]);
                match *both {
                    [_] => {}
                    [[_, a], [_, b]] if ends(&corners, a) != ends(&corners, b) => {
                        twin[a as usize] = b;
                        twin[b as usize] = a;
                    }
                    _ => return None,
                }
            }
        }
        first.push(u32::try_from(sides.len()).ok()?);
        let (pieces, along) = (vec![0; sides.len()], vec![0; sides.len()]);
        let tiling = Tiling {
            points,
            rank,
            point,
            corners,
            twin,
            side,
            sides,
            first,
            pieces,
            along,
            walls: Vec::new(),
            fans: HashMap::new(),
        };
        Some((tiling, positions))
    }

    /// The points inside an edge, in its direction. Its pieces are marked. `None` if it is no chain of sides.
    pub(super) fn chain(&mut self, edge: [usize; 2], ring: Option<usize>) -> Option<Vec<u32>> {
        let ring = ring.map(u32::try_from).transpose().ok()?;
        let [from, to] = edge.map(|v| self.rank.get(v).copied());
        let [from, to] = [from?, to?];
        let (mut at, last) = (from.min(to), from.max(to));
        let mut inside = Vec::new();
        // Points on one line have no sides, and their edges are not asked for.
        while at != last && !self.corners.is_empty() {
            let (next, side) = match self.side_to(at, last) {
                Some(side) => (last, side),
                None => {
                    let next = self.next_on_the_way(at, last)?;
                    (next, self.side_to(at, next)?)
                }
            };
            self.pieces[side] += 1;
            self.along[side] += if from < to { 1 } else { -1 };
            let wall = ring.map(|ring| Some([u32::try_from(side).ok()?, ring]));
            self.walls.extend(wall.flatten());
            if next != last {
                inside.push(self.point[next as usize]);
            }
            at = next;
        }
        if from > to {
            inside.reverse();
        }
        Some(inside)
    }

    /// The sides from a rank to later ones.
    fn beside(&self, at: u32) -> Range<usize> {
        self.first[at as usize] as usize..self.first[at as usize + 1] as usize
    }

    /// The side from a rank to a later one.
    fn side_to(&self, at: u32, to: u32) -> Option<usize> {
        let beside = self.beside(at);
        let place = self.sides[beside.clone()].binary_search(&[at, to]).ok()?;
        Some(beside.start + place)
    }

    /// The vertex beside `at` that lies on the way to a later one.
    fn next_on_the_way(&mut self, at: u32, to: u32) -> Option<u32> {
        let (points, point) = (self.points, &self.point);
        let place = |v: u32| &points[point[v as usize] as usize];
        let turn = |v: u32, w: u32| orient2d(place(at), place(v), place(w));
        let beside = &self.sides[self.beside(at)];
        let fan = self.fans.entry(at).or_insert_with(|| {
            let mut fan: Vec<u32> = beside.iter().map(|side| side[1]).collect();
            fan.sort_by(|&v, &w| turn(v, w).reverse());
            fan
        });
        let place = fan.binary_search_by(|&v| turn(v, to).reverse()).ok()?;
        Some(fan[place]).filter(|&next| next < to)
    }

    /// The ranks of the ends of a half-edge.
    fn ends(&self, half: u32) -> [u32; 2] {
        ends(&self.corners, half)
    }

    fn is_lower(&self, half: u32) -> bool {
        let [from, to] = self.ends(half);
        from < to
    }

    /// The lower hull, and the triangles in an order in which each stands after those across its lower sides.
    pub(super) fn in_order(&self) -> Option<(Vec<u32>, Vec<u32>)> {
        let halves = 0..u32::try_from(self.twin.len()).ok()?;
        let is_border = |half: &u32| self.twin[*half as usize] == NONE && self.is_lower(*half);
        let mut border: Vec<u32> = halves.clone().filter(is_border).collect();
        border.sort_unstable_by_key(|&half| self.ends(half));
        let starts = border.iter().map(|&half| self.ends(half)[0]);
        let end = border.last().map(|&half| self.ends(half)[1]);
        let lower = starts.chain(end).map(|v| self.point[v as usize]);

        // How many triangles must be listed before each.
        let mut waits = vec![0_u8; self.corners.len()];
        for half in halves.filter(|&half| self.twin[half as usize] != NONE && self.is_lower(half)) {
            waits[half as usize / 3] += 1;
        }
        let mut stack: Vec<u32> = Vec::new();
        for half in border.iter().rev() {
            if waits[*half as usize / 3] == 0 && stack.last() != Some(&(half / 3)) {
                stack.push(half / 3);
            }
        }
        let mut order = Vec::with_capacity(self.corners.len());
        while let Some(t) = stack.pop() {
            order.push(t);
            // From the right to the left.
            for half in [3 * t + 1, 3 * t + 2] {
                let above = self.twin[half as usize];
                if above == NONE || self.is_lower(half) {
                    continue;
                }
                let waits = &mut waits[above as usize / 3];
                *waits -= 1;
                if *waits == 0 {
                    stack.push(above / 3);
                }
            }
        }
        (order.len() == self.corners.len()).then(|| (lower.collect(), order))
    }

    /// The values of the first rule by which these triangles are inside, of those that know no rings.
    pub(super) fn values(&self, is_inside: impl Fn(usize) -> bool) -> Option<Values> {
        let all = 0..self.corners.len();
        if all.clone().all(&is_inside) {
            return Some(Values::Hull);
        }
        let is = |windings: &Vec<i32>| all.clone().all(|t| (windings[t] != 0) == is_inside(t));
        let rise = |rises: &[i32], half: u32| {
            let rise = rises[self.side[half as usize] as usize];
            if self.is_lower(half) { rise } else { -rise }
        };
        let parities =
            self.spread(|parity: &i32, half| (parity + rise(&self.pieces, half)).rem_euclid(2));
        let even_odd = parities.filter(is).map(Values::EvenOdd);
        even_odd.or_else(|| {
            let windings = self.spread(|winding, half| winding + rise(&self.along, half));
            windings.filter(is).map(Values::NonZero)
        })
    }

    /// Whether polygons of these rings cover what is inside and nothing else, if each ring is closed. Rings come and go on
    /// a walk through all triangles.
    pub(super) fn are_covered(
        &mut self,
        rings: &[Ring],
        is_inside: impl Fn(usize) -> bool,
    ) -> bool {
        self.walls.sort_unstable();
        let mut around = Around::new(rings);
        let mut seen = vec![false; self.corners.len()];
        // Half-edges to enter triangles by, and to leave them by.
        let halves = 0..3 * u32::try_from(self.corners.len()).unwrap_or(0);
        let is_border = |half: &u32| self.twin[*half as usize] == NONE;
        let mut stack: Vec<(u32, bool)> =
            halves.filter(is_border).map(|half| (half, true)).collect();
        while let Some((half, enters)) = stack.pop() {
            let t = half as usize / 3;
            if enters && seen[t] {
                continue;
            }
            for ring in self.rings_along(half) {
                around.flip(ring as usize);
            }
            if enters {
                seen[t] = true;
                if (around.covering > 0) != is_inside(t) {
                    return false;
                }
                stack.push((half, false));
                let twins = self.twin[3 * t..3 * t + 3].iter();
                stack.extend(
                    twins
                        .filter(|&&twin| twin != NONE)
                        .map(|&twin| (twin, true)),
                );
            }
        }
        true
    }

    /// The rings of the edges along a half-edge, after [`are_covered`](Self::are_covered).
    fn rings_along(&self, half: u32) -> impl Iterator<Item = u32> {
        let side = self.side[half as usize];
        let count = usize::try_from(self.pieces[side as usize]).unwrap_or(0);
        let first = if count == 0 {
            0
        } else {
            self.walls.partition_point(|&[other, _]| other < side)
        };
        let walls = self.walls[first..].iter().take(count);
        let walls = walls.take_while(move |[other, _]| *other == side);
        walls.map(|[_, ring]| *ring)
    }

    /// The rings along the lower sides of a triangle, by the names of these sides.
    pub(super) fn rings_below(&self, t: u32) -> impl Iterator<Item = (&'static str, u32)> {
        let lower = [(" ab", 3 * t), (" bc", 3 * t + 1)].into_iter();
        lower
            .filter(|&(_, half)| self.is_lower(half))
            .flat_map(|(name, half)| self.rings_along(half).map(move |ring| (name, ring)))
    }

    /// The points at the corners of a triangle.
    pub(super) fn triangle(&self, t: u32) -> [u32; 3] {
        self.corners[t as usize].map(|v| self.point[v as usize])
    }

    /// A value of each triangle, from the default one outside; `enter` makes of the value on the right of a half-edge the
    /// value on the left. `None` if two ways to a triangle disagree: then edges are no closed rings.
    fn spread<V: Clone + Default + PartialEq>(
        &self,
        enter: impl Fn(&V, u32) -> V,
    ) -> Option<Vec<V>> {
        let outside = V::default();
        let mut values: Vec<Option<V>> = vec![None; self.corners.len()];
        // Half-edges with a known value on the right: first those of the border, then those across sides.
        let halves = 0..u32::try_from(self.twin.len()).ok()?;
        let is_border = |half: &u32| self.twin[*half as usize] == NONE;
        let mut stack: Vec<u32> = halves.filter(is_border).collect();
        while let Some(half) = stack.pop() {
            let right = match self.twin[half as usize] {
                NONE => &outside,
                twin => values[twin as usize / 3].as_ref()?,
            };
            let value = enter(right, half);
            let known = &mut values[half as usize / 3];
            match known {
                Some(known) if *known != value => return None,
                Some(_) => continue,
                None => *known = Some(value),
            }
            let first = half as usize - half as usize % 3;
            let twins = self.twin[first..first + 3].iter();
            stack.extend(twins.filter(|&&twin| twin != NONE));
        }
        values.into_iter().collect()
    }

    /// For each triangle which sides are pieces of edges: the sum of 1, 2 and 4.
    pub(super) fn marks(&self) -> Vec<u8> {
        let piece = |&side: &u32| u8::from(self.pieces[side as usize] > 0);
        let mark = |sides: &[u32; 3]| {
            let [first, second, third] = sides.each_ref().map(piece);
            first | second << 1 | third << 2
        };
        self.side.as_chunks().0.iter().map(mark).collect()
    }
}

/// The ranks of the ends of a half-edge.
fn ends(corners: &[[u32; 3]], half: u32) -> [u32; 2] {
    let [t, k] = [half as usize / 3, half as usize % 3];
    [corners[t][k], corners[t][(k + 1) % 3]]
}

/// Triangles by their earliest corners, which stand first, and for each its position in the list.
fn by_earliest(listed: &[[u32; 3]], count: usize) -> Option<(Vec<[u32; 3]>, Vec<u32>)> {
    let mut starts = vec![0_usize; count + 1];
    for corners in listed {
        starts[corners[0] as usize + 1] += 1;
    }
    for rank in 0..count {
        starts[rank + 1] += starts[rank];
    }
    let (mut sorted, mut positions) = (vec![[0; 3]; listed.len()], vec![0; listed.len()]);
    for (position, corners) in listed.iter().enumerate() {
        let start = &mut starts[corners[0] as usize];
        sorted[*start] = *corners;
        positions[*start] = u32::try_from(position).ok()?;
        *start += 1;
    }
    Some((sorted, positions))
}

/// For each point its place among the distinct points, and for each place its first point; `None` if there are too many,
/// or one is not finite.
fn ranked<S: Coordinate>(points: &[[S; 2]]) -> Option<(Vec<u32>, Vec<u32>)> {
    let sorted = sorted(points);
    if sorted.len() < points.len() {
        return None;
    }
    let (mut rank, mut point) = (vec![0; points.len()], Vec::new());
    let is_equal = |(near, v): &([f64; 2], usize), (other, w): &([f64; 2], usize)| {
        order((near, &points[*v]), (other, &points[*w])).is_eq()
    };
    for equal in sorted.chunk_by(is_equal) {
        for &(_, v) in equal {
            rank[v] = u32::try_from(point.len()).ok()?;
        }
        point.push(u32::try_from(equal[0].1).ok()?);
    }
    Some((rank, point))
}
