//! Polygons whose vertices lie on circles, triangles about one vertex, and teeth along a straight side.
//!
//! The circles have many whole places: those of 5, 25 and 65 about one middle have 12, 20 and 36. No side of a ring leaves
//! out more than two of them, so that each ring surrounds the next one.

use arbitrary::{Result, Unstructured};

use super::bytes::{Made, Place, byte};

/// From this style on there are no polygons at all.
const NOTHING: u8 = 240;

/// Polygons of one of these forms; those that touch only where they may.
pub(super) fn wheels(may_touch: bool, bytes: &mut Unstructured<'_>) -> Result<Made> {
    let style = byte(bytes)?;
    match style & 3 {
        _ if style >= NOTHING => Ok(Made::new()),
        2 if may_touch => sectors(bytes),
        3 if may_touch => teeth(bytes),
        _ => discs(style >> 2, bytes),
    }
}

/// The whole places at this squared distance from the origin, counter-clockwise from the right: 12 for 25.
pub fn around(square: i32) -> Vec<Place> {
    let root = square.isqrt();
    let above = (-root..=root)
        .rev()
        .map(|x| [x, (square - x * x).isqrt()])
        .filter(|[x, y]| x * x + y * y == square && (*y > 0 || *x > 0));
    let mut places: Vec<Place> = above.collect();
    places.extend(places.clone().iter().map(|place| place.map(|x| -x)));
    places
}

/// A disc, or one with a hole, in which there may be a disc.
fn discs(style: u8, bytes: &mut Unstructured<'_>) -> Result<Made> {
    const RADII: [i32; 3] = [65, 25, 5];
    let first = usize::from(style % 3);
    let end = if style & 8 == 0 {
        first + 1
    } else {
        RADII.len()
    };
    let mut made = Made::new();
    for (level, radius) in RADII[first..end].iter().enumerate() {
        let places = around(radius * radius);
        let (mut ring, mut at) = (Vec::new(), 0);
        while at < places.len() {
            ring.push(places[at]);
            at += 1 + usize::from(byte(bytes)? % 3);
        }
        if level % 2 == 0 {
            made.push(vec![ring]);
        } else if let Some(outline) = made.last_mut() {
            ring.reverse();
            outline.push(ring);
        }
    }
    Ok(made)
}

/// Triangles about one vertex, with gaps between them or without.
fn sectors(bytes: &mut Unstructured<'_>) -> Result<Made> {
    let places = around(625);
    let (mut made, mut at) = (Made::new(), 0);
    while at + 1 < places.len() {
        let form = usize::from(byte(bytes)?);
        let end = at + 1 + (form & 1);
        made.push(vec![vec![[0, 0], places[at], places[end % places.len()]]]);
        at = end + (form >> 1 & 1);
    }
    Ok(made)
}

/// A bar, and along its upper side triangles that stand on it, on a corner or a side, and holes that reach up to it.
fn teeth(bytes: &mut Unstructured<'_>) -> Result<Made> {
    const HIGH: i32 = 4;
    let count = 3 + i32::from(byte(bytes)? % 5);
    let right = 4 * count;
    let (mut bar, mut teeth) = (
        vec![vec![[0, 0], [right, 0], [right, HIGH], [0, HIGH]]],
        Made::new(),
    );
    for tooth in 0..count {
        let [left, middle, right] = [1, 2, 3].map(|x| 4 * tooth + x);
        match byte(bytes)? % 5 {
            0 => {}
            1 | 2 => bar.push(vec![[left, 1], [middle, HIGH], [right, 1]]),
            3 => teeth.push(vec![vec![[left, HIGH], [right, HIGH], [middle, HIGH + 3]]]),
            _ => teeth.push(vec![vec![
                [middle, HIGH],
                [right, HIGH + 3],
                [left, HIGH + 3],
            ]]),
        }
    }
    teeth.insert(0, bar);
    Ok(teeth)
}

#[test]
fn circles_have_their_places_counter_clockwise() {
    for (square, count) in [(25, 12), (325, 24), (625, 20), (4225, 36)] {
        let places = around(square);
        assert_eq!(places.len(), count);
        for at in 0..count {
            let ([a, b], [c, d]) = (places[at], places[(at + 1) % count]);
            assert!(a * a + b * b == square && a * d > b * c, "{places:?}");
        }
    }
}
