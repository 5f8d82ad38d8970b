//! Which triangles new points leave wrong, and which sides are not canonical.
//!
//! A new point leaves a triangle wrong that sees it and has it inside its circle; or on it, if the rule for ties says
//! so: of vertices on one circle all diagonals end at the first one, by x and then from above. These triangles hang
//! together, across sides that are free, with the triangle in which the point lies. Beyond the hull the sides that see
//! the point count as triangles. Cost: an exact sign for each neighbour of a triangle found.

use sweep_cdt::scalar::{Scalar, in_circle};

use crate::locate::Place;
use crate::mesh::NONE;
use crate::triangulation::DynamicTriangulation;

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Adds to the region what a new vertex at this place leaves wrong.
    pub(crate) fn add_conflicts(&mut self, v: u32, place: Place) {
        match place {
            Place::Vertex(_) => return,
            Place::Triangle(t) => self.region.add(t),
            Place::Beyond(side) => self.region.add_beyond(side),
            Place::Side(side) => {
                self.region.add(side / 3);
                match self.mesh.twin(side) {
                    NONE => self.region.add_beyond(side),
                    across => self.region.add(across / 3),
                }
            }
        }
        let (mut face, mut beyond) = (0, 0);
        loop {
            if let Some(&t) = self.region.triangles.get(face) {
                face += 1;
                for side in 3 * t..3 * t + 3 {
                    match self.mesh.twin(side) {
                        _ if self.mesh.covers(side) > 0 => {}
                        NONE if self.is_right_of(side, self.points.place(v)) => {
                            self.region.add_beyond(side);
                        }
                        NONE => {}
                        across if self.region.has(across / 3) => {}
                        across if self.is_conflict(across, v) => self.region.add(across / 3),
                        _ => {}
                    }
                }
            } else if let Some(&side) = self.region.beyond.get(beyond) {
                beyond += 1;
                if self.mesh.covers(side) == 0 && self.is_conflict(side, v) {
                    self.region.add(side / 3);
                }
                for side in self.mesh.hull_beside(side) {
                    if self.is_right_of(side, self.points.place(v)) {
                        self.region.add_beyond(side);
                    }
                }
            } else {
                break;
            }
        }
    }

    /// Whether a vertex beyond a side leaves the triangle of the side wrong.
    fn is_conflict(&self, side: u32, v: u32) -> bool {
        let [p, q, r] = self.mesh.triangle(side / 3).expect("a triangle at a side");
        let [a, b] = self.mesh.ends(side);
        let places = [p, q, r, v].map(|v| self.points.place(v));
        let sign = in_circle(places[0], places[1], places[2], places[3]);
        sign.is_gt() || sign.is_eq() && !self.is_canonical([a, b], [self.mesh.apex(side), v])
    }

    /// Whether the diagonal of four vertices on one circle is the one of the canonical triangulation.
    fn is_canonical(&self, diagonal: [u32; 2], others: [u32; 2]) -> bool {
        let first = |[a, b]: [u32; 2]| {
            if self.points.order(a, b).is_lt() {
                a
            } else {
                b
            }
        };
        self.points.order(first(diagonal), first(others)).is_lt()
    }

    /// Whether a side between two triangles is neither part of an edge nor canonical.
    pub(crate) fn is_wrong(&self, side: u32) -> bool {
        let across = self.mesh.twin(side);
        across != NONE
            && self.mesh.covers(side) == 0
            && self.is_conflict(side, self.mesh.apex(across))
    }
}
