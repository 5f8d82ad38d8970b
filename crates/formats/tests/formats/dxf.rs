//! CAD's `.dxf`: entities as drawings have them, what is refused and where, random drawings, and damaged ones.

use sweep_cdt::Pslg;
use sweep_cdt_formats::{
    Column, GraphFile, Input, InputFormat, OutputFormat, ResultFormat, Source, read, read_result,
    write, write_graph,
};
use sweep_cdt_testing::Random;

/// A drawing: entities with a line for each code and value, from words with `|` between them.
fn drawing(entities: &str) -> String {
    let before = "  0|SECTION|  2|HEADER|  9|$ACADVER|  1|AC1015|  0|ENDSEC|  0|SECTION|  2|BLOCKS|0|CIRCLE|10|5|0|ENDSEC|\
                  999|a comment|0|SECTION|2|ENTITIES";
    let after = "0|ENDSEC|0|SECTION|2|OBJECTS|0|ARC|0|ENDSEC|0|EOF";
    let words = [before, entities, after]
        .into_iter()
        .filter(|text| !text.is_empty());
    let text: Vec<String> = words.map(|text| text.replace('|', "\n")).collect();
    text.join("\n") + "\n"
}

fn input(text: &str) -> Result<GraphFile<f64>, String> {
    match read(InputFormat::Dxf, &Source::new("file", text), None) {
        Ok(Input::Doubles(file)) => Ok(file),
        Ok(other) => panic!("{other:?}"),
        Err(error) => Err(error.to_string()),
    }
}

fn triangles(text: &str, points: &[[f64; 2]]) -> Result<Vec<[usize; 3]>, String> {
    let graph = Pslg {
        points: points.to_vec(),
        ..Pslg::default()
    };
    let result = read_result(
        ResultFormat::Dxf,
        &Source::new("file", text),
        None,
        &graph.into(),
    );
    result
        .map(|result| result.list)
        .map_err(|error| error.to_string())
}

/// The points, the edges and the heights as text, in which NaN equals itself.
#[track_caller]
fn read_drawing(entities: &str) -> (Vec<[f64; 2]>, Vec<[usize; 2]>, String) {
    let file = input(&drawing(entities)).expect("a drawing");
    let heights = file
        .heights()
        .map_or(String::new(), |column| format!("{:?}", column.values));
    (file.graph.points, file.graph.edges, heights)
}

#[test]
fn points_and_lines_of_all_kinds_are_read() {
    let corners = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.5]];
    let line = "0|LINE|5|2F|8|walls|10|0.0|20|0.0|30|7|11|4|21|0|31|8";
    let point = "0|POINT|8|0|10|4|20|3.5|30|-1.0";
    let found = read_drawing(&format!("{line}|{point}"));
    assert_eq!(
        found,
        (corners.clone(), vec![[0, 1]], "[7.0, 8.0, -1.0]".to_owned())
    );

    let open = "0|LWPOLYLINE|90|3|70|0|38|5|10|0|20|0|40|1|10|4|20|0|42|0.0|10|4|20|3.5";
    let edges = vec![[0, 1], [1, 2]];
    let found = read_drawing(open);
    assert_eq!(
        found,
        (corners.clone(), edges.clone(), "[5.0, 5.0, 5.0]".to_owned())
    );
    let closed = open.replace("70|0|38|5", "70|129");
    let around = [edges.clone(), vec![[2, 0]]].concat();
    assert_eq!(
        read_drawing(&closed),
        (corners.clone(), around.clone(), String::new())
    );
    let twice = format!("{closed}|10|0|20|0.0");
    assert_eq!(read_drawing(&twice).1, around);

    let heavy = |flags: &str, height: &str| {
        format!(
            "0|POLYLINE|66|1|10|0|20|0|30|{height}|70|{flags}|0|VERTEX|10|0|20|0|30|1|0|VERTEX|70|16|10|9|20|9|\
             0|VERTEX|10|4|20|0|30|2|0|VERTEX|10|4|20|3.5|30|3|0|SEQEND"
        )
    };
    let found = read_drawing(&heavy("0", "6"));
    assert_eq!(
        found,
        (corners.clone(), edges.clone(), "[6.0, 6.0, 6.0]".to_owned())
    );
    let found = read_drawing(&heavy("8", "0"));
    assert_eq!(
        found,
        (corners.clone(), edges, "[1.0, 2.0, 3.0]".to_owned())
    );
    assert_eq!(read_drawing(&heavy("9", "0")).1, around);

    // Faces are points of an input, and texts and what lies on the paper nothing.
    let face = "0|3DFACE|10|0|20|0|30|1|11|4|21|0|31|1|12|4|22|3.5|32|1|13|4|23|3.5|33|1";
    let paper = "0|CIRCLE|67|1|10|0|20|0|40|1|0|LINE|67|1|10|9|20|9|11|8|21|8";
    let text = "0|TEXT|10|1|20|1|1|0|0|MTEXT|10|2|20|2|0|DIMENSION|0|HATCH|10|3";
    let found = read_drawing(&format!("{text}|{face}|{paper}"));
    assert_eq!(found, (corners, vec![], "[1.0, 1.0, 1.0]".to_owned()));
    assert_eq!(read_drawing("").0, [[0.0; 2]; 0]);
    // A line without a height beside one that has one.
    let found = read_drawing("0|LINE|10|0|20|0|11|4|21|0|0|POINT|10|1|20|1|30|2");
    assert_eq!(found.2, "[NaN, NaN, 2.0]");
    let windows = drawing(line).replace('\n', "\r\n");
    assert_eq!(input(&windows).expect("a drawing").graph.edges, [[0, 1]]);
}

#[test]
fn faces_are_triangles() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.5], [0.0, 3.5]];
    let face =
        |last: &str| format!("0|3DFACE|10|0|20|0|30|1|11|4|21|0|31|1|12|4|22|3.5|32|1{last}");
    let other =
        "0|3DFACE|10|0|20|0|11|4|21|3.5|12|0.0|22|3.5|13|0|23|3.50|0|LINE|10|9|20|9|11|8|21|8";
    for last in ["", "|13|4.0|23|3.5|33|1"] {
        let text = drawing(&format!("{}|{other}", face(last)));
        assert_eq!(triangles(&text, &points), Ok(vec![[0, 1, 2], [0, 2, 3]]));
    }
    let quad = triangles(&drawing(&face("|13|0|23|3.5|33|1")), &points).expect_err("four corners");
    assert!(
        quad.starts_with("file:30: the face has 4 corners, and only triangles are read"),
        "{quad}"
    );
}

#[test]
fn what_is_no_straight_line_is_refused() {
    let refused = |entities: &str, why: &str| {
        let advice = "`ogr2ogr -f GeoJSON out.geojson in.dxf` makes straight lines of it";
        let why = format!("file:28: {why}: {advice}");
        assert_eq!(input(&drawing(entities)), Err(why));
    };
    for kind in [
        "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "INSERT", "3DSOLID", "MESH", "SOLID",
    ] {
        let why = format!("`{kind}` is not read, only points and straight lines");
        refused(&format!("0|{kind}|10|0|20|0|40|1"), &why);
    }
    let bulge = "a side with a bulge (42) is an arc, which is not read";
    refused("0|LWPOLYLINE|10|0|20|0|42|0.5|10|1|20|0", bulge);
    refused("0|VERTEX|10|0|20|0|42|-1", bulge);
    refused("0|POLYLINE|70|64", "a mesh as `POLYLINE` is not read");
    refused("0|POLYLINE|70|16", "a mesh as `POLYLINE` is not read");
    let plane = "lies in a plane of its own (210 to 230)";
    let light = "0|LWPOLYLINE|210|0|220|0|230|-1|10|0|20|0";
    refused(light, &format!("the `LWPOLYLINE` {plane}"));
    refused(
        "0|POLYLINE|210|1|220|0|230|0",
        &format!("the `POLYLINE` {plane}"),
    );
}

#[test]
fn wrong_drawings_are_named() {
    let refused = |entities: &str, why: &str| {
        assert_eq!(input(&drawing(entities)), Err(format!("file:{why}")));
    };
    refused(
        "0|LINE|10|0|20|0|11|1",
        "28: the `LINE` has no value of the code 21",
    );
    refused(
        "0|POINT|20|0",
        "28: the `POINT` has no value of the code 10",
    );
    refused("0|POINT|10|0|20|zero", "32: `zero` is not a coordinate");
    refused(
        "0|POINT|10|0|20|0|30|high",
        "34: `high` is not an attribute, a number",
    );
    refused("0|POINT|ten|0", "29: `ten` is not the code of a value");
    let light = "28: a place of the `LWPOLYLINE` is not one x (10) and one y (20)";
    refused("0|LWPOLYLINE|10|0|10|0", light);
    refused("0|LWPOLYLINE|20|0", light);
    refused(
        "0|LWPOLYLINE|10|0|20|1|10|2",
        "28: the last place of the `LWPOLYLINE` has no y (20)",
    );
    let whole = drawing("0|POINT|10|0|20|0");
    let end = whole.find("0\nEOF").expect("an end");
    let why = "file: the file ends where `EOF` should follow";
    assert_eq!(input(&whole[..end]), Err(why.to_owned()));
    let why = "file: the file ends where the section `ENTITIES` should follow";
    assert_eq!(input(""), Err(why.to_owned()));
    assert_eq!(input("0\nEOF\n"), Err(why.to_owned()));
    let why = "file:2: the file does not begin with the code 0 and `SECTION`";
    assert_eq!(input("2\nENTITIES\n"), Err(why.to_owned()));
    let binary = input("AutoCAD Binary DXF\r\n\u{1a}\0").expect_err("binary");
    assert!(binary.starts_with("file: only files of text are read, and no binary ones: `ogr2ogr"));
}

/// What is written is what the manual of DXF says.
#[test]
fn drawings_are_written_by_the_book() {
    let graph = Pslg {
        points: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.5]],
        edges: vec![[2, 0]],
        ..Pslg::default()
    };
    let heights = Column {
        name: Column::HEIGHT.to_owned(),
        values: vec![7.0, f64::NAN, -1.5],
    };
    let file = GraphFile {
        columns: vec![heights],
        ..graph.into()
    };
    let mut written = Vec::new();
    write_graph(InputFormat::Dxf, &file, &mut written).expect("memory takes it");
    let expected = "0|SECTION|2|ENTITIES|0|POINT|8|0|10|0|20|0|30|7|0|POINT|8|0|10|4|20|0|0|POINT|8|0|10|4|20|3.5|30|-1.5|\
                    0|LINE|8|0|10|4|20|3.5|30|-1.5|11|0|21|0|31|7|0|ENDSEC|0|EOF|";
    let written = String::from_utf8(written).expect("a text");
    assert_eq!(written, expected.replace('|', "\n"));
    assert_eq!(input(&written), Ok(file.clone()));
    let graph = &file.graph;
    let result = sweep_cdt::triangulate(&graph.points, &graph.edges).expect("a triangle");
    let mut written = Vec::new();
    write(OutputFormat::Dxf, &file, &result, &mut written).expect("memory takes it");
    let expected = "0|SECTION|2|ENTITIES|0|3DFACE|8|0|10|0|20|0|30|7|11|4|21|0|12|4|22|3.5|32|-1.5|13|4|23|3.5|33|-1.5|0|\
                    ENDSEC|0|EOF|";
    let written = String::from_utf8(written).expect("a text");
    assert_eq!(written, expected.replace('|', "\n"));
    assert_eq!(triangles(&written, &graph.points), Ok(vec![[0, 1, 2]]));
}

/// Lines of random drawings, in every entity that can hold them, are the edges that they mean.
#[test]
fn random_drawings_are_read_as_they_are_meant() {
    let mut dice = Random::new(11);
    for _ in 0..500 {
        let mut entities = Vec::new();
        let mut meant: Vec<[[f64; 2]; 2]> = Vec::new();
        for _ in 0..dice.below(6) {
            let places: Vec<[f64; 2]> = (0..2 + dice.below(4))
                .map(|_| [dice.unit() * 9.0, (dice.unit() - 0.5) / 64.0])
                .collect();
            let is_closed = dice.below(2) == 1;
            let form = dice.below(3);
            let mut sides: Vec<[[f64; 2]; 2]> = places.windows(2).map(|p| [p[0], p[1]]).collect();
            let place =
                |digit: usize, [x, y]: [f64; 2]| format!("{}|{x}|{}|{y:?}", 10 + digit, 20 + digit);
            let vertices = |before: &str| -> Vec<String> {
                places
                    .iter()
                    .map(|&p| format!("{before}{}", place(0, p)))
                    .collect()
            };
            if is_closed && form > 0 {
                sides.push([places[places.len() - 1], places[0]]);
            }
            let flag = u8::from(is_closed);
            match form {
                0 => entities.extend(
                    sides
                        .iter()
                        .map(|&[p, q]| format!("0|LINE|{}|{}", place(0, p), place(1, q))),
                ),
                1 => entities.push(format!("0|LWPOLYLINE|70|{flag}|{}", vertices("").join("|"))),
                _ => entities.push(format!(
                    "0|POLYLINE|70|{flag}|{}|0|SEQEND",
                    vertices("0|VERTEX|").join("|")
                )),
            }
            meant.extend(sides);
        }
        let graph = input(&drawing(&entities.join("|")))
            .expect("a drawing")
            .graph;
        let edges = graph.edges.iter().map(|edge| edge.map(|v| graph.points[v]));
        assert_eq!(edges.collect::<Vec<_>>(), meant);
    }
}

#[test]
fn damaged_drawings_are_refused_or_read_but_nothing_else() {
    let whole = drawing(
        "0|LINE|10|0|20|0|30|7|11|4|21|0|31|8|0|LWPOLYLINE|70|1|38|5|10|0|20|0|10|4|20|0|10|4|20|3.5|0|POLYLINE|70|8|30|1|\
         0|VERTEX|10|0|20|0|30|1|0|VERTEX|10|4|20|0|30|2|0|SEQEND|0|3DFACE|10|0|20|0|11|4|21|0|12|4|22|3.5",
    );
    let lines: Vec<&str> = whole.lines().collect();
    let mut dice = Random::new(12);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let mut damaged = lines.clone();
        for _ in 0..=dice.below(3) {
            let at = dice.below(damaged.len());
            match dice.below(3) {
                0 => drop(damaged.remove(at)),
                1 => damaged.insert(at, lines[dice.below(lines.len())]),
                _ => damaged[at] = lines[dice.below(lines.len())],
            }
        }
        let text = damaged.join("\n");
        match input(&text) {
            Ok(_) => read += 1,
            Err(error) => {
                assert!(error.starts_with("file:"));
                refused += 1;
            }
        }
        drop(triangles(&text, &[[0.0, 0.0], [4.0, 0.0]]));
    }
    assert!(read > 1000 && refused > 1000, "{read} {refused}");
}
