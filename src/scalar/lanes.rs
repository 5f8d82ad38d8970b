use std::ops::{Add, Mul, Sub};
use wide::f64x2;
#[derive(Clone, Copy)]
pub(super) struct Lanes(f64x2);
impl Lanes {
    #[inline(always)]
    pub(super) fn new(x: [f64; 2]) -> Lanes { Lanes(f64x2::new(x)) }
    #[inline(always)]
    pub(super) fn lows(self, other: Lanes) -> Lanes { let (a, b) = (self.0.to_array(), other.0.to_array()); Lanes(f64x2::new([a[0], b[0]])) }
    #[inline(always)]
    pub(super) fn highs(self, other: Lanes) -> Lanes { let (a, b) = (self.0.to_array(), other.0.to_array()); Lanes(f64x2::new([a[1], b[1]])) }
    #[inline(always)]
    pub(super) fn swapped(self) -> Lanes { let a = self.0.to_array(); Lanes(f64x2::new([a[1], a[0]])) }
    #[inline(always)]
    pub(super) fn abs(self) -> Lanes { Lanes(self.0.abs()) }
    #[inline(always)]
    pub(super) fn low(self) -> f64 { self.0.to_array()[0] }
}
impl Add for Lanes { type Output = Lanes; #[inline(always)] fn add(self, o: Lanes) -> Lanes { Lanes(self.0 + o.0) } }
impl Sub for Lanes { type Output = Lanes; #[inline(always)] fn sub(self, o: Lanes) -> Lanes { Lanes(self.0 - o.0) } }
impl Mul for Lanes { type Output = Lanes; #[inline(always)] fn mul(self, o: Lanes) -> Lanes { Lanes(self.0 * o.0) } }
