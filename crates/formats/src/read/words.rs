//! A file read word by word, with the bytes of binary numbers between the words.

use crate::read::source::{ReadError, Source, quoted, split_line};

/// The rest of a file.
#[derive(Clone)]
pub(super) struct Words<'a> {
    source: &'a Source,
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    pub(super) fn new(source: &'a Source) -> Result<Words<'a>, ReadError> {
        let rest = source.text()?;
        Ok(Words { source, rest })
    }

    /// The next word, if there is one.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        self.rest = self.rest.trim_ascii_start();
        let end = self.rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }

    /// The next word, or an error that says `what` is missing.
    pub(super) fn expect(&mut self, what: &str) -> Result<&'a [u8], ReadError> {
        self.word().ok_or_else(|| self.end(what))
    }

    /// The next word as a whole number; `what` it is stands in the message if it is none.
    pub(super) fn index(&mut self, what: &str) -> Result<usize, ReadError> {
        let word = self.expect(what)?;
        let text = std::str::from_utf8(word).ok();
        text.and_then(|text| text.parse().ok())
            .ok_or_else(|| self.error(word, &format!("is not {what}")))
    }

    /// The rest of the line, without spaces around it. A file that ends has empty lines.
    pub(super) fn line(&mut self) -> &'a [u8] {
        let (line, rest) = split_line(self.rest);
        self.rest = rest;
        line.trim_ascii()
    }

    /// As many bytes, if there are so many.
    pub(super) fn bytes(&mut self, count: usize) -> Option<&'a [u8]> {
        let (bytes, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(bytes)
    }

    /// Goes on at this text, if it follows anywhere.
    pub(super) fn skip_to(&mut self, text: &[u8]) -> Option<()> {
        let at = memchr::memmem::find(self.rest, text)?;
        self.rest = &self.rest[at..];
        Some(())
    }

    /// How many bytes are left.
    pub(super) fn len(&self) -> usize {
        self.rest.len()
    }

    /// The fault of a word.
    pub(super) fn error(&self, word: &'a [u8], why: &str) -> ReadError {
        let (line, _) = self.source.position(word);
        let message = format!("{} {why}", quoted(word));
        self.source.error_in_line(line, message)
    }

    /// The error that the file ends too early.
    pub(super) fn end(&self, what: &str) -> ReadError {
        let message = format!("the file ends where {what} should follow");
        ReadError::of_file(&self.source.name, message)
    }
}
