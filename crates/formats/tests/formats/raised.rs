//! Tables and maps that get heights and stay as they are otherwise.

use sweep_cdt_formats::{Column, Format, GraphFile, Input, Source, raised, read};

/// A file as it is read.
fn file(format: Format, source: &Source) -> GraphFile<f64> {
    match read(format, source, None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{other:?}"),
    }
}

/// The text with heights that are x and ten times y of each vertex, and none where x is 9. Read again, it has these heights
/// and all other columns as before.
fn lifted(format: Format, source: &Source) -> String {
    let mut expected = file(format, source);
    let height = |&[x, y]: &[f64; 2]| if x < 9.0 { x + 10.0 * y } else { f64::NAN };
    let heights = Column::heights(expected.graph.points.iter().map(height).collect());
    expected
        .columns
        .retain(|column| column.name != heights.name);
    expected.columns.insert(0, heights);
    let text = raised(format, source, &expected).expect("it was read");
    let text = text.expect("a format that stays");
    let again = file(format, &Source::new("again", text.clone()));
    assert_eq!(again.graph, expected.graph);
    if expected
        .heights()
        .is_some_and(|heights| heights.missing() < heights.values.len())
    {
        assert_eq!(again.columns.len(), expected.columns.len());
        for column in &expected.columns {
            assert!(
                again.columns.contains(column),
                "{column:?}: {:?}",
                again.columns
            );
        }
    }
    String::from_utf8(text).expect("text")
}

#[test]
fn rows_keep_their_fields() {
    for (before, after) in [
        // A new column is the last one.
        ("x,y\n1,2\n9,3\n", "x,y,z\n1,2,21\n9,3,\n"),
        (
            "name;x;y\r\n\"oak; old\";1;2\r\n\r\nelm;9;3",
            "name;x;y;z\r\n\"oak; old\";1;2;21\r\n\r\nelm;9;3;",
        ),
        (
            "x,y,\"kind, of\"\n1,2,\"a \"\"b\"\"\" \n9,3,\n",
            "x,y,\"kind, of\",z\n1,2,\"a \"\"b\"\"\",21 \n9,3,,\n",
        ),
        (
            "\u{feff}x\ty\tkind\n1\t2\n3\t4\tb\n",
            "\u{feff}x\ty\tkind\tz\n1\t2\t\t21\n3\t4\tb\t43\n",
        ),
        (
            "x y kind # of trees\n1 2 7 # oak\n9 3\n",
            "x y kind z # of trees\n1 2 7 21 # oak\n9 3 nan nan\n",
        ),
        // One that is there keeps its place.
        (
            "x,y,elev,id\n1,2,5,7\n9,3,6,8\n1,2,,9\n",
            "x,y,elev,id\n1,2,21,7\n9,3,,8\n1,2,21,9\n",
        ),
        (
            "x,y,\"elev (m)\"\n1,2,\"5\"\n1,3\n",
            "x,y,\"elev (m)\"\n1,2,\"21\"\n1,3,31\n",
        ),
        ("id,z,x,y\n7,5,1,2\n", "id,z,x,y\n7,21,1,2\n"),
        // Columns without names, and with names in a comment.
        ("1 2\n9 3\n", "1 2 21\n9 3 nan\n"),
        ("2\n1 2 5 7\n9 3 6 8\n", "2\n1 2 21 7\n9 3 nan 8\n"),
        (
            "# id x y\n7 1 2\n8 3 4\n",
            "# id x y z\n7 1 2 21\n8 3 4 43\n",
        ),
        (
            "sep=;\nx;y\n# a note\n1;2\n",
            "sep=;\nx;y;z\n# a note\n1;2;21\n",
        ),
    ] {
        let format = Format::Csv;
        assert_eq!(lifted(format, &Source::new("a.csv", before)), after);
    }
}

/// A column that is called z and is not that of heights is no reason for a second one of that name.
#[test]
fn columns_may_be_chosen() {
    let source = Source::new("a.csv", "x,y,z,w\n1,2,5,6\n").columns(["z", "w"]);
    let mut table = file(Format::Csv, &source);
    assert_eq!(table.graph.points, [[5.0, 6.0]]);
    table.columns = vec![Column::heights(vec![0.5])];
    let text = raised(Format::Csv, &source, &table).expect("it was read");
    assert_eq!(text.expect("a table"), b"x,y,z,w,height\n1,2,5,6,0.5\n");
}

#[test]
fn features_keep_their_properties() {
    let point = |place: &str| {
        format!(
            r#"{{"type": "Feature", "id": 7, "properties": {{"name": "[1,2]", "z": 3}}, "geometry": {{"type": "Point", "coordinates": {place}}}}}"#
        )
    };
    let line = |places: &str| {
        format!(r#"{{"type":"LineString","bbox":[0,0,1,1],"coordinates":[{places}]}}"#)
    };
    for (before, after) in [
        (point("[1, 2]"), point("[1, 2,21]")),
        (point("[ 1.0 ,2e0, 99 ]"), point("[ 1.0 ,2e0,21]")),
        (point("[9, 2, 99]"), point("[9, 2]")),
        // Equal positions, one of which has no height before.
        (
            line("[1,2],[3,4,5],[1,2]"),
            line("[1,2,21],[3,4,43],[1,2,21]"),
        ),
        (
            format!("\u{1e}{}\n\u{1e}{}\n", point("[1,2]"), line("[3,4]")),
            format!("\u{1e}{}\n\u{1e}{}\n", point("[1,2,21]"), line("[3,4,43]")),
        ),
    ] {
        assert_eq!(
            lifted(Format::Geojson, &Source::new("a.geojson", before)),
            after
        );
    }
}

#[test]
fn others_do_not_stay() {
    let source = Source::new("a.node", "1 2 0 0\n0 1 2\n");
    let table = file(Format::Node, &source);
    assert_eq!(raised(Format::Node, &source, &table), Ok(None));
    assert!(!Format::RAISED.contains(&Format::Node));
}
