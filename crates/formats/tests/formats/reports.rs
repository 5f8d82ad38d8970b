//! Files that people reported to other projects, or that habit makes: each is read as it is meant, or refused by what it
//! is. Beside each stands where it was asked for.

use sweep_cdt_formats::{Format, GraphFile, Input, Matched, Remark, Source, read, read_result};

#[track_caller]
fn file(format: Format, text: &str) -> GraphFile<f64> {
    match read(format, &Source::new("file", text), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{text}: {other:?}"),
    }
}

/// How many points and edges there are.
#[track_caller]
fn size(format: Format, text: &str) -> [usize; 2] {
    let graph = file(format, text).graph;
    [graph.points.len(), graph.edges.len()]
}

#[track_caller]
fn refusal(format: Format, text: &str) -> String {
    let error = read(format, &Source::new("file", text), None).expect_err("it is refused");
    error.to_string()
}

/// cinder/Cinder#1121, assimp/assimp#1200: Rhino wraps long lines.
#[test]
fn lines_of_obj_go_on_after_a_backslash() {
    let corners = "v 0 0 0\nv 4 0 0\nv 4 4 \\\n0\nv 0 4 0\n";
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0]];
    for line in [
        "l 1 2 3 \\\n4 1\n",
        "l 1 2\\\r\n3\\\r\n 4 1",
        "l \\\n\\\n1 2 3 4 1\n",
    ] {
        let graph = file(Format::Obj, &format!("{corners}{line}")).graph;
        assert_eq!(
            (graph.points.len(), &graph.edges[..]),
            (4, &edges[..]),
            "{line}"
        );
    }
    let many = format!("{corners}l 1 {}2", "\\\n".repeat(100_000));
    assert_eq!(size(Format::Obj, &many), [4, 1]);
    let error = refusal(Format::Obj, "v 1 \\\n");
    assert_eq!(
        error,
        "file:1: the line ends where a y coordinate should follow"
    );
}

/// firedrakeproject/firedrake#982, inducer/meshpy#15.
#[test]
fn lines_of_second_order_go_through_the_node_between() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 2 0 0\n3 1 0 0\n$EndNodes\n\
                $Elements\n2\n1 8 2 1 1 1 2 3\n2 15 2 1 1 1\n$EndElements\n";
    let graph = file(Format::Msh, text).graph;
    assert_eq!(graph.edges, [[0, 2], [2, 1]]);
}

/// mapbox/geojson.io#643; RFC 7946, 3.1: a geometry without coordinates is as one that is `null`.
#[test]
fn empty_coordinates_are_no_geometry() {
    for kind in [
        "Point",
        "MultiPoint",
        "LineString",
        "MultiLineString",
        "Polygon",
        "MultiPolygon",
    ] {
        let empty = format!("{{\"type\": \"{kind}\", \"coordinates\": [ ]}}");
        let corner = "{\"type\": \"Point\", \"coordinates\": [1, 2]}";
        let text =
            format!("{{\"type\": \"GeometryCollection\", \"geometries\": [{empty}, {corner}]}}");
        assert_eq!(size(Format::Geojson, &text), [1, 0], "{kind}");
    }
}

/// systemed/tilemaker#651; RFC 8142.
#[test]
fn sequences_of_features_are_read() {
    let feature = |x: u32| {
        let geometry = format!("{{\"type\": \"Point\", \"coordinates\": [{x}, 0]}}");
        format!("{{\"type\": \"Feature\",\n\"properties\": {{}}, \"geometry\": {geometry}}}")
    };
    let features = [0, 1, 2].map(feature);
    let separated: String = features
        .iter()
        .map(|text| format!("\u{1e}{text}\n"))
        .collect();
    for text in [features.join("\n"), features.join(""), separated] {
        let points = file(Format::Geojson, &text).graph.points;
        assert_eq!(points, [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    }
    let error = refusal(Format::Geojson, &format!("{}\nfour", features.join("\n")));
    assert_eq!(error, "file:7:1: `four` is no JSON here: expected ident");
    assert_eq!(
        refusal(Format::Geojson, " \u{1e}\n"),
        "file:1: the file is empty"
    );
}

/// By habit: a name that ends in `.json`.
#[test]
fn geojson_is_known_by_its_type() {
    let ring = "[[0, 0], [3, 0], [0, 3], [0, 0]]";
    let polygon = format!("{{\"type\": \"Polygon\", \"coordinates\": [{ring}]}}");
    assert_eq!(size(Format::Json, &polygon), [3, 3]);
    let input = file(Format::Geojson, &polygon);
    let source = Source::new("file", polygon);
    let result = read_result(Format::Json, &source, None, &input).expect("a triangle");
    assert_eq!(
        (result.list, result.matched),
        (vec![[0, 1, 2]], Matched::Equal)
    );
    // With a list of points it is our own.
    let own = "{\"type\": \"Point\", \"points\": [[1, 2]]}";
    assert_eq!(size(Format::Json, own), [1, 0]);
    let other = refusal(Format::Json, "{\"type\": \"Topologies\"}");
    assert_eq!(other, "file:1:1: the object has no `points`");
    let forms = [
        ("{\"type\": \"Topology\"}", "TopoJSON"),
        (
            "{\"geometryType\": \"esriGeometryPoint\", \"features\": []}",
            "Esri's JSON",
        ),
    ];
    for (text, form) in forms {
        for format in [Format::Json, Format::Geojson] {
            let words = format!("file: this is {form}, which is not read: ");
            assert!(refusal(format, text).starts_with(&words), "{text}");
        }
    }
}

/// `PostGIS` writes curves; Gmsh wrote version 1.
#[test]
fn what_is_not_read_is_named() {
    let curve = "CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))";
    assert_eq!(
        refusal(Format::Wkt, curve),
        "file:1: `CURVEPOLYGON` is a curve, and only straight lines are read: ST_CurveToLine of PostGIS makes these"
    );
    let first = "$NOD\n1\n1 0 0 0\n$ENDNOD\n";
    assert_eq!(
        refusal(Format::Msh, first),
        "file:1: the version is 1, and only 2 and 4.1 are read: save it again with Gmsh"
    );
}

/// Found by the comparison with Python: a collection was counted once for each of its geometries.
#[test]
fn a_feature_of_several_geometries_is_raised_once() {
    let parts =
        r#"[{"type": "Point", "coordinates": [0, 0]}, {"type": "Point", "coordinates": [4, 0]}]"#;
    let text = format!(
        r#"{{"type": "Feature", "properties": {{"z": 7}},
            "geometry": {{"type": "GeometryCollection", "geometries": {parts}}}}}"#
    );
    let file = file(Format::Geojson, &text);
    assert_eq!(file.heights().expect("heights").values, [7.0, 7.0]);
    let (name, count) = ("z".to_owned(), 1);
    assert_eq!(file.remarks, [Remark::HeightProperty { name, count }]);
}
