//! The picture of Voronoi cells: the ridges between cells grey, the border of all cells orange, the points as dots.

use std::io::{self, Write};

use super::layout::Layout;
use super::pixels;
use super::result::write_layout;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_formats::{Cell, Numbering};

/// A picture of Voronoi cells, as SVG or PNG.
///
/// ```
/// use sweep_cdt_draw::CellsPicture;
/// use sweep_cdt_formats::Cell;
///
/// let square = |left: f64| vec![vec![vec![[left, 0.0], [left + 1.0, 0.0], [left + 1.0, 1.0], [left, 1.0]]]];
/// let cells = [0.0, 1.0].map(|left| Cell { point: left as usize, polygons: square(left) });
/// let mut picture = Vec::new();
/// CellsPicture::new(&[[0.5, 0.5], [1.5, 0.5]], &cells).write(&mut picture)?;
/// assert!(String::from_utf8(picture).expect("text").contains("cells: 2"));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct CellsPicture<'a, S> {
    points: &'a [[S; 2]],
    cells: &'a [Cell<S>],
    numbering: Numbering,
}

impl<'a, S: Scalar> CellsPicture<'a, S> {
    /// A picture of the cells of these points.
    #[must_use]
    pub fn new(points: &'a [[S; 2]], cells: &'a [Cell<S>]) -> CellsPicture<'a, S> {
        CellsPicture {
            points,
            cells,
            numbering: Numbering::default(),
        }
    }

    /// How the file of the points counts them. By default from 0.
    #[must_use]
    pub fn numbering(self, numbering: Numbering) -> Self {
        CellsPicture { numbering, ..self }
    }

    /// Writes the picture as SVG.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        write_layout(
            &Layout::of_cells(self.points, self.cells),
            self.numbering,
            out,
        )
    }

    /// Writes the picture as PNG.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_png(&self, out: &mut impl Write) -> io::Result<()> {
        pixels::write(
            &Layout::of_cells(self.points, self.cells),
            self.numbering,
            out,
        )
    }
}
