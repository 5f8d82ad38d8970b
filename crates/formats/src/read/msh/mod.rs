//! Gmsh's `.msh` of the versions 2 and 4.1, as text or binary (see `binary.rs`; `parts.rs` has what both share): nodes, and the elements that are
//! lines and triangles.
//!
//! ```text
//! $MeshFormat                                   $MeshFormat
//! 2.2 0 8                                       4.1 0 8
//! $EndMeshFormat                                $EndMeshFormat
//! $Nodes                                        $Nodes
//! <nodes>                                       <blocks> <nodes> <least> <greatest>
//! <node> <x> <y> <z>                            <dimension> <entity> <parametric> <nodes>      a block
//! $EndNodes                                     <node>                                         all of its nodes
//!                                               <x> <y> <z>                                    and then their places
//! $Elements                                     $EndNodes and $Elements
//! <elements>                                    <blocks> <elements> <least> <greatest>
//! <element> <type> <tags> [tags] <node> ...     <dimension> <entity> <type> <elements>         a block
//! $EndElements                                  <element> <node> ...                           all of its elements
//! ```
//!
//! Elements of type 1 are lines, of type 2 triangles, of type 8 lines of second order: two ends, and a node between them
//! that the line goes through. The first tag of a line is its marker, that of a point (15) the marker of its node, that of a
//! triangle its region: the physical group. (Version 4.1 has no tags.) Nodes that are not numbered from 0 or 1 in the
//! order of the file are numbered from 1 on. Other sections, data of the nodes for instance, are ignored with a remark.

mod binary;
mod parts;

use crate::read::content::Syntax;
use crate::read::mesh::{Cells, Mesh};
use crate::read::msh::parts::{Nodes, add_element, has_blocks, mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::token_lines::{Line, Lines};

const NODE: &str = "a node's number";

/// Reads a `.msh`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    if binary::is_in(source)? {
        return binary::read(source);
    }
    let mut lines = Lines::new(source)?;
    let mut has_blocks = None;
    let mut nodes = None;
    let (mut cells, mut remarks) = (Cells::default(), Remarks::default());
    while let Some(mut line) = lines.next_line() {
        let section = line.expect_token("a section")?;
        match (section, has_blocks, &nodes) {
            (b"$MeshFormat", ..) => has_blocks = Some(read_version(&mut lines)?),
            (b"$Nodes", Some(has_blocks), None) => {
                nodes = Some(Nodes::read(has_blocks, &mut lines)?);
            }
            (b"$Elements", Some(has_blocks), Some(nodes)) => {
                read_elements(has_blocks, nodes, &mut cells, &mut lines)?;
            }
            (b"$NOD", None, _) => {
                let message =
                    "the version is 1, and only 2 and 4.1 are read: save it again with Gmsh";
                return Err(line.error(message));
            }
            (b"$ParametricNodes", ..) => {
                let message = "the section `$ParametricNodes` is not read: save the mesh again without parametric coordinates";
                return Err(line.error(message));
            }
            (b"$Nodes" | b"$Elements", ..) => {
                return Err(
                    line.error("`$MeshFormat`, `$Nodes` and `$Elements` come once, in this order")
                );
            }
            _ if section.starts_with(b"$") => {
                remarks.ignore_named(1, ["section", "sections"], section);
            }
            _ => {
                return Err(line.error(format!("{} is not the name of a section", quoted(section))));
            }
        }
        let end = [b"$End", section.get(1..).unwrap_or_default()].concat();
        let is_read = [&b"$MeshFormat"[..], b"$Nodes", b"$Elements"].contains(&section);
        loop {
            let shown = || quoted(&end);
            let mut line = lines.expect_line(shown)?;
            match line.token() {
                Some(token) if token == end => break,
                Some(token) if is_read => {
                    return Err(line.error(format!(
                        "{} stands where {} should",
                        quoted(token),
                        shown()
                    )));
                }
                _ => {}
            }
        }
    }
    mesh(source, Syntax::Plain, nodes, cells, remarks)
}

/// Whether the version has blocks.
fn read_version(lines: &mut Lines<'_>) -> Result<bool, ReadError> {
    let mut line = lines.expect_line(|| "the version".to_owned())?;
    let version = line.expect_token("the version")?;
    let has_blocks = has_blocks(version).map_err(|message| line.error(message))?;
    match line.expect_token("the type of the file")? {
        b"0" => Ok(has_blocks),
        other => Err(line.error(format!(
            "the type of the file is {}, not 0 or 1",
            quoted(other)
        ))),
    }
}

impl<'a> Nodes<'a> {
    fn read(has_blocks: bool, lines: &mut Lines<'a>) -> Result<Nodes<'a>, ReadError> {
        let mut nodes = Nodes::default();
        let mut numbers = Vec::new();
        let missing = || "a node".to_owned();
        let mut line = lines.expect_line(missing)?;
        let count = line.index("a number of nodes or of blocks")?;
        if has_blocks {
            for _ in 0..count {
                let mut block = lines.expect_line(|| "a block of nodes".to_owned())?;
                let size = fourth(&mut block)?;
                for _ in 0..size {
                    numbers.push(lines.expect_line(missing)?.index(NODE)?);
                }
                for _ in 0..size {
                    nodes.push(&mut lines.expect_line(missing)?)?;
                }
            }
        } else {
            for _ in 0..count {
                let mut line = lines.expect_line(missing)?;
                numbers.push(line.index(NODE)?);
                nodes.push(&mut line)?;
            }
        }
        nodes
            .number(&numbers)
            .map_err(|message| line.error(message))?;
        Ok(nodes)
    }

    fn push(&mut self, line: &mut Line<'a>) -> Result<(), ReadError> {
        self.coordinates.push(line.coordinates()?);
        self.heights
            .push(Some(line.expect_token("a z coordinate")?));
        Ok(())
    }

    /// The node that the next token names.
    fn next(&self, line: &mut Line<'_>) -> Result<usize, ReadError> {
        let number = line.index(NODE)?;
        self.place(number).map_err(|message| line.error(message))
    }
}

fn read_elements(
    has_blocks: bool,
    nodes: &Nodes<'_>,
    cells: &mut Cells,
    lines: &mut Lines<'_>,
) -> Result<(), ReadError> {
    let missing = || "an element".to_owned();
    let count = lines
        .expect_line(missing)?
        .index("a number of elements or of blocks")?;
    for _ in 0..count {
        let mut line = lines.expect_line(missing)?;
        if has_blocks {
            let mut head = line.clone();
            for what in ["a dimension", "an entity"] {
                head.index(what)?;
            }
            let kind = head.index("a type of elements")?;
            for _ in 0..fourth(&mut line)? {
                let mut line = lines.expect_line(missing)?;
                line.index("an element's number")?;
                add(kind, 0, nodes, cells, &mut line)?;
            }
        } else {
            line.index("an element's number")?;
            let kind = line.index("a type of elements")?;
            let mut group = 0;
            for tag in 0..line.index("a number of tags")? {
                let token = line.expect_token("a tag")?;
                if tag == 0 {
                    let number = std::str::from_utf8(token).ok();
                    let number = number.and_then(|number| number.parse().ok());
                    let wrong =
                        || line.error(format!("{} is not a tag, a whole number", quoted(token)));
                    group = number.ok_or_else(wrong)?;
                }
            }
            add(kind, group, nodes, cells, &mut line)?;
        }
    }
    Ok(())
}

/// Adds the element of this physical group whose nodes follow in its line.
fn add(
    kind: usize,
    group: i64,
    nodes: &Nodes<'_>,
    cells: &mut Cells,
    line: &mut Line<'_>,
) -> Result<(), ReadError> {
    let error = line.clone();
    let next = || nodes.next(line);
    add_element(kind, group, next, cells, |message| error.error(message))
}

/// The fourth number of a line, how many things a block has.
fn fourth(line: &mut Line<'_>) -> Result<usize, ReadError> {
    for _ in 0..3 {
        line.expect_token("a number")?;
    }
    line.index("the size of a block")
}
