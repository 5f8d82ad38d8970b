//! Two doubles that are added, subtracted and multiplied together, in one register where the machine has such ones.
//! Why it is right: each lane is rounded as a double alone is. So results are the same on every machine.
//! Cost: an instruction for both lanes. Arrays of two take a fifth more instructions in the in-circle test.

use core::ops::{Add, Mul, Sub};

use wide::f64x2;

/// A low and a high lane.
#[derive(Clone, Copy)]
pub(super) struct Lanes(f64x2);

impl Lanes {
    #[inline(always)]
    pub(super) fn new(lanes: [f64; 2]) -> Lanes {
        Lanes(f64x2::new(lanes))
    }

    #[inline(always)]
    pub(super) fn low(self) -> f64 {
        let [low, _] = self.0.to_array();
        low
    }

    #[inline(always)]
    pub(super) fn high(self) -> f64 {
        let [_, high] = self.0.to_array();
        high
    }

    #[inline(always)]
    pub(super) fn swapped(self) -> Lanes {
        Lanes::new([self.high(), self.low()])
    }

    /// The low lanes of `self` and `high`, as `highs` takes the high ones.
    #[inline(always)]
    pub(super) fn lows(self, high: Lanes) -> Lanes {
        Lanes::new([self.low(), high.low()])
    }

    #[inline(always)]
    pub(super) fn highs(self, high: Lanes) -> Lanes {
        Lanes::new([self.high(), high.high()])
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Lanes {
        Lanes(self.0.abs())
    }
}

impl Add for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn add(self, other: Lanes) -> Lanes {
        Lanes(self.0 + other.0)
    }
}

impl Sub for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn sub(self, other: Lanes) -> Lanes {
        Lanes(self.0 - other.0)
    }
}

impl Mul for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn mul(self, other: Lanes) -> Lanes {
        Lanes(self.0 * other.0)
    }
}
