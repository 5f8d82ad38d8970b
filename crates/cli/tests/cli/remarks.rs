//! What is said about inputs from public reports, and what is made of them (`tests/data/reports/README.md` has the
//! sources). The right results come from the reports, or from hand.

use std::path::Path;
use std::process::Output;

use crate::{folder, sweep_cdt, text};

const REPORTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/reports");

fn run(folder: impl AsRef<Path>, arguments: &str) -> Output {
    let output = sweep_cdt(folder, arguments).output();
    output.expect("the command starts")
}

/// Both streams of a run that does its work.
#[track_caller]
fn done(arguments: &str) -> (String, String) {
    let output = run(REPORTS, arguments);
    let (out, said) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{arguments}: {said}");
    (out.to_owned(), said.to_owned())
}

/// What a strict run says, which refuses.
#[track_caller]
fn refused(arguments: &str) -> String {
    let output = run(REPORTS, &format!("{arguments} --strict"));
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments}: {said}");
    assert_eq!(text(&output.stdout), "", "{arguments}");
    assert!(
        said.ends_with("; --strict refuses that\n"),
        "{arguments}: {said}"
    );
    said.to_owned()
}

/// The vertices of the `.obj` that a run writes.
#[track_caller]
fn vertices(arguments: &str) -> (Vec<String>, String) {
    let (out, said) = done(&format!("{arguments} -o - --output-format obj"));
    let lines = out.lines().filter(|line| line.starts_with("v "));
    (lines.map(str::to_owned).collect(), said)
}

#[test]
fn the_columns_of_a_table_without_names_are_said_and_can_be_chosen() {
    let (read, said) = vertices("triangulate survey_pnezd.csv");
    assert_eq!(read[0], "v 101 4017.25 9811.4");
    assert!(
        said.starts_with(
            "note: survey_pnezd.csv: x is column 1, y is column 2, z is column 3 of 5: none has a name \
             (--columns names others)\n"
        ),
        "{said}"
    );
    let (read, said) = vertices("triangulate survey_pnezd.csv --columns 3,2,4");
    assert_eq!(read[0], "v 9811.4 4017.25 102.41");
    assert!(!said.contains("none has a name"), "{said}");

    let output = run(REPORTS, "triangulate named_points.csv");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("`GCP1`") && said.contains("(or --columns"),
        "{said}"
    );
    let (read, _) = vertices("triangulate named_points.csv --columns 2,3,4");
    assert_eq!(read[0], "v 500120.5 4100231.25 88.1");
}

/// Two slashes begin a comment, and a number alone in the first row is that of the points.
#[test]
fn tables_of_scanners_are_read() {
    for (file, points) in [
        ("leica_count.txt", 4),
        ("cloudcompare_count.xyz", 3),
        ("two_slash_comments.txt", 3),
    ] {
        let (read, said) = vertices(&format!("triangulate {file}"));
        assert_eq!(read.len(), points, "{file}");
        assert!(!said.contains("the header says"), "{file}: {said}");
        let (out, _) = done(&format!("stream {file}"));
        let row = format!("points {points:>42}");
        assert!(out.contains(&row), "{file}: {out}");
    }
    let folder = folder(&[("cut.xyz", "5\n0 0 1\n4 0 1\n0 4 1\n")]);
    let output = run(&folder, "triangulate cut.xyz");
    let said = "note: cut.xyz: the header says that there are 5 points, and 3 follow\n";
    assert_eq!(text(&output.stderr), said);
}

#[test]
fn what_is_not_read_is_named_with_what_helps() {
    for (file, named, help) in [
        ("wkt_column.csv", "`WKT` holds shapes", "ogr2ogr"),
        ("esri.json", "Esri's JSON", "ogr2ogr"),
        ("topology.json", "TopoJSON", "ogr2ogr"),
        ("parametric_nodes.msh", "`$ParametricNodes`", "save"),
    ] {
        let output = run(REPORTS, &format!("triangulate {file}"));
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{file}");
        assert!(said.contains(named) && said.contains(help), "{said}");
        assert!(!said.contains("--columns"), "{said}");
    }
    let folder = folder(&[
        (
            "town.json",
            r#"{"type": "CityJSON", "transform": {}, "vertices": [[0, 0, 0]]}"#,
        ),
        (
            "query.json",
            r#"{"features": [{"attributes": {}, "geometry": {"x": 0, "y": 1}}]}"#,
        ),
        (
            "hexadecimal.wkt",
            "0101000000000000000000F03F000000000000F03F\n",
        ),
    ]);
    for (file, named, help) in [
        (
            "town.json",
            "this is CityJSON",
            "`cjio FILE export obj FILE.obj`",
        ),
        ("query.json", "this is Esri's JSON", "`ogr2ogr -f GeoJSON`"),
        ("hexadecimal.wkt", "is WKB", "ST_AsEWKT"),
    ] {
        let output = run(&folder, &format!("triangulate {file}"));
        let said = text(&output.stderr);
        assert!(said.contains(named) && said.contains(help), "{said}");
    }
}

/// The column of a table that holds shapes, as `csvcut` and spreadsheets write it, is a .wkt as the error says.
#[test]
fn a_column_of_shapes_is_read_alone() {
    let folder = folder(&[
        (
            "column.wkt",
            "WKT\n\"POLYGON ((0 0, 4 0, 0 4, 0 0))\"\nPOINT (9 9)\n\"LINEARRING (5 0, 6 0, 6 1, 5 0)\"\n",
        ),
        (
            "measured.geojson",
            r#"{"type": "LineString", "coordinates": [[0, 0, 1, 7], [4, 0, 2, 8], [0, 4, 3]]}"#,
        ),
    ]);
    let output = run(&folder, "triangulate column.wkt");
    let out = text(&output.stdout);
    assert!(
        out.starts_with("column.wkt: points 7, duplicates 0, edges 6"),
        "{out}"
    );
    let output = run(&folder, "triangulate measured.geojson");
    let said = text(&output.stderr);
    assert_eq!(said, "note: measured.geojson: ignored: 2 measures\n");
}

/// Both commands of terrains say what `triangulate` says.
#[test]
fn contradicting_heights_are_said_by_every_command() {
    let note = "equal_points_two.csv: vertex 0 at (0, 0) has two numbers for z, 1 and 99: 1 counts";
    for arguments in [
        "triangulate equal_points_two.csv",
        "heights equal_points_two.csv --at eq_at.csv",
        "contours equal_points_two.csv --every 1",
    ] {
        let (_, said) = done(arguments);
        assert_eq!(said, format!("note: {note}\n"), "{arguments}");
        let said = refused(arguments);
        assert_eq!(said, format!("error: {note}; --strict refuses that\n"));
    }
    let (out, said) = done("heights equal_points.csv --at eq_at.csv");
    assert_eq!((&out[..], &said[..]), ("x,y,z\n0,0,5\n1,1,5\n", ""));
}

#[test]
fn a_number_can_mean_that_there_is_none() {
    let arguments = "contours nodata_9999.xyz --every 1000";
    let (out, said) = done(arguments);
    assert!(out.contains("heights -9999 to 16"), "{out}");
    let hint = "2 heights are -9999, which often means that there is none (--no-value takes a number for that)";
    assert_eq!(said, format!("note: nodata_9999.xyz: {hint}\n"));
    let (out, said) = done(&format!("{arguments} --no-value -9999"));
    assert!(out.contains("heights 12 to 14"), "{out}");
    let note = "note: nodata_9999.xyz: 2 numbers are -9999 and counted as missing\n";
    assert!(said.starts_with(note), "{said}");
    let (_, said) = done(&format!("{arguments} --no-value -1"));
    let none = "note: nodata_9999.xyz: no number is -1\n";
    assert_eq!(said, format!("{none}note: nodata_9999.xyz: {hint}\n"));
}

#[test]
fn maps_that_mean_something_else_get_a_word() {
    let (_, said) = done("triangulate across_180.geojson");
    assert!(
        said.starts_with("note: across_180.geojson: 2 edges span more than 180 degrees"),
        "{said}"
    );
    // A map may say that it is one of degrees, as GDAL writes it.
    let ring = "179 -17, -179.5 -17, -179.5 -16, 179 -16, 179 -17";
    let crs = r#"{"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}"#;
    let line = "[[179, -17], [-179.5, -17], [-179.5, -16], [179, -16]]";
    let degrees = folder(&[
        ("srid.wkt", &format!("SRID=4326;POLYGON (({ring}))")),
        (
            "crs.geojson",
            &format!(r#"{{"type": "LineString", "crs": {crs}, "coordinates": {line}}}"#),
        ),
        ("swiss.wkt", &format!("SRID=2056;POLYGON (({ring}))")),
    ]);
    for (file, is_said) in [
        ("srid.wkt", true),
        ("crs.geojson", true),
        ("swiss.wkt", false),
    ] {
        let output = run(&degrees, &format!("triangulate {file}"));
        let said = text(&output.stderr);
        assert_eq!(
            said.contains("2 edges span more than 180 degrees"),
            is_said,
            "{file}: {said}"
        );
    }
    let (_, said) = done("triangulate outline_traced_twice.geojson");
    assert!(
        said.starts_with("note: outline_traced_twice.geojson: 2 edges are traced twice"),
        "{said}"
    );
    // A slit has each direction once, meters are no degrees, and 180 degrees are not more than half.
    let folder = folder(&[
        (
            "slit.wkt",
            "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0, 3 3, 3 6, 6 6, 6 3, 3 3, 0 0))",
        ),
        (
            "meters.geojson",
            r#"{"type": "LineString", "coordinates": [[-170, 0], [170, 0], [170, 91]]}"#,
        ),
        (
            "half.geojson",
            r#"{"type": "LineString", "coordinates": [[-90, 0], [90, 0], [90, 9]]}"#,
        ),
    ]);
    for name in ["slit.wkt", "meters.geojson", "half.geojson"] {
        let output = run(&folder, &format!("triangulate {name}"));
        assert_eq!(text(&output.stderr), "", "{name}");
    }
}

/// A surface of faces is not taken without a word for that of its corners.
#[test]
fn faces_that_do_not_count_are_said() {
    let folder = folder(&[(
        "tin.obj",
        "v 0 0 0\nv 4 0 4\nv 4 4 0\nv 0 4 4\nf 1 2 4\nf 2 3 4\n",
    )]);
    let arguments = "contours tin.obj --every 1";
    let output = run(&folder, arguments);
    let note = "note: tin.obj: ignored: 2 faces; the hull of the vertices is triangulated \
                (--faces takes them for polygons)\n";
    assert_eq!(text(&output.stderr), note);
    let output = run(&folder, &format!("{arguments} --faces"));
    assert_eq!(text(&output.stderr), "");
}

/// A stream to a `.ply` keeps heights, and makes no height of 0; it says what it leaves out.
#[test]
fn a_stream_says_what_it_leaves_out() {
    let folder = folder(&[
        ("flat.csv", "x,y\n0,0\n4,0\n0,4\n"),
        ("high.csv", "x,y,z\n0,0,7\n4,0,7\n0,4,7\n"),
        ("high.node", "3 2 1 1\n1 0 0 7 1\n2 4 0 7 1\n3 0 4 7 1\n"),
        (
            "high.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 7\n4 0 7\n0 4 7\n3 0 1 2\n",
        ),
    ]);
    for (input, note) in [
        ("flat.csv", None),
        ("high.csv", None),
        ("high.node", None),
        ("high.ply", Some("1 record of the element `face`")),
    ] {
        let arguments = format!("stream {input} -o out.ply");
        let output = run(&folder, &arguments);
        let said = note.map(|note| format!("note: {input}: ignored: {note}\n"));
        assert_eq!(text(&output.stderr), said.unwrap_or_default(), "{input}");
        let bytes = std::fs::read(folder.path().join("out.ply")).expect("the output");
        let head = b"end_header\n";
        let body = bytes.windows(head.len()).position(|window| window == head);
        let z = &bytes[body.expect("a header") + head.len() + 16..][..8];
        let z = f64::from_le_bytes(z.try_into().expect("eight bytes"));
        let expected = if input == "flat.csv" { 0.0 } else { 7.0 };
        assert_eq!(z.to_bits(), f64::to_bits(expected), "{input}: {z}");
        let strict = run(&folder, &format!("{arguments} --strict"));
        assert_eq!(strict.status.success(), note.is_none(), "{input}");
    }
    let output = run(&folder, "stream high.node");
    let note = "note: high.node: ignored: 1 attribute of each vertex, 1 marker of each vertex\n";
    assert_eq!(text(&output.stderr), note);
    let said = refused("stream cloud_with_z.csv");
    assert!(said.contains("1 column `z`"), "{said}");
}

/// Heights at all corners of a star, and of points along a needle: none is missing.
#[test]
fn heights_at_vertices_are_those_of_the_vertices() {
    let height = |row: &str| row.rsplit(',').next().expect("a field").to_owned();
    let heights = |out: &str| out.lines().skip(1).map(height).collect::<Vec<String>>();
    let (out, said) = done("heights star_with_heights.wkt --at star_corners.csv");
    let expected: Vec<String> = (10..26).map(|z| z.to_string()).collect();
    assert_eq!((heights(&out), &said[..]), (expected, ""));
    let (out, said) = done("heights needle_points.csv --at needle_points.csv");
    let expected = ["0", "10", "20", "30", "40", "50"].map(str::to_owned);
    assert_eq!((heights(&out), &said[..]), (expected.to_vec(), ""));
}

/// The second table of the reports: what was right stays right.
#[test]
fn results_that_other_programs_missed() {
    for (arguments, expected) in [
        ("drufat70.json --verify", "triangles 4,"),
        ("drufat70.json --inside even-odd", "inside 3 of 4"),
        ("drufat70.json --inside holes", "inside 3 of 4"),
        ("shapely2314.json --verify", "triangles 2,"),
        ("thin_wall.wkt --verify", "inside 14 of 18"),
        (
            "half_float_outline.json --split-crossings --verify",
            "new vertices 161",
        ),
        ("kninnug16.json --verify", "triangles 8,"),
    ] {
        let (out, _) = done(&format!("triangulate {arguments}"));
        assert!(out.contains(expected), "{arguments}: {out}");
        let is_verified = out.contains("correct: the result is");
        assert_eq!(is_verified, arguments.contains("--verify"), "{arguments}");
    }
    let (out, _) = done("contours saddle_of_zeros.csv --every 1");
    assert!(out.contains("lines 6, closed 0"), "{out}");
    let (read, said) = vertices("triangulate null_heights.csv");
    let missing = read.iter().filter(|line| line.ends_with("NaN")).count();
    assert_eq!(missing, 2, "{read:?}");
    assert!(said.contains("2 of 5 vertices have no height"), "{said}");
    let output = run(REPORTS, "verify sixty.json sixty_3_decimals.obj");
    let said = text(&output.stderr);
    assert!(
        said.contains("the nearest is vertex 4 at") && said.contains("(--tolerance 0.0005 accepts"),
        "{said}"
    );
}
