//! The questions about one sample: each function of [`Scalar`], in several
//! orders of the points.

use std::cell::Cell;
use std::fmt::Debug;
use std::panic::{AssertUnwindSafe, catch_unwind};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use sweep_cdt::scalar::{Scalar, in_circle, orient2d};

use super::nonconformity::Nonconformity;
use super::samples::Sample;
use super::truth::{self, area, determinant, is_near, sign};

type Asked = Result<(), Nonconformity>;

/// Orders of the points: some begin with a left turn if others begin with a right one.
const ORDERS: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 0, 2, 3], [3, 1, 2, 0], [2, 3, 0, 1]];

/// A sample and its points as numbers of the type.
pub(super) struct Questions<'a, S> {
    sample: &'a Sample,
    fractions: &'a [[BigRational; 2]; 4],
    points: &'a [[S; 2]],
    answers: Cell<usize>,
}

impl<'a, S: Scalar> Questions<'a, S> {
    pub(super) fn new(
        sample: &'a Sample,
        fractions: &'a [[BigRational; 2]; 4],
        points: &'a [[S; 2]],
    ) -> Self {
        Questions {
            sample,
            fractions,
            points,
            answers: Cell::new(0),
        }
    }

    /// Asks everything. Returns how many answers there were, all of them right.
    pub(super) fn ask(self) -> Result<usize, Nonconformity> {
        for place in 0..8 {
            self.number(place)?;
            // Those along the same axis.
            for other in (place..8).step_by(2) {
                self.pair(place, other)?;
                self.pair(other, place)?;
            }
        }
        for order in ORDERS {
            self.turn(order)?;
            self.circle(order)?;
        }
        self.doubles()?;
        Ok(self.answers.get())
    }

    fn number(&self, place: usize) -> Asked {
        let (number, exact) = (&self.points[place / 2][place % 2], self.exact(place));
        let call = |function: &str| format!("{function}({exact})");
        self.equal(|| call("is_finite"), || number.is_finite(), true)?;
        let near = self.answer(|| call("approx"), || number.approx())?;
        let bits = if S::APPROX_IS_EXACT { 2000 } else { 52 };
        let limit = |x: f64| BigRational::from_float(x).expect("a finite number");
        let is_large = |x: &BigRational| *x > limit(f64::MAX) || *x < limit(f64::MIN);
        let is_right = match BigRational::from_float(near) {
            // Infinite is what is larger than all doubles, with its sign.
            None => is_large(exact) && !near.is_nan() && (near > 0.0) == (*exact > limit(0.0)),
            Some(_) if is_large(exact) => near.abs() >= f64::MAX,
            Some(near) => is_near(&near, exact, bits) || is_tiny(&(near - exact), exact),
        };
        let expected = "the number, within 2^-52 of it or exactly as APPROX_IS_EXACT says";
        require(is_right, || call("approx"), near, expected)
    }

    fn pair(&self, place: usize, other: usize) -> Asked {
        let number = |place: usize| &self.points[place / 2][place % 2];
        let (a, b) = (number(place), number(other));
        let (exact_a, exact_b) = (self.exact(place), self.exact(other));
        let call = |function: &str| format!("{function}({exact_a}, {exact_b})");
        let order = exact_a.cmp(exact_b);
        self.equal(|| call("compare"), || a.compare(b), order)?;
        if order.is_lt() {
            let [low, high] = [a, b].map(S::approx);
            let expected = format!("at most {high}, which approx({exact_b}) is");
            require(low <= high, || format!("approx({exact_a})"), low, &expected)?;
        }
        let Some(found) = self.answer(|| call("difference"), || a.difference(b))? else {
            return Ok(());
        };
        let near = BigRational::from_float(found.0).and_then(|x| {
            // No difference of samples has as many bits.
            let power = i32::try_from(found.1)
                .ok()
                .filter(|power| power.abs() < 1 << 14)?;
            Some(x * BigRational::from(BigInt::from(2)).pow(power))
        });
        let exact = exact_a - exact_b;
        let is_right = near.is_some_and(|near| is_near(&near, &exact, 52));
        let expected = "within a relative error of 2^-52 of the difference";
        require(is_right, || call("difference"), found, expected)
    }

    fn turn(&self, order: [usize; 4]) -> Asked {
        let [a, b, c, _] = order;
        let corners = [a, b, c].map(|i| &self.sample.points[i]);
        let [p, q, r] = [a, b, c].map(|i| &self.points[i]);
        let call = |function: &str| self.call(function, &order[..3]);
        let expected = sign(&area(corners));
        let exact = || S::orient2d(p, q, r);
        self.equal(|| call("orient2d"), exact, expected)?;
        let filtered = || orient2d(p, q, r);
        self.equal(|| call("scalar::orient2d"), filtered, expected)?;
        let found = self.answer(|| call("height"), || S::height(p, q, r))?;
        let Some(found) = found else { return Ok(()) };
        match truth::height(corners) {
            Some(height) => self.size(|| call("height"), found, &height),
            None => require(false, || call("height"), found, "None: it turns back"),
        }
    }

    fn circle(&self, order: [usize; 4]) -> Asked {
        let corners = order.map(|i| &self.sample.points[i]);
        let [a, b, c, _] = corners;
        let turn = sign(&area([a, b, c]));
        // Three points on a line have no circle.
        if turn.is_eq() {
            return Ok(());
        }
        let [p, q, r, s] = order.map(|i| &self.points[i]);
        let call = |function: &str| self.call(function, &order);
        let expected = sign(&determinant(corners));
        let exact = || S::in_circle(p, q, r, s);
        self.equal(|| call("in_circle"), exact, expected)?;
        let filtered = || in_circle(p, q, r, s);
        self.equal(|| call("scalar::in_circle"), filtered, expected)?;
        if turn.is_lt() {
            return Ok(());
        }
        match self.answer(|| call("depth"), || S::depth(p, q, r, s))? {
            Some(found) => self.size(|| call("depth"), found, &truth::depth(corners)),
            None => Ok(()),
        }
    }

    fn doubles(&self) -> Asked {
        let call = || self.call("as_doubles", &[0, 1, 2, 3]);
        let Some(found) = self.answer(call, || S::as_doubles(self.points))? else {
            return Ok(());
        };
        let numbers = found.as_flattened().iter();
        let numbers: Option<Vec<_>> = numbers.map(|&x| BigRational::from_float(x)).collect();
        let exact = self.fractions.as_flattened();
        let is_right = numbers.is_some_and(|numbers| {
            let pairs = || numbers.iter().zip(exact);
            let factor = pairs().find(|(_, exact)| !exact.is_zero());
            let factor = factor.map_or_else(BigRational::zero, |(x, exact)| x / exact);
            let is_positive = factor > BigRational::zero() || exact.iter().all(Zero::is_zero);
            numbers.len() == 8 && is_positive && pairs().all(|(x, exact)| *x == exact * &factor)
        });
        let expected = "these numbers times one positive number";
        require(is_right, call, found, expected)
    }

    /// A depth or height; its error may be some units of 2^-52.
    fn size(&self, call: impl Fn() -> String, found: f64, exact: &BigRational) -> Asked {
        let near = BigRational::from_float(found);
        let is_right = near.is_some_and(|near| {
            let has_sign = near.cmp(&Zero::zero()) == exact.cmp(&Zero::zero());
            has_sign && (is_near(&near, exact, 48) || is_tiny(&(near - exact), exact))
        });
        require(is_right, call, found, &exact.to_string())
    }

    fn exact(&self, place: usize) -> &'a BigRational {
        &self.fractions[place / 2][place % 2]
    }

    /// A call with points, as text.
    fn call(&self, function: &str, points: &[usize]) -> String {
        let point = |&i: &usize| {
            let [x, y] = &self.fractions[i];
            format!("[{x}, {y}]")
        };
        let points: Vec<String> = points.iter().map(point).collect();
        format!("{function}({})", points.join(", "))
    }

    fn equal<T: Copy + PartialEq + Debug>(
        &self,
        call: impl Fn() -> String,
        answer: impl FnOnce() -> T,
        expected: T,
    ) -> Asked {
        let answer = self.answer(&call, answer)?;
        require(answer == expected, call, answer, &format!("{expected:?}"))
    }

    /// The answer of the scalar, unless it panics.
    fn answer<T>(
        &self,
        call: impl Fn() -> String,
        answer: impl FnOnce() -> T,
    ) -> Result<T, Nonconformity> {
        // Whatever a panic leaves half done belongs to the scalar, which is not asked again.
        let answer = catch_unwind(AssertUnwindSafe(answer));
        self.answers.update(|count| count + 1);
        answer.map_err(|_| Nonconformity::Panic { call: call() })
    }
}

/// Whether an error is one that subnormal doubles have: the number is, or is near, one of them.
fn is_tiny(error: &BigRational, exact: &BigRational) -> bool {
    let smallest = BigRational::from_float(f64::MIN_POSITIVE).expect("a finite number");
    let is_below = |x: &BigRational| *x < smallest && -x < smallest;
    is_below(exact) && is_below(error)
}

fn require(
    is_right: bool,
    call: impl FnOnce() -> String,
    answer: impl Debug,
    expected: &str,
) -> Asked {
    if is_right {
        return Ok(());
    }
    Err(Nonconformity::WrongAnswer {
        call: call(),
        answer: format!("{answer:?}"),
        expected: expected.to_owned(),
    })
}
