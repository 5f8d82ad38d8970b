//! Point clouds of laser scanners, `.las` and `.laz`, with the crate `las`: x, y and z of each point.
//!
//! A file holds whole numbers of 32 bits, and for each axis a scale and an offset. A coordinate is the double that the
//! crate makes of them. The coordinate system stands in a record, as WKT or as keys of `GeoTIFF`.
//!
//! The points of a `.laz` are packed in chunks, which a table lists, and newer ones in layers, whose sizes begin a chunk.
//! The crates allocate what header, table and sizes say, so these are compared with the length of the file before. Chunks
//! are unpacked whole, on all cores. Without threads, and where a chunk would take much memory, points are unpacked one
//! after the other instead. Decoders that panic over damaged bytes are caught.
//!
//! Points with the flag `withheld` count as deleted by the standard, and are left out.

mod lengths;

use std::fmt;
use std::io::{Cursor, Read, Seek};

use las::{PointData, PointDataBuilder, Reader};
use sweep_cdt::Pslg;

use crate::read::source::{ReadError, ReadErrorKind, Source};
use crate::remark::of_classes;
use crate::{Column, CoordinateSystem, GraphFile, Remark};
use lengths::{BYTES, CUT_OFF, Fault, caught, reader};

/// How many points are read at once: a few chunks of a `.laz`, which are unpacked on all cores. They are fewer where they
/// would take more than [`BYTES`].
const POINTS: u64 = 1 << 18;

/// A point cloud, `.las` or `.laz`, that is read from front to back, some points at a time.
///
/// ```no_run
/// use std::fs::File;
/// use std::io::BufReader;
/// use sweep_cdt_formats::Cloud;
///
/// let file = File::open("tile.laz")?;
/// let length = file.metadata()?.len();
/// let mut cloud = Cloud::open("tile.laz", BufReader::new(file), length, &[2])?;
/// let (mut places, mut ground) = (Vec::new(), 0);
/// while cloud.next_points(&mut places)? > 0 {
///     ground += places.drain(..).count();
/// }
/// println!("{ground} points of the ground");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Cloud {
    /// The name in errors.
    name: String,
    reader: Reader,
    points: PointData,
    /// The classes of the points that come, if they were chosen.
    classes: Vec<u8>,
    /// Whether there need be none of these classes.
    may_lack: bool,
    /// How many points were read of each class, and how many that are withheld.
    counts: [usize; 256],
    withheld: usize,
    length: u64,
    /// Where the points begin, as the header says.
    points_begin: u64,
    read: u64,
    count: u64,
}

impl fmt::Debug for Cloud {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Cloud");
        shown.field("read", &self.read).field("count", &self.count);
        shown.finish_non_exhaustive()
    }
}

impl Cloud {
    /// Begins to read a file of this name and so many bytes. Points of these classes alone come; those of all, if there are
    /// none. Points that are withheld never come.
    ///
    /// # Errors
    /// The beginning is that of no cloud, or promises more than the file has room for.
    pub fn open(
        name: impl Into<String>,
        read: impl Read + Seek + Send + Sync + 'static,
        length: u64,
        classes: &[u8],
    ) -> Result<Cloud, ReadError> {
        let name = name.into();
        let opened = caught(|| reader(read, length));
        let (reader, points_begin) = opened.map_err(|Fault(why)| ReadError::of_file(&name, why))?;
        let header = reader.header();
        let (points, count) = (
            PointDataBuilder::new().for_header(header).build(),
            header.number_of_points(),
        );
        Ok(Cloud {
            name,
            reader,
            points,
            classes: classes.to_vec(),
            may_lack: false,
            counts: [0; 256],
            withheld: 0,
            length,
            points_begin,
            read: 0,
            count,
        })
    }

    /// A file without any point of a chosen class is no error, and has none: one of several.
    #[must_use]
    pub fn that_may_lack_them(mut self) -> Cloud {
        self.may_lack = true;
        self
    }

    /// Appends x, y and z of the next points, and returns how many these are. If there are none, no more will come.
    ///
    /// # Errors
    /// The file ends, or is damaged: the message says after which point. No more can be read then. Or no point of the file
    /// is of a chosen class: the message says of which they are.
    pub fn next_points(&mut self, places: &mut Vec<[f64; 3]>) -> Result<usize, ReadError> {
        let before = places.len();
        // Of some points none may be of a chosen class.
        while places.len() == before && self.read < self.count {
            self.read_some(places)?;
        }
        let come = places.len() - before;
        let is_chosen = self.count > 0 && !self.classes.is_empty();
        if come == 0 && is_chosen && self.kept() == 0 && !self.may_lack {
            return Err(ReadError::of_file(&self.name, self.none_is_chosen()));
        }
        Ok(come)
    }

    /// How many points have come, if classes were chosen.
    fn kept(&self) -> usize {
        let classes = self.counts().into_iter();
        let chosen = classes.filter(|(class, _)| self.classes.contains(class));
        chosen.map(|(_, count)| count).sum()
    }

    /// The classes of the points that were read, and how many each has.
    fn counts(&self) -> Vec<(u8, usize)> {
        let counts = (0..=u8::MAX).zip(self.counts);
        counts.filter(|&(_, count)| count > 0).collect()
    }

    /// The message that no point is of a chosen class.
    fn none_is_chosen(&self) -> String {
        let chosen: Vec<String> = self.classes.iter().map(u8::to_string).collect();
        let withheld = (self.withheld > 0).then(|| format!("{} withheld", self.withheld));
        let others = [Some(of_classes(&self.counts())), withheld].into_iter();
        let others: Vec<String> = others.flatten().filter(|what| !what.is_empty()).collect();
        let (chosen, others) = (chosen.join(" or "), others.join(", "));
        format!("no point is of class {chosen}: {others}")
    }

    /// Appends those of the next points that were chosen.
    fn read_some(&mut self, places: &mut Vec<[f64; 3]>) -> Result<(), ReadError> {
        let each = self.reader.header().point_format().len();
        let most = POINTS.min(BYTES / u64::from(each.max(1)));
        let most = most.min(self.count - self.read);
        let Cloud { reader, points, .. } = self;
        let read = caught(|| Ok(reader.fill_points(most, points)?));
        let fault = |why: &str| {
            let (read, count) = (self.read, self.count);
            ReadError::of_file(&self.name, format!("after point {read} of {count}: {why}"))
        };
        match read {
            Ok(read) if read == most => {}
            Ok(_) => return Err(fault(CUT_OFF)),
            Err(Fault(why)) => return Err(fault(&why)),
        }
        self.read += most;
        let points = &self.points;
        // The flags of the first formats stand above the class.
        let withheld = match points.format().is_extended {
            true => 1 << 2,
            false => 1 << 7,
        };
        let records = points.raw_bytes().chunks_exact(points.record_len());
        let is_withheld = records.map(|record| record[15] & withheld != 0);
        let axes = points.x().zip(points.y()).zip(points.z());
        let all = axes.zip(points.classification()).zip(is_withheld);
        for ((((x, y), z), class), is_withheld) in all {
            if is_withheld {
                self.withheld += 1;
                continue;
            }
            self.counts[usize::from(class)] += 1;
            if self.classes.is_empty() || self.classes.contains(&class) {
                places.push([x, y, z]);
            }
        }
        Ok(())
    }

    /// How many points are read of how many.
    pub fn progress(&self) -> (u64, u64) {
        (self.read, self.count)
    }

    /// The coordinate system of x and y, if a record names one by a number of the EPSG.
    pub fn system(&self) -> Option<CoordinateSystem> {
        let header = self.reader.header();
        if let Some(text) = header.get_wkt_crs_bytes() {
            return CoordinateSystem::of_wkt(&String::from_utf8_lossy(text));
        }
        let keys = header.get_geotiff_crs().ok()??;
        let projected = keys.get_projected_crs_geo_key_value();
        let is_geographic = match keys.get_gt_model_type_geo_key_value() {
            Some(1) => false,
            Some(2) => true,
            None => projected.is_none(),
            Some(_) => return None,
        };
        let number = match is_geographic {
            true => keys.get_geodetic_crs_geo_key_value(),
            false => projected,
        };
        // Others are none of the EPSG.
        let number = number.filter(|number| (1024..32767).contains(number))?;
        Some(CoordinateSystem::of_epsg(number.into(), is_geographic))
    }

    /// The remarks on the file: what is left out of it, heights or not, and a header that says of no points, or that they
    /// are all in one place: it was never completed. How many points are withheld, and of which classes, is known at the end.
    pub fn remarks(&self, has_heights: bool) -> Vec<Remark> {
        let header = self.reader.header();
        let mut remarks = Vec::new();
        let bytes = self.length.saturating_sub(self.points_begin);
        if self.count == 0 && bytes >= u64::from(header.point_format().len().max(1)) {
            let what = format!("that there are 0 points, and {bytes} bytes follow");
            remarks.push(Remark::Promise { what });
        }
        let transforms = header.transforms();
        for (axis, scale) in [("x", transforms.x.scale), ("y", transforms.y.scale)] {
            if scale.abs() == 0.0 {
                let what =
                    format!("that the scale of {axis} is 0, so that all points have one {axis}");
                remarks.push(Remark::Promise { what });
            }
        }
        let has_system =
            header.get_wkt_crs_bytes().is_some() || matches!(header.get_geotiff_crs(), Ok(Some(_)));
        if has_system && self.system().is_none() {
            let what = "coordinate system, which has no number of the EPSG";
            remarks.push(Remark::ignored(1, what, ""));
        }
        let count = |points| usize::try_from(points).unwrap_or(usize::MAX);
        let is_read = self.count > 0 && self.read == self.count;
        if is_read && !self.classes.is_empty() {
            remarks.push(Remark::Classes {
                kept: self.kept(),
                points: self.counts.iter().sum(),
                counts: self.counts(),
            });
        }
        if is_read && self.withheld > 0 {
            remarks.push(Remark::ignored(
                self.withheld,
                "point that is withheld",
                "points that are withheld",
            ));
        }
        if self.count > 0 && !has_heights {
            remarks.push(Remark::ignored(count(self.count), "height", "heights"));
        }
        if self.count > 0 {
            remarks.push(Remark::Unread {
                count: count(self.count),
                what: "classes, and all else that points have beside places and heights".to_owned(),
            });
        }
        remarks
    }
}

/// Reads the points of a cloud with their heights.
pub(super) fn read(source: &Source) -> Result<GraphFile<f64>, ReadError> {
    let error = |why: String| ReadError::of_file(&source.name, why);
    // The crate wants bytes of its own.
    let bytes = Cursor::new(source.bytes.clone());
    let length = source.bytes.len() as u64;
    let mut cloud = Cloud::open(&source.name, bytes, length, &source.classes)?;
    let limit = source.most_unpacked();
    let (_, count) = cloud.progress();
    if count.saturating_mul(size_of::<[f64; 3]>() as u64) > limit {
        return Err(ReadError {
            kind: ReadErrorKind::UnpackedLimit { limit },
            ..error(format!(
                "{count} points would unpack to more than the limit of {limit} bytes"
            ))
        });
    }
    let (mut some, mut points, mut heights) = (Vec::new(), Vec::new(), Vec::new());
    while cloud.next_points(&mut some)? > 0 {
        points.extend(some.iter().map(|&[x, y, _]| [x, y]));
        heights.extend(some.drain(..).map(|[.., z]| z));
    }
    if let Some(point) = heights.iter().position(|height| !height.is_finite()) {
        return Err(error(format!(
            "point {point} has a height that is not finite"
        )));
    }
    let columns = match heights.is_empty() {
        true => Vec::new(),
        false => vec![Column::heights(heights)],
    };
    Ok(GraphFile {
        columns,
        system: cloud.system(),
        remarks: cloud.remarks(true),
        ..GraphFile::from(Pslg {
            points,
            ..Pslg::default()
        })
    })
}
