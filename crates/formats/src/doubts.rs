//! Numbers of vertices that one may doubt, counted as they are read: two numbers for one vertex, and numbers that often mean
//! that there is none. Each becomes a remark. Cost: constant time for each number.

use crate::Remark;

/// The vertices that have two numbers in a column, as they are found.
pub(crate) struct Conflicts {
    has_two: Vec<bool>,
    /// The first of them, the number that counts, and the other one.
    first: Option<(usize, [f64; 2])>,
}

impl Conflicts {
    /// None, of so many vertices.
    pub(crate) fn new(vertices: usize) -> Conflicts {
        Conflicts {
            has_two: vec![false; vertices],
            first: None,
        }
    }

    /// Adds a vertex with the number that counts and another one.
    pub(crate) fn add(&mut self, vertex: usize, values: [f64; 2]) {
        self.has_two[vertex] = true;
        self.first.get_or_insert((vertex, values));
    }

    /// The remark on a column of this name.
    pub(crate) fn remark(self, column: &str) -> Option<Remark> {
        let (vertex, values) = self.first?;
        Some(Remark::Conflict {
            column: column.to_owned(),
            vertex,
            values,
            count: self.has_two.into_iter().filter(|&two| two).count(),
        })
    }
}

/// Numbers among heights that programs often write where there is none: -9999 and others that rasters have, and all of 1e20
/// and more, as netCDF and rasters of floats have them. The first four are counted.
///
/// ```
/// use sweep_cdt_formats::{Remark, Voids};
///
/// let mut voids = Voids::default();
/// [12.5, 1e20, -32768.0, 1e20].map(|height| voids.add(height));
/// let said: Vec<String> = voids.remarks().map(|remark| remark.to_string()).collect();
/// assert_eq!(said[0], "2 heights are 1e20, which often means that there is none");
/// assert_eq!(said.len(), 2);
/// ```
#[derive(Debug, Default)]
pub struct Voids(Vec<(f64, usize)>);

impl Voids {
    /// Counts a height, if it is such a number.
    pub fn add(&mut self, height: f64) {
        const USUAL: [f64; 5] = [-9999.0, -99999.0, -999_999.0, -32768.0, -32767.0];
        let is = |value: f64| height.total_cmp(&value).is_eq();
        if height.abs() < 9999.0 || !(height.abs() >= 1e20 || USUAL.into_iter().any(is)) {
            return;
        }
        match self.0.iter().position(|&(value, _)| is(value)) {
            Some(at) => self.0[at].1 += 1,
            None if self.0.len() < 4 => self.0.push((height, 1)),
            None => {}
        }
    }

    /// The remarks on these numbers.
    pub fn remarks(&self) -> impl Iterator<Item = Remark> {
        let voids = self.0.iter();
        voids.map(|&(value, count)| Remark::Void { value, count })
    }
}
