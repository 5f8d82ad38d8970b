//! Files in memory, and where one is wrong.

use std::fmt;

/// A file in memory.
///
/// ```
/// use sweep_cdt::formats::{Input, InputFormat, Source, read};
///
/// let bytes = b"2 2 0 0\n1 0 0\n2 1 0.5\n".to_vec();
/// let source = Source { name: "two.node".to_owned(), bytes };
/// assert!(matches!(read(InputFormat::Node, &source, None), Ok(Input::Doubles(_))));
/// ```
#[derive(Clone, Debug)]
pub struct Source {
    /// What errors call it.
    pub name: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}

impl Source {
    /// An error in this line, counted from 1.
    pub(super) fn error_in_line(&self, line: usize, message: impl Into<String>) -> ReadError {
        ReadError {
            line: Some(line),
            ..ReadError::of_file(&self.name, message)
        }
    }

    /// Line and column of a piece of the contents, both counted from 1.
    pub(super) fn position(&self, piece: &[u8]) -> (usize, usize) {
        let offset = piece.as_ptr().addr() - self.bytes.as_ptr().addr();
        let before = &self.bytes[..offset];
        let line_start = before
            .iter()
            .rposition(|&byte| byte == b'\n')
            .map_or(0, |end| end + 1);
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        (line, offset - line_start + 1)
    }
}

/// Where a file is wrong, and how: `file:line:column: message`.
///
/// ```
/// use sweep_cdt::formats::{InputFormat, Source, read};
///
/// let source = Source { name: "a.node".to_owned(), bytes: b"1\n0 0 zero".to_vec() };
/// let error = read(InputFormat::Node, &source, None).unwrap_err();
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
    /// What is wrong there.
    pub message: String,
    /// Whether the file is a `.poly` that leaves its vertices to the `.node` beside it, which was not
    /// given.
    pub missing_node: bool,
}

impl ReadError {
    /// An error of the whole file: that it cannot be read at all, for instance.
    ///
    /// ```
    /// use sweep_cdt::formats::ReadError;
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
            missing_node: false,
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
pub(super) fn quoted(piece: &[u8]) -> String {
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
