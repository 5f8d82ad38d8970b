//! Certificates: the input, the triangles and hints, from which a proved checker sees that a result is right.
//!
//! The format is that of `proof/certificate.md`. The verdict is about the points, edges and polygons in the file:
//! coordinates as integers times one power of two, which must be the caller's exactly. A fault in anything else makes the
//! checker refuse, never accept. The hints are the chain of points along each edge, the lower hull, the sides that are
//! pieces of edges, an order of the triangles, and, where not all are inside, how often the edges go round each triangle,
//! or the rings of polygons that run along the sides below it.
//!
//! ```text
//!        .-----------.          A side that leads to a later point, counterclockwise, is a *lower* side of its
//!       / \         / \         triangle (*later* is meant in the order (x, y)). The neighbour across a lower
//!      /   \  2    /   \        side is listed before: 0 and 1 before 2. So the triangles read so far always
//!     /  0  \     /  1  \       have an upper border that goes from left to right.
//!    '-------'---'-------'
//! ```
//!
//! Cost: O(n log n) for n points, edges and triangles, by sorts; 80 bytes a triangle, and the integers. With polygons 8
//! bytes for each side along an edge more.

use std::collections::BTreeMap;
use std::io::{self, Write};

use sweep_cdt::interior::Ring;

use super::certificate_numbers::{least_exponent, push_integer};
use super::certificate_tiling::{Tiling, Values};
use crate::{Coordinate, Polygons};

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
/// assert!(text.starts_with("sweep-cdt-certificate 3\nexponent -1\ndomain hull\np 0 0\np 1 0\np 0 4\ne 0 1\n"));
/// assert!(text.ends_with("l 0 1\nt 0 1 2 1\nend\n"));
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
    let exponent = least_exponent(points)?;
    let (mut tiling, positions) = Tiling::new(points, triangles).ok_or_else(wrong)?;
    let is_inside = |t: usize| is_inside(positions[t] as usize);
    let ring = |edge: usize| polygons.and_then(|polygons| *polygons.ring_of.get(edge)?);
    let chains = edges.iter().enumerate();
    let chains = chains.map(|(edge, &ends)| tiling.chain(ends, ring(edge)));
    let chains = chains
        .collect::<Option<Vec<Vec<u32>>>>()
        .ok_or_else(wrong)?;
    let (lower, order) = tiling.in_order().ok_or_else(wrong)?;
    let values = match polygons {
        None => Some(tiling.values(is_inside).ok_or_else(other_interior)?),
        Some(polygons) if tiling.are_covered(&polygons.rings, is_inside) => None,
        Some(_) => return Err(other_interior()),
    };

    writeln!(out, "sweep-cdt-certificate 3")?;
    writeln!(out, "exponent {exponent}")?;
    let domain = match &values {
        None => "polygons",
        Some(Values::Hull) => "hull",
        Some(Values::EvenOdd(_)) => "even-odd",
        Some(Values::NonZero(_)) => "nonzero",
    };
    writeln!(out, "domain {domain}")?;
    if let Some(polygons) = polygons {
        write_polygons(&polygons.rings, out)?;
    }
    let mut lines = Lines::new(out);
    for [x, y] in points {
        lines.text.extend_from_slice(b"p ");
        push_integer(x, exponent, &mut lines.text)?;
        lines.text.push(b' ');
        push_integer(y, exponent, &mut lines.text)?;
        lines.end()?;
    }
    for (edge, ([from, to], chain)) in edges.iter().zip(&chains).enumerate() {
        lines.text.push(b'e');
        match (polygons, ring(edge)) {
            (None, _) => {}
            (_, None) => lines.text.extend_from_slice(b" -"),
            (_, Some(ring)) => {
                lines.next(ring);
            }
        }
        lines.next(*from);
        for point in chain {
            lines.next(*point);
        }
        lines.next(*to).end()?;
    }
    for side in lower.windows(2) {
        lines.text.push(b'l');
        lines.next(side[0]).next(side[1]).end()?;
    }
    let marks = tiling.marks();
    for t in order {
        let [a, b, c] = tiling.triangle(t);
        lines.text.push(b't');
        lines.next(a).next(b).next(c).next(marks[t as usize]);
        match &values {
            Some(Values::Hull) => {}
            Some(Values::EvenOdd(windings) | Values::NonZero(windings)) => {
                lines.next(windings[t as usize]);
            }
            None => {
                lines.next(u8::from(is_inside(t as usize)));
                let mut last = "";
                for (side, ring) in tiling.rings_below(t) {
                    if side != last {
                        lines.text.extend_from_slice(side.as_bytes());
                        last = side;
                    }
                    lines.next(ring);
                }
            }
        }
        lines.end()?;
    }
    lines.text.extend_from_slice(b"end\n");
    lines.finish()
}

/// Lines of numbers on their way out.
struct Lines<'a, W> {
    text: Vec<u8>,
    out: &'a mut W,
}

impl<'a, W: Write> Lines<'a, W> {
    const ROOM: usize = 1 << 16;

    fn new(out: &'a mut W) -> Self {
        let text = Vec::with_capacity(2 * Self::ROOM);
        Lines { text, out }
    }

    fn next(&mut self, number: impl itoa::Integer) -> &mut Self {
        self.text.push(b' ');
        let mut digits = itoa::Buffer::new();
        self.text
            .extend_from_slice(digits.format(number).as_bytes());
        self
    }

    fn end(&mut self) -> io::Result<()> {
        self.text.push(b'\n');
        if self.text.len() >= Self::ROOM {
            self.out.write_all(&self.text)?;
            self.text.clear();
        }
        Ok(())
    }

    fn finish(self) -> io::Result<()> {
        self.out.write_all(&self.text)
    }
}

/// The rings of each polygon, by their positions.
fn write_polygons(rings: &[Ring], out: &mut impl Write) -> io::Result<()> {
    let mut polygons: BTreeMap<usize, [Vec<usize>; 2]> = BTreeMap::new();
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

pub(super) fn wrong() -> io::Error {
    let why =
        "the triangles do not tile the hull with all edges, so that there is nothing to certify";
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

fn other_interior() -> io::Error {
    let why = "a certificate is of what is inside by the rule hull, polygons, even-odd or nonzero, and by none of these the same is \
               inside: `triangulate --inside hull` keeps all";
    io::Error::new(io::ErrorKind::InvalidInput, why)
}
