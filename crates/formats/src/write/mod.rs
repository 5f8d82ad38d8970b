//! Writers: a [`GraphFile`] and its [`Triangulation`] in, or a graph alone, and text out.

mod certificate;
mod certificate_numbers;
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
mod rows;
mod shapes;
mod violations;
mod vtu;

use std::io::{self, Write};

pub use certificate::write_certificate;
pub use crossings::{CrossingsFormat, write_crossings};
pub use lines::write_lines;
pub use losses::not_written;
pub use rows::write_node;
pub use violations::write_violations;

use self::mesh::Mesh;
use crate::{Coordinate, GraphFile, InputFormat};
use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt::memory::has_room;

named! {
    /// A format that [`write()`] makes, named by the extension of its files.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum OutputFormat {
        /// Triangle's triangles, numbered as the input.
        Ele = "ele",
        /// Triangle's vertices, numbered as the input.
        Node = "node",
        /// Vertices, edges and the whole result.
        Json = "json",
        /// A certificate for the proved checker.
        Cert = "cert",
        /// Wavefront's vertices and faces.
        Obj = "obj",
        /// Geomview's vertices and faces.
        Off = "off",
        /// Stanford's vertices and faces, as text.
        Ply = "ply",
        /// VTK's points and cells, as text.
        Vtk = "vtk",
        /// VTK's points and cells, as XML.
        Vtu = "vtu",
        /// VTK's points and polygons, as XML.
        Vtp = "vtp",
        /// Gmsh's nodes and triangles, as text of version 2.2.
        Msh = "msh",
        /// Triangles alone, as text.
        Stl = "stl",
        /// Polygons of maps, as JSON.
        Geojson = "geojson",
        /// Polygons as text.
        Wkt = "wkt",
        /// Triangles as an array of NumPy.
        Npy = "npy",
        /// Points, edges and triangles as arrays of NumPy.
        Npz = "npz",
    }
}

/// Writes `result`, the triangulation of the graph of `file`.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{OutputFormat, write};
///
/// let graph = Pslg { points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write(OutputFormat::Ele, &graph.into(), &result, &mut text)?;
/// assert_eq!(text, b"1 3 0\n0 0 1 2\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::OutOfMemory`] where there is no room for the lists of triangles.
pub fn write<S: Coordinate>(
    format: OutputFormat,
    file: &GraphFile<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    expect_room(format, result.len())?;
    match format {
        // These two need no domain, which takes a look at all triangles.
        OutputFormat::Ele => {
            rows::write_triangles(file.numbering.vertex, &result.canonical_triangles(), out)
        }
        OutputFormat::Node => write_node(file, out),
        OutputFormat::Json => json::write(file, result, out),
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
/// use sweep_cdt_formats::{OutputFormat, write_interior};
///
/// let points = vec![[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
/// let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
/// let graph = Pslg { points, edges, ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write_interior(OutputFormat::Ele, &graph.into(), &result.interior(FillRule::EvenOdd)?, &mut text)?;
/// assert_eq!(text, b"2 3 0\n0 0 1 3\n1 1 2 3\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::OutOfMemory`] where there is no room for the lists of triangles.
pub fn write_interior<S: Coordinate>(
    format: OutputFormat,
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    expect_room(format, interior.triangulation().len())?;
    match format {
        OutputFormat::Ele => rows::write_ele(file, interior, out),
        OutputFormat::Node => write_node(file, out),
        OutputFormat::Json => json::write_interior(file, interior, out),
        OutputFormat::Cert => write_certified(file, interior, out),
        OutputFormat::Obj => Mesh::of(file, interior).with_sides(interior).write_obj(out),
        OutputFormat::Off => Mesh::of(file, interior).write_off(out),
        OutputFormat::Ply => Mesh::of(file, interior)
            .with_labels(interior)
            .write_ply(out),
        OutputFormat::Vtk => Mesh::of(file, interior)
            .with_labels(interior)
            .write_vtk(out),
        OutputFormat::Vtu => Mesh::of(file, interior)
            .with_labels(interior)
            .write_vtu(out),
        OutputFormat::Vtp => Mesh::of(file, interior)
            .with_labels(interior)
            .write_vtp(out),
        OutputFormat::Msh => Mesh::of(file, interior)
            .with_labels(interior)
            .write_msh(out),
        OutputFormat::Stl => Mesh::of(file, interior).write_stl(out),
        OutputFormat::Geojson => shapes::write_geojson(file, interior, out),
        OutputFormat::Wkt => shapes::write_wkt(file, interior, out),
        OutputFormat::Npy => Mesh::of(file, interior).write_triangles(out),
        OutputFormat::Npz => Mesh::of(file, interior).write_npz(true, out),
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
fn expect_room(format: OutputFormat, triangles: usize) -> io::Result<()> {
    // The sorted list, made of groups; with both the places in it, and the neighbours.
    let each = match format {
        OutputFormat::Node => 0,
        OutputFormat::Json => 108,
        OutputFormat::Cert => 140,
        _ => 36,
    };
    if has_room(triangles.saturating_mul(each)) {
        Ok(())
    } else {
        Err(io::ErrorKind::OutOfMemory.into())
    }
}

/// Writes a graph that is not triangulated, in a format from which [`read()`](crate::read()) makes the same one, but for
/// fractions, which only `.node`, `.poly`, `.json` and points as text hold: the others have the nearest doubles. A
/// `.node` and points as text hold vertices alone, and a `.poly` without vertices is read as one whose vertices are in the
/// `.node` beside it.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{InputFormat, write_graph};
///
/// let points = vec![[0.0, 0.5], [2.0, 0.0]];
/// let graph = Pslg { points, edges: vec![[0, 1]], ..Pslg::default() };
/// let mut text = Vec::new();
/// write_graph(InputFormat::Poly, &graph.into(), &mut text)?;
/// assert_eq!(text, b"2 2 0 0\n0 0 0.5\n1 2 0\n1 0\n0 0 1\n0\n");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`.
pub fn write_graph<S: Coordinate>(
    format: InputFormat,
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        InputFormat::Node => write_node(file, out),
        InputFormat::Poly => rows::write_poly(file, out),
        InputFormat::Json => json::write_graph(file, out),
        InputFormat::Obj => Mesh::of_graph(file).write_obj(out),
        InputFormat::Off => Mesh::of_graph(file).write_off(out),
        InputFormat::Csv => points::write(file, b',', out),
        InputFormat::Xyz | InputFormat::Txt => points::write(file, b' ', out),
        InputFormat::Ply => Mesh::of_graph(file).write_ply(out),
        InputFormat::Vtk => Mesh::of_graph(file).write_vtk(out),
        InputFormat::Vtu => Mesh::of_graph(file).write_vtu(out),
        InputFormat::Vtp => Mesh::of_graph(file).write_vtp(out),
        InputFormat::Msh => Mesh::of_graph(file).write_msh(out),
        InputFormat::Geojson => shapes::write_geojson_graph(file, out),
        InputFormat::Wkt => shapes::write_wkt_graph(file, out),
        InputFormat::Npy => Mesh::of_graph(file).write_points(out),
        InputFormat::Npz => Mesh::of_graph(file).write_npz(false, out),
    }
}
