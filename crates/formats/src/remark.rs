//! What a reader has to say about a file that it has read: what it left out, and what it had to decide.

use std::fmt;

/// Something about a file that its user should know.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Remark, Source, read};
///
/// let source = Source::new("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n");
/// let Input::Doubles(file) = read(Format::Obj, &source, None)? else {
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
    /// Heights stand in a property, or were asked for in one or in a column that is not there.
    HeightProperty {
        /// The name of the property or column.
        name: String,
        /// How many features have it: none if it is not there.
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

    /// The remark in words, with a name for the vertex in it.
    pub(crate) fn words(&self, name: impl Fn(usize) -> String) -> String {
        match self {
            Remark::Ignored { count, what } => format!("ignored: {count} {what}"),
            Remark::Conflict {
                column,
                vertex,
                values: [kept, other],
                count,
            } => {
                let more = match count.saturating_sub(1) {
                    0 => String::new(),
                    1 => "; another vertex has two, too".to_owned(),
                    more => format!("; {more} more vertices have two, too"),
                };
                let name = name(*vertex);
                format!(
                    "{name} has two numbers for {column}, {kept} and {other}: {kept} counts{more}"
                )
            }
            Remark::HeightProperty { name, count: 0 } => {
                format!("no property or column with heights is called `{name}`")
            }
            Remark::HeightProperty { name, count } => {
                let plural = if *count == 1 { "" } else { "s" };
                format!("heights are the property `{name}` of {count} feature{plural}")
            }
        }
    }
}

/// The vertices that have two numbers in a column, as they are found.
pub(crate) struct Conflicts {
    has_two: Vec<bool>,
    /// The first of them, the number that counts, and the other one.
    first: Option<(usize, [f64; 2])>,
}

impl Conflicts {
    /// None, of so many vertices.
    pub(crate) fn new(vertices: usize) -> Conflicts {
        Conflicts {
            has_two: vec![false; vertices],
            first: None,
        }
    }

    /// Adds a vertex with the number that counts and another one.
    pub(crate) fn add(&mut self, vertex: usize, values: [f64; 2]) {
        self.has_two[vertex] = true;
        self.first.get_or_insert((vertex, values));
    }

    /// What is to say about a column of this name.
    pub(crate) fn remark(self, column: &str) -> Option<Remark> {
        let (vertex, values) = self.first?;
        Some(Remark::Conflict {
            column: column.to_owned(),
            vertex,
            values,
            count: self.has_two.into_iter().filter(|&two| two).count(),
        })
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words(|vertex| format!("vertex {vertex}")))
    }
}
