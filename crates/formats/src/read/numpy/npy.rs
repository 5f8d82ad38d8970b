//! NumPy's `.npy`, of the versions 1 to 3: one array of numbers.
//!
//! ```text
//! \x93NUMPY, the version in two bytes, and the length of the header in two (version 1) or four
//! {'descr': '<f8', 'fortran_order': False, 'shape': (5, 2), }     a literal of Python
//! the numbers as they are, row after row, or column after column
//! ```
//!
//! Read are floats of 32 and 64 bits, and whole numbers of 8 to 64, in either order of bytes. Arrays of fields, of
//! objects and of anything else are refused by their type. The header is not believed: the numbers must be there, and no
//! bytes behind them.

use std::ops::Range;

use crate::read::binary::{Kind, Number};
use crate::read::content::Syntax;
use crate::read::source::quoted;

/// An array: how its numbers stand, and where.
pub(super) struct Array {
    number: Number,
    /// Whether the numbers have 64 bits and no sign.
    is_unsigned: bool,
    is_by_columns: bool,
    shape: Vec<usize>,
    /// The place of the numbers in the file.
    range: Range<usize>,
}

impl Array {
    /// The array that stands in this part of a file; or what is wrong with it.
    pub(super) fn of(file: &[u8], part: Range<usize>) -> Result<Array, String> {
        const SHORT: &str = "the file ends in the header of an array";
        let bytes = &file[part.clone()];
        let rest = bytes.strip_prefix(b"\x93NUMPY");
        let rest = rest.ok_or("it does not begin as an array of NumPy does (`.npy`)")?;
        let (version, rest) = rest.split_at_checked(2).ok_or(SHORT)?;
        let digits = match version[0] {
            1 => 2,
            2 | 3 => 4,
            other => {
                return Err(format!(
                    "the version of `.npy` is {other}, and only 1 to 3 are read"
                ));
            }
        };
        let (length, rest) = rest.split_at_checked(digits).ok_or(SHORT)?;
        let digit = |length: usize, &byte: &u8| length << 8 | usize::from(byte);
        let length = length.iter().rev().fold(0, digit);
        let (header, numbers) = rest.split_at_checked(length).ok_or(SHORT)?;
        let header = String::from_utf8_lossy(header);
        let (number, is_unsigned) = type_of(&header)?;
        let shape = shape_of(&header)?;
        let is_by_columns = value(&header, "fortran_order")?.starts_with("True");
        let sizes = shape.iter().copied();
        let mut sizes = sizes.chain([number.kind.size()]);
        let size = sizes.try_fold(1_usize, usize::checked_mul);
        match size {
            Some(size) if size == numbers.len() => Ok(Array {
                number,
                is_unsigned,
                is_by_columns,
                shape,
                range: part.end - numbers.len()..part.end,
            }),
            Some(size) if size < numbers.len() => Err(format!(
                "{} bytes follow behind the array, and only one array is read",
                numbers.len() - size
            )),
            _ => Err(format!(
                "the file ends in the array, whose shape is {}",
                text(&shape)
            )),
        }
    }

    pub(super) fn syntax(&self) -> Syntax {
        Syntax::Binary(self.number)
    }

    /// The shape as Python writes it.
    pub(super) fn shape(&self) -> String {
        text(&self.shape)
    }

    /// How many rows and columns there are, if it is a matrix. An empty list is one, too.
    pub(super) fn matrix(&self) -> Option<[usize; 2]> {
        match *self.shape.as_slice() {
            [rows, columns] => Some([rows, columns]),
            [0] => Some([0, 2]),
            _ => None,
        }
    }

    /// How many numbers there are, if it is a list.
    pub(super) fn list(&self) -> Option<usize> {
        match *self.shape.as_slice() {
            [count] => Some(count),
            _ => None,
        }
    }

    /// Where a number of a matrix stands.
    pub(super) fn piece<'a>(
        &self,
        file: &'a [u8],
        size: [usize; 2],
        row: usize,
        column: usize,
    ) -> &'a [u8] {
        let [rows, columns] = size;
        let at = if self.is_by_columns {
            column * rows + row
        } else {
            row * columns + column
        };
        let bytes = self.number.kind.size();
        &file[self.range.clone()][at * bytes..(at + 1) * bytes]
    }

    /// Refuses whole numbers that are no doubles.
    pub(super) fn expect_doubles(&self, file: &[u8]) -> Result<(), String> {
        const LIMIT: f64 = 9_007_199_254_740_992.0;
        if self.number.kind != Kind::I64 {
            return Ok(());
        }
        for piece in file[self.range.clone()].chunks_exact(self.number.kind.size()) {
            let value = self.number.value(piece);
            let is_exact = value.abs() < LIMIT && !(self.is_unsigned && value < 0.0);
            if !is_exact {
                return Err("a whole number is 2^53 or more, which is no double".to_owned());
            }
        }
        Ok(())
    }
}

/// What stands behind a key of the header.
fn value<'h>(header: &'h str, key: &str) -> Result<&'h str, String> {
    let found = header.split_once(&format!("'{key}':"));
    let (_, value) = found.ok_or_else(|| format!("the header of the array has no `{key}`"))?;
    Ok(value.trim_start())
}

/// How the numbers stand, and whether they are of 64 bits without a sign.
fn type_of(header: &str) -> Result<(Number, bool), String> {
    let descr = value(header, "descr")?;
    if descr.starts_with('[') {
        let message = "the array has fields, which are not read: make numbers of it by \
                       numpy.lib.recfunctions.structured_to_unstructured";
        return Err(message.to_owned());
    }
    let name = descr
        .strip_prefix('\'')
        .and_then(|text| text.split_once('\''));
    let name = name.map_or("", |(name, _)| name);
    let (order, kind) = name.split_at_checked(1).unwrap_or_default();
    let kind = match kind {
        "i1" => Kind::I8,
        "u1" => Kind::U8,
        "i2" => Kind::I16,
        "u2" => Kind::U16,
        "i4" => Kind::I32,
        "u4" => Kind::U32,
        "i8" | "u8" => Kind::I64,
        "f4" => Kind::F32,
        "f8" => Kind::F64,
        _ => {
            let name = quoted(name.as_bytes());
            return Err(format!(
                "the numbers are of the type {name}, which is not read: make doubles of them by .astype(float)"
            ));
        }
    };
    let big_endian = order == ">";
    Ok((Number { kind, big_endian }, name.ends_with("u8")))
}

fn shape_of(header: &str) -> Result<Vec<usize>, String> {
    let shape = value(header, "shape")?;
    let inside = shape
        .strip_prefix('(')
        .and_then(|text| text.split_once(')'));
    let (inside, _) = inside.ok_or("the header of the array has a `shape` that is no tuple")?;
    let sizes = inside
        .split(',')
        .map(str::trim)
        .filter(|size| !size.is_empty());
    // Python 2 wrote `L` behind long numbers.
    let size = |text: &str| text.strip_suffix('L').unwrap_or(text).parse();
    let sizes: Result<Vec<usize>, _> = sizes.map(size).collect();
    sizes.map_err(|_| format!("the shape is {}", quoted(format!("({inside})").as_bytes())))
}

/// A shape as Python writes it.
fn text(shape: &[usize]) -> String {
    let sizes: Vec<String> = shape.iter().map(usize::to_string).collect();
    match sizes.as_slice() {
        [one] => format!("({one},)"),
        _ => format!("({})", sizes.join(", ")),
    }
}
