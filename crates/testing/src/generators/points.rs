//! The points of an input, and the edges that come with some of them.

use arbitrary::{Result, Unstructured};

use super::bytes::{FAR_POINTS, MAGNITUDES, Points, byte, each, integer, nudged, rounded, wide};
use super::wheels::around;

/// Special positions of the points of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Nothing: integers of 16 bits.
    General,
    /// A corner of the integer lattice: cocircular squares, collinear rows, duplicates.
    Lattice,
    /// Two to four different x: left cases of the point event, vertical edges.
    Columns,
    /// Two to four different y: ties of the sweep order, flat hulls, horizontal edges.
    Rows,
    /// On one to three circles about one centre, with integer coordinates: the canonical rule, whole
    /// fans of ties.
    Circle,
    /// Points exactly inside the segments between earlier ones: vertices on edges, split edges.
    OnSegments,
    /// Steps along one line, with a few points beside it: flat triangles, overlapping edges.
    Line,
    /// A parabola, steep or flat: every corner of the front convex, flips without end, and long convex
    /// stretches for the upper hull and for pockets.
    Parabola,
    /// Teeth that alternate high and low: deep pockets, long edges that switch between triangles and front.
    Comb,
    /// Left and right in turn, rising: each point event spans the whole front.
    Alternating,
    /// Ever closer to one place, and far outliers: defeats buckets of equal width.
    Cluster,
    /// Spokes about a hub in few directions: shared ends, edges that overlap from their end on.
    Star,
    /// Small polygons on a lattice, with their edges: holes, polygons that touch at a vertex or along
    /// an edge.
    Polygons,
    /// Lattice, circle, line or segments moved by a few units in the last place, or a circle or segment
    /// as rounding leaves it: the exact stages of the predicates with either sign and zero.
    Nudged,
    /// Small multiples of magnitudes over the whole range of doubles, subnormals included.
    Magnitudes,
    /// Any finite doubles.
    Raw,
    /// On one circle with whole coordinates, one after the other, and nothing in it: ties without end.
    Round,
    /// All on one line.
    Flat,
}

impl Shape {
    /// Each of them.
    pub const ALL: &[Shape] = &[
        Shape::General,
        Shape::Lattice,
        Shape::Columns,
        Shape::Rows,
        Shape::Circle,
        Shape::OnSegments,
        Shape::Line,
        Shape::Parabola,
        Shape::Comb,
        Shape::Alternating,
        Shape::Cluster,
        Shape::Star,
        Shape::Polygons,
        Shape::Nudged,
        Shape::Magnitudes,
        Shape::Raw,
        Shape::Round,
        Shape::Flat,
    ];

    /// The shape that a byte picks: as a rule one of the first sixteen.
    pub fn of(byte: u8) -> Shape {
        match byte {
            144..=155 => Shape::Round,
            156..=159 => Shape::Flat,
            _ => Shape::ALL[usize::from(byte % 16)],
        }
    }

    /// The name.
    pub fn name(self) -> &'static str {
        match self {
            Shape::General => "general",
            Shape::Lattice => "lattice",
            Shape::Columns => "columns",
            Shape::Rows => "rows",
            Shape::Circle => "circle",
            Shape::OnSegments => "on-segments",
            Shape::Line => "line",
            Shape::Parabola => "parabola",
            Shape::Comb => "comb",
            Shape::Alternating => "alternating",
            Shape::Cluster => "cluster",
            Shape::Star => "star",
            Shape::Polygons => "polygons",
            Shape::Nudged => "nudged",
            Shape::Magnitudes => "magnitudes",
            Shape::Raw => "raw",
            Shape::Round => "round",
            Shape::Flat => "flat",
        }
    }
}

type Edges = Vec<[usize; 2]>;

/// Up to `n` points of this shape, and the edges that belong to it.
pub(super) fn read(
    shape: Shape,
    n: usize,
    bytes: &mut Unstructured<'_>,
) -> Result<(Points, Edges)> {
    if shape == Shape::Polygons {
        return polygons(n, bytes);
    }
    let points = match shape {
        Shape::General => each(n, bytes, |_, b| Ok([wide(b)?, wide(b)?]))?,
        Shape::Lattice => {
            let size = 2 + byte(bytes)? % 14;
            each(n, bytes, |_, b| {
                let place = byte(b)?;
                Ok([place % size, (place >> 4) % size].map(f64::from))
            })?
        }
        Shape::Columns => each(n, bytes, |_, b| {
            let place = byte(b)?;
            Ok([place & 3, place >> 2].map(f64::from))
        })?,
        Shape::Rows => each(n, bytes, |_, b| {
            let place = byte(b)?;
            Ok([place >> 2, place & 3].map(f64::from))
        })?,
        Shape::Circle => circle(n, bytes)?,
        Shape::OnSegments => on_segments(n, bytes)?,
        Shape::Line => line(n, 32, bytes)?,
        Shape::Flat => line(n, 0, bytes)?,
        Shape::Round => round(n, bytes)?,
        Shape::Parabola => {
            let flatness = 2f64.powi(-i32::from(byte(bytes)? & 15));
            each(n, bytes, |_, b| {
                integer(b, 60).map(|x| [x, x * x * flatness])
            })?
        }
        Shape::Comb => each(n, bytes, |i, b| {
            let height = if i % 2 == 0 { 100.0 } else { 0.0 };
            Ok([2.0 * count(i), height + integer(b, 12)?])
        })?,
        Shape::Alternating => each(n, bytes, |i, b| {
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let step = byte(b)?;
            Ok([
                side * (64.0 + f64::from(step >> 4)),
                count(i) + f64::from(step & 1),
            ])
        })?,
        Shape::Cluster => each(n, bytes, |_, b| {
            let place = byte(b)?;
            let x = 2f64.powi(-i32::from(place & 31));
            Ok(match place >> 5 {
                0 => [1e6 * x, -1e6],
                1 => [-1e6, 1e6 * x],
                height => [x, f64::from(height)],
            })
        })?,
        Shape::Star => each(n, bytes, |_, b| {
            const WAYS: [[f64; 2]; 8] = [
                [1.0, 0.0],
                [2.0, 1.0],
                [0.0, 1.0],
                [-1.0, 1.0],
                [-1.0, 0.0],
                [-1.0, -2.0],
                [0.0, -1.0],
                [3.0, -1.0],
            ];
            let place = byte(b)?;
            let far = f64::from(place >> 3);
            Ok(WAYS[usize::from(place & 7)].map(|x| x * far))
        })?,
        Shape::Nudged => moved(n, bytes)?,
        Shape::Magnitudes => {
            let palette = [byte(bytes)?, byte(bytes)?].map(usize::from);
            let sizes = [
                palette[0] & 15,
                palette[0] >> 4,
                palette[1] & 15,
                palette[1] >> 4,
            ]
            .map(|i| MAGNITUDES[i]);
            each(n.min(FAR_POINTS), bytes, |_, b| {
                let number =
                    |place: u8| (f64::from(place & 7) - 3.0) * sizes[usize::from(place >> 3) & 3];
                Ok([number(byte(b)?), number(byte(b)?)])
            })?
        }
        Shape::Raw => each(n.min(FAR_POINTS), bytes, |_, b| {
            let number = |bits: u64| {
                Some(f64::from_bits(bits))
                    .filter(|x| x.is_finite())
                    .unwrap_or(0.0)
            };
            Ok([number(b.arbitrary()?), number(b.arbitrary()?)])
        })?,
        Shape::Polygons => Points::new(),
    };
    Ok((points, Edges::new()))
}

fn count(i: usize) -> f64 {
    f64::from(u32::try_from(i).unwrap_or(u32::MAX))
}

/// Points with integer coordinates whose squared distance from the origin is `square`.
fn on_circle(square: i32) -> Vec<[f64; 2]> {
    let root = square.isqrt();
    let mut points = Vec::new();
    for x in -root..=root {
        let y = (square - x * x).isqrt();
        if x * x + y * y == square {
            points.push([x, y].map(f64::from));
            if y > 0 {
                points.push([x, -y].map(f64::from));
            }
        }
    }
    points
}

fn circle(n: usize, bytes: &mut Unstructured<'_>) -> Result<Points> {
    let kind = byte(bytes)?;
    let centre = if kind & 4 == 0 {
        [0.0, 0.0]
    } else {
        [wide(bytes)?, wide(bytes)?]
    };
    // 12, 20 and 32 points, then circles with a common centre, once inside each other.
    let mut places = match kind & 3 {
        0 => on_circle(25),
        1 => on_circle(325),
        2 => on_circle(1105),
        _ => [on_circle(25), on_circle(100), on_circle(625)].concat(),
    };
    places.push([0.0, 0.0]);
    each(n, bytes, |_, b| {
        let place = places[usize::from(byte(b)?) % places.len()];
        Ok([centre[0] + place[0], centre[1] + place[1]])
    })
}

fn round(n: usize, bytes: &mut Unstructured<'_>) -> Result<Points> {
    let kind = byte(bytes)?;
    let places = around([25, 325, 625, 4225][usize::from(kind & 3)]);
    let mut at = usize::from(kind >> 2);
    each(n.min(places.len()), bytes, |_, b| {
        at += 1 + usize::from(byte(b)? % 3);
        Ok(places[at % places.len()].map(f64::from))
    })
}

/// Three or more places far apart, and points at exact eighths of the way between two earlier ones.
fn on_segments(n: usize, bytes: &mut Unstructured<'_>) -> Result<Points> {
    let mut points = Points::new();
    while points.len() < n && !bytes.is_empty() {
        let place = byte(bytes)?;
        if points.len() < 3 || place & 3 == 0 {
            let [x, y] = [place >> 2 & 7, place >> 5].map(f64::from);
            points.push([4096.0 * x, 4096.0 * y]);
        } else {
            let from = points[usize::from(place >> 2 & 7) % points.len()];
            let to = points[usize::from(byte(bytes)?) % points.len()];
            let eighths = f64::from(1 + (place >> 5));
            // Exact: multiples of 4096 divided by 8 up to four times.
            let part = [0, 1].map(|i| from[i] + (to[i] - from[i]) * eighths / 8.0);
            points.push(part);
        }
    }
    Ok(points)
}

/// Points on a line; those of bytes below `beside` are anywhere.
fn line(n: usize, beside: u8, bytes: &mut Unstructured<'_>) -> Result<Points> {
    let step = [integer(bytes, 3)?, integer(bytes, 3)?];
    each(n, bytes, |_, b| {
        let place = byte(b)?;
        if place < beside {
            return Ok([place & 7, place >> 3].map(f64::from));
        }
        let k = f64::from(place) - 144.0;
        Ok([k * step[0], k * step[1]])
    })
}

/// Another shape, scaled and moved by a few units in the last place.
fn moved(n: usize, bytes: &mut Unstructured<'_>) -> Result<Points> {
    const BASES: [Shape; 4] = [
        Shape::Lattice,
        Shape::Circle,
        Shape::Line,
        Shape::OnSegments,
    ];
    const SCALES: [f64; 4] = [1.0, 0.1, 1.0 / 3.0, 1e-9];
    let kind = byte(bytes)?;
    let scale = SCALES[usize::from(kind >> 2 & 3)];
    let offset = if kind & 16 == 0 { 0.0 } else { 1e6 };
    let mut points = if kind & 32 == 0 {
        read(BASES[usize::from(kind & 3)], n, bytes)?.0
    } else {
        rounded(kind & 1 == 0, n, bytes)?
    };
    for point in &mut points {
        let steps = byte(bytes)?;
        let steps = [steps & 7, steps >> 3 & 7];
        for i in 0..2 {
            // Mostly none, and up to two either way.
            let by = [0, 0, 0, 0, 1, -1, 2, -2][usize::from(steps[i])];
            point[i] = nudged(point[i] * scale + offset, by);
        }
    }
    Ok(points)
}

/// Triangles, squares and diamonds of a few sizes on a lattice, each with the edges around it.
fn polygons(n: usize, bytes: &mut Unstructured<'_>) -> Result<(Points, Edges)> {
    const OUTLINES: [&[[f64; 2]]; 4] = [
        &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        &[[1.0, 0.0], [2.0, 1.0], [1.0, 2.0], [0.0, 1.0]],
        &[[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]],
        &[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 1.0], [0.0, 2.0]],
    ];
    let (mut points, mut edges) = (Points::new(), Edges::new());
    while points.len() + 5 <= n && !bytes.is_empty() {
        let [kind, place] = [byte(bytes)?, byte(bytes)?];
        let outline = OUTLINES[usize::from(kind & 3)];
        let size = f64::from(1 << (kind >> 2 & 3));
        let corner = [place & 15, place >> 4].map(f64::from);
        let first = points.len();
        points.extend(
            outline
                .iter()
                .map(|p| [0, 1].map(|i| corner[i] + size * p[i])),
        );
        let k = outline.len();
        edges.extend((0..k).map(|i| [first + i, first + (i + 1) % k]));
    }
    Ok((points, edges))
}
