//! `sweep-cdt stream --contours --raster`: the lines of `sweep-cdt contours`, and the heights of `sweep-cdt heights`.

use std::fmt::Write;
use std::fs;

use sweep_cdt_testing::Random;
use tempfile::TempDir;

use crate::outputs::read;
use crate::stream::{expected, ran, set, triangles};
use crate::{CONTOURS, assert_fails, folder, names, printed, text, without_losses};

/// Settings that change time and memory, and no line but its place in the file.
const SETTINGS: [&str; 3] = ["", "--window 7 --check", "--memory 16M --window 50"];

/// The lines of a file, sorted.
fn lines(folder: &TempDir, name: &str) -> Vec<String> {
    let text = read(folder, name);
    let lines = text.lines().skip(1);
    let mut lines: Vec<String> = lines
        .map(|line| line.trim_end_matches(&['}', ']', ',', ')'][..]).to_owned())
        .collect();
    lines.sort_unstable();
    lines
}

/// Waves at points of which some are equal, some on rows of halves, and some have no height, as a `.csv`.
fn waves(count: u64) -> String {
    let mut random = Random::new(5);
    let mut text = "x,y,z\n".to_owned();
    for at in 0..count {
        let [x, y] = match at % 4 {
            0 => [random.below(60), random.below(60)].map(|twice| twice as f64 / 2.0),
            _ => [random.below(60_000), random.below(60_000)].map(|x| x as f64 / 2000.0),
        };
        let z = (10.0 * (x / 3.0).sin() * (y / 5.0).cos()).round() / 4.0;
        match at % 97 {
            0 => writeln!(text, "{x},{y},"),
            _ => writeln!(text, "{x},{y},{z}"),
        }
        .expect("room");
    }
    text
}

#[test]
fn contour_lines_are_those_in_memory() {
    let folder = folder(&[("waves.csv", &waves(4000))]);
    let poly = fs::read(CONTOURS).expect("a file");
    fs::write(folder.path().join("lines.poly"), poly).expect("a file");
    for (input, every, name) in [
        ("waves.csv", "0.5", "a.geojson"),
        ("waves.csv", "0.3 --from 0.1", "a.wkt"),
        ("lines.poly", "20 --from 319.37", "a.geojson"),
        ("lines.poly", "20 --from 309.37", "a.wkt"),
    ] {
        let made = ran(
            &folder,
            &format!("contours {input} --every {every} -o {name}"),
        );
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        let in_memory = lines(&folder, name);
        assert!(in_memory.len() > 50);
        for settings in SETTINGS {
            let arguments = format!("stream {input} --contours {name} --every {every} {settings}");
            let streamed = ran(&folder, &format!("{arguments} -o t.u32"));
            assert_eq!(
                streamed.status.code(),
                Some(0),
                "{}",
                text(&streamed.stderr)
            );
            assert!(lines(&folder, name) == in_memory, "{arguments}");
            // The summary, and what is said of the triangles, are those of `contours`.
            let counts = |output: &str| output.split("levels ").nth(1).map(str::to_owned);
            let printed = text(&streamed.stdout).lines().next().unwrap_or_default();
            assert_eq!(counts(printed), counts(text(&made.stdout).trim_end()));
            let said = text(&made.stderr)
                .lines()
                .filter(|line| line.contains("have a corner"));
            let also = text(&streamed.stderr)
                .lines()
                .filter(|line| line.contains("have a corner"));
            assert!(said.eq(also));
            // The triangles keep the numbers of the input.
            let found = fs::read(folder.path().join("t.u32")).expect("a file");
            assert!(set(triangles(&found, "u32")) == expected(&folder, input));
        }
    }
    // Where the lines that wait are too long, it is said.
    let parts = ran(
        &folder,
        "stream lines.poly --contours a.wkt --every 20 --memory 2M",
    );
    assert!(text(&parts.stdout).ends_with(" (more --memory holds longer lines)\n"));
}

/// The numbers in the rows of a grid, from above, and its lower left corner.
fn grid(folder: &TempDir, name: &str) -> (Vec<Vec<f64>>, [f64; 2]) {
    let text = read(folder, name);
    let numbers = |line: &str| {
        let words = line.split(' ').map(str::parse::<f64>);
        words.filter_map(Result::ok).collect::<Vec<f64>>()
    };
    let head: Vec<f64> = text.lines().take(6).map(|line| numbers(line)[0]).collect();
    let rows: Vec<Vec<f64>> = text.lines().skip(6).map(numbers).collect();
    let size = [rows[0].len(), rows.len()].map(|size| size as f64);
    assert_eq!(head[..2], size);
    assert!(rows.iter().all(|row| row.len() == rows[0].len()));
    (rows, [head[2], head[3]])
}

#[test]
fn grids_have_the_heights_at_their_centres() {
    let folder = folder(&[("waves.csv", &waves(3000))]);
    for cell in ["1", "0.3"] {
        let size: f64 = cell.parse().expect("a number");
        for settings in ["", "--memory 400K --window 20", "--window 9 -o t.ele"] {
            let output = ran(
                &folder,
                &format!("stream waves.csv --raster a.asc --cell {cell} {settings}"),
            );
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            let (rows, [left, low]) = grid(&folder, "a.asc");
            let mut centers = "x,y\n".to_owned();
            let mut found = Vec::new();
            let first = [left, low].map(|corner| (corner / size).round());
            for (from_above, row) in rows.iter().enumerate() {
                for (column, height) in row.iter().enumerate() {
                    let at = [column as f64, (rows.len() - 1 - from_above) as f64];
                    let [x, y] = [0, 1].map(|i| (2.0 * (first[i] + at[i]) + 1.0) * (size / 2.0));
                    writeln!(centers, "{x},{y}").expect("room");
                    found.push(*height);
                }
            }
            fs::write(folder.path().join("at.csv"), centers).expect("a file");
            let heights = ran(&folder, "heights waves.csv --at at.csv -o heights.csv");
            assert_eq!(heights.status.code(), Some(0), "{}", text(&heights.stderr));
            let heights = read(&folder, "heights.csv");
            let heights = heights.lines().skip(1).map(|row| {
                let height = row.split(',').nth(2).expect("three columns");
                height.parse().unwrap_or(f64::NAN)
            });
            let heights = heights.map(|height: f64| if height.is_nan() { -9999.0 } else { height });
            let heights: Vec<u64> = heights.map(f64::to_bits).collect();
            assert!(heights.iter().any(|&bits| bits == (-9999.0_f64).to_bits()));
            let found: Vec<u64> = found.into_iter().map(f64::to_bits).collect();
            assert!(found == heights, "{cell} {settings}");
        }
    }
}

/// Triangles in memory make the grid of a stream, bit for bit.
#[test]
fn grids_in_memory_are_those_of_streams() {
    let folder = folder(&[
        ("waves.csv", &waves(3000)),
        ("at.csv", "x,y\n5,5\n"),
        ("one.csv", "x,y,z\n3,4,5\n"),
        (
            "square.poly",
            "5 2 1 0\n1 0 0 0\n2 4 0 0\n3 4 4 4\n4 0 4 4\n5 6 2 9\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n",
        ),
        (
            "third.poly",
            "3 2 1 0\n1 0 0 1\n2 1/3 0 1\n3 0 1 1\n0 0\n0\n",
        ),
    ]);
    fs::copy(CONTOURS, folder.path().join("lines.poly")).expect("a file");
    let ends = match cfg!(feature = "geotiff") {
        true => &["asc", "tif"][..],
        false => &["asc"],
    };
    for (inputs, cell) in [
        ("waves.csv", "1"),
        ("waves.csv", "0.3"),
        ("lines.poly", "7"),
        ("one.csv", "2"),
        ("waves.csv one.csv", "0.5"),
    ] {
        for end in ends {
            let grid = |arguments: &str| {
                let grid = format!("--raster a.{end} --cell {cell}");
                let output = ran(&folder, &format!("{arguments} {grid}"));
                assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
                let bytes = fs::read(folder.path().join(format!("a.{end}"))).expect("a file");
                fs::remove_file(folder.path().join(format!("a.{end}"))).expect("a file");
                bytes
            };
            let streamed = grid(&format!("stream {inputs}"));
            assert!(
                streamed == grid(&format!("heights {inputs}")),
                "{inputs} {end}"
            );
            let beside = grid(&format!("heights {inputs} --at at.csv -o a.csv"));
            assert!(streamed == beside, "{inputs} {end}");
        }
    }
    // Outside of what is asked for there are no heights.
    let inside = "heights square.poly --inside even-odd --raster a.asc --cell 2";
    assert_eq!(printed(&ran(&folder, inside)), "");
    let rows = read(&folder, "a.asc");
    let rows: Vec<&str> = rows.lines().skip(6).collect();
    assert_eq!(rows, ["3 3 -9999", "1 1 -9999"]);
    let fraction = ran(&folder, "heights third.poly --raster a.asc --cell 1");
    assert_fails(
        &fraction,
        "third.poly: there are fractions, and a grid is made of doubles",
    );
    for (arguments, what) in [
        ("", "--at <POINTS>"),
        ("--raster a.asc", "--cell <SIZE>"),
        ("--raster a.asc --cell 1 -o b.csv", "--at <POINTS>"),
        ("--raster a.asc --cell 1 --within 3", "--at <POINTS>"),
        (
            "--raster r.asc --cell 1 --at at.csv -o r.asc --output-format csv",
            "the same file",
        ),
        ("--raster a.obj --cell 1", "let it end in .asc"),
    ] {
        let output = ran(&folder, &format!("heights one.csv {arguments}"));
        let said = text(&output.stderr);
        assert!(said.contains(what), "{arguments}: {said}");
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
    }
}

/// What the file says is tested where it is written.
#[cfg(feature = "geotiff")]
#[test]
fn grids_are_written_as_geotiff() {
    let folder = folder(&[("waves.csv", &waves(300))]);
    let arguments = "stream waves.csv --temporary . --raster a.tif --cell 1";
    let output = ran(&folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let bytes = fs::read(folder.path().join("a.tif")).expect("a file");
    assert!(
        bytes.starts_with(b"II*\0") && bytes.len() > 30 * 30 * 8,
        "{}",
        bytes.len()
    );
}

#[test]
fn one_place_with_two_heights_has_the_first() {
    // The third point equals the first one, and the last one the second, which has no height.
    let folder = folder(&[(
        "a.node",
        "5 2 1 0\n1 0 0 1\n2 4 0 nan\n3 0 0 7\n4 0 4 5\n5 4 0 1\n",
    )]);
    let arguments = "stream a.node --contours a.wkt --every 2 --from 1";
    let output = ran(&folder, arguments);
    let note = "note: a.node: vertex 1 has two numbers for z, 1 and 7: 1 counts\n";
    assert_eq!(without_losses(&output.stderr), note);
    assert_eq!(
        text(&output.stdout),
        "a.node: heights 1 to 7, levels 4, lines 1, closed 0\n"
    );
    assert_eq!(
        read(&folder, "a.wkt"),
        "MULTILINESTRING Z (\n(0 2 3,2 2 3))\n"
    );
    let refused = ran(&folder, &format!("{arguments} --strict"));
    let said = "vertex 1 has two numbers for z, 1 and 7: 1 counts; --strict refuses that";
    assert_fails(&refused, &format!("a.node: {said}"));
}

#[test]
fn a_number_may_mean_that_there_is_no_height() {
    let mut rows = waves(500);
    for at in 0..40 {
        writeln!(rows, "{at}.25,{at}.75,-9999").expect("room");
    }
    let folder = folder(&[
        ("a.csv", &rows),
        (
            "b.node",
            "3 2 2 1\n1 0 0 7 -1 -1\n2 1 0 -1 3 4\n3 0 1 5 6 -1\n",
        ),
    ]);
    let hint = "note: a.csv: 40 heights are -9999, which often means that there is none (--no-value takes a number for that)\n";
    let grid = "--raster a.asc --cell 0.5";
    let hinted = ran(&folder, &format!("stream a.csv {grid}"));
    assert!(text(&hinted.stderr).contains(hint));
    let count = "note: a.csv: 40 numbers are -9999 and counted as missing\n";
    let [streamed, in_memory] = ["stream", "heights"].map(|command| {
        let output = ran(&folder, &format!("{command} a.csv --no-value -9999 {grid}"));
        assert!(
            text(&output.stderr).contains(count),
            "{}",
            text(&output.stderr)
        );
        assert!(!text(&output.stderr).contains("often means"));
        read(&folder, "a.asc")
    });
    assert!(streamed == in_memory && streamed.contains("NODATA_value -9999\n"));
    // Markers keep theirs.
    let output = ran(&folder, "stream b.node --no-value -1 -o t.ele");
    assert_eq!(
        text(&output.stderr),
        "note: b.node: 2 numbers are -1 and counted as missing\n"
    );
    let expected = "3 2 2 1\n1 0 0 7 NaN -1\n2 1 0 NaN 3 4\n3 0 1 5 6 -1\n";
    assert_eq!(read(&folder, "t.node"), expected);
    let unread = ran(&folder, "stream b.node --no-value -1 -o t.u32");
    assert!(!text(&unread.stderr).contains("numbers are"));
}

#[test]
fn a_ply_keeps_the_heights_of_its_points() {
    let folder = folder(&[("a.xyz", "0 0 5\n1 0 nan\n0 1 7.5\n")]);
    assert_eq!(printed(&ran(&folder, "stream a.xyz -o a.ply")), "");
    let bytes = fs::read(folder.path().join("a.ply")).expect("a file");
    let end = bytes
        .windows(11)
        .position(|some| some == b"end_header\n")
        .expect("a header");
    let numbers = bytes[end + 11..].as_chunks().0;
    let heights = [2, 5, 8].map(|at| f64::from_le_bytes(numbers[at]));
    assert_eq!(format!("{heights:?}"), "[5.0, NaN, 7.5]");
}

#[test]
fn lines_up_to_where_too_much_is_alive_are_incomplete() {
    let mut text = "x,y,z\n".to_owned();
    for at in 0..400 {
        let angle = f64::from(at) / 400.0 * std::f64::consts::TAU;
        writeln!(text, "{},{},{}", angle.cos(), angle.sin(), at % 7).expect("room");
    }
    let folder = folder(&[("a.csv", &text)]);
    let arguments = "stream a.csv --memory 60K --window 10 --contours a.geojson --every 1 --raster a.asc --cell 0.1";
    let output = ran(&folder, arguments);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(
        names(folder.path()),
        ["a.asc.incomplete", "a.csv", "a.geojson.incomplete"]
    );
    let lines = read(&folder, "a.geojson.incomplete");
    assert!(serde_json::from_str::<serde_json::Value>(&lines).is_ok());
}

#[test]
fn terrain_that_cannot_be_is_refused() {
    let folder = folder(&[
        ("a.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n"),
        ("flat.xyz", "0 0\n1 0\n0 1\n"),
    ]);
    let flat = ran(&folder, "stream flat.xyz --contours a.wkt --every 1");
    let said = text(&flat.stderr);
    assert!(
        said.starts_with("error: flat.xyz: the vertices have no heights: "),
        "{said}"
    );
    let small = ran(&folder, "stream a.csv --raster a.asc --cell 1e-300");
    assert_fails(
        &small,
        "a.csv: the cells of the grid are too small: choose a larger --cell",
    );
    let large = ran(&folder, "stream a.csv --raster a.asc --cell 0.000001");
    assert_fails(
        &large,
        "a.csv: the grid would have 1000000000000 cells, and at most 10000000000 are made: choose a larger --cell",
    );
    let many = ran(&folder, "stream a.csv --contours a.wkt --every 1e-9");
    assert!(text(&many.stderr).contains("more than 1000000 levels"));
    for (arguments, what) in [
        ("--contours a.wkt", "--every"),
        ("--every 1", "--contours"),
        (
            "--contours a.wkt --every 0",
            "levels must be more than 0 apart",
        ),
        (
            "--contours a.obj --every 1",
            "a.obj is no name for contour lines: let it end in .geojson or .wkt",
        ),
        ("--raster a.asc", "--cell"),
        (
            "--raster a.asc --raster b.asc --cell 1",
            "cannot be used multiple times",
        ),
        (
            "--contours a.wkt --contours b.wkt --every 1",
            "cannot be used multiple times",
        ),
        ("--raster a.png --cell 1", "let it end in .asc"),
        ("--raster a.asc --cell=-1", "greater than 0"),
        ("--raster a.asc --cell nan", "greater than 0"),
        (
            "--raster a.asc --cell 1 --band 3 -o b",
            "cannot be used with",
        ),
        ("--contours a.wkt --every 1 --vertices v.f64", "--output"),
    ] {
        let output = ran(&folder, &format!("stream a.csv {arguments}"));
        let said = text(&output.stderr);
        assert!(said.contains(what), "{arguments}: {said}");
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
    }
    assert_eq!(names(folder.path()), ["a.csv", "flat.xyz"]);
}
