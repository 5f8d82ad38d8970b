//! What a reader has to say about a file that it has read: what it left out, and what it had to decide.

use std::fmt;

/// Something about a file that its user should know.
///
/// ```
/// use sweep_cdt_formats::{Input, InputFormat, Remark, Source, read};
///
/// let source = Source::new("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n");
/// let Input::Doubles(file) = read(InputFormat::Obj, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.remarks, [Remark::ignored(1, "line of `vt`", "lines of `vt`")]);
/// assert_eq!(file.remarks[0].to_string(), "ignored: 1 line of `vt`");
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The file says something, and nothing is made of it.
    Ignored {
        /// How many there are.
        count: usize,
        /// The name of so many.
        what: String,
    },
    /// One place has two numbers in a column.
    Conflict {
        /// The name of the column.
        column: String,
        /// The vertex, as a position.
        vertex: usize,
        /// The number that counts, and the first other one.
        values: [f64; 2],
        /// How many places have two numbers.
        count: usize,
    },
    /// Heights stand in a property.
    HeightProperty {
        /// The name of the property.
        name: String,
        /// How many features have it.
        count: usize,
    },
}

impl Remark {
    /// So many things that are ignored, with the name of one and of many.
    pub fn ignored(count: usize, one: &str, many: &str) -> Remark {
        let what = if count == 1 { one } else { many }.to_owned();
        Remark::Ignored { count, what }
    }

    /// Whether something of the file gets lost.
    pub fn is_loss(&self) -> bool {
        !matches!(self, Remark::HeightProperty { .. })
    }

    /// The remark with another number for its vertex.
    #[must_use]
    pub fn renumbered(&self, first: usize) -> Remark {
        let mut remark = self.clone();
        if let Remark::Conflict { vertex, .. } = &mut remark {
            *vertex = vertex.saturating_add(first);
        }
        remark
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Remark::Ignored { count, what } => write!(f, "ignored: {count} {what}"),
            Remark::Conflict {
                column,
                vertex,
                values: [kept, other],
                count,
            } => {
                write!(
                    f,
                    "vertex {vertex} has two numbers for {column}, {kept} and {other}"
                )?;
                write!(f, ": {kept} counts")?;
                match count - 1 {
                    0 => Ok(()),
                    1 => write!(f, "; another vertex has two, too"),
                    more => write!(f, "; {more} more vertices have two, too"),
                }
            }
            Remark::HeightProperty { name, count } => {
                if *count == 0 {
                    return write!(f, "no feature has the property `{name}`");
                }
                let plural = if *count == 1 { "" } else { "s" };
                write!(
                    f,
                    "heights are the property `{name}` of {count} feature{plural}"
                )
            }
        }
    }
}
