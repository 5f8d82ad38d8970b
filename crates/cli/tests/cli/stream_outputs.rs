//! What `sweep-cdt stream` writes beside raw numbers: files that say first how many triangles there are, and the vertices
//! in the order of the sweep.

use std::fs;

use sweep_cdt_testing::{Input, Random};
use tempfile::TempDir;

use crate::stream::{expected, ran, set, triangles, write_both, write_raw};
use crate::{FORMATS, folder, printed, printed_despite_losses, text};

/// Points with some that are equal, and edges.
fn few() -> Input {
    Input::parse(
        "0 0, 9 1, 2 0, 4 8, 2 0, 7 7, 0 0, 1 5, 5 3, -3 2",
        "0 3, 3 5, 6 1",
    )
}

/// The numbers of a text, row by row.
fn rows(text: &str) -> Vec<Vec<u64>> {
    let row = |line: &str| {
        let numbers = line.split_whitespace();
        numbers
            .map(|number| number.parse().expect("a number"))
            .collect()
    };
    text.lines().map(row).collect()
}

/// The triangles of an `.ele` whose numbers begin with this one.
fn elements(folder: &TempDir, name: &str, first: u64) -> Vec<[u64; 3]> {
    let text = fs::read_to_string(folder.path().join(name)).expect("a file");
    let rows = rows(&text);
    assert_eq!(rows[0][1..], [3, 0]);
    assert_eq!(rows[0][0], rows.len() as u64 - 1);
    let corners = rows[1..].iter().zip(first..).map(|(row, number)| {
        assert_eq!(row[0], number);
        [1, 2, 3].map(|i| row[i] - first)
    });
    set(corners.collect())
}

#[test]
fn elements_have_the_numbers_of_the_file() {
    let folder = folder(&[]);
    for (input, first) in [("ten.poly", 1), ("split.poly", 0), ("split.node", 0)] {
        let from = format!("{FORMATS}/{input}");
        assert_eq!(
            printed_despite_losses(&ran(&folder, &format!("stream {from} -o t.ele"))),
            ""
        );
        assert_eq!(elements(&folder, "t.ele", first), expected(&folder, &from));
        fs::remove_file(folder.path().join("t.node")).expect("a file beside it");
    }
    let one = "4 2\n1 0 0\n2 2 2\n3 0 2\n4 2 0\n1\n1 1 2\n";
    fs::write(folder.path().join("one.poly"), one).expect("a file");
    assert_eq!(printed(&ran(&folder, "stream one.poly -o one.ele")), "");
    assert_eq!(elements(&folder, "one.ele", 1), [[0, 1, 2], [0, 3, 1]]);
    let verdict = ran(&folder, "verify one.poly one.ele --level canonical");
    assert!(text(&verdict.stdout).starts_with("correct: "));
}

/// Heights and columns of every input go to the `.node` beside a `.ele`, and to a `.ply`, as `triangulate` writes them.
#[test]
fn columns_go_to_the_outputs_that_have_room() {
    let table = "name,x,y,elev,wind,gap\na,0,0,1.5,7,\nb,4,0,2,8,3\nc,4,0,2,9,4\nd,0,4,,-1,\n";
    let node = "4 2 2 1\n1 0 0 1 5 0\n2 4 0 2 6 1\n3 4 4 3 7 0\n4 0 4 4 8 2\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float a\nproperty float y\nproperty float x\n\
               property list uchar int b\nproperty int c\nend_header\n7 0 0 1 9 3\n8 0 4 0 4\n9 4 0 2 1 1 5\n";
    let folder = folder(&[("a.csv", table), ("b.node", node), ("c.ply", ply)]);
    let read = |name: &str| crate::outputs::read(&folder, name);
    for input in ["a.csv", "b.node", "c.ply"] {
        let make = |arguments: String| {
            let made = ran(&folder, &arguments);
            assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        };
        make(format!("triangulate {input} -o m.ele -o m.ply"));
        make(format!("stream {input} -o s.ele"));
        assert_eq!(read("s.node"), read("m.node"), "{input}");
        // Again: the same file may stand there, and no other one.
        make(format!("stream {input} -o s.ele"));
        make(format!("stream {input} -o s.ply"));
        // Both files are read to one graph.
        let [one, other] = ["m.ply", "s.ply"].map(|name| {
            let output = ran(
                &folder,
                &format!("triangulate {name} -o - --output-format json --inside hull"),
            );
            text(&output.stdout).to_owned()
        });
        assert_eq!(one, other, "{input}");
        // A stream reads what it has written.
        let through = ran(&folder, "stream s.ply -o again.ply");
        assert_eq!(through.status.code(), Some(0), "{}", text(&through.stderr));
        let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a file");
        assert!(bytes("s.ply") == bytes("again.ply"), "{input}");
        fs::remove_file(folder.path().join("m.node")).expect("a file");
        for other in ["0 2 0 0\n".to_owned(), read("s.node") + "# more\n"] {
            fs::write(folder.path().join("s.node"), other).expect("a file");
            let refused = ran(&folder, &format!("stream {input} -o s.ele"));
            let said = text(&refused.stderr);
            assert!(
                said.contains("s.node would be overwritten, since the .ele"),
                "{said}"
            );
            assert_eq!(refused.status.code(), Some(2));
        }
        fs::remove_file(folder.path().join("s.node")).expect("a file");
    }
    // The vertices that were read need no copy.
    let beside = ran(&folder, "stream b.node -o b.ele");
    assert_eq!(printed_despite_losses(&beside), "");
    assert_eq!(read("b.node"), node);
    let said = ran(&folder, "stream a.csv -o s.ply");
    assert_eq!(
        text(&said.stderr),
        "note: a.csv: ignored: 1 column `name`\n"
    );
}

/// Standard input is read until it ends, whatever it is.
#[test]
fn standard_input_is_read() {
    let folder = folder(&[("a.csv", "x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,5,4\n2,2,5\n")]);
    write_both(&folder, &few());
    for (input, format, options) in [
        ("p.f64", "f64", "--edges e.u64 -o t.u64"),
        ("a.csv", "csv", "-o t.ply"),
        ("a.csv", "csv", "--contours t.wkt --every 1"),
    ] {
        let written = options
            .split(' ')
            .find(|word| word.starts_with("t."))
            .expect("a file");
        let bytes = |name: &str| fs::read(folder.path().join(name)).expect("a file");
        let from_file = ran(&folder, &format!("stream {input} {options}"));
        let expected = bytes(written);
        assert_eq!(printed(&from_file).replace(input, "standard input"), {
            let arguments = format!("stream - --stream-format {format} {options}");
            let mut command = crate::sweep_cdt(&folder, &arguments);
            printed(&crate::feed(&mut command, &bytes(input))).to_owned()
        });
        assert!(bytes(written) == expected, "{options}");
    }
    let mut command = crate::sweep_cdt(&folder, "stream - --stream-format csv -o t.u32");
    let output = crate::feed(&mut command, b"x,y\n0,0\n1,zero\n");
    let error = "error: standard input:3: `zero` is not a coordinate\n";
    assert_eq!(text(&output.stderr), error);
    let mut command = crate::sweep_cdt(&folder, "stream - --stream-format poly -o t.u32");
    let output = crate::feed(&mut command, b"0 2 0 0\n0 0\n");
    assert!(text(&output.stderr).contains("standard input: there are no vertices"));
}

/// A file that is standard input is not overwritten.
#[test]
#[cfg(unix)]
fn standard_input_is_not_overwritten() {
    let folder = folder(&[]);
    write_both(&folder, &few());
    let path = folder.path().join("p.f64");
    let arguments = "stream - --stream-format f64 -o t.u32 --vertices p.f64";
    let mut command = crate::sweep_cdt(&folder, arguments);
    let output = command
        .stdin(fs::File::open(&path).expect("a file"))
        .output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("p.f64 is an input and would be overwritten"));
}

#[test]
fn a_ply_has_points_and_triangles() {
    let folder = folder(&[]);
    write_both(&folder, &few());
    assert_eq!(
        printed(&ran(
            &folder,
            "stream p.f64 --edges e.u64 --window 2 -o t.ply"
        )),
        ""
    );
    let bytes = fs::read(folder.path().join("t.ply")).expect("a file");
    let spaces = " ".repeat(19);
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment triangulated by sweep-cdt{spaces}\nelement vertex 10\n\
         property double x\nproperty double y\nproperty double z\nelement face 8\n\
         property list uchar uint vertex_indices\nend_header\n"
    );
    assert_eq!(text(&bytes[..header.len()]), header);
    let (points, faces) = bytes[header.len()..].split_at(10 * 24);
    let (numbers, _) = points.as_chunks();
    let numbers: Vec<f64> = numbers.iter().map(|&n| f64::from_le_bytes(n)).collect();
    let points = few().points.into_iter();
    assert_eq!(
        numbers,
        points.flat_map(|[x, y]| [x, y, 0.0]).collect::<Vec<_>>()
    );
    let (faces, rest) = faces.as_chunks::<13>();
    assert!(rest.is_empty() && faces.iter().all(|face| face[0] == 3));
    let corners: Vec<u8> = faces.iter().flat_map(|face| face[1..].to_vec()).collect();
    assert_eq!(set(triangles(&corners, "u32")), expected(&folder, "p.json"));
    let verdict = ran(&folder, "verify p.json t.ply --level canonical");
    assert!(printed(&verdict).starts_with("correct: "));
    // Without a triangle it is complete as well.
    fs::write(folder.path().join("none.f64"), "").expect("a file");
    assert_eq!(printed(&ran(&folder, "stream none.f64 -o none.ply")), "");
    let none = fs::read(folder.path().join("none.ply")).expect("a file");
    assert!(text(&none).ends_with(
        "element vertex 0\nproperty double x\nproperty double y\nproperty double z\nelement face 0\nproperty list uchar \
         uint vertex_indices\nend_header\n"
    ));
}

#[test]
fn vertices_come_in_the_order_of_the_sweep() {
    let folder = folder(&[]);
    write_both(&folder, &few());
    let expected = expected(&folder, "p.json");
    for settings in ["", "--check --window 1", "--check"] {
        let made = ran(
            &folder,
            &format!("stream p.f64 --edges e.u64 {settings} -o t.u32 --vertices v.f64"),
        );
        assert_eq!(printed(&made).is_empty(), !settings.contains("--check"));
        let vertices = fs::read(folder.path().join("v.f64")).expect("a file");
        let (numbers, _) = vertices.as_chunks();
        let numbers: Vec<f64> = numbers.iter().map(|&n| f64::from_le_bytes(n)).collect();
        let (vertices, _) = numbers.as_chunks::<2>();
        assert!(vertices.is_sorted_by(|a, b| (a[1], a[0]) < (b[1], b[0])));
        assert_eq!(vertices.len(), 8);
        // The first of equal points stands for them.
        let points = few().points;
        let first = |v: u64| {
            let place = vertices[usize::try_from(v).expect("a number")];
            points
                .iter()
                .position(|point| point.map(f64::to_bits) == place.map(f64::to_bits))
                .expect("a point") as u64
        };
        let bytes = fs::read(folder.path().join("t.u32")).expect("a file");
        let found = triangles(&bytes, "u32").into_iter();
        assert_eq!(
            set(found.map(|corners| corners.map(first)).collect()),
            expected
        );
    }
    write_raw(&folder, &Input::generated("uniform", 2000, 3));
    let made = ran(&folder, "stream p.f64 -o t.ele --vertices v.f64");
    assert_eq!(printed(&made), "");
    let made = ran(&folder, "stream p.f64 -o t.u64 --vertices v.f64");
    assert_eq!(printed(&made), "");
    let verdict = ran(&folder, "verify --stream v.f64 t.u64 --level canonical");
    assert!(printed(&verdict).starts_with("correct: "));
    let bytes = fs::read(folder.path().join("t.u64")).expect("a file");
    assert_eq!(elements(&folder, "t.ele", 0), set(triangles(&bytes, "u64")));
}

#[cfg(unix)]
#[test]
fn what_counts_first_needs_a_file() {
    let folder = folder(&[]);
    write_raw(&folder, &few());
    for name in ["t.ele", "t.ply"] {
        std::os::unix::fs::symlink("/dev/null", folder.path().join(name)).expect("a link");
        let message = "a .ele or .ply begins with the number of triangles, which is known last: let OUTPUT be a file";
        crate::outputs::assert_refused(&folder, &format!("stream p.f64 -o {name}"), message);
    }
}

/// In the first piece of a table, and in those that follow.
#[test]
fn columns_of_a_table_are_chosen() {
    let folder = folder(&[]);
    let mut random = Random::new(5);
    let row = |number: usize| {
        let [x, y] = [0, 1].map(|_| random.integer(1 << 20));
        format!("{number},{y},\"at {number}\",{x}\n")
    };
    let table: String = (1..20_000).map(row).collect();
    fs::write(folder.path().join("p.csv"), table).expect("a file");
    let made = ran(&folder, "stream p.csv --columns 4,2 -o t.u64");
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let bytes = fs::read(folder.path().join("t.u64")).expect("a file");
    let expected = expected(&folder, "p.csv --columns 4,2");
    assert_eq!(set(triangles(&bytes, "u64")), expected);
    let verdict = ran(&folder, "verify --stream p.csv t.u64 --columns 4,2");
    assert!(printed(&verdict).starts_with("correct: "));
    let other = ran(&folder, "verify --stream p.csv t.u64 --columns 1,4");
    assert_eq!(other.status.code(), Some(1));
    let unknown = ran(&folder, "stream p.csv --columns 4,7");
    assert_eq!(unknown.status.code(), Some(1));
}
