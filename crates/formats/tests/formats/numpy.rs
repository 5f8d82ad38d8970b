//! Arrays of NumPy: of all types that are read, in both orders, by rows and by columns; in archives, packed or not; and
//! what is refused. The bytes are made here, as the specifications of `.npy` and of ZIP have them.

use std::io::Read;

use flate2::read::DeflateEncoder;
use flate2::{Compression, Crc};
use sweep_cdt::{Pslg, Region};
use sweep_cdt_formats::{
    Column, Format, GraphFile, Input, ReadErrorKind, Source, read, read_result, write, write_graph,
};
use sweep_cdt_testing::Random;

fn npy(version: u8, descr: &str, is_by_columns: bool, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let order = if is_by_columns { "True" } else { "False" };
    let header = format!("{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let length = u32::try_from(header.len()).expect("short");
    let mut file = [b"\x93NUMPY", &[version, 0][..]].concat();
    file.extend(&length.to_le_bytes()[..if version == 1 { 2 } else { 4 }]);
    file.extend(header.as_bytes());
    file.extend(numbers);
    file
}

/// A matrix of doubles, or of what `descr` says.
fn matrix(descr: &str, rows: &[&[f64]], is_by_columns: bool) -> Vec<u8> {
    let columns = rows.first().map_or(2, |row| row.len());
    let mut numbers = Vec::new();
    let mut put = |value: f64| numbers.extend(bytes(descr, value));
    if is_by_columns {
        (0..columns).for_each(|column| rows.iter().for_each(|row| put(row[column])));
    } else {
        rows.iter().flat_map(|row| row.iter()).for_each(|&x| put(x));
    }
    let shape = format!("({}, {columns})", rows.len());
    npy(1, &format!("'{descr}'"), is_by_columns, &shape, &numbers)
}

/// The bytes of a number.
#[expect(clippy::cast_possible_truncation, reason = "small numbers are meant")]
fn bytes(descr: &str, x: f64) -> Vec<u8> {
    let (order, kind) = descr.split_at(1);
    let whole = x as i64;
    let mut bytes = match kind {
        "f8" => x.to_le_bytes().to_vec(),
        "f4" => (x as f32).to_le_bytes().to_vec(),
        _ => {
            let size: usize = kind[1..].parse().expect("a size");
            whole.to_le_bytes()[..size].to_vec()
        }
    };
    if order == ">" {
        bytes.reverse();
    }
    bytes
}

/// A member of an archive: its name, whether it is packed, and what it is.
type Member<'a> = (&'a str, bool, &'a [u8]);

/// An archive; `lie` is added to each size that is unpacked.
fn zip(members: &[Member<'_>], lie: u32) -> Vec<u8> {
    let size = |bytes: &[u8]| u32::try_from(bytes.len()).expect("short");
    let (mut file, mut directory) = (Vec::new(), Vec::new());
    for &(name, is_packed, contents) in members {
        let mut sum = Crc::new();
        sum.update(contents);
        let mut data = Vec::new();
        if is_packed {
            let mut encoder = DeflateEncoder::new(contents, Compression::default());
            encoder.read_to_end(&mut data).expect("memory takes it");
        } else {
            data.extend_from_slice(contents);
        }
        let mut common = vec![20, 0, 0, 0, if is_packed { 8 } else { 0 }, 0, 0, 0, 0, 0];
        for number in [
            sum.sum(),
            size(&data),
            size(contents) + lie,
            size(name.as_bytes()),
        ] {
            common.extend(number.to_le_bytes());
        }
        directory.extend([b"PK\x01\x02\x14\x00", common.as_slice(), &[0; 10]].concat());
        directory.extend(size(&file).to_le_bytes());
        directory.extend(name.as_bytes());
        file.extend([b"PK\x03\x04", common.as_slice(), name.as_bytes(), &data].concat());
    }
    let count = u16::try_from(members.len()).expect("few").to_le_bytes();
    let mut end = [b"PK\x05\x06\0\0\0\0".as_slice(), &count, &count].concat();
    end.extend(size(&directory).to_le_bytes());
    end.extend(size(&file).to_le_bytes());
    [file, directory, end, vec![0; 2]].concat()
}

fn input(format: Format, bytes: &[u8]) -> Result<GraphFile<f64>, String> {
    match read(format, &Source::new("file", bytes), None) {
        Ok(Input::Doubles(file)) => Ok(file),
        Ok(other) => panic!("{other:?}"),
        Err(error) => Err(error.to_string()),
    }
}

fn square() -> GraphFile<f64> {
    let points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    Pslg {
        points,
        ..Pslg::default()
    }
    .into()
}

fn triangles(format: Format, bytes: &[u8]) -> Result<Vec<[usize; 3]>, String> {
    let result = read_result(format, &Source::new("file", bytes), None, &square());
    result
        .map(|result| result.list)
        .map_err(|error| error.to_string())
}

const TYPES: [&str; 19] = [
    "<f8", ">f8", "<f4", ">f4", "|i1", "|u1", "<i2", ">i2", "<u2", ">u2", "<i4", ">i4", "<u4",
    ">u4", "<i8", ">i8", "<u8", ">u8", "=f8",
];

#[test]
fn all_types_and_orders_are_read() {
    let rows: [&[f64]; 3] = [
        &[1.0, 2.0, 7.0, 0.0],
        &[3.0, 4.0, 8.0, 5.0],
        &[0.0, 6.0, 9.0, 1.0],
    ];
    for descr in TYPES {
        for is_by_columns in [false, true] {
            let file = input(Format::Npy, &matrix(descr, &rows, is_by_columns));
            let file = file.expect(descr);
            assert_eq!(
                file.graph.points,
                [[1.0, 2.0], [3.0, 4.0], [0.0, 6.0]],
                "{descr}"
            );
            let column = |name: &str, values: [f64; 3]| Column {
                name: name.to_owned(),
                values: values.to_vec(),
            };
            let others = [
                column("z", [7.0, 8.0, 9.0]),
                column("column4", [0.0, 5.0, 1.0]),
            ];
            assert_eq!(file.columns, others, "{descr}");
            let corners: [&[f64]; 2] = [&[0.0, 1.0, 2.0], &[0.0, 2.0, 3.0]];
            let result = matrix(descr, &corners, is_by_columns);
            let expected = vec![[0, 1, 2], [0, 2, 3]];
            assert_eq!(triangles(Format::Npy, &result), Ok(expected), "{descr}");
        }
    }
    // Of single precision, and missing.
    let rows: [&[f64]; 2] = [&[-0.5, 0.25, f64::NAN], &[f64::from(0.1_f32), 1e30, 0.0]];
    let file = input(Format::Npy, &matrix("<f8", &rows, true)).expect("doubles");
    assert_eq!(
        file.graph.points,
        [[-0.5, 0.25], [f64::from(0.1_f32), 1e30]]
    );
    assert_eq!(file.columns[0].values[1].to_bits(), 0);
    assert!(file.columns[0].values[0].is_nan());
}

#[test]
fn all_versions_and_shapes_are_read() {
    let numbers: Vec<u8> = [0.0, 0.0, 1.0, 0.5]
        .iter()
        .flat_map(|&x| bytes("<f8", x))
        .collect();
    for version in [1, 2, 3] {
        for shape in ["(2, 2)", "(2L, 2L)", "(2,2,)"] {
            let file = npy(version, "'<f8'", false, shape, &numbers);
            let graph = input(Format::Npy, &file).expect(shape).graph;
            assert_eq!(graph.points, [[0.0, 0.0], [1.0, 0.5]]);
        }
    }
    for shape in ["(0, 2)", "(0,)", "(0, 3)", "(0, 1000000000000)"] {
        let file = npy(1, "'<f8'", false, shape, b"");
        assert_eq!(
            input(Format::Npy, &file).expect(shape).graph.points.len(),
            0
        );
        assert_eq!(triangles(Format::Npy, &file), Ok(vec![]), "{shape}");
    }
    // As mapbox_earcut returns them.
    let list = [0.0, 1.0, 2.0, 0.0, 2.0, 3.0]
        .iter()
        .flat_map(|&x| bytes("<u4", x));
    let list = npy(1, "'<u4'", false, "(6,)", &list.collect::<Vec<u8>>());
    assert_eq!(
        triangles(Format::Npy, &list),
        Ok(vec![[0, 1, 2], [0, 2, 3]])
    );
}

#[test]
fn what_is_no_such_array_is_refused() {
    let good = matrix("<f8", &[&[0.0, 1.0]], false);
    let one = bytes("<f8", 1.0);
    let wrong = |version, descr: &str, shape: &str, numbers: &[u8], why: &str| {
        let file = npy(version, descr, false, shape, numbers);
        let found = input(Format::Npy, &file).expect_err(why);
        assert_eq!(found, format!("file: {why}"));
    };
    wrong(
        4,
        "'<f8'",
        "(1, 2)",
        &one,
        "the version of `.npy` is 4, and only 1 to 3 are read",
    );
    wrong(
        1,
        "[('x', '<f8'), ('y', '<f8')]",
        "(1,)",
        &one,
        "the array has fields, which are not read: make numbers of it by \
         numpy.lib.recfunctions.structured_to_unstructured",
    );
    for descr in [
        "<c16", "|b1", "<f2", "<f16", "|O", "<U8", "<M8[ns]", "", "é",
    ] {
        let why = format!(
            "the numbers are of the type `{descr}`, which is not read: make doubles of them by .astype(float)"
        );
        wrong(1, &format!("'{descr}'"), "(1, 2)", &one, &why);
    }
    let why = "the file ends in the array, whose shape is (2, 2)";
    wrong(1, "'<f8'", "(2, 2)", &one, why);
    let why = "the file ends in the array, whose shape is (4611686018427387904, 4)";
    wrong(1, "'<f8'", "(4611686018427387904, 4)", &one, why);
    wrong(
        1,
        "'|u1'",
        "(1, 2)",
        &one,
        "6 bytes follow behind the array, and only one array is read",
    );
    wrong(1, "'<f8'", "(-1, 2)", &one, "the shape is `(-1, 2)`");
    wrong(
        1,
        "'<f8'",
        "5",
        &one,
        "the header of the array has a `shape` that is no tuple",
    );
    for (shape, numbers) in [
        ("(1,)", &one[..]),
        ("(1, 1)", &one),
        ("(1, 2, 1)", &one.repeat(2)),
        ("()", &one),
    ] {
        let why = format!(
            "the array `points`: the shape is {shape}, and (n, 2), or (n, 3) with z is read"
        );
        wrong(1, "'<f8'", shape, numbers, &why);
    }
    for bytes in [&b""[..], b"1 2\n", b"\x93NUMP"] {
        let why = "file: it does not begin as an array of NumPy does (`.npy`)";
        assert_eq!(input(Format::Npy, bytes), Err(why.to_owned()));
    }
    for end in 6..good.len() {
        assert!(input(Format::Npy, &good[..end]).is_err(), "{end}");
    }
    let large = "the array `points`: a whole number is 2^53 or more, which is no double";
    let number = (1_i64 << 53).to_le_bytes();
    wrong(1, "'<i8'", "(1, 2)", &number.repeat(2), large);
    wrong(1, "'<u8'", "(1, 2)", &[255; 16], large);
    let archive = zip(&[("points.npy", false, &good)], 0);
    let why = "file: it is an archive of arrays: call it .npz";
    assert_eq!(input(Format::Npy, &archive), Err(why.to_owned()));
    let result = |array: &[u8]| triangles(Format::Npy, array).expect_err("no triangles");
    assert_eq!(
        result(&matrix("<i4", &[&[0.0, 1.0, 2.0, 3.0]], false)),
        "file: the array `triangles`: the shape is (1, 4), and (t, 3) is read"
    );
    assert_eq!(
        result(&matrix("<f8", &[&[0.0, 1.0, 2.5]], false)),
        "file: the array `triangles`: 2.5 in row 0 is not a vertex's number"
    );
    assert_eq!(
        result(&matrix("<i4", &[&[0.0, 1.0, -1.0]], false)),
        "file: the array `triangles`: -1 in row 0 is not a vertex's number"
    );
}

#[test]
fn archives_are_read_by_names() {
    let points = matrix(
        "<f8",
        &[&[0.0, 0.0], &[1.0, 0.0], &[1.0, 1.0], &[0.0, 1.0]],
        false,
    );
    let edges = matrix("<i4", &[&[0.0, 2.0]], false);
    let faces = matrix("<i8", &[&[0.0, 1.0, 2.0], &[0.0, 2.0, 3.0]], true);
    let holes = matrix("<f8", &[&[0.5, 0.25]], false);
    let regions = matrix("<f8", &[&[0.5, 0.75, 3.0, -1.0]], false);
    for is_packed in [false, true] {
        for names in [
            ["points", "edges", "triangles"],
            ["vertices", "segments", "simplices"],
        ] {
            let [p, e, t] = names.map(|name| format!("{name}.npy"));
            let members: [Member<'_>; 6] = [
                ("readme.txt", false, b"no array"),
                (&t, is_packed, &faces),
                (&p, is_packed, &points),
                ("holes.npy", false, &holes),
                (&e, is_packed, &edges),
                ("regions.npy", is_packed, &regions),
            ];
            let archive = zip(&members, 0);
            let graph = input(Format::Npz, &archive).expect("an archive").graph;
            assert_eq!(graph.points, square().graph.points);
            assert_eq!(graph.edges, [[0, 2]]);
            assert_eq!(graph.holes, [[0.5, 0.25]]);
            let region = Region {
                seed: [0.5, 0.75],
                attribute: 3.0,
            };
            assert_eq!(graph.regions, [region]);
            let expected = vec![[0, 1, 2], [0, 2, 3]];
            assert_eq!(triangles(Format::Npz, &archive), Ok(expected.clone()));
            let alone = zip(&[("faces.npy", is_packed, &faces)], 0);
            assert_eq!(triangles(Format::Npz, &alone), Ok(expected));
        }
    }
    let refused = |members: &[Member<'_>], lie, why: &str| {
        let found = input(Format::Npz, &zip(members, lie)).expect_err(why);
        assert_eq!(found, format!("file: {why}"));
    };
    refused(
        &[("arr_0.npy", false, &points), ("arr_1.npy", false, &edges)],
        0,
        "there is no array `points`, `edges` or `triangles`, only `arr_0.npy`, `arr_1.npy`: name them, as in \
         numpy.savez(file, points=a, edges=b)",
    );
    refused(
        &[("edges.npy", false, &edges)],
        0,
        "there is no array `points`, and the names of others say nothing of points",
    );
    refused(
        &[
            ("points.npy", false, &points),
            ("vertices.npy", true, &points),
        ],
        0,
        "both `points` and `vertices` are there, which mean the same",
    );
    refused(
        &[("points.npy", false, &holes), ("edges.npy", false, &edges)],
        0,
        "line 0 of the mesh: vertex 2 does not exist: the vertices are numbered from 0 to 0",
    );
    refused(
        &[("points.npy", true, b"1 2")],
        0,
        "the array `points`: it does not begin as an array of NumPy does (`.npy`)",
    );
    refused(
        &[
            ("points.npy", false, &points),
            ("regions.npy", false, &holes),
        ],
        0,
        "the array `regions`: the shape is (1, 2), and (r, 3) is read",
    );
    let size = points.len() + 1;
    refused(
        &[("points.npy", true, &points)],
        1,
        &format!(
            "the archive is not read: `points`: Invalid size: expected {size}, got {}",
            size - 1
        ),
    );
    let mut damaged = zip(&[("points.npy", false, &points)], 0);
    let at = damaged
        .iter()
        .position(|&byte| byte == 0x3f)
        .expect("a one");
    damaged[at] ^= 1;
    let found = input(Format::Npz, &damaged).expect_err("a sum is wrong");
    assert!(
        found.starts_with("file: the archive is not read: `points`: Invalid checksum"),
        "{found}"
    );
    assert!(input(Format::Npz, b"PK").is_err());
}

/// A thousand bytes that say they unpack to a million.
#[test]
fn what_an_archive_unpacks_to_has_a_limit() {
    let rows = vec![&[0.0, 0.0][..]; 70_000];
    let archive = zip(&[("points.npy", true, &matrix("<f8", &rows, false))], 0);
    let source = Source::new("file", archive);
    assert!(source.bytes.len() < 10_000);
    let read = |limit| read(Format::Npz, &source.clone().unpacked_limit(limit), None);
    let error = read(1_000_000).expect_err("more than the limit");
    assert_eq!(
        error.kind,
        ReadErrorKind::UnpackedLimit { limit: 1_000_000 }
    );
    assert!(
        error
            .to_string()
            .starts_with("file: the array `points`: with its 1120")
    );
    assert!(read(1_200_000).is_ok());
}

/// What is written is what the specification says, and is read again.
#[test]
fn arrays_are_written_by_the_book() {
    let mut file = square();
    file.graph.edges = vec![[0, 2]];
    file.columns.push(Column {
        name: "rain".to_owned(),
        values: vec![1.0, 2.0, 3.0, f64::NAN],
    });
    let mut written = Vec::new();
    write_graph(Format::Npy, &file, &mut written).expect("memory takes it");
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (4, 4), }";
    let head = [
        b"\x93NUMPY\x01\0\x76\0",
        format!("{header:<117}\n").as_bytes(),
    ]
    .concat();
    assert_eq!(written[..128], head);
    let row: Vec<u8> = [1.0, 0.0, f64::NAN, 2.0]
        .iter()
        .flat_map(|&x| bytes("<f8", x))
        .collect();
    assert_eq!(written[128 + 32..128 + 64], row);
    let again = input(Format::Npy, &written).expect("an array");
    assert_eq!(again.graph.points, file.graph.points);
    let rain = Column {
        name: "column4".to_owned(),
        ..file.columns[0].clone()
    };
    assert_eq!(again.columns, [rain]);

    file.graph.holes.push([0.5, 0.25]);
    file.graph.regions.push(Region {
        seed: [0.5, 0.75],
        attribute: 2.0,
    });
    let mut archive = Vec::new();
    write_graph(Format::Npz, &file, &mut archive).expect("memory takes it");
    let again = input(Format::Npz, &archive).expect("an archive");
    assert_eq!(again.graph, file.graph);
    let result =
        sweep_cdt::triangulate(&file.graph.points, &file.graph.edges).expect("no crossing");
    for (output, format) in [(Format::Npy, Format::Npy), (Format::Npz, Format::Npz)] {
        let mut written = Vec::new();
        write(output, &file, &result, &mut written).expect("memory takes it");
        assert_eq!(
            triangles(format, &written),
            Ok(result.canonical_triangles())
        );
    }
}

/// Points on a line have no triangles, and a file that says so.
#[test]
fn a_result_without_triangles_is_one() {
    let graph = Pslg {
        points: vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]],
        ..Pslg::default()
    };
    let file = GraphFile::from(graph);
    let result = sweep_cdt::triangulate(&file.graph.points, &[]).expect("no edges");
    for (output, format) in [(Format::Npy, Format::Npy), (Format::Npz, Format::Npz)] {
        let mut written = Vec::new();
        write(output, &file, &result, &mut written).expect("memory takes it");
        let again = read_result(format, &Source::new("file", written), None, &file);
        assert_eq!(again.expect("a result").list, Vec::<[usize; 3]>::new());
    }
}

#[test]
fn damaged_archives_are_refused_or_read_but_nothing_else() {
    let points = matrix(
        ">f4",
        &[&[0.0, 0.0, 1.0], &[1.0, 0.0, 1.0], &[1.0, 1.0, 1.0]],
        true,
    );
    let edges = matrix("<i2", &[&[0.0, 2.0]], false);
    let mut dice = Random::new(8);
    for is_packed in [false, true] {
        let whole = zip(
            &[
                ("points.npy", is_packed, &points),
                ("edges.npy", is_packed, &edges),
            ],
            0,
        );
        assert!(input(Format::Npz, &whole).is_ok());
        let mut refused = 0;
        for _ in 0..20_000 {
            let mut damaged = whole.clone();
            for _ in 0..=dice.below(3) {
                let at = dice.below(damaged.len());
                let few = [0, 1, 2, 8, 0x7f, 0xff, b'(', b'9'];
                damaged[at] = few[dice.below(few.len())];
            }
            damaged.truncate(damaged.len() - dice.below(3) / 2 * dice.below(damaged.len()));
            refused += usize::from(input(Format::Npz, &damaged).is_err());
            drop(triangles(Format::Npz, &damaged));
        }
        assert!((1000..20_000).contains(&refused), "{refused}");
    }
    for whole in [points, edges] {
        for at in 0..whole.len() {
            for byte in 0..=255 {
                let mut damaged = whole.clone();
                damaged[at] = byte;
                drop(input(Format::Npy, &damaged));
                drop(triangles(Format::Npy, &damaged));
            }
        }
    }
}
