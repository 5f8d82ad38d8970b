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

use crate::read::content::{Edges, Field, Syntax, Vertices};
use crate::read::names::{Places, only, places};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, ReadErrorKind, Source, quoted};
use crate::read::text::rows::{Rows, Separator, text};
use crate::{Column, CoordinateError, Remark};

pub(super) use raised::raised;

/// The words for a number that is missing.
const MISSING: [&[u8]; 6] = [b"nan", b"na", b"n/a", b"null", b"none", b"-"];

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
    if source.columns.is_empty() && table.is_numbered() {
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
            kind: match fields.len() < 2 || fields.iter().any(|name| holds_shapes(name)) {
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
            chosen => Header::chosen(chosen, &fields, &comment).map_err(error)?,
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
        if fields.len() < 2 {
            let message = "the first row has one field: x and y must stand in two, with a comma, a semicolon, a tab or \
                           blanks between them";
            return Err(message.to_owned());
        }
        if let Some(&shapes) = fields.iter().find(|name| holds_shapes(name)) {
            return Err(format!(
                "the column {} holds shapes: they are read from a .wkt of that column alone, or from a .geojson, which \
                 `ogr2ogr -f GeoJSON` makes of this file",
                quoted(shapes)
            ));
        }
        if !fields.iter().any(|field| begins_as_number(field)) {
            let shown = shown();
            return Err(format!(
                "of the columns {shown} none are called x and y, or easting and northing, or longitude and latitude: \
                 rename two of them"
            ));
        }
        if comment.len() == fields.len()
            && let Ok(Some(header)) = Header::of(comment)
        {
            return Ok((header, Names::Comment));
        }
        let is_word = |field: &[u8]| !is_missing(field) && !begins_as_number(field);
        if is_word(fields[0]) && fields.iter().filter(|field| is_number(field)).count() > 1 {
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
        let named = |row: &[&[u8]], name: &str| row.iter().position(|field| text(field) == name);
        let names = |row: &[&[u8]]| row.iter().map(|name| text(name)).collect::<Vec<String>>();
        let place = |name: &String| {
            let by_place = || {
                let place: usize = name.parse().ok()?;
                (1..=fields.len()).contains(&place).then(|| place - 1)
            };
            let by_name = || named(fields, name).or_else(|| named(comment, name));
            let none = || {
                let count = fields.len();
                format!(
                    "there is no column {}: it is a name, or a place from 1 to {count}",
                    quoted(name.as_bytes())
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

/// Whether a name is that of a column with geometries.
fn holds_shapes(name: &[u8]) -> bool {
    let names = ["wkt", "geom", "geometry", "the_geom"];
    names
        .iter()
        .any(|known| name.eq_ignore_ascii_case(known.as_bytes()))
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
        }
    }

    /// Adds a point.
    fn add(&mut self, line: usize, fields: &[&'a [u8]]) -> Result<(), ReadError> {
        let width = self.columns.len();
        let error = |message: String| Err(self.source.error_in_line(line, message));
        let is_beyond = |field: &&[u8]| is_double(field);
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
                return error(format!(
                    "{shown} is not a coordinate: decimal commas are not read, only points, as in 0.5"
                ));
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

    /// Whether nothing tells that the first of more than three columns is x, and it counts three rows and more from 1
    /// on.
    fn is_numbered(&self) -> bool {
        let names = &self.header.names;
        let has_numbers = names.len() > 3 && names.iter().all(String::is_empty);
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
