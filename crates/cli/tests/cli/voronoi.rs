//! `sweep-cdt voronoi`: cells and what they are cut to, the diagram, pictures, and what is refused.

use std::fs;
use std::path::Path;
use std::process::Output;

use num_rational::BigRational;
use serde_json::{Value, json};

use crate::{assert_fails, folder, printed, sweep_cdt, text};

fn voronoi(folder: impl AsRef<Path>, arguments: &str) -> Output {
    let output = sweep_cdt(folder, &format!("voronoi {arguments}")).output();
    output.expect("the command starts")
}

fn object(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// Two points, numbered from 1.
const TWO: &str = "2 2 0 0\n1 0 0\n2 10 0\n";

#[test]
fn cells_are_cut_to_a_box_by_default() {
    let folder = folder(&[("a.node", TWO)]);
    let cells = voronoi(&folder, "a.node -o - --output-format geojson");
    let expected = "{\"type\":\"FeatureCollection\",\"features\":[\n\
        {\"type\":\"Feature\",\"properties\":{\"point\":1},\"geometry\":{\"type\":\"Polygon\",\
        \"coordinates\":[[[-1,-1],[5,-1],[5,1],[-1,1],[-1,-1]]]}},\n\
        {\"type\":\"Feature\",\"properties\":{\"point\":2},\"geometry\":{\"type\":\"Polygon\",\
        \"coordinates\":[[[5,-1],[11,-1],[11,1],[5,1],[5,-1]]]}}]}\n";
    assert_eq!(printed(&cells), expected);
}

#[test]
fn cells_are_cut_to_what_is_asked_for() {
    let frame = "POLYGON ((-1 -4, 11 -4, 11 4, -1 4, -1 -4), (4 -1, 4 1, 6 1, 6 -1, 4 -1))";
    let bar = "POLYGON ((2 -2, 4 -2, 4 2, 2 2, 2 -2)), POLYGON ((-3 -2, -1 -2, -1 2, -3 2, -3 -2))";
    let bar = format!("GEOMETRYCOLLECTION ({bar})");
    let island = "POLYGON ((4 -1, 6 -1, 6 1, 4 1, 4 -1))";
    let files = [
        ("a.node", TWO),
        ("frame.wkt", frame),
        ("two.wkt", &bar),
        ("island.wkt", island),
    ];
    let folder = folder(&files);
    let cells = |clip: &str| {
        let made = voronoi(
            &folder,
            &format!("a.node --clip {clip} -o - --output-format geojson"),
        );
        let made = object(printed(&made));
        let cells = made["features"].as_array().expect("features").iter();
        cells
            .map(|cell| cell["geometry"].clone())
            .collect::<Vec<_>>()
    };
    let left = cells("-2,0,6.5,7").remove(0);
    assert_eq!(
        left["coordinates"],
        json!([[[-2, 0], [5, 0], [5, 7], [-2, 7], [-2, 0]]])
    );
    // The hole takes a notch out of both cells, and two polygons are two parts of one cell.
    for cell in cells("frame.wkt") {
        assert_eq!(
            (
                &cell["type"],
                cell["coordinates"][0].as_array().expect("a ring").len()
            ),
            (&json!("Polygon"), 9)
        );
    }
    let two = cells("two.wkt");
    assert_eq!(
        (&two[0]["type"], &two[1]),
        (&json!("MultiPolygon"), &Value::Null)
    );
    assert_eq!(two[0]["coordinates"].as_array().expect("polygons").len(), 2);
    // A cell within a hole has a hole.
    fs::write(folder.path().join("a.node"), "1 2\n1 0 0\n").expect("a file");
    let whole = cells("frame.wkt").remove(0);
    assert_eq!(whole["coordinates"].as_array().expect("rings").len(), 2);
    assert_eq!(
        cells("island.wkt")[0]["coordinates"],
        json!([[[4, -1], [6, -1], [6, 1], [4, 1], [4, -1]]])
    );
    for clip in ["0,0,0,1", "1,1,0,0"] {
        let refused = voronoi(&folder, &format!("a.node --clip {clip} -o c.geojson"));
        assert_eq!(refused.status.code(), Some(2), "{clip}");
    }
    let missing = voronoi(&folder, "a.node --clip none.wkt -o c.geojson");
    assert_fails(&missing, "none.wkt: no such file or directory");
}

/// Every corner is as near to its point as to any other, but for its own rounding, by fractions of what is printed.
#[test]
fn corners_are_nearest_to_their_points() {
    let folder = folder(&[]);
    for kind in ["uniform", "circle", "lattice"] {
        let data = sweep_cdt(&folder, &format!("generate {kind} 60 -o a.json")).output();
        printed(&data.expect("the command starts"));
        for clip in ["", "--clip hull"] {
            let made = voronoi(
                &folder,
                &format!("a.json {clip} -o - --output-format geojson"),
            );
            let made = object(printed(&made));
            let input = fs::read_to_string(folder.path().join("a.json")).expect("a file");
            let place = |at: &Value| {
                let exact = |x: &Value| BigRational::from_float(x.as_f64().expect("a number"));
                [0, 1].map(|i| exact(&at[i]).expect("finite"))
            };
            let input = object(&input);
            let points: Vec<_> = input["points"]
                .as_array()
                .expect("points")
                .iter()
                .map(place)
                .collect();
            let squared = |p: &[BigRational; 2], q: &[BigRational; 2]| {
                let [x, y] = [0, 1].map(|i| &p[i] - &q[i]);
                &x * &x + &y * &y
            };
            let tiny = BigRational::new(1.into(), 1_000_000_000_000_i64.into());
            let cells = made["features"].as_array().expect("features");
            assert_eq!(cells.len(), points.len());
            for cell in cells {
                let point = cell["properties"]["point"].as_u64().expect("a number");
                let own = &points[usize::try_from(point).expect("small")];
                for corner in cell["geometry"]["coordinates"][0]
                    .as_array()
                    .into_iter()
                    .flatten()
                {
                    let corner = place(corner);
                    let distance = squared(&corner, own);
                    let most =
                        &distance + &tiny * (&distance + BigRational::from_integer(1.into()));
                    assert!(points.iter().all(|other| distance <= most
                        && squared(&corner, other) + &most - &distance >= distance));
                }
            }
        }
    }
}

#[test]
fn the_diagram_has_directions_for_what_is_not_bounded() {
    let thirds = r#"{"points": [[0,0],[4,0],[2,"3/1"]]}"#;
    let folder = folder(&[
        ("a.json", thirds),
        ("b.json", r#"{"points": [[0,0],[4,0]]}"#),
    ]);
    let diagram = object(printed(&voronoi(
        &folder,
        "a.json -o - --output-format json",
    )));
    assert_eq!(diagram["vertices"], json!([[2, "5/6"]]));
    assert_eq!(diagram["cells"], json!([[0], [0], [0]]));
    assert_eq!(
        diagram["ridge_vertices"],
        json!([[0, null], [0, null], [0, null]])
    );
    let points = diagram["ridge_points"].as_array().expect("a list");
    let below = points
        .iter()
        .position(|pair| *pair == json!([1, 0]))
        .expect("a ridge");
    assert_eq!(diagram["ridge_directions"][below], json!([0, -4]));
    let line = object(printed(&voronoi(
        &folder,
        "b.json -o - --output-format json",
    )));
    assert_eq!(line["ridge_vertices"], json!([[null, null]]));
}

#[test]
fn edges_are_refused_where_they_change_the_cells() {
    // The edge is the long diagonal.
    let kite = "4 2 0 0\n1 0 0\n2 8 0\n3 4 1\n4 4 -1\n1 0\n1 1 2\n0\n";
    let folder = folder(&[
        ("a.poly", kite),
        ("b.poly", &kite.replace("1 1 2\n", "1 3 4\n")),
    ]);
    let refused = voronoi(&folder, "a.poly -o a.svg");
    let why = "a.poly: an edge keeps side 1-2 from being Delaunay: triangulate the points without edges \
               (--without-edges takes the points alone)";
    assert_fails(&refused, why);
    printed(&voronoi(
        &folder,
        "a.poly --without-edges -o a.svg -o a.png -o a.geojson",
    ));
    printed(&voronoi(&folder, "b.poly -o b.svg -o b.png -o b.geojson"));
    let read = |name: &str| fs::read(folder.path().join(name)).expect("a file");
    for extension in ["svg", "png", "geojson"] {
        assert_eq!(
            read(&format!("a.{extension}")),
            read(&format!("b.{extension}"))
        );
    }
    assert!(text(&read("a.svg")).contains("cells: 4<"));
}

#[test]
fn equal_points_share_a_cell() {
    let folder = folder(&[
        ("a.csv", "x,y\n0,0\n4,0\n0,0\n"),
        ("b.csv", "x,y\n"),
        ("c.csv", "x,y\n1,1\n"),
    ]);
    let made = voronoi(&folder, "a.csv -o a.geojson");
    let note = "note: a.csv: 1 point equals another one, and shares its cell\n";
    assert_eq!((text(&made.stderr), made.status.code()), (note, Some(0)));
    let cells = fs::read_to_string(folder.path().join("a.geojson")).expect("a file");
    assert_eq!(cells.matches("\"point\":").count(), 2);
    let empty = voronoi(&folder, "b.csv -o - --output-format geojson");
    assert_eq!(
        text(&empty.stderr),
        "note: b.csv: no triangles: there are no points\n"
    );
    let one = object(printed(&voronoi(
        &folder,
        "c.csv -o - --output-format geojson",
    )));
    let coordinates = &one["features"][0]["geometry"]["coordinates"];
    assert_eq!(
        *coordinates,
        json!([[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]])
    );
}
