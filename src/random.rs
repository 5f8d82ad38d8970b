//! Random numbers, fixed: *random* and *expected* speak of the order in which the input meets them.

/// Marsaglia's xorshift: the same numbers in every run and on every machine.
#[derive(Debug)]
pub(crate) struct Random(u32);

impl Random {
    pub(crate) fn new() -> Random {
        Random(0x2545_F491)
    }

    /// A number below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0 as usize % n
    }

    pub(crate) fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }
}
