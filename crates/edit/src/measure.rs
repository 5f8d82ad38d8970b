//! Angles, areas and distances, compared exactly.
//!
//! **Cost.** Doubles decide where their rounding cannot matter: each polynomial is a sum of products of differences, all
//! of which are right to `u = 2^-53`. An angle's two sides have 9 and 10 such factors, so that 32 `u` times the larger
//! bound on them is more than the error of their difference, if nothing underflows. Fractions decide the rest.

use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;

/// The double nearest to the squared cosine of an angle in degrees.
pub(crate) fn squared_cosine(degrees: f64) -> f64 {
    // (1 + cos 2x) / 2 is exact at 0, 30, 45 and 60 degrees but for the cosine.
    f64::midpoint(1.0, (2.0 * degrees).to_radians().cos())
}

/// The point as doubles, if it is one.
pub(crate) fn doubles<S: Exact>(point: &[S; 2]) -> Option<[f64; 2]> {
    let double = |x: &S| {
        S::nearest_of_double(x.approx())
            .filter(|y| y.compare(x).is_eq())
            .map(|_| x.approx())
    };
    Some([double(&point[0])?, double(&point[1])?])
}

/// From `c` to `a` and to `b`: the scalar product, the sum of the sizes of its terms, and both squared lengths.
fn spread([a, b, c]: [[f64; 2]; 3]) -> [f64; 4] {
    let ([px, py], [qx, qy]) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
    let (x, y) = (px * qx, py * qy);
    [
        x + y,
        x.abs() + y.abs(),
        px * px + py * py,
        qx * qx + qy * qy,
    ]
}

/// So small that 32 u times the bound is more than all errors, and so large that nothing underflows.
const ERROR: f64 = 32.0 * (f64::EPSILON / 2.0);
const NORMAL: std::ops::Range<f64> = 1e-140..1e140;

fn fractions<S: Exact, const N: usize>(points: [&[S; 2]; N]) -> [[BigRational; 2]; N] {
    points.map(exactly)
}

fn exact_spread([a, b, c]: [[BigRational; 2]; 3]) -> [BigRational; 3] {
    let to = |p: &[BigRational; 2]| [&p[0] - &c[0], &p[1] - &c[1]];
    let (p, q) = (to(&a), to(&b));
    let product = |p: &[BigRational; 2], q: &[BigRational; 2]| &p[0] * &q[0] + &p[1] * &q[1];
    [product(&p, &q), product(&p, &p), product(&q, &q)]
}

fn fraction(x: f64) -> BigRational {
    BigRational::from_float(x).expect("bounds are finite where they are compared")
}

/// The sign of the scalar product from `c` to `a` and `b`: `Less`, if the angle at `c` is obtuse.
pub(crate) fn scalar_product<S: Exact>([a, b, c]: [&[S; 2]; 3]) -> Ordering {
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let [sum, sizes, ..] = spread([p, q, r]);
        if sum.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return sum.total_cmp(&0.0);
        }
    }
    let [sum, ..] = exact_spread(fractions([a, b, c]));
    sum.cmp(&zero())
}

/// The order of the squared cosine of the angle at `c`, and a squared cosine.
pub(crate) fn compare_angle<S: Exact>([a, b, c]: [&[S; 2]; 3], cosine: f64) -> Ordering {
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let [sum, _, pp, qq] = spread([p, q, r]);
        let (left, both) = (sum * sum, pp * qq);
        let difference = left - cosine * both;
        if difference.abs() > ERROR * both && NORMAL.contains(&pp) && NORMAL.contains(&qq) {
            return difference.total_cmp(&0.0);
        }
    }
    let [sum, pp, qq] = exact_spread(fractions([a, b, c]));
    (&sum * &sum).cmp(&(pp * qq * fraction(cosine)))
}

/// Whether an angle of a triangle is less than the one with this squared cosine.
pub(crate) fn has_angle_below<S: Exact>(corners: [&[S; 2]; 3], cosine: f64) -> bool {
    let turned = [0, 1, 2].map(|k| [0, 1, 2].map(|i| corners[(k + i) % 3]));
    let is_below =
        |corners| compare_angle(corners, cosine).is_gt() && scalar_product(corners).is_gt();
    if let [Some(a), Some(b), Some(c)] = corners.map(doubles) {
        // Most triangles are beyond doubt: no cosine is near the bound.
        let is_above = |corners| {
            let [sum, _, pp, qq] = spread(corners);
            let both = pp * qq;
            cosine * both - sum * sum > ERROR * both && NORMAL.contains(&pp) && NORMAL.contains(&qq)
        };
        if is_above([a, b, c]) && is_above([b, c, a]) && is_above([c, a, b]) {
            return false;
        }
    }
    turned.into_iter().any(is_below)
}

/// The order of the area of a triangle and another one.
pub(crate) fn compare_area<S: Exact>([a, b, c]: [&[S; 2]; 3], most: f64) -> Ordering {
    if most.is_infinite() {
        return Ordering::Less;
    }
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let (x, y) = ((p[0] - r[0]) * (q[1] - r[1]), (p[1] - r[1]) * (q[0] - r[0]));
        let (area, sizes) = ((x - y).abs(), x.abs() + y.abs() + 2.0 * most);
        let difference = area - 2.0 * most;
        if difference.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return difference.total_cmp(&0.0);
        }
    }
    let [a, b, c] = fractions([a, b, c]);
    let area = (&a[0] - &c[0]) * (&b[1] - &c[1]) - (&a[1] - &c[1]) * (&b[0] - &c[0]);
    let area = if area < zero() { -area } else { area };
    area.cmp(&(fraction(most) * fraction(2.0)))
}

/// The order of the length of a side and another one.
pub(crate) fn compare_side<S: Exact>([a, b]: [&[S; 2]; 2], most: f64) -> Ordering {
    if most.is_infinite() {
        return Ordering::Less;
    }
    if let (Some(p), Some(q)) = (doubles(a), doubles(b)) {
        let [_, _, square, _] = spread([p, p, q]);
        let difference = square - most * most;
        let sizes = square + most * most;
        if difference.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return difference.total_cmp(&0.0);
        }
    }
    let [_, square, _] = exact_spread(fractions([a, a, b]));
    square.cmp(&(fraction(most) * fraction(most)))
}

/// The values of the coordinates, which are finite.
pub(crate) fn exactly<S: Exact>(point: &[S; 2]) -> [BigRational; 2] {
    point.each_ref().map(S::to_fraction)
}

pub(crate) fn zero() -> BigRational {
    BigRational::from_integer(0.into())
}

/// The square of the distance.
pub(crate) fn squared_distance(p: &[BigRational; 2], q: &[BigRational; 2]) -> BigRational {
    let [x, y] = [0, 1].map(|k| &p[k] - &q[k]);
    &x * &x + &y * &y
}

/// Twice the area of a polygon, below 0 if its corners run clockwise.
pub(crate) fn doubled_area(corners: &[[BigRational; 2]]) -> BigRational {
    let Some(origin) = corners.first() else {
        return zero();
    };
    let from = |p: &[BigRational; 2]| [&p[0] - &origin[0], &p[1] - &origin[1]];
    let cross = |pair: &[[BigRational; 2]]| {
        let [p, q] = [from(&pair[0]), from(&pair[1])];
        &p[0] * &q[1] - &p[1] * &q[0]
    };
    corners.windows(2).map(cross).sum()
}

/// The centre of the circle through three points that turn left; of others none is made.
pub(crate) fn center<S: Exact>(corners: [&[S; 2]; 3]) -> Option<[BigRational; 2]> {
    let [p, q, r] = corners.map(exactly);
    let [u, w] = [q, r].map(|corner| [0, 1].map(|k| &corner[k] - &p[k]));
    let [uu, ww] = [&u, &w].map(|v| &v[0] * &v[0] + &v[1] * &v[1]);
    let area = (&u[0] * &w[1] - &u[1] * &w[0]) * BigRational::from_integer(2.into());
    if area <= zero() {
        return None;
    }
    let x = &p[0] + (&w[1] * &uu - &u[1] * &ww) / &area;
    let y = &p[1] + (&u[0] * &ww - &w[0] * &uu) / &area;
    Some([x, y])
}

/// Which of two points is nearer to a place.
pub(crate) fn compare_distances<S: Exact>(place: &[S; 2], [a, b]: [&[S; 2]; 2]) -> Ordering {
    if let (Some(q), Some(p), Some(r)) = (doubles(place), doubles(a), doubles(b)) {
        let [_, _, to_a, to_b] = spread([p, r, q]);
        let (difference, sizes) = (to_a - to_b, to_a + to_b);
        if difference.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return difference.total_cmp(&0.0);
        }
    }
    let [place, a, b] = [place, a, b].map(exactly);
    squared_distance(&place, &a).cmp(&squared_distance(&place, &b))
}

/// Whether a side `a`, `b` is farther from a place than a point that is as near as its ends or nearer. Of doubles that
/// leave it open, the answer is no.
pub(crate) fn is_farther<S: Exact>(place: &[S; 2], [a, b]: [&[S; 2]; 2], point: &[S; 2]) -> bool {
    if let [Some(q), Some(a), Some(b), Some(p)] = [place, a, b, point].map(doubles) {
        let [along, sizes, side, to_a] = spread([b, q, a]);
        let [back, sizes_back, _, to_b] = spread([a, q, b]);
        let [_, _, to_p, _] = spread([p, p, q]);
        let (x, y) = ((a[0] - q[0]) * (b[1] - q[1]), (a[1] - q[1]) * (b[0] - q[0]));
        let line = (x - y).abs() - ERROR * (x.abs() + y.abs());
        let is_normal = [side, to_a, to_b, to_p]
            .iter()
            .all(|square| NORMAL.contains(square));
        let surely = |more: f64, less: f64| more - less > ERROR * more;
        return is_normal
            && (line > 0.0 && surely(line * line, to_p * side)
                || along < -ERROR * sizes && surely(to_a, to_p)
                || back < -ERROR * sizes_back && surely(to_b, to_p));
    }
    let [q, a, b, p] = [place, a, b, point].map(exactly);
    let [along, side, to_a] = exact_spread([b.clone(), q.clone(), a.clone()]);
    let to_p = squared_distance(&q, &p);
    if along <= zero() {
        return to_a > to_p;
    }
    if along >= side {
        return squared_distance(&q, &b) > to_p;
    }
    let double = doubled_area(&[q, a, b]);
    &double * &double > to_p * side
}
