//! Files in memory, and where one is wrong.

use std::{fmt, io};

/// A file in memory.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Source, read};
///
/// let source = Source::new("two.node", b"2 2 0 0\n1 0 0\n2 1 0.5\n");
/// assert!(matches!(read(Format::Node, &source, None), Ok(Input::Doubles(_))));
/// ```
#[derive(Clone, Debug)]
pub struct Source {
    /// The name in errors.
    pub name: String,
    /// The file's contents.
    pub bytes: Vec<u8>,
    /// The limit that was asked for.
    unpacked_limit: Option<u64>,
    /// The name of a property that is a height, if it was named.
    pub(super) height_property: Option<String>,
    /// The columns of x, y and z, if they were chosen.
    pub(super) columns: Vec<String>,
    /// The classes of the points that are read, if they were chosen.
    pub(super) classes: Vec<u8>,
}

/// The bytes that every file may unpack to.
const UNPACKED: u64 = 16 << 20;
/// How often its size a file may unpack to, if that is more. Arrays of meshes unpack to 2 to 10 times their size.
const TIMES: u64 = 32;

impl Source {
    /// A file of this name with these contents.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Source {
        Source {
            name: name.into(),
            bytes: bytes.into(),
            unpacked_limit: None,
            height_property: None,
            columns: Vec::new(),
            classes: Vec::new(),
        }
    }

    /// Names the property of a feature that is the height of its positions, whatever their third coordinates, or the
    /// column of points as text. Other formats have neither. Without a call a number is found by its usual names, `elev`
    /// or `height` for instance, of features for points and lines alone;
    /// [`Remark::HeightProperty`](crate::Remark::HeightProperty) says which.
    #[must_use]
    pub fn height_property(mut self, name: impl Into<String>) -> Source {
        self.height_property = Some(name.into());
        self
    }

    /// Chooses the columns of points as text that are x, y and, if there are three, z: each by its place from 1 on, or by
    /// its name, which is no such number. Other formats have none.
    ///
    /// ```
    /// use sweep_cdt_formats::{Format, Input, Source, read};
    ///
    /// let source = Source::new("a.csv", "GCP1,4.5,7,88.1\nGCP2,5,8,89.4\n").columns(["2", "3", "4"]);
    /// let Input::Doubles(file) = read(Format::Csv, &source, None)? else {
    ///     unreachable!("no fraction in the file")
    /// };
    /// assert_eq!(file.graph.points[0], [4.5, 7.0]);
    /// # Ok::<(), sweep_cdt_formats::ReadError>(())
    /// ```
    #[must_use]
    pub fn columns(mut self, columns: impl IntoIterator<Item = impl Into<String>>) -> Source {
        self.columns = columns.into_iter().map(Into::into).collect();
        self
    }

    /// Chooses the points of a `.las` or `.laz` that are read: those of these classes alone, of which 2 is the ground. They
    /// are numbered as if there were no others. [`read()`](crate::read()) refuses classes of other formats.
    #[must_use]
    pub fn classes(mut self, classes: impl Into<Vec<u8>>) -> Source {
        self.classes = classes.into();
        self
    }

    /// Limits the bytes that what is packed in the file may unpack to, all together. (Only `.vtu`, `.vtp` and `.npz` may
    /// have packed arrays, and a `.laz` packed points, each of which counts 24 bytes.)
    ///
    /// Without a call the limit is 16 MiB, or 32 times the size of the file where that is more. A file that needs more
    /// is refused before memory is taken for it ([`ReadErrorKind::UnpackedLimit`]). Beside what is unpacked, a reader
    /// takes memory in proportion to it, as for a text: three to thirty times as much, the most for numbers of a byte.
    #[must_use]
    pub fn unpacked_limit(mut self, bytes: u64) -> Source {
        self.unpacked_limit = Some(bytes);
        self
    }

    /// How many bytes the file may unpack to.
    pub(super) fn most_unpacked(&self) -> u64 {
        let by_size = (self.bytes.len() as u64).saturating_mul(TIMES);
        self.unpacked_limit.unwrap_or(by_size.max(UNPACKED))
    }

    /// The contents after the byte order mark, if they begin with one.
    ///
    /// ```
    /// use sweep_cdt_formats::Source;
    ///
    /// let file = |bytes: &[u8]| Source::new("a.node", bytes);
    /// assert_eq!(file(b"\xef\xbb\xbf1 2\n").text()?, b"1 2\n");
    /// let error = file(b"\xff\xfe1\0 \x002\0").text().unwrap_err();
    /// assert_eq!(error.to_string(), "a.node: the text is UTF-16; save it as UTF-8");
    /// # Ok::<(), sweep_cdt_formats::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// The text is UTF-16, which is told by its byte order mark, or by zeros as every other byte.
    pub fn text(&self) -> Result<&[u8], ReadError> {
        let is_wide = match *self.bytes.as_slice() {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
            [0, a, 0, b, ..] | [a, 0, b, 0, ..] => a != 0 && b != 0,
            _ => false,
        };
        if is_wide {
            let message = "the text is UTF-16; save it as UTF-8";
            return Err(ReadError::of_file(&self.name, message));
        }
        Ok(self.bytes.strip_prefix(MARK).unwrap_or(&self.bytes))
    }

    /// An error in this line, counted from 1.
    pub(super) fn error_in_line(&self, line: usize, message: impl Into<String>) -> ReadError {
        ReadError {
            line: Some(line),
            ..ReadError::of_file(&self.name, message)
        }
    }

    /// Line and column of a piece of the contents, both counted from 1.
    pub(super) fn position(&self, piece: &[u8]) -> (usize, usize) {
        let text = self.bytes.strip_prefix(MARK).unwrap_or(&self.bytes);
        let mut rest = text;
        let mut offset = piece.as_ptr().addr() - text.as_ptr().addr();
        let mut line = 1;
        loop {
            let (first, others) = split_line(rest);
            if offset < first.len() || others.is_empty() {
                return (line, offset + 1);
            }
            (offset, rest, line) = (offset - first.len(), others, line + 1);
        }
    }
}

/// The bytes that some editors write before text, to say that it is UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// The first line with its end, which is a line feed, a carriage return or both, and all after it.
pub(super) fn split_line(text: &[u8]) -> (&[u8], &[u8]) {
    let length = match memchr::memchr2(b'\n', b'\r', text) {
        Some(end) if text[end..].starts_with(b"\r\n") => end + 2,
        Some(end) => end + 1,
        None => text.len(),
    };
    text.split_at(length)
}

/// Where a file is wrong, and how: `file:line:column: message`.
///
/// ```
/// use sweep_cdt_formats::{Format, Source, read};
///
/// let source = Source::new("a.node", b"1\n0 0 zero");
/// let error = read(Format::Node, &source, None).unwrap_err();
/// assert_eq!(error.to_string(), "a.node:2: `zero` is not a coordinate");
/// assert_eq!(error.line, Some(2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadError {
    /// The name of the file.
    pub file: String,
    /// The line, counted from 1, if one is to blame.
    pub line: Option<usize>,
    /// The column, counted from 1, where known.
    pub column: Option<usize>,
    /// The fault found there.
    pub message: String,
    /// What a caller may do about it.
    pub kind: ReadErrorKind,
}

/// What a caller may do about a [`ReadError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// Nothing: the contents are wrong, or the file cannot be read.
    Content,
    /// Give the `.node` beside the file, a `.poly` that leaves its vertices to it.
    MissingNode,
    /// Say which columns of a table are x and y ([`Source::columns`]).
    UnknownColumns,
    /// Raise the limit of unpacked data ([`Source::unpacked_limit`]), if the file can be trusted.
    UnpackedLimit {
        /// The limit, in bytes.
        limit: u64,
    },
}

impl ReadError {
    /// An error of the whole file: that it cannot be read at all, for instance.
    ///
    /// ```
    /// use sweep_cdt_formats::ReadError;
    ///
    /// let error = ReadError::of_file("a.poly", "permission denied");
    /// assert_eq!(error.to_string(), "a.poly: permission denied");
    /// ```
    pub fn of_file(file: impl Into<String>, message: impl Into<String>) -> ReadError {
        ReadError {
            file: file.into(),
            line: None,
            column: None,
            message: message.into(),
            kind: ReadErrorKind::Content,
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.file)?;
        for number in [self.line, self.column].into_iter().flatten() {
            write!(f, "{number}:")?;
        }
        write!(f, " {}", self.message)
    }
}

impl std::error::Error for ReadError {}

/// A piece of a file as messages show it: on one line and not too long.
///
/// ```
/// assert_eq!(sweep_cdt_formats::quoted(b"1\t2"), "`1\\t2`");
/// ```
#[must_use]
pub fn quoted(piece: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = String::from_utf8_lossy(&piece[..piece.len().min(4 * LONGEST)]);
    let short: String = text
        .chars()
        .take(LONGEST)
        .flat_map(char::escape_debug)
        .collect();
    let dots = if text.chars().count() > LONGEST {
        "..."
    } else {
        ""
    };
    format!("`{short}{dots}`")
}

/// The system's message without its error number.
#[must_use]
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or(&text);
    text.to_lowercase()
}

/// The message that an edge names a vertex which is not there, and what numbers there are.
pub(super) fn no_vertex(number: usize, first: usize, count: usize) -> String {
    match count {
        0 => format!("vertex {number} does not exist: there are no vertices"),
        _ => format!(
            "vertex {number} does not exist: the vertices are numbered from {first} to {}",
            first + count - 1
        ),
    }
}
