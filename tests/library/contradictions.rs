//! Scalars whose signs contradict each other: a panic that says so, never an endless loop.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::panic::{AssertUnwindSafe, catch_unwind};

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Triangulator};
use sweep_cdt_testing::Random;

/// A double with wrong signs; the kind of wrong is a constant.
#[derive(Clone, Copy, Debug)]
struct Wrong<const KIND: u8>(f64);

/// In circle is always positive; never negative; all signs are random.
const ALWAYS_INSIDE: u8 = 0;
const RANDOM_CIRCLES: u8 = 1;
const RANDOM: u8 = 2;

/// A sign that depends on nothing but the order of the coordinates.
fn random(points: &[&[f64; 2]]) -> Ordering {
    let seed = points.iter().flat_map(|p| p.iter()).fold(7_u64, |seed, x| {
        seed.rotate_left(9) ^ x.to_bits().wrapping_mul(0x9E37_79B9)
    });
    [Less, Equal, Greater][Random::new(seed).below(3)]
}

impl<const KIND: u8> Scalar for Wrong<KIND> {
    fn approx(&self) -> f64 {
        self.0
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| x.0));
        if KIND == RANDOM {
            random(&[&a, &b, &c])
        } else {
            Scalar::orient2d(&a, &b, &c)
        }
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        if KIND == ALWAYS_INSIDE {
            return Greater;
        }
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(|x| x.0));
        random(&[&a, &b, &c, &d])
    }
}

/// Triangulates small inputs; `collapsed` coordinates are so near each other that the filter decides
/// nothing. Returns how many runs ended in a panic that blames the scalar.
fn blamed<const KIND: u8>(algorithm: Algorithm) -> usize {
    let mut blamed = 0;
    for seed in 0..40 {
        let random = &mut Random::new(seed);
        // Their doubles are approximations for the filter, which cannot separate them.
        let points: Vec<[Wrong<KIND>; 2]> = (0..30)
            .map(|_| [0, 1].map(|_| Wrong(1.0 + random.integer(40) * f64::EPSILON)))
            .collect();
        let edges = [[0, 1], [2, 3], [4, 5]];
        let run = Triangulator::new().algorithm(algorithm);
        let result = catch_unwind(AssertUnwindSafe(|| {
            run.triangulate(&points, &edges).is_ok()
        }));
        if let Err(panic) = result {
            let message = panic
                .downcast_ref::<String>()
                .map(String::as_str)
                .or_else(|| panic.downcast_ref::<&str>().copied())
                .unwrap_or_default();
            blamed += usize::from(message.contains("signs contradict each other"));
        }
    }
    blamed
}

#[test]
fn every_run_ends() {
    let mut all = 0;
    for algorithm in [
        Algorithm::Auto,
        Algorithm::Sweep,
        Algorithm::DivideAndConquer,
    ] {
        let blamed = [
            blamed::<ALWAYS_INSIDE>(algorithm),
            blamed::<RANDOM_CIRCLES>(algorithm),
            blamed::<RANDOM>(algorithm),
        ];
        println!("{algorithm:?}: {blamed:?} of 40");
        all += blamed.iter().sum::<usize>();
    }
    assert!(all > 0, "no scalar was blamed");
}
