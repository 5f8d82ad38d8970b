//! An order that is cut into bands.
//!
//! A band gets the edges that begin in it, and those that have begun before and not ended. So the edges that are open at
//! the sweep line are in memory, with the vertices of one band.

use std::iter::repeat_n;

use crate::external::error::Error;
use crate::external::order::SweepOrder;
use crate::{Cut, Rest};

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

    /// The next band, from which nothing is final yet; `None` after the last. Of equal vertices the first one stays.
    ///
    /// # Errors
    /// See [`Error`]: the temporary files cannot be read.
    ///
    /// # Panics
    /// Never: an order is sorted, and its edges end at vertices.
    pub fn next_band(&mut self) -> Result<Option<Rest<f64>>, Error> {
        // The number and the place of each vertex, and how many equal ones there are.
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
        let each = |(number, point, count)| repeat_n((number, point), count);
        let vertices = vertices.into_iter().flat_map(each);
        let edges = self.open.iter().copied();
        let band = self.cut.band(first, vertices, edges, |_| ());
        let band = band.expect("vertices in order, and edges with ends");
        self.open
            .retain(|(_, [_, upper])| (upper[1], upper[0]) > (y, x));
        Ok(Some(band))
    }
}
