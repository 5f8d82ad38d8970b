//! An order that is cut into bands.
//!
//! A band gets the edges that begin in it, and those that have begun before and not ended. So the edges that are open at
//! the sweep line are in memory, with the vertices of one band.

use std::iter::repeat_n;
use std::mem;

use crate::external::error::Error;
use crate::external::order::SweepOrder;
use crate::{Cut, Rest};

/// A band as it was cut: edges have not been looked up among its vertices yet.
#[derive(Debug)]
pub struct Band {
    cut: Cut<f64>,
    /// The position of its first vertex.
    first: u64,
    /// The number and the place of each vertex, and how many equal ones there are.
    vertices: Vec<(u64, [f64; 2], usize)>,
    edges: Vec<(u64, [[f64; 2]; 2])>,
}

impl From<Band> for Rest<f64> {
    /// The rest of a band: all of it. Of equal vertices the first one stays.
    fn from(band: Band) -> Rest<f64> {
        let each = |(number, point, count)| repeat_n((number, point), count);
        let vertices = band.vertices.into_iter().flat_map(each);
        let rest = band.cut.band(band.first, vertices, band.edges, |_| ());
        rest.expect("vertices in order, and edges with ends")
    }
}

/// The bands of an order, one after the other, from below.
#[derive(Debug)]
pub struct Bands<'a> {
    order: &'a mut SweepOrder,
    cut: Cut<f64>,
    /// So many vertices a band has, but for those equal to its last one.
    size: u64,
    /// The position of the next vertex, which has been taken already.
    first: u64,
    next: Option<(u64, [f64; 2])>,
    /// The edges that have begun and not ended, with both ends.
    open: Vec<(u64, [[f64; 2]; 2])>,
    /// The edges that begin at the next vertex.
    of_next: Vec<(u64, [[f64; 2]; 2])>,
}

impl<'a> Bands<'a> {
    /// Cuts an order into bands of so many vertices, at least one; equal ones belong to one band.
    ///
    /// # Errors
    /// See [`Error`]: the temporary files cannot be read.
    pub fn new(order: &'a mut SweepOrder, size: u64) -> Result<Self, Error> {
        let summary = order.summary();
        let mut bands = Bands {
            order,
            cut: Cut {
                vertices: summary.points,
                between: summary.x,
            },
            size: size.max(1),
            first: 0,
            next: None,
            open: Vec::new(),
            of_next: Vec::new(),
        };
        bands.take()?;
        Ok(bands)
    }

    /// The bands that follow have so many vertices, at least one.
    pub fn resize(&mut self, size: u64) {
        self.size = size.max(1);
    }

    /// How many bands there are, but for equal vertices.
    #[must_use]
    pub fn most(&self) -> u64 {
        self.cut.vertices.div_ceil(self.size)
    }

    /// Takes the next vertex, and the edges that begin there.
    fn take(&mut self) -> Result<(), Error> {
        let vertex = self.order.next_vertex()?;
        self.next = vertex.map(|vertex| {
            let edges = vertex.upper.iter();
            let edges = edges.map(|&(edge, upper)| (edge, [vertex.point, upper]));
            self.of_next.extend(edges);
            (vertex.number, vertex.point)
        });
        Ok(())
    }

    /// How many vertices the bands have that were cut, equal ones included.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.first
    }

    /// The next band; `None` after the last.
    ///
    /// # Errors
    /// See [`Error`]: the temporary files cannot be read.
    pub fn next_band(&mut self) -> Result<Option<Band>, Error> {
        let mut vertices: Vec<(u64, [f64; 2], usize)> = Vec::new();
        let first = self.first;
        while let Some((number, point)) = self.next {
            // There is but one zero, so the bits of equal points are equal.
            let bits = |point: [f64; 2]| point.map(f64::to_bits);
            let last = vertices.last_mut();
            match last.filter(|(_, last, _)| bits(*last) == bits(point)) {
                Some((.., count)) => *count += 1,
                None if self.first - first >= self.size => break,
                None => vertices.push((number, point, 1)),
            }
            self.first += 1;
            self.open.append(&mut self.of_next);
            self.take()?;
        }
        let Some(&(_, [x, y], _)) = vertices.last() else {
            return Ok(None);
        };
        let goes_on = |(_, [_, upper]): &(u64, [[f64; 2]; 2])| (upper[1], upper[0]) > (y, x);
        let open = self.open.iter().copied().filter(goes_on).collect();
        Ok(Some(Band {
            cut: self.cut.clone(),
            first,
            vertices,
            edges: mem::replace(&mut self.open, open),
        }))
    }
}
