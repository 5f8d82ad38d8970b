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
#[derive(Clone, Debug)]
pub struct Header<'a> {
    /// How the records stand in the file.
    pub encoding: Encoding,
    /// What follows, in this order.
    pub elements: Vec<Element<'a>>,
}

/// How the records stand in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// A line for each record.
    Text,
    /// The bytes of numbers.
    Binary {
        /// Whether the most significant byte comes first.
        big_endian: bool,
    },
}

/// As many records, each with these properties.
#[derive(Clone, Debug)]
pub struct Element<'a> {
    /// The name.
    pub name: &'a [u8],
    /// How many records there are.
    pub count: usize,
    /// The properties of a record, in this order.
    pub properties: Vec<Property<'a>>,
}

/// One value, or a list with its length before it.
#[derive(Clone, Debug)]
pub struct Property<'a> {
    /// The name.
    pub name: &'a [u8],
    /// The type of the value, or of the members of the list.
    pub kind: Kind,
    /// The type of the length, if it is a list.
    pub length: Option<Kind>,
}

impl Header<'_> {
    /// Reads a header; `source` may be the begin of a file alone. Returns also how many lines and how many bytes of
    /// `source` it has.
    ///
    /// ```
    /// use sweep_cdt_formats::{Source, ply::Header};
    ///
    /// let text = "ply\nformat ascii 1.0\nelement vertex 9\nproperty double x\nend_header\n0.5\n";
    /// let source = Source::new("a.ply", text);
    /// let (header, lines, bytes) = Header::read(&source)?;
    /// assert_eq!((header.elements[0].count, lines, &text[bytes..]), (9, 5, "0.5\n"));
    /// # Ok::<(), sweep_cdt_formats::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// The header is wrong, or `source` ends before it does.
    pub fn read(source: &Source) -> Result<(Header<'_>, usize, usize), ReadError> {
        let mut lines = Lines::new(source)?;
        let header = read(source, &mut lines)?;
        let bytes = source.bytes.len() - lines.rest().len();
        Ok((header, lines.count(), bytes))
    }
}

impl Element<'_> {
    /// The place of a property that has one of these names.
    #[must_use]
    pub fn place(&self, names: &[&[u8]]) -> Option<usize> {
        let mut properties = self.properties.iter();
        properties.position(|property| names.contains(&property.name))
    }
}

/// Reads the header, and leaves `lines` at what follows it.
pub(crate) fn read<'a>(source: &'a Source, lines: &mut Lines<'a>) -> Result<Header<'a>, ReadError> {
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
