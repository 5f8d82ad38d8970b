//! CAD's `.dxf`, as text: the entities that are points, straight lines and faces.
//!
//! ```text
//! 0            a line with the code of what follows, and a line with the value
//! SECTION
//! 2
//! ENTITIES     only this section is read
//! 0
//! LINE         10, 20, 30 are x, y and z of its first place, 11, 21, 31 of its second one
//! ```
//!
//! | entity | an input takes | a result takes |
//! |---|---|---|
//! | `POINT` | a point | |
//! | `LINE`, `LWPOLYLINE`, `POLYLINE` | points and edges; of closed ones an edge back to the first | |
//! | `3DFACE` | points | triangles: the fourth corner is the third |
//!
//! Curves, bulges, meshes and inserted blocks are refused, for a drawing without them is another one. Texts, dimensions,
//! hatches, and all that lies in the space of the paper, are no part of the plan, and ignored with a remark. A polyline has one height
//! for all its places, unless it is in 3D. What has none is without a height.
//!
//! Cost: time and memory in proportion to the text.

use std::cmp::Ordering;

use crate::read::content::Syntax;
use crate::read::shapes::{Part, Shapes};
use crate::read::source::{ReadError, Source, quoted, split_line};

/// Entities that say where something is, and are not read.
const REFUSED: [&[u8]; 13] = [
    b"ARC", b"BODY", b"CIRCLE", b"ELLIPSE", b"HELIX", b"INSERT", b"MESH", b"MLINE", b"REGION",
    b"SOLID", b"SPLINE", b"SURFACE", b"TRACE",
];

const ADVICE: &str = "`ogr2ogr -f GeoJSON out.geojson in.dxf` makes straight lines of it";

/// Reads a `.dxf`; `faces` are the parts that a `3DFACE` is.
pub(super) fn read(source: &Source, faces: Part) -> Result<Shapes<'_>, ReadError> {
    let text = source.text()?;
    if text.starts_with(b"AutoCAD Binary DXF") {
        let message = format!("only files of text are read, and no binary ones: {ADVICE}");
        return Err(ReadError::of_file(&source.name, message));
    }
    let mut pairs = Pairs {
        source,
        rest: text,
        lines: 0,
    };
    let mut drawing = Drawing {
        source,
        shapes: Shapes::new(source, Syntax::Plain),
        faces,
        polyline: None,
    };
    let mut has_entities = false;
    let (mut is_in_entities, mut is_ended) = (false, false);
    let mut entity: Option<Entity<'_>> = None;
    while let Some((line, code, value)) = pairs.next_pair()? {
        match (code, &mut entity) {
            (999, _) => {}
            (0, _) => {
                if let Some(entity) = entity.take().filter(|_| is_in_entities) {
                    drawing.add(&entity)?;
                }
                is_ended = value == b"EOF";
                if is_ended {
                    break;
                }
                is_in_entities &= value != b"ENDSEC";
                entity = Some(Entity {
                    kind: value,
                    line,
                    values: Vec::new(),
                });
            }
            (2, Some(entity)) if entity.kind == b"SECTION" => {
                is_in_entities = value == b"ENTITIES";
                has_entities |= is_in_entities;
            }
            (code, Some(entity)) => entity.values.push((code, value)),
            (_, None) => {
                let message = "the file does not begin with the code 0 and `SECTION`";
                return Err(source.error_in_line(line, message));
            }
        }
    }
    let missing = |what: &str| {
        let message = format!("the file ends where {what} should follow");
        Err(ReadError::of_file(&source.name, message))
    };
    match (has_entities, is_ended) {
        (false, _) => missing("the section `ENTITIES`"),
        (true, false) => missing("`EOF`"),
        (true, true) => Ok(drawing.shapes),
    }
}

/// The codes and values of a file.
struct Pairs<'a> {
    source: &'a Source,
    rest: &'a [u8],
    lines: usize,
}

/// The line of a value, its code, and the value.
type Pair<'a> = (usize, i32, &'a [u8]);

impl<'a> Pairs<'a> {
    /// The next code, with its line and its value.
    fn next_pair(&mut self) -> Result<Option<Pair<'a>>, ReadError> {
        if self.rest.trim_ascii().is_empty() {
            return Ok(None);
        }
        let (code, value) = (self.next_line(), self.next_line());
        let number = std::str::from_utf8(code).ok();
        let number = number.and_then(|code| code.parse().ok()).ok_or_else(|| {
            let message = format!("{} is not the code of a value", quoted(code));
            self.source.error_in_line(self.lines - 1, message)
        })?;
        Ok(Some((self.lines, number, value)))
    }

    fn next_line(&mut self) -> &'a [u8] {
        let (line, rest) = split_line(self.rest);
        (self.rest, self.lines) = (rest, self.lines + 1);
        line.trim_ascii()
    }
}

/// An entity with its values.
struct Entity<'a> {
    kind: &'a [u8],
    line: usize,
    values: Vec<(i32, &'a [u8])>,
}

impl<'a> Entity<'a> {
    /// The first value of a code.
    fn value(&self, code: i32) -> Option<&'a [u8]> {
        let mut values = self.values.iter();
        values
            .find(|(other, _)| *other == code)
            .map(|(_, value)| *value)
    }

    /// The value of a code that is a number, or what it is where it is not there.
    fn number(&self, code: i32, default: f64) -> f64 {
        self.value(code).map_or(default, number)
    }

    /// Whether a value has this bit.
    fn has(&self, code: i32, bit: i64) -> bool {
        let value = self
            .value(code)
            .and_then(|value| std::str::from_utf8(value).ok());
        value
            .and_then(|value| value.parse().ok())
            .is_some_and(|bits: i64| bits & bit != 0)
    }
}

/// A number; NaN if it is none.
fn number(value: &[u8]) -> f64 {
    Syntax::Plain.value(value).unwrap_or(f64::NAN)
}

/// A polyline whose vertices follow.
struct Polyline<'a> {
    is_closed: bool,
    /// The height of all places, unless each has its own.
    height: Option<Option<&'a [u8]>>,
    places: Vec<Place<'a>>,
}

/// A place and its height.
type Place<'a> = ([&'a [u8]; 2], Option<&'a [u8]>);

/// The entities that are read.
struct Drawing<'a> {
    source: &'a Source,
    shapes: Shapes<'a>,
    faces: Part,
    polyline: Option<Polyline<'a>>,
}

impl<'a> Drawing<'a> {
    fn add(&mut self, entity: &Entity<'a>) -> Result<(), ReadError> {
        if entity.has(67, 1) {
            let remarks = &mut self.shapes.remarks;
            remarks.ignore(1, "entity on the paper", "entities on the paper");
            return Ok(());
        }
        match entity.kind {
            b"POINT" => self.end(&[self.place(entity, 0)?], Part::Points),
            b"LINE" => {
                let ends = [self.place(entity, 0)?, self.place(entity, 1)?];
                self.end(&ends, Part::Line);
            }
            b"3DFACE" => {
                let mut corners = Vec::new();
                for corner in 0..3 {
                    corners.push(self.place(entity, corner)?);
                }
                if entity.value(13).is_some() {
                    let last = self.place(entity, 3)?;
                    if !is_same(&last, &corners[2]) {
                        corners.push(last);
                    }
                }
                self.end(&corners, self.faces);
            }
            b"LWPOLYLINE" => self.add_light(entity)?,
            b"POLYLINE" => {
                if entity.has(70, 16 | 64) {
                    return Err(self.refused(entity.line, "a mesh as `POLYLINE` is not read"));
                }
                let is_spatial = entity.has(70, 8);
                self.expect_flat(entity, is_spatial)?;
                self.polyline = Some(Polyline {
                    is_closed: entity.has(70, 1),
                    height: (!is_spatial).then(|| entity.value(30)),
                    places: Vec::new(),
                });
            }
            b"VERTEX" => {
                let place = self.place(entity, 0)?;
                self.expect_straight(entity.line, entity.number(42, 0.0))?;
                // The frame of a spline is not part of the line.
                if let Some(polyline) = &mut self.polyline
                    && !entity.has(70, 16)
                {
                    let height = polyline.height.unwrap_or(place.1);
                    polyline.places.push((place.0, height));
                }
            }
            b"SEQEND" => {
                if let Some(polyline) = self.polyline.take() {
                    self.end_polyline(polyline.places, polyline.is_closed);
                }
            }
            kind if REFUSED.contains(&kind) || kind.starts_with(b"3DSOLID") => {
                let what = format!(
                    "{} is not read, only points and straight lines",
                    quoted(kind)
                );
                return Err(self.refused(entity.line, &what));
            }
            b"SECTION" => {}
            kind => {
                let remarks = &mut self.shapes.remarks;
                remarks.ignore_named(1, ["entity", "entities"], kind);
            }
        }
        Ok(())
    }

    /// Adds a `LWPOLYLINE`, whose places stand in it one after the other.
    fn add_light(&mut self, entity: &Entity<'a>) -> Result<(), ReadError> {
        self.expect_flat(entity, false)?;
        let height = entity.value(38);
        let mut places: Vec<Place<'a>> = Vec::new();
        let mut x = None;
        for &(code, value) in &entity.values {
            match (code, x) {
                (10, None) => x = Some(value),
                (20, Some(first)) => {
                    places.push(([first, value], height));
                    x = None;
                }
                (10 | 20, _) => {
                    let message = "a place of the `LWPOLYLINE` is not one x (10) and one y (20)";
                    return Err(self.source.error_in_line(entity.line, message));
                }
                (42, _) => self.expect_straight(entity.line, number(value))?,
                _ => {}
            }
        }
        if x.is_some() {
            let message = "the last place of the `LWPOLYLINE` has no y (20)";
            return Err(self.source.error_in_line(entity.line, message));
        }
        self.end_polyline(places, entity.has(70, 1));
        Ok(())
    }

    fn end_polyline(&mut self, mut places: Vec<Place<'a>>, is_closed: bool) {
        if let [first, .., last] = *places.as_slice()
            && is_closed
            && !is_same(&first, &last)
        {
            places.push(first);
        }
        self.end(&places, Part::Line);
    }

    fn end(&mut self, places: &[Place<'a>], part: Part) {
        for &(place, height) in places {
            self.shapes.push(place, height);
        }
        self.shapes.end(part);
    }

    /// The place whose codes end with this digit.
    fn place(&self, entity: &Entity<'a>, digit: i32) -> Result<Place<'a>, ReadError> {
        let value = |code: i32| {
            let missing = || {
                let kind = quoted(entity.kind);
                let message = format!("the {kind} has no value of the code {code}");
                self.source.error_in_line(entity.line, message)
            };
            entity.value(code).ok_or_else(missing)
        };
        let place = [value(10 + digit)?, value(20 + digit)?];
        Ok((place, entity.value(30 + digit)))
    }

    /// Refuses a line that is an arc.
    fn expect_straight(&self, line: usize, bulge: f64) -> Result<(), ReadError> {
        if bulge == 0.0 {
            return Ok(());
        }
        Err(self.refused(
            line,
            "a side with a bulge (42) is an arc, which is not read",
        ))
    }

    /// Refuses places in a plane that is not that of x and y.
    fn expect_flat(&self, entity: &Entity<'a>, is_spatial: bool) -> Result<(), ReadError> {
        let normal = [
            entity.number(210, 0.0),
            entity.number(220, 0.0),
            entity.number(230, 1.0),
        ];
        if is_spatial || normal[0] == 0.0 && normal[1] == 0.0 && normal[2] > 0.0 {
            return Ok(());
        }
        let what = format!(
            "the {} lies in a plane of its own (210 to 230)",
            quoted(entity.kind)
        );
        Err(self.refused(entity.line, &what))
    }

    fn refused(&self, line: usize, what: &str) -> ReadError {
        self.source.error_in_line(line, format!("{what}: {ADVICE}"))
    }
}

/// Whether two places are the same, heights included.
fn is_same(one: &Place<'_>, other: &Place<'_>) -> bool {
    let values = |([x, y], z): &Place<'_>| [number(x), number(y), z.map_or(0.0, number)];
    let pairs = values(one).into_iter().zip(values(other));
    pairs
        .map(|(x, y)| x.partial_cmp(&y))
        .all(|order| order.is_some_and(Ordering::is_eq))
}
