//! Text as lines of tokens, as in Triangle's files: `#` begins a comment, blank lines do not count. A line
//! ends with a line feed, a carriage return or both. And numbered records, one a line: vertices, edges and
//! triangles.

use std::ops::Range;

use crate::formats::read::source::{ReadError, Source, quoted, split_line};
use crate::threads::{in_blocks, on_all_cores};

/// The lines of a file that hold anything, one after the other.
#[derive(Clone)]
pub(super) struct Lines<'a> {
    source: &'a Source,
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(source: &'a Source) -> Result<Lines<'a>, ReadError> {
        Ok(Lines {
            source,
            rest: source.text()?,
            number: 0,
        })
    }

    /// The next line, or `None` at the end of the file.
    pub(super) fn next_line(&mut self) -> Option<Line<'a>> {
        while !self.rest.is_empty() {
            let (line, rest) = split_line(self.rest);
            (self.rest, self.number) = (rest, self.number + 1);
            let comment = memchr::memchr(b'#', line);
            let text = line[..comment.unwrap_or(line.len())].trim_ascii();
            if !text.is_empty() {
                return Some(Line {
                    source: self.source,
                    number: self.number,
                    rest: text,
                });
            }
        }
        None
    }

    /// The next line, or an error that says what is missing.
    pub(super) fn expect_line(
        &mut self,
        what: impl FnOnce() -> String,
    ) -> Result<Line<'a>, ReadError> {
        self.next_line().ok_or_else(|| {
            let message = format!("the file ends where {} should follow", what());
            self.source.error_in_line(self.number.max(1), message)
        })
    }

    /// The rest of the file in chunks, up to this many, each of them some lines; their numbers begin anew.
    pub(super) fn chunks(&self, count: usize) -> Vec<Lines<'a>> {
        const BYTES: usize = 1 << 17;
        let mut rest = self.rest;
        let mut chunks = Vec::new();
        while !rest.is_empty() && chunks.len() < count {
            let end = rest
                .get(BYTES..)
                .and_then(|rest| memchr::memchr(b'\n', rest));
            let (chunk, others) = rest.split_at(end.map_or(rest.len(), |end| BYTES + end + 1));
            rest = others;
            chunks.push(Lines {
                rest: chunk,
                number: 0,
                ..*self
            });
        }
        chunks
    }

    /// All that is left of the file.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// How many lines hold anything, and how many there are.
    fn count(mut self) -> (usize, usize) {
        let mut records = 0;
        while self.next_line().is_some() {
            records += 1;
        }
        (records, self.number)
    }

    /// Goes on behind the next chunk, which has so many lines, and returns it with their numbers.
    fn skip(&mut self, chunk: &Lines<'a>, lines: usize) -> Lines<'a> {
        let skipped = Lines {
            number: self.number,
            ..*chunk
        };
        self.rest = &self.rest[chunk.rest.len()..];
        self.number += lines;
        skipped
    }

    /// `count` as a size to reserve: no more lines than the rest of the file may hold.
    pub(super) fn capacity(&self, count: usize) -> usize {
        const SHORTEST: usize = "0 0 0\n".len();
        count.min(self.rest.len() / SHORTEST + 1)
    }
}

/// One line, read from the left.
#[derive(Clone)]
pub(super) struct Line<'a> {
    source: &'a Source,
    number: usize,
    rest: &'a [u8],
}

impl<'a> Line<'a> {
    /// The next token, if there is one.
    pub(super) fn token(&mut self) -> Option<&'a [u8]> {
        let end = self
            .rest
            .iter()
            .position(u8::is_ascii_whitespace)
            .unwrap_or(self.rest.len());
        let (token, rest) = self.rest.split_at(end);
        self.rest = rest.trim_ascii_start();
        (!token.is_empty()).then_some(token)
    }

    /// Whether there is no token left.
    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next token as a whole number; `what` it is stands in the message if it is none.
    pub(super) fn index(&mut self, what: &str) -> Result<usize, ReadError> {
        if let Some(number) = self.short_index() {
            return Ok(number);
        }
        let token = self.expect_token(what)?;
        let text = std::str::from_utf8(token).ok();
        text.and_then(|text| text.parse().ok())
            .ok_or_else(|| self.error(format!("{} is not {what}", quoted(token))))
    }

    /// The next token, if it is of digits alone, and so few that the number fits.
    fn short_index(&mut self) -> Option<usize> {
        const DIGITS: usize = usize::MAX.ilog10() as usize;
        let mut number = 0;
        for (at, &byte) in self.rest.iter().enumerate().take(DIGITS + 1) {
            match byte {
                b'0'..=b'9' if at < DIGITS => number = 10 * number + usize::from(byte - b'0'),
                _ if at > 0 && byte.is_ascii_whitespace() => {
                    self.rest = self.rest[at..].trim_ascii_start();
                    return Some(number);
                }
                _ => return None,
            }
        }
        None
    }

    /// The next two tokens, the coordinates of a vertex.
    pub(super) fn coordinates(&mut self) -> Result<[&'a [u8]; 2], ReadError> {
        Ok([
            self.expect_token("an x coordinate")?,
            self.expect_token("a y coordinate")?,
        ])
    }

    /// An error in this line.
    pub(super) fn error(&self, message: impl Into<String>) -> ReadError {
        self.source.error_in_line(self.number, message)
    }

    /// The next token, or an error that says `what` is missing.
    pub(super) fn expect_token(&mut self, what: &str) -> Result<&'a [u8], ReadError> {
        self.token()
            .ok_or_else(|| self.error(format!("the line ends where {what} should follow")))
    }
}

/// Records of one kind.
///
/// The numbers must be consecutive from 0 or 1, since messages use them. (Triangle itself ignores them.)
///
/// They are read on all cores. The text is cut into chunks that end with a line feed, which is always the end
/// of a line. The lines of each are counted, and then each is read by itself, with its first record and its
/// first line known: the same records, and of several errors the one that stands first in the file. Cost:
/// every line is found twice.
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
                self.read_chunks(lines, *first, &mut list, &read)?;
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

    /// Reads the chunks after the first record, as long as they hold nothing else. The records of some chunks are
    /// read while those before them go to the list.
    fn read_chunks<'a, T: Send>(
        &self,
        lines: &mut Lines<'a>,
        first: usize,
        list: &mut Vec<T>,
        read: &(impl Fn(&mut Line<'a>) -> Result<T, ReadError> + Sync + Send),
    ) -> Result<(), ReadError> {
        const CHUNKS: usize = 32;
        let read_chunk = |(mut lines, places): (Lines<'a>, Range<usize>)| {
            let mut records = Vec::with_capacity(places.len());
            while let Some(mut line) = lines.next_line() {
                self.check_number(&mut line, places.start + records.len(), &mut { first })?;
                records.push(read(&mut line)?);
            }
            Ok(records)
        };
        let mut at = list.len();
        let block = || {
            let chunks = lines.chunks(CHUNKS);
            let known = self.known(lines, &chunks, &mut at);
            let goes_on = known.len() == chunks.len() && !lines.rest.is_empty();
            (on_all_cores(known, read_chunk), goes_on)
        };
        in_blocks(block, |records: Result<Vec<T>, _>| {
            list.append(&mut records?);
            Ok(())
        })
    }

    /// Takes those of the next chunks that hold nothing but records, and tells which records each holds. `at` is the
    /// place of the next record.
    fn known<'a>(
        &self,
        lines: &mut Lines<'a>,
        chunks: &[Lines<'a>],
        at: &mut usize,
    ) -> Vec<(Lines<'a>, Range<usize>)> {
        let counts = on_all_cores(chunks.to_vec(), Lines::count);
        let mut known = Vec::with_capacity(chunks.len());
        for (chunk, (records, count)) in chunks.iter().zip(counts) {
            let places = *at..*at + records;
            if places.end > self.count {
                break;
            }
            *at = places.end;
            known.push((lines.skip(chunk, count), places));
        }
        known
    }
}
