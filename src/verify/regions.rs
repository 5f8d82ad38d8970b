//! Check 9: triangles have the attributes of their regions, as Triangle gives them (its option `-A`).
//! The constrained sides cut the triangles into *faces*: what is reached without passing one. A region is named by a
//! point in it, its *seed*. All triangles of the face that holds the seed must have the region's attribute, and
//! triangles of a face without a seed 0. So it is enough to flood the faces, and to know in which triangle each seed
//! lies. The check is made only for a constrained triangulation: otherwise there are no faces.
//! Cost: O(n + k) for n triangles and k seeds, 16 bytes a triangle.

use super::report::Record;
use super::sides::Sides;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;

/// Attributes of triangles, and for each region the triangle of its seed and its attribute.
pub(super) type Regions<'a> = (&'a [f64], &'a [(usize, f64)]);

pub(super) fn check<S: Scalar>(
    soup: &Soup<'_, S>,
    sides: &Sides,
    (attributes, seeds): Regions<'_>,
    record: &mut Record,
) {
    if !record.findings.is_sound() {
        return;
    }
    let (faces, count) = faces(soup, sides);
    let mut face_of = vec![0; faces.len()];
    for (t, face) in faces.into_iter().enumerate() {
        face_of[soup.number(t)] = face;
    }
    let mut wanted = vec![0.0; count];
    for &(triangle, attribute) in seeds {
        if let Some(&face) = face_of.get(triangle) {
            wanted[face] = attribute;
        }
    }
    for (triangle, &face) in face_of.iter().enumerate() {
        if attributes.get(triangle) != Some(&wanted[face]) {
            record.findings.add(Violation::WrongRegion { triangle });
        }
    }
}

/// For each triangle the number of its face, and how many faces there are.
fn faces<S: Scalar>(soup: &Soup<'_, S>, sides: &Sides) -> (Vec<usize>, usize) {
    let mut faces: Vec<Option<usize>> = vec![None; soup.triangles.len()];
    let mut count = 0;
    let mut waiting = Vec::new();
    for first in 0..faces.len() {
        waiting.push(first);
        let is_new = faces[first].is_none();
        while let Some(t) = waiting.pop() {
            if faces[t].is_some() {
                continue;
            }
            faces[t] = Some(count);
            let twins = (3 * t..3 * t + 3).filter_map(|side| sides.free_twin(side));
            waiting.extend(twins.map(|twin| twin / 3));
        }
        count += usize::from(is_new);
    }
    let faces = faces.into_iter();
    let faces = faces.map(|face| face.expect("each triangle was a first one"));
    (faces.collect(), count)
}
