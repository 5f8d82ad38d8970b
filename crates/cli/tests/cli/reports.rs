//! Verdicts and results that strangers asked about: what the command says of them.

use crate::{folder, printed, printed_despite_losses, sweep_cdt, text};

/// Blender exports y up: all points are on one line.
#[test]
fn a_result_without_triangles_says_why() {
    let flat = "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv 0.2 0 -0.3\n";
    let folder = folder(&[
        ("y_up.obj", flat),
        ("line.json", "{\"points\": [[0, 0], [1, 1], [2, 2]]}"),
        ("one.json", "{\"points\": [[0, 0], [0, 0]]}"),
        ("none.json", "{\"points\": []}"),
        ("open.json", "{\"points\": [[0, 0], [3, 0], [0, 3]]}"),
        (
            "right.json",
            "{\"points\": [[0, 0], [3, 0], [0, 3]], \"edges\": [[0, 1], [1, 2], [2, 0]]}",
        ),
    ]);
    let note = |arguments: &str| {
        let output = sweep_cdt(&folder, arguments)
            .output()
            .expect("the command starts");
        assert!(output.status.success(), "{arguments}");
        text(&output.stderr).to_owned()
    };
    let line = |file: &str| format!("note: {file}: no triangles: all points lie on one line");
    let conflict = "note: y_up.obj: vertex 2 at (1, 0) has two numbers for z, 1 and -1: 1 counts";
    assert_eq!(
        note("triangulate y_up.obj"),
        format!(
            "{conflict}\n{} (y is the same everywhere and z is not: perhaps y is up in this file)\n",
            line("y_up.obj")
        )
    );
    assert_eq!(
        note("triangulate line.json -o line.ele"),
        line("line.json") + "\n"
    );
    assert_eq!(
        note("triangulate one.json"),
        "note: one.json: no triangles: all points are one\n"
    );
    assert_eq!(
        note("triangulate none.json"),
        "note: none.json: no triangles: there are no points\n"
    );
    assert_eq!(
        note("triangulate open.json --inside even-odd -o open.ele"),
        "note: open.json: no triangles are inside: there are no edges\n"
    );
    assert_eq!(note("triangulate right.json --inside even-odd"), "");
}

/// `qgis/QGIS#44501`, `jblindsay/whitebox-tools#180`: a line without heights among points with some.
#[test]
fn vertices_without_a_height_are_counted() {
    let soft =
        "{\"points\": [[0, 0, 5], [9, 0, 6], [9, 9, 7], [3, 2], [4, 6]], \"edges\": [[3, 4]]}";
    let folder = folder(&[("soft.json", soft)]);
    let noted = |format: &str| {
        let arguments = format!("triangulate soft.json -o - --output-format {format}");
        let output = sweep_cdt(&folder, &arguments)
            .output()
            .expect("the command starts");
        (
            text(&output.stdout).to_owned(),
            text(&output.stderr).to_owned(),
        )
    };
    let note = "note: soft.json: 2 of 5 vertices have no height: z is `NaN` there, or left out, which some programs read as 0\n";
    for format in ["obj", "off", "ply", "vtk", "vtu", "vtp", "msh", "stl"] {
        let (written, notes) = noted(format);
        assert_eq!(notes, note, "{format}");
        assert!(
            written.contains("3 2 NaN") && !written.contains("3 2 0\n"),
            "{format}"
        );
    }
    assert_eq!(noted("wkt").1, note);
    assert!(noted("wkt").0.contains("3 2 NaN"));
    assert_eq!(noted("geojson").1, note);
    assert!(noted("geojson").0.contains("[3,2]"));
    assert!(noted("json").0.contains("[3,2]"));
}

/// Julia and Matlab count from 1.
#[test]
fn corners_counted_from_one_are_said_to_be() {
    let folder = folder(&[
        (
            "five.json",
            "{\"points\": [[0, 0], [4, 0], [4, 4], [0, 4], [1, 2]]}",
        ),
        (
            "from1.json",
            "{\"triangles\": [[1, 2, 5], [1, 5, 4], [2, 3, 5], [3, 4, 5]]}",
        ),
        (
            "from0.json",
            "{\"triangles\": [[0, 1, 4], [0, 4, 3], [1, 2, 4], [2, 3, 4]]}",
        ),
        (
            "wrong.json",
            "{\"triangles\": [[0, 1, 5], [0, 4, 3], [1, 2, 4], [2, 3, 4]]}",
        ),
    ]);
    let report = |result: &str| {
        let arguments = format!("verify five.json {result}");
        let output = sweep_cdt(&folder, &arguments)
            .output()
            .expect("the command starts");
        text(&output.stdout).to_owned()
    };
    let advice = "\ncorners are numbered from 1 and not from 0: subtract 1 from each\n";
    assert!(report("from1.json").ends_with(advice));
    assert!(!report("wrong.json").contains(advice));
    let right = sweep_cdt(&folder, "verify five.json from0.json").output();
    assert!(!printed(&right.expect("the command starts")).contains(advice));
}

/// `PostGIS`'s `ST_AsGeoJSON` prints 9 decimals: each corner is one vertex, rounded, and no other.
#[test]
fn rounded_triangles_without_numbers_are_verified() {
    let reports = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/reports");
    let verify = |folder: &std::path::Path, arguments: &str| {
        let output = sweep_cdt(folder, &format!("verify {arguments}")).output();
        output.expect("the command starts")
    };
    let output = verify(
        reports.as_ref(),
        "rounded_points.wkt rounded_9_decimals.geojson",
    );
    let report = printed(&output);
    let matched = "vertices matched by coordinates, which are rounded: greatest difference 4.9";
    let second = report.lines().nth(1).expect("a line");
    assert!(second.starts_with(matched), "{second}");

    // With a corner that is elsewhere, and with vertices that are too near to each other.
    let result = std::fs::read_to_string(format!("{reports}/rounded_9_decimals.geojson"));
    let result = result
        .expect("a file")
        .replace("-74.076395191", "-74.07641");
    let points = std::fs::read_to_string(format!("{reports}/rounded_points.wkt"));
    let points = points.expect("a file");
    let folder = folder(&[
        ("a.wkt", &points),
        ("b.geojson", &result),
        (
            "twins.wkt",
            "MULTIPOINT (0 0, 1.00000001 0, 0 1, 1.00000002 0)",
        ),
        (
            "twins.geojson",
            "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [1, 0], [0, 1]]]}",
        ),
    ]);
    let refused = verify(folder.path(), "a.wkt b.geojson");
    let error = text(&refused.stderr);
    let nearest = ", where the input has none: the nearest is vertex 0 at (-74.07639519102625, 4.610316603423072), by 1.48";
    assert!(
        error.contains("at (-74.07641, 4.610316603)") && error.contains(nearest),
        "{error}"
    );
    assert!(
        error.ends_with(" (--tolerance 1.5e-5 accepts it)\n"),
        "{error}"
    );
    let accepted = verify(folder.path(), "a.wkt b.geojson --tolerance 1.5e-5");
    let second = printed(&accepted).lines().nth(1).expect("a line");
    assert!(
        second.starts_with(
            "vertices matched by coordinates, within the tolerance: greatest difference 1.48"
        ),
        "{second}"
    );
    let twins = verify(folder.path(), "twins.wkt twins.geojson");
    assert_eq!(
        text(&twins.stderr),
        "error: twins.geojson:1: vertex 1 at (1, 0) may be vertex 1 or 3 of the input, within rounding to the digits that \
         are there (write the result with all digits, 17, or without coordinates)\n"
    );
}

/// Formats that are not read: the message names the command that makes one of them that is.
#[test]
fn what_converts_a_file_is_said() {
    let folder = folder(&[("five.json", "{\"points\": [[0, 0], [3, 0], [0, 3]]}")]);
    let said = |arguments: &str, file: &str| {
        let mut command = sweep_cdt(&folder, arguments);
        let output = command.arg(file).output().expect("the command starts");
        let message = text(&output.stderr);
        // What no option reads is no wrong usage.
        let is_usage = message.contains("Usage: ");
        let status = if is_usage { 2 } else { 1 };
        assert_eq!(output.status.code(), Some(status), "{arguments} {file}");
        let is_converted = message.contains(": convert it, ");
        assert_ne!(is_usage, is_converted, "{arguments} {file}");
        message.lines().next().expect("a line").to_owned()
    };
    for (file, command) in [
        ("roads.shp", "ogr2ogr -f GeoJSON roads.geojson roads.shp"),
        (
            "a/b.c/Land.GPKG",
            "ogr2ogr -f GeoJSON a/b.c/Land.geojson a/b.c/Land.GPKG",
        ),
        ("places.kml", "ogr2ogr -f GeoJSON places.geojson places.kml"),
        ("plots.gml", "ogr2ogr -f GeoJSON plots.geojson plots.gml"),
        (
            "cells.parquet",
            "ogr2ogr -f GeoJSON cells.geojson cells.parquet",
        ),
        ("hill.tif", "gdal2xyz.py -skipnodata hill.tif hill.xyz"),
        ("hill.TIFF", "gdal2xyz.py -skipnodata hill.TIFF hill.xyz"),
        (
            "hill.geotiff",
            "gdal2xyz.py -skipnodata hill.geotiff hill.xyz",
        ),
        ("cloud.las", "pdal translate cloud.las cloud.csv"),
        (
            "cloud.copc.laz",
            "pdal translate cloud.copc.laz cloud.copc.csv",
        ),
        (
            "part.dxf",
            "ogr2ogr -f GeoJSON part.geojson part.dxf (or ezdxf, in Python)",
        ),
        ("part.dwg", "dwgread -O GeoJSON -o part.geojson part.dwg"),
        ("part.mesh", "meshio convert part.mesh part.vtu"),
        ("part.glb", "assimp export part.glb part.obj"),
        (
            "table.xlsx",
            "libreoffice --headless --convert-to csv table.xlsx",
        ),
        (
            "my roads.shp",
            "ogr2ogr -f GeoJSON 'my roads.geojson' 'my roads.shp'",
        ),
        (
            "it's.shp",
            "ogr2ogr -f GeoJSON 'it'\\''s.geojson' 'it'\\''s.shp'",
        ),
    ] {
        for arguments in ["triangulate", "crossings", "verify five.json"] {
            let is_cloud = command.starts_with("pdal") && arguments != "verify five.json";
            if is_cloud && cfg!(feature = "las") {
                continue;
            }
            let build = match is_cloud {
                true => {
                    " by a build without the feature `las` (`cargo install --path crates/cli --features las` makes one \
                     with it)"
                }
                false => "",
            };
            let expected = format!("error: {file} is not read{build}: convert it, {command}");
            assert_eq!(said(arguments, file), expected, "{arguments}");
        }
    }
    let other = "error: the format of a.tsv is not known by its name: add --input-format txt";
    assert_eq!(said("triangulate", "a.tsv"), other);
    let other =
        "error: the format of a.NDJSON is not known by its name: add --result-format geojson";
    assert_eq!(said("verify five.json", "a.NDJSON"), other);
    assert!(
        said("verify five.json", "a.tsv").contains("add --result-format with one of ele, json")
    );
    assert!(said("triangulate", "shp").starts_with("error: the format of shp is not known: add"));
}

/// Points as text, and results as arrays: what the command makes of them.
#[test]
fn tables_and_arrays_go_through_the_command() {
    let table = "Name;Lon;Lat;Elev\nA;0;0;5\nB;4;0;6\nC;4;4;7\nD;0;4;8\n";
    let folder = folder(&[("survey.csv", table)]);
    let ran = |arguments: &str| {
        let output = sweep_cdt(&folder, arguments)
            .output()
            .expect("the command starts");
        printed_despite_losses(&output).to_owned()
    };
    assert_eq!(
        ran("triangulate survey.csv"),
        "survey.csv: points 4, duplicates 0, edges 0, triangles 2, hull 4\n"
    );
    ran("triangulate survey.csv -o t.npy -o t.npz -o t.vtp -o t.json");
    for result in ["t.npy", "t.npz", "t.vtp", "t.json"] {
        let verdict = ran(&format!("verify survey.csv {result}"));
        assert!(
            verdict.starts_with(&format!(
                "correct: {result} is a constrained Delaunay triangulation of survey.csv"
            )),
            "{verdict}"
        );
    }
    let points = "[0,0,5],\n[4,0,6],\n[4,4,7],\n[0,4,8]";
    let json = ran("triangulate survey.csv -o - --output-format json");
    assert!(json.contains(points), "{json}");
    // The archive is an input, too.
    assert!(ran("triangulate t.npz -o - --output-format json").contains(points));
    ran("generate lattice 9 -o grid.csv");
    assert!(ran("triangulate grid.csv").starts_with("grid.csv: points 9"));
}
