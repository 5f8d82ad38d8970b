//! Text as lines of tokens, as in Triangle's files: `#` begins a comment, blank lines do not count. A line
//! ends with a line feed, a carriage return or both.

use crate::formats::read::source::{ReadError, Source, quoted, split_line};

/// The lines of a file that hold anything, one after the other.
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
            let comment = line.iter().position(|&byte| byte == b'#');
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

    /// `count` as a size to reserve: no more lines than the rest of the file may hold.
    pub(super) fn capacity(&self, count: usize) -> usize {
        const SHORTEST: usize = "0 0 0\n".len();
        count.min(self.rest.len() / SHORTEST + 1)
    }
}

/// One line, read from the left.
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

    /// The next token as a whole number; `what` it is stands in the message if it is none.
    pub(super) fn index(&mut self, what: &str) -> Result<usize, ReadError> {
        let token = self.expect_token(what)?;
        let text = std::str::from_utf8(token).ok();
        text.and_then(|text| text.parse().ok())
            .ok_or_else(|| self.error(format!("{} is not {what}", quoted(token))))
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
