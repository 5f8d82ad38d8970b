//! Binary `.msh`, made here as Gmsh's manual has it, and what is refused.

use sweep_cdt::Pslg;
use sweep_cdt_formats::{
    Column, Format, GraphFile, Input, Remark, Source, read, read_result, write_graph,
};
use sweep_cdt_testing::Random;

/// A file that is written: its version and order of bytes.
struct Writer {
    has_blocks: bool,
    big_endian: bool,
    /// The bytes of a count in version 4.1.
    size: usize,
    file: Vec<u8>,
}

/// An element: its type and its nodes.
type Element<'a> = (i32, &'a [usize]);

impl Writer {
    fn put(&mut self, mut bytes: Vec<u8>) {
        if self.big_endian {
            bytes.reverse();
        }
        self.file.extend(bytes);
    }

    fn int(&mut self, number: i32) {
        self.put(number.to_le_bytes().to_vec());
    }

    fn count(&mut self, number: usize) {
        let size = if self.has_blocks { self.size } else { 4 };
        self.put(number.to_le_bytes()[..size].to_vec());
    }

    fn text(&mut self, text: &str) {
        self.file.extend(text.as_bytes());
    }

    /// The nodes with these numbers and elements, each of a block of its own, among other sections.
    fn write(
        mut self,
        points: &[[f64; 3]],
        numbers: &[usize],
        elements: &[Element<'_>],
    ) -> Vec<u8> {
        let version = if self.has_blocks { "4.1" } else { "2.2" };
        let size = if self.has_blocks { self.size } else { 8 };
        self.text(&format!("$MeshFormat\n{version} 1 {size}\n"));
        self.int(1);
        self.text(
            "\n$EndMeshFormat\n$PhysicalNames\n1\n1 7 \"a $ line\"\n$EndPhysicalNames\n$Entities\n",
        );
        self.file.extend([0, 255, 10, b'$', b'E', 13, 0]);
        self.text("\n$EndEntities\n$Nodes\n");
        if self.has_blocks {
            [points.len(), points.len(), 1, 9]
                .iter()
                .for_each(|&n| self.count(n));
        } else {
            self.text(&format!("{}\n", points.len()));
        }
        for (at, (place, &number)) in points.iter().zip(numbers).enumerate() {
            if self.has_blocks {
                let dimension = i32::try_from(at % 4).expect("small");
                let is_parametric = at % 3 == 1;
                self.int(dimension);
                self.int(-1);
                self.int(i32::from(is_parametric));
                self.count(1);
                self.count(number);
                place
                    .iter()
                    .for_each(|x| self.put(x.to_le_bytes().to_vec()));
                let parameters = if is_parametric { dimension } else { 0 };
                (0..parameters).for_each(|_| self.put(0.5_f64.to_le_bytes().to_vec()));
            } else {
                self.count(number);
                place
                    .iter()
                    .for_each(|x| self.put(x.to_le_bytes().to_vec()));
            }
        }
        self.text("\n$EndNodes\n$Elements\n");
        if self.has_blocks {
            [elements.len(), elements.len(), 1, 9]
                .iter()
                .for_each(|&n| self.count(n));
        } else {
            self.text(&format!("{}\n", elements.len()));
        }
        for (at, (kind, corners)) in elements.iter().enumerate() {
            if self.has_blocks {
                self.int(1);
                self.int(-4);
                self.int(*kind);
                self.count(1);
                self.count(at + 1);
            } else {
                let tags = i32::try_from(at % 3).expect("small");
                [*kind, 1, tags].iter().for_each(|&n| self.int(n));
                self.count(at + 1);
                (0..tags).for_each(|_| self.int(-7));
            }
            corners.iter().for_each(|&corner| self.count(corner));
        }
        self.text("\n$EndElements\n");
        self.file
    }
}

fn writers() -> Vec<Writer> {
    let kinds = [(false, 8), (true, 8), (true, 4)];
    let writers = kinds.iter().flat_map(|&(has_blocks, size)| {
        [false, true].map(|big_endian| Writer {
            has_blocks,
            big_endian,
            size,
            file: Vec::new(),
        })
    });
    writers.collect()
}

fn input(bytes: &[u8]) -> Result<GraphFile<f64>, String> {
    match read(Format::Msh, &Source::new("file", bytes), None) {
        Ok(Input::Doubles(file)) => Ok(file),
        Ok(other) => panic!("{other:?}"),
        Err(error) => Err(error.to_string()),
    }
}

const SQUARE: [[f64; 3]; 4] = [
    [0.0, 0.0, 7.5],
    [1.0, 0.0, 0.0],
    [1.0, 1e-9, -1.0],
    [0.0, 1.0, 1e300],
];

fn triangles(bytes: &[u8]) -> Result<Vec<[usize; 3]>, String> {
    let graph = Pslg {
        points: SQUARE.map(|[x, y, _]| [x, y]).to_vec(),
        ..Pslg::default()
    };
    let source = Source::new("file", bytes);
    let result = read_result(Format::Msh, &source, None, &graph.into());
    result
        .map(|result| result.list)
        .map_err(|error| error.to_string())
}

#[test]
fn both_versions_and_orders_are_read() {
    for numbers in [[1, 2, 3, 4], [0, 1, 2, 3], [9, 2, 70_000, 1]] {
        let [a, b, c, d] = numbers;
        let elements: [Element<'_>; 6] = [
            (15, &[a]),
            (1, &[a, c]),
            (2, &[a, b, c]),
            (8, &[a, d, b]),
            (15, &[d]),
            (2, &[a, c, d]),
        ];
        for writer in writers() {
            let has_tags = !writer.has_blocks;
            let bytes = writer.write(&SQUARE, &numbers, &elements);
            let file = input(&bytes).expect("it is right");
            assert_eq!(file.graph.points, SQUARE.map(|[x, y, _]| [x, y]));
            assert_eq!(file.columns[0].values, SQUARE.map(|place| place[2]));
            assert_eq!(file.graph.edges, [[0, 2], [0, 1], [1, 3]]);
            // The first tag is the marker.
            let markers: &[i64] = if has_tags { &[-7, 0, 0] } else { &[] };
            assert_eq!(file.edge_markers, markers);
            let of_vertices = |column: &&Column| column.name == Column::MARKER;
            let of_vertices = file.columns.iter().find(of_vertices);
            assert_eq!(
                of_vertices.map(|column| column.values[3]),
                has_tags.then_some(-7.0)
            );
            let ignored = ["`$PhysicalNames`", "`$Entities`"].map(|name| {
                let [one, many] = ["section", "sections"].map(|what| format!("{what} {name}"));
                Remark::ignored(1, &one, &many)
            });
            assert_eq!(file.remarks, ignored);
            assert_eq!(file.numbering.vertex, usize::from(a != 0));
            assert_eq!(triangles(&bytes), Ok(vec![[0, 1, 2], [0, 2, 3]]));
            // As text it is the same.
            let mut text = Vec::new();
            write_graph(Format::Msh, &file, &mut text).expect("memory takes it");
            assert_eq!(input(&text).expect("a text").graph, file.graph);
        }
    }
}

#[test]
fn wrong_files_are_named() {
    let numbers = [1, 2, 3, 4];
    let all = |points: &[[f64; 3]], elements: &[Element<'_>], which: usize| {
        let writer = writers().swap_remove(which);
        writer.write(points, &numbers[..points.len()], elements)
    };
    for which in 0..writers().len() {
        let refused = |elements: &[Element<'_>], why: &str| {
            let found = triangles(&all(&SQUARE, elements, which));
            assert_eq!(found, Err(format!("file: {why}")));
        };
        refused(
            &[(3, &[1, 2, 3, 4])],
            "elements of type 3 are not read, only triangles (2)",
        );
        refused(&[(99, &[1])], "elements of type 99 are not known");
        let whole = all(&SQUARE, &[(1, &[1, 3]), (2, &[1, 2, 3])], which);
        assert!(input(&whole).is_ok());
        // A file may end behind its nodes, and no end of a line need follow the last word.
        let is_whole = |cut: &[u8]| cut.trim_ascii_end().ends_with(b"$EndNodes");
        for end in (1..whole.len() - 1).filter(|&end| !is_whole(&whole[..end])) {
            assert!(input(&whole[..end]).is_err(), "{end} of {}", whole.len());
        }
        let beyond = all(&SQUARE, &[(1, &[1, 5])], which);
        let why = "file: line 1 of the mesh: vertex 5 does not exist: the vertices are numbered from 1 to 4";
        assert_eq!(input(&beyond), Err(why.to_owned()));
    }
    let twice = writers().swap_remove(0).write(&SQUARE[..2], &[5, 5], &[]);
    let why = "file: two nodes have the same number".to_owned();
    assert_eq!(input(&twice), Err(why));
    let none = writers()
        .swap_remove(2)
        .write(&SQUARE[..2], &[5, 7], &[(1, &[5, 6])]);
    assert_eq!(input(&none), Err("file: there is no node 6".to_owned()));
    let head = |text: &str| input(&[b"$MeshFormat\n", text.as_bytes()].concat());
    let refused = |text: &str, why: &str| assert_eq!(head(text), Err(format!("file:{why}")));
    refused(
        "4.0 1 8\n",
        "2: the version is `4.0`, and only 2 and 4.1 are read",
    );
    refused("4.1 1 16\n", "2: numbers of 16 bytes are not read");
    refused(
        "2.2 1 8\n\u{2}\0\0\0",
        "2: no int of 1 follows, which tells the order of bytes",
    );
    refused(
        "2.2 1 8\n\u{1}\0\0\0\n$EndMeshFormat\n$Nodes\n99999999999999\n",
        " the file ends where a node's number should follow",
    );
    refused(
        "2.2 1 8\n\u{1}\0\0\0\n$EndMeshFormat\n$Elements\n0\n",
        "5: `$Elements` stands where it should not: `$Nodes` come first, and once",
    );
    refused(
        "2.2 1 8\n\u{1}\0\0\0\n$EndMeshFormat\n$Comment\nno end",
        " the file ends where `$EndComment` should follow",
    );
    refused(
        "2.2 1 8\n\u{1}\0\0\0\n$EndMeshFormat\n",
        " there are no `$Nodes`",
    );
}

#[test]
fn damaged_files_are_refused_or_read_but_nothing_else() {
    let mut dice = Random::new(9);
    let elements: [Element<'_>; 3] = [(1, &[1, 3]), (2, &[1, 2, 3]), (8, &[1, 2, 3])];
    let mut refused = 0;
    for round in 0..30_000 {
        let writer = writers().swap_remove(round % 6);
        let mut bytes = writer.write(&SQUARE, &[1, 2, 3, 4], &elements);
        for _ in 0..=dice.below(3) {
            let at = dice.below(bytes.len());
            let few = [0, 1, 2, 3, 15, 0x7f, 0xff, b'$', b'\n', b'9'];
            bytes[at] = few[dice.below(few.len())];
        }
        refused += usize::from(input(&bytes).is_err());
        drop(triangles(&bytes));
    }
    assert!((1000..30_000).contains(&refused), "{refused}");
}
