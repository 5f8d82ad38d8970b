//! Certificates: the input, the triangles and hints, from which a proved checker sees that a result is right.
//!
//! The format is that of `proof/certificate.md`. The verdict is about the points, edges and polygons in the file:
//! coordinates as integers times one power of two, which must be the caller's exactly. A fault in anything else makes the
//! checker refuse, never accept. The hints are the chain of points along each edge, the lower hull, the sides that are
//! pieces of edges, an order of the triangles, and, where not all are inside, how often the edges go round each triangle,
//! or the rings of polygons that do.
//!
//! ```text
//!        .-----------.          A side that leads to a later point, counterclockwise, is a *lower* side of its
//!       / \         / \         triangle (*later* is meant in the order (x, y)). The neighbour across a lower
//!      /   \  2    /   \        side is listed before: 0 and 1 before 2. So the triangles read so far always
//!     /  0  \     /  1  \       have an upper border that goes from left to right.
//!    '-------'---'-------'
//! ```
//!
//! Cost: O(n log n) for n points, edges and triangles, by sorts; 80 bytes a triangle, and the integers. With polygons 24
//! bytes a triangle more, and the rings around each.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, Write};

use num_bigint::BigInt;
use sweep_cdt::interior::Ring;
use sweep_cdt::scalar::filtered_orient2d;

use crate::{Coordinate, Polygons};

/// No half-edge.
const NONE: u32 = u32::MAX;

/// Writes a certificate of a constrained Delaunay triangulation: of `points` and `edges` with these `triangles`, which
/// cover the hull, and of which those are inside that `is_inside` says, by position. The certificate is of `polygons` if
/// there are any here, which must cover what is inside. Else the certificate is of the hull if all is inside, and
/// otherwise of the rule (even-odd or nonzero) by which these triangles are.
///
/// ```
/// use sweep_cdt_formats::write_certificate;
///
/// let points = [[0.0, 0.0], [0.5, 0.0], [0.0, 2.0]];
/// let mut text = Vec::new();
/// write_certificate(&points, &[[0, 1]], None, &[[0, 1, 2]], |_| true, &mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.starts_with("sweep-cdt-certificate 1\nexponent -1\ndomain hull\npoints 3\n0 0\n1 0\n0 4\nedges 1\n0 1\n"));
/// assert!(text.ends_with("lower 1\n0\n1\ntriangles 1\n0 1 2 1\nend\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::InvalidInput`] where a coordinate is no integer times a power of two, where the
/// triangles do not tile the hull or lack an edge, so that there is nothing to certify, and where those inside are so by
/// another rule.
pub fn write_certificate<S: Coordinate>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    polygons: Option<&Polygons>,
    triangles: &[[usize; 3]],
    is_inside: impl Fn(usize) -> bool,
    out: &mut impl Write,
) -> io::Result<()> {
    let (exponent, coordinates) = coordinates(points)?;
    let mut tiling = Tiling::new(points, triangles).ok_or_else(wrong)?;
    let ring = |edge: usize| polygons.and_then(|polygons| *polygons.ring_of.get(edge)?);
    let chains = edges.iter().enumerate();
    let chains = chains.map(|(edge, &ends)| tiling.chain(ends, ring(edge)));
    let chains = chains
        .collect::<Option<Vec<Vec<u32>>>>()
        .ok_or_else(wrong)?;
    let (lower, order) = tiling.in_order().ok_or_else(wrong)?;
    let values = match polygons {
        Some(polygons) => tiling.values_of_polygons(&polygons.rings, is_inside),
        None => tiling.values(is_inside),
    };
    let values = values.ok_or_else(other_interior)?;

    writeln!(out, "sweep-cdt-certificate 1")?;
    writeln!(out, "exponent {exponent}")?;
    writeln!(out, "domain {}", values.domain())?;
    if let Some(polygons) = polygons {
        write_polygons(&polygons.rings, out)?;
    }
    writeln!(out, "points {}", points.len())?;
    for point in coordinates.chunks(2) {
        let [x, y] = [0, 1].map(|axis| integer(&point[axis], exponent));
        writeln!(out, "{x} {y}")?;
    }
    writeln!(out, "edges {}", edges.len())?;
    for (edge, ([from, to], chain)) in edges.iter().zip(&chains).enumerate() {
        match (polygons, ring(edge)) {
            (None, _) => {}
            (_, None) => write!(out, "- ")?,
            (_, Some(ring)) => write!(out, "{ring} ")?,
        }
        write!(out, "{from}")?;
        for point in chain {
            write!(out, " {point}")?;
        }
        writeln!(out, " {to}")?;
    }
    writeln!(out, "lower {}", lower.len().saturating_sub(1))?;
    for point in lower {
        writeln!(out, "{point}")?;
    }
    writeln!(out, "triangles {}", order.len())?;
    for t in order {
        let [a, b, c] = tiling.corners[t as usize];
        write!(out, "{a} {b} {c} {}", tiling.mark(t))?;
        match &values {
            Values::Hull => {}
            Values::EvenOdd(windings) | Values::NonZero(windings) => {
                write!(out, " {}", windings[t as usize])?;
            }
            Values::Polygons(rings) => {
                for ring in &rings[t as usize] {
                    write!(out, " {ring}")?;
                }
            }
        }
        writeln!(out)?;
    }
    writeln!(out, "end")
}

/// The rings of each polygon, by their positions.
fn write_polygons(rings: &[Ring], out: &mut impl Write) -> io::Result<()> {
    let mut polygons: BTreeMap<u32, [Vec<usize>; 2]> = BTreeMap::new();
    for (number, ring) in rings.iter().enumerate() {
        polygons.entry(ring.polygon).or_default()[usize::from(ring.is_hole)].push(number);
    }
    writeln!(out, "polygons {}", polygons.len())?;
    for rings in polygons.values() {
        for (name, list) in ["outlines", " holes"].iter().zip(rings) {
            write!(out, "{name}")?;
            for ring in list {
                write!(out, " {ring}")?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

fn wrong() -> io::Error {
    let why =
        "the triangles do not tile the hull with all edges, so that there is nothing to certify";
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

fn other_interior() -> io::Error {
    let why = "a certificate is of what is inside by the rule hull, polygons, even-odd or nonzero: add --inside hull";
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

/// For each triangle what shows whether it is inside, by the rule of a domain.
enum Values {
    Hull,
    EvenOdd(Vec<i32>),
    NonZero(Vec<i32>),
    Polygons(Vec<Vec<u32>>),
}

impl Values {
    /// The name of the rule.
    fn domain(&self) -> &'static str {
        match self {
            Values::Hull => "hull",
            Values::EvenOdd(_) => "even-odd",
            Values::NonZero(_) => "nonzero",
            Values::Polygons(_) => "polygons",
        }
    }
}

/// Whether one of the polygons covers what these rings, by position, go round.
fn is_covered(rings: &[Ring], around: &[u32]) -> bool {
    let mut polygons: HashMap<u32, [bool; 2]> = HashMap::new();
    for &ring in around {
        let Ring { polygon, is_hole } = rings[ring as usize];
        polygons.entry(polygon).or_default()[usize::from(is_hole)] = true;
    }
    polygons.values().any(|around| *around == [true, false])
}

/// The least exponent, and all coordinates, x and y in turn, each as an integer with an exponent of two.
fn coordinates<S: Coordinate>(points: &[[S; 2]]) -> io::Result<(i64, Vec<(BigInt, i64)>)> {
    let list: Option<Vec<(BigInt, i64)>> = points.iter().flatten().map(S::binary).collect();
    let list = list.ok_or_else(|| {
        let why = "a certificate has integers times a power of two, and a coordinate is none, such as 1/3 or 0.1 read \
                   exactly: multiply all by their denominators";
        io::Error::new(io::ErrorKind::InvalidInput, why)
    })?;
    let exponents = list.iter().filter(|(integer, _)| integer.bits() > 0);
    let least = exponents.map(|&(_, exponent)| exponent).min().unwrap_or(0);
    Ok((least, list))
}

/// A coordinate in units of two to the power `least`, as text.
fn integer((integer, exponent): &(BigInt, i64), least: i64) -> String {
    if integer.bits() == 0 {
        return "0".to_owned();
    }
    let integer = integer << (exponent - least).unsigned_abs();
    match i64::try_from(&integer) {
        Ok(small) => small.to_string(),
        // Hexadecimal digits are quicker to write and to read.
        Err(_) => format!("{integer:#x}"),
    }
}

/// Triangles with their neighbours. A half-edge `3 t + k` runs from corner `k` of triangle `t` to the next one.
struct Tiling<'a, S> {
    points: &'a [[S; 2]],
    /// For each point its place among the distinct points, in the order (x, y).
    rank: Vec<u32>,
    /// For each place the first point there.
    point: Vec<u32>,
    /// Counterclockwise, the earliest corner first.
    corners: Vec<[u32; 3]>,
    /// For each half-edge the one on the other side, or [`NONE`].
    twin: Vec<u32>,
    /// For each half-edge its side, a position in `sides`.
    side: Vec<u32>,
    /// The ranks of the ends of each side, the earlier one first, in ascending order.
    sides: Vec<[u32; 2]>,
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
    /// `None` if a vertex does not exist or a side has other than one or two triangles, one on each side.
    fn new(points: &'a [[S; 2]], triangles: &[[usize; 3]]) -> Option<Self> {
        let (rank, point) = ranked(points)?;
        let turned = |corners: &[usize; 3]| {
            let [a, b, c] = *corners;
            let [p, q, r] = [points.get(a)?, points.get(b)?, points.get(c)?];
            let is_left = !filtered_orient2d(p, q, r).is_lt();
            let mut corners = if is_left { [a, b, c] } else { [a, c, b] };
            let first = (0..3).min_by_key(|&k| rank[corners[k]])?;
            corners.rotate_left(first);
            Some(corners.map(|v| u32::try_from(v).expect("points are numbered with 32 bits")))
        };
        let corners: Vec<[u32; 3]> = triangles.iter().map(turned).collect::<Option<_>>()?;
        let halves = u32::try_from(3 * corners.len())
            .ok()
            .filter(|&halves| halves < NONE)?;

        let ends = |half: u32| ends(&corners, half).map(|v| rank[v as usize]);
        let of_side = |half: u32| {
            let [from, to] = ends(half);
            [from.min(to), from.max(to)]
        };
        let mut sorted: Vec<u32> = (0..halves).collect();
        sorted.sort_unstable_by_key(|&half| of_side(half));
        let (mut twin, mut side) = (vec![NONE; halves as usize], vec![0; halves as usize]);
        let mut sides = Vec::new();
        for both in sorted.chunk_by(|&a, &b| of_side(a) == of_side(b)) {
            for &half in both {
                side[half as usize] = u32::try_from(sides.len()).ok()?;
            }
            sides.push(of_side(both[0]));
            match *both {
                [_] => {}
                [a, b] if ends(a) != ends(b) => {
                    twin[a as usize] = b;
                    twin[b as usize] = a;
                }
                _ => return None,
            }
        }
        let (pieces, along) = (vec![0; sides.len()], vec![0; sides.len()]);
        Some(Tiling {
            points,
            rank,
            point,
            corners,
            twin,
            side,
            sides,
            pieces,
            along,
            walls: Vec::new(),
            fans: HashMap::new(),
        })
    }

    /// The points inside an edge, in its direction. Its pieces are marked. `None` if it is no chain of sides.
    fn chain(&mut self, edge: [usize; 2], ring: Option<usize>) -> Option<Vec<u32>> {
        let ring = ring.map(u32::try_from).transpose().ok()?;
        let [from, to] = edge.map(|v| self.rank.get(v).copied());
        let [from, to] = [from?, to?];
        let (mut at, last) = (from.min(to), from.max(to));
        let mut inside = Vec::new();
        // Points on one line have no sides, and their edges are not asked for.
        while at != last && !self.corners.is_empty() {
            let next = match self.sides.binary_search(&[at, last]) {
                Ok(_) => last,
                Err(_) => self.next_on_the_way(at, last)?,
            };
            let side = self.sides.binary_search(&[at, next]).ok()?;
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

    /// The vertex beside `at` that lies on the way to a later one.
    fn next_on_the_way(&mut self, at: u32, to: u32) -> Option<u32> {
        let (points, point) = (self.points, &self.point);
        let place = |v: u32| &points[point[v as usize] as usize];
        let turn = |v: u32, w: u32| filtered_orient2d(place(at), place(v), place(w));
        let sides = &self.sides;
        let fan = self.fans.entry(at).or_insert_with(|| {
            let first = sides.partition_point(|side| side[0] < at);
            let beside = sides[first..].iter().take_while(|side| side[0] == at);
            let mut fan: Vec<u32> = beside.map(|side| side[1]).collect();
            fan.sort_by(|&v, &w| turn(v, w).reverse());
            fan
        });
        let place = fan.binary_search_by(|&v| turn(v, to).reverse()).ok()?;
        Some(fan[place]).filter(|&next| next < to)
    }

    /// The ranks of the ends of a half-edge.
    fn ends(&self, half: u32) -> [u32; 2] {
        ends(&self.corners, half).map(|v| self.rank[v as usize])
    }

    fn is_lower(&self, half: u32) -> bool {
        let [from, to] = self.ends(half);
        from < to
    }

    /// The lower hull, and the triangles in an order in which each stands after those across its lower sides.
    fn in_order(&self) -> Option<(Vec<u32>, Vec<u32>)> {
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
    fn values(&self, is_inside: impl Fn(usize) -> bool) -> Option<Values> {
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

    /// The rings that go round each triangle an odd number of times, if polygons of them cover what is inside.
    fn values_of_polygons(
        &mut self,
        rings: &[Ring],
        is_inside: impl Fn(usize) -> bool,
    ) -> Option<Values> {
        self.walls.sort_unstable();
        let around = self.spread(|around: &Vec<u32>, half| {
            let mut around = around.clone();
            let side = self.side[half as usize];
            let first = self.walls.partition_point(|&[other, _]| other < side);
            let walls = self.walls[first..].iter();
            for [_, ring] in walls.take_while(|[other, _]| *other == side) {
                match around.binary_search(ring) {
                    Ok(place) => drop(around.remove(place)),
                    Err(place) => around.insert(place, *ring),
                }
            }
            around
        })?;
        let mut all = around.iter().enumerate();
        let is_right = all.all(|(t, around)| is_covered(rings, around) == is_inside(t));
        is_right.then_some(Values::Polygons(around))
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

    /// Which sides of a triangle are pieces of edges: the sum of 1, 2 and 4.
    fn mark(&self, t: u32) -> u8 {
        let pieces = |k: u32| self.pieces[self.side[(3 * t + k) as usize] as usize];
        (0..3).map(|k| u8::from(pieces(k) > 0) << k).sum()
    }
}

/// The points at the ends of a half-edge.
fn ends(corners: &[[u32; 3]], half: u32) -> [u32; 2] {
    let [t, k] = [half as usize / 3, half as usize % 3];
    [corners[t][k], corners[t][(k + 1) % 3]]
}

/// For each point its place among the distinct points, and for each place its first point; `None` if there are too many.
fn ranked<S: Coordinate>(points: &[[S; 2]]) -> Option<(Vec<u32>, Vec<u32>)> {
    let mut order: Vec<u32> = (0..u32::try_from(points.len()).ok()?).collect();
    let compare = |&v: &u32, &w: &u32| {
        let [[ax, ay], [bx, by]] = [v, w].map(|v| &points[v as usize]);
        ax.compare(bx).then_with(|| ay.compare(by))
    };
    order.sort_by(compare);
    let (mut rank, mut point) = (vec![0; points.len()], Vec::new());
    for equal in order.chunk_by(|v, w| compare(v, w).is_eq()) {
        for &v in equal {
            rank[v as usize] = u32::try_from(point.len()).ok()?;
        }
        point.push(equal[0]);
    }
    Some((rank, point))
}
