//! How the arrays of a `.vtu` are stored: as text, or as the bytes of their numbers.
//!
//! Bytes begin with a header of whole numbers of 32 or 64 bits. Without zlib it is one, how many bytes follow. With it
//! the header says how many blocks there are, the size of each but the last one and that of the last one when unpacked,
//! and the size of each when packed. In base 64 the header and the rest are written alone or together, so the signs `=`
//! may stand in the middle, too.
//!
//! Arrays in `AppendedData` end where the next one begins, and no two begin at the same place: so no byte of a file is
//! unpacked twice, however the file lies.
//!
//! What zlib packs may grow by a factor of 1,032, so there is a limit. A block unpacks to as many bytes as the header
//! says, or the array is refused. So it is the header that is compared with the limit, before anything is unpacked.

use std::ops::Range;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_zlib_with_limit};

/// Where the numbers of an array stand.
pub(super) enum Stored {
    /// As text, at this place of the file.
    Text(Range<usize>),
    /// In base 64, at this place of the file.
    Base64(Range<usize>),
    /// So far behind the beginning of `AppendedData`.
    Appended(usize),
}

/// How numbers become bytes, for the whole file.
pub(super) struct Packing<'a> {
    pub(super) big_endian: bool,
    /// Whether the numbers in headers have 64 bits.
    pub(super) has_wide_headers: bool,
    pub(super) is_zlib: bool,
    pub(super) appended: Option<Appended<'a>>,
}

/// `AppendedData`.
pub(super) struct Appended<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) is_base64: bool,
    /// Where arrays begin, in order.
    pub(super) offsets: Vec<usize>,
}

/// Why an array is not unpacked.
pub(super) enum Fault {
    /// How the array is wrong.
    Wrong(String),
    /// The bytes that the array claims to have, more than there is room for.
    NoRoom(u64),
}

impl<T: Into<String>> From<T> for Fault {
    fn from(what: T) -> Fault {
        Fault::Wrong(what.into())
    }
}

impl Packing<'_> {
    /// Appends the bytes of an array's numbers to `unpacked`, at most `room` if they are packed. Text has none.
    pub(super) fn unpack(
        &self,
        stored: &Stored,
        file: &[u8],
        unpacked: &mut Vec<u8>,
        room: u64,
    ) -> Result<(), Fault> {
        match stored {
            Stored::Text(_) => Ok(()),
            Stored::Base64(range) => {
                self.unpack_blocks(&decoded(&file[range.clone()])?, unpacked, room)
            }
            &Stored::Appended(offset) => {
                let appended = self.appended.as_ref();
                let appended = appended.ok_or("there is no `AppendedData`")?;
                let bytes = appended.array(offset)?;
                if appended.is_base64 {
                    self.unpack_blocks(&decoded(bytes)?, unpacked, room)
                } else {
                    self.unpack_blocks(bytes, unpacked, room)
                }
            }
        }
    }

    fn unpack_blocks(
        &self,
        mut bytes: &[u8],
        unpacked: &mut Vec<u8>,
        room: u64,
    ) -> Result<(), Fault> {
        const SHORT: &str = "there are fewer bytes than it says";
        if bytes.is_empty() {
            return Ok(());
        }
        let mut header = || self.take_number(&mut bytes).ok_or(SHORT);
        if !self.is_zlib {
            let size = header()?;
            unpacked.extend_from_slice(bytes.get(..size).ok_or(SHORT)?);
            return Ok(());
        }
        let (blocks, full, last) = (header()?, header()?, header()?);
        // Each has a number in the header.
        let mut sizes = Vec::new();
        for _ in 0..blocks {
            sizes.push(header()?);
        }
        let before = blocks.saturating_sub(1).saturating_mul(full);
        let said = before.saturating_add(if last > 0 { last } else { full }) as u64;
        if blocks > 0 && said > room {
            return Err(Fault::NoRoom(said));
        }
        for (at, size) in sizes.into_iter().enumerate() {
            let (block, rest) = bytes.split_at_checked(size).ok_or(SHORT)?;
            let is_partial = at + 1 == blocks && last > 0;
            inflate(block, if is_partial { last } else { full }, unpacked)?;
            bytes = rest;
        }
        Ok(())
    }

    /// The next number of a header.
    fn take_number(&self, bytes: &mut &[u8]) -> Option<usize> {
        let size = if self.has_wide_headers { 8 } else { 4 };
        let (number, rest) = bytes.split_at_checked(size)?;
        *bytes = rest;
        let mut padded = [0; 8];
        if self.big_endian {
            padded[8 - size..].copy_from_slice(number);
            usize::try_from(u64::from_be_bytes(padded)).ok()
        } else {
            padded[..size].copy_from_slice(number);
            usize::try_from(u64::from_le_bytes(padded)).ok()
        }
    }
}

impl<'a> Appended<'a> {
    /// The bytes from here to the next array.
    fn array(&self, offset: usize) -> Result<&'a [u8], String> {
        let after = self.offsets.partition_point(|&other| other <= offset);
        if after > 1 && self.offsets[after - 2] == offset {
            return Err(format!("another one has the offset {offset}, too"));
        }
        let end = self.offsets.get(after).copied();
        let end = end.unwrap_or(self.bytes.len()).min(self.bytes.len());
        let bytes = self.bytes.get(offset..end);
        bytes.ok_or_else(|| format!("`AppendedData` ends before the offset {offset}"))
    }
}

/// The bytes that a text in base 64 stands for; it may be several such texts, one after the other.
fn decoded(text: &[u8]) -> Result<Vec<u8>, String> {
    let text: Vec<u8> = text
        .iter()
        .copied()
        .filter(|byte| !byte.is_ascii_whitespace())
        .collect();
    let mut bytes = Vec::new();
    let mut rest = text.as_slice();
    while !rest.is_empty() {
        let sign = rest.iter().position(|&byte| byte == b'=');
        let signs = |at: &usize| rest[*at..].iter().take_while(|&&byte| byte == b'=').count();
        let end = sign.map_or(rest.len(), |at| at + signs(&at));
        let (piece, others) = rest.split_at(end);
        let decode = STANDARD.decode_vec(piece, &mut bytes);
        decode.map_err(|error| format!("no base 64: {error}"))?;
        rest = others;
    }
    Ok(bytes)
}

/// Appends what a block is when it is unpacked, which must have this size.
fn inflate(block: &[u8], size: usize, unpacked: &mut Vec<u8>) -> Result<(), String> {
    // A byte more than there may be tells a block that is too large.
    match decompress_to_vec_zlib_with_limit(block, size.saturating_add(1)) {
        Ok(bytes) if bytes.len() == size => {
            unpacked.extend(bytes);
            Ok(())
        }
        Err(error) if error.status != TINFLStatus::HasMoreOutput => {
            Err(format!("a block is not packed by zlib: {error}"))
        }
        _ => Err(format!(
            "a block does not have the {size} bytes that it says"
        )),
    }
}
