//! The dual of a triangulation: diagrams and cells, nearest points and natural neighbours, in fractions.

mod diagrams;
mod nearest;

use num_rational::BigRational;
use sweep_cdt_testing::Random;

type Place = [BigRational; 2];

fn whole(x: i64) -> BigRational {
    BigRational::from_integer(x.into())
}

fn distance(p: &Place, q: &Place) -> BigRational {
    let [x, y] = [0, 1].map(|k| &p[k] - &q[k]);
    &x * &x + &y * &y
}

/// Twice the area of a polygon.
fn area(corners: &[Place]) -> BigRational {
    let after = corners.iter().cycle().skip(1);
    let cross = |(p, q): (&Place, &Place)| &p[0] * &q[1] - &p[1] * &q[0];
    corners.iter().zip(after).map(cross).sum()
}

fn below(random: &mut Random, n: usize) -> i64 {
    random.below(n) as i64
}
