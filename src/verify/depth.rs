//! Depths of faults, which tell rounding from a wrong triangulation.
//! A program that decides by rounded numbers is wrong where the right answer hangs on the last bits, some units of
//! 1e-16 deep. Faults of a wrong algorithm are as deep as they come. A histogram by decades shows that at a glance.
//! Why it is right: the faults are found by exact signs. The scalar computes the sizes exactly and rounds at the end.
//! The decade is that of the double's shortest decimal, so no logarithm rounds it. Turns are measured only if all wrong
//! ones go on by less than a right angle and the boundary is simple, so that what it bounds is covered once.
//! Cost: big integers for each fault, so by default at most [`MEASURED`] in each 16384 triangles, and as many turns.

use alloc::collections::BTreeMap;
use alloc::format;
use core::fmt;
use core::hash::{Hash, Hasher};

/// How many depths are measured at a time, unless all are asked for.
pub(super) const MEASURED: usize = 1000;

/// How deep a fault is, relative to the size of the triangles or edges around it: a positive number.
///
/// For a side that is not Delaunay: the power of the corner that lies deepest in the circle of the other triangle, in
/// units of the squared radius; 1 at the centre. For a concave turn of the boundary: its height over the line between
/// its ends, in units of their distance. For an edge or a side of the boundary with added points beside it: the distance
/// of the farthest one, in units of the edge's or side's length. The size is right to about 1e-15 of itself, or is the smallest double.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Depth(f64);

impl Depth {
    /// The depth of this size, if the size is positive and finite.
    pub(super) fn new(size: f64) -> Option<Depth> {
        (size > 0.0 && size.is_finite()).then_some(Depth(size))
    }

    /// The size.
    pub fn get(self) -> f64 {
        self.0
    }

    /// The exponent of ten in scientific notation: -16 for 1e-16 up to below 1e-15.
    pub fn decade(self) -> i32 {
        let text = format!("{:e}", self.0);
        let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
        exponent.expect("scientific notation has an exponent")
    }
}

/// A depth is never NaN.
impl Eq for Depth {}

impl Hash for Depth {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.to_bits().hash(state);
    }
}

/// Writes two digits: `1.2e-16`.
impl fmt::Display for Depth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.1e}", self.0)
    }
}

/// The depths of violations: how many there are in each decade, and the greatest.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Depths {
    /// The number of depths in each [decade](Depth::decade) that has any.
    pub decades: BTreeMap<i32, usize>,
    /// The greatest depth; `None` if there are none.
    pub greatest: Option<Depth>,
}

impl Depths {
    /// How many depths there are.
    pub fn measured(&self) -> usize {
        self.decades.values().sum()
    }

    pub(super) fn add(&mut self, depth: Depth) {
        *self.decades.entry(depth.decade()).or_default() += 1;
        self.raise(Some(depth));
    }

    pub(super) fn append(&mut self, later: Depths) {
        for (decade, count) in later.decades {
            *self.decades.entry(decade).or_default() += count;
        }
        self.raise(later.greatest);
    }

    fn raise(&mut self, depth: Option<Depth>) {
        if depth > self.greatest {
            self.greatest = depth;
        }
    }
}
