//! The heights of a grid, filled by triangles that pass, in a bounded memory and a file.
//!
//! Triangles that pass in the order of a sweep fill the rows from below, most of them in the rows just below the sweep line.
//! So the uppermost rows that have begun are in memory, as many as it holds, and all below are in the file, where a
//! triangle that still meets them changes them in place.

use std::collections::VecDeque;
use std::io::{self, Read, Seek, SeekFrom, Write};

use crate::grid::Grid;
use crate::passing::Corner;

/// A grid that is filled.
#[derive(Debug)]
pub struct Raster<F> {
    grid: Grid,
    /// The rows before `first`, with doubles as little-endian bytes.
    file: F,
    first: usize,
    /// The rows from there on, and how many of them are in memory at most.
    rows: VecDeque<Vec<f64>>,
    most: usize,
    bytes: Vec<u8>,
}

/// The bytes of a height.
const EACH: usize = size_of::<f64>();

impl<F: Read + Write + Seek> Raster<F> {
    /// A grid without heights. At most so many bytes of it are in memory, but at least a row; the others are in a file, which
    /// is empty.
    ///
    /// ```
    /// use std::io::Cursor;
    /// use sweep_cdt_terrain::{Corner, Grid, Raster};
    ///
    /// let corner = |point: [f64; 2]| Corner { number: 0, point, height: point[0] };
    /// let grid = Grid::covering(1.0, [[0.0, 2.0], [0.0, 2.0]]).unwrap();
    /// let mut raster = Raster::new(grid, Cursor::new(Vec::new()), 0);
    /// raster.add([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]].map(corner))?;
    /// let mut rows = Vec::new();
    /// raster.each_row(|row| Ok(rows.push(row.to_vec())))?;
    /// assert!(rows[0][0] == 0.5 && rows[0][1].is_nan() && rows[1] == [0.5, 1.5]);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn new(grid: Grid, file: F, bytes: usize) -> Raster<F> {
        let most = (bytes / EACH / grid.columns()).max(1);
        Raster {
            grid,
            file,
            first: 0,
            rows: VecDeque::new(),
            most,
            bytes: Vec::new(),
        }
    }

    /// The grid.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The next triangle, counter-clockwise.
    ///
    /// # Errors
    /// Errors of the file.
    pub fn add(&mut self, corners: [Corner; 3]) -> io::Result<()> {
        let grid = self.grid.clone();
        grid.heights(corners, |row, column, heights| {
            while self.first + self.rows.len() <= row {
                self.begin_row()?;
            }
            match row.checked_sub(self.first) {
                Some(at) => {
                    self.rows[at][column..column + heights.len()].copy_from_slice(heights);
                    Ok(())
                }
                None => self.write(row, column, heights),
            }
        })
    }

    /// Makes room for the next row, in which no height is known.
    fn begin_row(&mut self) -> io::Result<()> {
        let mut row = Vec::new();
        if self.rows.len() == self.most {
            row = self.rows.pop_front().unwrap_or_default();
            self.write(self.first, 0, &row)?;
            self.first += 1;
        }
        row.clear();
        row.resize(self.grid.columns(), f64::NAN);
        self.rows.push_back(row);
        Ok(())
    }

    /// Writes heights to the file.
    fn write(&mut self, row: usize, column: usize, heights: &[f64]) -> io::Result<()> {
        self.bytes.clear();
        let bytes = heights.iter().flat_map(|height| height.to_le_bytes());
        self.bytes.extend(bytes);
        self.go_to(row, column)?;
        self.file.write_all(&self.bytes)
    }

    fn go_to(&mut self, row: usize, column: usize) -> io::Result<()> {
        let place = (row * self.grid.columns() + column) * EACH;
        self.file.seek(SeekFrom::Start(place as u64)).map(|_| ())
    }

    /// Passes on all rows from above, as images have them, NaN where there is no height.
    ///
    /// # Errors
    /// Errors of the file, and those of `out`.
    pub fn each_row(mut self, mut out: impl FnMut(&[f64]) -> io::Result<()>) -> io::Result<()> {
        let columns = self.grid.columns();
        let mut row = vec![f64::NAN; columns];
        for _ in self.first + self.rows.len()..self.grid.rows() {
            out(&row)?;
        }
        for row in self.rows.iter().rev() {
            out(row)?;
        }
        let mut bytes = vec![0; columns * EACH];
        for at in (0..self.first).rev() {
            self.go_to(at, 0)?;
            self.file.read_exact(&mut bytes)?;
            for (height, bytes) in row.iter_mut().zip(bytes.as_chunks().0) {
                *height = f64::from_le_bytes(*bytes);
            }
            out(&row)?;
        }
        Ok(())
    }
}
