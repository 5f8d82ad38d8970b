//! What each part of the sorting may take of the memory: one account, so that the sum is a bound.
//!
//! In parts of 32, of which no step takes more than there are:
//!
//! | step | what is held |
//! |---|---|
//! | points are sorted in runs | 27: a run that is filled, one that is sorted, and as much beside it |
//! | edges are joined to ends | 9 points, if they are one run; 6 places of a run; 8 a run of edges, and as much beside it; 4 edges that wait for a run |
//! | the order is taken | 9 blocks of runs of points, or all points; 4 the same for edges; 3 batches of both; 16 are free |
//!
//! Blocks are no shorter than [`SHORTEST`], so that the number of runs is limited, and with it what is held for each. Where
//! that is too little, [`Account::needed`] finds the least memory by the same rules, and what it says suffices. Pieces of
//! files, blocks of an input and stacks have constant sizes, and are not in the account; nor are the edges of one vertex,
//! which are in memory together.

use crate::external::record::{Edge, Record};

/// No block of a run that is merged has fewer records.
const SHORTEST: usize = 16;
/// No block is longer, in bytes.
const LONGEST: usize = 1 << 20;
/// No batch has more records, so that it is sorted in a cache.
const BATCH: usize = 1 << 14;
/// The bytes that are held for a run beside its block, or for its edges that wait beside themselves.
const EACH: usize = 80;

/// The memory that may be used, in bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Account(pub(crate) u64);

impl Account {
    fn parts(self, parts: usize) -> usize {
        usize::try_from(self.0 / 32).map_or(usize::MAX, |part| part.saturating_mul(parts))
    }

    /// How many records a run has. Their places in it have 32 bits.
    pub(crate) fn run<R: Record>(self) -> usize {
        (self.parts(R::PARTS) / size_of::<R>()).clamp(1, u32::MAX as usize)
    }

    /// How many runs can be merged, at most.
    pub(crate) fn runs<R: Record>(self) -> usize {
        // A block is read through a buffer that is as long.
        let blocks = self.parts(R::PARTS) / (SHORTEST * size_of::<R>() + EACH);
        blocks.saturating_sub(1)
    }

    /// How many records of each of so many runs are in memory.
    pub(crate) fn block<R: Record>(self, runs: usize) -> usize {
        let each = self.parts(R::PARTS) / (runs + 1);
        each.saturating_sub(EACH).min(LONGEST) / size_of::<R>()
    }

    /// How many bytes of edges wait in memory for each of so many runs.
    pub(crate) fn bucket(self, runs: usize) -> usize {
        (self.parts(2) / runs).saturating_sub(EACH / 2)
    }

    /// How many points a batch has, and after how many edges it ends. Of batches one is in use, one waits and one is made,
    /// each in lists that may have grown twofold; records are merged into one more, with as much beside it.
    pub(crate) fn batch(self) -> usize {
        usize::try_from(self.0 / 8192).map_or(BATCH, |most| most.clamp(1, BATCH))
    }

    /// The least memory that suffices for so many points of a kind, and edges, in whole KiB.
    pub(crate) fn needed<P: Record>(points: u64, edges: u64) -> u64 {
        let (mut less, mut enough) = (0, 1 << 50);
        while enough - less > 1 {
            let middle = less + (enough - less) / 2;
            let account = Account(middle << 10);
            if account.suffices::<P>(points) && account.suffices::<Edge>(edges) {
                enough = middle;
            } else {
                less = middle;
            }
        }
        enough << 10
    }

    fn suffices<R: Record>(self, records: u64) -> bool {
        let runs = records.div_ceil(self.run::<R>() as u64);
        runs <= 1 || runs <= self.runs::<R>() as u64
    }
}
