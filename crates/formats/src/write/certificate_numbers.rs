//! The coordinates of a certificate: integers times one power of two, as text.
//!
//! Most doubles fit into registers: a double is 53 bits times a power of two, and 128 bits hold it in units of the least one
//! of them, unless sizes differ much. Others are integers of any length.

use std::io;

use crate::Coordinate;

/// The least exponent of two among coordinates that are not 0.
pub(super) fn least_exponent<S: Coordinate>(points: &[[S; 2]]) -> io::Result<i64> {
    let mut least: Option<i64> = None;
    for coordinate in points.iter().flatten() {
        let exponent = match coordinate.small_binary() {
            Some((0, _)) => continue,
            Some((_, exponent)) => exponent,
            None => coordinate.binary().ok_or_else(no_integer)?.1,
        };
        least = Some(least.map_or(exponent, |least| least.min(exponent)));
    }
    Ok(least.unwrap_or(0))
}

fn no_integer() -> io::Error {
    let why = "a certificate has integers times a power of two, and a coordinate is none, such as 1/3 or 0.1 read \
               exactly: multiply all by their denominators";
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

/// Appends a line: a letter and numbers.
pub(super) fn push_line(letter: u8, numbers: &[u64], text: &mut Vec<u8>) {
    text.push(letter);
    for number in numbers {
        text.push(b' ');
        text.extend_from_slice(itoa::Buffer::new().format(*number).as_bytes());
    }
    text.push(b'\n');
}

/// Appends a coordinate in units of two to the power `least`. Hexadecimal digits are quicker to write and to read.
pub(super) fn push_integer<S: Coordinate>(
    coordinate: &S,
    least: i64,
    text: &mut Vec<u8>,
) -> io::Result<()> {
    if let Some((integer, exponent)) = coordinate.small_binary() {
        if integer == 0 {
            text.push(b'0');
            return Ok(());
        }
        let shift = (exponent - least).unsigned_abs();
        if u64::from(integer.unsigned_abs().leading_zeros()) + 64 >= shift {
            push_short(
                integer < 0,
                u128::from(integer.unsigned_abs()) << shift,
                text,
            );
            return Ok(());
        }
    }
    let (integer, exponent) = coordinate.binary().ok_or_else(no_integer)?;
    let integer = integer << (exponent - least).unsigned_abs();
    match i64::try_from(&integer) {
        Ok(small) => text.extend_from_slice(itoa::Buffer::new().format(small).as_bytes()),
        Err(_) => text.extend_from_slice(format!("{integer:#x}").as_bytes()),
    }
    Ok(())
}

/// Decimal digits if 64 bits hold the number with its sign, and hexadecimal ones otherwise.
fn push_short(is_negative: bool, size: u128, text: &mut Vec<u8>) {
    if is_negative {
        text.push(b'-');
    }
    let least = u128::from(i64::MIN.unsigned_abs());
    if size < least || size == least && is_negative {
        let mut digits = itoa::Buffer::new();
        text.extend_from_slice(digits.format(size).as_bytes());
        return;
    }
    text.extend_from_slice(b"0x");
    for place in (0..(128 - size.leading_zeros()).div_ceil(4)).rev() {
        text.push(b"0123456789abcdef"[(size >> (4 * place)) as usize & 15]);
    }
}
