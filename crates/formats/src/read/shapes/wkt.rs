//! WKT, the text of geometries (OGC Simple Features): one geometry, or several after each other.
//!
//! | geometry | an input takes | a result takes |
//! |---|---|---|
//! | `POINT`, `MULTIPOINT` | points | |
//! | `LINESTRING`, `LINEARRING`, `MULTILINESTRING` | points and edges | |
//! | `POLYGON`, `MULTIPOLYGON`, `TRIANGLE`, `TIN` | points and edges of the rings | triangles: polygons of three corners |
//! | `GEOMETRYCOLLECTION` | what is in it | what is in it |
//!
//! The third number of a position is a height, unless the geometry is marked `M`; measures are ignored with a remark.
//! Before a geometry `SRID=...;` names the coordinate system, which must be one for all. Semicolons are ignored, and so are
//! quotes and a first name, as the column of a table has them. Coordinates may be fractions.
//!
//! Collections are counted, not entered, so that nothing recurses.

use crate::CoordinateSystem;
use crate::read::content::Syntax;
use crate::read::shapes::{Part, Shapes};

use crate::read::source::{ReadError, Source, quoted};

/// Geometries with parts that are not straight (SQL/MM).
const CURVES: [&[u8]; 5] = [
    b"CIRCULARSTRING",
    b"COMPOUNDCURVE",
    b"CURVEPOLYGON",
    b"MULTICURVE",
    b"MULTISURFACE",
];

/// The usual names of columns of geometries.
const COLUMNS: [&[u8]; 9] = [
    b"wkt",
    b"geom",
    b"geometry",
    b"the_geom",
    b"wkt_geom",
    b"wkb_geometry",
    b"shape",
    b"wkb",
    b"geojson",
];

/// Reads a `.wkt`.
pub(crate) fn read(source: &Source) -> Result<Shapes<'_>, ReadError> {
    let mut tokens = Tokens {
        source,
        rest: source.text()?,
    };
    let mut shapes = Shapes::new(source, Syntax::Plain);
    // How many collections are open.
    let mut open = 0_usize;
    let mut is_first = true;
    while let Some(token) = tokens.next() {
        let is_name = std::mem::take(&mut is_first) && is_column(token);
        if is_name || token == b";" {
            continue;
        }
        if token.to_ascii_uppercase().starts_with(b"SRID=") {
            tokens.system(token, &mut shapes)?;
            continue;
        }
        let Some(geometry) = Geometry::named(token) else {
            let name = token.to_ascii_uppercase();
            return Err(if CURVES.contains(&&name[..]) {
                tokens.fault(token, "is a curve, and only straight lines are read: ST_CurveToLine of PostGIS makes these")
            } else if is_binary(token) {
                tokens.fault(token, "is WKB, and its text is read: ST_AsEWKT of PostGIS or shapely.to_wkt makes that")
            } else {
                tokens.wrong(token, "a geometry")
            });
        };
        let has_measure = tokens.skip(b"M") || geometry.has_measure;
        if !has_measure && !tokens.skip(b"Z") {
            tokens.skip(b"ZM");
        }
        if geometry.depth > 0 {
            shapes.begin_feature();
        }
        if !tokens.skip(b"EMPTY") {
            if geometry.depth == 0 {
                tokens.expect(b"(")?;
                open += 1;
                continue;
            }
            geometry.read(has_measure, &mut tokens, &mut shapes)?;
        }
        while open > 0 {
            if tokens.skip(b",") {
                break;
            }
            tokens.expect(b")")?;
            open -= 1;
        }
    }
    let system = shapes.system.as_ref();
    if system.is_some_and(CoordinateSystem::is_of_degrees) {
        shapes.say_wide_sides();
    }
    match open {
        0 => Ok(shapes),
        _ => Err(tokens.end("`)`")),
    }
}

/// Whether this is what columns of geometries are called.
fn is_column(name: &[u8]) -> bool {
    COLUMNS.iter().any(|known| name.eq_ignore_ascii_case(known))
}

/// Whether this is a geometry in hexadecimal digits.
fn is_binary(text: &[u8]) -> bool {
    let begins = text.starts_with(b"00") || text.starts_with(b"01");
    begins && text.len() > 16 && text.iter().all(u8::is_ascii_hexdigit)
}

/// Whether a field of a table is a geometry, or the name of a column of them.
pub(crate) fn is_in(field: &[u8]) -> bool {
    let word = field.split(|byte| !byte.is_ascii_alphanumeric()).next();
    let word = word.unwrap_or_default();
    let is_text = || field.contains(&b'(') && (Geometry::named(word).is_some() || word == b"SRID");
    is_column(field) || is_binary(field) || is_text() || field.starts_with(b"{")
}

/// A kind of geometry.
struct Geometry {
    /// The meaning of its lists of positions; of a polygon the first one.
    part: Part,
    /// In how many parentheses a position stands; in none in a collection.
    depth: usize,
    /// Whether the third number of a position is none of its coordinates.
    has_measure: bool,
}

impl Geometry {
    /// The kind of this name, which may end with `Z`, `M` or `ZM`.
    fn named(name: &[u8]) -> Option<Geometry> {
        let upper = name.to_ascii_uppercase();
        let ends = [&b"ZM"[..], b"Z", b"M"].into_iter();
        let mut ends = ends.filter_map(|end| Some((upper.strip_suffix(end)?, end)));
        let (name, end) = ends.next().unwrap_or((&upper, b""));
        let (part, depth) = match name {
            b"POINT" => (Part::Points, 1),
            b"MULTIPOINT" => (Part::Points, 2),
            b"LINESTRING" | b"LINEARRING" => (Part::Line, 1),
            b"MULTILINESTRING" => (Part::Line, 2),
            b"POLYGON" | b"TRIANGLE" => (Part::Ring, 2),
            b"MULTIPOLYGON" | b"TIN" | b"POLYHEDRALSURFACE" => (Part::Ring, 3),
            b"GEOMETRYCOLLECTION" => (Part::Points, 0),
            _ => return None,
        };
        let has_measure = end == b"M";
        Some(Geometry {
            part,
            depth,
            has_measure,
        })
    }

    /// Reads the positions, and all parentheses around them.
    fn read<'a>(
        &self,
        has_measure: bool,
        tokens: &mut Tokens<'a>,
        shapes: &mut Shapes<'a>,
    ) -> Result<(), ReadError> {
        let mut depth = 0;
        // Whether a list or a position has just ended: then a comma or a parenthesis follows.
        let mut is_behind = false;
        let mut has_ring = false;
        loop {
            let mut behind = tokens.clone();
            let token = behind.next().ok_or_else(|| tokens.end("`)`"))?;
            let is_separator = matches!(token, b"," | b")");
            if is_separator != is_behind {
                let what = if is_behind {
                    "`,` or `)`"
                } else {
                    "a position"
                };
                return Err(tokens.wrong(token, what));
            }
            match token {
                b"(" if depth < self.depth => depth += 1,
                b"," => is_behind = false,
                b")" => {
                    if depth == self.depth && self.part != Part::Points {
                        let part = if has_ring { Part::Hole } else { self.part };
                        shapes.end(part);
                        has_ring = self.part == Part::Ring;
                    }
                    depth -= 1;
                    // The last ring of a polygon has ended.
                    has_ring &= depth + 2 > self.depth;
                }
                _ if depth > 0 && token.eq_ignore_ascii_case(b"EMPTY") => is_behind = true,
                _ if depth == self.depth || depth > 0 && self.part == Part::Points => {
                    tokens.position(has_measure, shapes)?;
                    is_behind = true;
                    continue;
                }
                _ => return Err(tokens.wrong(token, "`(`")),
            }
            *tokens = behind;
            if depth == 0 {
                // Of points the parentheses say nothing.
                if self.part == Part::Points {
                    shapes.end(Part::Points);
                }
                return Ok(());
            }
        }
    }
}

/// The rest of a file.
#[derive(Clone)]
struct Tokens<'a> {
    source: &'a Source,
    rest: &'a [u8],
}

impl<'a> Tokens<'a> {
    /// The next token, if there is one: a parenthesis, a comma, a semicolon, or all up to one of them or a space.
    fn next(&mut self) -> Option<&'a [u8]> {
        let is_single = |byte: &u8| b"(),;".contains(byte);
        let is_blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'"';
        let begin = self.rest.iter().position(|byte| !is_blank(byte));
        self.rest = &self.rest[begin.unwrap_or(self.rest.len())..];
        let length = match self.rest.first()? {
            byte if is_single(byte) => 1,
            _ => {
                let is_end = |byte: &u8| is_single(byte) || is_blank(byte);
                let end = self.rest.iter().position(is_end);
                end.unwrap_or(self.rest.len())
            }
        };
        let (token, rest) = self.rest.split_at(length);
        self.rest = rest;
        Some(token)
    }

    /// Goes on behind the next token if it is this word.
    fn skip(&mut self, word: &[u8]) -> bool {
        let mut behind = self.clone();
        let is_next = behind
            .next()
            .is_some_and(|token| token.eq_ignore_ascii_case(word));
        if is_next {
            *self = behind;
        }
        is_next
    }

    /// Goes on behind the next token, which must be this one.
    fn expect(&mut self, word: &[u8]) -> Result<(), ReadError> {
        let what = quoted(word);
        let token = self.clone().next().ok_or_else(|| self.end(&what))?;
        match self.skip(word) {
            true => Ok(()),
            false => Err(self.wrong(token, &what)),
        }
    }

    /// Reads the number of a coordinate system.
    fn system(&self, token: &'a [u8], shapes: &mut Shapes<'a>) -> Result<(), ReadError> {
        let number = std::str::from_utf8(&token[b"SRID=".len()..]).ok();
        let srid: Option<u32> = number.and_then(|number| number.parse().ok());
        let srid =
            srid.ok_or_else(|| self.fault(token, "is not the number of a coordinate system"))?;
        // 0 stands for none.
        let system = (srid != 0).then(|| CoordinateSystem::of_srid(srid));
        if let (Some(one), Some(other)) = (&shapes.system, &system)
            && one != other
        {
            let why = format!(
                "is another coordinate system than {}, and one is read",
                one.name()
            );
            return Err(self.fault(token, &why));
        }
        shapes.system = system.or(shapes.system.take());
        Ok(())
    }

    /// Reads two to four numbers.
    fn position(&mut self, has_measure: bool, shapes: &mut Shapes<'a>) -> Result<(), ReadError> {
        let mut numbers = [None; 4];
        let mut count = 0;
        loop {
            let mut behind = self.clone();
            let token = behind.next().filter(|token| !b"(),;".contains(&token[0]));
            let Some(token) = token else { break };
            if count == numbers.len() {
                return Err(self.wrong(token, "`,` or `)`"));
            }
            numbers[count] = Some(token);
            count += 1;
            *self = behind;
        }
        match numbers {
            [Some(x), Some(y), z, fourth] => {
                let measures =
                    usize::from(has_measure && z.is_some()) + usize::from(fourth.is_some());
                shapes.remarks.ignore(measures, "measure", "measures");
                shapes.push([x, y], z.filter(|_| !has_measure));
                Ok(())
            }
            _ => Err(match self.clone().next() {
                Some(token) => self.wrong(token, "a number"),
                None => self.end("a number"),
            }),
        }
    }

    /// The fault of a token that stands in another one's place.
    fn wrong(&self, token: &'a [u8], what: &str) -> ReadError {
        self.fault(token, &format!("stands where {what} should"))
    }

    /// The fault of a token: what it is.
    fn fault(&self, token: &'a [u8], what: &str) -> ReadError {
        let (line, _) = self.source.position(token);
        let message = format!("{} {what}", quoted(token));
        self.source.error_in_line(line, message)
    }

    /// The error that the file ends too early.
    fn end(&self, what: &str) -> ReadError {
        let message = format!("the file ends where {what} should follow");
        ReadError::of_file(&self.source.name, message)
    }
}
