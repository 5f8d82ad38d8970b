//! Terrain: contour lines and heights, the picture, and generated contour lines with their heights.

use std::fs;

use crate::outputs::{assert_refused, read};
use crate::stream::ran;
use crate::{CONTOURS, assert_fails, folder, names, printed, run, sweep_cdt, text};

/// A pyramid, whose top is 10 high, numbered from 1.
const PYRAMID: &str = "5 2 1 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 2 2 10\n0 0\n0\n";
/// The pyramid, and a vertex on its right without a height.
const GAP: &str = "6 2 1 0\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n5 2 2 10\n6 8 2 nan\n0 0\n0\n";

#[test]
fn contour_lines_have_their_heights_in_every_format() {
    let folder = folder(&[("a.poly", PYRAMID)]);
    let written = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("contours a.poly {arguments}")).output();
        printed(&output.expect("the command starts")).to_owned()
    };
    // At 0 everything is above, at 10 there is a peak.
    let summary = "a.poly: heights 0 to 10, levels 3, lines 1, closed 1\n";
    assert_eq!(written("--every 5"), summary);
    assert_eq!(written("--every 5 -o a.geojson"), summary);
    assert_eq!(
        read(&folder, "a.geojson"),
        "{\"type\":\"FeatureCollection\",\"features\":[\n\
         {\"type\":\"Feature\",\"properties\":{\"elev\":5},\"geometry\":{\"type\":\"LineString\",\
         \"coordinates\":[[1,1,5],[3,1,5],[3,3,5],[1,3,5],[1,1,5]]}}]}\n"
    );
    // 1/6, 1/2, ... up to 59/6.
    let wkt = written("--every 1/3 --from 4.5 -o - --output-format wkt");
    assert_eq!(wkt.lines().count(), 1 + 30);
    assert!(wkt.contains("\n(1.9 1.9 9.5,2.1 1.9 9.5,2.1 2.1 9.5,1.9 2.1 9.5,1.9 1.9 9.5),\n"));
    let poly = "4 2 1 0\n0 1 1 5\n1 3 1 5\n2 3 3 5\n3 1 3 5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";
    assert_eq!(
        written("--every 10 --from 5 -o - --output-format poly"),
        poly
    );
    let none = "MULTILINESTRING Z EMPTY\n";
    assert_eq!(
        written("--every 100 --from -3 -o - --output-format wkt"),
        none
    );
}

/// What is written is read again, with its heights: the shipped lines, from which more lines are drawn.
#[test]
fn contour_lines_are_read_again() {
    let folder = folder(&[]);
    let contours = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("contours {arguments}")).output();
        let output = output.expect("the command starts");
        // Of the rounded lines two meet in one place, which the second run says.
        let others = text(&output.stderr).lines();
        let mut others = others.filter(|line| !line.contains(" has two numbers for z, "));
        assert_eq!(others.next(), None);
        text(&output.stdout).to_owned()
    };
    // The shipped lines are 20 m apart from 309.37 m on.
    let summary = contours(&format!("{CONTOURS} --every 20 --from 319.37 -o a.geojson"));
    assert!(
        summary.contains(": heights 309.37 to 989.37, levels 34, lines "),
        "{summary}"
    );
    // At the border some triangles are thinner than the rounding of the lines.
    let again = contours("a.geojson --split-crossings --every 20 --from 9.37");
    assert!(
        again.starts_with("a.geojson: heights 319.37 to 979.37, levels 33, lines "),
        "{again}"
    );
}

#[test]
fn points_get_the_heights_of_the_terrain() {
    // On a slope, at the top, on a side, at a corner, and outside.
    let points = "5 2 1 0\n1 2 1 77\n2 2 2 0\n3 1 1 0\n4 0 0 0\n5 9 9 3\n";
    let folder = folder(&[
        ("a.poly", PYRAMID),
        ("b.node", points),
        ("c.json", r#"{"points": [["2/1", "2/3"], [-1, 0]]}"#),
    ]);
    let heights = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("heights a.poly {arguments}")).output();
        let output = output.expect("the command starts");
        assert_eq!(output.status.code(), Some(0));
        [text(&output.stdout), text(&output.stderr)].map(str::to_owned)
    };
    let [written, note] = heights("--at b.node");
    assert_eq!(
        written,
        "5 2 1 0\n1 2 1 5\n2 2 2 10\n3 1 1 5\n4 0 0 0\n5 9 9 NaN\n"
    );
    let words = "b.node: 1 of 5 points have no height: they are on no triangle that has three";
    assert_eq!(note, format!("note: {words}\n"));
    let [written, _] = heights("--at c.json");
    // 2/3 of the way up a slope of 10 in 2.
    let expected =
        "{\n\"points\": [\n[2,\"2/3\",3.3333333333333335],\n[-1,0]],\n\"edges\": []\n}\n";
    assert_eq!(written, expected);
    let [written, note] = heights("--at b.node -o d.obj");
    assert_eq!(written, "");
    assert_eq!(note, format!("note: {words}\n"));
    assert!(read(&folder, "d.obj").starts_with("v 2 1 5\nv 2 2 10\nv 1 1 5\nv 0 0 0\n"));
}

/// A table stays as it is, with one more column; another format has the columns of numbers.
#[test]
fn points_as_text_get_a_column_of_heights() {
    let folder = folder(&[
        ("a.poly", PYRAMID),
        (
            "b.csv",
            "kind,x,y,girth\noak,2,1,0.5\n\"elm\",9,9,0.25\noak,2,1,0.75\n",
        ),
    ]);
    let heights = |output: &str| {
        let arguments = format!("heights a.poly --at b.csv --strict -o {output}");
        let output = sweep_cdt(&folder, &arguments).output();
        let output = output.expect("the command starts");
        (output.status.code(), text(&output.stderr).to_owned())
    };
    let missing =
        "note: b.csv: 1 of 3 points have no height: they are on no triangle that has three\n";
    assert_eq!(heights("c.csv"), (Some(0), missing.to_owned()));
    assert_eq!(
        read(&folder, "c.csv"),
        "kind,x,y,girth,z\noak,2,1,0.5,5\n\"elm\",9,9,0.25,\noak,2,1,0.75,5\n"
    );
    let lost = "error: b.csv: ignored: 1 column `kind`; --strict refuses that\n";
    assert_eq!(heights("c.xyz"), (Some(1), lost.to_owned()));
}

/// Numbers of the points are doubles, and those of the terrain fractions.
#[test]
fn features_get_heights_of_exact_terrain() {
    let terrain = r#"{"points": [["1/3", 0, 1], [9, 0, 1], [0, 9, 1]]}"#;
    let line = r#"{"type":"LineString","coordinates":[[1,0.1],[0.1,1.2],[70,1]]}"#;
    let folder = folder(&[("a.json", terrain), ("b.geojson", line)]);
    let output = sweep_cdt(&folder, "heights a.json --at b.geojson").output();
    assert_eq!(
        text(&output.expect("the command starts").stdout),
        r#"{"type":"LineString","coordinates":[[1,0.1,1],[0.1,1.2],[70,1]]}"#
    );
}

/// The columns of the terrain, and those of the points.
#[test]
fn columns_are_chosen_of_both_files() {
    let survey = "1,0,0,0\n2,4,0,0\n3,0,4,8\n";
    let folder = folder(&[("a.csv", survey), ("b.csv", "1,1,0,77\n2,1,1,0\n3,0,2,0\n")]);
    let heights = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("heights a.csv --at b.csv {arguments}")).output();
        output.expect("the command starts")
    };
    let counts = "the columns have no names, and the first counts the rows, 1, 2, 3 and so on, as names of points do: \
                  put names in the first row, x and y among them";
    let way_out = "names or numbers those of x, y and perhaps z: `";
    let refused = format!("a.csv: {counts} (or --columns {way_out}--columns 2,3`)");
    assert_fails(&heights(""), &refused);
    let refused = format!("b.csv: {counts} (or --at-columns {way_out}--at-columns 2,3`)");
    assert_fails(&heights("--columns 2,3,4"), &refused);
    let made = heights("--columns 2,3,4 --at-columns 2,3 --output-format xyz");
    assert_eq!(
        text(&made.stdout),
        "x y z column1 column4\n1 0 0 1 77\n1 1 2 2 0\n0 2 4 3 0\n"
    );
}

/// A map stays as it is, but for heights. In another format it has a feature for each point.
#[test]
fn points_of_a_map_are_features() {
    let feature = |x: u8, y: u8| {
        format!(
            r#"{{"type":"Feature","properties":{{"id":7}},"geometry":{{"type":"Point","coordinates":[{x},{y}]}}}}"#
        )
    };
    let wells = format!(
        r#"{{"type":"FeatureCollection","name":"wells","features":[{},{}]}}"#,
        feature(2, 1),
        feature(2, 2)
    );
    let folder = folder(&[("a.poly", PYRAMID), ("b.geojson", &wells)]);
    let output = sweep_cdt(&folder, "heights a.poly --at b.geojson --strict").output();
    let output = output.expect("the command starts");
    assert_eq!(text(&output.stderr), "");
    let expected = wells
        .replace("[2,1]", "[2,1,5]")
        .replace("[2,2]", "[2,2,10]");
    assert_eq!(text(&output.stdout), expected);
    let output = sweep_cdt(&folder, "heights a.poly --at b.geojson -o c.csv").output();
    assert_eq!(
        text(&output.expect("the command starts").stderr),
        "note: b.geojson: ignored: 2 properties `id`\n"
    );
    assert_eq!(read(&folder, "c.csv"), "x,y,z\n2,1,5\n2,2,10\n");
}

/// A polygon bounds the lines, its coordinate system goes through, and a vertex without a height gets one on request.
#[test]
fn maps_keep_their_outlines_and_systems() {
    let map = "SRID=25832;GEOMETRYCOLLECTION Z (POLYGON Z ((0 0 0,4 0 8,4 4 8,0 4 0,0 0 0)),\
               POINT Z (9 2 8),POINT Z (2 2 NaN))";
    let folder = folder(&[("a.wkt", map)]);
    let contours = |arguments: &str| {
        let output = sweep_cdt(&folder, &format!("contours a.wkt --every 6 {arguments}")).output();
        let output = output.expect("the command starts");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout).to_owned()
    };
    let line = contours("--missing interpolate -o - --output-format wkt");
    // The slope rises by 2 a step: one straight line, between two sides of the outline.
    assert!(
        line.starts_with("SRID=25832;MULTILINESTRING Z (\n(3 4 6,"),
        "{line}"
    );
    assert!(
        line.ends_with(",3 0 6))\n") && line.lines().count() == 2,
        "{line}"
    );
    let map = contours("--missing interpolate -o - --output-format geojson");
    assert!(
        map.contains("\"crs\":") && map.contains("EPSG::25832"),
        "{map}"
    );
}

#[test]
fn triangles_without_heights_are_left_out_and_said() {
    let folder = folder(&[("a.poly", GAP), ("b.node", "1 2 0 0\n0 5 2\n")]);
    let output = sweep_cdt(&folder, "contours a.poly --every 4").output();
    let output = output.expect("the command starts");
    let note = "note: a.poly: 1 of 5 triangles have a corner without a height, and are left out\n";
    assert_eq!(text(&output.stderr), note);
    let summary = "a.poly: heights 0 to 10, levels 3, lines 2, closed 2\n";
    assert_eq!(text(&output.stdout), summary);
    let output = sweep_cdt(&folder, "heights a.poly --at b.node").output();
    let output = output.expect("the command starts");
    assert_eq!(text(&output.stdout), "1 2 1 0\n0 5 2 NaN\n");
    assert!(text(&output.stderr).starts_with(note));
}

#[test]
fn what_makes_no_terrain_is_refused() {
    let flat = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";
    let folder = folder(&[("a.poly", PYRAMID), ("b.node", flat)]);
    let fails = |arguments: &str, error: &str| {
        let output = sweep_cdt(&folder, arguments).output();
        assert_fails(&output.expect("the command starts"), error);
    };
    let words = "the vertices have no heights: a third coordinate, the column z, the first attribute of a .node or .poly, or the property of a .geojson or column of a .csv that --height-property names";
    fails("contours b.node --every 1", &format!("b.node: {words}"));
    fails("heights b.node --at a.poly", &format!("b.node: {words}"));
    fails(
        "contours a.poly --every 1e-9",
        "a.poly: there are more than 1000000 levels between the lowest and the highest height: \
         choose levels that are further apart",
    );
    for (arguments, message) in [
        (
            "contours a.poly --every 0",
            "--every: levels must be more than 0 apart",
        ),
        (
            "contours a.poly --every x",
            "invalid value 'x' for '--every <DISTANCE>': `x` is not a coordinate",
        ),
        (
            "contours a.poly --every 1 -o a.poly",
            "a.poly is an input and would be overwritten",
        ),
        (
            "heights a.poly --at b.node -o b.node",
            "b.node is an input and would be overwritten",
        ),
    ] {
        assert_refused(&folder, arguments, message);
    }
    let output = sweep_cdt(&folder, "heights a.poly --at b").output();
    let output = output.expect("the command starts");
    let message = "error: the format of b is not known: add --at-format with one of node, poly, ";
    assert!(text(&output.stderr).starts_with(message));
    assert_eq!(names(folder.path()), ["a.poly", "b.node"]);
}

#[test]
fn pictures_of_terrain_say_their_heights() {
    let folder = folder(&[
        ("a.poly", GAP),
        ("b.poly", &PYRAMID.replace(" 10\n", " 0\n")),
    ]);
    printed(&run(&folder, "a.poly -o a.svg -o a.png"));
    let picture = read(&folder, "a.svg");
    for text in [">z: 0</text>", ">10</text>", ">no height: 1</text>"] {
        assert!(picture.contains(text), "{text}");
    }
    let png = fs::read(folder.path().join("a.png")).expect("a file");
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    // Level ground has no tints.
    printed(&run(&folder, "b.poly -o b.svg"));
    assert!(!read(&folder, "b.svg").contains("relief"));
}

#[test]
fn generated_contour_lines_have_heights() {
    let folder = folder(&[]);
    let output = sweep_cdt(&folder, "generate contours 20000 -o a.geojson").output();
    printed(&output.expect("the command starts"));
    let output = sweep_cdt(&folder, "contours a.geojson --every 1 --from 0.5").output();
    let summary = printed(&output.expect("the command starts")).to_owned();
    // The lines are at whole heights, 1 apart; between two of them there is a level.
    let numbers: Vec<i64> = summary
        .split([' ', ',', '\n'])
        .filter_map(|word| word.parse().ok())
        .collect();
    let [low, high, levels, lines, _] = numbers[..] else {
        panic!("five numbers: {summary}")
    };
    assert!(
        high - low == levels && levels > 5 && lines >= levels,
        "{summary}"
    );
}

/// Nothing of the rows gets lost but their order of columns; a map without a system has that of the terrain.
#[test]
fn rows_become_features() {
    let crs = r#""crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}}"#;
    let terrain =
        format!(r#"{{"type":"MultiPoint",{crs},"coordinates":[[0,0,1],[4,0,2],[0,4,3]]}}"#);
    let rows = "kind;x;old;y;z;kind;note;feature\n07;1;5;1;9;2.50;a \"b\";\n-;0;x;0;;n/a\n8;9;1e3;9;;;\"c;d\";f\n";
    let folder = folder(&[
        ("a.geojson", &terrain),
        ("rows.csv", rows),
        ("b.xyz", "0 0 7 5\n"),
    ]);
    let arguments = "heights a.geojson --at rows.csv --strict -o b.geojson";
    let output = sweep_cdt(&folder, arguments)
        .output()
        .expect("the command starts");
    assert_eq!(
        text(&output.stderr),
        "note: rows.csv: 1 of 3 points have no height: they are on no triangle that has three\n"
    );
    let point = |properties: &str, place: &str| {
        format!(
            r#"{{"type":"Feature","properties":{{{properties}}},"geometry":{{"type":"Point","coordinates":[{place}]}}}}"#
        )
    };
    let features = [
        point(
            r#""kind":"07","old":5,"kind_2":2.50,"note":"a \"b\"","feature_2":null"#,
            "1,1,1.75",
        ),
        point(
            r#""kind":null,"old":"x","kind_2":null,"note":null,"feature_2":null"#,
            "0,0,1",
        ),
        point(
            r#""kind":8,"old":1e3,"kind_2":null,"note":"c;d","feature_2":"f""#,
            "9,9",
        ),
    ];
    let expected = format!(
        "{{\"type\":\"FeatureCollection\",{crs},\"features\":[\n{}]}}\n",
        features.join(",\n")
    );
    assert_eq!(read(&folder, "b.geojson"), expected);
    let output = sweep_cdt(&folder, "heights a.geojson --at b.xyz -o c.geojson").output();
    assert_eq!(output.expect("the command starts").status.code(), Some(0));
    assert!(read(&folder, "c.geojson").contains(&point(r#""column4":5"#, "0,0,1")));
}

/// An extension that is not known may mean another format, and a stream reads less than memory.
#[test]
fn formats_of_names_are_not_guessed() {
    let folder = folder(&[
        ("t.csv", "x,y,z\n0,0,1\n1,0,1\n0,1,1\n"),
        ("l.geojson", "{}"),
    ]);
    for (arguments, why) in [
        (
            "heights t.csv --at t.csv -o x.tif",
            "the format of x.tif is not known: add --output-format with one of ",
        ),
        (
            "stream l.geojson -o t.u32",
            "l.geojson: a stream reads no .geojson, but f64, ",
        ),
    ] {
        let made = ran(&folder, arguments);
        assert!(
            text(&made.stderr).starts_with(&format!("error: {why}")),
            "{}",
            text(&made.stderr)
        );
        assert_eq!(made.status.code(), Some(2));
    }
    printed(&ran(&folder, "heights t.csv --at t.csv -o heights"));
}
