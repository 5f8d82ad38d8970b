//! A grid of heights as an output: where it goes, which cells it has, and how it is written.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use sweep_cdt_engine::Remark;
use sweep_cdt_formats::{CoordinateSystem, RasterHead, write_asc};
use sweep_cdt_terrain::{Grid, Raster};

use super::failure::Failure;
use super::files::FilesRead;
use super::outputs::{Destination, Out};

/// Arguments that ask for a grid.
#[derive(clap::Args)]
pub(crate) struct RasterArgs {
    /// File to write a grid of heights to, those at the centres of its cells: .asc, or .tif in a build with the feature
    /// `geotiff`
    #[arg(long, value_name = "FILE", requires = "cell")]
    raster: Option<PathBuf>,

    /// The size of a cell; cells lie at whole multiples of it
    #[arg(long, value_name = "SIZE", value_parser = cell, requires = "raster")]
    cell: Option<f64>,
}

/// Reads the size of a cell.
fn cell(text: &str) -> Result<f64, String> {
    let size = text.parse().ok();
    let size = size.filter(|size: &f64| size.is_normal() && *size > 0.0);
    size.ok_or_else(|| "not a number greater than 0".to_owned())
}

/// The cells that a grid may have: on disk they take 8 bytes each.
const CELLS: u128 = 10_000_000_000;

/// How a grid is written.
#[derive(Clone, Copy)]
pub(crate) enum RasterFormat {
    Asc,
    #[cfg(feature = "geotiff")]
    Tif,
}

/// The extensions of grids.
const RASTERS: &[(&str, RasterFormat)] = &[
    (".asc", RasterFormat::Asc),
    #[cfg(feature = "geotiff")]
    (".tif", RasterFormat::Tif),
];

impl RasterArgs {
    /// The file, if a grid is asked for.
    pub(crate) fn path(&self) -> Option<&PathBuf> {
        self.raster.as_ref()
    }

    /// Where the grid goes, if it is asked for; a name that tells no format is refused.
    pub(crate) fn target(&self) -> Result<Option<(Destination, RasterFormat)>, Failure> {
        let Some(path) = &self.raster else {
            return Ok(None);
        };
        let name = path.display().to_string();
        let Some((_, format)) = RASTERS.iter().find(|(end, _)| name.ends_with(end)) else {
            let tiff = match RASTERS.len() {
                1 => {
                    ", or in .tif with a build that has the feature `geotiff` (`cargo install --path crates/cli \
                     --features geotiff`)"
                }
                _ => " or .tif",
            };
            let message =
                format!("{name} is no name for a grid of heights: let it end in .asc{tiff}");
            return Err(Failure::Usage(message));
        };
        Ok(Some((Destination::of_path(path.clone())?, *format)))
    }

    /// A grid without heights over the points of an input of this name, whose x and y lie in intervals, if it is asked for.
    /// So many bytes of it are in memory, and the rest in a file in a folder.
    pub(crate) fn begin(
        &self,
        name: &str,
        intervals: [[f64; 2]; 2],
        folder: &Path,
        memory: usize,
    ) -> Result<Option<Raster<File>>, Failure> {
        let Some(cell) = self.cell else {
            return Ok(None);
        };
        // Without points there is one cell.
        let is_empty = intervals.iter().any(|[least, most]| least > most);
        let intervals = if is_empty { [[0.0; 2]; 2] } else { intervals };
        let failure = |why: &str| Failure::Error(format!("{name}: {why}: choose a larger --cell"));
        let grid = Grid::covering(cell, intervals)
            .ok_or_else(|| failure("the cells of the grid are too small"))?;
        let cells = grid.columns() as u128 * grid.rows() as u128;
        if cells > CELLS {
            return Err(failure(&format!(
                "the grid would have {cells} cells, and at most {CELLS} are made"
            )));
        }
        let file = tempfile::tempfile_in(folder);
        let file = file.map_err(|error| Failure::of_file(folder, &error))?;
        Ok(Some(Raster::new(grid, file, memory)))
    }
}

/// Says that a grid has no room for a coordinate system, if it has none.
pub(crate) fn say_lost(
    files: &FilesRead,
    target: Option<&(Destination, RasterFormat)>,
    system: Option<&CoordinateSystem>,
) -> Result<(), Failure> {
    match (system, target) {
        (Some(system), Some((raster, RasterFormat::Asc))) => say_system_lost(files, raster, system),
        _ => Ok(()),
    }
}

/// Says that an output has no room for a coordinate system.
pub(crate) fn say_system_lost(
    files: &FilesRead,
    output: &Destination,
    system: &CoordinateSystem,
) -> Result<(), Failure> {
    let what = vec![format!("the coordinate system {}", system.name())];
    let name = output.name.display().to_string();
    files.say(&name, &[Remark::NotWritten { what }])
}

/// Writes a grid, in which no height is lower than `lowest`. A `GeoTIFF` is made in a folder for temporary files, since its
/// beginning is known last.
#[cfg_attr(not(feature = "geotiff"), expect(unused_variables))]
pub(crate) fn write_raster(
    raster: Raster<File>,
    format: RasterFormat,
    (lowest, system): (f64, Option<CoordinateSystem>),
    folder: &Path,
    out: &mut Out<'_>,
) -> io::Result<()> {
    let grid = raster.grid();
    let head = RasterHead {
        size: [grid.columns(), grid.rows()],
        corners: grid.corners(),
        cell: grid.cell(),
        lowest,
        system,
    };
    match format {
        RasterFormat::Asc => write_asc(&head, |row| raster.each_row(row), out),
        #[cfg(feature = "geotiff")]
        RasterFormat::Tif => {
            let mut file = tempfile::tempfile_in(folder)?;
            let tiff = io::BufWriter::new(&mut file);
            sweep_cdt_formats::write_geotiff(&head, |row| raster.each_row(row), tiff)?;
            io::Seek::rewind(&mut file)?;
            io::copy(&mut file, out).map(|_| ())
        }
    }
}
