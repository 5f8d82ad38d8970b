//! Numbers as texts, or as bytes of one of nine types in one of two orders.

/// How a number stands in a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) kind: Kind,
    pub(super) order: Order,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    Text,
    MostSignificantFirst,
    LeastSignificantFirst,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
    /// Only where numbers of vertices are meant.
    I64,
}

/// The types of coordinates.
const KINDS: [Kind; 8] = [
    Kind::I8,
    Kind::U8,
    Kind::I16,
    Kind::U16,
    Kind::I32,
    Kind::U32,
    Kind::F32,
    Kind::F64,
];

impl Kind {
    /// The type of this number, or the next one that holds all of these numbers; the last one holds all.
    pub(super) fn holding(number: u8, all: &[f64]) -> Kind {
        let first = usize::from(number) % KINDS.len();
        let holds = |kind: &&Kind| all.iter().all(|&x| kind.round(x) == x);
        *KINDS[first..].iter().find(holds).unwrap_or(&Kind::F64)
    }

    /// The nearest number of the type.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the type has no more digits"
    )]
    #[expect(clippy::cast_sign_loss, reason = "the least number is 0")]
    #[expect(clippy::cast_precision_loss, reason = "numbers of vertices are small")]
    fn round(self, x: f64) -> f64 {
        match self {
            Kind::I8 => (x as i8).into(),
            Kind::U8 => (x as u8).into(),
            Kind::I16 => (x as i16).into(),
            Kind::U16 => (x as u16).into(),
            Kind::I32 => (x as i32).into(),
            Kind::U32 => (x as u32).into(),
            Kind::I64 => x as i64 as f64,
            Kind::F32 => (x as f32).into(),
            Kind::F64 => x,
        }
    }
}

impl Form {
    /// Appends a number that the type holds; as text with a space behind it.
    #[expect(clippy::cast_possible_truncation, reason = "the type holds the number")]
    #[expect(clippy::cast_sign_loss, reason = "the type holds the number")]
    pub(super) fn put(self, x: f64, file: &mut Vec<u8>) {
        if self.order == Order::Text {
            // What is whole has no point.
            file.extend_from_slice(format!("{x} ").as_bytes());
            return;
        }
        let from = file.len();
        match self.kind {
            Kind::I8 => file.extend((x as i8).to_be_bytes()),
            Kind::U8 => file.extend((x as u8).to_be_bytes()),
            Kind::I16 => file.extend((x as i16).to_be_bytes()),
            Kind::U16 => file.extend((x as u16).to_be_bytes()),
            Kind::I32 => file.extend((x as i32).to_be_bytes()),
            Kind::U32 => file.extend((x as u32).to_be_bytes()),
            Kind::I64 => file.extend((x as i64).to_be_bytes()),
            Kind::F32 => file.extend((x as f32).to_be_bytes()),
            Kind::F64 => file.extend(x.to_be_bytes()),
        }
        if self.order == Order::LeastSignificantFirst {
            file[from..].reverse();
        }
    }

    /// Appends numbers of vertices, or counts.
    #[expect(clippy::cast_precision_loss, reason = "there are few vertices")]
    pub(super) fn put_indices(self, indices: &[usize], file: &mut Vec<u8>) {
        indices
            .iter()
            .for_each(|&index| self.put(index as f64, file));
    }

    /// Ends a record or an array.
    pub(super) fn end(self, file: &mut Vec<u8>) {
        if self.order == Order::Text {
            file.push(b'\n');
        }
    }
}
