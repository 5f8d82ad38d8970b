//! The text of a file with other pieces in some places: all else stays, byte for byte.

use crate::read::source::Source;

/// A text that is copied from front to back, with changes.
pub(in crate::read) struct Edited<'a> {
    source: &'a Source,
    text: Vec<u8>,
    /// How far it is copied.
    at: usize,
}

impl<'a> Edited<'a> {
    pub(in crate::read) fn new(source: &'a Source) -> Edited<'a> {
        Edited {
            source,
            text: Vec::with_capacity(source.bytes.len()),
            at: 0,
        }
    }

    /// Has other bytes in the place of a piece of the source, which comes behind all before.
    pub(in crate::read) fn replace(&mut self, piece: &[u8], bytes: &[u8]) {
        let begin = self.place(piece);
        self.copy(begin);
        self.text.extend_from_slice(bytes);
        self.at = begin + piece.len();
    }

    /// Adds bytes behind a field of a row, and behind the quote that closes it.
    pub(in crate::read) fn insert_behind(&mut self, field: &[u8], bytes: &[u8]) {
        let end = self.place(field) + field.len();
        let is_quoted = self.source.bytes.get(end) == Some(&b'"');
        self.copy(end + usize::from(is_quoted));
        self.text.extend_from_slice(bytes);
    }

    /// Has other bytes in the place of all between a piece and the next sign of this kind.
    pub(in crate::read) fn replace_up_to(&mut self, piece: &[u8], sign: u8, bytes: &[u8]) {
        let begin = self.place(piece) + piece.len();
        let source = self.source;
        let behind = &source.bytes[begin..];
        let length = memchr::memchr(sign, behind).unwrap_or(0);
        self.replace(&behind[..length], bytes);
    }

    /// The whole text.
    pub(in crate::read) fn into_text(mut self) -> Vec<u8> {
        self.copy(self.source.bytes.len());
        self.text
    }

    fn copy(&mut self, end: usize) {
        self.text
            .extend_from_slice(&self.source.bytes[self.at..end]);
        self.at = end;
    }

    /// Where a piece of the source begins in it.
    fn place(&self, piece: &[u8]) -> usize {
        piece.as_ptr().addr() - self.source.bytes.as_ptr().addr()
    }
}
