//! The reader of `.ply`, compared with the one that has the file in memory: every encoding, every order of the elements,
//! lists among what is read, and files that are cut off.

use std::fs;

use sweep_cdt_formats::{Source, read};
use sweep_cdt_stream::external::{Format, Sorting, open};

use crate::formats::{check_file, random_graph};

/// Bytes of a file.
type Bytes = Vec<u8>;

/// A `.ply` with elements that are not read, with lists and other properties among those that are.
struct Ply {
    encoding: &'static str,
    real: &'static str,
    edges_first: bool,
    has_lists: bool,
}

impl Ply {
    fn bytes(&self, points: &[[f64; 2]], edges: &[[u64; 2]]) -> Bytes {
        let Ply {
            encoding,
            real,
            edges_first,
            has_lists,
        } = *self;
        let list = if has_lists {
            "property list uchar short more\n"
        } else {
            ""
        };
        let vertex = format!(
            "element vertex {}\n{list}property {real} y\nproperty uchar red\nproperty {real} x\n",
            points.len()
        );
        let edge = format!(
            "element edge {}\nproperty int vertex1\n{list}property int vertex2\n",
            edges.len()
        );
        let face = "element face 2\nproperty list uchar int vertex_indices\n";
        let order = match edges_first {
            true => [edge, face.to_owned(), vertex],
            false => [vertex, face.to_owned(), edge],
        };
        let header = format!(
            "ply\nformat {encoding} 1.0\ncomment made\n{}end_header\n",
            order.concat()
        );
        let mut bytes = header.into_bytes();
        let mut records: [Bytes; 3] = [Vec::new(), Vec::new(), Vec::new()];
        let [of_points, of_faces, of_edges] = &mut records;
        for (at, &[x, y]) in points.iter().enumerate() {
            self.list(at % 3, of_points);
            self.number(real, y, of_points);
            self.number("uchar", (at % 200) as f64, of_points);
            self.number(real, x, of_points);
            self.end(of_points);
        }
        for corners in [3, 4] {
            self.number("uchar", f64::from(corners), of_faces);
            (0..corners).for_each(|corner| self.number("int", f64::from(corner), of_faces));
            self.end(of_faces);
        }
        for (at, &[a, b]) in edges.iter().enumerate() {
            self.number("int", a as f64, of_edges);
            self.list(at % 4, of_edges);
            self.number("int", b as f64, of_edges);
            self.end(of_edges);
        }
        if edges_first {
            records.reverse();
        }
        bytes.extend(records.concat());
        bytes
    }

    fn list(&self, length: usize, bytes: &mut Bytes) {
        if self.has_lists {
            self.number("uchar", length as f64, bytes);
            (0..length).for_each(|at| self.number("short", at as f64, bytes));
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small numbers"
    )]
    fn number(&self, kind: &str, value: f64, bytes: &mut Bytes) {
        if self.encoding == "ascii" {
            return bytes.extend(format!("{value} ").into_bytes());
        }
        let mut piece = match kind {
            "uchar" => vec![value as u8],
            "short" => (value as i16).to_le_bytes().to_vec(),
            "int" => (value as i32).to_le_bytes().to_vec(),
            "float" => (value as f32).to_le_bytes().to_vec(),
            _ => value.to_le_bytes().to_vec(),
        };
        if self.encoding == "binary_big_endian" {
            piece.reverse();
        }
        bytes.extend(piece);
    }

    fn end(&self, bytes: &mut Bytes) {
        if self.encoding == "ascii" {
            bytes.push(b'\n');
        }
    }
}

#[test]
fn a_ply_is_read_in_every_encoding_and_order_of_its_elements() {
    let (points, edges) = random_graph();
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for (real, edges_first, has_lists) in [
            ("double", false, false),
            ("float", false, true),
            ("double", true, false),
            ("float", true, true),
            ("int", false, false),
        ] {
            let ply = Ply {
                encoding,
                real,
                edges_first,
                has_lists,
            };
            let name = format!("{encoding} {real} {edges_first} {has_lists}.ply");
            check_file(&name, &ply.bytes(&points, &edges), Format::Ply);
        }
    }
}

/// Every number of bytes is missing once. Only a whole file is read.
#[test]
fn a_ply_that_is_cut_off_is_refused_as_in_memory() {
    let points: Vec<[f64; 2]> = (0..5).map(|at| [f64::from(at), 0.5]).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.ply");
    for encoding in ["ascii", "binary_little_endian"] {
        for has_lists in [false, true] {
            let ply = Ply {
                encoding,
                real: "double",
                edges_first: false,
                has_lists,
            };
            let bytes = ply.bytes(&points, &[[0, 1], [3, 4]]);
            // A text may end within its last number.
            let whole = if encoding == "ascii" {
                bytes.len() - 2
            } else {
                bytes.len()
            };
            for length in 0..whole {
                fs::write(&path, &bytes[..length]).expect("a file");
                let source = Source::new(path.display().to_string(), &bytes[..length]);
                let expected = read(Format::Ply, &source, None).expect_err("it is cut off");
                let opened = open(&path, Format::Ply, None);
                let error = opened
                    .map_err(Into::into)
                    .and_then(|mut input| Sorting::new(1 << 20, folder.path()).sort(&mut *input));
                let error = error.expect_err("it is cut off");
                assert_eq!(error.to_string(), expected.to_string(), "{length} bytes");
            }
        }
    }
}

/// Where it can be known, a `.ply` is refused before any work on its points.
#[test]
fn a_binary_ply_that_is_cut_off_is_refused_at_once() {
    let points = [[1.0, 2.0]; 100];
    let ply = Ply {
        encoding: "binary_little_endian",
        real: "double",
        edges_first: false,
        has_lists: false,
    };
    let bytes = ply.bytes(&points, &[]);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.ply");
    fs::write(&path, &bytes[..bytes.len() - 900]).expect("a file");
    let mut input = open(&path, Format::Ply, None).expect("its header is whole");
    let mut read = Vec::new();
    let error = input.next_points(&mut read).expect_err("it is cut off");
    assert!(
        error
            .message
            .ends_with("the file ends, and 100 are announced"),
        "{error}"
    );
    assert!(read.is_empty());
}
