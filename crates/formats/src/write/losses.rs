//! What a format has no room for.

use crate::{Coordinate, CoordinateSystem, Format, GraphFile, Remark};
use sweep_cdt::interior::Interior;

/// The remark on everything of a file and its domain that an output in this format has no room for, if there is any.
/// A `.cert` alone has vertices without heights; other formats without heights have no vertices either.
///
/// ```
/// use sweep_cdt_formats::{Column, Format, GraphFile, not_written};
///
/// let wind = Column { name: "wind".to_owned(), values: vec![1.5] };
/// let file = GraphFile::<f64> { columns: vec![wind], ..GraphFile::default() };
/// let lost = not_written(Format::Obj, &file, None).unwrap();
/// assert_eq!(lost.to_string(), "not written: the column `wind`");
/// assert_eq!(not_written(Format::Node, &file, None), None);
/// ```
pub fn not_written<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    interior: Option<&Interior<'_>>,
) -> Option<Remark> {
    let Room {
        columns,
        vertex_markers,
        edge_markers,
        regions,
        system,
    } = Room::of(format);
    let mut losses = Vec::new();
    if format == Format::Cert && file.heights().is_some() {
        losses.push("heights".to_owned());
    }
    if !columns {
        let columns = file.other_columns();
        losses.extend(columns.map(|column| format!("the column `{}`", column.name)));
    }
    let markers = file.vertex_markers().unwrap_or_default();
    let marked = markers.iter().filter(|marker| **marker != 0).count();
    if !vertex_markers && marked > 0 {
        losses.push(format!("markers of {marked} vertices"));
    }
    let marked = file
        .edge_markers
        .iter()
        .filter(|marker| **marker != 0)
        .count();
    if !edge_markers && marked > 0 {
        losses.push(format!("markers of {marked} edges"));
    }
    if !regions && let Some(interior) = interior.filter(|interior| interior.has_regions()) {
        let what = if interior.is_of_polygons() {
            "features"
        } else {
            "regions"
        };
        losses.push(format!("{what} of triangles"));
    }
    let has_features = interior.is_some_and(Interior::is_of_polygons);
    if format != Format::Geojson || !has_features {
        losses.extend(file.properties.losses());
    }
    if let Some(lost) = file.system.as_ref().filter(|lost| !system.holds(lost)) {
        losses.push(format!("the coordinate system {}", lost.name()));
    }
    (!losses.is_empty()).then_some(Remark::NotWritten { what: losses })
}

/// What a format can say.
struct Room {
    columns: bool,
    vertex_markers: bool,
    edge_markers: bool,
    regions: bool,
    system: System,
}

/// How a format names a coordinate system.
enum System {
    No,
    /// By a number of the EPSG.
    Number,
    Any,
}

impl System {
    /// Whether a system can be named so.
    fn holds(&self, system: &CoordinateSystem) -> bool {
        match self {
            System::No => false,
            System::Number => system.srid().is_some(),
            System::Any => !system.json().is_empty(),
        }
    }
}

impl Room {
    fn of(format: Format) -> Room {
        let nothing = Room {
            columns: false,
            vertex_markers: false,
            edge_markers: false,
            regions: false,
            system: System::No,
        };
        match format {
            // A `.ele` stands beside a `.node`.
            Format::Ele | Format::Node => Room {
                columns: true,
                vertex_markers: true,
                regions: true,
                ..nothing
            },
            Format::Json => Room {
                columns: true,
                vertex_markers: true,
                edge_markers: true,
                regions: true,
                system: System::Any,
            },
            Format::Ply | Format::Vtk | Format::Vtu | Format::Vtp => Room {
                columns: true,
                vertex_markers: true,
                edge_markers: true,
                regions: true,
                ..nothing
            },
            Format::Msh => Room {
                vertex_markers: true,
                edge_markers: true,
                regions: true,
                ..nothing
            },
            Format::Geojson => Room {
                regions: true,
                system: System::Any,
                ..nothing
            },
            Format::Wkt => Room {
                system: System::Number,
                ..nothing
            },
            // Columns have no names in it, but are there.
            Format::Npz => Room {
                columns: true,
                vertex_markers: true,
                ..nothing
            },
            _ => nothing,
        }
    }
}
