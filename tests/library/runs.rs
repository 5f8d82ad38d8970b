//! The table of runs, with the scalars of optional features.

use sweep_cdt_testing::runs;

pub(crate) use sweep_cdt_testing::runs::assert_agree;

/// All runs; the first is the one that callers get who choose nothing.
pub(crate) fn all() -> Vec<runs::Run> {
    #[cfg_attr(not(feature = "rug"), expect(unused_mut))]
    let mut all = runs::all();
    #[cfg(feature = "rug")]
    all.extend(runs::with::<gmp::Gmp>("rug::Rational"));
    all
}

/// The runs of some scalars.
pub(crate) fn of(scalars: &[&str]) -> Vec<runs::Run> {
    let is_one = |run: &runs::Run| scalars.iter().any(|scalar| run.name.starts_with(scalar));
    all().into_iter().filter(is_one).collect()
}

#[cfg(feature = "rug")]
mod gmp {
    use std::cmp::Ordering;

    use rug::Rational;
    use sweep_cdt::scalar::Scalar;
    use sweep_cdt_testing::runs::Sample;

    /// A `rug::Rational`, as a type of its own that can be a [`Sample`].
    #[derive(Clone, Debug)]
    pub(crate) struct Gmp(Rational);

    impl Gmp {
        fn inner(p: &[Gmp; 2]) -> [Rational; 2] {
            p.each_ref().map(|x| x.0.clone())
        }
    }

    impl Sample for Gmp {
        fn of(x: f64) -> Option<Gmp> {
            Rational::from_f64(x).map(Gmp)
        }
    }

    impl Scalar for Gmp {
        fn approx(&self) -> f64 {
            self.0.approx()
        }

        fn compare(&self, other: &Self) -> Ordering {
            self.0.compare(&other.0)
        }

        fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
            let [a, b, c] = [a, b, c].map(Gmp::inner);
            Rational::orient2d(&a, &b, &c)
        }

        fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
            let [a, b, c, d] = [a, b, c, d].map(Gmp::inner);
            Rational::in_circle(&a, &b, &c, &d)
        }
    }
}
