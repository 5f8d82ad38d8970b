//! VTK's XML: what is refused, and why; what is read over; and files that lie about their arrays.

use std::fmt::Write as _;
use std::io::Read;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::read::ZlibEncoder;
use sweep_cdt_formats::{
    Format, GraphFile, Input, ReadError, ReadErrorKind, Source, read, read_result, write_graph,
};

/// A file of two points and a line: what the elements `VTKFile` and `Points` say, and what stands behind the piece.
fn file(head: &str, points: &str, tail: &str) -> Vec<u8> {
    let text = format!(
        "<VTKFile type=\"UnstructuredGrid\" {head}>\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"2\" NumberOfCells=\"1\">\n\
         <Points>\n{points}\n</Points>\n<Cells>\n\
         <DataArray type=\"Int64\" Name=\"connectivity\">0 1</DataArray>\n\
         <DataArray type=\"Int64\" Name=\"offsets\">2</DataArray>\n\
         <DataArray type=\"UInt8\" Name=\"types\">3</DataArray>\n\
         </Cells>\n</Piece>\n</UnstructuredGrid>\n{tail}</VTKFile>\n"
    );
    text.into_bytes()
}

/// An array of points with these attributes and this content.
fn points(attributes: &str, content: &str) -> String {
    format!(
        "<DataArray type=\"Float64\" NumberOfComponents=\"3\" {attributes}>{content}</DataArray>"
    )
}

const TEXT: &str = "1 0 0 2 0.5 0";

fn input(bytes: Vec<u8>) -> Result<GraphFile<f64>, String> {
    let name = "file".to_owned();
    match read(Format::Vtu, &Source::new(name, bytes), None) {
        Ok(Input::Doubles(file)) => Ok(file),
        Ok(other) => panic!("{other:?}"),
        Err(error) => Err(error.to_string()),
    }
}

#[track_caller]
fn assert_is_read(bytes: Vec<u8>) {
    let graph = input(bytes).expect("it is right").graph;
    assert_eq!(graph.points, [[1.0, 0.0], [2.0, 0.5]]);
    assert_eq!(graph.edges, [[0, 1]]);
}

#[track_caller]
fn assert_refused(bytes: Vec<u8>, why: &str) {
    assert_eq!(input(bytes), Err(why.to_owned()));
}

/// The numbers of [`TEXT`] with a header of 32 bits.
fn bytes() -> Vec<u8> {
    let numbers = [1.0, 0.0, 0.0, 2.0, 0.5, 0.0].map(f64::to_le_bytes);
    [&48_u32.to_le_bytes()[..], numbers.as_flattened()].concat()
}

#[test]
fn what_is_no_grid_is_read_over() {
    let text = points("format=\"ascii\" RangeMin=\"0\"", TEXT);
    assert_is_read(file("", &text, ""));
    let comment = format!("<!-- <DataArray> --><?pi?>{text}<Unknown><DataArray/></Unknown>");
    assert_is_read(file("", &comment, ""));
    let key = points(
        "",
        &format!("{TEXT}<InformationKey><Value>9</Value></InformationKey> "),
    );
    assert_is_read(file("version=\"1.0\"", &key, ""));
    let marked = [
        &b"\xef\xbb\xbf<?xml version=\"1.0\"?>\n"[..],
        &file("", &text, ""),
    ]
    .concat();
    assert_is_read(marked);
}

#[test]
fn base_64_may_be_cut_and_broken_into_lines() {
    let whole = STANDARD.encode(bytes());
    assert_is_read(file("", &points("format=\"binary\"", &whole), ""));
    let (head, numbers) = (&bytes()[..4], &bytes()[4..]);
    let cut = STANDARD.encode(head) + "\n  " + &STANDARD.encode(numbers);
    assert_is_read(file("", &points("format=\"binary\"", &cut), ""));
    let lines: Vec<&str> = (0..whole.len()).map(|at| &whole[at..=at]).collect();
    assert_is_read(file(
        "",
        &points("format=\"binary\"", &lines.join("\n")),
        "",
    ));
}

#[test]
fn wrong_elements_are_named() {
    let text = points("", TEXT);
    assert_refused(Vec::new(), "file: there is no `Piece` of a `VTKFile`");
    assert_refused(
        b"<VTKFile type=\"ImageData\"/>".to_vec(),
        "file:1: the attribute `type` is `ImageData`, not `UnstructuredGrid` or `PolyData`",
    );
    assert_refused(
        file("compressor=\"vtkLZ4DataCompressor\"", &text, ""),
        "file:1: the attribute `compressor` is `vtkLZ4DataCompressor`, not `vtkZLibDataCompressor`",
    );
    assert_refused(
        file("byte_order=\"Middle\"", &text, ""),
        "file:1: the attribute `byte_order` is `Middle`, not `LittleEndian` or `BigEndian`",
    );
    assert_refused(file("", "", ""), "file: there is no array `Points`");
    assert_refused(
        file("", &text.replace("\"3\"", "\"2\""), ""),
        "file:5: a point is not three numbers that are doubles",
    );
    assert_refused(
        file("", &text.replace("\"3\"", "\"x\""), ""),
        "file:5: the attribute `NumberOfComponents` is `x`, not a whole number",
    );
    assert_refused(
        file("", &text.replace("Float64", "String"), ""),
        "file:5: `String` is not a type that is read",
    );
    assert_refused(
        file("", &points("", "1 0 0 2 zero 0"), ""),
        "file:5: `zero` is not a coordinate",
    );
    assert_refused(
        file("", &points("Name=\"P\"", "1 0 0"), ""),
        "file:5: the array `P` has 3 numbers, not 6",
    );
    assert_refused(
        file("", &text, "<Piece/>"),
        "file:14: more than one `Piece` is not read",
    );
    assert_refused(
        file("", &format!("{text}</Cells>"), ""),
        "file:5: ill-formed document: expected `</Points>`, but `</Cells>` was found",
    );
    assert_refused(
        b"<VTKFile>\n\xff".to_vec(),
        "file: the elements are not UTF-8",
    );
}

#[test]
fn wrong_cells_are_named() {
    let whole = file("", &points("", TEXT), "");
    let whole = String::from_utf8(whole).expect("text");
    let changed = |from: &str, to: &str| whole.replace(from, to).into_bytes();
    assert_refused(
        changed(">2<", ">3<"),
        "file: cell 0: its corners are not in `connectivity`",
    );
    assert_refused(
        changed(">0 1<", ">0 -1<"),
        "file: `-1` in `Cells` is not a whole number",
    );
    assert_refused(
        changed(">0 1<", ">0 2<"),
        "file: line 0 of the mesh: vertex 2 does not exist: the vertices are numbered from 0 to 1",
    );
    let name = "file".to_owned();
    let bytes = changed(">3<", ">10<");
    let source = Source::new(name, bytes);
    let result = read_result(Format::Vtu, &source, None, &GraphFile::<f64>::default());
    let error = result.expect_err("a tetrahedron").to_string();
    assert_eq!(error, "file: cell 0: cells of type 10 are no triangles");
}

/// The points as appended bytes; offsets are those of the file's arrays.
fn appended(offsets: &[usize], encoding: &str, data: &[u8]) -> Vec<u8> {
    let mut arrays = String::new();
    for offset in offsets {
        let array = points(
            &format!("Name=\"P\" format=\"appended\" offset=\"{offset}\""),
            "",
        );
        writeln!(arrays, "{array}").expect("memory takes it");
    }
    let whole = file("", arrays.trim_end(), "@");
    let at = whole
        .iter()
        .position(|&byte| byte == b'@')
        .expect("the tail");
    let head = format!("<AppendedData {encoding}>\n _");
    let (before, after) = (&whole[..at], &whole[at + 1..]);
    [before, head.as_bytes(), data, b"\n</AppendedData>\n", after].concat()
}

#[test]
fn appended_arrays_are_read_and_share_no_bytes() {
    let raw = "encoding=\"raw\"";
    assert_is_read(appended(&[0], raw, &bytes()));
    let shifted = [b"<>\xff", &bytes()[..]].concat();
    assert_is_read(appended(&[3], raw, &shifted));
    assert_is_read(appended(
        &[0],
        "encoding=\"base64\"",
        STANDARD.encode(bytes()).as_bytes(),
    ));
    assert_refused(
        appended(&[0, 0], raw, &bytes()),
        "file:5: the array `P`: another one has the offset 0, too",
    );
    assert_refused(
        appended(&[0, 9], raw, &bytes()),
        "file:5: the array `P`: there are fewer bytes than it says",
    );
    assert_refused(
        appended(&[999], raw, &bytes()),
        "file:5: the array `P`: `AppendedData` ends before the offset 999",
    );
    assert_refused(
        appended(&[0], "encoding=\"hex\"", &bytes()),
        "file:14: the attribute `encoding` is `hex`, not `base64` or `raw`",
    );
    let missing = points("Name=\"P\" format=\"appended\" offset=\"0\"", "");
    assert_refused(
        file("", &missing, ""),
        "file:5: the array `P`: there is no `AppendedData`",
    );
}

fn zlib(bytes: impl Read) -> Vec<u8> {
    let mut packed = Vec::new();
    let mut encoder = ZlibEncoder::new(bytes, Compression::default());
    encoder.read_to_end(&mut packed).expect("memory takes it");
    packed
}

/// Blocks of 20 bytes packed by zlib, with a header of this size for each but the last and for the last.
fn packed(full: u32, last: u32) -> Vec<u8> {
    let blocks: Vec<Vec<u8>> = bytes()[4..].chunks(20).map(zlib).collect();
    let size = |block: &Vec<u8>| u32::try_from(block.len()).expect("a small block");
    let sizes = blocks.iter().map(size);
    let header = [3, full, last].into_iter().chain(sizes);
    let header: Vec<u8> = header.flat_map(u32::to_le_bytes).collect();
    [header, blocks.concat()].concat()
}

#[test]
fn blocks_have_the_sizes_that_they_say() {
    let packed = |full, last| {
        let text = STANDARD.encode(packed(full, last));
        let array = points("Name=\"P\" format=\"binary\"", &text);
        file("compressor=\"vtkZLibDataCompressor\"", &array, "")
    };
    assert_is_read(packed(20, 8));
    for (full, last, says) in [
        (19, 8, 19),
        (21, 8, 21),
        (20, 7, 7),
        (20, 9, 9),
        (20, 0, 20),
    ] {
        let why = format!("a block does not have the {says} bytes that it says");
        assert_refused(packed(full, last), &format!("file:5: the array `P`: {why}"));
    }
    let text = STANDARD.encode(bytes());
    let array = points("Name=\"P\" format=\"binary\"", &text);
    assert_refused(
        file("compressor=\"vtkZLibDataCompressor\"", &array, ""),
        "file:5: the array `P`: there are fewer bytes than it says",
    );
}

/// A file of so many points and of a column, all zeros, packed in so many equal blocks each.
fn zeros(points: u64, blocks: u64) -> Source {
    let array = |size: u64| {
        let block = zlib(std::io::repeat(0).take(size / blocks));
        let sizes = (0..blocks).map(|_| block.len() as u64);
        let header = [blocks, size / blocks, 0].into_iter().chain(sizes);
        let header: Vec<u8> = header.flat_map(u64::to_le_bytes).collect();
        let count = usize::try_from(blocks).expect("a few");
        [header, block.repeat(count)].concat()
    };
    let (places, column) = (array(24 * points), array(8 * points));
    let text = format!(
        "<VTKFile type=\"UnstructuredGrid\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n\
         <UnstructuredGrid><Piece NumberOfPoints=\"{points}\" NumberOfCells=\"0\"><Cells>\n\
         <DataArray type=\"Int64\" Name=\"connectivity\"/>\n<DataArray type=\"Int64\" Name=\"offsets\"/>\n\
         <DataArray type=\"UInt8\" Name=\"types\"/>\n</Cells><Points>\n\
         <DataArray type=\"Float64\" Name=\"P\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>\n\
         </Points><PointData>\n\
         <DataArray type=\"Float64\" Name=\"depth\" format=\"appended\" offset=\"{}\"/>\n\
         </PointData></Piece></UnstructuredGrid>\n<AppendedData encoding=\"raw\">_",
        places.len()
    );
    let tail = b"</AppendedData></VTKFile>\n";
    let bytes = [text.as_bytes(), &places, &column, tail].concat();
    Source::new("file", bytes)
}

/// The error; a file that is read is not shown.
fn refused(source: &Source) -> ReadError {
    match read(Format::Vtu, source, None) {
        Err(error) => error,
        Ok(_) => panic!("it is read"),
    }
}

/// Who believes the file takes 6 GB for its points; nothing at all is unpacked of them.
#[test]
fn what_would_unpack_to_gigabytes_is_refused() {
    let source = zeros(250_000_000, 250);
    let limit = 32 * source.bytes.len() as u64;
    assert!(limit < 250 << 20, "{limit}");
    let error = refused(&source);
    assert_eq!(error.kind, ReadErrorKind::UnpackedLimit { limit });
    let what = "with its 6000000000 bytes the file would unpack to more than the limit of";
    let message = format!("file:7: the array `P`: {what} {limit} bytes");
    assert_eq!(error.to_string(), message);
}

#[test]
fn the_limit_of_what_is_unpacked_is_for_all_arrays_and_can_be_raised() {
    let points: u64 = 1 << 19;
    let all = 32 * points;
    let source = zeros(points, 4);
    assert!(read(Format::Vtu, &source, None).is_ok(), "16 MiB are");
    let lower = source.clone().unpacked_limit(all - 1);
    let error = refused(&lower);
    assert_eq!(error.kind, ReadErrorKind::UnpackedLimit { limit: all - 1 });
    let what =
        "with its 4194304 bytes the file would unpack to more than the limit of 16777215 bytes";
    assert_eq!(
        error.to_string(),
        format!("file:9: the array `depth`: {what}")
    );

    let source = zeros(points + 4, 4);
    let limit = all;
    assert_eq!(
        refused(&source).kind,
        ReadErrorKind::UnpackedLimit { limit }
    );
    let raised = source.unpacked_limit(all + 4 * 32);
    let Ok(Input::Doubles(file)) = read(Format::Vtu, &raised, None) else {
        panic!("it has as many bytes as it may have")
    };
    assert_eq!(file.graph.points.len() as u64, points + 4);
    assert_eq!(file.columns[0].name, "depth");
}

/// A file of five points, with these sections of cells and counts of them.
fn poly_data(counts: &str, sections: &str) -> Vec<u8> {
    let text = format!(
        "<VTKFile type=\"PolyData\"><PolyData>\n<Piece NumberOfPoints=\"5\" {counts}>\n\
         <PointData>\n<DataArray type=\"Float64\" Name=\"rain\">1 2 3 4 nan</DataArray>\n</PointData>\n<Points>\n\
         <DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 7 2 0 7 2 2 7 0 2 7 1 1 8</DataArray>\n\
         </Points>\n{sections}</Piece></PolyData></VTKFile>\n"
    );
    text.into_bytes()
}

fn section(name: &str, corners: &str, ends: &str) -> String {
    format!(
        "<{name}>\n<DataArray type=\"Int64\" Name=\"connectivity\">{corners}</DataArray>\n\
         <DataArray type=\"Int32\" Name=\"offsets\">{ends}</DataArray>\n</{name}>\n"
    )
}

/// Triangles of the file.
fn triangles(bytes: Vec<u8>) -> Result<Vec<[usize; 3]>, String> {
    let file = input(poly_data("", "")).expect("points");
    let source = Source::new("file", bytes);
    let result = read_result(Format::Vtp, &source, None, &file);
    result
        .map(|result| result.list)
        .map_err(|error| error.to_string())
}

#[test]
fn lines_polygons_and_strips_of_poly_data_are_read() {
    let counts = "NumberOfVerts=\"1\" NumberOfLines=\"2\" NumberOfStrips=\"1\" NumberOfPolys=\"2\"";
    let verts = section("Verts", "0 1 2", "3");
    let lines = section("Lines", "0 1 2 3 0", "3 5");
    let polys = section("Polys", "0 1 4 1 2 4", "3 6");
    let strips = section("Strips", "4 3 0", "3");
    let all = [verts, lines.clone(), polys.clone(), strips].concat();
    let file = input(poly_data(counts, &all)).expect("it is right");
    assert_eq!(file.graph.edges, [[0, 1], [1, 2], [3, 0]]);
    assert_eq!(file.graph.points[4..5], [[1.0, 1.0]]);
    assert_eq!(file.columns[0].values, [7.0, 7.0, 7.0, 7.0, 8.0]);
    assert_eq!(
        (file.columns[1].name.as_str(), file.columns[1].missing()),
        ("rain", 1)
    );
    let expected = vec![[4, 3, 0], [0, 1, 4], [1, 2, 4]];
    assert_eq!(triangles(poly_data(counts, &all)), Ok(expected));
    // The data of cells are in the order of points, lines, strips and polygons.
    let data =
        "<CellData><DataArray type=\"Int32\" Name=\"marker\">9 5 6 7 8 8</DataArray></CellData>\n";
    let marked = input(poly_data(counts, &format!("{all}{data}"))).expect("it is right");
    assert_eq!(marked.edge_markers, [5, 5, 6]);
    // Sections without cells may be there, empty, or not.
    let none = "NumberOfLines=\"0\"";
    let empty = "<Lines/>".to_owned() + &section("Polys", "", "");
    for (counts, sections) in [("", ""), (none, ""), (none, &empty)] {
        assert_eq!(
            input(poly_data(counts, sections)).map(|file| file.graph.edges),
            Ok(vec![])
        );
        assert_eq!(triangles(poly_data(counts, sections)), Ok(vec![]));
    }
    // The cells of the other kind of file mean nothing.
    let cells = section("Cells", "0 1", "2");
    assert_eq!(
        input(poly_data("NumberOfCells=\"1\"", &cells)).map(|file| file.graph.edges),
        Ok(vec![])
    );
    let refused = |counts: &str, sections: &str, why: &str| {
        assert_eq!(triangles(poly_data(counts, sections)), Err(why.to_owned()));
    };
    refused(
        "NumberOfPolys=\"1\"",
        "",
        "file: there is no array `connectivity`",
    );
    refused(
        "",
        &lines,
        "file:11: the array `offsets` has 2 numbers, not 0",
    );
    refused(
        "NumberOfPolys=\"many\"",
        "",
        "file:2: the attribute `NumberOfPolys` is `many`, not a whole number",
    );
    refused(
        "NumberOfPolys=\"2\"",
        &section("Polys", "0 1 4 1 2", "3 6"),
        "file: cell 1: its corners are not in `connectivity`",
    );
    let quad = section("Polys", "0 1 2 3", "4");
    let error = triangles(poly_data(
        "NumberOfLines=\"2\" NumberOfPolys=\"1\"",
        &(lines + &quad),
    ));
    let error = error.expect_err("no triangle");
    assert!(
        error.starts_with("file: cell 2: the face has 4 corners"),
        "{error}"
    );
}

/// Polygons as the specification has them, by what VTK writes itself.
#[test]
fn poly_data_is_written_by_the_book() {
    let mut file = input(poly_data("", "")).expect("points");
    file.graph.edges = vec![[0, 4]];
    let mut text = Vec::new();
    write_graph(Format::Vtp, &file, &mut text).expect("memory takes it");
    let text = String::from_utf8(text).expect("a text");
    assert!(text.contains(
        "<PolyData>\n<Piece NumberOfPoints=\"5\" NumberOfVerts=\"0\" NumberOfLines=\"1\" NumberOfStrips=\"0\" \
         NumberOfPolys=\"0\">\n<PointData>"
    ));
    let lines = "<Lines>\n<DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">\n\
                 0 4\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" NumberOfComponents=\"1\" \
                 format=\"ascii\">\n2\n</DataArray>\n</Lines>\n<Polys>";
    assert!(text.contains(lines), "{text}");
    assert_eq!(input(text.into_bytes()), Ok(file));
}
