//! Formats: what files of odd but correct content mean.

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::{Error, Pslg};
use sweep_cdt_formats::{
    self as formats, Coordinate, CoordinateError, Format, GraphFile, Input, MAX_DIGITS, Matched,
    Numbering, Source, Triangles, read_result, write_node,
};
use sweep_cdt_testing::Random;

fn source(text: &str) -> Source {
    Source::new("file", text.as_bytes().to_vec())
}

/// The input has two points at the origin, and one more.
fn input() -> GraphFile<f64> {
    let graph = Pslg {
        points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 1.0]],
        ..Pslg::default()
    };
    graph.into()
}

fn read(format: Format, text: &str) -> Result<Triangles, String> {
    read_result(format, &source(text), None, &input()).map_err(|error| error.to_string())
}

#[test]
fn of_equal_vertices_the_first_is_matched() {
    let triangles = read(Format::Obj, "v 1 0 0\nv 0 1 0\nv 0 0 0\nf 3 1 2\n");
    let triangles = triangles.expect("a result");
    assert_eq!(triangles.matched, Matched::Equal);
    assert_eq!(triangles.list, [[0, 1, 3]]);
}

#[test]
fn a_vertex_counted_back_beyond_the_first_is_refused() {
    let text = |back: &str| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 {back}\n");
    assert!(read(Format::Obj, &text("-3")).is_ok());
    for back in ["-4", "-5", "-0"] {
        let error = read(Format::Obj, &text(back)).expect_err("no vertex");
        assert_eq!(error, format!("file:4: `{back}` is not a vertex's number"));
    }
}

#[test]
fn corners_in_one_list_come_in_threes() {
    let flat = |list: &str| read(Format::Json, &format!("{{\"triangles\": [{list}]}}"));
    assert_eq!(flat("0, 1, 3").expect("a triangle").list, [[0, 1, 3]]);
    assert!(flat("0, 1, 3, 2").is_err());
}

#[test]
fn without_a_node_vertices_are_numbered_as_triangles_are() {
    let corners = |text| read(Format::Ele, text).expect("a triangle").list;
    assert_eq!(corners("1 3 0\n0 0 1 3\n"), [[0, 1, 3]]);
    assert_eq!(corners("1 3 0\n1 1 2 4\n"), [[0, 1, 3]]);
}

#[test]
fn errors_have_the_numbers_of_the_file() {
    let numbering = Numbering {
        vertex: 1,
        ..Numbering::default()
    };
    let file = GraphFile {
        numbering,
        ..input()
    };
    let number = |error| file.as_numbered(error).to_string();
    let [own, file] = [(7, 4), (7, 5)].map(|(edge, vertex)| Error::EdgeOutOfRange { edge, vertex });
    assert_eq!(number(own), file.to_string());
    let [own, file] = [4, 5].map(|vertex| Error::NonFiniteCoordinate { vertex });
    assert_eq!(number(own), file.to_string());
}

#[test]
fn whole_numbers_beyond_doubles_stay_rationals() {
    let number = BigRational::from(BigInt::from((1_i64 << 53) + 1));
    assert_eq!(number.text(), "9007199254740993/1");
    assert_eq!(BigRational::from_text(&number.text()), Ok(number));
}

#[test]
fn numbers_of_too_many_digits_are_refused() {
    for before in ["1/", "", "0."] {
        let number = |digits| {
            let denominator = usize::from(before == "0.");
            BigRational::from_text(&format!("{before}{}", "3".repeat(digits - denominator)))
        };
        assert!(number(MAX_DIGITS).is_ok(), "{before}");
        let longer = number(MAX_DIGITS + 1);
        assert_eq!(longer, Err(CoordinateError::TooLong), "{before}");
    }
}

/// An exponent of few characters stands for a number of many digits, so it has a lower limit: all are doubles' own.
#[test]
fn exponents_of_exact_numbers_are_limited() {
    for number in [
        "1e400",
        "1E-400",
        "-2.5e+400",
        "4.9406564584124654e-324",
        "0e400",
    ] {
        assert!(BigRational::from_text(number).is_ok(), "{number}");
    }
    for number in [
        "1e401",
        "1e-401",
        "0e401",
        "-1E+2147483647",
        "1e-2147483648",
        "1e99999999999",
    ] {
        let error = BigRational::from_text(number);
        assert_eq!(error, Err(CoordinateError::ExponentTooLarge), "{number}");
    }
    let bytes = b"2 2\n1 1/3 0\n2 0 7e-9999\n".to_vec();
    let source = Source::new("a.node", bytes);
    let error = formats::read(Format::Node, &source, None).expect_err("too many zeros");
    let why = "`7e-9999` has an exponent beyond 400, the limit where numbers are read exactly";
    assert_eq!(error.to_string(), format!("a.node:3: {why}"));
}

#[test]
fn doubles_are_written_as_the_standard_library_writes_them() {
    let mut random = Random::new(1);
    let check = |value: f64| {
        let text = format!("{value:?}");
        assert_eq!(value.text(), text.strip_suffix(".0").unwrap_or(&text));
    };
    for value in [
        0.0,
        -0.0,
        5e-324,
        1e-5,
        9.99e-5,
        1e-4,
        9e15,
        1e16,
        1e23,
        f64::MAX,
    ] {
        check(value);
        check(-value);
    }
    for _ in 0..100_000 {
        let bits = random.bits();
        check(f64::from_bits(bits));
        // Any number of digits before and behind the point; many of them are halfway between two texts.
        let shift = i32::try_from(random.below(70)).expect("small");
        check((bits >> random.below(64)) as f64 / 2_f64.powi(shift));
        check(random.unit() * 10_f64.powi(shift / 4 - 6));
    }
}

/// Large and small ones, from their beginning and from a place within.
#[test]
fn a_file_is_read_from_where_it_stands() {
    let mut random = Random::new(3);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("file");
    let large = 5 << 20;
    for (length, start) in [
        (0, 0),
        (10, 3),
        (large, 0),
        (large + 1, 0),
        (large, 1 << 20),
        (large, large - 1),
    ] {
        let bytes: Vec<u8> = (0..length)
            .map(|_| random.bits().to_le_bytes()[0])
            .collect();
        std::fs::write(&path, &bytes).expect("a file");
        let mut file = File::open(&path).expect("the file");
        file.seek(SeekFrom::Start(start as u64)).expect("a place");
        let source = Source::of_file("name", &mut file).expect("its contents");
        assert!(
            source.bytes == bytes[start..],
            "{length} bytes from {start}"
        );
        assert_eq!(source.name, "name");
        let place = file.stream_position().expect("a place");
        assert_eq!(place, length as u64);
    }
}

/// While another thread makes the file longer or shorter: what is read has no gap, and nothing is lost that stays.
#[test]
fn a_file_that_changes_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("file");
    let bytes: Vec<u8> = (0..12_u32 << 18).flat_map(u32::to_le_bytes).collect();
    let middle = bytes.len() / 2;
    for round in 0..30 {
        let is_longer = round % 2 == 0;
        let given = if is_longer { middle } else { bytes.len() };
        std::fs::write(&path, &bytes[..given]).expect("a file");
        let mut file = File::open(&path).expect("the file");
        let source = std::thread::scope(|scope| {
            scope.spawn(|| {
                let changed = File::options().append(true).open(&path);
                let mut changed = changed.expect("the file");
                if is_longer {
                    changed.write_all(&bytes[middle..]).expect("room");
                } else {
                    changed.set_len(middle as u64).expect("a shorter file");
                }
            });
            Source::of_file("name", &mut file).expect("its contents")
        });
        assert!(source.bytes.len() >= middle, "{round}");
        assert!(bytes.starts_with(&source.bytes), "{round}");
    }
}

/// A number that ends a line: the most digits that are read without a look at the token, the largest, and too many.
#[test]
fn numbers_of_many_digits_end_a_line() {
    let read = |count: &str| {
        let text = format!("{count}\n0 0 0\n");
        let read = formats::read(Format::Node, &source(&text), None);
        read.expect_err("other counts").to_string()
    };
    for count in ["9999999999999999999", "18446744073709551615"] {
        let missing = format!("file:2: the file ends where vertex 2 of {count} should follow");
        assert_eq!(read(count), missing);
    }
    let large = "99999999999999999999";
    assert_eq!(
        read(large),
        format!("file:1: `{large}` is not a number of vertices")
    );
}

/// As many attributes as a number can say, and a marker more.
#[test]
fn attributes_and_a_marker_without_end() {
    let text = format!("1 2 {} 1\n0 0.5 0.25 7\n", usize::MAX);
    let error = formats::read(Format::Node, &source(&text), None).expect_err("one attribute");
    assert_eq!(
        error.to_string(),
        "file:2: the line ends where an attribute should follow"
    );
}

/// The lines of a `.poly` of so many points on a line, each joined to the next, with comments, blank lines and
/// all ends of lines in between.
fn long(points: usize) -> Vec<String> {
    let mut lines = vec![format!("{points} 2 # points\r\n")];
    for v in 0..points {
        lines.push(match v % 7 {
            3 => format!("  {} {v} 0.5 # \r", v + 1),
            5 => format!("\n# {v}\r\n\t{} {v} 0.5\r\n", v + 1),
            _ => format!("{} {v} 0.5 7\n", v + 1),
        });
    }
    lines.push(format!("{}\n", points - 1));
    lines.extend((1..points).map(|v| format!("{v} {v} {}\n", v + 1)));
    lines
}

#[test]
fn long_files_are_read_like_short_ones() {
    const POINTS: usize = 60_000;
    let lines = long(POINTS);
    let read = |lines: &[String]| formats::read(Format::Poly, &source(&lines.concat()), None);
    let Ok(Input::Doubles(file)) = read(&lines) else {
        panic!("a file without faults");
    };
    assert_eq!(
        file.graph.points,
        (0..POINTS).map(|v| [v as f64, 0.5]).collect::<Vec<_>>()
    );
    assert_eq!(
        file.graph.edges,
        (1..POINTS).map(|v| [v - 1, v]).collect::<Vec<_>>()
    );
    assert_eq!((file.numbering.vertex, file.numbering.edge), (1, 1));

    // Of two faults the first one is reported, in its line.
    let line_of = |at: usize| {
        let before = lines[..at].concat().replace("\r\n", "\n");
        1 + before.matches(['\r', '\n']).count()
    };
    for (at, fault, message) in [
        (50_001, "50001 x 0.5\n", "`x` is not a coordinate"),
        (
            50_001,
            "50001 0\n",
            "the line ends where a y coordinate should follow",
        ),
        (50_001, "50000 0 0\n", "the number is 50000, not 50001"),
        (
            110_000,
            "49999 0 1\n",
            "vertex 0 does not exist: the vertices are numbered from 1 to 60000",
        ),
    ] {
        let mut lines = lines.clone();
        lines[at] = fault.to_owned();
        let last = lines.len() - 1;
        lines[last] = "no number\n".to_owned();
        let error = read(&lines).expect_err("a fault").to_string();
        let last_error = format!("file:{}: `no` is not an edge's number", line_of(last));
        // Coordinates are converted when all lines are read.
        let expected = match message {
            "`x` is not a coordinate" => last_error,
            _ => format!("file:{}: {message}", line_of(at)),
        };
        assert_eq!(error, expected);
        lines.pop();
        let error = read(&lines).expect_err("an edge less").to_string();
        let missing = match message {
            "`x` is not a coordinate" => {
                format!(
                    "file:{}: the file ends where edge 59999 of 59999 should follow",
                    line_of(last) - 1
                )
            }
            _ => expected,
        };
        assert_eq!(error, missing);
    }
}

/// Long enough for several blocks of rows and of chunks: while one is taken the next is worked on.
#[test]
fn very_long_files_come_back() {
    let point = |v: u32| [f64::from(v) / 3.0, f64::from(v) / 7.0];
    let file = GraphFile::from(Pslg {
        points: (0..150_000).map(point).collect(),
        ..Pslg::default()
    });
    let mut text = Vec::new();
    write_node(&file, &mut text).expect("memory takes it");
    let text = String::from_utf8(text).expect("text");
    assert!(text.len() > 5_000_000, "several blocks of chunks");
    let read = |text: &str| formats::read(Format::Node, &source(text), None);
    match read(&text) {
        Ok(Input::Doubles(back)) => assert_eq!(back.graph.points, file.graph.points),
        other => panic!("{other:?}"),
    }

    // Of faults in several blocks the first one is reported.
    let mut text = text;
    for v in [149_999, 130_000, 30_000] {
        text = text.replacen(&format!("\n{v} "), "\n7 ", 1);
        let error = read(&text).expect_err("a wrong number").to_string();
        let expected = format!("file:{}: the number is 7, not {v}", v + 2);
        assert_eq!(error, expected);
    }
}
