//! The triangles around each vertex, counter-clockwise.
//!
//! Why it is right: for each vertex one triangle is kept. If the vertex is on the hull it is the one that has nothing
//! across its clockwise side there, so that turning counter-clockwise finds all of them; else any of them does, and
//! turning ends where it began.
//!
//! Cost: one pass over the triangles, and 4 bytes a vertex. Each step around a vertex reads one triangle.

use crate::ids::TriangleId;
use crate::mesh::{Side, next, prev};
use crate::triangulation::Triangulation;

/// The triangles around each vertex of a [`Triangulation`]; [`Triangulation::fans`] makes it.
///
/// ```
/// let points = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1]];
/// let result = sweep_cdt::triangulate(&points, &[])?;
/// let fans = result.fans();
/// assert_eq!(fans.around(4).count(), 4);
/// // What lies to the left of a walk around vertex 1, on the hull.
/// let next = |(t, corner)| result.triangle(t)[(corner + 1) % 3];
/// assert_eq!(fans.around(1).map(next).collect::<Vec<_>>(), [2, 4]);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fans<'a> {
    result: &'a Triangulation,
    /// For each vertex the side opposite it in its first triangle.
    first: Vec<Side>,
}

impl Triangulation {
    /// Finds the triangles around each vertex.
    pub fn fans(&self) -> Fans<'_> {
        let count = self.triangles().flatten().max().map_or(0, |v| v + 1);
        let mut first = vec![Side::NO_TRIANGLE; count];
        for (t, triangle) in self.triangles.iter().enumerate() {
            for corner in 0..3 {
                let begins = triangle.across(prev(corner)).is_open();
                let kept = &mut first[self.input_index(triangle.vertex(corner))];
                if begins || *kept == Side::NO_TRIANGLE {
                    *kept = Side::new(TriangleId::at(t), corner);
                }
            }
        }
        Fans {
            result: self,
            first,
        }
    }
}

impl Fans<'_> {
    /// The triangles around vertex `v`, counter-clockwise, each with the corner (0, 1 or 2) that the vertex is of it.
    ///
    /// On the hull the first one is that whose clockwise side there is on the hull. There are none for what is no
    /// vertex of a triangle. Those around a duplicate are those of its representative.
    pub fn around(&self, v: usize) -> impl Iterator<Item = (usize, usize)> + Clone + '_ {
        let first = self.first.get(self.result.representative(v)).copied();
        let first = first.filter(|&side| side != Side::NO_TRIANGLE);
        let turn = move |side: &Side| {
            let corner = next(side.corner());
            let across = self.result.triangles[side.triangle().index()].across(corner);
            // The vertex follows the side that both have.
            let after = (!across.is_open()).then(|| across.next());
            after.filter(|&side| Some(side) != first)
        };
        let sides = std::iter::successors(first, turn);
        sides.map(|side| (side.triangle().index(), side.corner() as usize))
    }
}
