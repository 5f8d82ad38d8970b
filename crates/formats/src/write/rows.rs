//! Triangle's formats, long lists of short lines: `.ele` and the `.node` that it refers to, and `.poly`. Columns are
//! attributes of the vertices, but for their markers.

use std::io::{self, Write};

use super::labels::Labels;
use crate::threads::in_turn;
use crate::{Column, Coordinate, GraphFile};
use sweep_cdt::Region;
use sweep_cdt::interior::Interior;

/// Writes the triangles inside with the vertices' numbers of the input, and, if the domain has regions or polygons, with
/// the attributes or features of these.
pub(super) fn write_ele<S>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let first = file.numbering.vertex;
    let triangles = interior.canonical_triangles();
    if !interior.has_regions() {
        return write_triangles(first, &triangles, out);
    }
    let labels = Labels::of(file, interior, &triangles);
    let attributes = labels.map_or(vec![0.0; triangles.len()], |labels| labels.values);
    writeln!(out, "{} 3 1", triangles.len())?;
    write_rows(out, triangles.len(), |t, text| {
        triangle(first, t, triangles[t], text);
        text.push(b' ');
        attributes[t].write_text(text);
        text.push(b'\n');
    })
}

/// Writes triangles without attributes; they and the vertices are numbered from `first`.
pub(super) fn write_triangles(
    first: usize,
    triangles: &[[usize; 3]],
    out: &mut impl Write,
) -> io::Result<()> {
    writeln!(out, "{} 3 0", triangles.len())?;
    write_rows(out, triangles.len(), |t, text| {
        triangle(first, t, triangles[t], text);
        text.push(b'\n');
    })
}

/// Appends the number of a triangle and its corners.
fn triangle(first: usize, t: usize, [a, b, c]: [usize; 3], text: &mut Vec<u8>) {
    numbers([t, a, b, c].map(|number| number + first), text);
}

/// Writes the vertices as a `.node`.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{GraphFile, Numbering, write_node};
///
/// let graph = Pslg { points: vec![[0.5, 2.0]], ..Pslg::default() };
/// let file = GraphFile { numbering: Numbering::FROM_ONE, ..graph.into() };
/// let mut text = Vec::new();
/// write_node(&file, &mut text)?;
/// assert_eq!(text, b"1 2 0 0\n1 0.5 2\n");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_node<S: Coordinate>(file: &GraphFile<S>, out: &mut impl Write) -> io::Result<()> {
    let markers = file.vertex_markers();
    let is_attribute = |column: &&Column| column.name != Column::MARKER || markers.is_none();
    let attributes: Vec<&Column> = file.columns.iter().filter(is_attribute).collect();
    writeln!(
        out,
        "{} 2 {} {}",
        file.graph.points.len(),
        attributes.len(),
        usize::from(markers.is_some())
    )?;
    write_rows(out, file.graph.points.len(), |vertex, text| {
        number(vertex + file.numbering.vertex, text);
        for coordinate in &file.graph.points[vertex] {
            text.push(b' ');
            coordinate.write_text(text);
        }
        for column in &attributes {
            text.push(b' ');
            column.of(vertex).write_text(text);
        }
        if let Some(markers) = &markers {
            write_marker(markers[vertex], text);
        }
        text.push(b'\n');
    })
}

/// Writes vertices, edges, and the seeds of holes and regions as a `.poly`.
pub(super) fn write_poly<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_node(file, out)?;
    let GraphFile {
        graph, numbering, ..
    } = file;
    let markers = &file.edge_markers;
    writeln!(
        out,
        "{} {}",
        graph.edges.len(),
        usize::from(!markers.is_empty())
    )?;
    write_rows(out, graph.edges.len(), |edge, text| {
        let [a, b] = graph.edges[edge].map(|end| end + numbering.vertex);
        numbers([edge + numbering.edge, a, b], text);
        if let Some(marker) = markers.get(edge) {
            write_marker(*marker, text);
        }
        text.push(b'\n');
    })?;
    writeln!(out, "{}", graph.holes.len())?;
    for (hole, [x, y]) in graph.holes.iter().enumerate() {
        writeln!(out, "{} {} {}", hole + numbering.hole, x.text(), y.text())?;
    }
    if graph.regions.is_empty() {
        return Ok(());
    }
    writeln!(out, "{}", graph.regions.len())?;
    for (region, Region { seed, attribute }) in graph.regions.iter().enumerate() {
        let [x, y] = seed.each_ref().map(Coordinate::text);
        let region = region + numbering.region;
        writeln!(out, "{region} {x} {y} {}", attribute.text())?;
    }
    Ok(())
}

/// Writes `count` rows; `row` appends each to a text. The texts of some chunks at a time are made on all cores,
/// while those before them are written.
pub(super) fn write_rows(
    out: &mut impl Write,
    count: usize,
    row: impl Fn(usize, &mut Vec<u8>) + Sync + Send,
) -> io::Result<()> {
    const ROWS: usize = 1 << 12;
    // Through `dyn`, so that the work on all cores is compiled once for all kinds of rows.
    let text: &(dyn Fn(usize) -> Vec<u8> + Sync) = &|start| {
        let mut text = Vec::new();
        (start..count.min(start + ROWS)).for_each(|at| row(at, &mut text));
        text
    };
    let take: &mut dyn FnMut(Vec<u8>) -> io::Result<()> = &mut |text| out.write_all(&text);
    in_turn((0..count).step_by(ROWS), text, take)
}

/// Appends numbers with spaces between them. All get their digits before the first is copied: a copy straight
/// after the formatting would have to wait for it.
pub(super) fn numbers<const N: usize>(numbers: [usize; N], text: &mut Vec<u8>) {
    let mut buffers = numbers.map(|number| (number, itoa::Buffer::new()));
    let digits = buffers
        .each_mut()
        .map(|(number, buffer)| buffer.format(*number));
    for (at, digits) in digits.into_iter().enumerate() {
        if at > 0 {
            text.push(b' ');
        }
        text.extend_from_slice(digits.as_bytes());
    }
}

/// Appends a number.
pub(super) fn number(number: usize, text: &mut Vec<u8>) {
    numbers([number], text);
}

/// Appends a space and a marker.
pub(super) fn write_marker(marker: i64, text: &mut Vec<u8>) {
    text.push(b' ');
    text.extend_from_slice(itoa::Buffer::new().format(marker).as_bytes());
}
