//! A number known up to an error, in doubles: what it decides needs no fractions.
//!
//! A *double-double* is the sum of two doubles; the second is at most half a unit of the first. The number differs from
//! it by at most a bound on the error (ball arithmetic). Sums, products and quotients are those of Dekker (1971) and
//! of Joldes, Muller and Popescu (2017).
//!
//! Why it is right: write u for 2^-53. For operands without an error, and as long as nothing under- or overflows, Joldes
//! et al. bound the error of a sum by about 3 u^2 of its size, of a product without fused operations by 7 u^2, of a
//! quotient by 15 u^2. The quotient here takes another product of theirs, which costs less than 10 u^2 more.
//! [`ROUNDING`] is 64 u^2. The errors of operands are carried along: |x y - X Y| <= |X| e + |Y| d + d e for
//! |x - X| <= d and |y - Y| <= e, and |x/y - X/Y| <= (d + |X/Y| e) / (|Y| - e). These bounds are sums and products of
//! numbers that are not negative, of less than ten roundings each; [`UP`] pays for sixteen.
//!
//! Numbers enter as zero or with sizes of 2^-200 to 2^200. Their differences are zero or from 2^-252 on, sums of two
//! products of these from 2^-504 to 2^403 in size, quotients of such sums within 2^±907. So nothing overflows, no
//! divisor is a number that has lost digits, and only a product with such a quotient can be so small that digits are
//! lost: less than [`UNDERFLOW`] in all.
//!
//! Cost: some ten to forty operations on doubles for each one.

use num_rational::BigRational;
use num_traits::ToPrimitive;

/// A bound on the error of one operation, relative to its result.
const ROUNDING: f64 = 64.0 * (f64::EPSILON / 2.0) * (f64::EPSILON / 2.0);

/// More than the roundings of a bound can make it too small.
const UP: f64 = 1.0 + 16.0 * f64::EPSILON;

/// More than a few underflows can add up to.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// A number that differs from `high + low` by at most `error`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosure {
    high: f64,
    low: f64,
    error: f64,
}

impl Enclosure {
    /// Exactly this number, if it is zero or of a size of 2^-200 to 2^200.
    pub(super) fn new(number: f64) -> Option<Enclosure> {
        /// 2^200.
        const LARGEST: f64 = f64::from_bits((1023 + 200) << 52);
        let is_moderate = number == 0.0 || (LARGEST.recip()..=LARGEST).contains(&number.abs());
        is_moderate.then_some(Enclosure::exactly(number))
    }

    /// Exactly this fraction, if it is such a number.
    pub(super) fn of(fraction: &BigRational) -> Option<Enclosure> {
        let number = fraction.to_f64()?;
        Enclosure::new(number)
            .filter(|_| BigRational::from_float(number).as_ref() == Some(fraction))
    }

    /// The double to which every number enclosed is rounded, if it is one.
    #[expect(clippy::float_cmp, reason = "asks for one and the same double")]
    pub(super) fn nearest(&self) -> Option<f64> {
        // One more bound pays for the rounding of the two sums.
        let error = 2.0 * self.error + self.low.abs() * f64::EPSILON;
        let [least, most] = [self.low - error, self.low + error].map(|low| self.high + low);
        (least == most).then_some(least)
    }

    pub(super) const fn exactly(number: f64) -> Enclosure {
        Enclosure {
            high: number,
            low: 0.0,
            error: 0.0,
        }
    }

    /// The result of an operation on numbers without an error, and what their errors add.
    fn rounded([high, low]: [f64; 2], carried: f64) -> Enclosure {
        let error = (carried + high.abs() * ROUNDING) * UP + UNDERFLOW;
        Enclosure { high, low, error }
    }

    pub(super) fn plus(self, other: Enclosure) -> Enclosure {
        let (high, low) = two_sum(self.high, other.high);
        let (t, rest) = two_sum(self.low, other.low);
        let (high, low) = fast_two_sum(high, low + t);
        let (high, low) = fast_two_sum(high, low + rest);
        Enclosure::rounded([high, low], self.error + other.error)
    }

    pub(super) fn minus(self, other: Enclosure) -> Enclosure {
        self.plus(other.negative())
    }

    fn negative(self) -> Enclosure {
        Enclosure {
            high: -self.high,
            low: -self.low,
            ..self
        }
    }

    /// The absolute value: its error is no larger, even where the sign is in doubt.
    pub(super) fn size(self) -> Enclosure {
        if self.high < 0.0 {
            self.negative()
        } else {
            self
        }
    }

    pub(super) fn times(self, other: Enclosure) -> Enclosure {
        let (high, low) = two_product(self.high, other.high);
        let low = low + (self.high * other.low + self.low * other.high);
        let (high, low) = fast_two_sum(high, low);
        let [x, y] = [self, other].map(|number| number.high.abs() * UP);
        let carried = x * other.error + y * self.error + self.error * other.error;
        Enclosure::rounded([high, low], carried)
    }

    /// The quotient; `None` if the other number may be zero.
    pub(super) fn over(self, other: Enclosure) -> Option<Enclosure> {
        let least = other.high.abs() / UP - other.error * UP;
        if least.is_nan() || least <= 0.0 {
            return None;
        }
        let first = self.high / other.high;
        let product = Enclosure::exactly(first).times(Enclosure {
            error: 0.0,
            ..other
        });
        let rest = (self.high - product.high) + (self.low - product.low);
        let (high, low) = fast_two_sum(first, rest / other.high);
        let carried = (self.error + high.abs() * UP * other.error) / (least / UP);
        Some(Enclosure::rounded([high, low], carried))
    }

    /// Whether every number enclosed is less than every one of `other`.
    pub(super) fn is_less_than(self, other: Enclosure) -> bool {
        let difference = other.minus(self);
        // The low part is at most half a unit of the high one.
        difference.high / UP > difference.error * UP
    }

    /// At least every number enclosed, if these are not negative.
    pub(super) fn most(self) -> f64 {
        (self.high * UP + self.error) * UP
    }
}

/// The rounded sum and its error (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// As [`two_sum`], for `a` of at least the size of `b` (Dekker).
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The rounded product and its error (Dekker): there are doubles without a fused operation.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let halves = |x: f64| {
        /// 2^27 + 1.
        const SPLITTER: f64 = 134_217_729.0;
        let large = SPLITTER * x;
        let high = large - (large - x);
        [high, x - high]
    };
    let product = a * b;
    let ([a1, a0], [b1, b0]) = (halves(a), halves(b));
    let error = a0 * b0 - (((product - a1 * b1) - a0 * b1) - a1 * b0);
    (product, error)
}

#[cfg(test)]
mod tests {
    use num_rational::BigRational;
    use num_traits::ToPrimitive;

    use super::Enclosure;

    /// Numbers from a small generator, the same at each call.
    fn numbers() -> impl FnMut(u32) -> u32 {
        let mut state = 12345_u64;
        move |below| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            u32::try_from((state >> 33) % u64::from(below)).expect("less than that")
        }
    }

    /// Of many sizes, short and long, some of them equal or close to each other.
    fn double(next: &mut impl FnMut(u32) -> u32) -> f64 {
        const HALF: u32 = 1 << 22;
        let whole = match next(3) {
            0 => f64::from(next(8)) - 4.0,
            1 => f64::from(next(HALF)) - 1e6,
            _ => f64::from(next(HALF)) * f64::from(HALF) + f64::from(next(HALF)) - 1e13,
        };
        let scale = match next(12) {
            0 => 2.0,
            1 => 1e9,
            2 => 1e40,
            3 => 1e-40,
            _ => 1.0,
        };
        whole * scale
    }

    fn exact(number: f64) -> BigRational {
        BigRational::from_float(number).expect("finite")
    }

    /// Panics unless the number is enclosed; returns whether it is enclosed closely.
    fn assert_encloses(enclosure: Enclosure, number: &BigRational) -> bool {
        let middle = exact(enclosure.high) + exact(enclosure.low);
        let off = if middle < *number {
            number - middle
        } else {
            middle - number
        };
        assert!(off <= exact(enclosure.error), "{enclosure:?} of {number}");
        assert!(enclosure.low.abs() <= enclosure.high.abs() * f64::EPSILON);
        if let Some(nearest) = enclosure.nearest() {
            assert_eq!(number.to_f64(), Some(nearest), "{enclosure:?} of {number}");
        }
        enclosure.nearest().is_some()
    }

    /// The enclosures that the crossings take: two differences, their products, a quotient, and a sum.
    #[test]
    fn what_fractions_give_is_enclosed() {
        let next = &mut numbers();
        let (mut close, mut less) = (0, 0);
        for _ in 0..20_000 {
            let doubles: [f64; 6] = core::array::from_fn(|_| double(next));
            let x = doubles.map(|x| Enclosure::new(x).expect("of a moderate size"));
            let y = doubles.map(exact);
            let (ab, cd) = (x[0].minus(x[1]), x[2].minus(x[3]));
            let (ab_exact, cd_exact) = (&y[0] - &y[1], &y[2] - &y[3]);
            assert_encloses(ab, &ab_exact);
            let (product, product_exact) = (ab.times(cd), &ab_exact * &cd_exact);
            assert_encloses(product, &product_exact);
            let (sum, sum_exact) = (
                product.plus(ab.times(x[4])),
                product_exact + ab_exact * &y[4],
            );
            assert_encloses(sum, &sum_exact);
            let Some(quotient) = sum.over(cd) else {
                continue;
            };
            let quotient_exact = sum_exact / cd_exact;
            assert_encloses(quotient, &quotient_exact);
            let (last, last_exact) = (quotient.plus(x[5]), quotient_exact + &y[5]);
            close += usize::from(assert_encloses(last, &last_exact));
            assert!(exact(last.size().most()) >= last_exact);
            if last.is_less_than(x[0]) {
                assert!(last_exact < y[0]);
                less += 1;
            }
        }
        assert!(close > 10_000 && less > 3000, "{close} close, {less} less");
    }

    /// Known to some digits only: errors of operands are carried along.
    #[test]
    fn what_is_known_badly_is_enclosed() {
        let next = &mut numbers();
        let mut quotients = 0;
        for _ in 0..20_000 {
            let numbers: [f64; 2] = core::array::from_fn(|_| double(next));
            let [x, y] = numbers.map(|number| {
                let high = f64::from_bits(number.to_bits() & !0xff_ffff_ffff);
                let error = (number - high).abs();
                Enclosure {
                    high,
                    low: 0.0,
                    error,
                }
            });
            let [x_exact, y_exact] = numbers.map(exact);
            assert_encloses(x.times(y), &(&x_exact * &y_exact));
            assert_encloses(x.minus(y), &(&x_exact - &y_exact));
            if x.is_less_than(y) {
                assert!(x_exact < y_exact);
            }
            if let Some(quotient) = x.over(y) {
                assert_encloses(quotient, &(x_exact / y_exact));
                quotients += 1;
            }
        }
        assert!(quotients > 10_000, "{quotients} quotients");
    }

    #[test]
    fn only_moderate_sizes_are_taken() {
        let is_taken = |x: f64| Enclosure::new(x).is_some();
        assert!([0.0, -1.0, 1e60, 1e-60].into_iter().all(is_taken));
        assert!(
            ![1e61, 1e-61, -1e300, f64::NAN, f64::INFINITY]
                .into_iter()
                .any(is_taken)
        );
    }
}
