//! Linear interpolation, with results that are as good as doubles allow. They depend on the places and heights alone, and
//! not on which corner is named first: so a triangle gives the same height wherever it comes from.
//!
//! Doubles do where their errors are bounded well below the accuracy promised; fractions do the rest: slivers, extreme
//! exponents, and coordinates that are no doubles. Results lie between the values that they come from.
//!
//! Why the bound holds: write u for 2^-53. The six coordinates relative to the point have relative errors of u, so each
//! of the three areas has an error of at most 4 u times the sum of the sizes of its two products. The weights are areas
//! divided by their sum, so the height is off by less than twice the sum of these errors, divided by the sum of the
//! areas, times the difference of the heights; and [`ACCURACY`] bounds the quotient.

use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::Scalar;

/// A bound on the error of a height, as a part of the difference of the heights that it comes from.
const ACCURACY: f64 = 1e-12;
/// Areas in doubles have lost digits if they are smaller.
const SMALLEST: f64 = 1e-250;
/// And so have their products with differences of heights that are smaller.
const SMALLEST_SPREAD: f64 = 1e-60;

/// The coordinate at a level between two heights, the first below it and the second not, from the coordinates there. It is
/// monotone in the level, and is the second coordinate where the level is the second height.
pub(crate) fn between(level: f64, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
    if level >= high {
        return to;
    }
    // Differences of the halves do not overflow.
    let share = match (level - low) / (high - low) {
        share if (high - low).is_finite() => share,
        _ => (level / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0),
    };
    let step = to - from;
    let place = if step.is_finite() {
        from + share * step
    } else {
        2.0 * (from / 2.0 + share * (to / 2.0 - from / 2.0))
    };
    place.clamp(from.min(to), from.max(to))
}

/// The height of a point between the two ends of a segment.
pub(crate) fn along<S: Exact>(
    point: &[S; 2],
    mut ends: [&[S; 2]; 2],
    mut heights: [f64; 2],
) -> f64 {
    if sweep_order(ends[0], ends[1]).is_gt() {
        ends.reverse();
        heights.reverse();
    }
    let height = || {
        let [[fx, fy], [tx, ty]] = ends.map(approx);
        let [x, y] = approx(point);
        let [dx, dy] = [tx - fx, ty - fy];
        let share = if dx.abs() > dy.abs() {
            (x - fx) / dx
        } else {
            (y - fy) / dy
        };
        // A share of an infinite way would be 0.
        let is_finite = dx.is_finite() && dy.is_finite();
        is_finite.then_some(heights[0] + share * (heights[1] - heights[0]))
    };
    let doubles = S::APPROX_IS_EXACT.then(height).flatten();
    let doubles = doubles.filter(|x| x.is_finite());
    let height = doubles.unwrap_or_else(|| {
        let [from, to] = ends.map(fraction);
        let point = fraction(point);
        let axis = usize::from(from[0] == to[0]);
        at_share(
            &((&point[axis] - &from[axis]) / (&to[axis] - &from[axis])),
            heights,
        )
    });
    clamped(height, heights)
}

/// The height at a share of the way between two: the nearest double.
pub(crate) fn at_share(share: &BigRational, heights: [f64; 2]) -> f64 {
    let [from, to] = heights.map(|height| height.to_fraction());
    f64::nearest(&(&from + share * (to - &from)))
}

/// The height of a point in a triangle.
pub(crate) fn within<S: Exact>(
    point: &[S; 2],
    mut corners: [&[S; 2]; 3],
    mut heights: [f64; 3],
) -> f64 {
    let least = (0..3).min_by(|&a, &b| sweep_order(corners[a], corners[b]));
    let least = least.unwrap_or(0);
    corners.rotate_left(least);
    heights.rotate_left(least);
    let doubles = S::APPROX_IS_EXACT
        .then(|| in_doubles(approx(point), corners.map(approx), heights))
        .flatten();
    let height = doubles.unwrap_or_else(|| in_fractions(point, corners, heights));
    clamped(height, heights)
}

/// The height, if doubles are accurate enough.
fn in_doubles([x, y]: [f64; 2], corners: [[f64; 2]; 3], heights: [f64; 3]) -> Option<f64> {
    let [a, b, c] = corners.map(|corner| [corner[0] - x, corner[1] - y]);
    let products = [[b, c], [c, a], [a, b]].map(|[p, q]| [p[0] * q[1], p[1] * q[0]]);
    let [wa, wb, wc] = products.map(|[plus, minus]| plus - minus);
    let error: f64 = products.iter().flatten().map(|x| x.abs()).sum();
    let area = wa + wb + wc;
    let is_in_range = area > SMALLEST && error.is_finite();
    let is_accurate = is_in_range && 4.0 * f64::EPSILON * error <= ACCURACY * area;
    let [za, zb, zc] = heights;
    let [to_b, to_c] = [zb - za, zc - za];
    let height = za + (wb * to_b + wc * to_c) / area;
    // Products of small areas and smaller differences of heights lose digits, too.
    let spread = to_b.abs().max(to_c.abs());
    let is_tiny = spread > 0.0 && spread < SMALLEST_SPREAD;
    (is_accurate && !is_tiny && height.is_finite()).then_some(height)
}

/// The nearest double to the height.
fn in_fractions<S: Exact>(point: &[S; 2], corners: [&[S; 2]; 3], heights: [f64; 3]) -> f64 {
    let [x, y] = fraction(point);
    let [a, b, c] = corners.map(|corner| {
        let [cx, cy] = fraction(corner);
        [cx - &x, cy - &y]
    });
    let area = |p: &[BigRational; 2], q: &[BigRational; 2]| &p[0] * &q[1] - &p[1] * &q[0];
    let weights = [area(&b, &c), area(&c, &a), area(&a, &b)];
    let whole = &weights[0] + &weights[1] + &weights[2];
    let [za, zb, zc] = heights.map(|height| height.to_fraction());
    let [wa, wb, wc] = weights;
    f64::nearest(&((wa * za + wb * zb + wc * zc) / whole))
}

/// The order of the sweep: by y, then by x.
fn sweep_order<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[1].compare(&b[1]).then_with(|| a[0].compare(&b[0]))
}

fn clamped<const N: usize>(height: f64, heights: [f64; N]) -> f64 {
    let low = heights.into_iter().fold(f64::INFINITY, f64::min);
    let high = heights.into_iter().fold(f64::NEG_INFINITY, f64::max);
    height.clamp(low, high)
}

fn approx<S: Exact>(point: &[S; 2]) -> [f64; 2] {
    point.each_ref().map(S::approx)
}

fn fraction<S: Exact>(point: &[S; 2]) -> [BigRational; 2] {
    point.each_ref().map(S::to_fraction)
}
