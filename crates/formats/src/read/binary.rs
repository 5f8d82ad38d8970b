//! Numbers as the bytes of binary files: of one of nine machine types, in one of two orders.
//!
//! Each of them is a double, so that coordinates arrive as they were written; but for whole numbers of 64 bits, which are
//! rounded and no coordinates.

/// How the bytes of a number stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    /// The type.
    pub kind: Kind,
    /// Whether the most significant byte comes first.
    pub big_endian: bool,
}

/// A machine type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// A whole number of 8 bits, with a sign.
    I8,
    /// A whole number of 8 bits, without a sign.
    U8,
    /// A whole number of 16 bits, with a sign.
    I16,
    /// A whole number of 16 bits, without a sign.
    U16,
    /// A whole number of 32 bits, with a sign.
    I32,
    /// A whole number of 32 bits, without a sign.
    U32,
    /// A whole number of 64 bits, with a sign.
    I64,
    /// A float of 32 bits.
    F32,
    /// A double.
    F64,
}

impl Kind {
    /// How many bytes a number has.
    #[must_use]
    pub fn size(self) -> usize {
        match self {
            Kind::I8 | Kind::U8 => 1,
            Kind::I16 | Kind::U16 => 2,
            Kind::I32 | Kind::U32 | Kind::F32 => 4,
            Kind::I64 | Kind::F64 => 8,
        }
    }
}

impl Number {
    /// The value of as many bytes as such a number has; NaN for any others.
    #[must_use]
    pub fn value(self, piece: &[u8]) -> f64 {
        let value = match self.kind {
            Kind::I8 => self.ordered(piece).map(|[a]| f64::from(a.cast_signed())),
            Kind::U8 => self.ordered(piece).map(|[a]| f64::from(a)),
            Kind::I16 => self.ordered(piece).map(|b| i16::from_be_bytes(b).into()),
            Kind::U16 => self.ordered(piece).map(|b| u16::from_be_bytes(b).into()),
            Kind::I32 => self.ordered(piece).map(|b| i32::from_be_bytes(b).into()),
            Kind::U32 => self.ordered(piece).map(|b| u32::from_be_bytes(b).into()),
            Kind::I64 => self.ordered(piece).map(|b| i64::from_be_bytes(b) as f64),
            Kind::F32 => self.ordered(piece).map(|b| f32::from_be_bytes(b).into()),
            Kind::F64 => self.ordered(piece).map(f64::from_be_bytes),
        };
        value.unwrap_or(f64::NAN)
    }

    /// The value as the number of a vertex or a count.
    #[must_use]
    pub fn index(self, piece: &[u8]) -> Option<usize> {
        let value = self.value(piece);
        let is_index = value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it is whole and in range"
        )]
        is_index.then_some(value as usize)
    }

    /// The bytes with the most significant one first.
    fn ordered<const N: usize>(self, piece: &[u8]) -> Option<[u8; N]> {
        let mut bytes: [u8; N] = piece.try_into().ok()?;
        if !self.big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }
}
