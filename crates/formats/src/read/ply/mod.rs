//! Stanford's `.ply`, as text or binary: the elements `vertex`, `edge` and `face`.
//!
//! | element | properties |
//! |---|---|
//! | `vertex` | `x` and `y`; `z` and all others but lists are columns |
//! | `edge` | `vertex1` and `vertex2`; a whole number `marker` |
//! | `face` | the list `vertex_indices` or `vertex_index`; of triangles a number `region` |
//!
//! Vertices, edges and faces are numbered from 0. Other elements and properties are ignored with a remark. Every number of a
//! binary file is a double, and arrives as it is; those of a text as all texts do, whatever type they are said to
//! have.

pub(super) mod header;

use crate::Column;
use crate::graph_file::whole;
use crate::read::binary::{Kind, Number};
use crate::read::content::{Field, Syntax, Vertices};
use crate::read::mesh::{Cells, Mesh};
use crate::read::ply::header::{Element, Encoding, Property};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::token_lines::Lines;

/// Reads a `.ply`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    let mut lines = Lines::new(source)?;
    let header = header::read(source, &mut lines)?;
    let mut body = match header.encoding {
        Encoding::Text => Body::Text(lines),
        Encoding::Binary { big_endian } => Body::Binary {
            source,
            rest: lines.rest(),
            big_endian,
        },
    };
    let mut vertices = None;
    let (mut cells, mut remarks) = (Cells::default(), Remarks::default());
    // A record without properties takes no bytes, so that there may be any number of them.
    let elements = header.elements.iter();
    for element in elements.filter(|element| !element.properties.is_empty()) {
        match element.name {
            b"vertex" if vertices.is_none() => {
                let is_read = |at: usize| element.properties[at].length.is_none();
                ignore_others(element, is_read, &mut remarks);
                vertices = Some(read_vertices(source, element, &mut body)?);
            }
            b"edge" => read_edges(source, element, &mut body, &mut cells, &mut remarks)?,
            b"face" => read_faces(source, element, &mut body, &mut cells, &mut remarks)?,
            _ => {
                remarks.ignore_named(element.count, ["element", "elements"], element.name);
                (0..element.count).try_for_each(|at| body.record(element, at, |_, _| Ok(())))?;
            }
        }
    }
    let missing = || ReadError::of_file(&source.name, "there is no element `vertex`");
    Ok(Mesh {
        vertices: vertices.ok_or_else(missing)?,
        cells,
        first: 0,
        remarks,
    })
}

fn read_vertices<'a>(
    source: &'a Source,
    element: &Element<'a>,
    body: &mut Body<'a>,
) -> Result<Vertices<'a>, ReadError> {
    let [x, y] = [
        place(source, element, &[b"x"])?,
        place(source, element, &[b"y"])?,
    ];
    let mut coordinates = Vec::new();
    let mut fields: Vec<(usize, Field<'a>)> = Vec::new();
    for (at, property) in element.properties.iter().enumerate() {
        if at != x && at != y && property.length.is_none() {
            let field = Field {
                name: String::from_utf8_lossy(property.name).into_owned(),
                syntax: body.syntax(property.kind),
                pieces: Vec::new(),
            };
            fields.push((at, field));
        }
    }
    if element.properties[x].kind != element.properties[y].kind {
        let message = "x and y have different types";
        return Err(ReadError::of_file(&source.name, message));
    }
    for vertex in 0..element.count {
        let mut point: [&[u8]; 2] = [b""; 2];
        body.record(element, vertex, |at, piece| {
            if at == x {
                point[0] = piece.bytes;
            } else if at == y {
                point[1] = piece.bytes;
            } else if let Ok(field) = fields.binary_search_by_key(&at, |(place, _)| *place) {
                fields[field].1.pieces.push(piece.bytes);
            }
            Ok(())
        })?;
        coordinates.push(point);
    }
    Ok(Vertices {
        syntax: body.syntax(element.properties[x].kind),
        fields: fields.into_iter().map(|(_, field)| field).collect(),
        ..Vertices::plain(source, coordinates, 0)
    })
}

fn read_edges<'a>(
    source: &'a Source,
    element: &Element<'a>,
    body: &mut Body<'a>,
    cells: &mut Cells,
    remarks: &mut Remarks,
) -> Result<(), ReadError> {
    let ends = [
        place(source, element, &[b"vertex1"])?,
        place(source, element, &[b"vertex2"])?,
    ];
    let marker = element.place(&[Column::MARKER.as_bytes()]);
    ignore_others(
        element,
        |at| ends.contains(&at) || Some(at) == marker,
        remarks,
    );
    for edge in 0..element.count {
        let mut line = [0; 2];
        body.record(element, edge, |at, piece| {
            if let Some(end) = ends.iter().position(|&end| end == at) {
                line[end] = piece.index("a vertex's number")?;
            } else if Some(at) == marker {
                cells.markers.push(piece.marker()?);
            }
            Ok(())
        })?;
        cells.lines.push(line);
    }
    Ok(())
}

fn read_faces<'a>(
    source: &'a Source,
    element: &Element<'a>,
    body: &mut Body<'a>,
    cells: &mut Cells,
    remarks: &mut Remarks,
) -> Result<(), ReadError> {
    let list = element.place(&[b"vertex_indices", b"vertex_index"]);
    let list = list.filter(|&list| element.properties[list].length.is_some());
    let Some(list) = list else {
        let message = "the element `face` has no list `vertex_indices`";
        return Err(ReadError::of_file(&source.name, message));
    };
    let region = element.place(&[b"region"]);
    ignore_others(element, |at| at == list || Some(at) == region, remarks);
    let mut corners = Vec::new();
    for face in 0..element.count {
        corners.clear();
        let mut attribute: Option<f64> = None;
        body.record(element, face, |at, piece| {
            if at == list {
                corners.push(piece.index("a vertex's number")?);
            } else if Some(at) == region {
                attribute = piece.syntax.value(piece.bytes).ok();
            }
            Ok(())
        })?;
        if corners.len() == 3 {
            cells.regions.extend(attribute);
        }
        let message = |what| format!("face {face}: {what}");
        cells.add(&corners, |what| {
            ReadError::of_file(&source.name, message(what))
        });
    }
    // A region that is no number makes all of them useless.
    if cells.regions.len() != cells.faces.triangles.len() {
        cells.regions.clear();
    }
    Ok(())
}

/// Adds a remark for each property of a vertex, an edge or a face that is not read.
fn ignore_others(element: &Element<'_>, is_read: impl Fn(usize) -> bool, remarks: &mut Remarks) {
    let kind = match element.name {
        b"vertex" => ["property of `vertex`", "properties of `vertex`"],
        b"edge" => ["property of `edge`", "properties of `edge`"],
        _ => ["property of `face`", "properties of `face`"],
    };
    let properties = element.properties.iter().enumerate();
    for (_, property) in properties.filter(|(at, _)| !is_read(*at)) {
        remarks.ignore_named(1, kind, property.name);
    }
}

/// The place of a property that must be there, and no list.
fn place(source: &Source, element: &Element<'_>, names: &[&[u8]; 1]) -> Result<usize, ReadError> {
    let place = element.place(names);
    let place = place.filter(|&place| element.properties[place].length.is_none());
    place.ok_or_else(|| {
        let [element, property] = [element.name, names[0]].map(quoted);
        let message = format!("the element {element} has no property {property}");
        ReadError::of_file(&source.name, message)
    })
}

/// The part that follows the header.
enum Body<'a> {
    /// A line for each record.
    Text(Lines<'a>),
    Binary {
        source: &'a Source,
        rest: &'a [u8],
        big_endian: bool,
    },
}

/// A number in a record.
struct Piece<'a, 'r> {
    bytes: &'a [u8],
    syntax: Syntax,
    error: &'r dyn Fn(String) -> ReadError,
}

impl Piece<'_, '_> {
    /// A marker.
    fn marker(&self) -> Result<i64, ReadError> {
        whole(self.syntax.value(self.bytes).unwrap_or(f64::NAN)).ok_or_else(|| {
            let shown = self.syntax.text(self.bytes);
            (self.error)(format!(
                "{} is not a marker, a whole number",
                quoted(shown.as_bytes())
            ))
        })
    }

    /// The number of a vertex, or how long a list is.
    fn index(&self, what: &str) -> Result<usize, ReadError> {
        self.syntax.index(self.bytes).ok_or_else(|| {
            let shown = self.syntax.text(self.bytes);
            (self.error)(format!("{} is not {what}", quoted(shown.as_bytes())))
        })
    }
}

impl<'a> Body<'a> {
    /// How a number of this type stands here.
    fn syntax(&self, kind: Kind) -> Syntax {
        match *self {
            Body::Text(_) => Syntax::Plain,
            Body::Binary { big_endian, .. } => Syntax::Binary(Number { kind, big_endian }),
        }
    }

    /// Reads a record; `take` gets each value and each member of a list, with the place of the property.
    fn record(
        &mut self,
        element: &Element<'a>,
        at: usize,
        take: impl FnMut(usize, &Piece<'a, '_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let (name, count) = (String::from_utf8_lossy(element.name), element.count);
        match self {
            Body::Text(lines) => {
                let line = lines.expect_line(|| format!("{name} {} of {count}", at + 1))?;
                let mut rest = line.clone();
                let next = |_: Kind| rest.expect_token("a number");
                let syntax = |_| Syntax::Plain;
                values(
                    &element.properties,
                    next,
                    syntax,
                    &|what| line.error(what),
                    take,
                )
            }
            Body::Binary {
                source,
                rest,
                big_endian,
            } => {
                let error = |what| ReadError::of_file(&source.name, format!("{name} {at}: {what}"));
                let next = |kind: Kind| {
                    let (piece, others) = rest.split_at_checked(kind.size()).ok_or_else(|| {
                        error(format!("the file ends, and {count} are announced"))
                    })?;
                    *rest = others;
                    Ok(piece)
                };
                let big_endian = *big_endian;
                let syntax = |kind| Syntax::Binary(Number { kind, big_endian });
                values(&element.properties, next, syntax, &error, take)
            }
        }
    }
}

/// Reads the values of a record one after the other.
fn values<'a>(
    properties: &[Property<'a>],
    mut next: impl FnMut(Kind) -> Result<&'a [u8], ReadError>,
    syntax: impl Fn(Kind) -> Syntax,
    error: &dyn Fn(String) -> ReadError,
    mut take: impl FnMut(usize, &Piece<'a, '_>) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    let mut piece = |kind| {
        let bytes = next(kind)?;
        let syntax = syntax(kind);
        Ok(Piece {
            bytes,
            syntax,
            error,
        })
    };
    for (at, property) in properties.iter().enumerate() {
        let count = match property.length {
            None => 1,
            Some(length) => piece(length)?.index("the length of a list")?,
        };
        for _ in 0..count {
            take(at, &piece(property.kind)?)?;
        }
    }
    Ok(())
}
