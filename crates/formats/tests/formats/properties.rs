//! Properties of features: triangles have those of the first feature that covers them.

use sweep_cdt_formats::{
    Format, GraphFile, Input, Remark, Source, not_written, read, write_interior,
};

/// Two polygons that overlap, a line and a point.
const MAP: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"road": "A1"}, "geometry": {"type": "LineString", "coordinates": [[0, 0], [9, 0]]}},
{"type": "Feature", "properties": {"name": "a \"lake\"", "feature": [1, 2]}, "geometry":
    {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}},
{"type": "Feature", "properties": {}, "geometry":
    {"type": "MultiPolygon", "coordinates": [[[[4, 0], [8, 0], [8, 4], [4, 4], [4, 0]]]]}},
{"type": "Feature", "properties": {"name": null, "height": 12}, "geometry":
    {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}},
{"type": "Feature", "properties": {"depth": 3}, "geometry": {"type": "Polygon", "coordinates": [[[0, 4], [4, 4], [2, 6], [0, 4]]]}}
]}"#;

fn map(text: &str) -> GraphFile<f64> {
    match read(Format::Geojson, &Source::new("a.geojson", text), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{other:?}"),
    }
}

/// The properties of each triangle, as text.
fn written(file: &GraphFile<f64>) -> Vec<String> {
    let result =
        sweep_cdt::triangulate(&file.graph.points, &file.graph.edges).expect("no crossing");
    let interior = file.polygons.interior(&result).expect("polygons");
    let mut text = Vec::new();
    write_interior(Format::Geojson, file, &interior, &mut text).expect("memory takes it");
    let value: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    let features = value["features"].as_array().expect("features");
    features
        .iter()
        .map(|feature| feature["properties"].to_string())
        .collect()
}

#[test]
fn triangles_have_the_properties_of_the_first_feature() {
    let mut found = written(&map(MAP));
    found.sort();
    found.dedup();
    assert_eq!(
        found,
        [
            r#"{"depth":3,"feature":5}"#,
            r#"{"feature":2,"feature_2":[1,2],"name":"a \"lake\""}"#,
            r#"{"feature":3}"#,
        ]
    );
}

#[test]
fn layers_keep_the_properties_of_their_features() {
    let layers = vec![("a".to_owned(), map(MAP)), ("b".to_owned(), map(MAP))];
    let whole = GraphFile::of_layers(layers).expect("no systems");
    let of = |feature: usize| whole.properties.of(feature);
    assert_eq!((of(0), of(1), of(3), of(11)), ("", "", "", ""));
    assert_eq!((of(5), of(10)), (r#""depth":3"#, r#""depth":3"#));
    assert_eq!(of(9), r#""name":null,"height":12"#);
}

/// Other outputs have no room for them, and without an interior of polygons no triangle has any.
#[test]
fn properties_that_are_not_written_are_said() {
    let file = map(MAP);
    let result =
        sweep_cdt::triangulate(&file.graph.points, &file.graph.edges).expect("no crossing");
    let interior = file.polygons.interior(&result).expect("polygons");
    let names =
        "the property `name`, the property `feature`, the property `height`, the property `depth`";
    for (format, domain, expected) in [
        (Format::Geojson, Some(&interior), None),
        (Format::Geojson, None, Some(format!("not written: {names}"))),
        (
            Format::Ply,
            Some(&interior),
            Some(format!("not written: {names}")),
        ),
    ] {
        let lost = not_written(format, &file, domain);
        assert_eq!(lost.map(|lost| lost.to_string()), expected);
    }
    let ignored = |file: &GraphFile<f64>| -> Vec<String> {
        file.remarks.iter().map(Remark::to_string).collect()
    };
    assert_eq!(ignored(&file), ["ignored: 1 property `road`"]);
    let file = file.without_properties();
    assert_eq!(
        ignored(&file),
        [
            "ignored: 1 property `road`",
            "ignored: 2 properties `name`",
            "ignored: 1 property `feature`",
            "ignored: 1 property `height`",
            "ignored: 1 property `depth`",
        ]
    );
}

/// A property that was asked for as the height is one, and is no loss.
#[test]
fn a_property_that_is_a_height_is_no_loss() {
    let source = Source::new("a.geojson", MAP).height_property("height");
    let Ok(Input::Doubles(file)) = read(Format::Geojson, &source, None) else {
        panic!("the file is right");
    };
    assert_eq!(file.heights().expect("heights").values[..1], [12.0]);
    let lost = not_written(Format::Ply, &file, None)
        .expect("names")
        .to_string();
    assert!(!lost.contains("height"), "{lost}");
    assert_eq!(file.properties.of(4), r#""name":null,"height":12"#);
}
