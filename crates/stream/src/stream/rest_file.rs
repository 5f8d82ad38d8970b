//! Rests as files: words of 64 bits, which are whole numbers or doubles, little-endian.
//!
//! | words | what |
//! |---|---|
//! | 2 | the letters `sweeprst`, and the version, 1 |
//! | 3 | how many vertices the input has; the positions of the first vertex, and behind the last one |
//! | 6 | the least and the greatest x of the input; x and y of the first vertex, and of the last one |
//! | 3 | how many vertices, sides and open edges follow |
//! | 3 each | a vertex: the number, x, y |
//! | 4 each | a side: both ends, the edge that it is a piece of, its kind: 1 on the border, 2 on an edge, 3 on both |
//! | 7 each | an open edge: the number, x and y of both ends, the lowest and the highest vertex that is needed |
//! | 1 | the CRC-32 of all bytes before |
//!
//! Vertices are named by their places among those of the file. What a side or an edge does not have is 2^64 - 1.

use std::fmt;

use super::rest::{Cut, Open, Rest};
use super::window::{Origin, Window};

const MAGIC: u64 = u64::from_le_bytes(*b"sweeprst");
const VERSION: u64 = 1;
/// The place of no vertex, the edge of a side that is none.
const NONE: u64 = u64::MAX;

/// Why bytes are no rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RestError {
    /// They do not begin as a rest.
    Foreign,
    /// They are of a version that is not known.
    Version(u64),
    /// They are not as they were written.
    Damaged,
}

impl fmt::Display for RestError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RestError::Foreign => f.write_str("is no rest of a band"),
            RestError::Version(version) => {
                write!(f, "is a rest of version {version}, and {VERSION} is known")
            }
            RestError::Damaged => f.write_str("is damaged: it does not fit its checksum"),
        }
    }
}

impl std::error::Error for RestError {}

impl Rest<f64> {
    /// The bytes of a file. The same rest has the same bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Rest {
            cut,
            covered,
            ends,
            window,
            open,
        } = self;
        let mut words = vec![MAGIC, VERSION, cut.vertices, covered.start, covered.end];
        let places = cut.between.iter().chain(ends.as_flattened());
        words.extend(places.map(|x| x.to_bits()));
        words.extend([window.points.len(), window.edges.len(), open.len()].map(|n| n as u64));
        for (&number, [x, y]) in window.numbers().iter().zip(&window.points) {
            words.extend([number, x.to_bits(), y.to_bits()]);
        }
        for ([u, v], Origin { edge, is_border }) in window.edges.iter().zip(&window.origins) {
            let kind = u64::from(*is_border) + 2 * u64::from(edge.is_some());
            words.extend([*u as u64, *v as u64, edge.unwrap_or(NONE), kind]);
        }
        for (&edge, Open { ends, met }) in open {
            words.push(edge);
            words.extend(ends.as_flattened().iter().map(|x| x.to_bits()));
            words.extend(met.map(|v| v.map_or(NONE, |v| v as u64)));
        }
        let mut bytes: Vec<u8> = words.into_iter().flat_map(u64::to_le_bytes).collect();
        let sum = u64::from(crc32fast::hash(&bytes));
        bytes.extend(sum.to_le_bytes());
        bytes
    }

    /// The rest that a file holds.
    ///
    /// # Errors
    /// [`RestError`]: the bytes are none of [`to_bytes`](Rest::to_bytes).
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, RestError> {
        let (words, odd) = bytes.as_chunks::<8>();
        let mut words = words.iter().map(|&word| u64::from_le_bytes(word));
        if words.next() != Some(MAGIC) {
            return Err(RestError::Foreign);
        }
        match words.next() {
            Some(VERSION) => {}
            Some(version) => return Err(RestError::Version(version)),
            None => return Err(RestError::Damaged),
        }
        let sum = words.next_back().ok_or(RestError::Damaged)?;
        let summed = &bytes[..bytes.len() - odd.len() - 8];
        if !odd.is_empty() || sum != u64::from(crc32fast::hash(summed)) {
            return Err(RestError::Damaged);
        }
        let mut words = Words(words);
        let rest = words.rest().filter(|_| words.0.next().is_none());
        rest.ok_or(RestError::Damaged)
    }
}

/// The words of a file that are not read yet.
struct Words<I>(I);

impl<I: Iterator<Item = u64>> Words<I> {
    fn array<const N: usize>(&mut self) -> Option<[u64; N]> {
        let mut array = [0; N];
        for word in &mut array {
            *word = self.0.next()?;
        }
        Some(array)
    }

    fn places<const N: usize>(&mut self) -> Option<[f64; N]> {
        let places = self.array()?.map(f64::from_bits);
        places.iter().all(|x| x.is_finite()).then_some(places)
    }

    /// The rest, if the words stand for one: no place is beyond the vertices, and each open edge has met what it must.
    fn rest(&mut self) -> Option<Rest<f64>> {
        let [vertices, start, end] = self.array()?;
        let between = self.places()?;
        let ends = [self.places()?, self.places()?];
        let [points, sides, edges] = self.array()?;
        let mut window = Window::default();
        for _ in 0..points {
            let [number] = self.array()?;
            window.push(number, self.places()?);
        }
        let count = window.points.len();
        let known = |v: u64| usize::try_from(v).ok().filter(|&v| v < count);
        for _ in 0..sides {
            let [u, v, edge, kind] = self.array()?;
            window.edges.push([known(u)?, known(v)?]);
            window.origins.push(Origin {
                edge: (kind & 2 != 0).then_some(edge),
                is_border: kind & 1 != 0,
            });
        }
        let mut rest = Rest {
            cut: Cut { vertices, between },
            covered: start..end,
            ends,
            window: window.whole(),
            open: Default::default(),
        };
        for _ in 0..edges {
            let [edge] = self.array()?;
            let ends = [self.places()?, self.places()?];
            let met = self.array()?.map(|v: u64| (v != NONE).then_some(v));
            let [goes_down, goes_up] = rest.beyond(&ends);
            let has_met = met.map(|v| v.is_some());
            // What passes may have met no vertex.
            let passes = goes_down && goes_up && has_met == [false; 2];
            if !(passes || has_met == [goes_down, goes_up]) {
                return None;
            }
            let [low, high] = met.map(|v| v.map(known));
            let met = [low, high].map(Option::flatten);
            (met.map(|v| v.is_some()) == has_met).then_some(())?;
            rest.open.insert(edge, Open { ends, met });
        }
        let is_range = start < end && end <= vertices;
        is_range.then_some(rest)
    }
}
