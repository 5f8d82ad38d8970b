//! Inputs from public reports, each with the result that it must have (`tests/data/reports/README.md` has the sources).
//! Areas and counts come from the reports, or from hand.

use std::process::Output;

use serde_json::Value;

use crate::{folder, run, text, without_losses};

const REPORTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/reports");

/// The JSON that a run writes, and what it says.
#[track_caller]
fn result(arguments: &str) -> (Value, String) {
    let output = run(REPORTS, &format!("{arguments} -o - --output-format json"));
    let said = text(&output.stderr).to_owned();
    assert!(output.status.success(), "{arguments}: {said}");
    let json = serde_json::from_slice(&output.stdout);
    (json.expect("JSON"), said)
}

fn number(value: &Value) -> f64 {
    match value {
        Value::String(fraction) => {
            let (p, q) = fraction.split_once('/').expect("a fraction");
            p.parse::<f64>().expect("a number") / q.parse::<f64>().expect("a number")
        }
        value => value.as_f64().expect("a number"),
    }
}

/// How many triangles there are, and their area.
fn area(json: &Value) -> (usize, f64) {
    let point = |v: &Value| {
        let vertex: usize = serde_json::from_value(v.clone()).expect("a vertex");
        let point = &json["points"][vertex];
        [number(&point[0]), number(&point[1])]
    };
    let triangles = json["triangles"].as_array().expect("triangles");
    let areas = triangles.iter().map(|triangle| {
        let [a, b, c] = [0, 1, 2].map(|i| point(&triangle[i]));
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
    });
    (triangles.len(), areas.sum())
}

#[test]
fn what_is_inside_has_the_area_that_was_meant() {
    for (arguments, triangles, expected) in [
        // The hull without the hole of an open box, and nothing where the outside comes in.
        (
            "open_box_with_hole.poly --inside hull-without-holes",
            Some(8),
            72.0,
        ),
        ("open_box_with_hole.poly", Some(0), 0.0),
        // Rings are borders, lines are not; a hole that sticks out takes away what it covers of the outline.
        ("boundary_hole_breakline.geojson", None, 384.0),
        ("hole_sticks_out.wkt --split-crossings", None, 33750.0),
        (
            "hole_sticks_out.wkt --split-crossings --scalar rational",
            None,
            33750.0,
        ),
        (
            "raw_offset.json --split-crossings --inside positive",
            None,
            1600.0,
        ),
        ("ngon_face.obj --faces", None, 7.0),
        ("holes_in_json.json --inside holes", None, 15.5),
        ("holes_in_json.json", None, 15.5),
        ("clipper1058.json --inside even-odd", Some(24), f64::NAN),
        ("gte5.json --inside even-odd", Some(12), f64::NAN),
        ("ifc2095.json --inside even-odd", Some(14), f64::NAN),
        ("cdt176b.json --inside even-odd", None, 9.0),
        ("qhull166.json", Some(4), f64::NAN),
        ("pode15.json", Some(1), f64::NAN),
        ("earcut177.geojson --inside even-odd", None, 454.5),
        ("earcut177.geojson", None, 454.5),
        ("earcut129a.wkt", None, 184.5),
        ("earcut45.wkt", None, 400.0),
        ("earcut136_shared_edges.wkt", None, 11.0),
        ("threejs11670.wkt", None, 75000.0),
        ("L_without_holes.poly", Some(5), 11.5),
        ("L_without_holes.poly --inside holes", Some(4), 7.0),
    ] {
        let (json, _) = result(arguments);
        let (count, area) = area(&json);
        if let Some(triangles) = triangles {
            assert_eq!(count, triangles, "{arguments}");
        }
        let is_right = expected.is_nan() || (area - expected).abs() <= 1e-9 * expected;
        assert!(is_right, "{arguments}: {area}");
    }
}

/// The third coordinates, and which points have none.
fn heights(json: &Value) -> Vec<Option<f64>> {
    let points = json["points"].as_array().expect("points");
    points
        .iter()
        .map(|point| point.get(2).map(number))
        .collect()
}

#[test]
fn no_height_is_invented_and_none_is_lost() {
    let (soft, _) = result("soft_breakline.geojson");
    let known = heights(&soft);
    assert_eq!(known.iter().filter(|height| height.is_none()).count(), 2);
    assert!(!known.contains(&Some(0.0)));
    let (filled, said) = result("soft_breakline.geojson --missing interpolate");
    assert!(heights(&filled).iter().all(Option::is_some), "{said}");
    assert!(said.contains("2 heights are interpolated"), "{said}");
    let refused = run(REPORTS, "soft_breakline.geojson --missing refuse");
    let error = without_losses(&refused.stderr);
    assert!(
        error.contains("has no height, and 1 others have none"),
        "{error}"
    );
    let (filled, _) = result("soft_breakline.geojson --missing -7.5");
    let given = heights(&filled)
        .iter()
        .filter(|height| **height == Some(-7.5))
        .count();
    assert_eq!(given, 2);

    let (line, _) = result("flat_line_first.wkt");
    let height = |x: i64, y: i64| {
        let points = line["points"].as_array().expect("points");
        let point = points.iter().find(|p| p[0] == x && p[1] == y);
        point.expect("a point").get(2).map(number)
    };
    assert_eq!([height(0, 0), height(10, 10)], [Some(5.0), Some(7.0)]);

    let (_, said) = result("conflicting_heights.wkt");
    let conflict = "vertex 1 at (10, 10) has two numbers for z, 7 and 30: 7 counts";
    assert!(said.contains(conflict), "{said}");
    let strict = run(REPORTS, "conflicting_heights.wkt --strict");
    assert_eq!(strict.status.code(), Some(1));
}

#[test]
fn files_are_refused_or_explained_by_what_they_are() {
    for (arguments, words) in [
        ("nan_point.ply", "vertex 1"),
        (
            "hole_seed_outside.poly",
            "the seed of hole 0 lies outside of the hull",
        ),
        ("curve.wkt", "is a curve"),
        ("version1.msh", "the version is 1"),
        ("y_up.obj", "perhaps y is up in this file"),
        (
            "ngon_face.obj",
            "ignored: 1 face; the hull of the vertices is triangulated (--faces takes them for polygons)",
        ),
        (
            "ngon_face.obj --inside even-odd",
            "no triangles are inside: there are no edges",
        ),
        (
            "open_box_with_hole.poly",
            "--inside hull-without-holes keeps all but the holes",
        ),
        ("libtess22.json", "edges 14 and 18 cross near (-2.3"),
        ("five.poly --inside polygons", "there are no polygons"),
    ] {
        let said = text(&run(REPORTS, arguments).stderr).to_owned();
        assert!(said.contains(words), "{arguments}: {said}");
    }
    let summary = run(REPORTS, "L_without_holes.poly");
    let summary = text(&summary.stdout);
    assert!(
        summary.contains("rule hull, as the input has no holes and no polygons; --inside holes keeps what edges enclose"),
        "{summary}"
    );
}

/// Points, edges, and points that are equal to others.
#[test]
fn files_are_read_as_they_are_meant() {
    for (arguments, counts) in [
        ("nan_height.wkt", "points 4"),
        ("nan_column.ply", "points 4"),
        ("second_order_edge.msh", "edges 2"),
        ("wrapped_line.obj", "edges 4"),
        ("empty_coordinates.geojson", "points 3"),
        ("one_feature_a_line.geojson", "points 3"),
        ("geojson_named.json", "points 11"),
        ("proteus200_no_regions.poly", "points 4"),
        ("manifold1211.json", "points 10, duplicates 5"),
        ("triangle4.json", "points 5, duplicates 1"),
        ("libtess22.json --split-crossings", "new vertices 4"),
    ] {
        let output: Output = run(REPORTS, arguments);
        let printed = text(&output.stdout);
        assert!(printed.contains(counts), "{arguments}: {printed}");
    }
}

#[test]
fn all_others_are_right() {
    for name in [
        "geogram363.json",
        "constrainautor15.json",
        "clipper1058.json",
        "gte5.json",
        "manifold1211.json",
        "qhull166.json",
        "lyon486.json",
        "lyon500.json",
        "ifc2095.json",
        "cdt176b.json",
        "cdt37.json",
        "noise416.json",
        "tinfour119.json",
        "pode15.json",
        "triangle4.json",
        "compas206.json",
        "delaunator_rs8.json",
        "qthund2.json",
        "earcut177.geojson",
        "earcut129a.wkt",
        "earcut45.wkt",
        "earcut136_shared_edges.wkt",
        "jts1001.wkt",
        "threejs11670.wkt",
        "tangle_160.json --split-crossings",
    ] {
        let output = run(REPORTS, &format!("{name} --verify"));
        assert!(output.status.success(), "{name}");
        assert!(
            text(&output.stdout).contains("correct: the result"),
            "{name}"
        );
    }
}

/// Every name and number that a file says and that is not read or written is said.
#[test]
fn what_is_ignored_or_not_written_is_said_or_refused() {
    let folder = folder(&[
        (
            "a.geojson",
            r#"{"type": "Feature", "id": 7, "properties": {"name": "x", "wind": 2}, "geometry":
                {"type": "LineString", "coordinates": [[0, 0], [4, 0], [0, 4]]}}"#,
        ),
        (
            "b.poly",
            "3 2 1 1\n1 0 0 5 2\n2 4 0 6 0\n3 0 4 7 0\n1 1\n1 1 2 9\n0\n1\n1 1 1 3 0.25\n",
        ),
        (
            "c.obj",
            "v 0 0 0\nv 4 0 0\nv 0 4 0\nvn 0 0 1\nf 1 2 3\nl 1 2\n",
        ),
        (
            "d.wkt",
            "SRID=25832;MULTIPOINT ZM (0 0 1 2, 4 0 1 2, 0 4 1 2)",
        ),
        (
            "e.json",
            r#"{"points": [[0, 0], [4, 0], [0, 4]], "author": "x"}"#,
        ),
    ]);
    for (arguments, said) in [
        (
            "a.geojson",
            "note: a.geojson: ignored: 1 member `id`, 1 property `name`, 1 property `wind`\n",
        ),
        (
            "b.poly -o b.obj",
            "note: b.poly: ignored: 1 area of a region\n\
             note: b.obj: not written: markers of 1 vertices, markers of 1 edges\n",
        ),
        (
            "b.poly -o c.vtu",
            "note: b.poly: ignored: 1 area of a region\n",
        ),
        (
            "c.obj",
            "note: c.obj: ignored: 1 line of `vn`\n\
             note: c.obj: ignored: 1 face; the hull of the vertices is triangulated (--faces takes them for polygons)\n",
        ),
        (
            "d.wkt -o d.stl",
            "note: d.wkt: ignored: 3 measures\n\
             note: d.stl: not written: the coordinate system EPSG:25832\n",
        ),
        ("d.wkt -o d.geojson", "note: d.wkt: ignored: 3 measures\n"),
        ("e.json", "note: e.json: ignored: 1 member `author`\n"),
    ] {
        let output = run(&folder, arguments);
        assert_eq!(text(&output.stderr), said, "{arguments}");
        assert!(output.status.success(), "{arguments}");
        let strict = run(&folder, &format!("{arguments} --strict"));
        let first = said.lines().next().expect("a line").strip_prefix("note: ");
        let error = format!("error: {}; --strict refuses that\n", first.expect("a note"));
        assert_eq!(text(&strict.stderr), error, "{arguments}");
        assert_eq!(strict.status.code(), Some(1), "{arguments}");
    }
    let geojson = std::fs::read_to_string(folder.path().join("d.geojson")).expect("a file");
    assert!(geojson.contains("urn:ogc:def:crs:EPSG::25832"), "{geojson}");
}

/// Where edges cross, with the features and rings that they are of.
#[test]
fn crossing_edges_name_their_place_and_their_features() {
    let ring = "[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [3, 1], [2, 3], [1, 1]]";
    let map = format!(
        r#"{{"type": "FeatureCollection", "features": [
            {{"type": "Feature", "geometry": {{"type": "Point", "coordinates": [9, 9]}}}},
            {{"type": "Feature", "geometry": {{"type": "Polygon", "coordinates": [{ring}]}}}},
            {{"type": "Feature", "geometry": {{"type": "LineString", "coordinates": [[-1, 2], [2, 2.5]]}}}}]}}"#
    );
    let folder = folder(&[("map.geojson", &map)]);
    let error = run(&folder, "map.geojson");
    assert_eq!(
        text(&error.stderr).split(" (`").next(),
        Some(
            "error: map.geojson: edges 6 and 7 cross near (1.7272727272727273, 2.4545454545454546), hole 1 of feature 2 and \
             a line of feature 3"
        )
    );
}

/// A property that is asked for is the height, whatever the third coordinates, and its name must be there.
#[test]
fn a_property_that_is_asked_for_is_the_height() {
    let line = |z: i32, elev: i32| {
        format!(
            r#"{{"type": "Feature", "properties": {{"ELEV_M": {elev}}}, "geometry": {{"type": "LineString",
                "coordinates": [[{elev}, 0, {z}], [{elev}, 9, {z}]]}}}}"#
        )
    };
    let map = format!(
        r#"{{"type": "FeatureCollection", "features": [{}, {}]}}"#,
        line(0, 10),
        line(0, 20)
    );
    let folder = folder(&[("map.geojson", &map)]);
    let said = |arguments: &str| text(&run(&folder, arguments).stderr).to_owned();
    assert_eq!(
        said("map.geojson --height-property ELEV_M -o a.obj"),
        "note: map.geojson: heights are the property `ELEV_M` of 2 features\n"
    );
    let obj = std::fs::read_to_string(folder.path().join("a.obj")).expect("a file");
    assert!(
        obj.starts_with("v 10 0 10\nv 10 9 10\nv 20 0 20\n"),
        "{obj}"
    );
    assert_eq!(
        said("map.geojson --height-property elev_m -o b.obj"),
        "note: map.geojson: no property or column with heights is called `elev_m`\n\
         note: map.geojson: ignored: 2 properties `ELEV_M`\n"
    );
}

#[test]
fn polygons_that_overlap_are_said_to() {
    let folder = folder(&[(
        "two.wkt",
        "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)) POLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))",
    )]);
    assert_eq!(
        text(&run(&folder, "two.wkt").stderr),
        "note: two.wkt: polygons overlap: 2 triangles are covered more than once, and have the first feature that does\n"
    );
}
