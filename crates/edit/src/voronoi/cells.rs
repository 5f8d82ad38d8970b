//! The part of a cell that lies inside a polygon.
//!
//! A cell is where its point is as near as each of its neighbours: one half-plane after the other is cut off a convex
//! polygon (Sutherland and Hodgman 1974). Any other domain is cut triangle by triangle; then sides that two pieces share
//! go, and the rest is linked to rings. All numbers are fractions, so that shared sides are equal.

use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;

use super::{Voronoi, VoronoiError};
use crate::measure::{doubled_area, exactly, squared_distance, zero};

type Place = [BigRational; 2];

impl<S: Exact> Voronoi<'_, S> {
    /// The corners of a bounded cell, counter-clockwise. Vertices that round to one place are one; empty, if fewer than
    /// three are left, as for a point that has no cell.
    pub fn corners(&self, point: usize) -> Vec<[S; 2]> {
        let own = self.cells.get(point).into_iter().flatten();
        distinct(own.map(|&v| self.vertices[v].clone()).collect())
    }

    /// The part of a point's cell inside a convex polygon, whose corners are given counter-clockwise: its corners, from
    /// one of the polygon's where there is one. Corners that round to one place are one. Empty, if they share no area, or
    /// one that rounding takes.
    ///
    /// # Errors
    /// [`VoronoiError::NoPoint`], [`VoronoiError::NonFiniteCorner`].
    pub fn cell_within(
        &self,
        point: usize,
        polygon: &[[S; 2]],
    ) -> Result<Vec<[S; 2]>, VoronoiError> {
        let is_finite = |corner: &[S; 2]| corner.iter().all(S::is_finite);
        if let Some(corner) = polygon.iter().position(|corner| !is_finite(corner)) {
            return Err(VoronoiError::NonFiniteCorner { corner });
        }
        let corners = polygon.iter().map(exactly).collect();
        Ok(rounded(&self.cut(point, corners)?))
    }

    /// The part of a point's cell inside any domain: polygons with holes, of which `inside` is the interior and `corners`
    /// are the points. Polygons, each an outline counter-clockwise and the holes in it clockwise, without straight corners;
    /// corners that round to one place are one.
    ///
    /// Each call looks at every triangle of the domain.
    ///
    /// ```
    /// use sweep_cdt::interior::FillRule;
    /// use sweep_cdt_edit::Voronoi;
    ///
    /// // A plane that is cut in two halves, and an L.
    /// let points = [[-2.0, 0.0], [2.0, 0.0]];
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let voronoi = Voronoi::new(&result, &points)?;
    /// let corners = [[-1.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [-1.0, 2.0]];
    /// let edges = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]];
    /// let l = sweep_cdt::triangulate(&corners, &edges)?;
    /// let polygons = voronoi.cell_inside(1, &l.interior(FillRule::EvenOdd)?, &corners)?;
    /// assert_eq!([polygons.len(), polygons[0].len()], [1, 1]);
    /// assert_eq!(polygons[0][0], [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`VoronoiError::NoPoint`]; [`VoronoiError::NonFiniteCorner`], also if the domain has a corner that does not exist.
    pub fn cell_inside(
        &self,
        point: usize,
        inside: &Interior<'_>,
        corners: &[[S; 2]],
    ) -> Result<Vec<Vec<Vec<[S; 2]>>>, VoronoiError> {
        let mut triangles = Vec::with_capacity(inside.inside().len());
        for corner in inside.triangles().flatten() {
            let place = corners
                .get(corner)
                .filter(|place| place.iter().all(S::is_finite));
            triangles.push(place.ok_or(VoronoiError::NonFiniteCorner { corner })?);
        }
        // No triangle beside the cell's part of the box around the domain need be cut.
        let Some(domain) = limits(&triangles) else {
            return self.cut(point, Vec::new()).map(|_| Vec::new());
        };
        let [[left, right], [low, high]] = domain;
        let bounds = [[left, low], [right, low], [right, high], [left, high]];
        let bounds = bounds.map(|[x, y]| [x.to_fraction(), y.to_fraction()]);
        let part = self.cut(point, bounds.to_vec())?;
        // A rounding that does not fall keeps what touches.
        let part: Vec<[S; 2]> = part
            .iter()
            .map(|place| place.each_ref().map(S::nearest))
            .collect();
        let Some(part) = limits(&part.iter().collect::<Vec<_>>()) else {
            return Ok(Vec::new());
        };
        let mut pieces = Vec::new();
        for triangle in triangles.chunks(3) {
            let own = limits(triangle).expect("three corners");
            let is_beside = |k: usize| {
                let ([low, high], [least, most]) = (own[k], part[k]);
                high.compare(least).is_lt() || low.compare(most).is_gt()
            };
            if !is_beside(0) && !is_beside(1) {
                let corners = triangle.iter().map(|corner| exactly(corner)).collect();
                pieces.push(self.cut(point, corners)?);
            }
        }
        let polygons = polygons(rings(&pieces)).into_iter().map(|rings| {
            let rings = rings.iter().map(|ring| rounded(ring));
            rings.filter(|ring| !ring.is_empty()).collect()
        });
        // Without its outline a polygon has no area.
        Ok(polygons
            .filter(|rings: &Vec<_>| !rings.is_empty())
            .collect())
    }

    /// What the cell leaves of a convex polygon; nothing, if that has no area.
    fn cut(&self, point: usize, mut corners: Vec<Place>) -> Result<Vec<Place>, VoronoiError> {
        let own = self
            .points
            .get(point)
            .ok_or(VoronoiError::NoPoint { point })?;
        let own = exactly(own);
        for &other in &self.neighbors[point] {
            let other = exactly(&self.points[other]);
            // Above 0 where a place is nearer to the other point.
            let beyond =
                |place: &Place| squared_distance(place, &own) - squared_distance(place, &other);
            let mut kept = Vec::new();
            for (i, a) in corners.iter().enumerate() {
                let b = &corners[(i + 1) % corners.len()];
                let (at_a, at_b) = (beyond(a), beyond(b));
                if at_a <= zero() {
                    kept.push(a.clone());
                }
                if at_a < zero() && at_b > zero() || at_a > zero() && at_b < zero() {
                    let part = &at_a / (&at_a - &at_b);
                    kept.push([0, 1].map(|k| &a[k] + (&b[k] - &a[k]) * &part));
                }
            }
            corners = kept;
        }
        if doubled_area(&corners) == zero() {
            corners.clear();
        }
        Ok(corners)
    }
}

/// A ring as nearest places: empty, if fewer than three differ.
fn rounded<S: Exact>(places: &[Place]) -> Vec<[S; 2]> {
    let nearest = |place: &Place| place.each_ref().map(S::nearest);
    distinct(places.iter().map(nearest).collect())
}

/// A ring without a place twice in a row: empty, if fewer than three are left.
fn distinct<S: Exact>(mut ring: Vec<[S; 2]>) -> Vec<[S; 2]> {
    let is_same = |p: &[S; 2], q: &[S; 2]| (0..2).all(|k| p[k].compare(&q[k]).is_eq());
    ring.dedup_by(|p, q| is_same(p, q));
    while ring.len() > 1 && is_same(&ring[0], &ring[ring.len() - 1]) {
        ring.pop();
    }
    if ring.len() < 3 {
        ring.clear();
    }
    ring
}

/// Rings as polygons: outlines run counter-clockwise, and each is followed by the holes in it, which run clockwise.
fn polygons(rings: Vec<Vec<Place>>) -> Vec<Vec<Vec<Place>>> {
    let is_outline = |ring: &Vec<Place>| doubled_area(ring) > zero();
    let (outlines, holes): (Vec<_>, Vec<_>) = rings.into_iter().partition(is_outline);
    let mut polygons: Vec<Vec<Vec<Place>>> = outlines.into_iter().map(|ring| vec![ring]).collect();
    for hole in holes {
        let holds =
            |polygon: &Vec<Vec<Place>>| hole.iter().any(|place| is_inside(&polygon[0], place));
        // A hole whose corners all touch the outline is in the only one that is left.
        let place = polygons.iter().position(holds).unwrap_or(0);
        if let Some(polygon) = polygons.get_mut(place) {
            polygon.push(hole);
        }
    }
    polygons
}

/// Whether a place lies in a ring and not on it.
fn is_inside(ring: &[Place], place: &Place) -> bool {
    let mut crossed = 0;
    for (i, a) in ring.iter().enumerate() {
        let b = &ring[(i + 1) % ring.len()];
        let [low, high] = if a[1] < b[1] { [a, b] } else { [b, a] };
        if low[1] <= place[1] && place[1] < high[1] {
            match doubled_area(&[low.clone(), high.clone(), place.clone()]).cmp(&zero()) {
                Ordering::Greater => crossed += 1,
                Ordering::Equal => return false,
                Ordering::Less => {}
            }
        }
    }
    crossed % 2 == 1
}

/// The least and the greatest x, and so for y.
fn limits<'p, S: Exact>(places: &[&'p [S; 2]]) -> Option<[[&'p S; 2]; 2]> {
    let along = |k: usize| {
        let values = places.iter().map(|place| &place[k]);
        let least = values.clone().min_by(|x, y| x.compare(y))?;
        Some([least, values.max_by(|x, y| x.compare(y))?])
    };
    Some([along(0)?, along(1)?])
}

/// The rings around pieces that run counter-clockwise and share whole sides. No ring has a place twice.
fn rings(pieces: &[Vec<Place>]) -> Vec<Vec<Place>> {
    let mut places: Vec<&Place> = pieces.iter().flatten().collect();
    places.sort_unstable();
    places.dedup();
    let number = |place: &Place| places.binary_search(&place).expect("a corner of a piece");
    // For each place the ends of the sides that begin there and are not shared.
    let mut ends = vec![Vec::new(); places.len()];
    for piece in pieces {
        let corners: Vec<usize> = piece.iter().map(number).collect();
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            if let Some(shared) = ends[b].iter().position(|&end| end == a) {
                ends[b].swap_remove(shared);
            } else {
                ends[a].push(b);
            }
        }
    }
    let mut rings = Vec::new();
    let mut position = vec![None; places.len()];
    for first in 0..places.len() {
        // The way from the first place, without the loops that were cut off.
        let (mut way, mut at) = (vec![first], first);
        position[first] = Some(0);
        while !ends[at].is_empty() {
            let back = way.len().checked_sub(2).map(|before| way[before]);
            // Of several ways on, the first one clockwise from the way back keeps to one piece.
            let order = |&i: &usize, &j: &usize| {
                back.map_or(Ordering::Equal, |back| {
                    clockwise(
                        places[at],
                        places[back],
                        [ends[at][i], ends[at][j]].map(|v| places[v]),
                    )
                })
            };
            let on = (0..ends[at].len()).min_by(order).expect("a way on");
            at = ends[at].swap_remove(on);
            if let Some(begin) = position[at] {
                let ring: Vec<&Place> = way[begin..].iter().map(|&v| places[v]).collect();
                for v in way.drain(begin + 1..) {
                    position[v] = None;
                }
                rings.push(without_straight_corners(&ring));
            } else {
                position[at] = Some(way.len());
                way.push(at);
            }
        }
        position[first] = None;
    }
    rings
}

fn without_straight_corners(ring: &[&Place]) -> Vec<Place> {
    let is_corner = |&i: &usize| {
        let around = [i + ring.len() - 1, i, i + 1].map(|i| ring[i % ring.len()].clone());
        doubled_area(&around) != zero()
    };
    let corners = (0..ring.len()).filter(is_corner);
    corners.map(|i| ring[i].clone()).collect()
}

/// Which of two ways from a place comes first, clockwise from the way back.
fn clockwise(at: &Place, back: &Place, ways: [&Place; 2]) -> Ordering {
    let turn = |p: &Place, q: &Place| doubled_area(&[at.clone(), p.clone(), q.clone()]);
    // Within half a turn clockwise from the way back, or beyond.
    let is_late = ways.map(|way| turn(back, way) >= zero());
    let [p, q] = ways;
    is_late[0]
        .cmp(&is_late[1])
        .then_with(|| turn(p, q).cmp(&zero()))
}
