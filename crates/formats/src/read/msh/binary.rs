//! Gmsh's `.msh` as binary, of the versions 2 and 4.1.
//!
//! ```text
//! $MeshFormat
//! 2.2 1 8                   the version, 1 for binary, and the size of a number (in 4.1: of a count)
//! <1 as an int>             it tells the order of bytes
//! $EndMeshFormat
//! $Nodes                    version 2: <nodes> as text, then of each the number and x, y, z
//! $Elements                 version 2: <elements> as text, then blocks: type, elements, tags; and of each element the
//!                           number, tags and nodes
//! ```
//!
//! Version 4.1 has the blocks of the text (see `msh.rs`), with ints for dimensions, entities and types, and counts for all
//! else. Nodes on curves and surfaces may have parameters behind their places, which are read over. Other sections are
//! skipped up to their `$End`.

use crate::graph_file::whole;
use crate::read::binary::{Kind, Number};
use crate::read::content::Syntax;
use crate::read::mesh::{Cells, Mesh};
use crate::read::msh::parts::{Nodes, add_element, has_blocks, mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::words::Words;

/// How many nodes the elements of each type have, from type 1 on.
const NODES: [usize; 31] = [
    2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1, 8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5, 6,
    20, 35, 56,
];

/// Whether a file says that it is binary.
pub(super) fn is_in(source: &Source) -> Result<bool, ReadError> {
    let mut words = Words::new(source)?;
    let is_mesh = words.word() == Some(b"$MeshFormat");
    Ok(is_mesh && words.word().is_some() && words.word() == Some(b"1"))
}

/// Reads a binary `.msh`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    let mut body = Body::new(source)?;
    let mut nodes = None;
    let (mut cells, mut remarks) = (Cells::default(), Remarks::default());
    while let Some(section) = body.words.word() {
        body.words.line();
        match (section, &nodes) {
            (b"$Nodes", None) => nodes = Some(body.read_nodes()?),
            (b"$Elements", Some(nodes)) => body.read_elements(nodes, &mut cells)?,
            (b"$Nodes" | b"$Elements", _) => {
                let why = "stands where it should not: `$Nodes` come first, and once";
                return Err(body.words.error(section, why));
            }
            _ if section.starts_with(b"$") => {
                remarks.ignore_named(1, ["section", "sections"], section);
                let end = [b"$End", &section[1..]].concat();
                body.words
                    .skip_to(&end)
                    .ok_or_else(|| body.words.end(&quoted(&end)))?;
            }
            _ => return Err(body.words.error(section, "is not the name of a section")),
        }
        let end = [b"$End", &section[1..]].concat();
        match body.words.word() {
            Some(word) if word == end => {}
            _ => {
                let message = format!("{} does not follow behind its section", quoted(&end));
                return Err(ReadError::of_file(&source.name, message));
            }
        }
    }
    let syntax = body.syntax(Kind::F64);
    mesh(source, syntax, nodes, cells, remarks)
}

/// What follows in a file, and how its numbers stand.
struct Body<'a> {
    source: &'a Source,
    words: Words<'a>,
    has_blocks: bool,
    big_endian: bool,
    /// The type of counts and of numbers of nodes.
    count: Kind,
}

impl<'a> Body<'a> {
    /// Reads the section `$MeshFormat`.
    fn new(source: &'a Source) -> Result<Body<'a>, ReadError> {
        let mut words = Words::new(source)?;
        words.expect("`$MeshFormat`")?;
        let version = words.expect("the version")?;
        let error = |message: String| source.error_in_line(2, message);
        let has_blocks = has_blocks(version).map_err(error)?;
        words.expect("the type of the file")?;
        let count = match (has_blocks, words.index("the size of a number")?) {
            (false, 8) => Kind::I32,
            (true, 8) => Kind::I64,
            (true, 4) => Kind::U32,
            (_, size) => return Err(error(format!("numbers of {size} bytes are not read"))),
        };
        words.line();
        let big_endian = match words.bytes(4) {
            Some([1, 0, 0, 0]) => false,
            Some([0, 0, 0, 1]) => true,
            _ => {
                return Err(error(
                    "no int of 1 follows, which tells the order of bytes".to_owned(),
                ));
            }
        };
        if words.word() != Some(b"$EndMeshFormat") {
            return Err(words.end("`$EndMeshFormat`"));
        }
        Ok(Body {
            source,
            words,
            has_blocks,
            big_endian,
            count,
        })
    }

    fn syntax(&self, kind: Kind) -> Syntax {
        let big_endian = self.big_endian;
        Syntax::Binary(Number { kind, big_endian })
    }

    /// So many numbers of a type.
    fn take(
        &mut self,
        kind: Kind,
        count: Option<usize>,
        what: &str,
    ) -> Result<&'a [u8], ReadError> {
        let size = count.and_then(|count| count.checked_mul(kind.size()));
        let bytes = size.and_then(|size| self.words.bytes(size));
        bytes.ok_or_else(|| self.words.end(what))
    }

    /// The next number, a count or that of a node.
    fn index(&mut self, kind: Kind, what: &str) -> Result<usize, ReadError> {
        let piece = self.take(kind, Some(1), what)?;
        self.syntax(kind).index(piece).ok_or_else(|| {
            let text = self.syntax(kind).text(piece);
            ReadError::of_file(&self.source.name, format!("{text} is not {what}"))
        })
    }

    fn read_nodes(&mut self) -> Result<Nodes<'a>, ReadError> {
        const NODE: &str = "a node";
        let mut nodes = Nodes::default();
        let mut numbers = Vec::new();
        if self.has_blocks {
            for _ in 0..self.begin_blocks()? {
                let dimension = self.index(Kind::I32, "a dimension")?;
                self.take(Kind::I32, Some(1), "an entity")?;
                let is_parametric = self.index(Kind::I32, "whether nodes have parameters")? != 0;
                let size = self.index(self.count, "the size of a block")?;
                for _ in 0..size {
                    numbers.push(self.index(self.count, "a node's number")?);
                }
                let parameters = if is_parametric { dimension.min(3) } else { 0 };
                for _ in 0..size {
                    let place = self.take(Kind::F64, Some(3 + parameters), NODE)?;
                    push(&mut nodes, place);
                }
            }
        } else {
            let count = self.words.index("a number of nodes")?;
            self.words.line();
            for _ in 0..count {
                numbers.push(self.index(Kind::I32, "a node's number")?);
                push(&mut nodes, self.take(Kind::F64, Some(3), NODE)?);
            }
        }
        let numbered = nodes.number(&numbers);
        numbered.map_err(|message| ReadError::of_file(&self.source.name, message))?;
        Ok(nodes)
    }

    fn read_elements(&mut self, nodes: &Nodes<'_>, cells: &mut Cells) -> Result<(), ReadError> {
        if self.has_blocks {
            for _ in 0..self.begin_blocks()? {
                self.take(Kind::I32, Some(2), "an entity")?;
                let kind = self.index(Kind::I32, "a type of elements")?;
                let count = self.index(self.count, "the size of a block")?;
                self.read_block(kind, count, 0, nodes, cells)?;
            }
            return Ok(());
        }
        let mut left = self.words.index("a number of elements")?;
        self.words.line();
        while left > 0 {
            let kind = self.index(Kind::I32, "a type of elements")?;
            let count = self.index(Kind::I32, "the size of a block")?;
            let tags = self.index(Kind::I32, "a number of tags")?;
            self.read_block(kind, count, tags, nodes, cells)?;
            left = left.saturating_sub(count);
        }
        Ok(())
    }

    /// Reads the four counts before blocks; returns how many blocks there are.
    fn begin_blocks(&mut self) -> Result<usize, ReadError> {
        let count = self.index(self.count, "a number of blocks")?;
        self.take(self.count, Some(3), "the first block")?;
        Ok(count)
    }

    /// Reads elements of a type, with so many tags between their numbers and nodes.
    fn read_block(
        &mut self,
        kind: usize,
        count: usize,
        tags: usize,
        nodes: &Nodes<'_>,
        cells: &mut Cells,
    ) -> Result<(), ReadError> {
        let source = self.source;
        let error = |message: String| ReadError::of_file(&source.name, message);
        let corners = kind.checked_sub(1).and_then(|at| NODES.get(at));
        let corners =
            corners.ok_or_else(|| error(format!("elements of type {kind} are not known")))?;
        let numbers = tags.checked_add(1 + corners);
        let syntax = self.syntax(self.count);
        for _ in 0..count {
            let element = self.take(self.count, numbers, "an element")?;
            let mut numbers = element.chunks_exact(self.count.size()).skip(1);
            // The first tag is the physical group. Version 4.1 has none.
            let group = numbers.clone().next().filter(|_| tags > 0);
            let group = group
                .and_then(|piece| syntax.value(piece).ok())
                .and_then(whole);
            let group = group.unwrap_or_default();
            let mut corners = numbers.by_ref().skip(tags);
            let next = || {
                let number = corners.next().and_then(|piece| syntax.index(piece));
                let number =
                    number.ok_or_else(|| error("a node's number is negative".to_owned()))?;
                nodes.place(number).map_err(error)
            };
            add_element(kind, group, next, cells, error)?;
        }
        Ok(())
    }
}

/// Adds the node whose place these bytes begin with.
fn push<'a>(nodes: &mut Nodes<'a>, place: &'a [u8]) {
    nodes.coordinates.push([&place[..8], &place[8..16]]);
    nodes.heights.push(Some(&place[16..24]));
}
