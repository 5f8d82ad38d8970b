//! The test of scalars (`sweep_cdt_testing::conformance`): every scalar of the crate passes it, and it names what a wrong one gets wrong.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::ToPrimitive;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_testing::conformance::{Nonconformity, conformance};

/// The integer that equals a fraction.
fn integer<T>(x: &BigRational, to: fn(&BigInt) -> Option<T>) -> Option<T> {
    x.is_integer().then(|| to(x.numer())).flatten()
}

fn double(x: &BigRational) -> Option<f64> {
    let near = x.to_f64()?;
    (BigRational::from_float(near)? == *x).then_some(near)
}

fn single(x: &BigRational) -> Option<f32> {
    let near = double(x)? as f32;
    (BigRational::from_float(near)? == *x).then_some(near)
}

fn ratio(x: &BigRational) -> Option<Ratio<i64>> {
    Some(Ratio::new(x.numer().to_i64()?, x.denom().to_i64()?))
}

/// Panics unless so many answers are right.
fn conforms<S: Scalar>(of: impl Fn(&BigRational) -> Option<S>, least: usize) {
    match conformance(of) {
        Ok(answers) => assert!(answers > least, "{answers}"),
        Err(fault) => panic!("{}: {fault}", std::any::type_name::<S>()),
    }
}

#[test]
#[ignore = "8 seconds: `.ci/nightly` runs it"]
fn the_scalars_of_the_crate_conform() {
    conforms(double, 400_000);
    conforms(single, 100_000);
    conforms(|x| integer(x, ToPrimitive::to_i32), 40_000);
    conforms(|x| integer(x, ToPrimitive::to_i64), 80_000);
    conforms(|x| integer(x, ToPrimitive::to_i128), 120_000);
    conforms(|x| integer(x, |x| Some(x.clone())), 140_000);
    conforms(|x| Some(x.clone()), 1_000_000);
    conforms(ratio, 200_000);
}

#[test]
fn references_conform() {
    conforms(|x| double(x).map(leaked), 400_000);
    conforms(|x| integer(x, ToPrimitive::to_i128).map(leaked), 120_000);
    conforms(|x| ratio(x).map(leaked), 200_000);
}

fn leaked<T>(number: T) -> &'static T {
    Box::leak(Box::new(number))
}

#[cfg(feature = "rug")]
#[test]
fn the_numbers_of_gmp_conform() {
    conforms(|x| Some(super::to_rug(x)), 1_000_000);
    let whole = |x: &BigRational| super::to_rug(x).into_numer_denom().0;
    conforms(|x| x.is_integer().then(|| whole(x)), 140_000);
}

/// A number of 1024ths that gets one thing wrong.
#[derive(Clone, Copy)]
struct Wrong<const FAULT: usize>(i64);

/// For each fault the function that must be named.
const FAULTS: [&str; 14] = [
    "orient2d(",
    "in_circle(",
    "compare(",
    "approx(",
    "difference(",
    "as_doubles(",
    "orient2d(",
    "is_finite(",
    "depth(",
    "height(",
    "orient2d(",
    "approx(",
    "in_circle(",
    "in_circle(",
];

fn whole<const FAULT: usize>(p: &[Wrong<FAULT>; 2]) -> [i64; 2] {
    p.map(|x| x.0)
}

impl<const FAULT: usize> Scalar for Wrong<FAULT> {
    const APPROX_IS_EXACT: bool = FAULT == 11;

    fn is_finite(&self) -> bool {
        FAULT != 7 || self.0 < 1 << 40
    }

    fn approx(&self) -> f64 {
        let near = self.0 as f64 / 1024.0;
        if FAULT == 3 {
            f64::from(near as f32)
        } else {
            near
        }
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        (FAULT == 5).then(|| points.iter().map(|p| p.map(|x| x.0 as f64)).collect())
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let rounded = (self.0 as f64 - other.0 as f64, -10);
        let exact = ((i128::from(self.0) - i128::from(other.0)) as f64, -10);
        Some(if FAULT == 4 { rounded } else { exact })
    }

    fn compare(&self, other: &Self) -> Ordering {
        match FAULT {
            2 => self.approx().total_cmp(&other.approx()),
            _ => self.0.cmp(&other.0),
        }
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(whole);
        match FAULT {
            0 => {
                let minus = |p: [i64; 2]| [0, 1].map(|i| p[i].wrapping_sub(c[i]));
                let (p, q) = (minus(a), minus(b));
                p[0].wrapping_mul(q[1]).cmp(&p[1].wrapping_mul(q[0]))
            }
            6 => {
                let minus = |p: [i64; 2]| [0, 1].map(|i| p[i].checked_sub(c[i]).expect("room"));
                let (p, q) = (minus(a), minus(b));
                let product = |x: i64, y: i64| x.checked_mul(y).expect("room");
                product(p[0], q[1]).cmp(&product(p[1], q[0]))
            }
            // Only what is straight.
            10 => Scalar::orient2d(&a, &b, &c).then(Ordering::Less),
            _ => Scalar::orient2d(&a, &b, &c),
        }
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let [p, q, r, s] = [a, b, c, d].map(whole);
        let exact = Scalar::in_circle(&p, &q, &r, &s);
        let depth = i64::depth(&p, &q, &r, &s);
        match FAULT {
            // Whatever is hardly inside or outside is on the circle.
            1 if depth.is_some_and(|depth| depth.abs() < 1e-9) => Ordering::Equal,
            // Only what is on the circle.
            12 => exact.then(Ordering::Less),
            13 => rounded::in_circle(a, b, c, d),
            _ => exact,
        }
    }

    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let [a, b, c, d] = [a, b, c, d].map(whole);
        let depth = i64::depth(&a, &b, &c, &d)?;
        Some(if FAULT == 8 { depth.max(0.0) } else { depth })
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = [a, b, c].map(whole);
        let height = i64::height(&a, &b, &c)?;
        Some(if FAULT == 9 { height / 1024.0 } else { height })
    }
}

/// The in-circle test in doubles, whose rounding nobody looks at.
mod rounded {
    use super::{Ordering, Scalar};

    pub(super) fn in_circle<S: Scalar>(a: &[S; 2], b: &[S; 2], c: &[S; 2], d: &[S; 2]) -> Ordering {
        let row = |p: &[S; 2]| [0, 1].map(|i| p[i].approx() - d[i].approx());
        let [a, b, c] = [row(a), row(b), row(c)];
        let lift = |[x, y]: [f64; 2]| x * x + y * y;
        let cross = |[px, py]: [f64; 2], [qx, qy]: [f64; 2]| px * qy - py * qx;
        let sum = lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b);
        sum.partial_cmp(&0.0).expect("a number")
    }
}

fn judge<const FAULT: usize>() -> Result<usize, Nonconformity> {
    let unit = BigInt::from(1024);
    conformance(|x| integer(&(x * &unit), ToPrimitive::to_i64).map(Wrong::<FAULT>))
}

#[test]
fn what_is_wrong_is_named() {
    let found = [
        judge::<0>(),
        judge::<1>(),
        judge::<2>(),
        judge::<3>(),
        judge::<4>(),
        judge::<5>(),
        judge::<6>(),
        judge::<7>(),
        judge::<8>(),
        judge::<9>(),
        judge::<10>(),
        judge::<11>(),
        judge::<12>(),
        judge::<13>(),
    ];
    for ((fault, found), function) in found.into_iter().enumerate().zip(FAULTS) {
        let named = match &found {
            Err(Nonconformity::WrongAnswer { call, .. }) if fault != 6 => call,
            Err(Nonconformity::Panic { call }) if fault == 6 => call,
            _ => panic!("{fault}: {found:?}"),
        };
        assert!(named.starts_with(function), "{fault}: {named}");
    }
    // Without a fault.
    assert!(judge::<14>().is_ok_and(|answers| answers > 80_000));
    let message = judge::<1>().expect_err("an epsilon").to_string();
    assert!(message.contains(" is Equal, but must be "), "{message}");
    let message = judge::<6>().expect_err("an overflow").to_string();
    assert!(message.ends_with(" panics"), "{message}");
}

#[test]
fn a_type_that_has_hardly_any_number_is_not_judged() {
    let nothing = conformance::<f64>(|_| None);
    assert_eq!(nothing, Err(Nonconformity::TooFewNumbers { tried: 0 }));
}
