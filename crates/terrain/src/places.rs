//! Where points lie on a domain, and which place on its border is nearest to one outside.
//!
//! Both are decided exactly: the first all at once (`WithPoints::locate_all`), the second by squares of distances in
//! fractions. Of several nearest places the lowest counts, and of these the leftmost: the order of the input does not.
//!
//! A tree of boxes in doubles tells which sides of the border to look at: no side is nearer than its box. Why none is
//! missed: a coordinate is scaled by a power of two, and off by 2^-52 of its size if it is no double; a box is larger by
//! [`SLACK`], which is more than its own error and that of a point beside it; and the square of the distance to a box,
//! two differences, two products and a sum, is off by less than [`MARGIN`]. Where doubles overflow or lose digits, all
//! sides are looked at.
//!
//! Cost: O((n + m) log(n + m)) to locate m points in n triangles. A point outside costs O(log n), and a step for each
//! side whose box is nearer than the nearest side: few, but where many long slanted sides lie side by side.

use num_rational::BigRational;
use num_traits::{One, Zero};
use static_aabb2d_index::{Control, StaticAABB2DIndex, StaticAABB2DIndexBuilder};
use sweep_cdt::Location;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;

/// A bound on the error of the square of a distance in doubles, as a factor.
const MARGIN: f64 = 1.0 + 16.0 * f64::EPSILON;
/// What a box is larger by: a part of the size of its coordinates, which are scaled to 1, and a number.
const SLACK: [f64; 2] = [8.0 * f64::EPSILON, 1e-30];
/// The largest coordinates of borders that have boxes.
const SIZES: std::ops::Range<f64> = 1e-290..1e290;

/// Where points lie on a domain, found once for any number of surfaces over it.
#[derive(Debug)]
pub struct Places<'p, S> {
    pub(crate) points: &'p [[S; 2]],
    pub(crate) found: Vec<Place>,
}

/// Where a point lies on a domain.
#[derive(Debug)]
pub(crate) enum Place {
    Outside,
    Vertex(usize),
    Side([usize; 2]),
    Triangle(usize),
    Near(Near),
}

/// A place on a side of the border, from its first end by a share of its length.
#[derive(Debug)]
pub(crate) struct Near {
    pub(crate) ends: [usize; 2],
    pub(crate) share: BigRational,
}

impl<'p, S: Exact> Places<'p, S> {
    /// Finds where `points` lie on a domain of a triangulation of `vertices`. In place of a point outside that is not
    /// farther than `within` from the border, in the units of the points, the nearest place on the border counts.
    /// Points whose coordinates are not finite lie outside, and nothing is nearest to them.
    ///
    /// ```
    /// use sweep_cdt::interior::Interior;
    /// use sweep_cdt_terrain::{Places, Surface};
    ///
    /// let vertices = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    /// let result = sweep_cdt::triangulate(&vertices, &[])?;
    /// let whole = Interior::whole(&result);
    /// let surface = Surface::new(&vertices, &whole, &[1.0, 5.0, 9.0]);
    /// let points = [[2.0, -0.25], [2.0, -0.5], [2.0, -0.75]];
    /// let places = Places::new(&vertices, &whole, &points, Some(0.5));
    /// assert_eq!(surface.heights_of(&places), [Some(3.0), Some(3.0), None]);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    #[must_use]
    pub fn new(
        vertices: &[[S; 2]],
        interior: &Interior<'_>,
        points: &'p [[S; 2]],
        within: Option<f64>,
    ) -> Places<'p, S> {
        let result = interior.triangulation();
        let located = result.with_points(vertices).locate_all(points);
        let mut is_corner = vec![false; vertices.len()];
        for corners in interior.triangles() {
            corners.into_iter().for_each(|v| is_corner[v] = true);
        }
        let is_inside = |t: usize| interior.is_inside(t);
        let place = |location| match location {
            Location::Vertex(v) if is_corner[v] => Place::Vertex(v),
            Location::Side { triangle: t, side }
                if is_inside(t) || result.neighbor(t, side).is_some_and(is_inside) =>
            {
                Place::Side(result.side(t, side))
            }
            Location::Triangle(t) if is_inside(t) => Place::Triangle(t),
            _ => Place::Outside,
        };
        let mut found: Vec<Place> = located.into_iter().map(place).collect();
        if let Some(within) = within.filter(|within| *within >= 0.0) {
            let mut border = None;
            for (place, point) in found.iter_mut().zip(points) {
                let is_outside = matches!(place, Place::Outside);
                if is_outside && point.iter().all(|x| x.is_finite()) {
                    let border = border.get_or_insert_with(|| Border::new(vertices, interior));
                    if let Some(near) = border.nearest(point, within) {
                        *place = Place::Near(near);
                    }
                }
            }
        }
        Places { points, found }
    }
}

/// The sides between what is inside and what is not.
struct Border<'a, S> {
    vertices: &'a [[S; 2]],
    sides: Vec<[usize; 2]>,
    /// The boxes of the sides, and the power of two that scales their coordinates.
    boxes: Option<(StaticAABB2DIndex<f64>, f64)>,
}

impl<'a, S: Exact> Border<'a, S> {
    fn new(vertices: &'a [[S; 2]], interior: &Interior<'_>) -> Border<'a, S> {
        let result = interior.triangulation();
        let is_beyond = |t: usize, side| {
            let across = result.neighbor(t, side);
            across.is_none_or(|across| !interior.is_inside(across))
        };
        let sides = interior
            .inside()
            .flat_map(|t| [0, 1, 2].map(|side| (t, side)));
        let sides = sides.filter(|&(t, side)| is_beyond(t, side));
        let sides: Vec<[usize; 2]> = sides.map(|(t, side)| result.side(t, side)).collect();
        let of_sides = || sides.iter().flatten().flat_map(|&v| &vertices[v]);
        let largest = of_sides().fold(0.0, |most: f64, x| most.max(x.approx().abs()));
        let boxes = SIZES.contains(&largest).then(|| {
            // All bits of the fraction are left out.
            let scale = 1.0 / f64::from_bits(largest.to_bits() >> 52 << 52);
            let mut boxes = StaticAABB2DIndexBuilder::new(sides.len());
            for side in &sides {
                let [x, y] = [0, 1].map(|axis| {
                    let [a, b] = side.map(|v| vertices[v][axis].approx() * scale);
                    let [low, high] = [a.min(b), a.max(b)];
                    let slack = |x: f64| SLACK[0] * x.abs() + SLACK[1];
                    [low - slack(low), high + slack(high)]
                });
                boxes.add(x[0], y[0], x[1], y[1]);
            }
            Some((boxes.build().ok()?, scale))
        });
        Border {
            vertices,
            boxes: boxes.flatten(),
            sides,
        }
    }

    /// The place that is nearest to a point, if it is not farther than this.
    fn nearest(&self, point: &[S; 2], within: f64) -> Option<Near> {
        let fraction = point.each_ref().map(S::to_fraction);
        // The square of the greatest distance; an infinite one has none.
        let most = BigRational::from_float(within).map(|within| &within * &within);
        // The boxes, and the point scaled as they are.
        let boxes = self.boxes.as_ref().and_then(|(boxes, scale)| {
            let scaled = point.each_ref().map(|x| x.approx() * scale);
            let is_finite = scaled.iter().all(|x| x.is_finite());
            is_finite.then_some((boxes, scaled, *scale))
        });
        let bound = |square: &BigRational| match &boxes {
            Some((.., scale)) => {
                let scale = scale.to_fraction();
                f64::nearest(&(square * &scale * &scale)) * MARGIN + f64::MIN_POSITIVE
            }
            None => f64::INFINITY,
        };
        let mut farthest = most.as_ref().map_or(f64::INFINITY, bound);
        let mut best: Option<Foot> = None;
        let mut look = |side: usize, square: f64| {
            if square > farthest {
                return Control::Break(());
            }
            if let Some((_, point, scale)) = &boxes
                && self.is_beyond(side, *point, *scale, farthest)
            {
                return Control::Continue;
            }
            let foot = Foot::new(&fraction, self.sides[side], self.vertices);
            let is_near = most.as_ref().is_none_or(|most| foot.square <= *most);
            if is_near && best.as_ref().is_none_or(|best| foot.key() < best.key()) {
                farthest = farthest.min(bound(&foot.square));
                best = Some(foot);
            }
            Control::Continue
        };
        match &boxes {
            Some((boxes, [x, y], _)) => {
                boxes.visit_neighbors(*x, *y, &mut look);
            }
            None => (0..self.sides.len()).for_each(|side| {
                look(side, 0.0);
            }),
        }
        best.map(|foot| foot.near)
    }

    /// Whether a side is farther from a scaled point than this square says, if doubles can tell, which saves fractions.
    /// A side is as far as its line, and farther where the foot lies before or after it. Both are products of vectors,
    /// off by less than [`SLACK`] says of the products that they are sums of.
    fn is_beyond(&self, side: usize, point: [f64; 2], scale: f64, farthest: f64) -> bool {
        let ends = self.sides[side].map(|v| &self.vertices[v]);
        let [from, to] = ends.map(|end| end.each_ref().map(|x| x.approx() * scale));
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let least = |products: [f64; 2]| {
            let size: f64 = products.iter().map(|x| x.abs()).sum();
            products[0] + products[1] - SLACK[0] * size - SLACK[1]
        };
        let of = |[px, py]: [f64; 2]| {
            let across = [dx * py, -dy * px];
            let before = [-dx * px, -dy * py];
            [least(across).max(least(across.map(|x| -x))), least(before)]
        };
        let [across, before] = of([point[0] - from[0], point[1] - from[1]]);
        let [_, after] = of([to[0] - point[0], to[1] - point[1]]);
        let [across, along] = [across, before.max(after)].map(|x| x.max(0.0));
        let square = dx * dx + dy * dy;
        S::APPROX_IS_EXACT && across * across + along * along > farthest * MARGIN * square
    }
}

/// The place of a side that is nearest to a point.
struct Foot {
    near: Near,
    place: [BigRational; 2],
    square: BigRational,
}

impl Foot {
    fn new<S: Exact>(point: &[BigRational; 2], ends: [usize; 2], vertices: &[[S; 2]]) -> Foot {
        let [from, to] = ends.map(|v| vertices[v].each_ref().map(S::to_fraction));
        let minus = |p: &[BigRational; 2], q: &[BigRational; 2]| [&p[0] - &q[0], &p[1] - &q[1]];
        let dot = |p: &[BigRational; 2], q: &[BigRational; 2]| &p[0] * &q[0] + &p[1] * &q[1];
        let side = minus(&to, &from);
        let share = dot(&minus(point, &from), &side) / dot(&side, &side);
        let share = share.clamp(BigRational::zero(), BigRational::one());
        let place = [0, 1].map(|axis| &from[axis] + &share * &side[axis]);
        let apart = minus(point, &place);
        Foot {
            near: Near { ends, share },
            square: dot(&apart, &apart),
            place,
        }
    }

    fn key(&self) -> (&BigRational, [&BigRational; 2]) {
        (&self.square, [&self.place[1], &self.place[0]])
    }
}
