//! Lists of points out of bytes.

use arbitrary::{Result, Unstructured};

pub(super) type Points = Vec<[f64; 2]>;

/// Up to `n` points, as long as there are bytes.
pub(super) fn each(
    n: usize,
    bytes: &mut Unstructured<'_>,
    mut point: impl FnMut(usize, &mut Unstructured<'_>) -> Result<[f64; 2]>,
) -> Result<Points> {
    let mut points = Points::new();
    while points.len() < n && !bytes.is_empty() {
        points.push(point(points.len(), bytes)?);
    }
    Ok(points)
}
