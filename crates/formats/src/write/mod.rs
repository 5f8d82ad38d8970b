//! Writers: a [`GraphFile`] and its [`Triangulation`] in, or a graph alone, and text out.

mod cells;
mod certificate;
mod certificate_edges;
mod certificate_numbers;
mod certificate_stream;
mod certificate_tiling;
mod crossings;
mod features;
mod json;
mod labels;
mod lines;
mod losses;
mod mesh;
mod mesh_formats;
mod numpy;
mod points;
mod raster;
mod rows;
mod shapes;
mod violations;
mod vtu;

use std::io::{self, Write};

pub use cells::{Cell, Ridges, write_cells, write_ridges};
pub use certificate::write_certificate;
pub use certificate_stream::StreamCertificate;
pub use crossings::write_crossings;
pub use json::json_coordinate;
pub use labels::edges_along;
pub use lines::{LineWriter, write_lines};
pub use losses::not_written;
pub use mesh_formats::one_word;
#[cfg(feature = "geotiff")]
pub use raster::write_geotiff;
pub use raster::{RasterHead, write_asc};
pub use rows::write_node;
pub use violations::write_violations;

use self::mesh::Mesh;
use crate::{Coordinate, Format, GraphFile};
use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt::memory::has_room;

/// Writes `result`, the triangulation of the graph of `file`, in one of [`Format::OUTPUTS`] that is no picture.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Format, write};
///
/// let graph = Pslg { points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write(Format::Ele, &graph.into(), &result, &mut text)?;
/// assert_eq!(text, b"1 3 0\n0 0 1 2\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::OutOfMemory`] where there is no room for the lists of triangles;
/// [`io::ErrorKind::Unsupported`] for another format.
pub fn write<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    expect_room(format, result.len())?;
    match format {
        // These two need no domain, which takes a look at all triangles.
        Format::Ele => {
            rows::write_triangles(file.numbering.vertex, &result.canonical_triangles(), out)
        }
        Format::Node => write_node(file, out),
        Format::Json => json::write(file, result, out),
        _ => write_interior(format, file, &Interior::whole(result), out),
    }
}

/// Writes the part of a triangulation of the graph of `file` that is inside a domain: the triangles inside and no others. The
/// vertices are all written, and keep their numbers. A `.ele` has the attributes of regions, if the domain has
/// regions and `file` lists them.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt::interior::FillRule;
/// use sweep_cdt_formats::{Format, write_interior};
///
/// let points = vec![[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
/// let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
/// let graph = Pslg { points, edges, ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write_interior(Format::Ele, &graph.into(), &result.interior(FillRule::EvenOdd)?, &mut text)?;
/// assert_eq!(text, b"2 3 0\n0 0 1 3\n1 1 2 3\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::OutOfMemory`] where there is no room for the lists of triangles;
/// [`io::ErrorKind::Unsupported`] for another format.
pub fn write_interior<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    expect_room(format, interior.triangulation().len())?;
    let mesh = || Mesh::of(file, interior);
    let labelled = || mesh().with_labels(interior);
    match format {
        Format::Ele => rows::write_ele(file, interior, out),
        Format::Node => write_node(file, out),
        Format::Json => json::write_interior(file, interior, out),
        Format::Cert => write_certified(file, interior, out),
        Format::Obj => mesh().with_sides(interior).write_obj(out),
        Format::Off => mesh().write_off(out),
        Format::Ply => labelled().write_ply(out),
        Format::Vtk => labelled().write_vtk(out),
        Format::Vtu => labelled().write_vtu(out),
        Format::Vtp => labelled().write_vtp(out),
        Format::Msh => labelled().write_msh(out),
        Format::Stl => mesh().write_stl(out),
        Format::Geojson => shapes::write_geojson(file, interior, out),
        Format::Wkt => shapes::write_wkt(file, interior, out),
        Format::Npy => mesh().write_triangles(out),
        Format::Npz => mesh().write_npz(true, out),
        _ => Err(unsupported(format, "triangulation")),
    }
}

/// Writes a certificate of a triangulation and its interior.
fn write_certified<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let result = interior.triangulation();
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    let graph = &file.graph;
    let polygons = interior.is_of_polygons().then_some(&file.polygons);
    write_certificate(
        &graph.points,
        &graph.edges,
        polygons,
        &triangles,
        |t| interior.is_inside(t),
        out,
    )
}

/// Refuses to write so many triangles where there is no memory for their lists.
fn expect_room(format: Format, triangles: usize) -> io::Result<()> {
    // The sorted list, made of groups; with both the places in it, and the neighbours.
    let each = match format {
        Format::Node => 0,
        Format::Json => 108,
        Format::Cert => 140,
        _ => 36,
    };
    if has_room(triangles.saturating_mul(each)) {
        Ok(())
    } else {
        Err(io::ErrorKind::OutOfMemory.into())
    }
}

/// The error of a format that has no room for this.
fn unsupported(format: Format, what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::Unsupported, format.lacks(what))
}

/// Writes a graph that is not triangulated, in one of [`Format::GRAPHS`]. [`read()`](crate::read()) makes the same one of
/// it, but for fractions, which only `.node`, `.poly`, `.json` and points as text hold: the others have the nearest
/// doubles. A `.node` and points as text hold vertices alone, and a `.poly` without vertices is read as one whose vertices
/// are in the `.node` beside it.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Format, write_graph};
///
/// let points = vec![[0.0, 0.5], [2.0, 0.0]];
/// let graph = Pslg { points, edges: vec![[0, 1]], ..Pslg::default() };
/// let mut text = Vec::new();
/// write_graph(Format::Poly, &graph.into(), &mut text)?;
/// assert_eq!(text, b"2 2 0 0\n0 0 0.5\n1 2 0\n1 0\n0 0 1\n0\n");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::Unsupported`] for another format.
pub fn write_graph<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mesh = || Mesh::of_graph(file);
    match format {
        Format::Node => write_node(file, out),
        Format::Poly => rows::write_poly(file, out),
        Format::Json => json::write_graph(file, out),
        Format::Obj => mesh().write_obj(out),
        Format::Off => mesh().write_off(out),
        Format::Csv => points::write(file, b',', out),
        Format::Xyz | Format::Txt => points::write(file, b' ', out),
        Format::Ply => mesh().write_ply(out),
        Format::Vtk => mesh().write_vtk(out),
        Format::Vtu => mesh().write_vtu(out),
        Format::Vtp => mesh().write_vtp(out),
        Format::Msh => mesh().write_msh(out),
        Format::Geojson => shapes::write_geojson_graph(file, out),
        Format::Wkt => shapes::write_wkt_graph(file, out),
        Format::Npy => mesh().write_points(out),
        Format::Npz => mesh().write_npz(false, out),
        _ => Err(unsupported(format, "graph")),
    }
}
