//! What the two readers of Gmsh's `.msh` share: nodes by their numbers, elements by their types.

use std::collections::HashMap;

use crate::read::content::{Syntax, Vertices};
use crate::read::mesh::{Cells, Mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};

/// The contents of a file whose coordinates stand so.
pub(super) fn mesh<'a>(
    source: &'a Source,
    syntax: Syntax,
    nodes: Option<Nodes<'a>>,
    mut cells: Cells,
    remarks: Remarks,
) -> Result<Mesh<'a>, ReadError> {
    // Groups that are all 0 are none.
    if cells.regions.iter().all(|&region| region == 0.0) {
        cells.regions.clear();
    }
    let Some(nodes) = nodes else {
        return Err(ReadError::of_file(&source.name, "there are no `$Nodes`"));
    };
    let vertices = Vertices {
        syntax,
        ..Vertices::plain(source, nodes.coordinates, nodes.first)
    };
    Ok(Mesh {
        vertices: vertices.with_heights(&nodes.heights),
        cells,
        first: 1,
        remarks,
    })
}

/// Whether a version has blocks of nodes and elements.
pub(super) fn has_blocks(version: &[u8]) -> Result<bool, String> {
    match version {
        b"4.1" => Ok(true),
        _ if version.starts_with(b"2") => Ok(false),
        _ => Err(format!(
            "the version is {}, and only 2 and 4.1 are read",
            quoted(version)
        )),
    }
}

/// The nodes of a file.
#[derive(Default)]
pub(super) struct Nodes<'a> {
    pub(super) coordinates: Vec<[&'a [u8]; 2]>,
    pub(super) heights: Vec<Option<&'a [u8]>>,
    /// The number of the first one.
    first: usize,
    /// The places of nodes that are not numbered one after the other.
    places: HashMap<usize, usize>,
}

impl Nodes<'_> {
    /// Gives the nodes their numbers.
    pub(super) fn number(&mut self, numbers: &[usize]) -> Result<(), &'static str> {
        self.first = numbers.first().map_or(1, |&first| first.min(1));
        let mut counted = numbers.iter().zip(self.first..);
        if counted.any(|(&number, expected)| number != expected) {
            self.first = 1;
            self.places = numbers.iter().copied().zip(1..).collect();
            if self.places.len() < numbers.len() {
                return Err("two nodes have the same number");
            }
        }
        Ok(())
    }

    /// The node of a number, counted from `first`.
    pub(super) fn place(&self, number: usize) -> Result<usize, String> {
        if self.places.is_empty() {
            return Ok(number);
        }
        let place = self.places.get(&number).copied();
        place.ok_or_else(|| format!("there is no node {number}"))
    }
}

/// Adds an element of one of Gmsh's types and of a physical group, 0 for none, whose nodes `next` returns.
pub(super) fn add_element(
    kind: usize,
    group: i64,
    mut next: impl FnMut() -> Result<usize, ReadError>,
    cells: &mut Cells,
    error: impl FnOnce(String) -> ReadError,
) -> Result<(), ReadError> {
    match kind {
        1 => {
            cells.lines.push([next()?, next()?]);
            cells.markers.push(group);
        }
        8 => {
            let [from, to] = [next()?, next()?];
            let between = next()?;
            cells.lines.extend([[from, between], [between, to]]);
            cells.markers.extend([group; 2]);
        }
        2 => {
            cells.faces.triangles.push([next()?, next()?, next()?]);
            cells.regions.push(group as f64);
        }
        15 if group != 0 => cells.vertex_markers.push((next()?, group)),
        15 => {}
        _ => cells.refuse(|| {
            error(format!(
                "elements of type {kind} are not read, only triangles (2)"
            ))
        }),
    }
    Ok(())
}
