//! Files as other programs write them: binary numbers of all types in both orders, strips, polylines, single precision,
//! XML with packed arrays, polygons with holes.
//!
//! The crate writes none of these, so the writers are our own and share nothing with it. They know what they mean: the
//! points, edges, heights and triangles that must be read, or that the file is no triangulation and must be refused.

mod meant;
mod numbers;
mod ply;
mod shapes;
mod shapes_text;
mod soup;
mod vtk;
mod vtu;

use arbitrary::{Result, Unstructured};
use sweep_cdt::{Pslg, Triangulation, triangulate};
use sweep_cdt_formats::{Format, GraphFile, Input, Matched, read, read_result};
use sweep_cdt_testing::generators;

use self::meant::Meant;
use super::again::{as_heights, heights, source};
use sweep_cdt_testing::oracle::canonical;

/// The heights of vertices, in turn.
const HEIGHTS: [f64; 5] = [812.5, 0.0, -3.0, 1e-7, 1e300];

/// A generated input and its triangulation, in one of the forms.
pub(super) fn judge(bytes: &mut Unstructured<'_>) -> Result<()> {
    let [form, style, number, height, packing]: [u8; 5] = bytes.arbitrary()?;
    match form % 8 {
        0 => return shapes::judge(style, bytes),
        1 => {
            let points = generators::read(bytes)?.points;
            soup::judge(points, [style, number, height]);
            return Ok(());
        }
        _ => {}
    }
    let input = generators::read(bytes)?;
    // Edges that cross are left out.
    let edges = match triangulate(&input.points, &input.edges) {
        Ok(_) => input.edges,
        Err(_) => Vec::new(),
    };
    let result = triangulate(&input.points, &edges).expect("edges that do not cross");
    // Small ones fit into more types.
    let few = if height & 1 == 0 { 3 } else { HEIGHTS.len() };
    let of_vertex = |v: usize| HEIGHTS[(v + usize::from(height >> 1)) % few];
    let has_heights = height >> 6 != 0;
    let count = if has_heights { input.points.len() } else { 0 };
    let meant = Meant {
        heights: (0..count).map(of_vertex).collect(),
        points: input.points,
        edges,
        triangles: result.triangles().collect(),
    };
    let (name, mut file) = match form % 8 {
        2..5 => ("ply", ply::write(&meant, style, number)),
        5 | 6 => ("vtk", vtk::write(&meant, style, number)),
        _ => ("vtu", vtu::write(&meant, style, number, packing)),
    };
    let as_input = Format::named(name, Format::INPUTS).expect("a format");
    let as_result = Format::named(name, Format::RESULTS).expect("a format");
    judge_input(as_input, &file, &meant);
    judge_result(as_result, &file, &meant, &result);
    // A byte that is damaged may change what is read, or be refused, and nothing else.
    let at = usize::from(bytes.arbitrary::<u16>()?) % file.len();
    file[at] = bytes.arbitrary()?;
    let damaged = source(&file);
    drop(read(as_input, &damaged, None));
    drop(read_result(
        as_result,
        &damaged,
        None,
        &GraphFile::<f64>::default(),
    ));
    Ok(())
}

/// Panics unless the file reads as the points, heights and edges that it means.
fn judge_input(format: Format, bytes: &[u8], meant: &Meant) {
    let shown = || format!("{} of {meant:?}", String::from_utf8_lossy(bytes));
    let file = match read(format, &source(bytes), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{other:?}: {}", shown()),
    };
    assert_eq!(file.graph.points, meant.points, "{}", shown());
    assert_eq!(file.graph.edges, meant.edges, "{}", shown());
    let expected = as_heights(meant.heights.clone(), meant.points.len());
    assert_eq!(heights(&file), expected, "{}", shown());
}

/// Panics unless the file reads as the triangles that it means.
fn judge_result(format: Format, file: &[u8], meant: &Meant, result: &Triangulation) {
    let shown = || format!("{} of {meant:?}", String::from_utf8_lossy(file));
    let input = Pslg {
        points: meant.points.clone(),
        ..Pslg::default()
    };
    let read = read_result(format, &source(file), None, &input.into());
    let read = read.unwrap_or_else(|error| panic!("{error}: {}", shown()));
    assert_eq!(read.matched, Matched::Equal, "{}", shown());
    let list = canonical(result, &read.list);
    assert_eq!(list, result.canonical_triangles(), "{}", shown());
}
