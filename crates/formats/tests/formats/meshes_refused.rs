//! Formats of other programs: what is refused, and why; and what is ignored.

use sweep_cdt::Pslg;
use sweep_cdt_formats::{Format, GraphFile, Input, Matched, Matching, Source, read, read_result};

fn source(text: &str) -> Source {
    Source::new("file", text.replace('|', "\n").into_bytes())
}

fn square() -> GraphFile<f64> {
    let graph = Pslg {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        ..Pslg::default()
    };
    graph.into()
}

#[track_caller]
fn file(format: &str, text: &str) -> GraphFile<f64> {
    let format = Format::named(format, Format::INPUTS).expect("a format of inputs");
    match read(format, &source(text), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{format:?}: {other:?}"),
    }
}

fn triangles(format: &str, text: &str) -> Result<Vec<[usize; 3]>, String> {
    let format = Format::named(format, Format::RESULTS).expect("a format of results");
    let result = read_result(format, &source(text), None, &square());
    result
        .map(|result| result.list)
        .map_err(|error| error.to_string())
}

/// Inputs that are wrong, and what is said of them.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "off",
        "OFF|2 0 0|0 0 0|1 0",
        "file:4: the line ends where a z coordinate should follow",
    ),
    (
        "off",
        "OFF|2 0|0 0 0|",
        "file:3: the file ends where vertex 2 of 2 should follow",
    ),
    (
        "off",
        "OFF|1 0|0 0 0|1 1 1|",
        "file:4: only 1 vertices and 0 faces are announced",
    ),
    (
        "off",
        "OFF|1 0|0 zero 0",
        "file:3: `zero` is not a coordinate",
    ),
    (
        "off",
        "OFF|1 0|0 0 high",
        "file:3: `high` is not an attribute, a number",
    ),
    (
        "off",
        "2 1|0 0 0|1 1 0|2 0 2",
        "file: line 0 of the mesh: vertex 2 does not exist: the vertices are numbered from 0 to 1",
    ),
    ("obj", "v 0 0|l 1 x", "file:2: `x` is not a vertex's number"),
    ("ply", "plyt", "file:1: the file does not begin with `ply`"),
    ("ply", "ply|end_header", "file: the header has no `format`"),
    (
        "ply",
        "ply|format ascii 1.0|end_header",
        "file: there is no element `vertex`",
    ),
    (
        "ply",
        "ply|property int x",
        "file:2: the property stands before all elements",
    ),
    (
        "ply",
        "ply|format text 1.0",
        "file:2: `text` is not ascii, binary_little_endian or binary_big_endian",
    ),
    (
        "ply",
        "ply|format ascii 1.0|element vertex 1|property int x|end_header|1",
        "file: the element `vertex` has no property `y`",
    ),
    (
        "ply",
        "ply|format binary_little_endian 1.0|element vertex 1000000000000|property double x|property double y|\
         end_header|0123456701234567",
        "file: vertex 1: the file ends, and 1000000000000 are announced",
    ),
    (
        "vtk",
        "vtk",
        "file:1: the file does not begin with `# vtk DataFile Version`",
    ),
    (
        "vtk",
        "# vtk DataFile Version 3.0|t|ASCII|DATASET STRUCTURED_POINTS",
        "file:4: `STRUCTURED_POINTS` is not `POLYDATA` or `UNSTRUCTURED_GRID`",
    ),
    (
        "vtk",
        "# vtk DataFile Version 3.0|t|ASCII|DATASET POLYDATA|POINTS 900 float|0 0 0",
        "file: the file ends where a coordinate should follow",
    ),
    (
        "vtk",
        "# vtk DataFile Version 3.0|t|ASCII|POINTS 1 float|0 0 0|LINES 1 3|5 0 0",
        "file: the file ends where corners of all cells should follow",
    ),
    (
        "msh",
        "$MeshFormat|4.0 0 8",
        "file:2: the version is `4.0`, and only 2 and 4.1 are read",
    ),
    (
        "msh",
        "$MeshFormat|2.2 1 8",
        "file:2: no int of 1 follows, which tells the order of bytes",
    ),
    (
        "msh",
        "$MeshFormat|2.2 2 8",
        "file:2: the type of the file is `2`, not 0 or 1",
    ),
    (
        "msh",
        "$MeshFormat|2.2 0 8|$EndMeshFormat|$Elements|0|$EndElements",
        "file:4: `$MeshFormat`, `$Nodes` and `$Elements` come once, in this order",
    ),
    (
        "msh",
        "$MeshFormat|2.2 0 8|$EndMeshFormat|$Nodes|2|7 0 0 0|7 1 0 0|$EndNodes",
        "file:5: two nodes have the same number",
    ),
    (
        "msh",
        "$MeshFormat|2.2 0 8|$EndMeshFormat|$Nodes|1|7 0 0 0|$EndNodes|$Elements|1|1 1 0 7 8",
        "file:10: there is no node 8",
    ),
    (
        "geojson",
        "{\"type\": \"Circle\"}",
        "file:1:10: `\\\"Circle\\\"` is not a type of GeoJSON",
    ),
    (
        "geojson",
        "{\"features\": []}",
        "file:1:1: `{\\\"features\\\": []}` is not a geometry, a feature or a collection of them",
    ),
    (
        "geojson",
        "{\"type\": \"LineString\",|\"coordinates\": [[1, 2], [3]]}",
        "file:2:16: `[[1, 2], [3]]` is not a list of positions",
    ),
    (
        "geojson",
        "{\"type\": \"Point\", \"coordinates\": [1, true]}",
        "file:1:38: `true` is not a coordinate",
    ),
    (
        "wkt",
        "CIRCLE (1 2)",
        "file:1: `CIRCLE` stands where a geometry should",
    ),
    (
        "wkt",
        "POINT (1|)",
        "file:2: `)` stands where a number should",
    ),
    (
        "wkt",
        "POINT (1 2 3 4 5)",
        "file:1: `5` stands where `,` or `)` should",
    ),
    (
        "wkt",
        "LINESTRING (1 2,, 3 4)",
        "file:1: `,` stands where a position should",
    ),
    (
        "wkt",
        "POLYGON (1 2, 3 4)",
        "file:1: `1` stands where `(` should",
    ),
    (
        "wkt",
        "LINESTRING (1 2, 3 4",
        "file: the file ends where `)` should follow",
    ),
    (
        "wkt",
        "GEOMETRYCOLLECTION (POINT (1 2)",
        "file: the file ends where `)` should follow",
    ),
];

#[test]
fn what_is_wrong_is_said() {
    for &(format, text, expected) in WRONG {
        let format = Format::named(format, Format::INPUTS).expect("a format of inputs");
        let error = read(format, &source(text), None).expect_err(text);
        assert_eq!(error.to_string(), expected, "{text}");
    }
}

#[test]
fn faces_of_a_result_are_triangles() {
    let quad = "the face has 4 corners, and only triangles are read: split it, for example by the option \
         `triangulate` of the program that wrote it";
    let vertices = "0 0 0|1 0 0|1 1 0|0 1 0|";
    let off = format!("OFF|4 2 0|{vertices}4 0 1 2 3|3 0 1 2");
    assert_eq!(triangles("off", &off), Err(format!("file:7: {quad}")));
    assert_eq!(
        file("off", &off).graph.points,
        square().graph.points,
        "an input has no faces"
    );
    let vtk =
        format!("# vtk DataFile Version 2.0|t|ASCII|POINTS 4 int {vertices}POLYGONS 1 5 4 0 1 2 3");
    assert_eq!(triangles("vtk", &vtk), Err(format!("file: cell 0: {quad}")));
    let ring = "POLYGON ((0 0, 1 0,|1 1, 0 1, 0 0))";
    assert_eq!(triangles("wkt", ring), Err(format!("file:1: {quad}")));
    let hole = "POLYGON ((0 0, 1 0, 1 1), (0 0, 1 0, 1 1))";
    let error = "file:1: the polygon has a hole, and only triangles are read";
    assert_eq!(triangles("wkt", hole), Err(error.to_owned()));
    // A triangle of six nodes is none, nor is a line of three.
    let msh = "$MeshFormat|2.2 0 8|$EndMeshFormat|$Nodes|1|1 0 0 0|$EndNodes|$Elements|1|1 9 0 1 1 1 1 1 1|$EndElements";
    let error = "file:10: elements of type 9 are not read, only triangles (2)";
    assert_eq!(triangles("msh", msh), Err(error.to_owned()));
}

#[test]
fn strips_turn_every_other_triangle() {
    let vtk = "# vtk DataFile Version 2.0|t|ASCII|POINTS 4 int 0 0 0 1 0 0 0 1 0 1 1 0|TRIANGLE_STRIPS 1 5 4 0 1 2 3";
    assert_eq!(triangles("vtk", vtk), Ok(vec![[0, 1, 3], [3, 1, 2]]));
}

#[test]
fn rings_are_closed_and_equal_points_are_one_vertex() {
    let open = "POLYGON ((0 0, 1 0, 1 1))";
    let closed =
        "SRID=4326;Polygon((0 0, 1 0, 1 1, 0.0 0));LINESTRING M (1.0 0 7, 2 2 7) POINT EMPTY";
    assert_eq!(file("wkt", open).graph.edges, [[0, 1], [1, 2], [2, 0]]);
    let file = file("wkt", closed);
    assert_eq!(
        file.graph.points,
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 2.0]]
    );
    assert_eq!(file.graph.edges, [[0, 1], [1, 2], [2, 0], [1, 3]]);
    assert!(file.columns.is_empty(), "a measure is no height");
}

#[test]
fn collections_in_collections_do_not_recurse() {
    let depth = 100_000;
    let deep = format!(
        "{}POINT (1 2){}",
        "GEOMETRYCOLLECTION (".repeat(depth),
        ")".repeat(depth)
    );
    assert_eq!(file("wkt", &deep).graph.points, [[1.0, 2.0]]);
    let geojson = |depth| {
        let begin = "{\"type\": \"GeometryCollection\", \"geometries\": [".repeat(depth);
        format!("{begin}{}", "]}".repeat(depth))
    };
    assert!(file("geojson", &geojson(101)).graph.points.is_empty());
    for depth in [102, depth] {
        let error = read(Format::Geojson, &source(&geojson(depth)), None).expect_err("deep");
        let error = error.to_string();
        assert!(error.ends_with(": more than 100 objects are in each other"));
    }
}

#[test]
fn fractions_are_read_in_texts() {
    let graph = |format, text: &str| match read(format, &source(text), None) {
        Ok(Input::Rationals(file)) => file.graph,
        other => panic!("{text}: {other:?}"),
    };
    let wkt = graph(Format::Wkt, "MULTIPOINT (1/3 0.1, (0.5 2))");
    let json = r#"{"vertices": [["1/3", 0.1], [0.5, 2]], "segments": []}"#;
    assert_eq!(wkt, graph(Format::Json, json));
}

#[test]
fn json_has_the_names_of_other_programs() {
    let text =
        |name: &str| format!(r#"{{"vertices": [[0, 0], [1, 0], [1, 1]], "{name}": [[0, 1, 2]]}}"#);
    for name in ["triangles", "simplices", "faces"] {
        assert_eq!(
            triangles("json", &text(name)),
            Ok(vec![[0, 1, 2]]),
            "{name}"
        );
    }
    let both = r#"{"points": [[0, 0]], "vertices": [[0, 0]]}"#;
    let error = read(Format::Json, &source(both), None).expect_err("two lists of points");
    let expected = "file:1:34: `vertices` means the same as `points`, which is there, too";
    assert_eq!(error.to_string(), expected);
}

/// A binary STL of one triangle.
fn single(corners: [[f32; 2]; 3]) -> Source {
    let mut bytes = [&[b's'; 80][..], &1_u32.to_le_bytes(), &[0; 12]].concat();
    for [x, y] in corners {
        bytes.extend([x, y, 0.0].map(f32::to_le_bytes).concat());
    }
    bytes.extend([0; 2]);
    Source::new("file", bytes)
}

#[test]
fn coordinates_alone_decide_where_there_are_no_numbers() {
    let points = vec![[0.1, 0.0], [1.0, 0.3], [1.0, 1.0]];
    let mut input = GraphFile::from(Pslg {
        points,
        ..Pslg::default()
    });
    let stl = single([[1.0, 1.0], [0.1, 0.0], [1.0, 0.3]]);
    let result = read_result(Format::Stl, &stl, None, &input).expect("one vertex each");
    assert_eq!(result.list, [[2, 0, 1]]);
    assert!(matches!(result.matched, Matched::Single { difference } if difference < 2e-8));

    let by_number = Matching::new().by_number(true);
    let error = by_number
        .read(Format::Stl, &stl, None, &input)
        .expect_err("no numbers");
    let expected = "file: the triangles are coordinates, and their vertices have no numbers";
    assert_eq!(error.to_string(), expected);

    // Another vertex that is rounded to the same numbers.
    input.graph.points.push([0.1 + 1e-12, 0.0]);
    assert!(read_result(Format::Stl, &stl, None, &input).is_err());
    // As many vertices, none of them the input's: rounding does not help.
    let text = "POLYGON ((0.100001 0, 1 0.3, 1 1))";
    input.graph.points.pop();
    let error = read_result(Format::Wkt, &source(text), None, &input).expect_err("a stranger");
    let expected = "file:1: vertex 0 is at (0.100001, 0), where the input has none: the nearest is vertex 0 at \
         (0.1, 0), by 1.000000000001e-6";
    assert_eq!(error.to_string(), expected);
}
