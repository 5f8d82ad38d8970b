//! Four points at a time, of whole numbers in some unit: random ones, the ends of what so many bits hold, and points
//! on or next to a line or a circle, around zero and far from it.

use num_bigint::BigInt;
use num_rational::BigRational;

/// Numbers of bits at which types end, or begin to compute with more. Smaller ones come first, so that the first
/// wrong answer is one about small numbers.
const BITS: [u64; 44] = [
    1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 15, 16, 20, 24, 25, 26, 28, 30, 31, 32, 33, 40, 48, 51, 52,
    53, 54, 58, 60, 61, 62, 63, 64, 65, 80, 96, 120, 126, 127, 128, 130, 200, 600,
];
/// How many samples of each kind there are for each unit and number of bits.
const ROUNDS: usize = 2;

/// Units, as fractions of powers: `(base, exponent)`.
const UNITS: [(u8, i32); 18] = [
    (2, 0),
    (2, -1),
    (2, -4),
    (2, -8),
    (2, -16),
    (2, -24),
    (2, -32),
    (2, -60),
    (2, -200),
    (2, 20),
    (2, 300),
    (3, -1),
    (7, -1),
    (10, -1),
    (10, -2),
    (10, -3),
    (10, -6),
    (10, -9),
];

/// Four points in one unit.
pub(super) struct Sample {
    unit: BigRational,
    pub(super) points: [[BigInt; 2]; 4],
}

impl Sample {
    /// The points themselves.
    pub(super) fn fractions(&self) -> [[BigRational; 2]; 4] {
        let number = |x: &BigInt| &self.unit * x;
        self.points.each_ref().map(|p| p.each_ref().map(number))
    }
}

/// All samples in units that `exist`, the same each time.
pub(super) fn samples(exists: impl Fn(&BigRational) -> bool) -> impl Iterator<Item = Sample> {
    let power = |(base, exponent): (u8, i32)| BigRational::from(BigInt::from(base)).pow(exponent);
    let units: Vec<BigRational> = UNITS.map(power).into_iter().filter(exists).collect();
    let mut random = Random(1);
    let of_bits = move |bits| {
        let mut found = Vec::new();
        for unit in &units {
            for _ in 0..ROUNDS {
                let kinds = random.kinds(bits);
                let in_unit = |points| Sample {
                    unit: unit.clone(),
                    points,
                };
                found.extend(kinds.map(in_unit));
            }
        }
        found
    };
    BITS.into_iter().flat_map(of_bits)
}

/// A linear congruential generator (Knuth's MMIX), of which the high bits are used.
struct Random(u64);

impl Random {
    fn below(&mut self, count: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) % count
    }

    /// From -2^`bits` up to 2^`bits`, neither included.
    fn integer(&mut self, bits: u64) -> BigInt {
        let mut size = BigInt::from(0);
        for _ in 0..bits.div_ceil(32) {
            size = (size << 32_u32) + self.below(1 << 32);
        }
        let size = size >> (bits.div_ceil(32) * 32 - bits);
        if self.below(2) == 0 { size } else { -size }
    }

    fn point(&mut self, bits: u64) -> [BigInt; 2] {
        [self.integer(bits), self.integer(bits)]
    }

    /// The ends of so many bits with a sign, their neighbours, and zero.
    fn end(&mut self, bits: u64) -> BigInt {
        let power = BigInt::from(1) << bits;
        match self.below(6) {
            0 => power - 1,
            1 => -power,
            2 => 1 - power,
            3 => power >> 1_u32,
            4 => BigInt::from(self.below(3)) - 1,
            _ => self.integer(bits),
        }
    }

    /// One sample of each kind, of about so many bits.
    fn kinds(&mut self, bits: u64) -> [[[BigInt; 2]; 4]; 8] {
        let few = bits.min(6);
        let (far, near) = (self.point(bits), BigInt::from(1) << (bits / 2));
        let line = self.line(bits);
        let circle = self.circle(bits);
        let positive = self
            .circle(bits)
            .map(|p| p.map(|x| x + (BigInt::from(1) << bits)));
        let moved = |points: [[BigInt; 2]; 4]| points.map(|[x, y]| [x + &far[0], y + &far[1]]);
        [
            [(); 4].map(|()| self.point(bits)),
            [(); 4].map(|()| [self.end(bits), self.end(bits)]),
            line,
            circle,
            positive,
            moved(self.line(few)),
            moved(self.circle(few)),
            // Points one column, and a small figure beside numbers that are far larger.
            [(); 4].map(|()| [&near + self.integer(few), self.integer(bits)]),
        ]
    }

    /// Points on a line, the last three of which may be one unit off it.
    fn line(&mut self, bits: u64) -> [[BigInt; 2]; 4] {
        let (from, along) = (self.point(bits), self.point(bits.saturating_sub(2).max(1)));
        let mut factor = -1_i64;
        [(); 4].map(|()| {
            factor += 1;
            let nudge = self.below(4) / 3;
            [
                &from[0] + &along[0] * factor,
                &from[1] + &along[1] * factor + nudge,
            ]
        })
    }

    /// Points on a circle: a rectangle or a square, in any order that keeps its turn, each of which may be one unit
    /// off it.
    fn circle(&mut self, bits: u64) -> [[BigInt; 2]; 4] {
        let [[x, y], [z, w]] = [self.point(bits), self.point(bits)];
        let corners = if self.below(2) == 0 {
            [
                [x.clone(), y.clone()],
                [z.clone(), y],
                [z, w.clone()],
                [x, w],
            ]
        } else {
            // Half as many bits for the side, so that all corners have about as many.
            let [u, v] = self.point(bits.saturating_sub(1).max(1));
            [
                [x.clone(), y.clone()],
                [&x + &u, &y + &v],
                [&x + &u - &v, &y + &v + &u],
                [x - v, y + u],
            ]
        };
        corners.map(|[x, y]| [x, y + self.below(4) / 3])
    }
}
