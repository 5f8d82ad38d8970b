//! Grids of heights: `.asc`, the text of ESRI.
//!
//! ```text
//! ncols 3
//! nrows 2
//! xllcorner 0            the lower left corner of the grid
//! yllcorner 0
//! cellsize 1
//! NODATA_value -9999     a number that no height is
//! 0.5 1.5 -9999          rows from above, columns from the left
//! ...
//! ```

use std::io::{self, Write};

use crate::Coordinate;

/// What a grid is, beside its heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RasterHead {
    /// How many columns and rows it has.
    pub size: [usize; 2],
    /// Its lower left corner.
    pub corner: [f64; 2],
    /// The size of a cell.
    pub cell: f64,
    /// A height that is no higher than any other.
    pub lowest: f64,
}

/// Writes a grid as `.asc`. `rows` passes on each row from above, NaN where there is no height.
///
/// ```
/// use sweep_cdt_formats::{RasterHead, write_asc};
///
/// let head = RasterHead { size: [2, 1], corner: [4.0, -0.5], cell: 0.5, lowest: -9999.0 };
/// let mut text = Vec::new();
/// write_asc(&head, |row| row(&[f64::NAN, 1.25]), &mut text)?;
/// let begin = "ncols 2\nnrows 1\nxllcorner 4\nyllcorner -0.5\ncellsize 0.5\n";
/// assert_eq!(text, [begin, "NODATA_value -99999\n-99999 1.25\n"].concat().as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out` and of `rows`.
pub fn write_asc(
    head: &RasterHead,
    rows: impl FnOnce(&mut dyn FnMut(&[f64]) -> io::Result<()>) -> io::Result<()>,
    out: &mut impl Write,
) -> io::Result<()> {
    let RasterHead {
        size: [columns, height],
        corner: [x, y],
        cell,
        lowest,
    } = head;
    let mut none = -9999.0;
    while none >= *lowest {
        none = 10.0 * none - 9.0;
    }
    let [x, y, cell, none] = [*x, *y, *cell, none].map(|number| number.text());
    writeln!(
        out,
        "ncols {columns}\nnrows {height}\nxllcorner {x}\nyllcorner {y}"
    )?;
    writeln!(out, "cellsize {cell}\nNODATA_value {none}")?;
    let mut text = Vec::new();
    rows(&mut |row| {
        text.clear();
        for height in row {
            match height.is_nan() {
                true => text.extend_from_slice(none.as_bytes()),
                false => height.write_text(&mut text),
            }
            text.push(b' ');
        }
        text.pop();
        text.push(b'\n');
        out.write_all(&text)
    })
}
