//! Several inputs as layers of one: terrain of contour lines, a border and breaklines; and what messages call their parts.

use crate::outputs::read;
use crate::{assert_fails, feed, folder, printed, run, sweep_cdt, text};

/// Lines at two heights of a slope that rises by 2 for each 1 to the north.
const CONTOURS: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"elev": 10}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [10, 0]]}},
{"type": "Feature", "properties": {"elev": 30}, "geometry": {"type": "LineString", "coordinates": [[0, 10], [10, 10]]}}
]}"#;
/// A square with a notch, whose tip is at no end of a contour line.
const BORDER: &str =
    r#"{"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [5, 5], [0, 10], [0, 0]]]}"#;
const BREAKLINES: &str = "LINESTRING Z (2 1 12, 8 1 12)";
const FILES: [(&str, &str); 3] = [
    ("contours.geojson", CONTOURS),
    ("border.geojson", BORDER),
    ("breaklines.wkt", BREAKLINES),
];
const NAMES: &str = "contours.geojson border.geojson breaklines.wkt";

#[test]
fn contour_lines_a_border_and_breaklines_are_one_terrain() {
    let folder = folder(&FILES);
    let output = run(&folder, &format!("{NAMES} --missing interpolate"));
    assert_eq!(
        text(&output.stderr),
        "note: contours.geojson: heights are the property `elev` of 2 features\n\
         note: contours.geojson and 2 others: 1 height is interpolated\n"
    );
    assert_eq!(
        text(&output.stdout),
        "contours.geojson and 2 others: points 11, duplicates 4, edges 8, triangles 8, hull 4\n\
         equal positions that became one vertex with another: 1\n\
         inside 7 of 8 triangles: rule polygons, as the input has 1 polygon; --inside hull keeps all\n"
    );
    run(
        &folder,
        &format!("{NAMES} --missing interpolate -o a.node -o a.geojson"),
    );
    // The border has the heights of the contour lines at whose ends it is.
    assert_eq!(
        read(&folder, "a.node"),
        "11 2 1 0\n0 0 0 10\n1 10 0 10\n2 0 10 30\n3 10 10 30\n\
         4 0 0 10\n5 10 0 10\n6 10 10 30\n7 5 5 20\n8 0 10 30\n9 2 1 12\n10 8 1 12\n"
    );
    let features = read(&folder, "a.geojson");
    assert_eq!(features.matches("\"feature\":3").count(), 7, "{features}");

    let mut contours = sweep_cdt(
        &folder,
        &format!("contours {NAMES} --missing interpolate --every 14"),
    );
    let contours = contours.output().expect("the command starts");
    assert_eq!(
        text(&contours.stdout),
        "contours.geojson and 2 others: heights 10 to 30, levels 2, lines 3, closed 0\n"
    );
}

/// An equal vertex of another layer has the height before all others that are asked for.
#[test]
fn missing_heights_are_first_those_of_equal_points() {
    let folder = folder(&FILES);
    for missing in ["7.5", "refuse"] {
        let output = run(
            &folder,
            &format!("contours.geojson border.geojson --missing {missing} -o a.node"),
        );
        if missing == "refuse" {
            let error =
                "vertex 3 of border.geojson at (5, 5) has no height, and 0 others have none";
            let note = "note: contours.geojson: heights are the property `elev` of 2 features\n";
            assert_eq!(
                text(&output.stderr),
                format!(
                    "{note}error: contours.geojson and border.geojson: {error} (--missing interpolate makes them)\n"
                )
            );
        } else {
            let vertices = read(&folder, "a.node");
            assert!(
                vertices.ends_with("\n6 10 10 30\n7 5 5 7.5\n8 0 10 30\n"),
                "{vertices}"
            );
        }
    }
}

#[test]
fn two_coordinate_systems_are_refused_by_the_names_of_both_files() {
    let line = "LINESTRING (0 0, 1 1)\n";
    let folder = folder(&[
        ("a.wkt", line),
        ("b.wkt", &format!("SRID=25832;{line}")),
        ("c.wkt", &format!("SRID=4326;{line}")),
    ]);
    let output = run(&folder, "a.wkt b.wkt c.wkt");
    assert_fails(
        &output,
        "c.wkt: the coordinate system is EPSG:4326, and that of b.wkt is EPSG:25832: files of one input must have the same",
    );
}

/// A road, numbered from 1, that crosses the upper contour line and no vertex.
const ROADS: &str = "3 2 1 0\n1 4 6 1\n2 4 8 5\n3 4 12 9\n2\n1 1 2\n2 2 3\n0\n";

#[test]
fn edges_of_two_layers_that_cross_have_the_names_of_both_files() {
    let folder = folder(&[("lines.geojson", CONTOURS), ("roads.poly", ROADS)]);
    let both = "edges 1 and 3 cross near (4, 10), a line of feature 2 of lines.geojson and edge 2 of roads.poly";
    let way_out =
        "(`sweep-cdt crossings` lists all that do, --split-crossings makes vertices of them)";
    let note = "note: lines.geojson: heights are the property `elev` of 2 features\n";
    for missing in ["", "--missing interpolate"] {
        let output = run(&folder, &format!("lines.geojson roads.poly {missing}"));
        assert_eq!(
            text(&output.stderr),
            format!("{note}error: lines.geojson and roads.poly: {both} {way_out}\n")
        );
    }
    let listed = sweep_cdt(&folder, "crossings lines.geojson roads.poly").output();
    let listed = listed.expect("the command starts");
    assert_eq!(
        text(&listed.stdout),
        format!("lines.geojson and roads.poly: edges 4, crossings 1\n{both}\n")
    );
    let split = run(&folder, "lines.geojson roads.poly --split-crossings");
    let split = text(&split.stdout);
    assert!(
        split.contains(": 4 edges split into 6, new vertices 1, "),
        "{split}"
    );
}

/// An edge without heights takes no part, and the others keep their numbers.
#[test]
fn edges_that_cross_have_their_numbers_where_heights_are_interpolated() {
    let crossing = "5 2 1 0\n1 0 0 nan\n2 9 9 nan\n3 0 9 1\n4 4 4 2\n5 9 0 3\n";
    let folder = folder(&[
        ("a.poly", &format!("{crossing}3\n1 1 2\n2 3 5\n3 4 4\n0\n")),
        ("b.poly", "2 2 1 0\n1 1 0 1\n2 8 9 5\n1\n1 1 2\n0\n"),
    ]);
    let output = run(&folder, "a.poly b.poly --missing interpolate");
    let error = text(&output.stderr);
    assert!(
        error.contains("edge 2 of a.poly and edge 1 of b.poly"),
        "{error}"
    );
}

#[test]
fn seeds_have_the_names_of_their_files() {
    let square = "4\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n";
    let folder = folder(&[
        ("a.poly", &format!("{square}1\n1 1 1\n")),
        ("b.poly", "0\n0\n1\n1 9 9\n"),
        ("b.node", "1 2 0 0\n1 2 2\n"),
        (
            "c.geojson",
            r#"{"type": "LineString", "coordinates": [[0, 4], [1, 7]]}"#,
        ),
    ]);
    assert_fails(
        &run(&folder, "a.poly b.poly"),
        "a.poly and b.poly: the seed of hole 2 lies outside of the hull, at (9, 9), hole 1 of b.poly \
         (--inside hull keeps all triangles)",
    );
    assert_fails(
        &run(&folder, "a.poly c.geojson --inside even-odd"),
        "a.poly and c.geojson: the edges are no closed rings: they do not go on at vertex 4, at (0, 4), vertex 4 of a.poly",
    );
}

/// Every subcommand makes of two tables what it makes of one with the rows of both.
#[test]
fn layers_are_taken_by_all_subcommands() {
    let (one, other) = ("0,0,1\n9,1,2\n8,8,6\n", "1,7,5\n4,3,3\n");
    let head = "x,y,z\n";
    let folder = folder(&[
        ("a.csv", &format!("{head}{one}")),
        ("b.csv", &format!("{head}{other}")),
        ("all.csv", &format!("{head}{one}{other}")),
        ("at.csv", "x,y\n5,5\n"),
    ]);
    for subcommand in [
        "triangulate -o o.json -o o.ele -o o.svg",
        "refine --min-angle 25 -o o.json",
        "voronoi -o o.json -o o.geojson -o o.svg",
        "heights --at at.csv -o o.csv",
        "contours --every 1 -o o.geojson",
        "crossings -o o.csv --svg o.svg",
    ] {
        let outputs = subcommand.split(' ').filter(|word| word.starts_with("o."));
        let outputs: Vec<&str> = outputs.collect();
        let made = |inputs: &str| {
            let (name, others) = subcommand.split_once(' ').expect("options");
            let output = sweep_cdt(&folder, &format!("{name} {inputs} {others}")).output();
            let output = output.expect("the command starts");
            let said = [text(&output.stdout), text(&output.stderr)].concat();
            let files = outputs.iter().map(|output| read(&folder, output));
            (files.collect::<Vec<_>>(), said)
        };
        let (whole, said) = made("all.csv");
        let (layers, said_of_layers) = made("a.csv b.csv");
        assert_eq!(layers, whole, "{subcommand}");
        assert_eq!(
            said_of_layers,
            said.replace("all.csv", "a.csv and b.csv"),
            "{subcommand}"
        );
    }
}

/// Fractions in one layer make the numbers of all exact. Options for tables and for formats count for each of them.
#[test]
fn layers_of_other_formats_are_read_as_they_are() {
    let folder = folder(&[
        ("a.json", r#"{"points": [["1/3", 0], [1, 0]]}"#),
        ("b.csv", "7,0,1\n"),
        ("c.dat", "9,2,3\n"),
    ]);
    let mut both = sweep_cdt(
        &folder,
        "triangulate a.json b.csv - c.dat --columns 2,3 --input-format csv -o - --output-format node",
    );
    let output = feed(&mut both, b"5,0.5,0.5\n");
    let vertices = text(&output.stdout);
    let expected = "5 2 1 0\n0 1/3 0 NaN\n1 1 0 NaN\n2 0 1 7\n3 1/2 1/2 5\n4 2 3 9\n";
    assert_eq!(vertices, expected, "{}", text(&output.stderr));
    let unknown = run(&folder, "a.json c.dat");
    assert!(text(&unknown.stderr).contains("the format of c.dat is not known"));
}

/// What takes one input refuses a second one, and an output that was a layer is not overwritten.
#[test]
fn layers_are_refused_where_there_is_one_input() {
    let folder = folder(&FILES);
    let output = sweep_cdt(&folder, "trace a.json b.json").output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("unexpected argument"));
    let output = run(&folder, "contours.geojson border.geojson -o border.geojson");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("border.geojson is an input and would be overwritten"));
    assert_eq!(read(&folder, "border.geojson"), BORDER);
    assert_eq!(printed(&run(&folder, "border.geojson -o a.svg")), "");
}

/// Triangles have the properties of the feature that covers them, in the order of the files. Outputs without room say so.
#[test]
fn triangles_have_the_properties_of_their_features() {
    let area = |name: &str, x: u8| {
        let ring = format!("[[{x},0],[{},0],[{x},4],[{x},0]]", x + 4);
        format!(
            r#"{{"type":"Feature","properties":{{"name":"{name}"}},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
        )
    };
    let folder = folder(&[
        ("a.geojson", &area("meadow", 0)),
        ("b.geojson", &area("pond", 4)),
    ]);
    let output = run(&folder, "a.geojson b.geojson -o t.geojson --strict");
    assert_eq!((text(&output.stderr), output.status.code()), ("", Some(0)));
    let written = read(&folder, "t.geojson");
    for named in [
        r#""properties":{"feature":1,"name":"meadow"}"#,
        r#""properties":{"feature":2,"name":"pond"}"#,
    ] {
        assert_eq!(written.matches(named).count(), 1, "{written}");
    }
    for (arguments, what) in [
        (
            "-o t.wkt",
            "t.wkt: not written: features of triangles, the property `name`",
        ),
        (
            "-o t.geojson --inside hull",
            "t.geojson: not written: the property `name`",
        ),
    ] {
        let output = run(&folder, &format!("a.geojson {arguments}"));
        assert_eq!(text(&output.stderr), format!("note: {what}\n"));
    }
    let output = sweep_cdt(&folder, "crossings a.geojson").output();
    let note = "note: a.geojson: ignored: 1 property `name`\n";
    assert_eq!(text(&output.expect("the command starts").stderr), note);
}
