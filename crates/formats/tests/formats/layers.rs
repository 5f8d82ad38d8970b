//! Layers: the parts of a random map, as files of some parts each in any order, against one file that has them all.

use std::collections::BTreeMap;

use sweep_cdt::Region;
use sweep_cdt::interior::{Ring, Seed};
use sweep_cdt_formats::{
    Column, CoordinateSystem, Format, GraphFile, Input, Numbering, Polygons, Remark, Source, read,
};
use sweep_cdt_testing::Random;

/// A part of a map, in a square cell of its own, whose border it may share with its neighbours.
#[derive(Clone, Copy)]
struct Part {
    cell: usize,
    kind: Kind,
    /// Heights, wind and markers of vertices: whether the part has them.
    columns: [bool; 3],
    edge_marker: i64,
    seed: Option<f64>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// An outline and a hole.
    Polygon,
    Line,
    /// A feature without edges.
    Place,
    /// An edge, of no feature.
    Edge,
}

const NAMES: [&str; 3] = [Column::HEIGHT, "wind", Column::MARKER];

impl Part {
    fn random(cell: usize, random: &mut Random) -> Part {
        let kinds = [Kind::Polygon, Kind::Line, Kind::Place, Kind::Edge];
        Part {
            cell,
            kind: random.pick(&kinds),
            columns: [(); 3].map(|()| random.one_in(2)),
            edge_marker: random.pick(&[0, 0, 5, -3]),
            seed: random.pick(&[None, None, Some(f64::INFINITY), Some(2.5)]),
        }
    }

    fn place(&self, [x, y]: [usize; 2]) -> [f64; 2] {
        [8 * (self.cell % 3) + x, 8 * (self.cell / 3) + y].map(|x| x as f64)
    }
}

/// The file of these parts, as a reader gives it.
fn file(parts: &[Part]) -> GraphFile<f64> {
    let mut file = GraphFile::default();
    let mut columns = NAMES.map(|name| Column {
        name: name.to_owned(),
        values: Vec::new(),
    });
    let (mut areas, mut markers) = (Vec::new(), Vec::new());
    let (mut edge_features, mut ring_of) = (Vec::new(), Vec::new());
    for part in parts {
        let chains: &[&[[usize; 2]]] = match part.kind {
            Kind::Polygon => &[
                &[[0, 0], [8, 0], [8, 8], [0, 8]],
                &[[2, 2], [2, 4], [4, 4], [4, 2]],
            ],
            Kind::Line => &[&[[5, 5], [6, 7], [7, 7]]],
            Kind::Place => &[&[[0, 0]]],
            Kind::Edge => &[&[[8, 8], [5, 1]]],
        };
        file.features += usize::from(part.kind != Kind::Edge);
        if part.kind == Kind::Polygon {
            file.polygons.features.push(file.features);
        }
        for (at, chain) in chains.iter().enumerate() {
            let first = file.graph.points.len();
            for &corner in *chain {
                let [x, y] = part.place(corner);
                file.graph.points.push([x, y]);
                let numbers = [x + 100.0 * y, x - y, 7.0];
                for at in 0..3 {
                    let value = if part.columns[at] {
                        numbers[at]
                    } else {
                        f64::NAN
                    };
                    columns[at].values.push(value);
                }
            }
            let last = file.graph.points.len() - 1;
            let edges = &mut file.graph.edges;
            edges.extend((first..last).map(|v| [v, v + 1]));
            let mut ring = None;
            if part.kind == Kind::Polygon {
                edges.push([last, first]);
                ring = Some(file.polygons.rings.len());
                let polygon = file.polygons.features.len() - 1;
                let is_hole = at > 0;
                file.polygons.rings.push(Ring { polygon, is_hole });
            }
            let feature = match part.kind {
                Kind::Edge => 0,
                _ => u32::try_from(file.features).expect("a few"),
            };
            ring_of.resize(edges.len(), ring);
            edge_features.resize(edges.len(), feature);
            markers.resize(edges.len(), part.edge_marker);
        }
        if let Some(area) = part.seed {
            file.graph.holes.push(part.place([3, 3]));
            let seed = part.place([1, 5]);
            let attribute = part.cell as f64;
            file.graph.regions.push(Region { seed, attribute });
            areas.push(area);
        }
    }
    // A list of what nothing has is empty.
    let is_there = |column: &Column| column.missing() < column.values.len();
    file.columns = columns.into_iter().filter(is_there).collect();
    let keep = |is_there: bool| usize::from(is_there) * usize::MAX;
    areas.truncate(keep(areas.iter().any(|area: &f64| area.is_finite())));
    markers.truncate(keep(markers.iter().any(|&marker| marker != 0)));
    edge_features.truncate(keep(edge_features.iter().any(|&feature| feature > 0)));
    ring_of.truncate(keep(!file.polygons.is_empty()));
    let polygons = Polygons {
        ring_of,
        ..file.polygons
    };
    GraphFile {
        region_areas: areas,
        edge_markers: markers,
        edge_features,
        polygons,
        ..file
    }
}

/// Corners and, where polygons cover it, the cell of the part that the feature of a triangle is.
type Triangles = BTreeMap<[[u64; 2]; 3], Option<usize>>;

/// The triangles of a file of these parts, by their places.
fn triangles(file: &GraphFile<f64>, parts: &[Part]) -> Triangles {
    let graph = &file.graph;
    let result = sweep_cdt::triangulate(&graph.points, &graph.edges).expect("no edges cross");
    let interior = file.polygons.interior(&result);
    let features: Vec<&Part> = parts
        .iter()
        .filter(|part| part.kind != Kind::Edge)
        .collect();
    let triangles = (0..result.len()).map(|t| {
        let mut corners = result
            .triangle(t)
            .map(|v| graph.points[v].map(f64::to_bits));
        corners.sort_unstable();
        let interior = interior.as_ref().ok();
        let feature = interior.and_then(|interior| file.polygons.feature(interior, t));
        (corners, feature.map(|feature| features[feature - 1].cell))
    });
    triangles.collect()
}

#[test]
fn layers_are_the_file_that_has_all_their_parts() {
    let (mut with_polygons, mut with_all) = (0, 0);
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let cells = 0..1 + random.below(9);
        let mut parts: Vec<Part> = cells.map(|cell| Part::random(cell, &mut random)).collect();
        let mut layers = vec![Vec::new(); 1 + random.below(4)];
        for &part in &parts {
            let layer = random.below(layers.len());
            layers[layer].push(part);
        }
        let in_order = layers.concat();
        let files = layers.iter().enumerate().map(|(at, parts)| {
            let numbering = random.pick(&[Numbering::default(), Numbering::FROM_ONE]);
            let file = GraphFile {
                numbering,
                ..file(parts)
            };
            (format!("layer{at}"), file)
        });
        let files: Vec<(String, GraphFile<f64>)> = files.collect();
        let mut whole = GraphFile::of_layers(files.clone()).expect("no systems");

        // Vertices, edges and seeds have the names that their own files give them.
        for ((name, file), layer) in files.iter().zip(&whole.layers) {
            for (v, vertex) in layer.vertices.clone().enumerate() {
                let own = format!("vertex {} of {name}", v + file.numbering.vertex);
                assert_eq!(whole.vertex_of_layer(vertex), Some(own), "seed {seed}");
            }
            for (e, edge) in layer.edges.clone().enumerate() {
                let number = || format!("edge {}", e + file.numbering.edge);
                // Without features in the same file, an edge has nothing but its number.
                let part = file.part_of(e).unwrap_or_else(number);
                assert_eq!(
                    whole.part_of(edge),
                    Some(format!("{part} of {name}")),
                    "seed {seed}"
                );
            }
            for (h, hole) in layer.holes.clone().enumerate() {
                let own = format!("hole {} of {name}", h + file.numbering.hole);
                assert_eq!(
                    whole.seed_of_layer(Seed::Hole(hole)),
                    Some(own),
                    "seed {seed}"
                );
            }
        }
        assert_eq!(whole.vertex_of_layer(whole.graph.points.len()), None);

        let mut expected = file(&in_order);
        expected.numbering = files[0].1.numbering;
        whole.layers.clear();
        for file in [&mut expected, &mut whole] {
            file.columns.sort_by(|one, other| one.name.cmp(&other.name));
        }
        assert_eq!(whole, expected, "seed {seed}");
        with_polygons += usize::from(!whole.polygons.is_empty());
        with_all += usize::from(whole.columns.len() == 3 && !whole.edge_markers.is_empty());

        random.shuffle(&mut parts);
        assert_eq!(
            triangles(&whole, &in_order),
            triangles(&file(&parts), &parts),
            "seed {seed}"
        );
    }
    assert!(
        with_polygons > 200 && with_all > 200,
        "{with_polygons} {with_all}"
    );
}

/// A file of points with the columns of this text.
fn table(text: &str) -> GraphFile<f64> {
    match read(Format::Csv, &Source::new("table", text), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{text}: {other:?}"),
    }
}

#[track_caller]
fn assert_columns(layers: &[&str], expected: &[(&str, &[f64])]) {
    let layers = layers.iter().map(|text| {
        let mut file = table(text);
        for column in &mut file.columns {
            column.name = column.name.replace("_2", "");
        }
        (String::new(), file)
    });
    let whole = GraphFile::of_layers(layers.collect()).expect("no systems");
    let column = |&(name, values): &(&str, &[f64])| Column {
        name: name.to_owned(),
        values: values.to_vec(),
    };
    let expected: Vec<Column> = expected.iter().map(column).collect();
    assert_eq!(whole.columns, expected);
}

const NONE: f64 = f64::NAN;

#[test]
fn heights_of_a_later_layer_are_the_first_column() {
    assert_columns(
        &["x,y,wind\n0,0,5\n", "x,y,z\n1,1,70\n", "x,y,wind\n2,2,6\n"],
        &[("z", &[NONE, 70.0, NONE]), ("wind", &[5.0, NONE, 6.0])],
    );
}

/// As a `.ply` may have them, and a table has not.
#[test]
fn columns_of_one_name_in_one_file_stay_apart() {
    assert_columns(
        &[
            "x,y,a,a\n0,0,1,2\n1,0,3,4\n",
            "x,y,a,b,a\n5,5,6,7,8\n",
            "x,y,a\n9,9,0\n",
        ],
        &[
            ("a", &[1.0, 3.0, 6.0, 0.0]),
            ("a", &[2.0, 4.0, 8.0, NONE]),
            ("b", &[NONE, NONE, 7.0, NONE]),
        ],
    );
}

/// A remark names its vertex in the whole.
#[test]
fn remarks_of_a_later_layer_name_its_vertices() {
    let map = "POINT Z (9 9 1) POINT Z (1 1 7) POINT Z (1 1 8)";
    let Ok(Input::Doubles(map)) = read(Format::Wkt, &Source::new("map", map), None) else {
        panic!("a map");
    };
    let layers = vec![
        ("a".to_owned(), table("x,y\n0,0\n5,5\n")),
        ("b".to_owned(), map),
    ];
    let whole = GraphFile::of_layers(layers).expect("no systems");
    let words: Vec<String> = whole
        .remarks
        .iter()
        .map(|remark| whole.in_words(remark))
        .collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    assert_eq!(
        words,
        ["vertex 1 of b at (1, 1) has two numbers for z, 7 and 8: 7 counts"]
    );
    assert!(matches!(
        whole.remarks[0],
        Remark::Conflict { vertex: 3, .. }
    ));
}

#[test]
fn layers_have_one_coordinate_system() {
    let system = |text: &str| {
        let text = format!(r#"{{"type": "Point", "coordinates": [1, 2], "crs": {text}}}"#);
        match read(Format::Geojson, &Source::new("map", text), None) {
            Ok(Input::Doubles(file)) => file,
            other => panic!("{other:?}"),
        }
    };
    let named = |name: &str| {
        system(&format!(
            r#"{{"type": "name", "properties": {{"name": "{name}"}}}}"#
        ))
    };
    let whole = |files: [GraphFile<f64>; 3]| {
        let layers = ["a", "b", "c"].map(str::to_owned).into_iter().zip(files);
        let whole = GraphFile::of_layers(layers.collect());
        whole.map(|whole| whole.system.map(|system| system.name()))
    };
    let none = || table("x,y\n0,0\n");
    let utm = || named("urn:ogc:def:crs:EPSG::25832");
    let found = whole([none(), utm(), named("EPSG:25832")]);
    assert_eq!(found, Ok(Some("EPSG:25832".to_owned())));
    let error = whole([none(), utm(), named("EPSG:4326")]).expect_err("two systems");
    assert_eq!(
        error.to_string(),
        "c: the coordinate system is EPSG:4326, and that of b is EPSG:25832: files of one input must have the same"
    );
    // Without a number of the EPSG, members say the same, whatever blanks they have.
    let local = [
        r#"{"type":"name","properties":{}}"#,
        r#"{"properties": {}, "type": "name"}"#,
    ];
    let [one, other] = local.map(system);
    assert!(whole([one.clone(), other, none()]).is_ok());
    assert!(whole([one, utm(), none()]).is_err());
    let srid = GraphFile {
        system: Some(CoordinateSystem::of_srid(4326)),
        ..none()
    };
    assert!(whole([srid, none(), utm()]).is_err());
}

/// The faces of a mesh would name vertices of other layers.
#[test]
fn faces_are_left_out_with_a_remark() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let Ok(Input::Doubles(mesh)) = read(Format::Obj, &Source::new("mesh", text), None) else {
        panic!("a mesh");
    };
    let layers = |mesh: GraphFile<f64>| {
        let layers = vec![
            ("a".to_owned(), table("x,y\n5,5\n")),
            ("b".to_owned(), mesh),
        ];
        GraphFile::of_layers(layers).expect("no systems")
    };
    let whole = layers(mesh.clone());
    assert!(whole.faces.is_empty() && whole.graph.edges.is_empty());
    assert_eq!(whole.remarks, [Remark::Faces { count: 1 }]);
    let whole = layers(mesh.with_faces().expect("three corners"));
    assert_eq!(whole.graph.edges, [[1, 2], [2, 3], [3, 1]]);
    assert_eq!(whole.polygons.features, [1]);
}
