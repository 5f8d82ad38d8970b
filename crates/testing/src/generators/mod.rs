//! Bytes into degenerate inputs, and back.
//!
//! The first byte picks the [`Shape`] of the points, the second the [`Pattern`] of the edges and the
//! disguise, the third how many points there are; one to four bytes make a point, and what is left makes
//! edges, so a small change of the bytes is a small change of the input. Where the bytes run out, the list
//! that they were read for ends. Every sequence of bytes is an input.
//!
//! [`polygons()`] makes polygons with holes out of bytes. Where the first byte is large, the input has the sides of
//! their rings as edges.
//!
//! An input has at most [`POINTS`] points, so that every exact check of it ends soon. [`medium`] makes larger ones.

mod bytes;
mod edges;
mod points;
mod polygons;
mod sieves;
mod wheels;

use arbitrary::{Result, Unstructured};

pub use bytes::{BYTES, EDGES, FAR_POINTS, POINTS};
pub use edges::{Pattern, drop_crossings};
pub use points::Shape;
pub use polygons::{Polygons, Rings, polygons};
pub use wheels::around;

use sweep_cdt_generate::Random;

use crate::Input;

/// The input that these bytes stand for.
pub fn input(bytes: &[u8]) -> Input {
    // Reading is total but for a type that has no values.
    read(&mut Unstructured::new(bytes)).unwrap_or_default()
}

/// A number out of the first eight bytes, for what a property chooses itself, and the input that the others
/// stand for.
pub fn input_with_choices(bytes: &[u8]) -> (u64, Input) {
    let mut bytes = Unstructured::new(bytes);
    // Reading is total but for a type that has no values.
    let choices = bytes.arbitrary().unwrap_or_default();
    (choices, read(&mut bytes).unwrap_or_default())
}

/// Takes an input out of the bytes, all of which it uses.
///
/// # Errors
/// None in practice; see [`Unstructured`].
pub fn read(bytes: &mut Unstructured<'_>) -> Result<Input> {
    Ok(read_named(bytes)?.1)
}

/// [`read`], and the name of the shape.
///
/// # Errors
/// None in practice; see [`Unstructured`].
pub fn read_named(bytes: &mut Unstructured<'_>) -> Result<(&'static str, Input)> {
    let byte: u8 = bytes.arbitrary()?;
    if byte >= RINGED {
        return Ok(("rings", ringed(byte, bytes)?));
    }
    let shape = Shape::of(byte);
    Ok((shape.name(), read_shape(shape, bytes)?))
}

/// From this first byte on the edges of an input are the sides of rings.
pub const RINGED: u8 = 160;

/// Reads an input whose edges are the sides of rings of polygons, and some others every fourth time.
fn ringed(shape: u8, bytes: &mut Unstructured<'_>) -> Result<Input> {
    let (style, n): (u8, u8) = bytes.arbitrary()?;
    let most = match usize::from(n) {
        n if n > 2 * POINTS => POINTS,
        n => RINGS + 2 * n % (POINTS + 1 - RINGS),
    };
    let with_others = style & 3 == 3;
    let (mut points, rings) = polygons(Rings::of(shape, with_others), true, most, bytes)?;
    let sides = rings.iter().flatten().flat_map(|ring| ring_sides(ring));
    let mut edges: Vec<[usize; 2]> = sides.collect();
    if with_others {
        let pattern = Pattern::ALL[usize::from(style >> 2 & 7)];
        edges.extend(edges::read(pattern, &points, bytes)?);
        edges.truncate(EDGES);
        drop_crossings(&points, &mut edges);
    }
    disguise(style >> 5, &mut points);
    Ok(Input { points, edges })
}

/// Rings have at most so many points where there are few: a quadrangle with four triangles as holes.
const RINGS: usize = 16;

/// The sides of a ring.
pub fn ring_sides(ring: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])
}

/// Reads an input with points of a given shape.
///
/// # Errors
/// None in practice; see [`Unstructured`].
pub fn read_shape(shape: Shape, bytes: &mut Unstructured<'_>) -> Result<Input> {
    let style: u8 = bytes.arbitrary()?;
    let n = usize::from(bytes.arbitrary::<u8>()?);
    let (mut points, mut edges) = points::read(shape, n % (POINTS + 1), bytes)?;
    let pattern = Pattern::ALL[usize::from(style & 7)];
    edges.extend(edges::read(pattern, &points, bytes)?);
    edges.truncate(EDGES);
    // One in four keeps the edges that cross.
    if style >> 3 & 3 != 0 {
        drop_crossings(&points, &mut edges);
    }
    disguise(style >> 5, &mut points);
    Ok(Input { points, edges })
}

/// So far below 1 that products of four differences, but not of two, underflow.
const TINY: i32 = -266;

/// Mirrors, turns by 90 degrees, or multiplies by a power of two, all exactly; or makes all points tiny and
/// adds one far away, so that no common factor makes them large again.
fn disguise(kind: u8, points: &mut Vec<[f64; 2]>) {
    let change = |[x, y]: [f64; 2]| match kind {
        1 => [-x, y],
        2 => [y, -x],
        3 => [y, x],
        4 => [-x, -y],
        5 => [x * 2f64.powi(-40), y * 2f64.powi(-40)],
        6 => [x * 2f64.powi(130), y * 2f64.powi(130)],
        7 => [x * 2f64.powi(TINY), y * 2f64.powi(TINY)],
        _ => [x, y],
    };
    let changed: Vec<[f64; 2]> = points.iter().copied().map(change).collect();
    // What would overflow, or lose digits, stays as it is.
    let scale = 2f64.powi([0, 0, 0, 0, 0, 40, -130, -TINY][usize::from(kind)]);
    let is_exact = changed
        .iter()
        .flatten()
        .zip(points.iter().flatten())
        .all(|(new, old)| kind < 5 || (new * scale).to_bits() == old.to_bits());
    let is_small = points.len() < FAR_POINTS;
    if is_exact && (kind < 7 || is_small) {
        *points = changed;
        points.extend((kind == 7).then_some([1.0, 0.5]));
    }
}

/// A small degenerate input out of random bytes, of up to about a dozen points.
pub fn small(random: &mut Random) -> Input {
    let mut bytes = random.bytes(5);
    // The third byte is the number of points.
    bytes[2] %= 13;
    let more = 4 + random.below(40);
    bytes.extend(random.bytes(more));
    input(&bytes)
}

/// Uniform points, a lattice, few columns or few rows, with a few long edges and many short ones that
/// do not cross: hundreds of both, pseudo-polygons full of edges that end in them.
pub fn medium(random: &mut Random) -> Input {
    let (width, height) = random.pick(&[(1 << 20, 1 << 20), (9, 9), (40, 15), (3, 200), (200, 3)]);
    let n = 100 + random.below(300);
    let mut input = Input::default();
    for _ in 0..n {
        input
            .points
            .push([random.integer(width), random.integer(height)]);
    }
    for _ in 0..random.below(8) {
        input.edges.push([random.below(n), random.below(n)]);
    }
    let tries = random.pick(&[1, 5, 50]);
    for _ in 0..random.below(n) {
        let a = random.below(n);
        let distance = |b: usize| {
            let [x, y] = [0, 1].map(|i| input.points[a][i] - input.points[b][i]);
            x.hypot(y)
        };
        let others: Vec<usize> = (0..tries)
            .map(|_| random.below(n))
            .filter(|&b| b != a)
            .collect();
        let nearest = others
            .into_iter()
            .min_by(|&b, &c| distance(b).total_cmp(&distance(c)));
        input.edges.extend(nearest.map(|b| [a, b]));
    }
    drop_crossings(&input.points, &mut input.edges);
    input
}

/// Bytes that stand for this input, for seeds made of inputs that are known to be hard, if there are any: few points, or small integers; few edges.
pub fn encode(wanted: &Input) -> Option<Vec<u8>> {
    [Shape::General, Shape::Raw].into_iter().find_map(|shape| {
        let bytes = written(shape, wanted)?;
        let found = input(&bytes);
        (found.to_string() == wanted.to_string()).then_some(bytes)
    })
}

fn written(shape: Shape, Input { points, edges }: &Input) -> Option<Vec<u8>> {
    let most = if shape == Shape::Raw {
        FAR_POINTS
    } else {
        POINTS
    };
    if points.len() > most || edges.len() > EDGES {
        return None;
    }
    let shape_byte = Shape::ALL.iter().position(|&other| other == shape)?;
    // Any two points, crossing edges kept, no disguise.
    let style = Pattern::ALL
        .iter()
        .position(|&other| other == Pattern::Pairs)?;
    let mut bytes = vec![
        u8::try_from(shape_byte).ok()?,
        u8::try_from(style).ok()?,
        u8::try_from(points.len()).ok()?,
    ];
    for x in points.iter().flatten() {
        if shape == Shape::Raw {
            bytes.extend(x.to_bits().to_le_bytes());
        } else {
            // The comparison afterwards notices what does not fit.
            bytes.extend((*x as i16).to_le_bytes());
        }
    }
    // The hub, which pairs do not use.
    bytes.push(0);
    for &end in edges.iter().flatten() {
        bytes.push(u8::try_from(end).ok()?);
    }
    Some(bytes)
}

#[test]
fn what_is_encoded_is_read_back() {
    let lattice = Input::parse("0 0, 3 0, 3 2, -5 7", "0 2, 1 3");
    let extreme = Input::parse("0 0, 1e308 5e-324, -0.1 0.30000000000000004", "2 1");
    for wanted in [lattice, extreme] {
        let bytes = encode(&wanted).expect("few points");
        assert_eq!(input(&bytes).to_string(), wanted.to_string());
    }
    assert!(encode(&Input::parse("1e9 0, 0 0, 0 1", "0 7")).is_none());
}
