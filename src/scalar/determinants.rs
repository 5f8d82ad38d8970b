//! The determinants of the predicates, for numbers with exact arithmetic: big integers, GMP's numbers and your own.
//! Why it is right: the determinants are the polynomials of the definitions, computed exactly.
//! Cost: 7 operations for an orientation, 29 for the in-circle determinant, with the differences.

use core::cmp::Ordering;

/// A number with the three exact operations that determinants take.
pub(super) trait Arithmetic: Clone + Ord {
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: &Self) -> Self;
    fn times(self, other: &Self) -> Self;
    /// The order of the number and zero.
    fn sign(&self) -> Ordering;
}

/// The orientation of three points.
pub(super) fn orient2d<T: Arithmetic>([a, b, c]: [&[T; 2]; 3]) -> Ordering {
    turn(&minus(a, c), &minus(b, c))
}

/// The side of the circle through the first three points on which the last lies.
pub(super) fn in_circle<T: Arithmetic>([a, b, c, d]: [&[T; 2]; 4]) -> Ordering {
    determinant(&[a, b, c].map(|p| minus(p, d))).sign()
}

pub(super) fn minus<T: Arithmetic>(a: &[T; 2], b: &[T; 2]) -> [T; 2] {
    [a[0].clone().minus(&b[0]), a[1].clone().minus(&b[1])]
}

/// The sign of the turn from `a` to `b`, two differences to the same point.
pub(super) fn turn<T: Arithmetic>(a: &[T; 2], b: &[T; 2]) -> Ordering {
    let left = a[0].clone().times(&b[1]);
    left.cmp(&a[1].clone().times(&b[0]))
}

/// The in-circle determinant whose rows are the differences of three points to a fourth.
pub(super) fn determinant<T: Arithmetic>([a, b, c]: &[[T; 2]; 3]) -> T {
    let of_a = square(a).times(&cross(b, c));
    let of_b = square(b).times(&cross(c, a));
    let of_c = square(c).times(&cross(a, b));
    of_a.plus(of_b).plus(of_c)
}

pub(super) fn cross<T: Arithmetic>(p: &[T; 2], q: &[T; 2]) -> T {
    let left = p[0].clone().times(&q[1]);
    left.minus(&p[1].clone().times(&q[0]))
}

pub(super) fn dot<T: Arithmetic>(p: &[T; 2], q: &[T; 2]) -> T {
    let x = p[0].clone().times(&q[0]);
    x.plus(p[1].clone().times(&q[1]))
}

pub(super) fn square<T: Arithmetic>(p: &[T; 2]) -> T {
    dot(p, p)
}
