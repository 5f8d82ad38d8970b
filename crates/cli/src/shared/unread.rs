//! Files that are not read, by their extensions, and the command that makes one of them that is.

use std::path::Path;

/// A program that converts files.
#[derive(Clone, Copy)]
enum Converter {
    /// GDAL's, for maps of points, lines and polygons.
    Ogr,
    /// GDAL's, for grids of heights; without places that have none.
    Gdal,
    /// PDAL, for clouds of points.
    Pdal,
    /// GDAL's too, for drawings of CAD as text.
    Dxf,
    /// `LibreDWG`, for drawings of CAD.
    Dwg,
    /// `meshio`, for meshes.
    Meshio,
    /// Assimp, for models of 3D programs.
    Assimp,
    /// `LibreOffice`, for tables.
    Office,
}

/// The extensions that are known, and what converts such a file.
const KNOWN: [(Converter, &[&str]); 8] = [
    (
        Converter::Ogr,
        &[
            "shp",
            "gpkg",
            "kml",
            "kmz",
            "gml",
            "parquet",
            "geoparquet",
            "fgb",
            "tab",
            "mif",
            "gpx",
            "sqlite",
            "topojson",
            "dgn",
        ],
    ),
    (
        Converter::Gdal,
        &[
            "tif", "tiff", "geotiff", "gtiff", "asc", "img", "dem", "hgt", "vrt", "bil", "flt",
            "nc", "jp2",
        ],
    ),
    (Converter::Pdal, &["las", "laz", "e57", "pcd", "bpf", "ptx"]),
    (Converter::Dxf, &["dxf"]),
    (Converter::Dwg, &["dwg"]),
    (
        Converter::Meshio,
        &[
            "mesh", "meshb", "xdmf", "xmf", "med", "inp", "exo", "cgns", "su2", "bdf", "nas",
            "fem", "avs", "h5m",
        ],
    ),
    (
        Converter::Assimp,
        &["glb", "gltf", "fbx", "dae", "3ds", "blend", "x3d", "3mf"],
    ),
    (Converter::Office, &["xlsx", "xls", "ods"]),
];

/// The command that converts a file whose extension is known.
pub(super) fn command(path: &Path) -> Option<String> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    let mut known = KNOWN.iter();
    let (converter, _) = known.find(|(_, names)| names.contains(&extension.as_str()))?;
    let file = shown(path);
    let other = |extension: &str| shown(&path.with_extension(extension));
    Some(match converter {
        Converter::Ogr => format!("ogr2ogr -f GeoJSON {} {file}", other("geojson")),
        Converter::Gdal => format!("gdal2xyz.py -skipnodata {file} {}", other("xyz")),
        Converter::Pdal => format!("pdal translate {file} {}", other("csv")),
        Converter::Dxf => format!(
            "ogr2ogr -f GeoJSON {} {file} (or ezdxf, in Python)",
            other("geojson")
        ),
        Converter::Dwg => format!("dwgread -O GeoJSON -o {} {file}", other("geojson")),
        Converter::Meshio => format!("meshio convert {file} {}", other("vtu")),
        Converter::Assimp => format!("assimp export {file} {}", other("obj")),
        Converter::Office => format!("libreoffice --headless --convert-to csv {file}"),
    })
}

/// The words for a file that another build reads, and how that is made.
pub(super) fn build(path: &Path) -> Option<&'static str> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    let is_cloud = ["las", "laz"].contains(&extension.as_str());
    (is_cloud && !cfg!(feature = "las")).then_some(
        " by a build without the feature `las` (`cargo install --path crates/cli --features las` makes one with it)",
    )
}

/// The name of a format that is read, where a file has another extension of it.
pub(super) fn other_name(path: &Path) -> Option<&'static str> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    match extension.as_str() {
        "tsv" | "dat" | "pts" => Some("txt"),
        "geojsonl" | "geojsons" | "ndjson" | "geojsonseq" => Some("geojson"),
        "ewkt" => Some("wkt"),
        _ => None,
    }
}

/// A path as a shell takes it.
fn shown(path: &Path) -> String {
    let path = path.display().to_string();
    let is_plain = |sign: char| sign.is_alphanumeric() || "._-/".contains(sign);
    if path.chars().all(is_plain) {
        path
    } else {
        let path: String = path.chars().filter(|sign| !sign.is_control()).collect();
        format!("'{}'", path.replace('\'', "'\\''"))
    }
}
