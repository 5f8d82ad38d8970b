//! Points as text, `.csv`, `.xyz` and `.txt`, read in pieces.
//!
//! The first row of such a file says what separates the fields, which columns are x and y, and how many there are. So
//! each piece is read as a file of its own that begins as the whole one does, up to its first row: by the reader of whole
//! files, and on all cores. A piece may be wrong because it ends within a quoted field. So a piece that is refused is read
//! once more up to where quotes are closed, and with what follows it, and an error counts only if that does not help.

use std::ops::Range;

use sweep_cdt::threads::on_all_cores;
use sweep_cdt_formats::{
    Column, Format, GraphFile, Input as Whole, ReadError, Remark, Source, quoted, read,
};

use crate::external::input::file::InputFile;
use crate::external::input::{Choice, Input, MOST_COLUMNS};

/// The bytes of a piece, and of the pieces that are read at once.
const PIECE: usize = 1 << 17;
const BLOCK: usize = 8 * PIECE;
/// The most that a row, or what stands before the first one, may have.
const LONGEST: usize = 2 * BLOCK;
/// The most lines of a row of names, some of which may stand in quotes.
const MOST_LINES: usize = 16;

/// Points as text.
#[derive(Debug)]
pub(super) struct Text {
    file: InputFile,
    begin: Begin,
    /// The points of the begin, until they are taken.
    first: Points,
    /// What is read of the file behind the points that were taken, and how many lines come before that.
    bytes: Vec<u8>,
    lines: usize,
    /// As far as the first piece shows.
    left_out: Vec<Remark>,
    has_heights: bool,
    /// The heights of the points that came last, if they are asked for, and their other columns.
    heights: Option<Vec<f64>>,
    columns: Vec<Column>,
    /// How many points have come since they were asked for.
    come: usize,
    /// The columns that have text in some piece, as remarks name them.
    words: Vec<String>,
}

/// Points, the height of each if heights are asked for, and their other columns.
#[derive(Debug, Default)]
struct Points {
    places: Vec<[f64; 2]>,
    heights: Vec<f64>,
    columns: Vec<Column>,
    /// The columns that have text, as remarks name them.
    words: Vec<String>,
}

/// How a file begins, up to the first row and with it.
#[derive(Debug)]
struct Begin {
    name: String,
    /// The columns that were chosen.
    columns: Vec<String>,
    text: Vec<u8>,
    lines: usize,
    /// How many points that is: none, if the row holds names.
    points: usize,
    /// Whether heights are asked for, and other columns.
    heights: bool,
    others: bool,
}

impl Text {
    pub(super) fn new(mut file: InputFile, choice: &Choice) -> Result<Text, ReadError> {
        let mut bytes = Vec::new();
        let mut length = loop {
            file.read(PIECE, &mut bytes)?;
            if let Some(length) = first_row(&bytes, file.left() == 0) {
                break length;
            }
            if bytes.len() > LONGEST {
                return Err(file.error("the first row does not end: is this a text?"));
            }
        };
        let mut begin = Begin {
            name: file.name.clone(),
            columns: choice.columns.clone(),
            text: bytes[..length].to_vec(),
            lines: 0,
            points: 0,
            heights: choice.heights,
            others: choice.others,
        };
        let mut first = begin.points_with(&[]);
        for _ in 1..MOST_LINES {
            if first.is_ok() {
                break;
            }
            // The row may go on behind the end of a line.
            length = line_end(&bytes, length, true).unwrap_or(bytes.len());
            begin.text = bytes[..length].to_vec();
            first = begin.points_with(&[]).or(first);
        }
        let first = first?;
        bytes.drain(..length);
        begin.points = first.places.len();
        begin.lines = line_ends(&begin.text);
        let piece = pieces(&bytes, file.left() == 0).into_iter().next();
        // A piece that is wrong is refused where it is taken, or ends within quotes.
        let piece = &bytes[piece.unwrap_or(0..0)];
        let shown = begin.file_with(piece);
        let shown = shown.or_else(|_| begin.file_with(&piece[..end_outside_quotes(piece)]));
        let (mut left_out, mut has_heights) = (Vec::new(), false);
        if let Ok(shown) = shown {
            has_heights = shown.heights().is_some();
            let columns = shown.columns.iter();
            let is_read = |column: &&Column| match &column.name[..] {
                Column::HEIGHT => choice.heights,
                _ => choice.others,
            };
            let columns = columns.filter(|column| !is_read(column));
            left_out.extend(columns.map(|column| {
                let what = named(&column.name);
                Remark::Ignored { count: 1, what }
            }));
            // A piece has fewer points than the file.
            let is_of_all = |remark: &Remark| matches!(remark, Remark::Promise { .. });
            let others = shown.remarks.into_iter();
            left_out.extend(others.filter(|remark| !is_of_all(remark)));
        }
        Ok(Text {
            file,
            left_out,
            has_heights,
            heights: (choice.heights && has_heights).then(Vec::new),
            columns: Vec::new(),
            come: 0,
            words: Vec::new(),
            lines: begin.lines,
            begin,
            first,
            bytes,
        })
    }

    /// Appends the points of the pieces that are in memory, up to the first that is refused, and goes on behind them.
    fn take_pieces(&mut self, points: &mut Vec<[f64; 2]>) {
        let pieces = pieces(&self.bytes, self.file.left() == 0);
        let of_piece = |piece: Range<usize>| {
            let end = piece.end;
            (end, self.begin.points_with(&self.bytes[piece]))
        };
        let mut end = 0;
        for (piece_end, found) in on_all_cores(pieces, of_piece) {
            let Ok(found) = found else { break };
            self.add(found, points);
            end = piece_end;
        }
        self.pass(end);
    }

    /// Appends the points of as long a piece as is not refused.
    fn take_longer(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        loop {
            let is_all = self.file.left() == 0;
            let is_long = self.bytes.len() > LONGEST;
            let mut end = match pieces(&self.bytes, is_all).last() {
                Some(last) => last.end,
                None => 0,
            };
            let mut found = self.begin.points_with(&self.bytes[..end]);
            if found.is_err() && !is_all {
                let outside = end_outside_quotes(&self.bytes[..end]);
                let sooner = self.begin.points_with(&self.bytes[..outside]);
                if outside > 0 && sooner.is_ok() {
                    (end, found) = (outside, sooner);
                }
            }
            match found {
                Ok(_) if end == 0 && is_long => {
                    let message = "the line does not end: is this a text?";
                    return Err(self.file.error_in_line(self.lines + 1, message));
                }
                Ok(found) if end > 0 => {
                    self.add(found, points);
                    self.pass(end);
                    return Ok(());
                }
                Err(mut error) if is_all || is_long => {
                    let behind = |line: usize| match line.checked_sub(self.begin.lines) {
                        Some(line) => self.lines + line,
                        None => line,
                    };
                    error.line = error.line.map(behind);
                    return Err(error);
                }
                _ => self
                    .file
                    .read(self.bytes.len().max(PIECE), &mut self.bytes)?,
            }
        }
    }

    /// Adds points, their heights if heights are asked for, and their other columns. A column that is not there has no
    /// numbers in this piece; one with text in any piece is none.
    fn add(&mut self, found: Points, points: &mut Vec<[f64; 2]>) {
        let count = found.places.len();
        if let Some(heights) = &mut self.heights {
            heights.extend(&found.heights);
            heights.resize(heights.len() + count - found.heights.len(), f64::NAN);
        }
        points.extend(found.places);
        let before = self.come;
        self.come += count;
        for what in found.words {
            if !self.words.contains(&what) {
                let remark = Remark::Ignored {
                    count: 1,
                    what: what.clone(),
                };
                let is_new = self.begin.others && !self.left_out.contains(&remark);
                self.left_out.extend(is_new.then_some(remark));
                self.words.push(what);
            }
        }
        for column in found.columns {
            let own = match self
                .columns
                .iter_mut()
                .position(|own| own.name == column.name)
            {
                Some(place) => &mut self.columns[place],
                None => {
                    let name = column.name;
                    let values = vec![f64::NAN; before];
                    self.columns.push(Column { name, values });
                    self.columns.last_mut().expect("it was added")
                }
            };
            own.values.extend(column.values);
        }
        // Of many columns of text some have no names: one that is not there may be among them.
        let is_vague =
            |what: &String| what.ends_with("of another kind") || what.ends_with("of other kinds");
        if self.words.iter().any(is_vague) {
            let are_not_there = |column: &&Column| {
                let missing = column.values.iter().take_while(|value| value.is_nan());
                column.values.len() < before + count || before > 0 && missing.count() >= before
            };
            let names = self.columns.iter().filter(are_not_there);
            self.words.extend(names.map(|column| named(&column.name)));
        }
        let words = &self.words;
        self.columns.retain_mut(|column| {
            column.values.resize(before + count, f64::NAN);
            !words.contains(&named(&column.name))
        });
    }

    /// Goes on behind so many bytes.
    fn pass(&mut self, length: usize) {
        self.lines += line_ends(&self.bytes[..length]);
        self.bytes.drain(..length);
    }
}

impl Begin {
    /// The points of a piece, as if it followed the begin.
    fn points_with(&self, piece: &[u8]) -> Result<Points, ReadError> {
        let file = self.file_with(piece)?;
        let (mut heights, mut columns) = (Vec::new(), Vec::new());
        for mut column in file.columns {
            column.values.drain(..self.points);
            match &column.name[..] {
                Column::HEIGHT if self.heights => heights = column.values,
                Column::HEIGHT => {}
                _ if self.others && columns.len() < MOST_COLUMNS => columns.push(column),
                _ => {}
            }
        }
        let is_text = |remark| match remark {
            Remark::Ignored { what, .. } if self.others => Some(what),
            _ => None,
        };
        let words = file.remarks.into_iter().filter_map(is_text).collect();
        let mut places = file.graph.points;
        places.drain(..self.points);
        Ok(Points {
            places,
            heights,
            columns,
            words,
        })
    }

    /// A piece as a file, as if it followed the begin.
    fn file_with(&self, piece: &[u8]) -> Result<GraphFile<f64>, ReadError> {
        let source = Source::new(&self.name, [&self.text, piece].concat());
        let source = source.columns(&self.columns);
        match read(Format::Csv, &source, None)? {
            Whole::Doubles(file) => Ok(file),
            Whole::Rationals(_) => Err(ReadError::of_file(
                &self.name,
                "there are fractions, which are read only where all points are in memory",
            )),
        }
    }
}

impl Input for Text {
    fn name(&self) -> &str {
        &self.file.name
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let before = points.len();
        if let Some(heights) = &mut self.heights {
            heights.clear();
        }
        for column in &mut self.columns {
            column.values.clear();
        }
        self.come = 0;
        let first = std::mem::take(&mut self.first);
        self.add(first, points);
        while points.len() == before {
            let room = BLOCK.saturating_sub(self.bytes.len());
            self.file.read(room, &mut self.bytes)?;
            if self.bytes.is_empty() {
                return self.file.check();
            }
            let left = self.bytes.len();
            self.take_pieces(points);
            if self.bytes.len() == left {
                self.take_longer(points)?;
            }
        }
        Ok(())
    }

    fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    fn columns(&self) -> &[Column] {
        &self.columns
    }

    fn has_edges(&self) -> bool {
        false
    }

    fn remarks(&self) -> Vec<Remark> {
        self.left_out.clone()
    }

    fn has_heights(&self) -> bool {
        self.has_heights
    }

    fn progress(&self) -> (u64, u64) {
        (self.file.at, self.file.length)
    }
}

/// A column as remarks name it.
fn named(name: &str) -> String {
    format!("column {}", quoted(name.as_bytes()))
}

/// Where the line ends that begins here; `None` if it goes on behind the bytes.
fn line_end(bytes: &[u8], from: usize, is_all: bool) -> Option<usize> {
    let end = from + memchr::memchr2(b'\n', b'\r', &bytes[from..])?;
    match (bytes[end], bytes.get(end + 1)) {
        (b'\r', Some(b'\n')) => Some(end + 2),
        // A line feed may follow.
        (b'\r', None) if !is_all => None,
        _ => Some(end + 1),
    }
}

/// How many lines end.
fn line_ends(bytes: &[u8]) -> usize {
    let ends = memchr::memchr2_iter(b'\n', b'\r', bytes);
    ends.filter(|&end| bytes[end] == b'\n' || bytes.get(end + 1) != Some(&b'\n'))
        .count()
}

/// Where the first line ends that may be a row: no comment, and not blanks and separators alone; `None` if that is not
/// known yet.
fn first_row(bytes: &[u8], is_all: bool) -> Option<usize> {
    let mut from = 0;
    while from < bytes.len() {
        let end = match line_end(bytes, from, is_all) {
            Some(end) => end,
            None if is_all => bytes.len(),
            None => return None,
        };
        let line = bytes[from..end].trim_ascii();
        let marked = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line);
        let is_comment = marked.starts_with(b"#") || marked.starts_with(b"//");
        let is_of_excel = line.len() <= 8 && memchr::memmem::find(line, b"sep=").is_some();
        let is_empty = line.iter().all(|byte| b" \t\x0c,;\"".contains(byte));
        if !(is_comment || is_of_excel || is_empty) {
            return Some(end);
        }
        from = end;
    }
    is_all.then_some(bytes.len())
}

/// Where the last line ends before which quotes are closed, as far as their number tells.
fn end_outside_quotes(bytes: &[u8]) -> usize {
    let (mut is_open, mut end) = (false, 0);
    for at in memchr::memchr3_iter(b'"', b'\n', b'\r', bytes) {
        match bytes[at] {
            b'"' => is_open = !is_open,
            _ if !is_open => end = at + 1,
            _ => {}
        }
    }
    end
}

/// Pieces of whole lines; the last line is one only if it is the last of the file.
fn pieces(bytes: &[u8], is_all: bool) -> Vec<Range<usize>> {
    // A carriage return ends a line where no line feeds do.
    let has_feeds = memchr::memchr(b'\n', bytes).is_some();
    let end_from = |from: usize| {
        let rest = bytes.get(from..)?;
        let end = match has_feeds {
            true => memchr::memchr(b'\n', rest)?,
            false => memchr::memchr(b'\r', rest)?,
        };
        Some(from + end + 1)
    };
    let mut pieces = Vec::new();
    let mut begin = 0;
    while let Some(end) = end_from(begin + PIECE) {
        pieces.push(begin..end);
        begin = end;
    }
    let rest = &bytes[begin..];
    let last = match has_feeds {
        _ if is_all => Some(rest.len()),
        true => memchr::memrchr(b'\n', rest).map(|end| end + 1),
        // A line feed may follow the last one.
        false => memchr::memrchr(b'\r', &rest[..rest.len().saturating_sub(1)]).map(|end| end + 1),
    };
    if let Some(length) = last
        && length > 0
    {
        pieces.push(begin..begin + length);
    }
    pieces
}
