//! The fault of a JSON file that could not be read, and its place.
//!
//! A file that is right never comes here. One that is wrong is read once more, piece by piece.

use serde_json::value::RawValue;

use crate::read::json::pieces::{File, no_json};
use crate::read::source::{ReadError, Source, no_vertex, quoted};

/// The items that a file has lists of.
struct Kind {
    /// The names that the list may have; the first one is ours.
    members: &'static [&'static str],
    /// The name of an item in messages.
    item: &'static str,
    /// How many parts an item has, and how many at most.
    parts: usize,
    most: usize,
    /// The name of several.
    part: &'static str,
    /// The advice about one part more.
    advice: &'static str,
}

const POINTS: Kind = Kind {
    members: &["points", "vertices"],
    item: "a point",
    parts: 2,
    most: 3,
    part: "coordinates",
    advice: ": leave out all but x, y and z",
};

const EDGES: Kind = Kind {
    members: &["edges", "segments"],
    item: "an edge",
    parts: 2,
    most: 2,
    part: "ends",
    advice: ": split it into edges",
};

const TRIANGLES: Kind = Kind {
    members: &["triangles", "simplices", "faces"],
    item: "a triangle",
    parts: 3,
    most: 3,
    part: "corners",
    advice: ": split it into triangles",
};

/// The fault of a file that should hold a graph.
pub(super) fn of_graph(source: &Source, error: &serde_json::Error) -> ReadError {
    let find = |file: &File<'_>| {
        for point in file.list(&POINTS)?.ok_or_else(|| file.without(&POINTS))? {
            file.parts(&POINTS, point)?;
        }
        for edge in file.list(&EDGES)?.unwrap_or_default() {
            file.numbers(&EDGES, edge)?;
        }
        Ok(())
    };
    found(source, error, find)
}

/// The fault of a file that should hold triangles.
pub(super) fn of_triangles(source: &Source, error: &serde_json::Error) -> ReadError {
    let find = |file: &File<'_>| {
        let list = file.list(&TRIANGLES)?;
        let list = list.ok_or_else(|| file.without(&TRIANGLES))?;
        if list.first().is_some_and(|item| item.get().starts_with('[')) {
            for item in list {
                file.numbers(&TRIANGLES, item)?;
            }
        } else {
            for &corner in &list {
                file.number(corner)?;
            }
            if let (Some(&last), false) = (list.last(), list.len().is_multiple_of(3)) {
                let count = list.len();
                let message = format!("the {count} corners in one list do not make triangles");
                return Err(file.fault(last, message));
            }
        }
        for point in file.list(&POINTS)?.unwrap_or_default() {
            file.parts(&POINTS, point)?;
        }
        Ok(())
    };
    found(source, error, find)
}

/// The error that a file holds a list in place of an object.
pub(super) fn of_list(source: &Source) -> ReadError {
    let message =
        "a list stands where an object with named lists should, such as {\"points\": [...]}";
    ReadError::of_file(&source.name, message)
}

/// The error that an edge has an end that does not exist.
pub(super) fn of_ends(source: &Source, edges: &[[usize; 2]], count: usize) -> ReadError {
    let from_one = edges
        .as_flattened()
        .iter()
        .all(|vertex| (1..=count).contains(vertex));
    let find = |file: &File<'_>| {
        for edge in file.list(&EDGES)?.unwrap_or_default() {
            for end in file.parts(&EDGES, edge)? {
                let number = file.number(end)?;
                if number >= count {
                    let advice = if from_one {
                        "; subtract 1 from each"
                    } else {
                        ""
                    };
                    let message = no_vertex(number, 0, count) + advice;
                    return Err(file.fault(end, message));
                }
            }
        }
        Ok(())
    };
    let file = File::new(source);
    file.and_then(|file| find(&file))
        .expect_err("an edge has an end that does not exist")
}

/// The first fault that is found, of a file that serde refused with this error.
fn found(
    source: &Source,
    error: &serde_json::Error,
    find: impl FnOnce(&File<'_>) -> Result<(), ReadError>,
) -> ReadError {
    let fault = File::new(source).and_then(|file| find(&file)).err();
    fault.unwrap_or_else(|| no_json(source, source.text().unwrap_or_default(), error))
}

impl<'a> File<'a> {
    /// The error that there is no list of this kind.
    fn without(&self, kind: &Kind) -> ReadError {
        self.fault(
            self.whole,
            format!("the object has no `{}`", kind.members[0]),
        )
    }

    /// The items of a list, if it is there.
    fn list(&self, kind: &Kind) -> Result<Option<Vec<&'a RawValue>>, ReadError> {
        let is_named = |(member, _): &&(String, _)| kind.members.contains(&member.as_str());
        let mut named = self.members.iter().filter(is_named);
        let Some((name, list)) = named.next() else {
            return Ok(None);
        };
        if let Some((other, again)) = named.next() {
            let message = match other == name {
                true => format!("`{name}` is there twice"),
                false => format!("`{other}` means the same as `{name}`, which is there, too"),
            };
            return Err(self.fault(again, message));
        }
        let items = serde_json::from_str(list.get());
        items.map_err(|_| self.fault(list, format!("`{name}` should be a list")))
    }

    /// The parts of an item.
    fn parts(&self, kind: &Kind, item: &'a RawValue) -> Result<Vec<&'a RawValue>, ReadError> {
        let Kind {
            item: name,
            parts: count,
            most,
            part,
            advice,
            ..
        } = kind;
        let parts: Result<Vec<&RawValue>, _> = serde_json::from_str(item.get());
        let parts = parts.map_err(|_| {
            let shown = quoted(item.get().as_bytes());
            self.fault(
                item,
                format!("{shown} is not {name}, a list of {count} {part}"),
            )
        })?;
        if (*count..=*most).contains(&parts.len()) {
            return Ok(parts);
        }
        let advice = if parts.len() == most + 1 { advice } else { "" };
        let message = format!(
            "{name} has {count} {part}, and this one {}{advice}",
            parts.len()
        );
        Err(self.fault(item, message))
    }

    /// The parts of an item that is made of vertices' numbers.
    fn numbers(&self, kind: &Kind, item: &'a RawValue) -> Result<(), ReadError> {
        let parts = self.parts(kind, item)?;
        parts
            .into_iter()
            .try_for_each(|part| self.number(part).map(|_| ()))
    }

    fn number(&self, part: &RawValue) -> Result<usize, ReadError> {
        serde_json::from_str(part.get()).map_err(|_| {
            let shown = quoted(part.get().as_bytes());
            self.fault(part, format!("{shown} is not a vertex's number"))
        })
    }
}
