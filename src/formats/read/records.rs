//! Numbered records, one a line: vertices, edges and triangles of Triangle's files.
//!
//! The numbers must be consecutive from 0 or 1, since messages use them. (Triangle itself ignores them.)
//!
//! They are read on all cores. The text is cut into chunks that end with a line feed, which is always the end
//! of a line. The lines of each are counted, and then each is read by itself, with its first record and its
//! first line known: the same records, and of several errors the one that stands first in the file. Cost:
//! every line is found twice.

use crate::formats::cores;
use crate::formats::read::source::ReadError;
use crate::formats::read::token_lines::{Line, Lines};

/// Records of one kind.
pub(super) struct Records {
    /// What messages call a record.
    pub(super) name: &'static str,
    /// What they call its number.
    pub(super) number: &'static str,
    /// How many there must be.
    pub(super) count: usize,
}

impl Records {
    /// Reads all of them; `read` gets the rest of each line. The number of the first one is left in `first`
    /// if it is 0 or 1, and must be what `first` says otherwise.
    pub(super) fn read<'a, T: Send>(
        &self,
        lines: &mut Lines<'a>,
        first: &mut usize,
        read: impl Fn(&mut Line<'a>) -> Result<T, ReadError> + Sync + Send,
    ) -> Result<Vec<T>, ReadError> {
        let mut list = Vec::with_capacity(lines.capacity(self.count));
        while list.len() < self.count {
            let missing = || format!("{} {} of {}", self.name, list.len() + 1, self.count);
            let mut line = lines.expect_line(missing)?;
            self.check_number(&mut line, list.len(), first)?;
            list.push(read(&mut line)?);
            // The first record has said where the numbers begin.
            if list.len() == 1 {
                while self.read_block(lines, *first, &mut list, &read)? {}
            }
        }
        Ok(list)
    }

    /// Reads the number of record `at`, counted from 0.
    fn check_number(
        &self,
        line: &mut Line<'_>,
        at: usize,
        first: &mut usize,
    ) -> Result<(), ReadError> {
        let number = line.index(self.number)?;
        if at == 0 && number <= 1 {
            *first = number;
        }
        match at + *first {
            expected if expected == number => Ok(()),
            _ if at == 0 => Err(line.error(format!("the first number is {number}, not 0 or 1"))),
            expected => Err(line.error(format!("the number is {number}, not {expected}"))),
        }
    }

    /// Reads the next chunks, as long as they hold nothing else; false if that was not all of them, or none.
    fn read_block<'a, T: Send>(
        &self,
        lines: &mut Lines<'a>,
        first: usize,
        list: &mut Vec<T>,
        read: &(impl Fn(&mut Line<'a>) -> Result<T, ReadError> + Sync + Send),
    ) -> Result<bool, ReadError> {
        const CHUNKS: usize = 32;
        let chunks = lines.chunks(CHUNKS);
        let counts = cores::map(chunks.clone(), Lines::count);
        let mut at = list.len();
        let mut known = Vec::with_capacity(chunks.len());
        for (chunk, (records, count)) in chunks.iter().zip(counts) {
            if at + records > self.count {
                break;
            }
            known.push((lines.skip(chunk, count), at));
            at += records;
        }
        let is_all = !known.is_empty() && known.len() == chunks.len();
        let read_chunk = |(mut lines, at): (Lines<'a>, usize)| {
            let mut records = Vec::new();
            while let Some(mut line) = lines.next_line() {
                self.check_number(&mut line, at + records.len(), &mut { first })?;
                records.push(read(&mut line)?);
            }
            Ok(records)
        };
        for records in cores::map(known, read_chunk) {
            list.append(&mut records?);
        }
        Ok(is_all)
    }
}
