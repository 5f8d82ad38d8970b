//! What a cloud says of its lengths, compared with the length of the file before anything is allocated; and why it cannot be
//! read. Cost: a step for each chunk.

use std::io::{self, Read, Seek, SeekFrom};
use std::panic::{AssertUnwindSafe, catch_unwind};

use las::{Header, LazParallelism, Reader, ReaderOptions};
use laz::laszip::{ChunkTable, LazItemType};
use laz::{LasZipError, LazVlr};
use sweep_cdt::threads::has_threads;

use crate::read::source::reason;

/// The most bytes of the points that are read at once, and of a chunk that is unpacked whole.
pub(super) const BYTES: u64 = 1 << 23;

/// The message on a file that ends before all is read that it promises.
pub(super) const CUT_OFF: &str = "the file ends too soon: it is cut off";

/// Why a file cannot be read: what the crates or the system say.
pub(super) struct Fault(pub(super) String);

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
pub(super) fn caught<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let done = catch_unwind(AssertUnwindSafe(work));
    done.unwrap_or_else(|_| Err(Fault("what is packed is damaged".to_owned())))
}

/// Checks a file, and reads it from the begin. Returns also where its points begin.
pub(super) fn reader(
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
