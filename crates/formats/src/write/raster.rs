//! Grids of heights: `.asc`, the text of ESRI, and `GeoTIFF`, with the crate `tiff`.
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
//!
//! A `GeoTIFF` has doubles, NaN where there is no height, and tags that say where the grid lies. Its keys say that a number
//! is that of an area, not of a point, and name the coordinate system, if that has a number of the EPSG and is known to be
//! of longitudes and latitudes or of a plane.

#[cfg(feature = "geotiff")]
use std::io::Seek;
use std::io::{self, Write};

#[cfg(feature = "geotiff")]
use tiff::{
    TiffError,
    encoder::{TiffEncoder, TiffKind, colortype::Gray64Float},
    tags::Tag,
};

use crate::{Coordinate, CoordinateSystem};

/// What a grid is, beside its heights.
#[derive(Clone, Debug, PartialEq)]
pub struct RasterHead {
    /// How many columns and rows it has.
    pub size: [usize; 2],
    /// The lower left corner of the grid, and the upper right one.
    pub corners: [[f64; 2]; 2],
    /// The size of a cell.
    pub cell: f64,
    /// A height that is no higher than any other.
    pub lowest: f64,
    /// The coordinate system, if it is known: an `.asc` has no room for it.
    pub system: Option<CoordinateSystem>,
}

/// Writes a grid as `.asc`. `rows` passes on each row from above, NaN where there is no height.
///
/// ```
/// use sweep_cdt_formats::{RasterHead, write_asc};
///
/// let corners = [[4.0, -0.5], [5.0, 0.0]];
/// let head = RasterHead { size: [2, 1], corners, cell: 0.5, lowest: -9999.0, system: None };
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
        corners: [[x, y], _],
        cell,
        lowest,
        ..
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

/// Writes a grid as `GeoTIFF`, with rows as [`write_asc`] gets them; as a `BigTIFF` if 32 bits do not count its bytes.
///
/// # Errors
/// Errors of `out` and of `rows`.
#[cfg(feature = "geotiff")]
pub fn write_geotiff(
    head: &RasterHead,
    rows: impl FnOnce(&mut dyn FnMut(&[f64]) -> io::Result<()>) -> io::Result<()>,
    out: impl Write + Seek,
) -> io::Result<()> {
    // Beside the heights there are a place and a length for each row, and the tags.
    let [columns, height] = head.size.map(|size| size as u64);
    let bytes = columns * height * 8 + height * 8 + 1024;
    match u32::try_from(bytes) {
        Ok(_) => write_strips(head, rows, TiffEncoder::new(out).map_err(of_tiff)?),
        Err(_) => write_strips(head, rows, TiffEncoder::new_big(out).map_err(of_tiff)?),
    }
}

#[cfg(feature = "geotiff")]
fn write_strips<W: Write + Seek, K: TiffKind>(
    head: &RasterHead,
    rows: impl FnOnce(&mut dyn FnMut(&[f64]) -> io::Result<()>) -> io::Result<()>,
    mut tiff: TiffEncoder<W, K>,
) -> io::Result<()> {
    let size = head
        .size
        .map(|size| u32::try_from(size).map_err(io::Error::other));
    let [columns, height] = size;
    let image = tiff.new_image::<Gray64Float>(columns?, height?);
    let mut image = image.map_err(of_tiff)?;
    image.rows_per_strip(1).map_err(of_tiff)?;
    // The upper left corner of the first cell lies at the left and at the top.
    let [[left, _], [_, top]] = head.corners;
    let tags = image.encoder();
    let scale = [head.cell, head.cell, 0.0];
    let tie = [0.0, 0.0, 0.0, left, top, 0.0];
    tags.write_tag(Tag::ModelPixelScaleTag, &scale[..])
        .map_err(of_tiff)?;
    tags.write_tag(Tag::ModelTiepointTag, &tie[..])
        .map_err(of_tiff)?;
    tags.write_tag(Tag::GeoKeyDirectoryTag, &keys(head.system.as_ref())[..])
        .map_err(of_tiff)?;
    tags.write_tag(Tag::GdalNodata, "nan").map_err(of_tiff)?;
    rows(&mut |row| image.write_strip(row).map_err(of_tiff))?;
    image.finish().map_err(of_tiff)
}

/// The keys of a `GeoTIFF`: a head, and four numbers for each.
#[cfg(feature = "geotiff")]
fn keys(system: Option<&CoordinateSystem>) -> Vec<u16> {
    const MODEL: u16 = 1024;
    const RASTER: u16 = 1025;
    const GEODETIC: u16 = 2048;
    const PROJECTED: u16 = 3072;
    let is_area = (RASTER, 1);
    let named = system.and_then(|system| {
        let number = u16::try_from(system.srid()?).ok()?;
        let number = (1024..32767).contains(&number).then_some(number)?;
        Some(match system.is_geographic()? {
            false => [(MODEL, 1), is_area, (PROJECTED, number)],
            true => [(MODEL, 2), is_area, (GEODETIC, number)],
        })
    });
    let keys = named.map_or_else(|| vec![is_area], |keys| keys.to_vec());
    let mut numbers = vec![1, 1, 0, if named.is_some() { 3 } else { 1 }];
    numbers.extend(keys.into_iter().flat_map(|(key, value)| [key, 0, 1, value]));
    numbers
}

#[cfg(feature = "geotiff")]
fn of_tiff(error: TiffError) -> io::Error {
    match error {
        TiffError::IoError(error) => error,
        error => io::Error::other(error),
    }
}

#[cfg(all(test, feature = "geotiff"))]
mod tests {
    use std::io::Cursor;

    use tiff::decoder::{Decoder, DecodingResult};

    use super::*;

    #[test]
    fn a_geotiff_has_its_heights_and_its_place() {
        let head = RasterHead {
            size: [3, 2],
            corners: [[4.0, -0.5], [5.5, 0.5]],
            cell: 0.5,
            lowest: 1.0,
            system: Some(CoordinateSystem::of_epsg(4326, true)),
        };
        let rows = [[1.0, f64::NAN, 0.1], [2.0, 1e300, -0.0]];
        let mut file = Cursor::new(Vec::new());
        let written = write_geotiff(
            &head,
            |put| rows.iter().try_for_each(|row| put(row)),
            &mut file,
        );
        written.expect("memory takes all");
        file.set_position(0);
        let mut tiff = Decoder::new(file).expect("a TIFF");
        assert_eq!(tiff.dimensions().expect("a size"), (3, 2));
        let scale = tiff.get_tag_f64_vec(Tag::ModelPixelScaleTag);
        assert_eq!(scale.expect("a tag"), [0.5, 0.5, 0.0]);
        let tie = tiff.get_tag_f64_vec(Tag::ModelTiepointTag);
        assert_eq!(tie.expect("a tag"), [0.0, 0.0, 0.0, 4.0, 0.5, 0.0]);
        let keys = tiff.get_tag_u16_vec(Tag::GeoKeyDirectoryTag);
        let expected = [1, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326];
        assert_eq!(keys.expect("a tag"), expected);
        let none = tiff.get_tag_ascii_string(Tag::GdalNodata);
        assert_eq!(none.expect("a tag"), "nan");
        let DecodingResult::F64(heights) = tiff.read_image().expect("an image") else {
            panic!("no doubles");
        };
        let bits = |height: &f64| height.to_bits();
        let expected: Vec<u64> = rows.as_flattened().iter().map(bits).collect();
        assert_eq!(heights.iter().map(bits).collect::<Vec<_>>(), expected);
    }
}
