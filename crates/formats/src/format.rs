//! The formats of files: the extension of each, and which are read and written.

use Format::{
    Cert, Csv, Ele, Geojson, Json, Msh, Node, Npy, Npz, Obj, Off, Ply, Png, Poly, Stl, Svg, Txt,
    Vtk, Vtp, Vtu, Wkt, Xyz,
};

use crate::ReadError;

/// A format of files, named by their extension.
///
/// ```
/// use sweep_cdt_formats::{Format, Source, read};
///
/// assert_eq!(Format::named("POLY", Format::INPUTS), Some(Format::Poly));
/// assert_eq!(Format::named("poly", Format::RESULTS), None);
/// let error = read(Format::Ele, &Source::new("result.ele", "1 3 0\n0 0 1 2\n"), None).unwrap_err();
/// assert_eq!(error.to_string(), "result.ele: a .ele holds no graph");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Triangle's triangles.
    Ele,
    /// Triangle's vertices.
    Node,
    /// Triangle's vertices, edges, and seeds of holes and regions.
    Poly,
    /// An object with points, edges and triangles, under any of their usual names.
    Json,
    /// A certificate for the proved checker.
    Cert,
    /// Wavefront's vertices, lines and faces.
    Obj,
    /// Geomview's vertices and faces; a face of two corners is a line.
    Off,
    /// Points, a row for each, with or without the names of columns.
    Csv,
    /// Points as in `.csv`.
    Xyz,
    /// Points as in `.csv`; or the steps of a trace.
    Txt,
    /// Stanford's vertices, edges and faces, as text or binary.
    Ply,
    /// VTK's points, lines, and polygons or cells, as text or binary.
    Vtk,
    /// VTK's points and cells, as XML.
    Vtu,
    /// VTK's points, lines and polygons, as XML.
    Vtp,
    /// Gmsh's nodes, lines and triangles, as text or binary.
    Msh,
    /// Triangles alone, as text or binary.
    Stl,
    /// Points, lines and polygons of maps, as JSON.
    Geojson,
    /// Points, lines and polygons as text.
    Wkt,
    /// Points or triangles as an array of NumPy.
    Npy,
    /// Points, edges and triangles as arrays of NumPy.
    Npz,
    /// A picture.
    Svg,
    /// A picture of pixels.
    Png,
    /// The steps of a trace, for programs.
    Jsonl,
    /// The steps of a trace, as a page for a browser.
    Html,
    /// Points as doubles, x and y of each; little-endian, without a header.
    F64,
    /// A point cloud of a laser scanner.
    Las,
    /// A point cloud of a laser scanner that is packed.
    Laz,
}

impl Format {
    /// Formats of a graph that [`read()`](crate::read()) reads: [`Format::GRAPHS`], and point clouds with the feature `las`.
    pub const INPUTS: &'static [Format] = &[
        Node,
        Poly,
        Json,
        Obj,
        Off,
        Csv,
        Xyz,
        Txt,
        Ply,
        Vtk,
        Vtu,
        Vtp,
        Msh,
        Geojson,
        Wkt,
        Npy,
        Npz,
        #[cfg(feature = "las")]
        Format::Las,
        #[cfg(feature = "las")]
        Format::Laz,
    ];

    /// Formats of a graph that [`write_graph`](crate::write_graph) writes, all of which are read.
    pub const GRAPHS: &'static [Format] = &[
        Node, Poly, Json, Obj, Off, Csv, Xyz, Txt, Ply, Vtk, Vtu, Vtp, Msh, Geojson, Wkt, Npy, Npz,
    ];

    /// Formats of a triangulation that [`read_result`](crate::read_result) reads.
    pub const RESULTS: &'static [Format] = &[
        Ele, Json, Obj, Off, Ply, Vtk, Vtu, Vtp, Msh, Stl, Geojson, Wkt, Npy, Npz,
    ];

    /// Formats in which a triangulation is written: the pictures by the package `sweep-cdt-draw`, the others by
    /// [`write()`](crate::write()).
    pub const OUTPUTS: &'static [Format] = &[
        Ele, Node, Json, Cert, Obj, Off, Ply, Vtk, Vtu, Vtp, Msh, Stl, Geojson, Wkt, Npy, Npz, Svg,
        Png,
    ];

    /// Formats that [`raised`](crate::raised) writes as they were read, but for heights.
    pub const RAISED: &'static [Format] = &[Csv, Xyz, Txt, Geojson];

    /// Points as text, a row for each.
    pub const TABLES: &'static [Format] = &[Csv, Xyz, Txt];

    /// Formats in which [`write_crossings`](crate::write_crossings) lists edges that cross.
    pub const CROSSINGS: &'static [Format] = &[Csv, Json, Geojson];

    /// Formats in which a [`LineWriter`](crate::LineWriter) writes lines one by one.
    pub const LINES: &'static [Format] = &[Geojson, Wkt];

    /// The name, which is the extension of its files.
    pub fn name(self) -> &'static str {
        match self {
            Ele => "ele",
            Node => "node",
            Poly => "poly",
            Json => "json",
            Cert => "cert",
            Obj => "obj",
            Off => "off",
            Csv => "csv",
            Xyz => "xyz",
            Txt => "txt",
            Ply => "ply",
            Vtk => "vtk",
            Vtu => "vtu",
            Vtp => "vtp",
            Msh => "msh",
            Stl => "stl",
            Geojson => "geojson",
            Wkt => "wkt",
            Npy => "npy",
            Npz => "npz",
            Svg => "svg",
            Png => "png",
            Format::Jsonl => "jsonl",
            Format::Html => "html",
            Format::F64 => "f64",
            Format::Las => "las",
            Format::Laz => "laz",
        }
    }

    /// The format of this name, whatever its case, if it is one of these.
    pub fn named(name: &str, formats: &[Format]) -> Option<Format> {
        let mut formats = formats.iter().copied();
        formats.find(|format| format.name().eq_ignore_ascii_case(name))
    }

    /// Refuses classes of points that were chosen of a file of this name, if the format has none.
    ///
    /// # Errors
    /// There are classes, and the format is no cloud.
    pub fn expect_classes(self, file: &str, classes: &[u8]) -> Result<(), ReadError> {
        if classes.is_empty() || matches!(self, Format::Las | Format::Laz) {
            return Ok(());
        }
        let message = format!("a .{} has no classes of points", self.name());
        Err(ReadError::of_file(file, message))
    }

    /// An error's words for a format in which something is neither read nor written.
    pub(crate) fn lacks(self, what: &str) -> String {
        format!("a .{} holds no {what}", self.name())
    }
}
