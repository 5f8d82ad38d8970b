//! `sweep-cdt stream` and `verify` of several files: they are one input, whose points are numbered on through all of them.

use std::fmt::Write;
use std::fs;

use sweep_cdt_testing::Random;
use tempfile::TempDir;

use crate::outputs::read;
use crate::stream::{Triangles, ran, set, triangles};
use crate::{assert_fails, folder, names, printed, printed_despite_losses, text};

/// A segment in a cell of a lattice: two points with heights that the place decides, and a number of its own for each.
type Segment = [[f64; 4]; 2];

/// Segments that do not cross, some of which begin at a corner that others have, too.
fn segments(count: usize) -> Vec<Segment> {
    let mut random = Random::new(11);
    let height = |x: f64, y: f64| (8.0 * (x / 3.0).sin() * (y / 4.0).cos()).round() / 4.0;
    (0..count)
        .map(|at| {
            let cell = [at % 20, at / 20].map(|place| place as f64);
            let mut part = || random.below(900) as f64 / 1024.0;
            let begin = match at % 3 {
                0 => cell,
                _ => cell.map(|low| low + part()),
            };
            let end = cell.map(|low| low + part());
            [begin, end].map(|[x, y]| [x, y, height(x, y), at as f64])
        })
        .collect()
}

/// Segments as a `.ply` with edges.
fn ply(segments: &[Segment]) -> String {
    let count = segments.len();
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty double id\n\
         element edge {count}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
        2 * count
    );
    for [x, y, z, id] in segments.as_flattened() {
        writeln!(text, "{x} {y} {z} {id}").expect("room");
    }
    for at in 0..count {
        writeln!(text, "{} {}", 2 * at, 2 * at + 1).expect("room");
    }
    text
}

/// A folder with segments in `all.ply`, and dealt out at random in the tiles `0.ply`, `1.ply` and so on, which follow each
/// other as in `all.ply`.
fn tiles(count: usize) -> (TempDir, Vec<Vec<Segment>>) {
    let mut random = Random::new(3);
    let mut tiles = vec![Vec::new(); count];
    for segment in segments(600) {
        tiles[random.below(count)].push(segment);
    }
    let folder = folder(&[("all.ply", &ply(&tiles.concat()))]);
    for (at, tile) in tiles.iter().enumerate() {
        fs::write(folder.path().join(format!("{at}.ply")), ply(tile)).expect("a file");
    }
    (folder, tiles)
}

fn streamed(folder: &TempDir, arguments: &str) -> Triangles {
    let made = ran(folder, &format!("stream {arguments} -o t.u32"));
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    set(triangles(
        &fs::read(folder.path().join("t.u32")).expect("a file"),
        "u32",
    ))
}

#[test]
fn tiles_are_the_file_that_they_were_cut_from() {
    let (folder, _) = tiles(4);
    let tiles = "0.ply 1.ply 2.ply 3.ply";
    for (options, outputs) in [
        ("", &["t.u64"][..]),
        ("--check --window 9", &["t.ply"]),
        ("--memory 20M", &["t.ele", "t.node"]),
        ("--vertices v.f64", &["t.u32", "v.f64"]),
        ("--check", &["t.cert"]),
        (
            "--contours c.geojson --every 0.5 --raster r.asc --cell 0.25",
            &["t.u32", "c.geojson", "r.asc"],
        ),
    ] {
        let [of_tiles, of_all] = [tiles, "all.ply"].map(|inputs| {
            let made = ran(
                &folder,
                &format!("stream {inputs} {options} -o {}", outputs[0]),
            );
            assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
            let found = outputs.iter().map(|name| {
                let bytes = fs::read(folder.path().join(name)).expect("a file");
                fs::remove_file(folder.path().join(name)).expect("a file");
                assert!(bytes.len() > 1000, "{name}");
                bytes
            });
            found.collect::<Vec<_>>()
        });
        assert!(of_tiles == of_all, "{options}");
    }
    for (inputs, bands) in [(tiles, "of-tiles"), ("all.ply", "of-all")] {
        let made = ran(&folder, &format!("stream {inputs} --band 200 -o {bands}"));
        printed_despite_losses(&made);
    }
    let bands = ["of-tiles", "of-all"].map(|name| {
        let path = folder.path().join(name);
        let bands = names(&path)
            .into_iter()
            .map(|name| fs::read(path.join(name)).expect("a file"));
        bands.collect::<Vec<_>>()
    });
    assert!(bands[0].len() == 6 && bands[0] == bands[1]);
}

#[test]
fn tiles_in_another_order_are_the_terrain() {
    let (folder, tiles) = tiles(3);
    let terrain = "--contours c.wkt --every 0.5 --raster r.asc --cell 0.25";
    let expected = streamed(&folder, &format!("all.ply {terrain}"));
    // A closed line may begin at another of its points.
    let sorted = |name| {
        let text = read(&folder, name);
        let points = |line: &str| {
            let line = line.trim_matches(&['(', ')', ','][..]);
            let mut points: Vec<String> = line.split(',').map(str::to_owned).collect();
            points.sort_unstable();
            points.dedup();
            points
        };
        let mut lines: Vec<Vec<String>> = text.lines().map(points).collect();
        lines.sort_unstable();
        lines
    };
    let (lines, grid) = (sorted("c.wkt"), read(&folder, "r.asc"));
    let found = streamed(&folder, &format!("2.ply 1.ply 0.ply {terrain}"));
    assert!(read(&folder, "r.asc") == grid);
    assert!(sorted("c.wkt") == lines && lines.len() > 20);
    // Of equal points either may be named: corners are compared by their places.
    let places = |tiles: Vec<Vec<Segment>>, found: Triangles| {
        let points = tiles.concat();
        let points = points.as_flattened();
        let place = |v: u64| {
            let [x, y, ..] = points[usize::try_from(v).expect("small")];
            [x, y].map(f64::to_bits)
        };
        let mut places: Vec<_> = found
            .into_iter()
            .map(|corners| {
                let mut corners = corners.map(place);
                let least = (0..3).min_by_key(|&i| corners[i]).expect("three");
                corners.rotate_left(least);
                corners
            })
            .collect();
        places.sort_unstable();
        places
    };
    let backwards = tiles.iter().rev().cloned().collect();
    assert!(places(backwards, found) == places(tiles, expected));
}

#[test]
fn several_files_are_verified_as_one() {
    let (folder, _) = tiles(3);
    streamed(&folder, "0.ply 1.ply 2.ply");
    let verdict = |inputs: &str| {
        let made = ran(
            &folder,
            &format!("verify --stream {inputs} t.u32 --level canonical"),
        );
        text(&made.stdout)
            .lines()
            .next()
            .unwrap_or_default()
            .to_owned()
    };
    let right = "is the canonical constrained Delaunay triangulation of";
    assert_eq!(
        verdict("0.ply 1.ply 2.ply"),
        format!("correct: t.u32 {right} 0.ply and 2 others")
    );
    assert!(verdict("all.ply").starts_with("correct: "));
    assert!(verdict("1.ply 0.ply 2.ply").starts_with("wrong: "));
    // Layers in memory.
    let inputs = "0.ply 1.ply 2.ply";
    let made = ran(&folder, &format!("triangulate {inputs} -o t.json"));
    printed_despite_losses(&made);
    let judged = ran(
        &folder,
        &format!("verify {inputs} t.json --level canonical"),
    );
    assert!(
        printed_despite_losses(&judged)
            .starts_with(&format!("correct: t.json {right} 0.ply and 2 others"))
    );
    let record = ran(&folder, &format!("verify {inputs} t.json --json"));
    let record: serde_json::Value = serde_json::from_slice(&record.stdout).expect("JSON");
    assert_eq!(record["input"].as_array().map(Vec::len), Some(3));
    let judged = ran(&folder, "verify 0.ply 1.ply t.json");
    assert_eq!(judged.status.code(), Some(1));
}

#[test]
fn edges_of_a_file_count_the_points_of_all() {
    let numbers = |numbers: &[f64]| {
        numbers
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect::<Vec<u8>>()
    };
    let folder = folder(&[("b.node", "2 2 0 0\n1 0 4\n2 4 4\n")]);
    let write =
        |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).expect("a file");
    write("a.f64", &numbers(&[0.0, 0.0, 4.0, 0.0]));
    write("e.u64", &[1_u64, 2].map(u64::to_le_bytes).concat());
    assert_eq!(
        streamed(&folder, "a.f64 b.node --edges e.u64"),
        [[0, 1, 2], [1, 3, 2]]
    );
    write("e.u64", &[0_u64, 3].map(u64::to_le_bytes).concat());
    assert_eq!(
        streamed(&folder, "a.f64 b.node --edges e.u64"),
        [[0, 1, 3], [0, 3, 2]]
    );
    write("e.u64", &[0_u64, 4].map(u64::to_le_bytes).concat());
    assert_fails(
        &ran(&folder, "stream a.f64 b.node --edges e.u64"),
        "e.u64: edge 0 ends at point 4, which does not exist: the points are numbered from 0 to 3",
    );
    // Points of one file keep its numbers beside edges.
    write("c.node", b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
    write("e.u64", &[0_u64, 2].map(u64::to_le_bytes).concat());
    printed(&ran(&folder, "stream c.node --edges e.u64 -o c.ele"));
    assert!(read(&folder, "c.ele").ends_with("\n1 3 1 2\n"));
}

#[test]
fn heights_and_columns_are_missing_where_a_file_has_none() {
    let folder = folder(&[
        ("a.csv", "x,y,z,a\n0,0,5,1\n1,0,6,2\n"),
        ("b.csv", "x,y,b\n0,1,3\n"),
        ("c.node", "2 2 1 1\n1 1 1 9 4\n2 2 2 8\n"),
        ("d.node", "1 2 0 0\n0 3 0\n"),
    ]);
    printed(&ran(&folder, "stream a.csv b.csv c.node -o t.ele"));
    assert_eq!(
        read(&folder, "t.node"),
        "5 2 4 0\n0 0 0 5 1 NaN NaN\n1 1 0 6 2 NaN NaN\n2 0 1 NaN NaN 3 NaN\n3 1 1 9 NaN NaN 4\n4 2 2 8 NaN NaN NaN\n"
    );
    // Files that all have markers by their formats give markers; they are numbered as the first one.
    printed(&ran(&folder, "stream c.node d.node -o n.ele"));
    assert_eq!(
        read(&folder, "n.node"),
        "3 2 1 1\n1 1 1 9 4\n2 2 2 8 0\n3 3 0 NaN 0\n"
    );
    assert!(read(&folder, "n.ele").contains("3 0\n1 "));
    // A column of text and numbers is none of its file.
    let mut words = "x,y,c\n".to_owned();
    for at in 0..200_000 {
        writeln!(words, "{at},0,{at}").expect("room");
    }
    fs::write(folder.path().join("w.csv"), format!("{words}0,1,high\n")).expect("a file");
    fs::write(folder.path().join("n.csv"), "x,y,c\n5,5,5\n").expect("a file");
    for inputs in ["w.csv n.csv", "n.csv w.csv"] {
        assert_fails(
            &ran(&folder, &format!("stream {inputs} -o w.ply")),
            "w.csv: the column `c` has text in some rows, and numbers in another input",
        );
    }
    printed_despite_losses(&ran(&folder, "stream w.csv a.csv -o w.ply"));
}

#[test]
fn faults_have_the_names_and_numbers_of_their_files() {
    let folder = folder(&[
        ("a.poly", "2 2 0 0\n1 0 0\n2 4 4\n1 0\n1 1 2\n"),
        ("b.poly", "2 2 0 0\n0 0 4\n1 4 0\n2 0\n0 0 0\n1 0 1\n"),
        ("far.poly", "2 2 0 0\n0 9 9\n1 8 9\n1 0\n0 0 2\n"),
        ("attributes.poly", "2 2 2 0\n1 7 7 1 2\n2 8 8 1 2\n0 0\n"),
        ("c.csv", "x,y,name\n5,5,a\n6,6,b\n"),
        ("a.node", "1 2 0 0\n1 0 0\n"),
        ("b.node", "1 2 0 0\n1 1 0\n"),
    ]);
    let nan = [1.0, 1.0, f64::NAN, 0.0].map(f64::to_le_bytes);
    fs::write(folder.path().join("nan.f64"), nan.as_flattened()).expect("a file");
    let advice = "(where memory holds them, `sweep-cdt crossings` lists all that do)";
    for (inputs, error) in [
        ("a.poly b.poly", format!("edge 1 of a.poly and edge 1 of b.poly cross {advice}")),
        ("b.poly a.poly", format!("edge 1 of b.poly and edge 1 of a.poly cross {advice}")),
        // A point of another file is no end of an edge.
        (
            "far.poly b.poly",
            "far.poly: edge 0 ends at point 2, which does not exist: the points are numbered from 0 to 1".to_owned(),
        ),
        (
            "b.poly far.poly",
            "far.poly: edge 0 ends at point 2, which does not exist: the points are numbered from 0 to 1".to_owned(),
        ),
        ("a.poly nan.f64", "nan.f64: point 1 has a coordinate that is not finite".to_owned()),
        ("a.poly gone.csv", "gone.csv: no such file or directory".to_owned()),
        (
            "nan.f64 a.poly --edges nan.f64",
            "a.poly: it has edges itself, and nan.f64 cannot add any".to_owned(),
        ),
        ("a.poly c.csv --class 2", "a.poly: a .poly has no classes of points".to_owned()),
    ] {
        assert_fails(&ran(&folder, &format!("stream {inputs}")), &error);
    }
    let noted = ran(&folder, "stream attributes.poly c.csv -o t.u32");
    assert_eq!(
        text(&noted.stderr),
        "note: attributes.poly: ignored: 2 attributes of each vertex\nnote: c.csv: ignored: 1 column `name`\n\
         note: attributes.poly and c.csv: no triangles: all points lie on one line\n".lines().take(2).map(|line| format!("{line}\n")).collect::<String>()
    );
    for (arguments, error) in [
        (
            "stream - - --stream-format csv",
            "standard input is read once: let one INPUT be `-`",
        ),
        (
            "stream a.node b.node -o a.ele",
            "a.node is an input and would be overwritten",
        ),
        (
            "stream a.node b.node -o b.ele",
            "b.node is an input and would be overwritten",
        ),
    ] {
        let made = ran(&folder, arguments);
        assert_eq!(made.status.code(), Some(2), "{arguments}");
        assert!(
            text(&made.stderr).starts_with(&format!("error: {error}\n")),
            "{}",
            text(&made.stderr)
        );
    }
}

#[cfg(feature = "las")]
#[test]
fn clouds_of_one_system_are_one_terrain() {
    use crate::clouds::cloud;

    let (folder, mut random) = (folder(&[]), Random::new(8));
    let points: Vec<[u32; 4]> = (0..900)
        .map(|at| {
            let [x, y] =
                [random.below(9000), random.below(9000)].map(|x| u32::try_from(x).expect("small"));
            [x, y, x / 3 + y, 1 + at % 2]
        })
        .collect();
    let of_system =
        |srid: &str| format!(r#"PROJCS["a", GEOGCS["b"], AUTHORITY["EPSG", "{srid}"]]"#);
    let write = |name: &str, points: &[[u32; 4]], srid: &str| {
        let system = of_system(srid);
        let bytes = cloud(points.iter().copied(), &[(2112, system.as_bytes())]);
        fs::write(folder.path().join(name), bytes).expect("a file");
    };
    write("all.las", &points, "25832");
    let [first, second, third] = [&points[..100], &points[100..500], &points[500..]];
    write("a.las", first, "25832");
    write("b.las", second, "25832");
    write("c.las", third, "25832");
    write("other.las", third, "25833");
    let outputs = "--class 2 --contours c.geojson --every 1/4 --raster r.asc --cell 0.5";
    let found = streamed(&folder, &format!("a.las b.las c.las {outputs}"));
    let written = ["c.geojson", "r.asc"].map(|name| read(&folder, name));
    assert!(written[0].contains("EPSG::25832"));
    assert!(found == streamed(&folder, &format!("all.las {outputs}")));
    assert!(written == ["c.geojson", "r.asc"].map(|name| read(&folder, name)));
    assert_fails(
        &ran(&folder, "stream a.las b.las other.las"),
        "other.las: the coordinate system is EPSG:25833, and that of a.las is EPSG:25832: files of one input must have the same",
    );
    // Classes are those of clouds; breaklines have none.
    fs::write(folder.path().join("lines.ply"), ply(&segments(9))).expect("a file");
    let made = ran(&folder, "stream a.las lines.ply --class 2 -o t.ply --check");
    assert!(text(&made.stderr).contains("a.las: ") && made.status.success());
}
