//! Where a point lies: a walk through sides that have the point on their other side.
//!
//! The side tried first is drawn at random, so no walk goes round for ever where edges keep triangles from being
//! Delaunay (Devillers, Pion and Teillaud 2001). A walk longer than there are triangles ends: all are looked at instead.
//! Cost: a step for each triangle on the way. Differs from the library's search: the walk begins at the last edit or at a
//! vertex of a [grid](crate::hints), since edits often follow each other in place.

use sweep_cdt::Location;
use sweep_cdt::scalar::{Scalar, orient2d};

use crate::mesh::{NONE, next, prev};
use crate::triangulation::DynamicTriangulation;

/// Where a point lies in the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Vertex(u32),
    /// On this side.
    Side(u32),
    Triangle(u32),
    /// Beyond this side of the hull.
    Beyond(u32),
}

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Where a point lies. If there are no triangles, everything is outside.
    ///
    /// ```
    /// use sweep_cdt::Location;
    /// use sweep_cdt_edit::DynamicTriangulation;
    ///
    /// let mut square = DynamicTriangulation::new();
    /// for corner in [[0, 0], [4, 0], [4, 4], [0, 4]] {
    ///     square.insert(corner)?;
    /// }
    /// assert_eq!(square.locate(&[4, 4]), Location::Vertex(2));
    /// assert_eq!(square.locate(&[5, 4]), Location::Outside);
    /// assert!(matches!(square.locate(&[1, 1]), Location::Triangle(_)));
    /// # Ok::<(), sweep_cdt_edit::EditError>(())
    /// ```
    pub fn locate(&self, point: &[S; 2]) -> Location {
        if self.mesh.len() == 0 || !point.iter().all(Scalar::is_finite) {
            return Location::Outside;
        }
        match self.find(point) {
            Place::Vertex(v) => Location::Vertex(self.points.name(v)),
            Place::Side(side) => Location::Side {
                triangle: side as usize / 3,
                side: side as usize % 3,
            },
            Place::Triangle(t) => Location::Triangle(t as usize),
            Place::Beyond(_) => Location::Outside,
        }
    }

    /// Where a walk to a point begins: at the last edit, or at the vertex that came last into the point's cell of the
    /// grid, whichever is nearer.
    fn start(&self, point: &[S; 2]) -> u32 {
        let mesh = &self.mesh;
        let distance = |t: u32| {
            let v = mesh.triangle(t).expect("a triangle")[0];
            let along = |i: usize| (point[i].approx() - self.points.place(v)[i].approx()).abs();
            along(0) + along(1)
        };
        let hint = self.hints.near(point).map(|v| mesh.at(v));
        let hint = hint
            .filter(|&corner| corner != NONE)
            .map(|corner| corner / 3);
        let last = Some(self.last).filter(|&t| mesh.triangle(t).is_some());
        match (hint, last) {
            (Some(hint), Some(last)) if distance(last) < distance(hint) => last,
            (Some(t), _) | (None, Some(t)) => t,
            (None, None) => mesh.all().next().expect("there are triangles"),
        }
    }

    /// The place of a point in the mesh, which has triangles.
    pub(crate) fn find(&self, point: &[S; 2]) -> Place {
        let mesh = &self.mesh;
        let mut t = self.start(point);
        let (mut came, mut random) = (NONE, t.wrapping_mul(0x9E37_79B9) | 1);
        for _ in 0..mesh.len() + 64 {
            random ^= random << 13;
            random ^= random >> 17;
            random ^= random << 5;
            let sides = (0..3).map(|k| 3 * t + (k + random) % 3);
            let away = sides
                .filter(|&side| side != came)
                .find(|&side| self.is_right_of(side, point));
            let Some(side) = away else {
                return self.in_triangle(t, point);
            };
            came = mesh.twin(side);
            if came == NONE {
                return Place::Beyond(side);
            }
            t = came / 3;
        }
        let inside = |&t: &u32| (3 * t..3 * t + 3).all(|side| !self.is_right_of(side, point));
        match mesh.all().find(inside) {
            Some(t) => self.in_triangle(t, point),
            None => {
                let mut sides = mesh.all().flat_map(|t| 3 * t..3 * t + 3);
                let beyond = |&side: &u32| mesh.twin(side) == NONE && self.is_right_of(side, point);
                Place::Beyond(
                    sides
                        .find(beyond)
                        .expect("a side of the hull sees the point"),
                )
            }
        }
    }

    /// The place of a point that no side of the triangle has on its other side.
    fn in_triangle(&self, t: u32, point: &[S; 2]) -> Place {
        let on = |side: u32| {
            let [a, b] = self.mesh.ends(side).map(|v| self.points.place(v));
            orient2d(a, b, point).is_eq()
        };
        let Some(side) = (3 * t..3 * t + 3).find(|&side| on(side)) else {
            return Place::Triangle(t);
        };
        if on(next(side)) {
            Place::Vertex(self.mesh.apex(prev(side)))
        } else if on(prev(side)) {
            Place::Vertex(self.mesh.apex(next(side)))
        } else {
            // Of both sides the one with the lower number, whichever way the walk came.
            Place::Side(side.min(self.mesh.twin(side)))
        }
    }

    /// Whether a point lies strictly to the right of a side, where its triangle does not lie.
    pub(crate) fn is_right_of(&self, side: u32, point: &[S; 2]) -> bool {
        let [a, b] = self.mesh.ends(side).map(|v| self.points.place(v));
        orient2d(a, b, point).is_lt()
    }
}
