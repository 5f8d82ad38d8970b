//! Points as text, a row for each: `.csv`, `.xyz` and `.txt`.
//!
//! ```text
//! id;easting;northing;elev;note     names, which may be missing: then the columns are x, y, z and others
//! 7;3402.5;811.25;102.4;oak
//! ```
//!
//! | column | names, in any case, without units |
//! |---|---|
//! | x and y | the first of these pairs: `x`, `y`; `point_x`, `point_y`; `easting`, `northing`; `longitude`, `latitude` (`lon`, `long`, `lng`, `lat`); `e`, `n` |
//! | z | the one that [`Source::height_property`] names; or the best of the usual names (`names.rs`) |
//! | others | of numbers: columns of the vertices; of anything else: ignored with a remark |
//!
//! The names may also stand in the last comment before the numbers, if that has those of x and y. [`Source::columns`]
//! chooses others, and must where the first of more than three columns counts the rows. A first row of one whole number
//! is how many points follow. The separator is the first one of semicolon, tab, comma and blanks that makes a row of
//! names, or of numbers, out of the first row. (See `rows.rs` for rows and quotes.) A field that is empty, `nan`, `na`,
//! `n/a`, `null`, `none` or `-` is missing, which x and y must not be. Rows may be short, and what they lack is
//! missing; fields beyond the first row must not be numbers.
//!
//! Cost: time in proportion to the text. So is the memory: short rows may leave out no more fields than the file has
//! bytes.

mod raised;
mod rows;

use std::collections::HashMap;

use crate::read::content::{Edges, Field, NO_COMMAS, Syntax, Vertices};
use crate::read::names::{Places, only, places};
use crate::read::remarks::Remarks;
use crate::read::shapes::wkt;
use crate::read::source::{ReadError, ReadErrorKind, Source, quoted};
use crate::read::text::rows::{Rows, Separator, text};
use crate::{Column, CoordinateError, Remark};

pub(super) use raised::{properties, raised};

/// The words for a number that is missing.
const MISSING: [&[u8]; 10] = [
    b"nan", b"na", b"n/a", b"null", b"none", b"-", b"--", b"#n/a", b"\\n", b"nodata",
];

/// Reads points.
pub(super) fn read(source: &Source) -> Result<Edges<'_>, ReadError> {
    let Begin {
        mut rows,
        mut fields,
        line,
        promised,
        header,
        names,
        z,
        mut remarks,
    } = Begin::of(source)?;
    let mut table = Table::new(source, line, header, z);
    if names != Names::FirstRow {
        table.add(line, &fields)?;
    }
    while let Some(line) = rows.next_row(&mut fields)? {
        table.add(line, &fields)?;
    }
    let first_line = table.first_line;
    if names == Names::FirstRow
        && let Some(fields) = table.least_beyond
        && !table.coordinates.is_empty()
    {
        let message = format!(
            "line {first_line} has {} names, and all rows have {fields} fields or more: name the first or the last column, too",
            table.columns.len()
        );
        return Err(ReadError::of_file(&source.name, message));
    }
    let is_numbered = source.columns.is_empty() && table.is_numbered();
    if is_numbered && table.columns.len() == 3 {
        let (places, count) = (vec![1, 2, 3], 3);
        remarks.add(Remark::Columns { places, count });
    } else if is_numbered {
        let message = "the columns have no names, and the first counts the rows, 1, 2, 3 and so on, as names of points \
                       do: put names in the first row, x and y among them";
        return Err(ReadError {
            kind: ReadErrorKind::UnknownColumns,
            ..ReadError::of_file(&source.name, message)
        });
    }
    let points = table.coordinates.len();
    if let Some(promised) = promised.filter(|&promised| promised != points as u64) {
        let what = format!("that there are {promised} points, and {points} follow");
        remarks.add(Remark::Promise { what });
    }
    let vertices = table.vertices(&mut remarks);
    Ok(Edges {
        remarks,
        ..Edges::without_seeds(vertices, Vec::new(), 0)
    })
}

/// The beginning of a file: up to the first row of names or numbers, and what it says of all rows.
struct Begin<'a> {
    /// The rows that follow.
    rows: Rows<'a>,
    /// The first row, and its line.
    fields: Vec<&'a [u8]>,
    line: usize,
    /// How many points there should be, if a row before says that.
    promised: Option<u64>,
    header: Header,
    names: Names,
    /// The column of the height.
    z: Option<usize>,
    remarks: Remarks,
}

/// Where the names of columns stand.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Names {
    FirstRow,
    Comment,
    Nowhere,
}

impl<'a> Begin<'a> {
    fn of(source: &'a Source) -> Result<Begin<'a>, ReadError> {
        let mut rows = Rows::new(source, separator(source)?)?;
        let mut fields = Vec::new();
        let Some(mut line) = rows.next_row(&mut fields)? else {
            return Err(ReadError::of_file(&source.name, "the file is empty"));
        };
        let promised = count(&fields);
        if promised.is_some()
            && let Some(next) = rows.next_row(&mut fields)?
        {
            line = next;
        }
        let mut remarks = Remarks::default();
        let error = |message: String| ReadError {
            kind: match fields.len() < 3 || fields.iter().any(|field| wkt::is_in(field)) {
                true => ReadErrorKind::Content,
                false => ReadErrorKind::UnknownColumns,
            },
            ..source.error_in_line(line, message)
        };
        let comment = rows.comment();
        let (header, names) = match &source.columns[..] {
            [] => match Header::of(&fields).map_err(error)? {
                Some(header) => (header, Names::FirstRow),
                None => Header::not_in(&fields, &comment, &mut remarks).map_err(error)?,
            },
            chosen => Header::chosen(chosen, &fields, &comment)
                .map_err(|message| source.error_in_line(line, message))?,
        };
        let z = match &source.height_property {
            Some(name) => header.asked(name, &mut remarks),
            None => header.z().map_err(error)?,
        };
        Ok(Begin {
            rows,
            fields,
            line,
            promised,
            header,
            names,
            z,
            remarks,
        })
    }
}

/// The number of points that a first row is, as some scanners write it.
fn count(fields: &[&[u8]]) -> Option<u64> {
    match fields {
        [only] => std::str::from_utf8(only).ok()?.parse().ok(),
        _ => None,
    }
}

/// The separator of a file.
fn separator(source: &Source) -> Result<Separator, ReadError> {
    let mut there = None;
    for separator in Separator::ALL {
        let mut fields = Vec::new();
        let mut rows = Rows::new(source, separator)?;
        let mut is_wrong = rows.next_row(&mut fields).is_err();
        if count(&fields).is_some() {
            is_wrong |= rows.next_row(&mut fields).is_err();
        }
        if is_wrong {
            continue;
        }
        let is_header = || !matches!(Header::of(&fields), Ok(None));
        let are_numbers = || fields.len() > 1 && fields[..2].iter().copied().all(is_number);
        if is_header() || are_numbers() {
            return Ok(separator);
        }
        if fields.len() > 1 {
            there.get_or_insert(separator);
        }
    }
    Ok(there.unwrap_or(Separator::Blanks))
}

/// The names of the columns, and what they hold.
struct Header {
    names: Vec<String>,
    x: usize,
    y: usize,
    /// The columns with the best name of a height.
    heights: Vec<usize>,
}

impl Header {
    /// The header that a row is, if it names x and y.
    fn of(fields: &[&[u8]]) -> Result<Option<Header>, String> {
        let names: Vec<String> = fields.iter().map(|name| text(name)).collect();
        let found = places(&names)?;
        Ok(found.map(|Places { x, y, heights }| Header {
            names,
            x,
            y,
            heights,
        }))
    }

    /// The header of a file whose first row is none: the last comment, or the order of the columns.
    fn not_in(
        fields: &[&[u8]],
        comment: &[&[u8]],
        remarks: &mut Remarks,
    ) -> Result<(Header, Names), String> {
        let shown = || {
            let names = fields.iter().take(8).map(|&name| quoted(name));
            names.collect::<Vec<String>>().join(", ")
        };
        if let Some(&shapes) = fields.iter().find(|field| wkt::is_in(field)) {
            return Err(format!(
                "the column {} holds shapes: they are read from a .wkt of that column alone, or from a .geojson, which \
                 `ogr2ogr -f GeoJSON` makes of this file",
                quoted(shapes)
            ));
        }
        let [x, y, ..] = fields else {
            let message = "the first row has one field: x and y must stand in two, with a comma, a semicolon, a tab or \
                           blanks between them";
            return Err(message.to_owned());
        };
        let is_word = |field: &[u8]| !is_missing(field) && !begins_as_number(field);
        let numbers = fields.iter().filter(|field| is_number(field)).count();
        if is_word(x) && is_word(y) && numbers < 2 {
            let shown = shown();
            return Err(format!(
                "of the columns {shown} none are called x and y, or easting and northing, or longitude and latitude: \
                 rename two of them, or put `#` before what is no row"
            ));
        }
        if comment.len() == fields.len()
            && let Ok(Some(header)) = Header::of(comment)
        {
            return Ok((header, Names::Comment));
        }
        if is_word(x) && numbers > 1 {
            let shown = shown();
            return Err(format!(
                "the columns {shown} have no names, and the first is no number: put names in the first row, x and y among them"
            ));
        }
        let header = Header::without_names(fields);
        let count = fields.len();
        if count > 3 {
            let z = header.heights.first();
            let places = [&header.x, &header.y].into_iter().chain(z);
            let places = places.map(|place| place + 1).collect();
            remarks.add(Remark::Columns { places, count });
        }
        Ok((header, Names::Nowhere))
    }

    /// The header where columns are chosen, each by its place or name.
    fn chosen(
        chosen: &[String],
        fields: &[&[u8]],
        comment: &[&[u8]],
    ) -> Result<(Header, Names), String> {
        let named = |row: &[&[u8]], name: &str| {
            let is_it = |field: &&[u8]| text(field) == name;
            let in_any_case = |field: &&[u8]| text(field).to_lowercase() == name.to_lowercase();
            let mut fields = row.iter();
            fields
                .position(is_it)
                .or_else(|| row.iter().position(in_any_case))
        };
        let names = |row: &[&[u8]]| row.iter().map(|name| text(name)).collect::<Vec<String>>();
        let place = |name: &String| {
            let by_place = || {
                let place: usize = name.parse().ok()?;
                (1..=fields.len()).contains(&place).then(|| place - 1)
            };
            let by_name = || named(fields, name).or_else(|| named(comment, name));
            let none = || {
                let row = if is_row(fields) { comment } else { fields };
                let names = row
                    .iter()
                    .take(8)
                    .map(|&name| quoted(name))
                    .collect::<Vec<String>>();
                let names = match names.is_empty() {
                    true => String::new(),
                    false => format!(" of {}", names.join(", ")),
                };
                format!(
                    "there is no column {}: it is a name{names}, or a place from 1 to {}",
                    quoted(name.as_bytes()),
                    fields.len()
                )
            };
            // A number of the first row is no name for a place.
            by_place()
                .or_else(by_name)
                .filter(|&at| at < fields.len())
                .ok_or_else(none)
        };
        let places: Vec<usize> = chosen.iter().map(place).collect::<Result<_, _>>()?;
        let (&[x, y] | &[x, y, _]) = &places[..] else {
            return Err(format!(
                "{} columns are chosen: two are, or three with z",
                places.len()
            ));
        };
        if let Some(at) = (1..places.len()).find(|&at| places[..at].contains(&places[at])) {
            let place = places[at] + 1;
            return Err(format!("column {place} is chosen twice"));
        }
        let is_header = !begins_as_number(fields[x]) && !begins_as_number(fields[y]);
        let (names, place) = match is_header {
            true => (names(fields), Names::FirstRow),
            false if comment.len() == fields.len() => (names(comment), Names::Comment),
            false => (vec![String::new(); fields.len()], Names::Nowhere),
        };
        let heights = places[2..].to_vec();
        Ok((
            Header {
                names,
                x,
                y,
                heights,
            },
            place,
        ))
    }

    /// The column of the height by its name, if there is one.
    fn z(&self) -> Result<Option<usize>, String> {
        match self.heights[..] {
            [] => Ok(None),
            _ => only(&self.heights, "the height", &self.names).map(Some),
        }
    }

    /// The column of the height that is asked for by its name, if there is one beside x and y.
    fn asked(&self, name: &str, remarks: &mut Remarks) -> Option<usize> {
        let is_asked = |&at: &usize| at != self.x && at != self.y && self.names[at] == name;
        let z = (0..self.names.len()).find(is_asked);
        if z.is_none() {
            let name = name.to_owned();
            remarks.add(Remark::HeightProperty { name, count: 0 });
        }
        z
    }

    /// The columns of a file without names, by its first row: x, y, and z if there are three of numbers.
    fn without_names(first: &[&[u8]]) -> Header {
        let is_height = |field: &&&[u8]| is_missing(field) || is_number(field);
        Header {
            names: vec![String::new(); first.len()],
            x: 0,
            y: 1,
            heights: first
                .get(2)
                .filter(is_height)
                .map(|_| 2)
                .into_iter()
                .collect(),
        }
    }
}

fn is_missing(field: &[u8]) -> bool {
    let is_it = |word: &&[u8]| field.eq_ignore_ascii_case(word);
    field.is_empty() || MISSING.iter().any(is_it)
}

/// Whether a field can be a coordinate.
fn is_number(field: &[u8]) -> bool {
    let is_of_fraction = |byte: &u8| byte.is_ascii_digit() || b"/-+".contains(byte);
    match value(field) {
        Err(CoordinateError::Fraction) => field.iter().all(is_of_fraction),
        value => !matches!(value, Err(CoordinateError::NotANumber)),
    }
}

/// Whether a field begins as a number does, perhaps one with a decimal comma.
fn begins_as_number(field: &[u8]) -> bool {
    let unsigned = field.strip_prefix(b"-").unwrap_or(field);
    is_number(field) || unsigned.first().is_some_and(u8::is_ascii_digit)
}

/// Whether there is a number among the fields, so that they are no names.
fn is_row(fields: &[&[u8]]) -> bool {
    fields.iter().any(|field| begins_as_number(field))
}

/// Whether a field is a number, too large a one included, which is then refused where it stands.
fn is_double(field: &[u8]) -> bool {
    matches!(value(field), Ok(_) | Err(CoordinateError::TooLarge))
}

fn value(field: &[u8]) -> Result<f64, CoordinateError> {
    Syntax::Plain.value(field)
}

/// The points that are read, and their columns.
struct Table<'a> {
    source: &'a Source,
    /// The line of the first row.
    first_line: usize,
    header: Header,
    /// The column of the height.
    z: Option<usize>,
    coordinates: Vec<[&'a [u8]; 2]>,
    /// The fields of each column but x and y, as long as they are numbers or missing.
    columns: Vec<Option<Vec<&'a [u8]>>>,
    /// How many fields were left out of short rows.
    left_out: usize,
    /// The fewest fields of a row, if all rows have more than the first one.
    least_beyond: Option<usize>,
}

impl<'a> Table<'a> {
    fn new(source: &'a Source, first_line: usize, header: Header, z: Option<usize>) -> Table<'a> {
        let is_column = |at: usize| at != header.x && at != header.y;
        let columns = (0..header.names.len()).map(|at| is_column(at).then(Vec::new));
        Table {
            source,
            first_line,
            columns: columns.collect(),
            header,
            z,
            coordinates: Vec::new(),
            left_out: 0,
            least_beyond: Some(usize::MAX),
        }
    }

    /// Adds a point.
    fn add(&mut self, line: usize, fields: &[&'a [u8]]) -> Result<(), ReadError> {
        let width = self.columns.len();
        let error = |message: String| Err(self.source.error_in_line(line, message));
        let is_beyond = |field: &&[u8]| is_double(field);
        let has_more = fields.iter().skip(width).any(|field| !field.is_empty());
        let least = self.least_beyond.map(|least| least.min(fields.len()));
        self.least_beyond = least.filter(|_| has_more);
        self.left_out += width.saturating_sub(fields.len());
        if fields.iter().skip(width).any(is_beyond) || self.left_out > self.source.bytes.len() {
            let (fields, first) = (fields.len(), self.first_line);
            return error(format!(
                "the row has {fields} fields, and that of line {first} has {width}"
            ));
        }
        let field = |at: usize| fields.get(at).copied().unwrap_or_default();
        let Header { x, y, .. } = self.header;
        for (name, at) in [("x", x), ("y", y)] {
            if is_missing(field(at)) {
                return error(format!("{name} is missing"));
            }
            if field(at).contains(&b',') || field(at).contains(&b' ') {
                let shown = quoted(field(at));
                return error(format!("{shown} is not a coordinate: {NO_COMMAS}"));
            }
        }
        self.coordinates.push([field(x), field(y)]);
        for (at, column) in self.columns.iter_mut().enumerate() {
            let field = field(at);
            let is_height = self.z == Some(at);
            match column {
                Some(column) if is_missing(field) => column.push(b""),
                Some(column) if is_height || is_double(field) => column.push(field),
                _ => *column = None,
            }
        }
        Ok(())
    }

    /// Whether nothing tells that the first of three columns or more is x, and it counts three rows and more from 1 on.
    fn is_numbered(&self) -> bool {
        let names = &self.header.names;
        let has_numbers = names.len() > 2 && names.iter().all(String::is_empty);
        let mut rows = (1_usize..).zip(&self.coordinates);
        has_numbers
            && self.coordinates.len() > 2
            && rows.all(|(row, [x, _])| *x == row.to_string().as_bytes())
    }

    /// The points with the columns that have any numbers; others are ignored.
    fn vertices(self, remarks: &mut Remarks) -> Vertices<'a> {
        let Table { header, z, .. } = self;
        let mut seen: HashMap<String, usize> = HashMap::new();
        let mut fields: Vec<Field<'a>> = Vec::new();
        for (at, (name, pieces)) in header.names.into_iter().zip(self.columns).enumerate() {
            let count = match name.is_empty() {
                true => &mut 0,
                false => seen.entry(name.clone()).or_default(),
            };
            *count += 1;
            let Some(pieces) = pieces else {
                if at != header.x && at != header.y {
                    let name = match name.is_empty() {
                        true => (at + 1).to_string(),
                        false => name,
                    };
                    remarks.ignore_named(1, ["column", "columns"], name.as_bytes());
                }
                continue;
            };
            // Nothing is lost of a column without any number. Many programs end each row with a separator.
            if pieces.iter().all(|piece| piece.is_empty()) {
                continue;
            }
            let name = match (name.as_str(), *count) {
                _ if z == Some(at) => Column::HEIGHT.to_owned(),
                ("", _) => format!("column{}", at + 1),
                (_, 1) => name,
                (_, count) => format!("{name}_{count}"),
            };
            fields.push(Field {
                name,
                syntax: Syntax::Plain,
                pieces,
            });
        }
        // Formats without names take the first column for heights.
        fields.sort_by_key(|field| field.name != Column::HEIGHT);
        Vertices {
            fields,
            ..Vertices::plain(self.source, self.coordinates, 0)
        }
    }
}
