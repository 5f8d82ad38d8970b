//! Text as rows of fields, which a comma, a semicolon, a tab or blanks separate, as in `.csv`.
//!
//! Lines that begin with `#`, `//`, `%`, `!` or, where it separates nothing, `;` are comments, and rows without anything in
//! their fields do not count. A field may stand in quotes: then separators and ends of lines in it mean nothing, and a doubled quote is one. Blanks around a field do
//! not belong to it. Where blanks separate, many are as one, and `#` ends the row.
//!
//! Each field is a piece of the source, found in one pass over the text.

use crate::read::source::{ReadError, Source, quoted, split_line};

/// The sign between two fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Semicolon,
    Tab,
    Comma,
    Blanks,
}

impl Separator {
    /// All of them, those first that stand least in other fields.
    pub(super) const ALL: [Separator; 4] = [
        Separator::Semicolon,
        Separator::Tab,
        Separator::Comma,
        Separator::Blanks,
    ];

    /// Whether this byte separates two fields.
    pub(super) fn is(self, byte: u8) -> bool {
        match self {
            Separator::Semicolon => byte == b';',
            Separator::Tab => byte == b'\t',
            Separator::Comma => byte == b',',
            Separator::Blanks => is_blank(byte),
        }
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0c')
}

fn is_end_of_line(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// The rows of a file, one after the other.
pub(super) struct Rows<'a> {
    source: &'a Source,
    separator: Separator,
    rest: &'a [u8],
    /// How many lines are read.
    lines: usize,
    /// The last comment, without its sign.
    comment: &'a [u8],
}

impl<'a> Rows<'a> {
    /// All rows of a file. A first line `sep=;` is no row, as Excel has it.
    pub(super) fn new(source: &'a Source, separator: Separator) -> Result<Rows<'a>, ReadError> {
        let text = source.text()?;
        let (first, others) = split_line(text);
        let is_of_excel = first.starts_with(b"sep=") && first.trim_ascii_end().len() <= 5;
        let text = if is_of_excel { others } else { text };
        Ok(Rows {
            source,
            separator,
            rest: text,
            lines: usize::from(is_of_excel),
            comment: b"",
        })
    }

    /// What separates the fields.
    pub(super) fn separator(&self) -> Separator {
        self.separator
    }

    /// Puts the fields of the next row in the place of the others; returns its line, or `None` at the end of the file.
    pub(super) fn next_row(
        &mut self,
        fields: &mut Vec<&'a [u8]>,
    ) -> Result<Option<usize>, ReadError> {
        while !self.rest.is_empty() {
            fields.clear();
            self.lines += 1;
            let line = self.lines;
            let (text, rest) = split_line(self.rest);
            let text = text.trim_ascii();
            if let Some(comment) = self.comment_in(text) {
                (self.comment, self.rest) = (comment, rest);
                continue;
            }
            while self.take_field(fields)? {}
            if fields.iter().any(|field| !field.is_empty()) {
                return Ok(Some(line));
            }
        }
        Ok(None)
    }

    /// What a line says behind the sign of a comment, if it begins with one.
    fn comment_in(&self, line: &'a [u8]) -> Option<&'a [u8]> {
        let mut signs = [&b"#"[..], b"//", b"%", b"!", b";"].into_iter();
        let comment = signs.find_map(|sign| line.strip_prefix(sign))?;
        let separates = self.separator == Separator::Semicolon && line.starts_with(b";");
        (!separates).then_some(comment)
    }

    /// The fields of the last comment before the row that was read last.
    pub(super) fn comment(&self) -> Vec<&'a [u8]> {
        let mut rows = Rows {
            rest: self.comment,
            ..*self
        };
        let mut fields = Vec::new();
        // A comment with a quote that is not closed is one, and no row.
        if rows.next_row(&mut fields).is_err() {
            fields.clear();
        }
        fields
    }

    /// Takes the next field of the line; returns whether another one follows.
    fn take_field(&mut self, fields: &mut Vec<&'a [u8]>) -> Result<bool, ReadError> {
        self.skip_blanks();
        let is_by_blanks = self.separator == Separator::Blanks;
        let is_over = |rest: &[u8]| {
            let first = rest.first().copied();
            first.is_none_or(|byte| is_end_of_line(byte) || is_by_blanks && byte == b'#')
        };
        if is_by_blanks && is_over(self.rest) {
            self.rest = split_line(self.rest).1;
            return Ok(false);
        }
        let field = match self.rest.strip_prefix(b"\"") {
            Some(rest) => self.take_quoted(rest)?,
            None => {
                let ends = |&byte: &u8| self.separator.is(byte) || is_end_of_line(byte);
                let end = self.rest.iter().position(ends);
                let (field, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
                self.rest = rest;
                field.trim_ascii()
            }
        };
        fields.push(field);
        match self.rest.first() {
            Some(&byte) if self.separator.is(byte) => {
                self.rest = &self.rest[1..];
                Ok(true)
            }
            _ => {
                self.rest = split_line(self.rest).1;
                Ok(false)
            }
        }
    }

    /// Takes a field whose quote is open, up to the sign after it.
    fn take_quoted(&mut self, text: &'a [u8]) -> Result<&'a [u8], ReadError> {
        let mut from = 0;
        let end = loop {
            let Some(at) = memchr::memchr(b'"', &text[from..]) else {
                return Err(self.error("a quote is opened and not closed"));
            };
            let at = from + at;
            if text.get(at + 1) != Some(&b'"') {
                break at;
            }
            from = at + 2;
        };
        let field = &text[..end];
        self.rest = &text[end + 1..];
        if self.separator != Separator::Blanks {
            self.skip_blanks();
        }
        if let Some(&byte) = self.rest.first()
            && !is_end_of_line(byte)
            && !self.separator.is(byte)
        {
            let behind = quoted(split_line(self.rest).0.trim_ascii());
            return Err(self.error(format!("{behind} follows a quote that is closed")));
        }
        let mut inside = field;
        while let Some(at) = memchr::memchr2(b'\n', b'\r', inside) {
            inside = split_line(&inside[at..]).1;
            self.lines += 1;
        }
        Ok(field)
    }

    /// Goes on behind blanks that do not separate fields, or are many that do.
    fn skip_blanks(&mut self) {
        let is_tab = self.separator == Separator::Tab;
        let is_skipped = |&byte: &u8| is_blank(byte) && !(is_tab && byte == b'\t');
        let end = self.rest.iter().position(|byte| !is_skipped(byte));
        self.rest = &self.rest[end.unwrap_or(self.rest.len())..];
    }

    /// The fault of the line that is read.
    fn error(&self, message: impl Into<String>) -> ReadError {
        self.source.error_in_line(self.lines, message)
    }
}

/// The text of a field, with single quotes for doubled ones. One that is no UTF-8 is Latin-1, as old programs write.
pub(super) fn text(field: &[u8]) -> String {
    let text = match std::str::from_utf8(field) {
        Ok(text) => text.to_owned(),
        Err(_) => field.iter().copied().map(char::from).collect(),
    };
    text.replace("\"\"", "\"")
}
