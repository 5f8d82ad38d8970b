//! Readers of files: each is compared with the reader that has the file in memory. (`ply.rs` has those of `.ply`.)

use std::fs;
use std::path::Path;

use sweep_cdt_formats::{Column, Input as Read, Source, read};
use sweep_cdt_stream::external::{Choice, Format, Sorting, open, open_chosen};

use crate::{Random, expected, take};

/// Sorts a file, and compares it with what a reader of the whole file finds.
pub(crate) fn check_file(name: &str, bytes: &[u8], format: Format) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("a file");
    let file = match read(format, &Source::new(name, bytes), None) {
        Ok(Read::Doubles(file)) => file,
        other => panic!("{name} is read in memory: {other:?}"),
    };
    let heights = file.heights().map(|column| &column.values[..]);
    check_heights(&path, format, heights);
    check_columns(&path, format, &file.columns);
    let graph = file.graph;
    let edges: Vec<[u64; 2]> = graph
        .edges
        .iter()
        .map(|edge| edge.map(|end| end as u64))
        .collect();
    sorts_to(&path, format, &graph.points, &edges);
}

/// Reads a file in pieces, and compares the columns that come with the points. Markers that are all 0 are none in memory.
fn check_columns(path: &Path, format: Format, expected: &[Column]) {
    let choice = Choice {
        heights: true,
        others: true,
        ..Choice::default()
    };
    let mut input = open_chosen(path, format, None, &choice).expect("a file");
    let mut columns: Vec<Column> = Vec::new();
    let mut points = Vec::new();
    loop {
        let before = points.len();
        input.next_points(&mut points).expect("points");
        if points.len() == before {
            break;
        }
        for column in input.columns() {
            assert_eq!(column.values.len(), points.len() - before);
            let place = columns.iter().position(|own| own.name == column.name);
            let place = place.unwrap_or_else(|| {
                let (name, values) = (column.name.clone(), Vec::new());
                columns.push(Column { name, values });
                columns.len() - 1
            });
            columns[place].values.resize(before, f64::NAN);
            columns[place].values.extend(&column.values);
        }
        for column in &mut columns {
            column.values.resize(points.len(), f64::NAN);
        }
    }
    // At the end the names are known.
    let names: Vec<&str> = input
        .columns()
        .iter()
        .map(|column| &column.name[..])
        .collect();
    let is_said = |column: &Column| {
        let numbers = column.values.iter();
        column.name != Column::MARKER || !numbers.clone().all(|&x| x.is_nan() || x == 0.0)
    };
    columns.retain(|column| names.contains(&&column.name[..]) && is_said(column));
    let mut expected = expected.to_vec();
    expected.retain(|column| column.name != Column::HEIGHT && is_said(column));
    for list in [&mut columns, &mut expected] {
        list.sort_by(|a, b| a.name.cmp(&b.name));
    }
    assert!(
        columns == expected,
        "{}: {columns:?}: {expected:?}",
        path.display()
    );
}

/// Sorts a file in little memory and in much, and compares the heights that come with the vertices.
pub(crate) fn check_heights(path: &Path, format: Format, expected: Option<&[f64]>) {
    let folder = tempfile::tempdir().expect("a folder");
    for memory in [250_000, 1 << 30] {
        let choice = Choice {
            heights: true,
            ..Choice::default()
        };
        let mut input = open_chosen(path, format, None, &choice).expect("a file");
        let order = Sorting::new(memory, folder.path()).sort(&mut *input);
        let mut order = order.expect("no fault");
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        while let Some(vertex) = order.next_vertex().expect("no fault") {
            let at = usize::try_from(vertex.number).expect("small");
            let height = expected.map_or(f64::NAN, |heights| heights[at]);
            let height = Some(height).filter(|height| !height.is_nan());
            let bits = |height: Option<f64>| height.map(f64::to_bits);
            assert_eq!(bits(vertex.height), bits(height), "{}", path.display());
            range = height.map_or(range, |z| [range[0].min(z), range[1].max(z)]);
        }
        let bits = |range: [f64; 2]| range.map(f64::to_bits);
        let summary = order.summary();
        assert_eq!(bits(summary.height), bits(range), "{}", path.display());
    }
}

/// Sorts a file in little memory and in much.
fn sorts_to(path: &Path, format: Format, points: &[[f64; 2]], edges: &[[u64; 2]]) {
    let folder = tempfile::tempdir().expect("a folder");
    for memory in [200_000, 1 << 30] {
        let mut input = open(path, format, None).expect("a file");
        let order = Sorting::new(memory, folder.path()).sort(&mut *input);
        let vertices = take(order.expect("no fault")).expect("no fault");
        let expected = expected(points, edges).0;
        assert_eq!(vertices.len(), expected.len());
        for (vertex, expected) in vertices.iter().zip(&expected) {
            assert_eq!(vertex, expected, "{}", path.display());
        }
    }
}

pub(crate) fn random_graph() -> (Vec<[f64; 2]>, Vec<[u64; 2]>) {
    let mut random = Random(51);
    let points = (0..9000).map(|_| [random.share(), random.below(500) as f64]);
    let points = points.collect();
    let edges = (0..2000).map(|_| [random.below(9000), random.below(9000)]);
    (points, edges.collect())
}

#[test]
fn raw_doubles_are_read_with_and_without_edges() {
    let (points, edges) = random_graph();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("points.f64");
    let bytes = |numbers: Vec<[u8; 8]>| numbers.concat();
    let doubles = points
        .as_flattened()
        .iter()
        .map(|value| value.to_le_bytes());
    fs::write(&path, bytes(doubles.collect())).expect("a file");
    sorts_to(&path, Format::F64, &points, &[]);

    let pairs = folder.path().join("edges.u64");
    let numbers = edges.as_flattened().iter().map(|end| end.to_le_bytes());
    fs::write(&pairs, bytes(numbers.collect())).expect("a file");
    let mut input = open(&path, Format::F64, Some(&pairs)).expect("two files");
    let order = Sorting::new(200_000, folder.path()).sort(&mut *input);
    let vertices = take(order.expect("no fault")).expect("no fault");
    assert!(vertices == expected(&points, &edges).0);
}

/// A batch of the order ends early where many edges begin: the heights behind it come with the next one.
#[test]
fn heights_come_where_batches_end_early() {
    let mut random = Random(52);
    let mut text = "400 2 1 0\n".to_owned();
    for at in 0..400 {
        let [x, y, z] = [0; 3].map(|_| random.below(1000));
        text.push_str(&format!("{at} {x} {y} {z}\n"));
    }
    text.push_str("4000 0\n");
    for at in 0..4000 {
        let [a, b] = [0; 2].map(|_| random.below(400));
        text.push_str(&format!("{at} {a} {b}\n"));
    }
    text.push_str("0\n");
    check_file("a.poly", text.as_bytes(), Format::Poly);
}

/// Compares the error of a file with that of a reader in memory.
fn check_error(name: &str, bytes: &[u8], format: Format) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("a file");
    let source = Source::new(path.display().to_string(), bytes);
    let expected = read(format, &source, None).expect_err("it is wrong");
    let opened = open(&path, format, None).map_err(Into::into);
    let error = opened.and_then(|mut input| Sorting::new(1 << 20, folder.path()).sort(&mut *input));
    assert_eq!(
        error.expect_err("it is wrong").to_string(),
        expected.to_string(),
        "{name}"
    );
}

/// Rows of points as text, enough for some blocks of pieces.
fn rows(separator: &str, end: &str) -> Vec<String> {
    let mut random = Random(52);
    let row = |at: u64| {
        let (x, y) = (random.share(), random.below(5000));
        let s = separator;
        format!("{at}{s}{y}{s}{x:?}{s}{}e-3{s}tree {at}{end}", at * 7)
    };
    (0..70_000).map(row).collect()
}

#[test]
fn points_as_text_are_read_as_in_memory() {
    let names = "id;northing;Easting (m);z;note";
    for end in ["\n", "\r\n", "\r"] {
        let plain = rows(";", end).concat();
        assert!(plain.len() > 2 << 20, "some blocks of pieces");
        for begin in [
            format!("{names}{end}"),
            format!("\u{feff}sep=;{end}{end};;;;{end}{names}{end}"),
            format!("# {names}{end}# of others{end}{names}{end}"),
        ] {
            let text = format!("{begin}{plain}");
            check_file("names.csv", text.as_bytes(), Format::Csv);
        }
    }
    // Without names x and y are the first two columns; the last row does not end.
    let text = rows(" ", "\n").concat();
    let text = format!("# a comment\n\n{}", text.trim_end());
    check_file("plain.xyz", text.as_bytes(), Format::Xyz);
    // The names are in a comment.
    let text = format!("#id y x z note\n{}", text.replace("tree ", "tree"));
    check_file("comment.txt", text.as_bytes(), Format::Txt);
    check_file("one.csv", b"1,2", Format::Csv);
    check_file("names_alone.csv", b"x,y\n", Format::Csv);
}

/// The ends of pieces fall within quotes somewhere.
#[test]
fn lines_end_within_quotes() {
    let quoted = |(at, row): (usize, String)| {
        let lines = "a\n7;8;9;\"\"\n".repeat(at % 40);
        row.replace("tree", &format!("\"{lines}\""))
            .replace("\" ", "\";")
    };
    let rows: String = rows(";", "\n")
        .into_iter()
        .enumerate()
        .map(quoted)
        .collect();
    let text = format!("\"the\nid\";y;x;z;note;more\n{rows}");
    check_file("quotes.csv", text.as_bytes(), Format::Csv);
    let open_quote = format!("{text}1;2;3;4;\"5\n{rows}");
    let open_quote = open_quote.trim_end_matches('"').to_owned() + ";\"";
    check_error("open.csv", open_quote.as_bytes(), Format::Csv);
}

#[test]
fn errors_of_points_as_text_have_their_lines() {
    let names = "id;y;x;z;note\n";
    for (at, row) in [
        (0, "1;2\n"),
        (5, "7;8;x;9;10\n"),
        (40_000, "7;8,5;9;10;11\n"),
        (69_999, "7;8;9;10;11;12\n"),
    ] {
        let mut rows = rows(";", "\n");
        rows[at] = row.to_owned();
        let text = format!("# comment\n{names}{}", rows.concat());
        check_error("wrong.csv", text.as_bytes(), Format::Csv);
    }
    // Both signs of an end are one, also in the first row.
    let mut rows = rows(";", "\r\n");
    rows[30_000] = "7;8;x;9;10\r\n".to_owned();
    let text = format!("id;y;x;z;note\r\n{}", rows.concat());
    check_error("ends.csv", text.as_bytes(), Format::Csv);
    for text in ["", "\n\n", "# x y\n", "a,b\n1,2\n", "5\n", "x,x,y\n1,2,3\n"] {
        check_error("begin.csv", text.as_bytes(), Format::Csv);
    }
}

#[test]
fn fractions_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a");
    for (format, text, words) in [
        (
            Format::Xyz,
            "1 2\n1/3 4\n",
            "there are fractions, which are read only where all points are in memory",
        ),
        (
            Format::Node,
            "1\n0 1/3 4\n",
            "`1/3` is a fraction, which is read only where all points are in memory",
        ),
    ] {
        fs::write(&path, text).expect("a file");
        let mut input = open(&path, format, None).expect("it begins well");
        let error = Sorting::new(1 << 20, folder.path()).sort(&mut *input);
        let error = error.expect_err("a fraction").to_string();
        assert!(error.ends_with(words), "{error}");
    }
}

/// A `.poly`, with its vertices or without them, and the rest of it.
fn poly(points: &[[f64; 2]], edges: &[[u64; 2]], first: u64) -> [String; 2] {
    let mut vertices = format!("# a graph\n{} 2 1 1 # counts\n\n", points.len());
    for ([x, y], number) in points.iter().zip(first..) {
        vertices += &format!(" {number}\t{x:?} {y} 7.5 0 # vertex\n");
    }
    let mut rest = format!("{} 1\n", edges.len());
    for ([a, b], number) in edges.iter().zip(first..) {
        rest += &format!("{number} {} {} 3\r\n", a + first, b + first);
    }
    [vertices, rest + "1\n1 0.5 0.5\n0\n"]
}

#[test]
fn triangles_files_are_read_as_in_memory() {
    let (points, edges) = random_graph();
    for first in [0, 1] {
        let [vertices, rest] = poly(&points, &edges, first);
        check_file("a.node", vertices.as_bytes(), Format::Node);
        let text = format!("{vertices}{rest}");
        check_file("a.poly", text.as_bytes(), Format::Poly);
        // The vertices are in the `.node`.
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("b.node"), vertices).expect("a file");
        let path = folder.path().join("b.poly");
        fs::write(&path, format!("0 2 0 0\n{rest}")).expect("a file");
        sorts_to(&path, Format::Poly, &points, &edges);
    }
}

#[test]
fn errors_of_triangles_files_are_those_in_memory() {
    for text in [
        "",
        "x\n",
        "2 3\n",
        "2 5\n",
        "2\n",
        "2\n0 1 2\n",
        "2\n0 1 2\n2 3 4\n",
        "2\n2 1 2\n",
        "2\n0 1\n1 3 4\n",
        "2\n0 1 2\n1 3 z\n",
        "2\n0 1 2\n1 3 1e999\n",
        "1\n0 1 2\n1 3 4\n",
    ] {
        check_error("a.node", text.as_bytes(), Format::Node);
    }
    // The two signs of an end stand in two pieces of the file.
    let comment = format!("#{}\r\n", "x".repeat((1 << 18) - 2));
    let text = format!("{comment}2\r\n0 1 2\r\n1 3 z\r\n");
    check_error("a.node", text.as_bytes(), Format::Node);
    let vertices = "2\n1 0 0\n2 1 1\n";
    for rest in [
        "",
        "y\n",
        "1\n",
        "1\n1 1\n",
        "1\n1 1 b\n",
        "2\n1 1 2\n3 1 2\n",
    ] {
        let text = format!("{vertices}{rest}");
        check_error("a.poly", text.as_bytes(), Format::Poly);
    }
}

/// Ends of edges are checked when all are read, by the numbers of the file.
#[test]
fn numbers_in_errors_are_those_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.poly");
    for (text, words) in [
        (
            "2\n1 0 0\n2 1 1\n2\n1 1 2\n2 1 3\n",
            "edge 2 ends at point 3, which does not exist: the points are numbered from 1 to 2",
        ),
        (
            "2\n1 0 0\n2 1 1\n2\n1 1 2\n2 1 0\n",
            "6: vertex 0 does not exist: the vertices are numbered from 1",
        ),
        (
            "2\n1 0 0\n2 1 nan\n0\n",
            "point 2 has a coordinate that is not finite",
        ),
    ] {
        fs::write(&path, text).expect("a file");
        let mut input = open(&path, Format::Poly, None).expect("it begins well");
        let error = Sorting::new(1 << 20, folder.path()).sort(&mut *input);
        let error = error.expect_err("a fault").to_string();
        assert!(error.ends_with(words), "{error}");
    }
}

#[test]
fn a_format_with_edges_takes_no_others() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.poly");
    fs::write(&path, "1\n0 0 0\n0\n").expect("a file");
    let error = open(&path, Format::Poly, Some(&path))
        .err()
        .expect("it is refused");
    let words = format!("it has edges itself, and {} cannot add any", path.display());
    assert!(error.to_string().ends_with(&words), "{error}");
}

/// Which columns hold numbers is known at the end: text, or the first number, may stand in the last of many pieces.
#[test]
fn columns_of_many_pieces_are_those_of_the_whole_file() {
    let rows = 60_000;
    let row = |at: usize| {
        let late = if at + 1 == rows { "7" } else { "" };
        let word = if at + 1 == rows { "oak" } else { "1" };
        let first = if at == 0 { "oak" } else { "1" };
        let sparse = if at % 20_000 == 5 { "3" } else { "" };
        format!(
            "{at},{},{at}.5,{late},{word},{first},{sparse},\n",
            at * at % 977
        )
    };
    let rows: String = (0..rows).map(row).collect();
    let text = format!("x,y,all,late,word,first,sparse,sparse\n{rows}");
    check_file("pieces.csv", text.as_bytes(), Format::Csv);
    // So many columns of text that not all have names in remarks.
    let names: Vec<String> = (0..20).map(|at| format!("n{at}")).collect();
    let row = |at: usize| {
        let words = (0..20).map(|n| {
            if at == 50_000 && n > 3 || n > 5 {
                "w"
            } else {
                "1"
            }
        });
        format!(
            "{at},{},{}\n",
            at % 977,
            words.collect::<Vec<_>>().join(",")
        )
    };
    let rows: String = (0..60_000).map(row).collect();
    let text = format!("x,y,{}\n{rows}", names.join(","));
    check_file("words.csv", text.as_bytes(), Format::Csv);
}
