//! The new vertex of a triangle that breaks a bound: where it comes, and what stands in its way.
//!
//! The way from the triangle to the place is followed exactly, from corner to place, as an edge event would
//! (figure 12). Then the triangles that have the place inside their circle are found from there.

use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::{in_circle, orient2d};

use crate::bounds::Broken;
use crate::mesh::{next, prev};
use crate::refine::Reason;
use crate::refine::work::{Bad, Kind, Work};

/// The treatment of a triangle that breaks a bound.
pub(super) enum Candidate<S> {
    /// The triangle stays.
    Stays(Reason),
    /// Parts of edges are in the way: they are split instead.
    Parts(Vec<u32>),
    /// A vertex here leaves these triangles wrong.
    Place([S; 2], Vec<u32>),
}

/// Off-centers are drawn in by this, so that rounding leaves the new angle above the bound.
const DRAWN_IN: f64 = 0.95;

impl<S: Exact> Work<'_, '_, S> {
    /// The treatment of a triangle that breaks a bound.
    pub(super) fn candidate(&self, bad: &Bad) -> Candidate<S> {
        let [p, q, r] = self.at_shortest_side(bad.t);
        if bad.bound == Broken::Angle && self.is_input_angle([p, q, r]) {
            return Candidate::Stays(Reason::InputAngle);
        }
        let Some(place) = center([p, q, r].map(|v| self.near(v)), self.off_center)
            .and_then(|place| self.exactly(place))
        else {
            return Candidate::Stays(Reason::Rounding);
        };
        match self.way(bad.t, &place) {
            Ok(t) => self.around(t, place),
            Err(Some(side)) => Candidate::Parts(vec![self.part_at(side)]),
            Err(None) => Candidate::Stays(Reason::Rounding),
        }
    }

    /// The vertices of a triangle, counter-clockwise, those at its shortest side first.
    fn at_shortest_side(&self, t: u32) -> [u32; 3] {
        let corners = self.mesh.mesh.triangle(t).expect("a triangle");
        let near = corners.map(|v| self.near(v));
        let length = |k: usize| {
            let ([x, y], [z, w]) = (near[k], near[(k + 1) % 3]);
            (z - x).hypot(w - y)
        };
        let shortest = (0..3).min_by(|&i, &j| length(i).total_cmp(&length(j)));
        let k = shortest.expect("three sides");
        [0, 1, 2].map(|i| corners[(k + i) % 3])
    }

    /// Whether the least angle of a triangle is one of the input, or stands on two equal shells of a corner.
    fn is_input_angle(&self, [p, q, r]: [u32; 3]) -> bool {
        let is_part = |v, w| self.parts_by_ends.contains_key(&self.names([v, w]));
        let shell = |v: u32| match self.kinds[self.name(v) as usize] {
            Kind::OnPart(shell) => shell,
            _ => None,
        };
        is_part(p, r) && is_part(q, r) || shell(p).is_some() && shell(p) == shell(q)
    }

    fn exactly(&self, place: [f64; 2]) -> Option<[S; 2]> {
        let exactly = |x: f64| {
            let fraction = || num_rational::BigRational::from_float(x);
            S::nearest_of_double(x).or_else(|| Some(S::nearest(&fraction()?)))
        };
        let [x, y] = place;
        Some([exactly(x)?, exactly(y)?]).filter(|place| place.iter().all(S::is_finite))
    }

    /// The triangle that holds a place seen from triangle `t`; the side of a part that is in the way; or nothing, if the
    /// way leaves the triangle at a corner.
    fn way(&self, t: u32, place: &[S; 2]) -> Result<u32, Option<u32>> {
        let mesh = &self.mesh.mesh;
        let mut sides = (3 * t..3 * t + 3).filter(|&side| self.mesh.is_right_of(side, place));
        let Some(mut side) = sides.next() else {
            return Ok(t);
        };
        if sides.next().is_some() {
            return Err(None);
        }
        let from = self.mesh.points.place(mesh.apex(side));
        loop {
            if mesh.covers(side) > 0 {
                return Err(Some(side));
            }
            // The inside is bounded by parts, so there is a triangle across.
            let across = mesh.twin(side);
            let apex = self.mesh.points.place(mesh.apex(across));
            side = if orient2d(from, place, apex).is_gt() {
                next(across)
            } else {
                prev(across)
            };
            if !self.mesh.is_right_of(side, place) {
                return Ok(across / 3);
            }
        }
    }

    /// The triangles that a vertex in triangle `t` leaves wrong, if it may come there.
    fn around(&self, t: u32, place: [S; 2]) -> Candidate<S> {
        let mesh = &self.mesh.mesh;
        let (mut found, mut parts, mut next) = (vec![t], Vec::new(), 0);
        while let Some(&t) = found.get(next) {
            next += 1;
            let corners = mesh
                .triangle(t)
                .expect("a triangle")
                .map(|v| self.mesh.points.place(v));
            if corners.iter().any(|corner| {
                corner[0].compare(&place[0]).is_eq() && corner[1].compare(&place[1]).is_eq()
            }) {
                return Candidate::Stays(Reason::Rounding);
            }
            for side in 3 * t..3 * t + 3 {
                if mesh.covers(side) > 0 {
                    if self.mesh.is_right_of(side, &place) || self.is_encroached(side, &place) {
                        parts.push(self.part_at(side));
                    }
                    continue;
                }
                let across = mesh.twin(side) / 3;
                if found.contains(&across) {
                    continue;
                }
                let [a, b, c] = mesh
                    .triangle(across)
                    .expect("a triangle")
                    .map(|v| self.mesh.points.place(v));
                if in_circle(a, b, c, &place).is_ge() {
                    found.push(across);
                }
            }
        }
        if parts.is_empty() {
            Candidate::Place(place, found)
        } else {
            Candidate::Parts(parts)
        }
    }
}

/// The centre of the circle through three points, the first two of which are nearest to each other; or the point on the
/// way there whose distance from their side is `most` of its length.
fn center([p, q, r]: [[f64; 2]; 3], most: f64) -> Option<[f64; 2]> {
    let ([ux, uy], [wx, wy]) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
    let (w, area) = (wx * wx + wy * wy, ux * wy - uy * wx);
    // Across the side, in its lengths: the centre stands on the bisector.
    let height = (w - (ux * wx + uy * wy)) / (2.0 * area);
    let height = height.min(most * DRAWN_IN);
    let place = [p[0] + ux / 2.0 - uy * height, p[1] + uy / 2.0 + ux * height];
    place.iter().all(|x| x.is_finite()).then_some(place)
}
