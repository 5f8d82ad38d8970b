//! Triangle's `.node`, `.poly` and `.ele`.
//!
//! ```text
//! .node    <vertices> 2 <attributes> <markers>        counts; only the first one is needed
//!          <vertex> <x> <y> [attributes] [marker]     numbered from 0 or from 1
//!
//! .poly    as .node; 0 vertices: they are in the .node beside it
//!          <segments> <markers>
//!          <segment> <vertex> <vertex> [marker]       numbered from 0 or from 1
//!          <holes>                                    this line and all after it may be left out
//!          <hole> <x> <y>                             a point in the hole; numbered from 0 or from 1
//!          <regions>                                  this line and all after it may be left out
//!          <region> <x> <y> [attribute] [area]        a point in the region; numbered from 0 or from 1
//!
//! .ele     <triangles> 3 <attributes>                 counts; only the first one is needed
//!          <triangle> <vertex> <vertex> <vertex> [attributes]       numbered from 0 or from 1
//! ```
//!
//! The first attribute of a vertex is its height. Markers of vertices are the last of their columns. The areas of regions,
//! which limit triangles where a mesh is refined, are ignored with a remark, and so are numbers of vertices that the first
//! line does not announce. What else follows on a line is ignored. A region
//! without an attribute has 0. The vertices of a `.ele` are numbered as in the `.node` beside it; without one, from 0 or 1
//! as the triangles are, as Triangle does.

use crate::read::content::{Corners, Edges, Field, Labels, Syntax, Vertices};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, ReadErrorKind, Source, no_vertex, quoted};
use crate::read::token_lines::{Line, Lines, Records};
use crate::{Column, Coordinate};

/// Reads a `.node`.
pub(super) fn read_node<'a>(
    source: &'a Source,
    remarks: &mut Remarks,
) -> Result<Vertices<'a>, ReadError> {
    let mut lines = Lines::new(source)?;
    let counts = vertex_counts(&mut lines)?;
    let vertices = read_vertices(source, &mut lines, counts, remarks)?;
    let count = counts.vertices;
    match lines.next_line() {
        Some(line) => Err(line.error(format!("the first line announces only {count} vertices"))),
        None => Ok(vertices),
    }
}

/// Reads a `.poly`; `node` is where its vertices are if it holds none.
pub(super) fn read_poly<'a>(
    source: &'a Source,
    node: Option<&'a Source>,
) -> Result<Edges<'a>, ReadError> {
    // The vertices, here or in the `.node`.
    let mut lines = Lines::new(source)?;
    let mut remarks = Remarks::default();
    let counts = vertex_counts(&mut lines)?;
    let vertices = match (counts.vertices, node) {
        (0, Some(node)) => read_node(node, &mut remarks)?,
        (0, None) => {
            return Err(ReadError {
                kind: ReadErrorKind::MissingNode,
                ..ReadError::of_file(&source.name, "no vertices, and no .node beside it")
            });
        }
        _ => read_vertices(source, &mut lines, counts, &mut remarks)?,
    };

    // The edges.
    let mut line = lines.expect_line(|| "the number of edges".to_owned())?;
    let count = line.index("a number of edges")?;
    let has_markers = is_announced(&mut line);
    let records = Records {
        name: "edge",
        number: "an edge's number",
        count,
    };
    let mut first = vertices.first;
    let ends = |line: &mut Line<'_>| Ok([end(line, &vertices)?, end(line, &vertices)?]);
    let (edges, markers) = if has_markers {
        let row = |line: &mut Line<'_>| Ok((ends(line)?, marker(line)?));
        let rows = records.read(&mut lines, &mut first, row)?;
        rows.into_iter().unzip()
    } else {
        (records.read(&mut lines, &mut first, ends)?, Vec::new())
    };

    // Holes and regions, if the file goes on.
    let holes = read_holes(source, &mut lines, vertices.first)?;
    let (regions, attributes, areas) = read_regions(source, &mut lines, vertices.first)?;
    Ok(Edges {
        holes,
        regions,
        attributes,
        areas,
        markers,
        remarks,
        ..Edges::without_seeds(vertices, edges, first)
    })
}

/// What the first line announces.
#[derive(Clone, Copy)]
struct Counts {
    vertices: usize,
    attributes: usize,
    has_markers: bool,
}

/// Whether the next number of a line announces markers.
fn is_announced(line: &mut Line<'_>) -> bool {
    line.token().is_some_and(|number| number != b"0")
}

/// The marker that a line may end with.
fn marker(line: &mut Line<'_>) -> Result<i64, ReadError> {
    let Some(token) = line.token() else {
        return Ok(0);
    };
    let number = std::str::from_utf8(token).ok();
    let number = number.and_then(|number| number.parse().ok());
    number.ok_or_else(|| line.error(format!("{} is not a marker, a whole number", quoted(token))))
}

/// The counts in the first line.
fn vertex_counts(lines: &mut Lines<'_>) -> Result<Counts, ReadError> {
    let mut line = lines.expect_line(|| "the number of vertices".to_owned())?;
    let vertices = line.index("a number of vertices")?;
    let counts = Counts {
        vertices,
        attributes: 0,
        has_markers: false,
    };
    match line.token() {
        None => Ok(counts),
        Some(b"2") if line.is_empty() => Ok(counts),
        Some(b"2") => Ok(Counts {
            attributes: line.index("a number of attributes")?,
            has_markers: is_announced(&mut line),
            ..counts
        }),
        Some(b"3") => Err(line.error(
            "3 coordinates are announced, and only x and y are read: leave out z and announce 2",
        )),
        Some(other) => Err(line.error(format!(
            "{} is not 2, the number of coordinates",
            quoted(other)
        ))),
    }
}

fn read_vertices<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    Counts {
        vertices,
        attributes,
        has_markers,
    }: Counts,
    remarks: &mut Remarks,
) -> Result<Vertices<'a>, ReadError> {
    let records = Records {
        name: "vertex",
        number: "a vertex's number",
        count: vertices,
    };
    let mut first = 0;
    let columns = attributes.saturating_add(usize::from(has_markers));
    if columns == 0 {
        let coordinates = records.read(lines, &mut first, Line::coordinates)?;
        let more = coordinates
            .iter()
            .filter(|[_, y]| is_followed(source, y))
            .count();
        ignore_more(more, remarks);
        return Ok(Vertices::plain(source, coordinates, first));
    }
    let rows = records.read(lines, &mut first, |line| {
        let point = line.coordinates()?;
        let row = (0..columns).map(|at| match line.token() {
            Some(token) => Ok(token),
            // Triangle lets lines end before the marker.
            None if at == attributes => Ok(&b""[..]),
            None => line.expect_token("an attribute"),
        });
        Ok((point, row.collect::<Result<Vec<_>, _>>()?))
    })?;
    let last = rows.iter().filter_map(|(_, row)| row.last());
    ignore_more(
        last.filter(|piece| is_followed(source, piece)).count(),
        remarks,
    );
    // Without a row there may be any number of attributes.
    let width = rows.first().map_or(0, |(_, row)| row.len());
    let field = |at: usize| Field {
        name: match at {
            _ if at == attributes => Column::MARKER.to_owned(),
            0 => Column::HEIGHT.to_owned(),
            _ => format!("attribute{}", at + 1),
        },
        syntax: Syntax::Plain,
        pieces: rows.iter().map(|(_, row)| row[at]).collect(),
    };
    let is_said = |field: &Field<'_>| {
        let mut pieces = field.pieces.iter();
        field.name != Column::MARKER || !pieces.all(|&piece| piece.is_empty() || piece == b"0")
    };
    Ok(Vertices {
        fields: (0..width).map(field).filter(is_said).collect(),
        ..Vertices::plain(
            source,
            rows.iter().map(|&(point, _)| point).collect(),
            first,
        )
    })
}

/// Whether more follows a piece on its line.
fn is_followed(source: &Source, piece: &[u8]) -> bool {
    let end = (piece.as_ptr().addr() + piece.len()).wrapping_sub(source.bytes.as_ptr().addr());
    // A missing marker is no piece of the file.
    let Some(rest) = source.bytes.get(end..).filter(|_| !piece.is_empty()) else {
        return false;
    };
    let mut rest = rest.iter().filter(|&&byte| !b" \t\x0c".contains(&byte));
    rest.next().is_some_and(|byte| !b"\n\r#".contains(byte))
}

/// Adds that vertices have more numbers than are announced.
fn ignore_more(vertices: usize, remarks: &mut Remarks) {
    remarks.ignore(
        vertices,
        "vertex's numbers that the first line does not announce",
        "vertices' numbers that the first line does not announce",
    );
}

/// Reads an end of an edge.
fn end(line: &mut Line<'_>, vertices: &Vertices<'_>) -> Result<usize, ReadError> {
    let number = line.index("a vertex's number")?;
    number
        .checked_sub(vertices.first)
        .filter(|&vertex| vertex < vertices.coordinates.len())
        .ok_or_else(|| {
            let (first, count) = (vertices.first, vertices.coordinates.len());
            line.error(no_vertex(number, first, count))
        })
}

/// Reads a `.ele`; `node` is the `.node` beside it.
pub(super) fn read_ele<'a>(
    source: &'a Source,
    node: Option<&'a Source>,
) -> Result<Corners<'a>, ReadError> {
    // The line of counts.
    let mut lines = Lines::new(source)?;
    let mut line = lines.expect_line(|| "the number of triangles".to_owned())?;
    let count = line.index("a number of triangles")?;
    match line.token() {
        None | Some(b"3") => {}
        Some(b"6") => {
            return Err(line.error(
                "the triangles have 6 nodes each, and only those of 3 are read: \
                 write them without Triangle's option -o2",
            ));
        }
        Some(b"4") => {
            return Err(
                line.error("the cells have 4 corners, and only triangles are read: split them")
            );
        }
        Some(other) => {
            return Err(line.error(format!("{} is not 3, the number of corners", quoted(other))));
        }
    }

    // Without a number of attributes there are none.
    let has_attributes = line.token().is_some_and(|number| number != b"0");

    // The triangles.
    let records = Records {
        name: "triangle",
        number: "a triangle's number",
        count,
    };
    let mut first_triangle = 0;
    let (triangles, labels) = if has_attributes {
        let row = |line: &mut Line<'_>| Ok((corners(line)?, number(line, "an attribute")?));
        let rows = records.read(&mut lines, &mut first_triangle, row)?;
        let (triangles, attributes) = rows.into_iter().unzip();
        (triangles, Labels::Attributes(attributes))
    } else {
        let triangles = records.read(&mut lines, &mut first_triangle, corners)?;
        (triangles, Labels::Nothing)
    };
    if let Some(line) = lines.next_line() {
        let message = format!("the first line announces only {count} triangles");
        return Err(line.error(message));
    }

    // The vertices, whose numbers begin where the `.node` says, or where those of the triangles do.
    let vertices = node.map(|node| read_node(node, &mut Remarks::default()));
    let vertices = vertices.transpose()?;
    Ok(Corners {
        triangles,
        first: first_triangle,
        first_vertex: vertices
            .as_ref()
            .map_or(first_triangle, |vertices| vertices.first),
        is_soup: false,
        labels,
        vertices,
    })
}

/// Reads the corners of a triangle.
fn corners(line: &mut Line<'_>) -> Result<[usize; 3], ReadError> {
    let mut corner = || line.index("a vertex's number");
    Ok([corner()?, corner()?, corner()?])
}

/// Reads the holes, if the file goes on; they are numbered from 0 or 1, or, if there are none, from `first`.
fn read_holes<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    mut first: usize,
) -> Result<Vertices<'a>, ReadError> {
    let records = Records {
        name: "hole",
        number: "a hole's number",
        count: seed_count(lines, "a number of holes")?,
    };
    let coordinates = records.read(lines, &mut first, Line::coordinates)?;
    Ok(seeds(source, coordinates, first))
}

/// Reads the regions, likewise, their attributes, and the areas that may follow.
fn read_regions<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    mut first: usize,
) -> Result<(Vertices<'a>, Vec<f64>, Vec<f64>), ReadError> {
    let records = Records {
        name: "region",
        number: "a region's number",
        count: seed_count(lines, "a number of regions")?,
    };
    let regions = records.read(lines, &mut first, |line| {
        let coordinates = line.coordinates()?;
        let [attribute, area] = [number(line, "an attribute")?, number(line, "an area")?];
        Ok((coordinates, attribute, area))
    })?;
    let attributes = regions.iter().map(|&(_, attribute, _)| attribute).collect();
    let areas = regions.iter().map(|&(.., area)| area).collect();
    let coordinates = regions.iter().map(|&(coordinates, ..)| coordinates);
    Ok((
        seeds(source, coordinates.collect(), first),
        attributes,
        areas,
    ))
}

/// The number in the next line, or 0 if there is none.
fn seed_count(lines: &mut Lines<'_>, what: &str) -> Result<usize, ReadError> {
    let line = lines.next_line();
    line.map_or(Ok(0), |mut line| line.index(what))
}

/// The next number, or 0 if the line ends.
fn number(line: &mut Line<'_>, what: &str) -> Result<f64, ReadError> {
    let Some(token) = line.token() else {
        return Ok(0.0);
    };
    let value = f64::from_text(&String::from_utf8_lossy(token)).ok();
    let value = value.filter(|value| value.is_finite());
    value.ok_or_else(|| line.error(format!("{} is not {what}, a number", quoted(token))))
}

fn seeds<'a>(source: &'a Source, coordinates: Vec<[&'a [u8]; 2]>, first: usize) -> Vertices<'a> {
    Vertices::plain(source, coordinates, first)
}
