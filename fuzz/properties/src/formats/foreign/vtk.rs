//! `.vtk` in forms that the crate does not write.

use std::io::Write;

use super::meant::Meant;
use super::numbers::{Form, Kind, Order};

/// Files are written to memory, which takes all of them.
const GROWS: &str = "memory takes it";

/// VTK's legacy format: polygons or strips beside lines, or cells of all types; counts or offsets.
pub(super) fn write(meant: &Meant, style: u8, number: u8) -> Vec<u8> {
    let (order, encoding) = match style & 1 {
        0 => (Order::Text, "ASCII"),
        _ => (Order::MostSignificantFirst, "BINARY"),
    };
    let form = |kind| Form { kind, order };
    let mut all = meant.points.as_flattened().to_vec();
    all.extend(&meant.heights);
    let place = form(Kind::holding(number, &all));
    let has_offsets = style & 2 != 0;
    let is_polydata = style & 4 != 0;

    let version = if has_offsets { "5.1" } else { "3.0" };
    let mut file = Vec::new();
    writeln!(
        file,
        "# vtk DataFile Version {version}\nof nobody\n{encoding}"
    )
    .expect(GROWS);
    let kind = if is_polydata {
        "POLYDATA"
    } else {
        "UNSTRUCTURED_GRID"
    };
    let count = meant.points.len();
    writeln!(
        file,
        "DATASET {kind}\nPOINTS {count} {}",
        name_of(place.kind)
    )
    .expect(GROWS);
    for (v, [x, y]) in meant.points.iter().enumerate() {
        let height = meant.heights.get(v).copied().unwrap_or(0.0);
        [*x, *y, height]
            .into_iter()
            .for_each(|x| place.put(x, &mut file));
    }
    file.push(b'\n');
    let Cells { list, types, lines } = Cells::of(meant, style);
    if is_polydata {
        let (lines, faces) = list.split_at(lines);
        let name = if has_strips(style) {
            "TRIANGLE_STRIPS"
        } else {
            "POLYGONS"
        };
        cells("LINES", lines, form, has_offsets, &mut file);
        cells(name, faces, form, has_offsets, &mut file);
        return file;
    }
    cells("CELLS", &list, form, has_offsets, &mut file);
    writeln!(file, "CELL_TYPES {}", types.len()).expect(GROWS);
    form(Kind::I32).put_indices(&types, &mut file);
    file.push(b'\n');
    file
}

/// The meant faces as cells of VTK's types.
pub(super) struct Cells {
    pub(super) list: Vec<Vec<usize>>,
    pub(super) types: Vec<usize>,
    /// How many of them are lines; they are the first.
    lines: usize,
}

impl Cells {
    /// Lines or polylines, then triangles, polygons or strips.
    pub(super) fn of(meant: &Meant, style: u8) -> Cells {
        let lines = if style & 8 != 0 {
            polylines(&meant.edges)
        } else {
            meant.edges.iter().map(|edge| edge.to_vec()).collect()
        };
        let faces = if has_strips(style) {
            strips(&meant.triangles)
        } else {
            meant.triangles.iter().map(|t| t.to_vec()).collect()
        };
        let line = |cell: &Vec<usize>| if cell.len() == 2 { 3 } else { 4 };
        let face = match (has_strips(style), style & 32) {
            (true, _) => 6,
            (false, 0) => 5,
            (false, _) => 7,
        };
        let mut types: Vec<usize> = lines.iter().map(line).collect();
        types.resize(lines.len() + faces.len(), face);
        Cells {
            types,
            lines: lines.len(),
            list: [lines, faces].concat(),
        }
    }
}

fn has_strips(style: u8) -> bool {
    style & 16 != 0
}

fn name_of(kind: Kind) -> &'static str {
    match kind {
        Kind::I8 => "char",
        Kind::U8 => "unsigned_char",
        Kind::I16 => "short",
        Kind::U16 => "unsigned_short",
        Kind::I32 => "int",
        Kind::U32 => "unsigned_int",
        Kind::I64 => "vtktypeint64",
        Kind::F32 => "float",
        Kind::F64 => "double",
    }
}

/// Appends cells: each with its count before it, or the offsets of all and then their corners.
fn cells(
    name: &str,
    cells: &[Vec<usize>],
    form: impl Fn(Kind) -> Form,
    has_offsets: bool,
    file: &mut Vec<u8>,
) {
    let corners = cells.concat();
    if !has_offsets {
        writeln!(
            file,
            "{name} {} {}",
            cells.len(),
            cells.len() + corners.len()
        )
        .expect(GROWS);
        for cell in cells {
            form(Kind::I32).put_indices(&[cell.len()], file);
            form(Kind::I32).put_indices(cell, file);
        }
        file.push(b'\n');
        return;
    }
    let ends = (0..=cells.len()).map(|count| cells[..count].concat().len());
    let ends: Vec<usize> = ends.collect();
    writeln!(file, "{name} {} {}", ends.len(), corners.len()).expect(GROWS);
    for (name, array) in [("OFFSETS", ends), ("CONNECTIVITY", corners)] {
        writeln!(file, "{name} {}", name_of(Kind::I64)).expect(GROWS);
        form(Kind::I64).put_indices(&array, file);
        file.push(b'\n');
    }
}

/// Edges that begin where the one before ends, joined.
fn polylines(edges: &[[usize; 2]]) -> Vec<Vec<usize>> {
    let mut lines: Vec<Vec<usize>> = Vec::new();
    for &[a, b] in edges {
        match lines.last_mut().filter(|line| line.last() == Some(&a)) {
            Some(line) => line.push(b),
            None => lines.push(vec![a, b]),
        }
    }
    lines
}

/// Strips of triangles: each corner makes one with the two before it, every other one turned over.
fn strips(triangles: &[[usize; 3]]) -> Vec<Vec<usize>> {
    let mut left = triangles.to_vec();
    let mut strips = Vec::new();
    while let Some(corners) = left.pop() {
        let mut strip = corners.to_vec();
        loop {
            let [p, q] = [strip[strip.len() - 2], strip[strip.len() - 1]];
            let side = if strip.len().is_multiple_of(2) {
                [p, q]
            } else {
                [q, p]
            };
            let beyond = |t: &[usize; 3]| {
                let mut sides = (0..3).map(|i| [t[i], t[(i + 1) % 3], t[(i + 2) % 3]]);
                sides.find(|[a, b, _]| [*a, *b] == side)
            };
            let Some((at, [.., next])) =
                (left.iter().enumerate()).find_map(|(at, t)| Some((at, beyond(t)?)))
            else {
                break;
            };
            left.swap_remove(at);
            strip.push(next);
        }
        strips.push(strip);
    }
    strips
}
