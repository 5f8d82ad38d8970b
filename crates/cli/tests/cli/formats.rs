//! Every format read and written.

use std::fs;
use std::path::Path;

use crate::{
    CONTOURS, FORMATS, assert_fails, folder, names, printed, printed_despite_losses, run,
    run_with_input, sweep_cdt,
};

#[test]
fn all_input_formats_are_read() {
    let output = run(FORMATS, "ten.poly -o - --output-format json");
    // The attribute of its vertices, 0.5 or 0, is a height, which the others do not have. Nor do they have markers.
    let (points, others) = printed(&output).split_once("\"edges\"").expect("edges");
    let points = points.replace(",0]", "]").replace(",0.5]", "]");
    let (edges, others) = others.split_once("\"vertex_markers\"").expect("markers");
    let (_, others) = others.split_once("\"triangles\"").expect("triangles");
    let expected = format!("{points}\"edges\"{edges}\"triangles\"{others}");
    for input in ["ten.json", "split.poly"] {
        assert_eq!(
            printed_despite_losses(&run(FORMATS, &format!("{input} -o - --output-format json"))),
            expected,
            "{input}"
        );
    }
    let summary = "split.node: points 10, duplicates 0, edges 0, triangles 12, hull 6\n";
    assert_eq!(printed(&run(FORMATS, "split.node")), summary);
}

#[test]
fn standard_input_is_read() {
    for (format, file) in [
        ("poly", "ten.poly"),
        ("json", "ten.json"),
        ("node", "split.node"),
    ] {
        let input = fs::read(Path::new(FORMATS).join(file)).expect("a file");
        let expected = run(FORMATS, &format!("{file} -o - --output-format json"));
        let output = run_with_input(
            &format!("- --input-format {format} -o - --output-format json"),
            &input,
        );
        assert_eq!(
            printed_despite_losses(&output),
            printed_despite_losses(&expected),
            "{file}"
        );
    }
    let output = run_with_input("- --input-format poly", b"0 2\n0\n");
    assert_fails(
        &output,
        "standard input: no vertices, and no .node beside it",
    );
}

#[test]
fn vertices_keep_their_numbers_in_ele_and_node() {
    let corner = "3 2 1 0\n1 0 0 7\n2 1e300 -0.0 7\n3 0.10 1 7\n";
    let folder = folder(&[("corner.node", corner)]);
    printed(&run(&folder, "corner.node -o other.ele -o corner.ele"));
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a file");
    assert_eq!(
        names(folder.path()),
        ["corner.ele", "corner.node", "other.ele", "other.node"]
    );
    assert_eq!(read("corner.node"), corner, "it holds the vertices already");
    assert_eq!(
        read("other.node"),
        "3 2 1 0\n1 0 0 7\n2 1e300 -0 7\n3 0.1 1 7\n"
    );
    assert_eq!(read("other.ele"), "1 3 0\n1 1 2 3\n");
    assert_eq!(read("corner.ele"), read("other.ele"));

    printed(&run(&folder, "corner.node -o corner.json"));
    printed_despite_losses(&run(&folder, "corner.json -o corner.ele -o corner.node"));
    assert_eq!(read("corner.ele"), "1 3 0\n0 0 1 2\n", "JSON counts from 0");
    assert_eq!(
        read("corner.node"),
        "3 2 1 0\n0 0 0 7\n1 1e300 -0 7\n2 0.1 1 7\n",
        "so this must too"
    );
}

#[test]
fn json_output_describes_the_result_and_can_be_read_again() {
    let thirds = run(FORMATS, "thirds.json -o - --output-format json");
    let expected = r#"{
"points": [
[0,0],
["1/3","1/7"],
["2/3","2/7"],
[1,"3/7"],
["-1/10","9/10"],
["1/3","1/7"],
["1/2",-1]],
"edges": [
[0,3]],
"triangles": [
[0,1,4],
[0,6,1],
[1,2,4],
[1,6,2],
[2,3,4],
[2,6,3]],
"neighbors": [
[2,null,1],
[3,0,null],
[4,0,3],
[5,2,1],
[null,2,5],
[null,4,3]],
"constrained": [
[0,1],
[1,2],
[2,3]],
"hull": [
4,
0,
6,
3],
"duplicates": [
[5,1]],
"chains": [
[0,1,2,3]]
}
"#;
    assert_eq!(printed_despite_losses(&thirds), expected);
    let again = run_with_input(
        "- --input-format json -o - --output-format json",
        &thirds.stdout,
    );
    assert_eq!(printed_despite_losses(&again), expected);
    assert_eq!(
        printed(&run(FORMATS, "thirds.poly -o - --output-format json")),
        expected
    );
}

#[test]
fn obj_counts_from_1_and_has_three_dimensions() {
    let output = run_with_input(
        "- --input-format json -o - --output-format obj",
        br#"{"points":[[0,0],["3/2",0],[0,1]]}"#,
    );
    assert_eq!(printed(&output), "v 0 0 0\nv 1.5 0 0\nv 0 1 0\nf 1 2 3\n");
}

#[test]
fn svg_tells_triangles_edges_and_hull_apart() {
    let output = run(FORMATS, "ten.poly -o - --output-format svg");
    let svg = printed(&output);
    for (class, lines) in [("side", 1), ("edge", 1), ("hull", 1), ("vertex", 1)] {
        let found = svg
            .matches(&format!("<path class=\"{class}\" d=\"M"))
            .count();
        assert_eq!(found, lines, "{class}");
    }
    assert!(
        svg.contains(">10</text>"),
        "vertices have the numbers of the file"
    );
    let output = run(FORMATS, &format!("{CONTOURS} -o - --output-format svg"));
    assert!(printed(&output).len() < 1_000_000);
}

#[test]
fn svg_is_the_same_for_subnormal_and_huge_coordinates() {
    let picture = |exponent: &str| {
        let points = ["0,0", "4,0", "0,4", "4,4"].map(|point| {
            let [x, y] = [&point[..1], &point[2..]].map(|digit| format!("{digit}{exponent}"));
            format!("[{x},{y}]")
        });
        let input = format!("{{\"points\":[{}]}}", points.join(","));
        let output = run_with_input(
            "- --input-format json -o - --output-format svg",
            input.as_bytes(),
        );
        printed(&output).to_owned()
    };
    let expected = picture("");
    for exponent in ["e-323", "e-300", "e307"] {
        assert_eq!(picture(exponent), expected, "4{exponent}");
    }
}

/// Three points of 72 bytes, packed by zlib.
#[test]
fn what_a_file_unpacks_to_has_a_limit_that_can_be_raised() {
    let points = "AQAAAEgAAAAAAAAAEQAAAHjaY2DABz7YMxApDwA9VgJf";
    let array = |kind: &str, name: &str, numbers: &str| {
        format!("<DataArray type=\"{kind}\" Name=\"{name}\">{numbers}</DataArray>\n")
    };
    let cells = [
        array("Int64", "connectivity", "0 1 2"),
        array("Int64", "offsets", "3"),
        array("UInt8", "types", "5"),
    ];
    let text = format!(
        "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkZLibDataCompressor\">\n\
         <UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n\
         <Points><DataArray type=\"Float64\" Name=\"P\" NumberOfComponents=\"3\" format=\"binary\">\n\
         {points}</DataArray></Points>\n<Cells>{}</Cells></Piece></UnstructuredGrid></VTKFile>\n",
        cells.concat()
    );
    let folder = folder(&[("a.vtu", &text)]);
    let error = "a.vtu:3: the array `P`: with its 72 bytes the file would unpack to more than the limit of 71 bytes \
         (--unpacked-limit allows more)";
    let ran = |arguments: &str| {
        sweep_cdt(&folder, arguments)
            .output()
            .expect("the command starts")
    };
    for arguments in [
        "triangulate a.vtu",
        "verify a.vtu a.vtu",
        "crossings a.vtu",
        "trace a.vtu",
    ] {
        assert_fails(&ran(&format!("{arguments} --unpacked-limit 71")), error);
        for size in ["72", "1kB", "16G", "2GiB"] {
            printed_despite_losses(&ran(&format!("{arguments} --unpacked-limit {size}")));
        }
        printed_despite_losses(&ran(arguments));
    }
    printed_despite_losses(&ran("trace a.vtu -o a.txt"));
    let replay = "replay a.txt --input a.vtu --unpacked-limit";
    assert_fails(&ran(&format!("{replay} 71")), error);
    printed_despite_losses(&ran(&format!("{replay} 72")));
    let output = ran("triangulate a.vtu --unpacked-limit much");
    assert_eq!(output.status.code(), Some(2));
}
