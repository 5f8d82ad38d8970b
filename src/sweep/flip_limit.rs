//! How many flips change the heuristics, abandon the sweep, or prove the scalar wrong. Cost: one subtraction a flip.
//!
//! The *budget* grows with the work: by some flips for each vertex swept, each corner of a chain that is filled, and
//! each vertex when the hull is completed. Long walks along the front spend it, too. Unused flips are kept, up to a
//! *reserve*. So the budget is linear in the size of the input and what its edges pierce, and vertices that need far more
//! flips are noticed soon. Ordinary inputs need a small part of the budget. When it is spent, divide and conquer takes
//! over ([`crate::Algorithm::Auto`]). Where bands are joined, the reserve is the whole budget.
//!
//! The *excess* is what the sweep flips beyond four flips for each vertex. While it is large, the sweep uses the
//! paper's heuristics; when it is gone, the caller's again. Wide corners flip least on most data. But where points
//! crowd in clusters within clusters, they flip two to four times as much as the paper's corners and basins.
//!
//! When the budget is spent or there is none, the *limit* counts, which proves the scalar wrong ([`super::contradiction`]).

use super::contradiction::inexact_scalar;
use crate::tuning::{
    COMMON_FLIPS, FLIPS_FOR_CORNER, FLIPS_FOR_HULL, FLIPS_FOR_VERTEX, RESERVE_FOR_PAPER,
    STEPS_FOR_FLIP,
};

/// The flips that are left of the budget or of the limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlipLimit {
    left: u64,
    reserve: u64,
    most: u64,
    stage: Stage,
    /// The value of `left` when the excess was last counted, plus all flips granted since.
    counted: u64,
    excess: u64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// The budget is being spent.
    Budget,
    /// The budget is spent, and the limit counts.
    Spent,
    /// There is no budget, only the limit.
    Limit,
}

impl FlipLimit {
    /// The limit for `vertices` vertices, after a budget with this [`reserve`](crate::Tuning), if one is given.
    pub(super) fn new(vertices: usize, reserve: Option<u64>) -> FlipLimit {
        let n = vertices as u64;
        let most = (n + 2).saturating_mul(n + 2);
        let (left, stage) = match reserve {
            Some(reserve) => (n / 2 + reserve, Stage::Budget),
            None => (most, Stage::Limit),
        };
        FlipLimit {
            left,
            reserve: left,
            most,
            stage,
            counted: left,
            excess: 0,
        }
    }

    /// Grants the budget of `swept` more vertices, up to the reserve, and counts the excess.
    #[inline(always)]
    pub(super) fn grant_for_vertices(&mut self, swept: u32) {
        if self.stage == Stage::Budget {
            let swept = u64::from(swept);
            let flips = self.counted - self.left;
            self.excess = (self.excess + flips).saturating_sub(COMMON_FLIPS * swept);
            let left = self.left + FLIPS_FOR_VERTEX * swept;
            self.left = left.min(self.reserve);
            self.counted = self.left;
        }
    }

    /// Whether the sweep should go on with the paper's heuristics.
    #[inline(always)]
    pub(super) fn is_excessive(&self) -> bool {
        self.excess > self.reserve / RESERVE_FOR_PAPER
    }

    pub(super) fn grant_for_hull(&mut self, vertices: usize) {
        self.grant(FLIPS_FOR_HULL * vertices as u64);
    }

    pub(super) fn grant_for_chain(&mut self, corners: usize) {
        self.grant(FLIPS_FOR_CORNER * corners as u64);
    }

    /// Grants more flips.
    pub(super) fn grant(&mut self, flips: u64) {
        if self.stage == Stage::Budget {
            self.left += flips;
            self.counted += flips;
        }
    }

    /// Whether the sweep should be abandoned.
    #[inline(always)]
    pub(super) fn is_spent(&self) -> bool {
        self.stage == Stage::Spent
    }

    #[inline(always)]
    pub(super) fn spend(&mut self) {
        self.left -= 1;
        if self.left == 0 {
            self.reached();
        }
    }

    /// Spends what a long walk along the front costs, if there is a budget.
    #[cold]
    pub(super) fn spend_steps(&mut self, steps: usize) {
        if self.stage == Stage::Budget {
            let flips = (steps as u64 / STEPS_FOR_FLIP).min(self.left);
            self.left -= flips;
            self.counted -= flips;
            if self.left == 0 {
                self.reached();
            }
        }
    }

    /// Renews the limit after an edge has been inserted: sides may come back once more.
    pub(super) fn reset(&mut self) {
        if self.stage != Stage::Budget {
            self.left = self.most;
        }
    }

    #[cold]
    #[inline(never)]
    fn reached(&mut self) {
        if self.stage != Stage::Budget {
            inexact_scalar();
        }
        (self.stage, self.left) = (Stage::Spent, self.most);
    }
}
