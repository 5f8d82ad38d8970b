//! The arrays of a `.vtk`: numbers as words, or as bytes in a binary file.

use crate::read::binary::{Kind, Number};
use crate::read::content::Syntax;
use crate::read::source::ReadError;
use crate::read::words::Words;

/// The rest of a file, and how its numbers stand in it.
pub(super) struct Arrays<'a> {
    pub(super) words: Words<'a>,
    pub(super) is_binary: bool,
    /// Whether cells are listed by offsets, as from version 5 on.
    pub(super) has_offsets: bool,
}

impl<'a> Arrays<'a> {
    /// Reads over lines up to an empty one.
    pub(super) fn skip_metadata(&mut self) {
        self.words.line();
        while !self.words.line().is_empty() {}
    }

    /// Reads the corners of each cell.
    pub(super) fn read_cells(&mut self) -> Result<Vec<Vec<usize>>, ReadError> {
        const WHAT: &str = "a number of cells";
        let (count, size) = (
            self.words.index(WHAT)?,
            self.words.index("a number of numbers")?,
        );
        if self.has_offsets {
            let ends = self.read_indices(b"OFFSETS", count)?;
            let corners = self.read_indices(b"CONNECTIVITY", size)?;
            let cells = ends
                .windows(2)
                .map(|ends| corners.get(ends[0]..ends[1]).map(<[_]>::to_vec));
            return cells
                .collect::<Option<_>>()
                .ok_or_else(|| self.words.end("corners of all cells"));
        }
        let numbers = self.indices(Kind::I32, size)?;
        let mut rest = numbers.as_slice();
        let mut cells = Vec::new();
        for _ in 0..count {
            let cell = rest
                .split_first()
                .and_then(|(&corners, others)| others.split_at_checked(corners));
            let Some((cell, others)) = cell else {
                return Err(self.words.end("corners of all cells"));
            };
            cells.push(cell.to_vec());
            rest = others;
        }
        Ok(cells)
    }

    /// Reads an array of this name that is a part of the cells.
    fn read_indices(&mut self, name: &[u8], count: usize) -> Result<Vec<usize>, ReadError> {
        let word = self.words.expect("`OFFSETS`")?;
        if word != name {
            return Err(self
                .words
                .error(word, "is not `OFFSETS` or `CONNECTIVITY`, in this order"));
        }
        let kind = self.read_kind()?;
        self.indices(kind, count)
    }

    pub(super) fn indices(&mut self, kind: Kind, count: usize) -> Result<Vec<usize>, ReadError> {
        const WHAT: &str = "a whole number";
        let pieces = self.numbers(kind, Some(count), WHAT)?;
        let syntax = self.syntax(kind);
        let index = |piece| {
            let error = || match syntax {
                Syntax::Binary(_) => self.words.end(WHAT),
                _ => self.words.error(piece, "is not a whole number"),
            };
            syntax.index(piece).ok_or_else(error)
        };
        pieces.into_iter().map(index).collect()
    }

    /// The next numbers, as pieces of the file.
    pub(super) fn numbers(
        &mut self,
        kind: Kind,
        count: Option<usize>,
        what: &str,
    ) -> Result<Vec<&'a [u8]>, ReadError> {
        // Each takes more than a byte.
        let count = count.filter(|&count| count <= self.words.len());
        let count = count.ok_or_else(|| self.words.end(what))?;
        if !self.is_binary {
            return (0..count).map(|_| self.words.expect(what)).collect();
        }
        // The bytes begin after the line.
        self.words.line();
        let bytes = self.words.bytes(count.saturating_mul(kind.size()));
        let bytes = bytes.ok_or_else(|| self.words.end(what))?;
        Ok(bytes.chunks_exact(kind.size()).collect())
    }

    pub(super) fn syntax(&self, kind: Kind) -> Syntax {
        match self.is_binary {
            false => Syntax::Plain,
            true => Syntax::Binary(Number {
                kind,
                big_endian: true,
            }),
        }
    }

    pub(super) fn read_kind(&mut self) -> Result<Kind, ReadError> {
        let word = self.words.expect("a type")?;
        match word {
            b"char" => Ok(Kind::I8),
            b"unsigned_char" => Ok(Kind::U8),
            b"short" => Ok(Kind::I16),
            b"unsigned_short" => Ok(Kind::U16),
            b"int" | b"vtkIdType" | b"vtktypeint32" => Ok(Kind::I32),
            b"unsigned_int" => Ok(Kind::U32),
            b"long" | b"unsigned_long" | b"vtktypeint64" => Ok(Kind::I64),
            b"float" => Ok(Kind::F32),
            b"double" => Ok(Kind::F64),
            _ => Err(self.words.error(word, "is not a type that is read")),
        }
    }
}
