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

use std::fmt;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::panic::{AssertUnwindSafe, catch_unwind};

use las::{Header, LazParallelism, PointData, PointDataBuilder, Reader, ReaderOptions};
use laz::laszip::{ChunkTable, LazItemType};
use laz::{LasZipError, LazVlr};
use sweep_cdt::Pslg;
use sweep_cdt::threads::has_threads;

use crate::read::source::{ReadError, ReadErrorKind, Source, reason};
use crate::remark::of_classes;
use crate::{Column, CoordinateSystem, GraphFile, Remark};

/// How many points are read at once: a few chunks of a `.laz`, which are unpacked on all cores. They are fewer where they
/// would take more than [`BYTES`].
const POINTS: u64 = 1 << 18;

/// The most bytes of the points that are read at once, and of a chunk that is unpacked whole.
const BYTES: u64 = 1 << 23;

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
            counts: [0; 256],
            withheld: 0,
            length,
            points_begin,
            read: 0,
            count,
        })
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
        if come == 0 && self.count > 0 && !self.classes.is_empty() && self.kept() == 0 {
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

/// The message on a file that ends before all is read that it promises.
const CUT_OFF: &str = "the file ends too soon: it is cut off";

/// Why a file cannot be read: what the crates or the system say.
struct Fault(String);

impl From<String> for Fault {
    fn from(why: String) -> Fault {
        Fault(why)
    }
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Fault {
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Fault(CUT_OFF.to_owned()),
            _ => Fault(reason(&error)),
        }
    }
}

impl From<LasZipError> for Fault {
    fn from(error: LasZipError) -> Fault {
        match error {
            LasZipError::IoError(error) => error.into(),
            _ => Fault(error.to_string()),
        }
    }
}

impl From<las::Error> for Fault {
    fn from(error: las::Error) -> Fault {
        match error {
            las::Error::Io(error) => error.into(),
            las::Error::LasZipError(error) => error.into(),
            _ => Fault(error.to_string()),
        }
    }
}

/// What the crates make of a file. Some of their decoders end in a panic where bytes are damaged: here that is an error,
/// after which nobody goes on with them.
fn caught<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let done = catch_unwind(AssertUnwindSafe(work));
    done.unwrap_or_else(|_| Err(Fault("what is packed is damaged".to_owned())))
}

/// Checks a file, and reads it from the begin. Returns also where its points begin.
fn reader(
    mut read: impl Read + Seek + Send + Sync + 'static,
    length: u64,
) -> Result<(Reader, u64), Fault> {
    if length == 0 {
        return Err(Fault("the file is empty".to_owned()));
    }
    let begin = check_lengths(&mut read, length)?;
    read.rewind()?;
    let chunk = largest_chunk(&mut read, length)?;
    let parallelism = match chunk <= BYTES && has_threads() {
        true => LazParallelism::Yes,
        false => LazParallelism::No,
    };
    let options = ReaderOptions::default().with_laz_parallelism(parallelism);
    read.rewind()?;
    let reader = Reader::with_options(read, options)?;
    Ok((reader, begin))
}

/// Refuses a header that says of points, and of the record behind them, more than the file has room for.
/// Returns where the points begin.
fn check_lengths(read: &mut (impl Read + Seek), length: u64) -> Result<u64, Fault> {
    let header = las::raw::Header::read_from(&mut *read)?;
    let large = header.large_file.map(|large| large.number_of_point_records);
    let count = match header.number_of_point_records {
        0 => large.unwrap_or(0),
        count => u64::from(count),
    };
    let bytes = count.checked_mul(u64::from(header.point_data_record_length));
    let end = bytes.and_then(|bytes| bytes.checked_add(header.offset_to_point_data.into()));
    let is_packed = header.point_data_record_format & 0x80 != 0;
    if end.is_none_or(|end| end > length && !is_packed) {
        return Err(
            format!("it has {length} bytes, and {count} points take more: it is cut off").into(),
        );
    }
    let points_begin = header.offset_to_point_data.into();
    let Some(record) = header.evlr else {
        return Ok(points_begin);
    };
    let begin = record.start_of_first_evlr;
    // Behind 20 bytes stands the length of what follows a head of 60.
    let after = |bytes: u64| begin.checked_add(bytes).filter(|&place| place <= length);
    let size = after(20).map(|place| {
        read.seek(SeekFrom::Start(place))?;
        next_number(read)
    });
    let size = size.transpose()?;
    match size.and_then(|size| after(size.checked_add(60)?)) {
        Some(_) => Ok(points_begin),
        None => Err(format!(
            "the record behind its points is longer than its {length} bytes: it is cut off"
        )
        .into()),
    }
}

/// The bytes of the points of the largest chunk; 0 where nothing is packed. Refuses a table of chunks with more than the
/// file has room for.
fn largest_chunk(read: &mut (impl Read + Seek + Send), length: u64) -> Result<u64, Fault> {
    let header = Header::new(&mut *read)?;
    if !header.point_format().is_compressed {
        return Ok(0);
    }
    let vlr = header.laz_vlr()?;
    let [packed, each] = [vlr.items_size(), header.point_format().len().into()];
    if packed != each {
        return Err(format!(
            "a point has {each} bytes by its header, and {packed} where it is packed"
        )
        .into());
    }
    let (begin, table, count) = table_of_chunks(read)?;
    let room = table.saturating_sub(begin);
    if table > length || u64::from(count) > room {
        return Err(format!(
            "its table of chunks has {count} entries, and there is no room for so many in its {length} bytes"
        ).into());
    }
    read.seek(SeekFrom::Start(begin))?;
    let chunks = ChunkTable::read_from(&mut *read, &vlr)?;
    let chunks: &[_] = chunks.as_ref();
    let packed = chunks.iter().map(|chunk| u128::from(chunk.byte_count));
    if packed.sum::<u128>() > u128::from(room) {
        return Err(format!("its chunks are longer than its {length} bytes").into());
    }
    let mut place = begin + ChunkTable::OFFSET_SIZE as u64;
    for (number, chunk) in chunks
        .iter()
        .enumerate()
        .filter(|(_, chunk)| chunk.byte_count > 0)
    {
        let layers = layers(read, place, &vlr)?;
        if layers > chunk.byte_count {
            return Err(format!("the layers of chunk {number} are longer than the chunk").into());
        }
        place += chunk.byte_count;
    }
    let points = chunks.iter().map(|chunk| chunk.point_count);
    let count = header.number_of_points();
    let most = points.clone().fold(0_u64, u64::saturating_add);
    if count > most {
        return Err(
            format!("its header says {count} points, and its chunks have at most {most}").into(),
        );
    }
    Ok(points.max().unwrap_or(0).saturating_mul(each))
}

/// The bytes of the layers of the chunk at a place, as it says: after its first point and the number of its points. Points
/// of the first formats have no layers.
fn layers(read: &mut (impl Read + Seek), place: u64, vlr: &LazVlr) -> io::Result<u64> {
    let count = |item: LazItemType| match item {
        LazItemType::Point14 => 9,
        LazItemType::RGB14 | LazItemType::WavePacket14 => 1,
        LazItemType::RGBNIR14 => 2,
        LazItemType::Byte14(count) => usize::from(count),
        _ => 0,
    };
    let count: usize = vlr.items().iter().map(|item| count(item.item_type())).sum();
    let mut sizes = vec![[0; 4]; count];
    read.seek(SeekFrom::Start(place + vlr.items_size() + 4))?;
    read.read_exact(sizes.as_flattened_mut())?;
    let sizes = sizes.into_iter().map(u32::from_le_bytes);
    Ok(sizes.map(u64::from).sum())
}

/// Where the points begin, where the table of chunks begins, and how many entries it has. Its place stands before the
/// points, or, where that is not known when they are written, at the end.
fn table_of_chunks(read: &mut (impl Read + Seek)) -> io::Result<(u64, u64, u32)> {
    let begin = read.stream_position()?;
    let mut table = next_place(read)?;
    if table <= begin {
        read.seek(SeekFrom::End(-8))?;
        table = next_place(read)?;
    }
    read.seek(SeekFrom::Start(table))?;
    let mut bytes = [0; 8];
    read.read_exact(&mut bytes)?;
    let [_, _, _, _, count @ ..] = bytes;
    Ok((begin, table, u32::from_le_bytes(count)))
}

/// The next eight bytes as a number.
fn next_number(read: &mut impl Read) -> io::Result<u64> {
    let mut bytes = [0; 8];
    read.read_exact(&mut bytes)?;
    Ok(u64::from_le_bytes(bytes))
}

/// The next eight bytes as a place in the file, or 0.
fn next_place(read: &mut impl Read) -> io::Result<u64> {
    let number = next_number(read)?;
    Ok(if i64::try_from(number).is_ok() {
        number
    } else {
        0
    })
}
