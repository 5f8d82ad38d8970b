//! Text that is read line by line, in pieces of a file: `#` begins a comment, blank lines do not count. A line ends with a
//! line feed, a carriage return or both.

use sweep_cdt_formats::{Coordinate, CoordinateError, ReadError, Source, quoted};

use crate::external::input::file::{InputFile, PIECE};

/// A line that is longer is none of a text of points.
const LONGEST: usize = 1 << 21;

/// The lines of a file that hold anything, one after the other.
#[derive(Debug)]
pub(super) struct Lines {
    pub(super) file: InputFile,
    /// What is read of the file, and where the next line begins.
    bytes: Vec<u8>,
    at: usize,
    /// Where the line stands to which this went.
    line: (usize, usize),
    /// How many lines are read.
    number: usize,
}

impl Lines {
    /// The lines from where the file stands, of which so many were read before.
    pub(super) fn new(file: InputFile, number: usize) -> Lines {
        Lines {
            file,
            bytes: Vec::new(),
            at: 0,
            line: (0, 0),
            number,
        }
    }

    /// Goes on at this byte, before which there are so many lines.
    pub(super) fn go_to(&mut self, byte: u64, number: usize) -> Result<(), ReadError> {
        self.bytes.clear();
        (self.at, self.number) = (0, number);
        self.file.go_to(byte)
    }

    /// Goes to the next line, and tells whether there is one.
    pub(super) fn advance(&mut self) -> Result<bool, ReadError> {
        while let Some((begin, end)) = self.find_line()? {
            let line = &self.bytes[begin..end];
            let comment = memchr::memchr(b'#', line).unwrap_or(line.len());
            self.line = (begin, begin + comment);
            if !line[..comment].trim_ascii().is_empty() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The line to which this went.
    pub(super) fn line(&self) -> Line<'_> {
        let (begin, end) = self.line;
        Line {
            file: &self.file,
            number: self.number,
            rest: self.bytes[begin..end].trim_ascii(),
        }
    }

    /// The next line, or an error that says what is missing.
    pub(super) fn expect(&mut self, what: impl FnOnce() -> String) -> Result<Line<'_>, ReadError> {
        if self.advance()? {
            return Ok(self.line());
        }
        let message = format!("the file ends where {} should follow", what());
        Err(self.file.error_in_line(self.number.max(1), message))
    }

    /// Finds the next line in what is read, and reads more if it is not there; `None` at the end of the file.
    fn find_line(&mut self) -> Result<Option<(usize, usize)>, ReadError> {
        let mut from = self.at;
        loop {
            let end = memchr::memchr2(b'\n', b'\r', &self.bytes[from..]).map(|end| from + end);
            // A line feed may follow a carriage return.
            if let Some(end) = end
                && (self.bytes[end] == b'\n' || end + 1 < self.bytes.len() || self.file.left() == 0)
            {
                let is_both = self.bytes[end..].starts_with(b"\r\n");
                let line = (self.at, end);
                self.at = end + 1 + usize::from(is_both);
                self.number += 1;
                return Ok(Some(line));
            }
            if self.file.left() == 0 {
                if self.at == self.bytes.len() {
                    return Ok(None);
                }
                let line = (self.at, self.bytes.len());
                self.at = self.bytes.len();
                self.number += 1;
                return Ok(Some(line));
            }
            if self.bytes.len() - self.at > LONGEST {
                let message = "the line does not end: is this a text?";
                return Err(self.file.error_in_line(self.number + 1, message));
            }
            from = end.unwrap_or(self.bytes.len()) - self.at;
            self.bytes.drain(..self.at);
            self.at = 0;
            let is_first = self.file.at == 0;
            self.file.read(PIECE, &mut self.bytes)?;
            if is_first {
                let first = &self.bytes[..self.bytes.len().min(64)];
                let first = Source::new(&self.file.name, first);
                // A mark of UTF-8 is no part of the text.
                self.at = first.bytes.len() - first.text()?.len();
                from = self.at;
            }
        }
    }
}

/// One line, read from the left.
#[derive(Debug)]
pub(super) struct Line<'a> {
    file: &'a InputFile,
    number: usize,
    rest: &'a [u8],
}

impl<'a> Line<'a> {
    /// The next token, or an error that says `what` is missing.
    pub(super) fn expect(&mut self, what: &str) -> Result<&'a [u8], ReadError> {
        self.token()
            .ok_or_else(|| self.error(format!("the line ends where {what} should follow")))
    }

    /// The next token, if there is one.
    pub(super) fn token(&mut self) -> Option<&'a [u8]> {
        let end = memchr::memchr3(b' ', b'\t', b'\x0c', self.rest).unwrap_or(self.rest.len());
        let (token, rest) = self.rest.split_at(end);
        self.rest = rest.trim_ascii_start();
        (!token.is_empty()).then_some(token)
    }

    /// Whether no token follows.
    pub(super) fn is_over(&self) -> bool {
        self.rest.is_empty()
    }

    /// An error in this line.
    pub(super) fn error(&self, message: impl Into<String>) -> ReadError {
        self.file.error_in_line(self.number, message)
    }
}

/// A token as a coordinate.
pub(super) fn coordinate(
    token: &[u8],
    error: impl FnOnce(String) -> ReadError,
) -> Result<f64, ReadError> {
    let text = std::str::from_utf8(token).unwrap_or_default();
    f64::from_text(text).map_err(|why| {
        let shown = quoted(token);
        error(match why {
            CoordinateError::Fraction => {
                format!("{shown} is a fraction, which is read only where all points are in memory")
            }
            why => format!("{shown} {why}"),
        })
    })
}
