//! The coordinates that a program takes: whole numbers, doubles or single precision, between two sizes.
//!
//! Points are moved into a set by a power of two, which keeps what is degenerate about them, as far as the set allows.

use std::fmt;
use std::str::FromStr;

/// A set of coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numbers {
    kind: Kind,
    least: f64,
    most: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Integers,
    Single,
    Doubles,
}

impl Numbers {
    /// All finite doubles.
    pub const DOUBLES: Numbers = Numbers {
        kind: Kind::Doubles,
        least: 5e-324,
        most: f64::MAX,
    };

    /// Whole numbers of so many bits and a sign, up to 53.
    pub fn integers(bits: u32) -> Numbers {
        let most = 2f64.powi(bits.min(53).cast_signed()) - 1.0;
        Numbers {
            kind: Kind::Integers,
            least: 1.0,
            most,
        }
    }

    /// Zero, and doubles whose size is from `least` to `most`.
    pub fn doubles(least: f64, most: f64) -> Numbers {
        Numbers {
            kind: Kind::Doubles,
            least,
            most,
        }
    }

    /// Zero, and numbers of single precision whose size is from `least` to `most`.
    pub fn single(least: f64, most: f64) -> Numbers {
        let (low, high) = (to_single(least), to_single(most.min(f64::from(f32::MAX))));
        let low = if f64::from(low) < least {
            low.next_up()
        } else {
            low
        };
        let high = if f64::from(high) > most {
            high.next_down()
        } else {
            high
        };
        Numbers {
            kind: Kind::Single,
            least: low.into(),
            most: high.into(),
        }
    }

    /// Whether a coordinate is one of them.
    pub fn has(&self, x: f64) -> bool {
        let size = x.abs();
        let has_digits = match self.kind {
            Kind::Integers => x.fract() == 0.0,
            Kind::Single => f64::from(to_single(x)) == x,
            Kind::Doubles => true,
        };
        x == 0.0 || has_digits && (self.least..=self.most).contains(&size)
    }

    /// Moves points into the set: by a power of two, which changes nothing else, and then each coordinate to one
    /// nearby. `stretch` is how far the largest coordinate is to be from the limit, in bits; `None` leaves what fits.
    pub fn fit(&self, points: &mut [[f64; 2]], stretch: Option<u8>) {
        let sizes = || {
            points
                .as_flattened()
                .iter()
                .map(|x| x.abs())
                .filter(|x| *x > 0.0)
        };
        let (least, most) = sizes().fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        let fits = points.as_flattened().iter().all(|&x| self.has(x));
        if most == 0.0 || fits && stretch.is_none() {
            return;
        }
        let room = exponent(self.most) - exponent(most) - i32::from(most > self.most);
        let below = exponent(self.least) - exponent(least) + 1;
        let shift = match stretch {
            Some(bits) => (room - i32::from(bits)).max(below.min(room)),
            None if self.kind == Kind::Integers => room,
            None => below.max(0).min(room),
        };
        for x in points.as_flattened_mut() {
            *x = self.nearest(times_power(*x, shift));
        }
    }

    /// A number of the set next to this one.
    pub fn nearest(&self, x: f64) -> f64 {
        let x = match self.kind {
            Kind::Integers => x.round(),
            Kind::Single => f64::from(to_single(x)),
            Kind::Doubles => x,
        };
        if x.abs() < self.least {
            0.0
        } else {
            x.clamp(-self.most, self.most)
        }
    }

    /// The next number of the set, up or down; the number itself at the end of the set.
    pub fn next(&self, x: f64, is_up: bool) -> f64 {
        let next = match (self.kind, is_up) {
            (Kind::Integers, true) => x + 1.0,
            (Kind::Integers, false) => x - 1.0,
            (Kind::Single, true) => f64::from(to_single(x).next_up()),
            (Kind::Single, false) => f64::from(to_single(x).next_down()),
            (Kind::Doubles, true) => x.next_up(),
            (Kind::Doubles, false) => x.next_down(),
        };
        if self.has(next) { next } else { x }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to single precision is meant"
)]
fn to_single(x: f64) -> f32 {
    x as f32
}

/// The exponent of two of a number above zero.
fn exponent(x: f64) -> i32 {
    let x = if x < f64::MIN_POSITIVE {
        (x * 2f64.powi(64), -64)
    } else {
        (x, 0)
    };
    i32::try_from(x.0.to_bits() >> 52).expect("twelve bits") - 1023 + x.1
}

/// A number times a power of two, but for the rounding of subnormals.
fn times_power(x: f64, power: i32) -> f64 {
    // From the smallest double to the largest one is more than one factor can be.
    let third = power / 3;
    x * 2f64.powi(third) * 2f64.powi(third) * 2f64.powi(power - 2 * third)
}

/// `integers:BITS`, `doubles`, `single`, `doubles:LEAST..MOST`, or `single:LEAST..MOST`.
impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Numbers, String> {
        let error = || {
            format!(
                "`{text}` is no integers:BITS, doubles, single, doubles:LEAST..MOST, or single:LEAST..MOST"
            )
        };
        let limits = |limits: &str| {
            let (least, most) = limits.split_once("..").ok_or_else(error)?;
            let [least, most] = [least, most].map(|x| x.parse::<f64>().ok().filter(|x| *x > 0.0));
            match (least, most) {
                (Some(least), Some(most)) if least < most && most.is_finite() => Ok((least, most)),
                _ => Err(error()),
            }
        };
        match text.split_once(':') {
            None if text == "doubles" => Ok(Numbers::DOUBLES),
            None if text == "single" => Ok(Numbers::single(f64::from(f32::MIN_POSITIVE), f64::MAX)),
            Some(("integers", bits)) => {
                let bits = bits.parse().ok().filter(|bits| (1..=53).contains(bits));
                bits.map(Numbers::integers).ok_or_else(error)
            }
            Some(("doubles", text)) => {
                limits(text).map(|(least, most)| Numbers::doubles(least, most))
            }
            Some(("single", text)) => {
                limits(text).map(|(least, most)| Numbers::single(least, most))
            }
            _ => Err(error()),
        }
    }
}

impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Numbers { kind, least, most } = self;
        match kind {
            Kind::Integers => write!(f, "integers:{}", exponent(most + 1.0)),
            Kind::Single => write!(f, "single:{least:e}..{most:e}"),
            Kind::Doubles => write!(f, "doubles:{least:e}..{most:e}"),
        }
    }
}

#[test]
fn numbers_are_fitted_into_their_set() {
    let names = [
        "integers:1",
        "integers:20",
        "integers:53",
        "single:1e-20..1e30",
        "doubles:1e-9..1e15",
        "doubles:5e-324..1e0",
        "doubles:5e-324..1.7976931348623157e308",
    ];
    for name in names {
        let numbers: Numbers = name.parse().expect("a set");
        assert_eq!(numbers.to_string().parse(), Ok(numbers), "{name}");
        for scale in [5e-324, 1e-300, 1e-5, 1.0, 7.0, 1e20, 1e307] {
            for stretch in [None, Some(0), Some(3), Some(200)] {
                let mut points = [
                    [scale, 2.0 * scale],
                    [0.0, -3.0 * scale],
                    [4.0 * scale, 4.5 * scale],
                ];
                numbers.fit(&mut points, stretch);
                let all = points.as_flattened();
                assert!(
                    all.iter().all(|&x| numbers.has(x)),
                    "{name} {scale} {stretch:?}: {points:?}"
                );
                assert!(
                    all.iter().any(|&x| x != 0.0),
                    "{name} {scale} {stretch:?}: {points:?}"
                );
            }
        }
    }
    let mut small = [[3.0, 5.0], [0.0, 1.0]];
    Numbers::integers(20).fit(&mut small, None);
    assert_eq!(small, [[3.0, 5.0], [0.0, 1.0]]);
    Numbers::integers(20).fit(&mut small, Some(0));
    assert_eq!(small[0], [3.0 * 131_072.0, 5.0 * 131_072.0]);
    for wrong in [
        "integers:0",
        "integers:54",
        "doubles:1..inf",
        "single:3..2",
        "reals",
    ] {
        assert!(wrong.parse::<Numbers>().is_err(), "{wrong}");
    }
}
