//! Pixels as a file: PNG, in true colour.
//!
//! The format is that of ISO/IEC 15948: a signature, and chunks with lengths and checks. Each row is replaced by its
//! differences to the pixels on its left or above, whichever sum is smaller, and all rows are packed by `miniz_oxide`.

use std::io::{self, Write};

use miniz_oxide::deflate::compress_to_vec_zlib;

/// How hard the pixels are packed, of 10.
const LEVEL: u8 = 9;
/// Bytes of a pixel.
const PIXEL: usize = 3;

/// Writes rows of pixels, each red, green and blue.
pub(super) fn write(pixels: &[u8], width: usize, out: &mut impl Write) -> io::Result<()> {
    let rows = pixels.chunks_exact(PIXEL * width);
    let mut header = Vec::new();
    for size in [width, rows.len()] {
        let size = u32::try_from(size).map_err(io::Error::other)?;
        header.extend(size.to_be_bytes());
    }
    // 8 bits each of red, green and blue; no other choices.
    header.extend([8, 2, 0, 0, 0]);
    out.write_all(b"\x89PNG\r\n\x1a\n")?;
    chunk(*b"IHDR", &header, out)?;
    chunk(*b"IDAT", &compress_to_vec_zlib(&filtered(rows), LEVEL), out)?;
    chunk(*b"IEND", &[], out)
}

/// The rows as differences, each with the number of its filter before it.
fn filtered<'a>(rows: impl Iterator<Item = &'a [u8]>) -> Vec<u8> {
    let mut all = Vec::new();
    let mut above: Option<&[u8]> = None;
    for row in rows {
        let left = |at: usize| at.checked_sub(PIXEL).map_or(0, |left| row[left]);
        let up = |at: usize| above.map_or(0, |above| above[at]);
        let sub = (0..row.len()).map(|at| row[at].wrapping_sub(left(at)));
        let from_up = (0..row.len()).map(|at| row[at].wrapping_sub(up(at)));
        let size = |byte: u8| u64::from(byte.cast_signed().unsigned_abs());
        if sub.clone().map(size).sum::<u64>() < from_up.clone().map(size).sum::<u64>() {
            all.push(1);
            all.extend(sub);
        } else {
            all.push(2);
            all.extend(from_up);
        }
        above = Some(row);
    }
    all
}

/// Writes a chunk: its length, its name, its contents, and the check of the last two.
fn chunk(name: [u8; 4], contents: &[u8], out: &mut impl Write) -> io::Result<()> {
    let length = u32::try_from(contents.len()).map_err(io::Error::other)?;
    out.write_all(&length.to_be_bytes())?;
    out.write_all(&name)?;
    out.write_all(contents)?;
    let check = name.iter().chain(contents).fold(u32::MAX, |check, byte| {
        let index = (check ^ u32::from(*byte)) & 0xFF;
        (check >> 8) ^ CHECKS[index as usize]
    });
    out.write_all(&(!check).to_be_bytes())
}

/// The remainders of all bytes by the polynomial of CRC-32.
const CHECKS: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0_u32;
    while byte < 256 {
        let mut rest = byte;
        let mut bit = 0;
        while bit < 8 {
            rest = if rest & 1 == 1 {
                rest >> 1 ^ 0xEDB8_8320
            } else {
                rest >> 1
            };
            bit += 1;
        }
        table[byte as usize] = rest;
        byte += 1;
    }
    table
};
