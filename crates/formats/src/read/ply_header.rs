//! The header of a `.ply`: in lines of text what follows, and how.
//!
//! ```text
//! ply
//! format ascii 1.0                          or binary_little_endian, binary_big_endian
//! comment ...                               also obj_info
//! element <name> <count>
//! property <type> <name>                    of the element before
//! property list <type> <type> <name>
//! end_header
//! ```

use crate::read::binary::Kind;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::token_lines::{Line, Lines};

/// The contents of a header.
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
}

/// How the records stand in the file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Binary { big_endian: bool },
}

/// As many records, each with these properties.
pub(super) struct Element<'a> {
    pub(super) name: &'a [u8],
    pub(super) count: usize,
    pub(super) properties: Vec<Property<'a>>,
}

/// One value, or a list with its length before it.
pub(super) struct Property<'a> {
    pub(super) name: &'a [u8],
    pub(super) kind: Kind,
    pub(super) length: Option<Kind>,
}

impl Element<'_> {
    /// The place of a property.
    pub(super) fn place(&self, names: &[&[u8]]) -> Option<usize> {
        let mut properties = self.properties.iter();
        properties.position(|property| names.contains(&property.name))
    }
}

/// Reads the header, and leaves `lines` at what follows it.
pub(super) fn read<'a>(source: &'a Source, lines: &mut Lines<'a>) -> Result<Header<'a>, ReadError> {
    let missing = |what: &'static str| move || what.to_owned();
    let mut first = lines.expect_line(missing("`ply`"))?;
    if first.token() != Some(b"ply") {
        return Err(first.error("the file does not begin with `ply`"));
    }
    let mut encoding = None;
    let mut elements: Vec<Element<'_>> = Vec::new();
    loop {
        let mut line = lines.expect_line(missing("`end_header`"))?;
        match line.expect_token("a keyword")? {
            b"format" => encoding = Some(read_encoding(&mut line)?),
            b"comment" | b"obj_info" => {}
            b"element" => elements.push(Element {
                name: line.expect_token("the name of an element")?,
                count: line.index("a number of records")?,
                properties: Vec::new(),
            }),
            b"property" => {
                let property = read_property(&mut line)?;
                let Some(element) = elements.last_mut() else {
                    return Err(line.error("the property stands before all elements"));
                };
                element.properties.push(property);
            }
            b"end_header" => break,
            other => {
                let shown = quoted(other);
                return Err(line.error(format!("{shown} is no keyword of a header")));
            }
        }
    }
    let missing = || ReadError::of_file(&source.name, "the header has no `format`");
    Ok(Header {
        encoding: encoding.ok_or_else(missing)?,
        elements,
    })
}

fn read_encoding(line: &mut Line<'_>) -> Result<Encoding, ReadError> {
    match line.expect_token("a format")? {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::Binary { big_endian: false }),
        b"binary_big_endian" => Ok(Encoding::Binary { big_endian: true }),
        other => Err(line.error(format!(
            "{} is not ascii, binary_little_endian or binary_big_endian",
            quoted(other)
        ))),
    }
}

fn read_property<'a>(line: &mut Line<'a>) -> Result<Property<'a>, ReadError> {
    let mut behind = line.clone();
    let length = if behind.token() == Some(b"list") {
        *line = behind;
        Some(read_kind(line)?)
    } else {
        None
    };
    Ok(Property {
        length,
        kind: read_kind(line)?,
        name: line.expect_token("the name of a property")?,
    })
}

fn read_kind(line: &mut Line<'_>) -> Result<Kind, ReadError> {
    match line.expect_token("a type")? {
        b"char" | b"int8" => Ok(Kind::I8),
        b"uchar" | b"uint8" => Ok(Kind::U8),
        b"short" | b"int16" => Ok(Kind::I16),
        b"ushort" | b"uint16" => Ok(Kind::U16),
        b"int" | b"int32" => Ok(Kind::I32),
        b"uint" | b"uint32" => Ok(Kind::U32),
        b"float" | b"float32" => Ok(Kind::F32),
        b"double" | b"float64" => Ok(Kind::F64),
        other => Err(line.error(format!("{} is not a type", quoted(other)))),
    }
}
