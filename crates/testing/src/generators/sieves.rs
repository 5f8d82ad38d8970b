//! Polygons with 0 to 20 holes, beside each other, in frames, and with polygons in their holes.
//!
//! A polygon is cut into square slots, with one hole in the middle of each. A hole, and what is nested in it, has its
//! vertices along the same directions from the middle, each ring nearer than the one before. A hole that touches has one
//! vertex moved: to the vertex of the hole on the left or below that points to it, or to the outline. So each ring touches
//! at most one that came before it, in one point, and what a polygon covers stays in one piece.

use arbitrary::{Result, Unstructured};

use super::bytes::{Made, Place, byte};

/// The width of a slot. Holes keep a unit away from its border.
const SLOT: i32 = 16;
/// The directions of the vertices of a hole, counter-clockwise.
const WAYS: [Place; 8] = [
    [1, 0],
    [1, 1],
    [0, 1],
    [-1, 1],
    [-1, 0],
    [-1, -1],
    [0, -1],
    [1, -1],
];
/// Triangles about the middle, as bits for the ways.
const TRIANGLES: [u8; 6] = [
    0b0101_0010,
    0b1001_0100,
    0b0100_1010,
    0b1001_0010,
    0b0010_1001,
    0b1010_0100,
];
/// How many holes a polygon has.
const HOLES: [u8; 16] = [0, 1, 1, 2, 2, 2, 3, 3, 3, 4, 5, 6, 8, 12, 17, 20];
/// The number of holes from which on they are triangles with nothing in them, for lack of points.
const MANY: u8 = 6;

/// Some polygons, and frames around all of them.
pub(super) fn sieves(may_touch: bool, bytes: &mut Unstructured<'_>) -> Result<Made> {
    let style = byte(bytes)?;
    let count = [1, 1, 1, 2, 2, 3, 4, 1][usize::from(style & 7)];
    let frames = [0, 0, 0, 1, 1, 2, 0, 0][usize::from(style >> 3 & 7)];
    let (mut made, mut islands) = (Made::new(), Made::new());
    let (mut corner, mut far) = ([0, 0], [0, 0]);
    for _ in 0..count {
        let size = polygon(may_touch, corner, bytes, &mut made, &mut islands)?;
        let end = [0, 1].map(|i| corner[i] + size[i]);
        far = [0, 1].map(|i| far[i].max(end[i]));
        corner = match byte(bytes)? & 3 {
            // A side in common, or a corner; or apart.
            0 if may_touch => [end[0], corner[1]],
            1 if may_touch => end,
            2 => [end[0] + 3, corner[1]],
            _ => [corner[0], far[1] + 2],
        };
    }
    let mut rings = Made::new();
    for frame in (0..frames).rev() {
        let around = |by: i32| {
            let [x, y] = far.map(|end| end + by);
            vec![[-by, -by], [x, -by], [x, y], [-by, y]]
        };
        let mut inner = around(2 + 4 * frame);
        inner.reverse();
        rings.push(vec![around(4 + 4 * frame), inner]);
    }
    // What is in frames and in holes is left out first, where there are too many points.
    rings.extend(made);
    rings.extend(islands);
    Ok(rings)
}

/// A polygon with holes from this corner on, and the polygons in them; returns its size.
fn polygon(
    may_touch: bool,
    [left, low]: Place,
    bytes: &mut Unstructured<'_>,
    made: &mut Made,
    islands: &mut Made,
) -> Result<Place> {
    let [number, style] = [byte(bytes)?, byte(bytes)?];
    let count = HOLES[usize::from(number & 15)];
    let columns = (1..5).find(|c| c * c >= count).unwrap_or(5);
    let [width, height] =
        [columns, count.div_ceil(columns).max(1)].map(|slots| SLOT * i32::from(slots));
    let size = if count >= MANY || style & 3 == 3 {
        [2 * width, 2 * height]
    } else {
        [width, height]
    };
    let [right, high] = [left + size[0], low + size[1]];
    let mut outline = vec![[left, low], [right, low], [right, high], [left, high]];
    if size[0] > width {
        outline.remove(2);
    }
    let mut holes: Vec<Hole> = Vec::new();
    let mut rings = Vec::new();
    for number in 0..count {
        let [form, nest, touch] = [byte(bytes)?, byte(bytes)?, byte(bytes)?];
        let place = [number % columns, number / columns];
        let mut hole = Hole::new(
            [0, 1].map(|i| [left, low][i] + SLOT * i32::from(place[i])),
            form,
        );
        if count < MANY && form & 64 != 0 {
            hole.ways |= nest;
        }
        let mut ring = hole.ring();
        // Where a vertex to the left, below or at the corner may be moved to.
        let before = |back: u8, way: usize| {
            let other = holes.get(usize::from(number.checked_sub(back)?))?;
            (other.ways >> way & 1 == 1).then(|| other.vertex(way))
        };
        let [x, y] = hole.middle;
        let targets = [
            (
                4,
                if place[0] == 0 {
                    Some([left, y])
                } else {
                    before(1, 0)
                },
            ),
            (
                6,
                if place[1] == 0 {
                    Some([x, low])
                } else {
                    before(columns, 2)
                },
            ),
            (5, (number == 0).then_some([left, low])),
        ];
        let is_asked = |(k, to): (usize, Option<Place>)| {
            let can_move = may_touch && touch >> (k - 4) & 1 == 1;
            let at = ring.iter().position(|&vertex| vertex == hole.vertex(k));
            Some((at.filter(|_| can_move)?, to?))
        };
        if let Some((at, to)) = targets.into_iter().find_map(is_asked) {
            ring[at] = to;
            // The outline has a vertex there, or not. Its left side runs down.
            let above = outline.iter().rposition(|p| p[0] == left && p[1] > to[1]);
            if let Some(above) = above.filter(|_| to[0] == left && to[1] > low && touch & 8 != 0) {
                outline.insert(above + 1, to);
            }
        }
        ring.reverse();
        rings.push(ring);
        // Polygons in the hole, and holes in them.
        let levels = if count < MANY {
            [0, 0, 1, 2, 1, 3, 0, 1][usize::from(nest & 7)]
        } else {
            0
        };
        let shared = if may_touch {
            usize::from(nest >> 3 & 15)
        } else {
            WAYS.len()
        };
        let mut nested = hole;
        for level in 0..levels {
            for (k, far) in nested.far.iter_mut().enumerate() {
                *far -= i32::from(k != shared);
            }
            let mut ring = nested.ring();
            if level % 2 == 0 {
                islands.push(vec![ring]);
            } else if let Some(island) = islands.last_mut() {
                ring.reverse();
                island.push(ring);
            }
        }
        holes.push(hole);
    }
    rings.insert(0, outline);
    made.push(rings);
    Ok(size)
}

/// Vertices about the middle of a slot.
#[derive(Clone, Copy)]
struct Hole {
    middle: Place,
    /// The ways that have a vertex, as bits.
    ways: u8,
    /// How far it is, from 4 to 7.
    far: [i32; WAYS.len()],
}

impl Hole {
    fn new(corner: Place, form: u8) -> Hole {
        Hole {
            middle: corner.map(|x| x + SLOT / 2),
            ways: TRIANGLES[usize::from(form) % TRIANGLES.len()],
            far: [0, 1, 4, 9, 16, 25, 36, 49].map(|square| 4 + (i32::from(form >> 3) + square) % 4),
        }
    }

    fn vertex(&self, way: usize) -> Place {
        [0, 1].map(|i| self.middle[i] + WAYS[way][i] * self.far[way])
    }

    /// Counter-clockwise.
    fn ring(&self) -> Vec<Place> {
        let chosen = (0..WAYS.len()).filter(|way| self.ways >> way & 1 == 1);
        chosen.map(|way| self.vertex(way)).collect()
    }
}
