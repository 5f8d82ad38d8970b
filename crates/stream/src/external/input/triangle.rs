//! Triangle's `.node` and `.poly`, read in pieces.
//!
//! ```text
//! .node    <vertices> 2 <attributes> <markers>        counts; only the first one is needed
//!          <vertex> <x> <y> [attributes] [marker]     numbered from 0 or from 1
//!
//! .poly    as .node; 0 vertices: they are in the .node beside it
//!          <segments> <markers>
//!          <segment> <vertex> <vertex> [marker]       numbered from 0 or from 1
//! ```
//!
//! Numbers must be consecutive, as where the file is in memory. The first attribute is the height of a vertex. Attributes
//! and markers are read as far as they are asked for. All that follows on a line is read over, and so are holes and regions.

use std::path::Path;

use sweep_cdt_formats::{Column, ReadError, Remark, quoted};

use crate::external::input::file::InputFile;
use crate::external::input::lines::{Line, Lines, coordinate};
use crate::external::input::{Choice, Input, MOST_COLUMNS, Part};

/// How many records are read at once.
const RECORDS: u64 = 1 << 13;

/// Vertices, and maybe edges.
#[derive(Debug)]
pub(super) struct Triangle {
    /// The file with the vertices, and that with the edges if it is another one.
    vertices: Lines,
    edges: Option<Lines>,
    has_edges: bool,
    vertex: Records,
    /// Unknown until all vertices are read.
    edge: Option<Records>,
    /// How many attributes and markers each vertex has.
    others: [u64; 2],
    /// The attributes and markers of the vertices that came last, as far as they are asked for: heights first.
    columns: Vec<Column>,
    has_heights: bool,
}

/// Records of one kind, with consecutive numbers.
#[derive(Debug)]
struct Records {
    /// The name of a record in messages.
    name: &'static str,
    /// The name of its number there.
    number: &'static str,
    /// How many there must be, and how many are read.
    count: u64,
    read: u64,
    /// The number of the first one: 0 or 1.
    first: u64,
}

impl Records {
    /// Appends what `read` makes of the rest of the next lines, some of them or all that are left.
    fn next<T>(
        &mut self,
        lines: &mut Lines,
        list: &mut Vec<T>,
        mut read: impl FnMut(&mut Line<'_>) -> Result<T, ReadError>,
    ) -> Result<(), ReadError> {
        let end = self.count.min(self.read + RECORDS);
        while self.read < end {
            let mut line = lines.expect(|| {
                let Records { name, count, .. } = self;
                format!("{name} {} of {count}", self.read + 1)
            })?;
            let number = index(&mut line, self.number)?;
            if self.read == 0 {
                if number > 1 {
                    return Err(line.error(format!("the first number is {number}, not 0 or 1")));
                }
                self.first = number;
            }
            let expected = self.read + self.first;
            if number != expected {
                return Err(line.error(format!("the number is {number}, not {expected}")));
            }
            list.push(read(&mut line)?);
            self.read += 1;
        }
        Ok(())
    }
}

impl Triangle {
    /// Begins a `.node`.
    pub(super) fn of_node(file: InputFile, choice: &Choice) -> Result<Triangle, ReadError> {
        let mut vertices = Lines::new(file, 0);
        let counts = vertex_count(&mut vertices)?;
        Ok(Triangle::new(vertices, None, false, counts, choice))
    }

    /// Begins a `.poly`; `node` is the place of the `.node` beside it, if there is such a place.
    pub(super) fn of_poly(
        file: InputFile,
        node: Option<&Path>,
        choice: &Choice,
    ) -> Result<Triangle, ReadError> {
        let mut vertices = Lines::new(file, 0);
        let counts = vertex_count(&mut vertices)?;
        if counts.0 > 0 {
            return Ok(Triangle::new(vertices, None, true, counts, choice));
        }
        let Some(node) = node else {
            let message = "there are no vertices: they are in a .node beside the file, and this one has no place";
            return Err(vertices.file.error(message));
        };
        let edges = vertices;
        let mut vertices = Lines::new(InputFile::open(node)?, 0);
        let counts = vertex_count(&mut vertices)?;
        Ok(Triangle::new(vertices, Some(edges), true, counts, choice))
    }

    fn new(
        vertices: Lines,
        edges: Option<Lines>,
        has_edges: bool,
        (count, others): (u64, [u64; 2]),
        choice: &Choice,
    ) -> Triangle {
        let most = if choice.others { MOST_COLUMNS } else { 1 };
        let [attributes, markers] = others.map(|count| usize::try_from(count).unwrap_or(most));
        let is_height = |at: usize| at == 0 && attributes > 0;
        let names = (0..attributes.saturating_add(markers.min(1)).min(most)).map(|at| match at {
            _ if at == attributes => Column::MARKER.to_owned(),
            0 => Column::HEIGHT.to_owned(),
            _ => format!("attribute{}", at + 1),
        });
        let names = names.enumerate();
        let asked = names.map_while(|(at, name)| {
            let is_asked = if is_height(at) {
                choice.heights
            } else {
                choice.others
            };
            let values = Vec::new();
            is_asked.then_some(Column { name, values })
        });
        let columns: Vec<Column> = asked.collect();
        Triangle {
            vertices,
            edges,
            has_edges,
            vertex: Records {
                name: "vertex",
                number: "a vertex's number",
                count,
                read: 0,
                first: 0,
            },
            edge: None,
            others,
            has_heights: columns.iter().any(|column| column.name == Column::HEIGHT),
            columns,
        }
    }

    /// The file that is read now.
    fn file(&self) -> &InputFile {
        match &self.edges {
            Some(lines) if self.edge.is_some() => &lines.file,
            _ => &self.vertices.file,
        }
    }
}

/// The number of vertices in the first line, and how many attributes and markers each has.
fn vertex_count(lines: &mut Lines) -> Result<(u64, [u64; 2]), ReadError> {
    let mut line = lines.expect(|| "the number of vertices".to_owned())?;
    let count = index(&mut line, "a number of vertices")?;
    match line.token() {
        None | Some(b"2") => {
            let mut number = || std::str::from_utf8(line.token()?).ok()?.parse().ok();
            Ok((count, [number().unwrap_or(0), number().unwrap_or(0)]))
        }
        Some(b"3") => Err(line.error(
            "3 coordinates are announced, and only x and y are read: leave out z and announce 2",
        )),
        Some(other) => {
            let shown = quoted(other);
            Err(line.error(format!("{shown} is not 2, the number of coordinates")))
        }
    }
}

/// The next token as a whole number; `what` it is stands in the message if it is none.
fn index(line: &mut Line<'_>, what: &str) -> Result<u64, ReadError> {
    let token = line.expect(what)?;
    let text = std::str::from_utf8(token).ok();
    text.and_then(|text| text.parse().ok())
        .ok_or_else(|| line.error(format!("{} is not {what}", quoted(token))))
}

impl Input for Triangle {
    fn name(&self) -> &str {
        &self.file().name
    }

    fn part(&self) -> Part {
        let first_edge = self.edge.as_ref().map_or(0, |edge| edge.first);
        Part {
            first: [self.vertex.first, first_edge],
            ..Part::default()
        }
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let Triangle {
            vertices,
            vertex,
            columns,
            ..
        } = self;
        for column in &mut *columns {
            column.values.clear();
        }
        if vertex.read < vertex.count {
            return vertex.next(vertices, points, |line| {
                let value = |line: &mut Line<'_>, what| {
                    let token = line.expect(what)?;
                    coordinate(token, |why| line.error(why))
                };
                let point = [
                    value(line, "an x coordinate")?,
                    value(line, "a y coordinate")?,
                ];
                for column in &mut *columns {
                    // Triangle lets lines end before the marker.
                    let is_there = column.name != Column::MARKER || !line.is_over();
                    let number = match is_there {
                        true => value(line, "an attribute")?,
                        false => f64::NAN,
                    };
                    column.values.push(number);
                }
                Ok(point)
            });
        }
        let is_node = !self.has_edges || self.edges.is_some();
        if is_node && vertices.advance()? {
            let count = vertex.count;
            let message = format!("the first line announces only {count} vertices");
            return Err(vertices.line().error(message));
        }
        vertices.file.check()
    }

    fn heights(&self) -> Option<&[f64]> {
        let heights = self.columns.first().filter(|_| self.has_heights);
        heights.map(|column| &column.values[..])
    }

    fn columns(&self) -> &[Column] {
        &self.columns[usize::from(self.has_heights)..]
    }

    fn has_edges(&self) -> bool {
        self.has_edges
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        if !self.has_edges {
            return Ok(());
        }
        let lines = self.edges.as_mut().unwrap_or(&mut self.vertices);
        let edge = match &mut self.edge {
            Some(edge) => edge,
            none => {
                let mut line = lines.expect(|| "the number of edges".to_owned())?;
                none.insert(Records {
                    name: "edge",
                    number: "an edge's number",
                    count: index(&mut line, "a number of edges")?,
                    read: 0,
                    first: 0,
                })
            }
        };
        if edge.read == edge.count {
            return lines.file.check();
        }
        let first = self.vertex.first;
        edge.next(lines, edges, |line| {
            let mut end = || {
                let number = index(line, "a vertex's number")?;
                number.checked_sub(first).ok_or_else(|| {
                    line.error("vertex 0 does not exist: the vertices are numbered from 1")
                })
            };
            Ok([end()?, end()?])
        })
    }

    fn remarks(&self) -> Vec<Remark> {
        let [attributes, markers] = self.others.map(|count| usize::try_from(count).unwrap_or(0));
        let marked = self
            .columns
            .iter()
            .filter(|column| column.name == Column::MARKER);
        let marked = marked.count();
        let attributes = attributes.saturating_sub(self.columns.len() - marked);
        let markers = markers.saturating_sub(marked);
        [
            (
                attributes,
                "attribute of each vertex",
                "attributes of each vertex",
            ),
            (markers, "marker of each vertex", "markers of each vertex"),
        ]
        .into_iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| Remark::ignored(count, one, many))
        .collect()
    }

    fn has_heights(&self) -> bool {
        self.others[0] > 0
    }

    fn progress(&self) -> (u64, u64) {
        let files = [Some(&self.vertices), self.edges.as_ref()];
        let files = files.into_iter().flatten().map(|lines| &lines.file);
        files.fold((0, 0), |(done, all), file| {
            (done + file.at, all + file.length)
        })
    }
}
