//! Random numbers from a seed: the same ones on every run and every platform.

/// Steele, Lea and Flood's `SplitMix64`.
///
/// ```
/// use sweep_cdt_generate::Random;
///
/// let [mut one, mut other] = [Random::new(7), Random::new(7)];
/// assert_eq!(one.points(3), other.points(3));
/// assert!((0..10).contains(&one.below(10)));
/// ```
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of this seed.
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to `below` - 1.
    pub fn below(&mut self, below: usize) -> usize {
        usize::try_from(self.bits() % below as u64).expect("fits as `below` does")
    }

    /// An integer from `-limit` to `limit`, as a double.
    pub fn integer(&mut self, limit: u64) -> f64 {
        (self.bits() % (2 * limit + 1)) as f64 - limit as f64
    }

    /// A multiple of 2^-53 from 0 up to, but not, 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Random points in the unit square.
    pub fn points(&mut self, count: usize) -> Vec<[f64; 2]> {
        (0..count).map(|_| [self.unit(), self.unit()]).collect()
    }

    /// True one time in `n`.
    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// One of these.
    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// Puts the list in a random order.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }

    /// A random byte.
    pub fn byte(&mut self) -> u8 {
        self.bits().to_le_bytes()[0]
    }

    /// Random bytes.
    pub fn bytes(&mut self, n: usize) -> Vec<u8> {
        (0..n).map(|_| self.byte()).collect()
    }
}
