//! Polygons with holes out of bytes: what they cover is known from how they are made.
//!
//! Rings of all shapes but walks are those of valid polygons, which may touch. They are made on a small lattice, then
//! moved by a map that keeps them valid exactly: columns and rows to other places, or all by small integers.

use std::collections::BTreeMap;

use arbitrary::{Result, Unstructured};

use super::bytes::{Made, Place, Points, byte};
use super::sieves::sieves;
use super::wheels::wheels;

/// How rings are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rings {
    /// The borders of cells of a board: many holes, rings that touch at corners, vertices on straight lines.
    Cells,
    /// Rings about one centre, each within the one before: polygons in holes, slivers, rings that touch.
    Stars,
    /// Between two chains that run from left to right: steep, flat, or with teeth.
    Strips,
    /// Some polygons, each with 0 to 20 holes in rows and columns: holes that touch the outline or each other, polygons
    /// in holes and in frames, with a side in common, or a corner.
    Sieves,
    /// Vertices on circles, ten triangles about one vertex, teeth along a straight side.
    Wheels,
    /// Walks on a lattice: rings that overlap, repeat and go through themselves.
    Walks,
}

impl Rings {
    /// Each of them.
    pub const ALL: [Rings; 6] = [
        Rings::Cells,
        Rings::Stars,
        Rings::Strips,
        Rings::Sieves,
        Rings::Wheels,
        Rings::Walks,
    ];

    /// The shape that a byte picks, every other time a sieve, one in eight wheels. Walks are rings of no valid polygons.
    pub fn of(byte: u8, with_walks: bool) -> Rings {
        let plain = [Rings::Cells, Rings::Stars, Rings::Strips, Rings::Walks];
        let count = plain.len() - usize::from(!with_walks);
        match byte & 7 {
            0 | 2 | 4 | 6 => Rings::Sieves,
            7 => Rings::Wheels,
            _ => plain[usize::from(byte >> 1) % count],
        }
    }

    /// The name.
    pub fn name(self) -> &'static str {
        match self {
            Rings::Cells => "cells",
            Rings::Stars => "stars",
            Rings::Strips => "strips",
            Rings::Sieves => "sieves",
            Rings::Wheels => "wheels",
            Rings::Walks => "walks",
        }
    }
}

/// Points, and polygons as lists of rings: outlines run counter-clockwise, holes clockwise.
pub type Polygons = (Points, Vec<Vec<Vec<usize>>>);

/// Polygons of this shape with at most `most` vertices.
///
/// # Errors
/// None in practice; see [`Unstructured`].
pub fn polygons(
    shape: Rings,
    may_touch: bool,
    most: usize,
    bytes: &mut Unstructured<'_>,
) -> Result<Polygons> {
    let mut rings = match shape {
        Rings::Cells => cells(may_touch, bytes)?,
        Rings::Stars => stars(may_touch, bytes)?,
        Rings::Strips => strips(bytes)?,
        Rings::Sieves => sieves(may_touch, bytes)?,
        Rings::Wheels => wheels(may_touch, bytes)?,
        Rings::Walks => walks(bytes)?,
    };
    while rings.iter().flatten().map(Vec::len).sum::<usize>() > most {
        // A hole, or else a polygon.
        match rings.last_mut() {
            Some(polygon) if polygon.len() > 1 => drop(polygon.pop()),
            _ => drop(rings.pop()),
        }
    }
    let map = Map::read(shape, bytes)?;
    let (mut points, mut polygons) = (Points::new(), Vec::new());
    for polygon in &mut rings {
        let mut numbered = Vec::new();
        for ring in polygon {
            let first = usize::from(byte(bytes)?) % ring.len();
            ring.rotate_left(first);
            numbered.push((points.len()..points.len() + ring.len()).collect());
            points.extend(ring.iter().map(|&place| map.apply(place)));
        }
        polygons.push(numbered);
    }
    Ok((points, polygons))
}

/// The places where columns and rows are, or four small integers.
enum Map {
    Lines([Vec<f64>; 2]),
    Linear([i32; 4]),
}

/// So many columns and rows a lattice has at most.
const LINES: usize = 17;

impl Map {
    fn read(shape: Rings, bytes: &mut Unstructured<'_>) -> Result<Map> {
        const LINEAR: [[i32; 4]; 6] = [
            [1, 0, 0, 1],
            [0, -1, 1, 0],
            [1, 1, 0, 1],
            [2, 1, -1, 1],
            [3, 1, 1, 2],
            [7, 2, 3, 1],
        ];
        let kind = byte(bytes)?;
        if shape != Rings::Cells || kind & 1 == 0 {
            return Ok(Map::Linear(LINEAR[usize::from(kind >> 1) % LINEAR.len()]));
        }
        let unit = [1.0, 0.1, 1.0 / 3.0, 1e-7][usize::from(kind >> 1 & 3)];
        let offset = [0.0, -1.0, 1e3, 1e6][usize::from(kind >> 3 & 3)];
        let mut lines = || {
            let mut at = offset;
            let places = (0..LINES).map(|_| {
                let step = byte(bytes)?;
                // Mostly a few units, sometimes the next double.
                let next = at + unit * f64::from(step & 31);
                let place = at;
                at = if next > at { next } else { at.next_up() };
                Ok(place)
            });
            places.collect::<Result<Vec<f64>>>()
        };
        Ok(Map::Lines([lines()?, lines()?]))
    }

    fn apply(&self, [x, y]: Place) -> [f64; 2] {
        match self {
            Map::Lines(places) => {
                let at = |axis: usize, line: i32| {
                    places[axis][usize::try_from(line).unwrap_or(0) % LINES]
                };
                [at(0, x), at(1, y)]
            }
            Map::Linear([a, b, c, d]) => [a * x + b * y, c * x + d * y].map(f64::from),
        }
    }
}

/// The borders of the cells that the bits of bytes choose: each set of cells that share sides is a polygon.
fn cells(may_touch: bool, bytes: &mut Unstructured<'_>) -> Result<Made> {
    let (width, height) = (
        1 + usize::from(byte(bytes)? % 7),
        1 + usize::from(byte(bytes)? % 6),
    );
    let mut rows = Vec::new();
    for _ in 0..height {
        let row = byte(bytes)?;
        rows.push((0..width).map(|x| row >> x & 1 == 1).collect::<Vec<bool>>());
    }
    let style = byte(bytes)?;
    let mut is_open = !may_touch;
    while is_open {
        is_open = false;
        // Two cells that share only a corner get a third one.
        for y in 1..height {
            for x in 1..width {
                let [a, b, c, d] = [
                    rows[y - 1][x - 1],
                    rows[y - 1][x],
                    rows[y][x - 1],
                    rows[y][x],
                ];
                if a == d && b == c && a != b {
                    (rows[y - 1][x - 1], rows[y - 1][x]) = (true, true);
                    is_open = true;
                }
            }
        }
    }
    let is_in = |[x, y]: Place| {
        let cell = [x, y].map(usize::try_from);
        matches!(cell, [Ok(x), Ok(y)] if x < width && y < height && rows[y][x])
    };
    // The number of the polygon of each cell: the least of its cells, lowered until nothing changes.
    let all: Vec<Place> = (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .map(|(x, y)| [x, y].map(|c| i32::try_from(c).expect("few cells")))
        .filter(|&cell| is_in(cell))
        .collect();
    let mut number: BTreeMap<Place, usize> = all.iter().copied().zip(0..).collect();
    let beside = |[x, y]: Place| [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]];
    loop {
        let before = number.clone();
        for cell in &all {
            let least = beside(*cell)
                .iter()
                .filter_map(|other| number.get(other))
                .min()
                .copied();
            let own = number[cell];
            number.insert(*cell, own.min(least.unwrap_or(own)));
        }
        if number == before {
            break;
        }
    }
    // The sides that a cell has alone, with the cell on the left: from a place in a direction.
    let mut sides: BTreeMap<(Place, usize), usize> = BTreeMap::new();
    for &[x, y] in &all {
        let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
        let across = [[x, y - 1], [x + 1, y], [x, y + 1], [x - 1, y]];
        for way in 0..4 {
            if !is_in(across[way]) {
                sides.insert((corners[way], way), number[&[x, y]]);
            }
        }
    }
    const WAYS: [Place; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    let mut polygons: BTreeMap<usize, Vec<Vec<Place>>> = BTreeMap::new();
    while let Some((&first, &polygon)) = sides.iter().next() {
        let (mut ring, mut at) = (Vec::new(), first);
        let mut turns = 0;
        loop {
            sides.remove(&at);
            let (place, way) = at;
            let to = [0, 1].map(|i| place[i] + WAYS[way][i]);
            // A left turn stays at the cell.
            let turn = [1, 0, 3].into_iter().find(|turn| {
                let next = (to, (way + turn) % 4);
                next == first || sides.get(&next) == Some(&polygon)
            });
            let turn = turn.unwrap_or(0);
            turns += [0, 1, 0, -1][turn];
            let is_corner = turn != 0;
            if is_corner || style & 1 == 0 || style & 2 == 0 && (to[0] + to[1]) % 2 == 0 {
                ring.push(to);
            }
            at = (to, (way + turn) % 4);
            if at == first || !sides.contains_key(&at) {
                break;
            }
        }
        let rings = polygons.entry(polygon).or_default();
        if turns > 0 {
            rings.insert(0, ring)
        } else {
            rings.push(ring)
        }
    }
    Ok(polygons.into_values().collect())
}

/// Rings about the origin: along each of some directions a ring has a vertex, nearer than that of the ring before.
fn stars(may_touch: bool, bytes: &mut Unstructured<'_>) -> Result<Made> {
    // By angle; no two that follow each other at any byte are half a turn apart.
    const WAYS: [Place; 16] = [
        [1, 0],
        [3, 1],
        [2, 2],
        [1, 2],
        [0, 1],
        [-1, 3],
        [-1, 1],
        [-3, 1],
        [-1, 0],
        [-2, -1],
        [-1, -1],
        [-1, -3],
        [0, -1],
        [1, -2],
        [1, -1],
        [4, -1],
    ];
    let chosen = u16::from(byte(bytes)?) << 8 | u16::from(byte(bytes)?) | 0b0001_0001_0001_0001;
    let ways: Vec<Place> = (0..16)
        .filter(|i| chosen >> i & 1 == 1)
        .map(|i| WAYS[i])
        .collect();
    let levels = 1 + byte(bytes)? % 5;
    let mut far: Vec<i32> = Vec::new();
    for _ in &ways {
        far.push(8 + i32::from(byte(bytes)? % 24));
    }
    let mut made = Made::new();
    for level in 0..levels {
        if far.iter().any(|&far| far < 1) {
            break;
        }
        let mut ring: Vec<Place> = ways
            .iter()
            .zip(&far)
            .map(|(way, far)| way.map(|x| x * far))
            .collect();
        if level % 2 == 0 {
            made.push(vec![ring]);
        } else {
            ring.reverse();
            made.last_mut().expect("an outline came before").push(ring);
        }
        let touching = if may_touch {
            usize::from(byte(bytes)?)
        } else {
            usize::MAX
        };
        for (i, far) in far.iter_mut().enumerate() {
            *far -= if i == touching {
                0
            } else {
                1 + i32::from(byte(bytes)? % 8)
            };
        }
    }
    Ok(made)
}

/// A polygon between a lower and an upper chain with vertices at the same x.
fn strips(bytes: &mut Unstructured<'_>) -> Result<Made> {
    let columns = 2 + byte(bytes)? % 12;
    let (mut lower, mut upper): (Vec<Place>, Vec<Place>) = (Vec::new(), Vec::new());
    for column in 0..columns {
        let x = 4 * i32::from(column);
        let [low, gap] = [byte(bytes)?, byte(bytes)?].map(i32::from);
        // Often as low as the one before, so that three are on a line.
        let before = lower.last().map_or(0, |p| p[1]);
        let low = if low & 3 == 0 { before } else { low >> 3 };
        lower.push([x, low]);
        upper.push([x, low + 1 + (gap >> 2)]);
    }
    upper.reverse();
    lower.extend(upper);
    Ok(vec![vec![lower]])
}

/// Polygons of walks on a lattice, with a vertex halfway between its places too, so that all sides meet in vertices.
fn walks(bytes: &mut Unstructured<'_>) -> Result<Made> {
    const SIZE: i32 = 4;
    let mut made = Made::new();
    for _ in 0..1 + byte(bytes)? % 3 {
        let mut polygon = Vec::new();
        for _ in 0..1 + byte(bytes)? % 3 {
            let [x, y] = [byte(bytes)?, byte(bytes)?].map(|x| i32::from(x) % SIZE);
            let first = [2 * x, 2 * y];
            let mut ring = vec![first];
            for _ in 0..2 + byte(bytes)? % 5 {
                let step = i32::from(byte(bytes)?);
                let [x, y] = ring[ring.len() - 1];
                let way = [step % 3 - 1, step / 3 % 3 - 1];
                let far = 2 * (1 + step / 9 % 3);
                let is_on = |x: i32| (0..2 * SIZE - 1).contains(&x);
                if way != [0, 0] && is_on(x + far * way[0]) && is_on(y + far * way[1]) {
                    ring.extend((1..=far).map(|k| [x + k * way[0], y + k * way[1]]));
                }
            }
            // Back along a column and a row.
            for axis in [1, 0] {
                let mut at = ring[ring.len() - 1];
                while at[axis] != first[axis] {
                    at[axis] += (first[axis] - at[axis]).signum();
                    ring.push(at);
                }
            }
            if ring.len() > 1 {
                ring.pop();
            }
            polygon.push(ring);
        }
        made.push(polygon);
    }
    Ok(made)
}
