//! Contour lines and a grid of heights, made of the triangles of a stream as they pass.

use std::cell::RefCell;
use std::fs::File;
use std::io::{self, Write};
use std::mem;
use std::path::{Path, PathBuf};

use num_rational::BigRational;
use sweep_cdt_engine::Remark;
use sweep_cdt_formats::{Column, Coordinate, CoordinateSystem, LineWriter, Voids};
use sweep_cdt_stream::external::{Format, Vertex};
use sweep_cdt_stream::{Carried, Final};
use sweep_cdt_terrain::{Contour, Corner, LevelsError, PassingContours, Raster, levels};

use super::SortArgs;
use super::order::Sorted;
use crate::contours::number;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, by_extension};
use crate::shared::outputs::{Destination, Out};
use crate::shared::raster::{RasterArgs, RasterFormat, write_raster};

/// Outputs for which the points need heights.
#[derive(clap::Args)]
pub(super) struct TerrainOutputs {
    /// File to write contour lines to, those of `sweep-cdt contours`, each as soon as it is complete: .geojson or .wkt
    #[arg(long, value_name = "FILE", requires = "every")]
    contours: Option<PathBuf>,

    /// How far levels are apart: 50, 0.1 or 1/3
    #[arg(long, value_name = "DISTANCE", value_parser = number, requires = "contours")]
    every: Option<BigRational>,

    /// A height that is a level; the others are whole distances above and below it [default: 0]
    #[arg(long, value_name = "HEIGHT", value_parser = number, requires = "contours", allow_negative_numbers = true)]
    from: Option<BigRational>,

    #[command(flatten)]
    raster: RasterArgs,
}

/// Where contour lines and the grid go.
#[derive(Default)]
pub(super) struct TerrainTargets {
    pub(super) lines: Option<(Destination, Format)>,
    pub(super) raster: Option<(Destination, RasterFormat)>,
}

impl TerrainTargets {
    pub(super) fn all(&self) -> impl Iterator<Item = &Destination> {
        let lines = self.lines.iter().map(|(lines, _)| lines);
        lines.chain(self.raster.iter().map(|(raster, _)| raster))
    }
}

impl TerrainOutputs {
    pub(super) fn is_asked(&self) -> bool {
        self.contours.is_some() || self.raster.path().is_some()
    }

    /// Where they go; names that tell no format are refused.
    pub(super) fn targets(&self) -> Result<TerrainTargets, Failure> {
        let mut targets = TerrainTargets::default();
        if let Some(path) = &self.contours {
            let file = FileArgument::File(path.clone());
            let format = by_extension(&file, Format::LINES).ok_or_else(|| {
                let name = path.display();
                let message =
                    format!("{name} is no name for contour lines: let it end in .geojson or .wkt");
                Failure::Usage(message)
            })?;
            targets.lines = Some((Destination::of(&file)?, format));
        }
        targets.raster = self.raster.target()?;
        if self
            .every
            .as_ref()
            .is_some_and(|every| *every <= BigRational::default())
        {
            let error = LevelsError::NotPositive;
            return Err(Failure::Usage(format!("--every: {error}")));
        }
        Ok(targets)
    }

    /// The terrain of sorted points, if it is asked for, without a triangle yet.
    pub(super) fn begin(
        &self,
        name: &str,
        sorted: &Sorted,
        sort: &SortArgs,
    ) -> Result<Option<Terrain>, Failure> {
        if !self.is_asked() {
            return Ok(None);
        }
        let summary = sorted.order.summary();
        let failure =
            |error: &dyn ToString| Failure::Error(format!("{name}: {}", error.to_string()));
        // A sixteenth of the memory each.
        let share = usize::try_from(sort.memory() / 16).unwrap_or(usize::MAX);
        let [low, high] = summary.height;
        let mut contours = None;
        let mut words = "no heights".to_owned();
        if let Some(every) = &self.every {
            let from = self.from.clone().unwrap_or_default();
            let levels = match low <= high {
                true => levels(&from, every, [low, high]).map_err(|error| failure(&error))?,
                false => Vec::new(),
            };
            if low <= high {
                words = format!(
                    "heights {} to {}, levels {}",
                    low.text(),
                    high.text(),
                    levels.len()
                );
            }
            contours = Some(PassingContours::new(levels, share / size_of::<[f64; 2]>()));
        }
        let intervals = [summary.x, summary.y];
        let raster = self.raster.begin(name, intervals, &sort.folder(), share)?;
        Ok(Some(Terrain {
            vertices: Carried::default(),
            contours,
            raster,
            words,
            lowest: low,
            system: sorted.system.clone(),
            lines: [0; 2],
            missing: 0,
            conflict: None,
            conflict_at: None,
            voids: Voids::default(),
        }))
    }

    /// The name of what could not be written, lines or the grid.
    pub(super) fn name(&self) -> &Path {
        let names = [self.contours.as_ref(), self.raster.path()];
        names
            .into_iter()
            .flatten()
            .next()
            .map_or(Path::new(""), |path| path)
    }
}

/// The terrain of a stream.
pub(super) struct Terrain {
    vertices: Carried<Corner>,
    contours: Option<PassingContours>,
    raster: Option<Raster<File>>,
    /// Heights and levels in words.
    words: String,
    lowest: f64,
    system: Option<CoordinateSystem>,
    /// How many lines have been written, and how many of them are closed.
    lines: [u64; 2],
    /// How many triangles have a corner without a height.
    missing: u64,
    /// A point with two heights, and the last one that was found.
    conflict: Option<(u64, [f64; 2], usize)>,
    conflict_at: Option<u64>,
    /// Heights that often mean that there is none.
    voids: Voids,
}

/// Triangles that pass, and where their lines go.
pub(super) struct Passing<'a> {
    terrain: RefCell<&'a mut Terrain>,
    lines: RefCell<Option<LineWriter<&'a mut dyn Write>>>,
}

impl Terrain {
    /// The bytes that a vertex takes here, alive or not.
    pub(super) const BYTES: u64 = 2 * size_of::<(u64, Corner)>() as u64;

    /// The terrain while triangles pass; `lines` is where contour lines go.
    pub(super) fn passing<'a>(
        &'a mut self,
        lines: Option<(&'a mut dyn Write, Format)>,
    ) -> io::Result<Passing<'a>> {
        let system = self.system.as_ref();
        let begin = |(out, format)| LineWriter::begin(format, system, out);
        Ok(Passing {
            lines: RefCell::new(lines.map(begin).transpose()?),
            terrain: RefCell::new(self),
        })
    }

    /// Writes the grid.
    pub(super) fn write_raster(
        &mut self,
        format: RasterFormat,
        folder: &Path,
        out: &mut Out<'_>,
    ) -> io::Result<()> {
        let head = (self.lowest, self.system.clone());
        let raster = self.raster.take();
        raster.map_or(Ok(()), |raster| {
            write_raster(raster, format, head, folder, out)
        })
    }

    /// The remarks on the heights; the first point has this number.
    pub(super) fn remarks(&self, first: u64, triangles: u64) -> Vec<Remark> {
        let count = |number| usize::try_from(number).unwrap_or(usize::MAX);
        let conflict = self
            .conflict
            .map(|(vertex, values, places)| Remark::Conflict {
                column: Column::HEIGHT.to_owned(),
                vertex: count(vertex + first),
                values,
                count: places,
            });
        let open = (self.missing > 0).then(|| Remark::OpenTriangles {
            missing: count(self.missing),
            triangles: count(triangles),
        });
        let all = conflict.into_iter().chain(open);
        all.chain(self.voids.remarks()).collect()
    }

    /// The counts of contour lines in words, if there are to be any.
    pub(super) fn summary(&self) -> Option<String> {
        let contours = self.contours.as_ref()?;
        let ([lines, closed], words) = (self.lines, &self.words);
        let parts = match contours.parts() {
            0 => String::new(),
            parts => {
                format!(", {parts} of them parts of longer ones (more --memory holds longer lines)")
            }
        };
        Some(format!("{words}, lines {lines}, closed {closed}{parts}"))
    }
}

impl Passing<'_> {
    /// Takes a vertex, and returns the number that the stream gets with it; `before` is the one of the last vertex, if that
    /// is at the same place.
    pub(super) fn vertex(&self, vertex: &Vertex<'_>, before: Option<u64>) -> u64 {
        let mut terrain = self.terrain.borrow_mut();
        let height = vertex.height.unwrap_or(f64::NAN);
        terrain.voids.add(height);
        let Some(before) = before else {
            return terrain.vertices.push(Corner {
                number: vertex.number,
                point: vertex.point,
                height,
            });
        };
        // Of equal points the first height counts.
        let corner = terrain.vertices.get_mut(before);
        let kept = *corner;
        if kept.height.is_nan() {
            corner.height = height;
        } else if (kept.height - height).abs() > 0.0 {
            let is_known = terrain.conflict_at.replace(kept.number) == Some(kept.number);
            let first = (kept.number, [kept.height, height], 0);
            terrain.conflict.get_or_insert(first).2 += usize::from(!is_known);
        }
        before
    }

    /// Forgets what the stream can name no more.
    pub(super) fn forget<O: FnMut(Final)>(&self, stream: &sweep_cdt_stream::Stream<'_, f64, O>) {
        self.terrain.borrow_mut().vertices.forget(stream);
    }

    /// The number of a vertex in the input.
    pub(super) fn number(&self, vertex: u64) -> u64 {
        self.terrain.borrow().vertices.get(vertex).number
    }

    /// Takes what is final.
    pub(super) fn found(&self, found: &Final) -> io::Result<()> {
        let terrain = &mut **self.terrain.borrow_mut();
        let corner = |&number: &u64| *terrain.vertices.get(number);
        let mut written = Ok(());
        let mut lines = self.lines.borrow_mut();
        let counts = &mut terrain.lines;
        let mut out = |line: Contour| {
            counts[0] += 1;
            counts[1] += u64::from(line.is_closed());
            if let (Some(lines), Ok(())) = (lines.as_mut(), &written) {
                written = lines.line(line.level, &line.points);
            }
        };
        match found {
            Final::Triangle { corners, .. } => {
                let corners = corners.each_ref().map(corner);
                let is_open = corners.iter().any(|corner| corner.height.is_nan());
                terrain.missing += u64::from(is_open);
                if let Some(contours) = &mut terrain.contours {
                    contours.triangle(corners, &mut out);
                }
                if let Some(raster) = &mut terrain.raster {
                    raster.add(corners)?;
                }
            }
            Final::HullSide { ends } => {
                if let Some(contours) = &mut terrain.contours {
                    contours.border(ends.each_ref().map(corner), &mut out);
                }
            }
            _ => {}
        }
        written
    }

    /// Ends the lines.
    pub(super) fn finish(self) -> io::Result<()> {
        let lines = mem::take(&mut *self.lines.borrow_mut());
        lines.map_or(Ok(()), LineWriter::finish)
    }
}
