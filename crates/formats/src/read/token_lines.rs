//! Text as lines of tokens, as in Triangle's files: `#` begins a comment, blank lines do not count. A line
//! ends with a line feed, a carriage return or both. And numbered records, one a line: vertices, edges and
//! triangles.

use std::convert::Infallible;

use crate::read::source::{ReadError, Source, quoted, split_line};
use crate::threads::in_blocks;
use sweep_cdt::threads::on_all_cores;

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
            let (line, rest) = match memchr::memchr3(b'\n', b'\r', b'#', self.rest) {
                Some(end) if self.rest[end] == b'\n' => (&self.rest[..end], &self.rest[end + 1..]),
                Some(end) => (&self.rest[..end], split_line(&self.rest[end..]).1),
                None => (self.rest, &[][..]),
            };
            (self.rest, self.number) = (rest, self.number + 1);
            let text = line.trim_ascii();
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

    /// How many lines are read.
    pub(super) fn count(&self) -> usize {
        self.number
    }

    /// Goes on behind the next chunk, which has so many lines.
    fn skip(&mut self, chunk: &Lines<'a>, lines: usize) {
        self.rest = &self.rest[chunk.rest.len()..];
        self.number += lines;
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
        // The other white space ends a line.
        let end = memchr::memchr3(b' ', b'\t', b'\x0c', self.rest).unwrap_or(self.rest.len());
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
        // All that is left are digits.
        let digits = std::mem::take(&mut self.rest);
        (!digits.is_empty()).then_some(number)
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
/// Records are read on all cores. The text is cut into chunks that end with a line feed, which is always the end
/// of a line, and each is read by itself. It counts if it holds nothing but records, and if the number of the first
/// follows that of the last record before. From the first chunk that does not, line after line is read: so of several
/// errors the one that stands first in the file is found.
pub(super) struct Records {
    /// The name of a record in messages.
    pub(super) name: &'static str,
    /// The name of its number there.
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
                self.read_chunks(lines, *first, &mut list, &read);
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

    /// Reads the chunks after the first record, as long as they hold nothing but those that follow. Those of some
    /// chunks are read while those before them go to the list.
    fn read_chunks<'a, T: Send>(
        &self,
        lines: &mut Lines<'a>,
        first: usize,
        list: &mut Vec<T>,
        read: &(impl Fn(&mut Line<'a>) -> Result<T, ReadError> + Sync + Send),
    ) {
        const CHUNKS: usize = 32;
        let mut at = list.len();
        let block = || {
            let chunks = lines.chunks(CHUNKS);
            let records = on_all_cores(chunks.clone(), |lines| self.read_chunk(lines, read));
            let mut follow = Vec::with_capacity(chunks.len());
            for (chunk, records) in chunks.iter().zip(records) {
                let Some(records) = records.filter(|records| {
                    let first_number = records.first.unwrap_or(at + first);
                    first_number == at + first && records.list.len() <= self.count - at
                }) else {
                    break;
                };
                at += records.list.len();
                lines.skip(chunk, records.lines);
                follow.push(records.list);
            }
            let goes_on = follow.len() == chunks.len() && !lines.rest.is_empty();
            (follow, goes_on)
        };
        let take = |mut records| {
            list.append(&mut records);
            Ok::<(), Infallible>(())
        };
        let Ok(()) = in_blocks(block, take);
    }

    /// Reads a chunk, if it holds nothing but records with consecutive numbers.
    fn read_chunk<'a, T>(
        &self,
        mut lines: Lines<'a>,
        read: &impl Fn(&mut Line<'a>) -> Result<T, ReadError>,
    ) -> Option<Chunk<T>> {
        let line_feeds = memchr::memchr_iter(b'\n', lines.rest).count();
        let mut list = Vec::with_capacity(line_feeds);
        let mut first = None;
        while let Some(mut line) = lines.next_line() {
            let number = line.index(self.number).ok()?;
            if number.wrapping_sub(*first.get_or_insert(number)) != list.len() {
                return None;
            }
            list.push(read(&mut line).ok()?);
        }
        Some(Chunk {
            first,
            list,
            lines: lines.number,
        })
    }
}

/// The records of a chunk.
struct Chunk<T> {
    list: Vec<T>,
    /// The number of the first one, if there is any.
    first: Option<usize>,
    /// How many lines the chunk has.
    lines: usize,
}
