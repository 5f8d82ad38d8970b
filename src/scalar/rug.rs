//! `rug::Rational` (feature `rug`): the rationals of GMP, behind the same filter as every
//! [`Unbounded`](super::Unbounded) number.
//!
//! `to_f64` rounds towards zero: monotone, and off by less than one unit in the last place, which is
//! what [`approx`](Scalar::approx) must be.

use std::cmp::Ordering;

use rug::Rational;

use super::{Scalar, filter};

impl Scalar for Rational {
    fn approx(&self) -> f64 {
        self.to_f64()
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let points = [a, b, c];
        let [x, y, z] = points.map(approx);
        filter::orient2d(x, y, z, false)
            .or_else(|| are_doubles(points, [x, y, z]).then(|| f64::orient2d(&x, &y, &z)))
            .unwrap_or_else(|| cross(&minus(a, c), &minus(b, c)).cmp0())
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let points = [a, b, c, d];
        let [w, x, y, z] = points.map(approx);
        filter::in_circle(w, x, y, z, false)
            .or_else(|| are_doubles(points, [w, x, y, z]).then(|| f64::in_circle(&w, &x, &y, &z)))
            .unwrap_or_else(|| {
                let [a, b, c] = [a, b, c].map(|p| minus(p, d));
                let det =
                    lift(&a) * cross(&b, &c) + lift(&b) * cross(&c, &a) + lift(&c) * cross(&a, &b);
                det.cmp0()
            })
    }
}

fn approx(point: &[Rational; 2]) -> [f64; 2] {
    [point[0].approx(), point[1].approx()]
}

fn are_doubles<const N: usize>(points: [&[Rational; 2]; N], near: [[f64; 2]; N]) -> bool {
    points
        .into_iter()
        .flatten()
        .zip(near.iter().flatten())
        .all(|(exact, double)| exact == double)
}

fn minus(a: &[Rational; 2], b: &[Rational; 2]) -> [Rational; 2] {
    [0, 1].map(|i| Rational::from(&a[i] - &b[i]))
}

fn lift(p: &[Rational; 2]) -> Rational {
    Rational::from(p[0].square_ref()) + Rational::from(p[1].square_ref())
}

fn cross(p: &[Rational; 2], q: &[Rational; 2]) -> Rational {
    Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0])
}
