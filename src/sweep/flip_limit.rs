//! How many sides may be flipped before the sweep changes its heuristics, before it is abandoned, and before
//! the scalar must be wrong.
//!
//! The *budget* grows with the work: by some flips for each vertex swept, each corner of a chain that is
//! filled, and each vertex when the hull is completed. What the sweep does not need at once it may keep, but
//! no more than a *reserve*. So the budget is linear in the size of the input and what its edges pierce, and
//! a stretch of the sweep that needs far more flips is noticed soon. Ordinary inputs need a small part of
//! it. When it is spent, divide and conquer takes over ([`crate::Algorithm::Auto`]).
//!
//! The *excess* is what the sweep flips beyond four for each vertex. Where it grows, the sweep goes on with
//! the paper's heuristics; when it is gone, with the caller's again. Wide corners flip least on most data.
//! But where points crowd in clusters within clusters they flip two to four times as much as the paper's
//! corners and basins.
//!
//! Where bands are joined, the reserve is all there is.
//!
//! The *limit* is quadratic, and no exact scalar can reach it: a flip lowers the lifted surface, so a side
//! that was flipped away does not come back before the next edge is inserted. With n vertices and two
//! artificial ones there are fewer than (n + 2)^2 / 2 sides. A scalar that reaches the limit contradicts
//! itself: each of its signs may look right, but together they belong to no points. Without a limit its
//! flips might never end.
//!
//! Cost: one subtraction a flip.
//!
//! Differs from the paper: it sets no limits.

/// Flips that the budget grants for each vertex swept.
const FOR_VERTEX: u64 = 8;
/// Flips that it grants for each corner of a chain.
const FOR_CORNER: u64 = 4;
/// Flips that it grants for each vertex when the hull is completed: to begin anew so late costs more.
const FOR_HULL: u64 = 2;
/// The reserve: half a flip for each vertex, and these.
const RESERVE: u64 = 1000;
/// Flips for each vertex that are no excess.
const COMMON: u64 = 4;
/// The part of the reserve that the excess must reach for the paper's heuristics: a later change helps less.
const FOR_PAPER: u64 = 8;

/// What is left of the budget or of the limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlipLimit {
    left: u64,
    reserve: u64,
    most: u64,
    stage: Stage,
    /// What was left when the excess was last counted, and what was granted since.
    counted: u64,
    excess: u64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// The budget is being spent.
    Budget,
    /// It is spent, and the limit is what is left.
    Spent,
    /// There is no budget, only the limit.
    Limit,
}

impl FlipLimit {
    /// The limit for this many vertices; `has_budget` if there is a budget before it.
    pub(super) fn new(vertices: usize, has_budget: bool) -> FlipLimit {
        let n = vertices as u64;
        let most = (n + 2).saturating_mul(n + 2);
        let reserve = n / 2 + RESERVE;
        let (left, stage) = if has_budget {
            (reserve, Stage::Budget)
        } else {
            (most, Stage::Limit)
        };
        FlipLimit {
            left,
            reserve,
            most,
            stage,
            counted: left,
            excess: 0,
        }
    }

    /// So many vertices have been swept: the budget grows up to the reserve.
    #[inline(always)]
    pub(super) fn grant_for_vertices(&mut self, swept: u32) {
        if self.stage == Stage::Budget {
            let swept = u64::from(swept);
            let flips = self.counted - self.left;
            self.excess = (self.excess + flips).saturating_sub(COMMON * swept);
            let left = self.left + FOR_VERTEX * swept;
            self.left = left.min(self.reserve);
            self.counted = self.left;
        }
    }

    /// Whether the sweep should go on with the paper's heuristics.
    #[inline(always)]
    pub(super) fn is_excessive(&self) -> bool {
        self.excess > self.reserve / FOR_PAPER
    }

    /// The hull of so many vertices will be completed.
    pub(super) fn grant_for_hull(&mut self, vertices: usize) {
        self.grant(FOR_HULL * vertices as u64);
    }

    /// A chain of so many corners will be filled.
    pub(super) fn grant_for_chain(&mut self, corners: usize) {
        self.grant(FOR_CORNER * corners as u64);
    }

    fn grant(&mut self, flips: u64) {
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

    /// Counts a flip.
    #[inline(always)]
    pub(super) fn spend(&mut self) {
        self.left -= 1;
        if self.left == 0 {
            self.reached();
        }
    }

    /// An edge has been inserted: sides may come back once more.
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

/// What only signs that contradict each other can lead to.
#[cold]
#[inline(never)]
pub(super) fn inexact_scalar() -> ! {
    panic!("the scalar is not exact: its predicates contradict each other");
}
