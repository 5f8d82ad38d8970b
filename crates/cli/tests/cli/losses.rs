//! The table of `docs/formats.md`: what each format can say is read, written, or left out with a note.
//!
//! One file with everything in it is written in each format; numbers that stand nowhere else tell what is there. What was
//! written is read again, and so are files made by hand in the formats that are only read.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::{folder, run, text};

const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/formats.md");

/// A square with a square hole in it, and in each kind of number one that stands nowhere else.
const ALL: &str = r#"{
"points": [[0, 0, 812.5], [9, 0], [9, 9, 3], [0, 9, 4], [3, 3, 5], [6, 3, 6], [6, 6, 7], [3, 6, 8]],
"edges": [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]],
"holes": [[4.5, 4.75]],
"regions": [[1, 2, 99]],
"vertex_markers": [4711, 0, 0, 0, 0, 0, 0, 0],
"edge_markers": [1234, 0, 0, 0, 0, 0, 0, 0],
"columns": {"wind": [0.0625, null, 1, 2, 3, 4, 5, 6]},
"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}
}"#;

/// The contents of the table's columns.
const CONTENTS: [&str; 10] = [
    "heights",
    "columns",
    "markers of vertices",
    "markers of edges",
    "seeds of holes and regions",
    "regions or features of triangles",
    "constrained sides",
    "polygons",
    "faces",
    "coordinate system",
];

/// For each format its row: what the table says of each content.
fn table() -> BTreeMap<String, Vec<String>> {
    let docs = fs::read_to_string(DOCS).expect("the documentation");
    let (_, section) = docs
        .split_once("## What a format can say")
        .expect("the section");
    let mut lines = section.lines().skip_while(|line| !line.starts_with('|'));
    let fields = |line: &str| -> Vec<String> {
        let inner = line.trim_matches('|').split('|');
        inner.map(|field| field.trim().to_owned()).collect()
    };
    let head = fields(lines.next().expect("a head"));
    assert_eq!(head[1..], CONTENTS);
    let rows = lines.skip(1).take_while(|line| line.starts_with('|'));
    let mut table = BTreeMap::new();
    for row in rows {
        let row = fields(row);
        assert_eq!(row.len(), 1 + CONTENTS.len(), "{row:?}");
        for name in row[0].split(", ") {
            let name = name.trim_matches(['`', '.']).to_owned();
            table.insert(name, row[1..].to_vec());
        }
    }
    table
}

/// What a run writes to a file, with what it says.
fn written(folder: &Path, input: &str, output: &str) -> (Vec<u8>, String) {
    let run = run(folder, &format!("{input} -o {output}"));
    let said = text(&run.stderr).to_owned();
    assert!(run.status.success(), "{input} to {output}: {said}");
    (fs::read(folder.join(output)).expect("the output"), said)
}

/// Whether a text or a double is in a file.
fn has(bytes: &[u8], number: f64) -> bool {
    let text = number.to_string();
    let is_in = |piece: &[u8]| bytes.windows(piece.len()).any(|window| window == piece);
    is_in(text.as_bytes()) || is_in(&number.to_le_bytes())
}

#[test]
fn what_a_format_has_room_for_is_written_and_the_rest_is_said() {
    let table = table();
    let folder = folder(&[("all.json", ALL)]);
    let formats = [
        "node", "ele", "json", "cert", "obj", "off", "ply", "vtk", "vtu", "vtp", "msh", "stl",
        "geojson", "wkt", "npy", "npz",
    ];
    for format in formats {
        // Of a `.ele` the vertices stand in the `.node` beside it.
        let (bytes, said) = written(folder.path(), "all.json", &format!("{format}.{format}"));
        let notes: Vec<&str> = said
            .lines()
            .filter(|line| line.contains("not written: "))
            .collect();
        assert!(notes.len() <= 1, "{said}");
        let note = notes.first().copied().unwrap_or_default();
        for (at, number, words) in [
            (0, 812.5, "height"),
            (1, 0.0625, "the column `wind`"),
            (2, 4711.0, "markers of 1 vertices"),
            (3, 1234.0, "markers of 1 edges"),
            (5, 99.0, "regions of triangles"),
            (9, 25832.0, "the coordinate system EPSG:25832"),
        ] {
            let cell = &table[format][at][..];
            // The seeds of regions have their attribute, too.
            let is_of_seed = format == "npz" && words.starts_with("regions");
            let what = format!("{format}: {}: {cell}: {said}", CONTENTS[at]);
            let is_written = matches!(cell, "both" | "written") || is_of_seed;
            assert_eq!(has(&bytes, number), is_written, "{what}");
            assert_eq!(note.contains(words), cell.ends_with("said"), "{what}");
        }
    }
}

/// What a JSON says of its input.
fn contents(bytes: &[u8], said: &str) -> Vec<bool> {
    let json: Value = serde_json::from_slice(bytes).expect("JSON");
    let is_marked = |name: &str| {
        let markers = json[name].as_array();
        markers.is_some_and(|markers| markers.iter().any(|marker| marker != 0))
    };
    let points = json["points"].as_array().expect("points");
    vec![
        points
            .iter()
            .any(|point| point.get(2).is_some_and(|z| *z == 812.5)),
        json["columns"]
            .as_object()
            .is_some_and(|columns| !columns.is_empty()),
        is_marked("vertex_markers"),
        is_marked("edge_markers"),
        said.contains("rule holes"),
        false,
        !json["edges"].as_array().expect("edges").is_empty(),
        said.contains("rule polygons"),
        said.contains("(--faces takes them for polygons)"),
        json.get("crs").is_some(),
    ]
}

#[test]
fn what_a_format_says_is_read() {
    let table = table();
    let folder = folder(&[
        ("all.json", ALL),
        (
            "hand.poly",
            "4 2 2 1\n1 0 0 812.5 5 4711\n2 4 0 1 6 0\n3 4 4 2 7 0\n4 0 4 3 8 0\n\
                       5 1\n1 1 2 1234\n2 2 3 0\n3 3 4 0\n4 4 1 0\n5 1 3 0\n1\n1 1 3\n1\n1 3 1 99\n",
        ),
        (
            "hand.csv",
            "x,y,z,wind,marker\n0,0,812.5,0.0625,4711\n4,0,,,\n0,4,1,,\n",
        ),
        (
            "hand.xyz",
            "x y z wind marker\n0 0 812.5 0.0625 4711\n4 0 1 2 0\n0 4 1 3 0\n",
        ),
        (
            "hand.txt",
            "x\ty\tz\twind\tmarker\n0\t0\t812.5\t0.0625\t4711\n4\t0\t1\t2\t0\n0\t4\t1\t3\t0\n",
        ),
        (
            "hand.geojson",
            r#"{"type": "Polygon", "crs": {"type": "name", "properties": {"name": "EPSG:25832"}},
                "coordinates": [[[0, 0, 812.5], [4, 0, 1], [0, 4, 2], [0, 0, 812.5]]]}"#,
        ),
        (
            "hand.wkt",
            "SRID=25832;POLYGON Z ((0 0 812.5, 4 0 1, 0 4 2, 0 0 812.5))",
        ),
    ]);
    // A mesh with lines, and nothing of which a result takes no part.
    let by_hand = ["poly", "csv", "xyz", "txt", "geojson", "wkt"];
    for (format, row) in &table {
        let is_result_alone = ["ele", "cert", "stl", "npy"].contains(&&format[..]);
        // Clouds have tests of their own (`clouds.rs`).
        let is_cloud = ["las", "laz"].contains(&&format[..]);
        if is_result_alone || is_cloud {
            continue;
        }
        let input = match by_hand.contains(&&format[..]) {
            true => format!("hand.{format}"),
            false => {
                let name = format!("made.{format}");
                written(folder.path(), "all.json", &name);
                name
            }
        };
        let back = format!("back-{format}.json");
        let (bytes, mut said) = written(folder.path(), &input, &back);
        let summary = run(folder.path(), &input);
        said.push_str(text(&summary.stdout));
        for (at, is_there) in contents(&bytes, &said).into_iter().enumerate() {
            // A result holds no seeds, and what is read of its triangles is for `verify`.
            let is_of_results = CONTENTS[at] == "regions or features of triangles"
                || CONTENTS[at] == "seeds of holes and regions" && input.starts_with("made");
            if is_of_results {
                continue;
            }
            let cell = &row[at][..];
            // Edges of a map or of a `.poly` are none of a mesh.
            let is_read = matches!(cell, "both" | "read")
                || CONTENTS[at] == "constrained sides"
                    && ["poly", "geojson", "wkt"].contains(&&format[..])
                || CONTENTS[at] == "constrained sides" && format == "npz";
            assert_eq!(
                is_there, is_read,
                "{format}: {}: {cell}: {said}",
                CONTENTS[at]
            );
        }
    }
}
