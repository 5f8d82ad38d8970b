//! Formats of other programs: what these wrote is read as it was meant, and what is written is read again.
//!
//! `tests/data/meshes.jsonl` holds one small terrain, first as lists, and then as files of other programs: made by
//! `meshio`, `shapely` and VTK, or byte by byte by their specification, as `origin` says.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Deserialize;
use sweep_cdt::Pslg;
use sweep_cdt::verify::Verifier;
use sweep_cdt_formats::{
    Column, Format, GraphFile, Input, Matched, Source, read, read_result, write, write_graph,
};
use sweep_cdt_testing::Random;

/// The terrain.
#[derive(Deserialize)]
struct Terrain {
    points: Vec<[f64; 3]>,
    edges: Vec<[usize; 2]>,
    triangles: Vec<[usize; 3]>,
}

/// A file with it.
#[derive(Deserialize)]
struct Sample {
    /// The contents: `triangles`, lines too (`all`), triangles without a list of vertices (`soup`), triangles in
    /// single precision (`single`), no triangles (`graph`), or what is not read (`refused`).
    kind: String,
    format: String,
    origin: String,
    base64: String,
}

fn samples() -> (Terrain, Vec<Sample>) {
    let text = include_str!("../data/meshes.jsonl");
    let (first, others) = text.split_once('\n').expect("a first line");
    let others = others.lines();
    let sample = |line| serde_json::from_str(line).expect("a sample");
    (
        serde_json::from_str(first).expect("the terrain"),
        others.map(sample).collect(),
    )
}

impl Terrain {
    fn file(&self) -> GraphFile<f64> {
        let graph = Pslg {
            points: self.points.iter().map(|&[x, y, _]| [x, y]).collect(),
            edges: self.edges.clone(),
            ..Pslg::default()
        };
        GraphFile {
            columns: vec![Column {
                name: Column::HEIGHT.to_owned(),
                values: self.points.iter().map(|point| point[2]).collect(),
            }],
            ..graph.into()
        }
    }
}

impl Sample {
    fn source(&self) -> Source {
        source(&STANDARD.decode(&self.base64).expect("base 64"))
    }
}

fn source(bytes: &[u8]) -> Source {
    Source::new("file", bytes.to_vec())
}

/// An input of doubles.
#[track_caller]
fn file(format: Format, source: &Source) -> GraphFile<f64> {
    match read(format, source, None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{format:?}: {other:?}"),
    }
}

#[test]
fn triangles_of_other_programs_are_read() {
    let (terrain, samples) = samples();
    let input = terrain.file();
    let is_result = |sample: &&Sample| !["graph", "refused"].contains(&sample.kind.as_str());
    for sample in samples.iter().filter(is_result) {
        let format = Format::named(&sample.format, Format::RESULTS).expect("a format that is read");
        let result = read_result(format, &sample.source(), None, &input);
        let result = result.unwrap_or_else(|error| panic!("{}: {error}", sample.origin));
        assert_eq!(result.list, terrain.triangles, "{}", sample.origin);
        let is_single = sample.kind == "single" || sample.origin.contains("stl {'binary': True}");
        match result.matched {
            Matched::Rounded { difference } if sample.kind == "single" => {
                assert!((1e-8..1e-6).contains(&difference));
            }
            Matched::Single { difference } if is_single => {
                assert!((1e-8..1e-6).contains(&difference));
            }
            matched => assert_eq!((matched, is_single), (Matched::Equal, false)),
        }
        let verdict = Verifier::new().verify(&input.graph.points, &[], &result.list);
        assert!(verdict.is_ok(), "{}", sample.origin);
    }
}

#[test]
fn graphs_of_other_programs_are_read() {
    let (terrain, samples) = samples();
    let expected = terrain.file();
    let is_input = |sample: &&Sample| ["triangles", "all", "graph"].contains(&sample.kind.as_str());
    for sample in samples.iter().filter(is_input) {
        let format = Format::named(&sample.format, Format::INPUTS).expect("a format that is read");
        let found = file(format, &sample.source());
        assert_eq!(
            found.graph.points, expected.graph.points,
            "{}",
            sample.origin
        );
        assert_eq!(found.columns[0], expected.columns[0], "{}", sample.origin);
        if sample.kind != "triangles" {
            assert_eq!(found.graph.edges, expected.graph.edges, "{}", sample.origin);
        }
    }
}

#[test]
fn other_columns_go_with_the_vertices() {
    let (_, samples) = samples();
    let rain = |values: [f64; 6]| Column {
        name: "rain".to_owned(),
        values: values.to_vec(),
    };
    let mut count = 0;
    for sample in samples
        .iter()
        .filter(|sample| sample.kind != "refused" && !sample.origin.starts_with("struct"))
    {
        let format = Format::named(&sample.format, Format::INPUTS);
        if let Some(format @ (Format::Ply | Format::Vtk | Format::Vtu)) = format {
            let read_first = file(format, &sample.source());
            assert_eq!(
                read_first.columns[1..],
                [rain([1.5, 2.0, 3.0, 4.0, 5.0, 0.1])]
            );
            for again in [Format::Ply, Format::Vtk, Format::Vtu] {
                let mut text = Vec::new();
                write_graph(again, &read_first, &mut text).expect("memory takes it");
                assert_eq!(
                    file(again, &source(&text)).columns,
                    read_first.columns,
                    "{again:?}"
                );
            }
            let mut text = Vec::new();
            write_graph(Format::Node, &read_first, &mut text).expect("memory takes it");
            let of_node = file(Format::Node, &source(&text)).columns;
            assert_eq!(of_node[0], read_first.columns[0]);
            assert_eq!(of_node[1].values, read_first.columns[1].values);
            count += 1;
        }
    }
    assert_eq!(count, 15);
}

/// Whether a format holds more than vertices.
fn has_edges(format: Format) -> bool {
    use Format::{Csv, Node, Npy, Txt, Xyz};
    ![Node, Csv, Xyz, Txt, Npy].contains(&format)
}

#[test]
fn every_format_reads_what_it_writes() {
    let (terrain, _) = samples();
    let terrain = terrain.file();
    let flat = GraphFile {
        columns: Vec::new(),
        ..terrain.clone()
    };
    for written in [terrain, flat] {
        for &format in Format::GRAPHS {
            let mut text = Vec::new();
            write_graph(format, &written, &mut text).expect("memory takes it");
            let again = file(format, &source(&text));
            assert_eq!(again.graph.points, written.graph.points, "{format:?}");
            assert_eq!(again.columns, written.columns, "{format:?}");
            if has_edges(format) {
                assert_eq!(again.graph.edges, written.graph.edges, "{format:?}");
            }
        }
        let result = sweep_cdt::triangulate(&written.graph.points, &written.graph.edges);
        let result = result.expect("edges do not cross");
        for &format in Format::RESULTS {
            let mut text = Vec::new();
            write(format, &written, &result, &mut text).expect("memory takes it");
            let again = read_result(format, &source(&text), None, &written);
            let again = again.unwrap_or_else(|error| panic!("{format:?}: {error}"));
            assert_eq!(again.list, result.canonical_triangles(), "{format:?}");
        }
    }
}

/// Random heights, some of them 0 and some missing, through every pair of formats: none is invented, none is lost.
#[test]
fn missing_heights_stay_missing() {
    let (terrain, _) = samples();
    let mut dice = Random::new(1);
    for _ in 0..20 {
        let mut written = terrain.file();
        let values = &mut written.columns[0].values;
        for value in values.iter_mut() {
            *value = match dice.below(3) {
                0 => f64::NAN,
                1 => 0.0,
                _ => 100.0 * dice.unit(),
            };
        }
        values[0] = 1.5;
        values[1] = f64::NAN;
        let through = |format, written: &GraphFile<f64>| {
            let mut text = Vec::new();
            write_graph(format, written, &mut text).expect("memory takes it");
            let again = file(format, &source(&text));
            assert_eq!(again.columns, written.columns, "{format:?}");
            again
        };
        for &one in Format::GRAPHS {
            let again = through(one, &written);
            for &other in Format::GRAPHS {
                through(other, &again);
            }
        }
    }
}

/// `GenericMappingTools/gmt#2268`: of a place that is named with and without a height, the known one counts.
/// `developmentseed/geojson-pydantic#139`: `NaN` is no height, as GEOS writes it.
/// `qgis/QGIS#44501`, `jblindsay/whitebox-tools#180`: none is made up for lines without one.
#[test]
fn what_a_file_says_of_heights_is_kept() {
    let heights = |format, text: &str| {
        let columns = file(format, &source(text.as_bytes())).columns;
        columns
            .into_iter()
            .next()
            .map_or(Vec::new(), |column| column.values)
    };
    let is = |found: &[f64], expected: &[f64]| {
        // NaN equals itself in text.
        assert_eq!(format!("{found:?}"), format!("{expected:?}"));
    };
    let nan = f64::NAN;
    let wkt = "LINESTRING (0 0, 10 10)\nLINESTRING Z (0 0 5, 5 5 6, 10 10 7)";
    is(&heights(Format::Wkt, wkt), &[5.0, 7.0, 6.0]);
    is(
        &heights(Format::Wkt, "MULTIPOINT Z (0 0 NaN, 1 0 2)"),
        &[nan, 2.0],
    );
    is(
        &heights(Format::Wkt, "MULTIPOINT Z (0 0 NaN, 1 0 nan)"),
        &[],
    );
    let json = "{\"points\": [[0, 0, null], [1, 0, 2], [0, 1]]}";
    is(&heights(Format::Json, json), &[nan, 2.0, nan]);
    let ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
               property float intensity\nend_header\n0 0 nan\n1 0 0.5\n";
    is(&heights(Format::Ply, ply), &[nan, 0.5]);
}

#[test]
fn damaged_files_are_refused_or_read_but_nothing_else() {
    let (terrain, samples) = samples();
    let input = terrain.file();
    let mut refused = 0;
    for sample in &samples {
        let whole = sample.source().bytes;
        let mut damaged: Vec<Vec<u8>> = (0..whole.len()).map(|end| whole[..end].to_vec()).collect();
        for at in 0..whole.len() {
            for byte in *b"9- {\n\xff" {
                damaged.push([&whole[..at], &[byte], &whole[at + 1..]].concat());
            }
        }
        for bytes in damaged {
            let source = source(&bytes);
            if let Some(format) = Format::named(&sample.format, Format::RESULTS) {
                match read_result(format, &source, None, &input) {
                    Ok(triangles) => {
                        drop(Verifier::new().verify(&input.graph.points, &[], &triangles.list));
                    }
                    Err(error) => assert!(error.to_string().starts_with("file:")),
                }
            }
            if let Some(format) = Format::named(&sample.format, Format::INPUTS)
                && let Err(error) = read(format, &source, None)
            {
                assert!(error.to_string().starts_with("file:"));
                refused += 1;
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}

/// A file that announces more than it has must not take the memory for it.
#[test]
fn counts_are_not_believed() {
    const MANY: &str = "1000000000000000000";
    let (_, samples) = samples();
    for sample in &samples {
        let bytes = sample.source().bytes;
        for number in ["6", "8", "30"] {
            for at in 0..bytes.len() {
                if bytes[at..].starts_with(number.as_bytes()) {
                    let after = &bytes[at + number.len()..];
                    let source = source(&[&bytes[..at], MANY.as_bytes(), after].concat());
                    if let Some(format) = Format::named(&sample.format, Format::INPUTS) {
                        drop(read(format, &source, None));
                    }
                    if let Some(format) = Format::named(&sample.format, Format::RESULTS) {
                        drop(read_result(
                            format,
                            &source,
                            None,
                            &GraphFile::<f64>::default(),
                        ));
                    }
                }
            }
        }
    }
}

/// The files that are written, as the specifications of the formats have it.
#[test]
fn triangles_are_written_by_the_book() {
    let graph = Pslg {
        points: vec![[0.5, 0.0], [4.0, 0.0], [0.0, 3.0]],
        edges: vec![[1, 2]],
        ..Pslg::default()
    };
    let file = GraphFile {
        columns: vec![
            Column {
                name: "z".to_owned(),
                values: vec![7.0, 8.5, -9.0],
            },
            Column {
                name: "wind speed".to_owned(),
                values: vec![1.0, 2.0, 0.25],
            },
        ],
        edge_markers: vec![-5],
        ..graph.into()
    };
    let graph = &file.graph;
    let result = sweep_cdt::triangulate(&graph.points, &graph.edges).expect("a triangle");
    for (format, lines) in [
        ("obj", "v 0.5 0 7|v 4 0 8.5|v 0 3 -9|l 2 3|f 1 2 3"),
        ("off", "OFF|3 1 0|0.5 0 7|4 0 8.5|0 3 -9|3 0 1 2"),
        (
            "ply",
            "ply|format ascii 1.0|element vertex 3|property double x|property double y|property double z|\
             property double wind_speed|element edge 1|property int vertex1|property int vertex2|property int marker|\
             element face 1|property list uchar int vertex_indices|end_header|\
             0.5 0 7 1|4 0 8.5 2|0 3 -9 0.25|1 2 -5|3 0 1 2",
        ),
        (
            "vtk",
            "# vtk DataFile Version 3.0|sweep-cdt|ASCII|DATASET UNSTRUCTURED_GRID|POINTS 3 double|0.5 0 7|4 0 8.5|0 3 -9|\
             CELLS 2 7|2 1 2|3 0 1 2|CELL_TYPES 2|3|5|CELL_DATA 2|SCALARS marker long 1|LOOKUP_TABLE default|-5|0|\
             POINT_DATA 3|SCALARS wind_speed double 1|LOOKUP_TABLE default|1|2|0.25",
        ),
        (
            "vtu",
            "<?xml version=\"1.0\"?>|\
             <VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">|<UnstructuredGrid>|\
             <Piece NumberOfPoints=\"3\" NumberOfCells=\"2\">|<PointData>|\
             <DataArray type=\"Float64\" Name=\"wind speed\" NumberOfComponents=\"1\" format=\"ascii\">|1|2|0.25|\
             </DataArray>|</PointData>|<CellData>|\
             <DataArray type=\"Int64\" Name=\"marker\" NumberOfComponents=\"1\" format=\"ascii\">|-5|0|</DataArray>|\
             </CellData>|<Points>|\
             <DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">|\
             0.5 0 7|4 0 8.5|0 3 -9|</DataArray>|</Points>|<Cells>|\
             <DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">|1 2|0 1 2|\
             </DataArray>|\
             <DataArray type=\"Int64\" Name=\"offsets\" NumberOfComponents=\"1\" format=\"ascii\">|2|5|</DataArray>|\
             <DataArray type=\"UInt8\" Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">|3|5|</DataArray>|\
             </Cells>|</Piece>|</UnstructuredGrid>|</VTKFile>",
        ),
        (
            "msh",
            "$MeshFormat|2.2 0 8|$EndMeshFormat|$Nodes|3|1 0.5 0 7|2 4 0 8.5|3 0 3 -9|$EndNodes|$Elements|2|\
             1 1 2 -5 -5 2 3|2 2 2 0 0 1 2 3|$EndElements",
        ),
        (
            "stl",
            "solid sweep-cdt|facet normal 0 0 0|outer loop|vertex 0.5 0 7|vertex 4 0 8.5|vertex 0 3 -9|endloop|\
             endfacet|endsolid sweep-cdt",
        ),
        (
            "geojson",
            "{\"type\":\"FeatureCollection\",\"features\":[|{\"type\":\"Feature\",\"properties\":{},\"geometry\":\
             {\"type\":\"Polygon\",\"coordinates\":[[[0.5,0,7],[4,0,8.5],[0,3,-9],[0.5,0,7]]]}}]}",
        ),
        (
            "wkt",
            "GEOMETRYCOLLECTION Z (|POLYGON Z ((0.5 0 7,4 0 8.5,0 3 -9,0.5 0 7)))",
        ),
    ] {
        let mut text = Vec::new();
        let format = Format::named(format, Format::OUTPUTS).expect("a format");
        write(format, &file, &result, &mut text).expect("memory takes it");
        let text = String::from_utf8(text).expect("text");
        assert_eq!(text.trim_end().replace('\n', "|"), lines, "{format:?}");
    }
}

/// Corners that stand in the order of the vertices, two of which are duplicates: no number says that they are meant.
#[test]
fn corners_are_the_lowest_of_equal_vertices() {
    let [a, b, c, d] = [[0.0, 0.0], [1.0, -2.0], [2.0, -2.0], [3.0, 0.0]];
    let points = vec![a, b, c, a, c, d];
    let graph = Pslg {
        points,
        ..Pslg::default()
    };
    let text = "MULTIPOLYGON (((0 0, 1 -2, 2 -2, 0 0)), ((0 0, 2 -2, 3 0, 0 0)))";
    let result = read_result(Format::Wkt, &source(text.as_bytes()), None, &graph.into())
        .expect("its vertices");
    assert_eq!(result.list, [[0, 1, 2], [0, 2, 5]]);
}
