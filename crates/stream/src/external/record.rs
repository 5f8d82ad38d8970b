//! What is sorted: points, and edges at their lower ends.
//!
//! Records are compared by y, then x, then number: the order of the sweep, and of equal places the first number. No
//! coordinate is NaN, and none is -0.0, so that `<` is a total order of them. A number occurs once in a sort, so no two
//! records are equal.
//!
//! On disk a point takes 20 bytes: a run of points holds consecutive ones, so that four bytes tell how far the number is
//! from the first of them. Its height takes 8 more, where there are heights. An edge takes 40.

use std::cmp::Ordering;

/// A record that is sorted by its place and its number.
pub(crate) trait Record: Copy + Default + Send + Sync + 'static {
    /// How many bytes it takes on disk.
    const BYTES: usize;

    /// The parts of the memory, of 32, that a run takes.
    const PARTS: usize;

    /// The coordinate that decides first.
    fn y(&self) -> f64;

    /// The coordinate that decides among equal y.
    fn x(&self) -> f64;

    /// What decides among equal places.
    fn number(&self) -> u64;

    /// Fills so many bytes; `first` is the least number of the run.
    fn write(&self, first: u64, bytes: &mut [u8]);

    /// What was written so.
    fn read(first: u64, bytes: &[u8]) -> Self;

    /// The order of records.
    fn compare(&self, other: &Self) -> Ordering {
        let key = |record: &Self| (record.y(), record.x(), record.number());
        key(self)
            .partial_cmp(&key(other))
            .unwrap_or(Ordering::Equal)
    }
}

/// A point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Point {
    pub(crate) y: f64,
    pub(crate) x: f64,
    pub(crate) number: u64,
}

impl Record for Point {
    const BYTES: usize = 20;
    const PARTS: usize = 9;

    fn y(&self) -> f64 {
        self.y
    }

    fn x(&self) -> f64 {
        self.x
    }

    fn number(&self) -> u64 {
        self.number
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "a run has fewer than 2^32 points, and their numbers are consecutive"
    )]
    fn write(&self, first: u64, bytes: &mut [u8]) {
        bytes[..8].copy_from_slice(&self.y.to_le_bytes());
        bytes[8..16].copy_from_slice(&self.x.to_le_bytes());
        bytes[16..20].copy_from_slice(&((self.number - first) as u32).to_le_bytes());
    }

    fn read(first: u64, bytes: &[u8]) -> Point {
        Point {
            y: f64::from_le_bytes(array(bytes, 0)),
            x: f64::from_le_bytes(array(bytes, 8)),
            number: first + u64::from(u32::from_le_bytes(array(bytes, 16))),
        }
    }
}

/// A record that is a point, with a height or without.
pub(crate) trait Located: Record {
    /// The record of a point, with this height if it has room for one.
    fn new(point: Point, height: f64) -> Self;

    /// The point.
    fn point(&self) -> Point;

    /// The height, NaN where there is none.
    fn height(&self) -> f64;
}

impl Located for Point {
    fn new(point: Point, _height: f64) -> Point {
        point
    }

    fn point(&self) -> Point {
        *self
    }

    fn height(&self) -> f64 {
        f64::NAN
    }
}

/// A point with its height.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Raised {
    point: Point,
    height: f64,
}

impl Record for Raised {
    const BYTES: usize = Point::BYTES + 8;
    const PARTS: usize = Point::PARTS;

    fn y(&self) -> f64 {
        self.point.y
    }

    fn x(&self) -> f64 {
        self.point.x
    }

    fn number(&self) -> u64 {
        self.point.number
    }

    fn write(&self, first: u64, bytes: &mut [u8]) {
        self.point.write(first, bytes);
        bytes[Point::BYTES..Raised::BYTES].copy_from_slice(&self.height.to_le_bytes());
    }

    fn read(first: u64, bytes: &[u8]) -> Raised {
        Raised {
            point: Point::read(first, bytes),
            height: f64::from_le_bytes(array(bytes, Point::BYTES)),
        }
    }
}

impl Located for Raised {
    fn new(point: Point, height: f64) -> Raised {
        Raised { point, height }
    }

    fn point(&self) -> Point {
        self.point
    }

    fn height(&self) -> f64 {
        self.height
    }
}

/// An edge: its lower end, its number, its upper end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Edge {
    pub(crate) y: f64,
    pub(crate) x: f64,
    pub(crate) number: u64,
    pub(crate) upper: [f64; 2],
}

impl Record for Edge {
    const BYTES: usize = 40;
    const PARTS: usize = 4;

    fn y(&self) -> f64 {
        self.y
    }

    fn x(&self) -> f64 {
        self.x
    }

    fn number(&self) -> u64 {
        self.number
    }

    fn write(&self, _first: u64, bytes: &mut [u8]) {
        bytes[..8].copy_from_slice(&self.y.to_le_bytes());
        bytes[8..16].copy_from_slice(&self.x.to_le_bytes());
        bytes[16..24].copy_from_slice(&self.number.to_le_bytes());
        bytes[24..32].copy_from_slice(&self.upper[0].to_le_bytes());
        bytes[32..40].copy_from_slice(&self.upper[1].to_le_bytes());
    }

    fn read(_first: u64, bytes: &[u8]) -> Edge {
        Edge {
            y: f64::from_le_bytes(array(bytes, 0)),
            x: f64::from_le_bytes(array(bytes, 8)),
            number: u64::from_le_bytes(array(bytes, 16)),
            upper: [
                f64::from_le_bytes(array(bytes, 24)),
                f64::from_le_bytes(array(bytes, 32)),
            ],
        }
    }
}

/// The bytes of a number that stands at a place.
pub(crate) fn array<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    bytes[at..at + N]
        .try_into()
        .expect("as many bytes as were asked for")
}
