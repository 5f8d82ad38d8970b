//! `.las` and `.laz`: clouds of points are read wherever points are, with their heights, classes and coordinate system.

use std::fs;

use tempfile::TempDir;

use crate::outputs::read;
use crate::stream::ran;
use crate::{assert_fails, folder, names, printed, text};

/// The ground and a roof above it: x, y, z and class of each point, in thousandths.
const POINTS: [[u32; 4]; 6] = [
    [0, 0, 0, 2],
    [4000, 0, 4000, 2],
    [2000, 1000, 90_000, 6],
    [0, 4000, 0, 2],
    [4000, 4000, 4000, 2],
    [2000, 3000, 90_000, 6],
];
const GROUND: &str = "x,y,z\n0,0,0\n4,0,4\n0,4,0\n4,4,4\n";
const ALL: &str = "x,y,z\n0,0,0\n4,0,4\n2,1,90\n0,4,0\n4,4,4\n2,3,90\n";

/// A cloud in the simplest version: x, y, z and class of each point, in thousandths, and records before them, each with
/// its number.
pub(crate) fn cloud(points: impl Iterator<Item = [u32; 4]>, records: &[(u16, &[u8])]) -> Vec<u8> {
    let mut bytes = vec![0; 227];
    bytes[..4].copy_from_slice(b"LASF");
    bytes[24..26].copy_from_slice(&[1, 2]);
    bytes[94] = 227;
    bytes[100] = u8::try_from(records.len()).expect("few");
    bytes[105] = 20;
    for axis in 0..3 {
        bytes[131 + 8 * axis..][..8].copy_from_slice(&0.001_f64.to_le_bytes());
    }
    for (number, data) in records {
        let mut head = [0; 54];
        head[2..17].copy_from_slice(b"LASF_Projection");
        head[18..20].copy_from_slice(&number.to_le_bytes());
        let length = u16::try_from(data.len()).expect("short");
        head[20..22].copy_from_slice(&length.to_le_bytes());
        bytes.extend(head);
        bytes.extend_from_slice(data);
    }
    let begin = u32::try_from(bytes.len()).expect("short");
    bytes[96..100].copy_from_slice(&begin.to_le_bytes());
    let mut count = 0_u32;
    for [x, y, z, class] in points {
        let class = [0, 0, 0, u8::try_from(class).expect("a class"), 0, 0, 0, 0];
        bytes.extend([x, y, z].map(u32::to_le_bytes).as_flattened());
        bytes.extend(class);
        count += 1;
    }
    bytes[107..111].copy_from_slice(&count.to_le_bytes());
    bytes
}

/// A folder with the cloud and the points of each class as text.
fn clouds() -> TempDir {
    let folder = folder(&[
        ("ground.csv", GROUND),
        ("all.csv", ALL),
        ("at.csv", "x,y\n1,1\n3,2\n"),
        ("line.wkt", "LINESTRING Z (1 2 1, 3 2 3)"),
        ("part.wkt", "POLYGON ((0 0, 2 0, 2 4, 0 4, 0 0))"),
    ]);
    fs::write(folder.path().join("a.las"), cloud(POINTS.into_iter(), &[])).expect("a file");
    folder
}

#[test]
fn clouds_are_read_wherever_points_are() {
    let folder = clouds();
    for arguments in [
        "triangulate INPUT -o - --output-format vtu",
        "triangulate INPUT line.wkt -o - --output-format json",
        "triangulate line.wkt INPUT -o - --output-format json",
        "heights INPUT --at at.csv",
        "heights all.csv --at INPUT -o - --output-format vtu",
        "contours INPUT --every 0.7 -o - --output-format wkt",
        "refine INPUT --max-area 1 -o - --output-format ply",
        "voronoi INPUT -o - --output-format geojson",
        "voronoi INPUT --clip part.wkt -o - --output-format geojson",
        "crossings INPUT",
        "trace INPUT",
    ] {
        for (table, classes) in [
            ("all.csv", ""),
            ("ground.csv", "--class 2"),
            ("all.csv", "--class 6,2"),
        ] {
            let classes = if arguments.contains("--at INPUT") {
                ""
            } else {
                classes
            };
            let table = if classes.is_empty() { "all.csv" } else { table };
            let from_text = ran(&folder, &arguments.replace("INPUT", table));
            let arguments = arguments.replace("INPUT", "a.las");
            let from_cloud = ran(&folder, &format!("{arguments} {classes}"));
            let [expected, made] = [&from_text, &from_cloud].map(|output| text(&output.stdout));
            assert_eq!(
                from_cloud.status.code(),
                Some(0),
                "{}",
                text(&from_cloud.stderr)
            );
            assert_eq!(
                made.replace("a.las", table),
                expected,
                "{arguments} {classes}"
            );
            assert!(!expected.is_empty());
        }
    }
}

#[test]
fn results_of_clouds_are_verified() {
    let folder = clouds();
    for classes in ["", "--class 2"] {
        let made = ran(&folder, &format!("triangulate a.las {classes} -o r.json"));
        assert_eq!(made.status.code(), Some(0));
        let judged = ran(&folder, &format!("verify a.las r.json {classes}"));
        let judged = text(&judged.stdout);
        assert!(judged.starts_with("correct: "), "{judged}");
        let made = ran(&folder, &format!("stream a.las {classes} -o t.u32"));
        assert_eq!(made.status.code(), Some(0));
        let judged = ran(&folder, &format!("verify --stream a.las t.u32 {classes}"));
        assert!(printed(&judged).starts_with("correct: "));
    }
}

/// All clouds have classes and more, which nobody asked for: a strict run refuses what else gets lost.
#[test]
fn strict_runs_take_clouds() {
    let folder = clouds();
    let system = (2112, &br#"PROJCS["a", AUTHORITY["EPSG", "25832"]]"#[..]);
    fs::write(
        folder.path().join("system.las"),
        cloud(POINTS.into_iter(), &[system]),
    )
    .expect("a file");
    let mut withheld = cloud(POINTS.into_iter(), &[]);
    withheld[227 + 15] |= 1 << 7;
    fs::write(folder.path().join("withheld.las"), withheld).expect("a file");
    let note = "note: a.las: ignored: 6 classes, and all else that points have beside places and heights\n";
    for arguments in [
        "triangulate a.las",
        "triangulate a.las -o t.obj",
        "stream a.las -o t.ply",
        "stream a.las --raster t.asc --cell 1",
        "contours a.las --every 1 -o t.wkt",
    ] {
        let output = ran(&folder, &format!("{arguments} --strict"));
        assert_eq!(text(&output.stderr), note, "{arguments}");
        assert_eq!(output.status.code(), Some(0), "{arguments}");
    }
    for (arguments, lost) in [
        ("stream a.las -o t.u32", "a.las: ignored: 6 heights"),
        (
            "stream system.las --raster t.asc --cell 1",
            "t.asc: not written: the coordinate system EPSG:25832",
        ),
        (
            "triangulate withheld.las",
            "withheld.las: ignored: 1 point that is withheld",
        ),
    ] {
        let output = ran(&folder, &format!("{arguments} --strict"));
        let refused = format!("error: {lost}; --strict refuses that\n");
        assert!(
            text(&output.stderr).ends_with(&refused),
            "{}",
            text(&output.stderr)
        );
        assert_eq!(output.status.code(), Some(1), "{arguments}");
    }
}

#[test]
fn notes_on_clouds_are_those_of_streams() {
    let folder = clouds();
    let output = ran(&folder, "triangulate a.las --class 2,9");
    assert_eq!(
        text(&output.stderr),
        "note: a.las: 4 of 6 points are of the classes that were chosen: 4 are of class 2, 2 of class 6\n\
         note: a.las: ignored: 6 classes, and all else that points have beside places and heights\n"
    );
    let mut bytes = cloud(POINTS.into_iter(), &[]);
    bytes[107..111].fill(0);
    fs::write(folder.path().join("none.las"), bytes).expect("a file");
    let output = ran(&folder, "triangulate none.las");
    assert!(
        text(&output.stderr).starts_with(
            "note: none.las: the header says that there are 0 points, and 120 bytes follow\n"
        ),
        "{}",
        text(&output.stderr)
    );
}

/// A stream and a triangulation were empty, and contours and heights blamed something else.
#[test]
fn classes_that_no_point_has_are_refused() {
    let folder = clouds();
    for (command, classes, what) in [
        ("stream a.las -o r.u32", "5", "5"),
        ("triangulate a.las -o r.json", "5", "5"),
        ("contours a.las --every 1 -o r.wkt", "5,0", "5 or 0"),
        ("heights a.las --at at.csv -o r.csv", "5", "5"),
        ("triangulate line.wkt a.las -o r.json", "5", "5"),
    ] {
        let output = ran(&folder, &format!("{command} --class {classes}"));
        let what =
            format!("error: a.las: no point is of class {what}: 4 are of class 2, 2 of class 6\n");
        let said = text(&output.stderr);
        assert!(said.ends_with(&what), "{command}: {said}");
        assert_eq!(output.status.code(), Some(1));
        let names = names(folder.path());
        assert!(
            !names.iter().any(|name| name.starts_with("r.")),
            "{names:?}"
        );
    }
    let points = (0..15).map(|class| [class, class % 2, 0, class]);
    fs::write(folder.path().join("all.las"), cloud(points, &[])).expect("a file");
    let output = ran(&folder, "triangulate all.las --class 31");
    let said = text(&output.stderr);
    assert!(
        said.contains("31: 1 is of class 0, 1 of class 1, "),
        "{said}"
    );
    assert!(said.contains(", 1 of class 11, 3 of others\n"), "{said}");
}

/// Points with the highest bit beside their class are withheld.
#[test]
fn points_that_are_withheld_are_left_out() {
    let folder = clouds();
    let withheld = POINTS.map(|[x, y, z, class]| [x, y, z, class | u32::from(class == 6) << 7]);
    fs::write(
        folder.path().join("a.las"),
        cloud(withheld.into_iter(), &[]),
    )
    .expect("a file");
    for command in ["triangulate INPUT -o - --output-format json", "trace INPUT"] {
        let from_text = ran(&folder, &command.replace("INPUT", "ground.csv"));
        let from_cloud = ran(&folder, &command.replace("INPUT", "a.las"));
        let expected = text(&from_text.stdout).replace("ground.csv", "a.las");
        assert_eq!(text(&from_cloud.stdout), expected);
    }
    for command in ["triangulate a.las", "stream a.las -o r.u32"] {
        let output = ran(&folder, &format!("{command} --class 2"));
        let said = text(&output.stderr);
        for what in [
            "4 of 4 points are of the classes that were chosen: 4 are of class 2\n",
            "note: a.las: ignored: 2 points that are withheld",
        ] {
            assert_eq!(said.matches(what).count(), 1, "{said}");
        }
    }
    let output = ran(&folder, "triangulate a.las --class 6");
    assert_fails(
        &output,
        "a.las: no point is of class 6: 4 are of class 2, 2 withheld",
    );
}

#[test]
fn what_is_no_cloud_has_no_classes() {
    let folder = clouds();
    for arguments in [
        "triangulate all.csv",
        "triangulate line.wkt all.csv",
        "stream all.csv",
    ] {
        let output = ran(&folder, &format!("{arguments} --class 2"));
        let file = if arguments.contains("line") {
            "line.wkt: a .wkt"
        } else {
            "all.csv: a .csv"
        };
        assert_fails(&output, &format!("{file} has no classes of points"));
    }
    fs::write(
        folder.path().join("b.las"),
        &cloud(POINTS.into_iter(), &[])[..300],
    )
    .expect("a file");
    let output = ran(&folder, "triangulate b.las -o b.json");
    assert_fails(
        &output,
        "b.las: it has 300 bytes, and 6 points take more: it is cut off",
    );
    assert!(!names(folder.path()).contains(&"b.json".to_owned()));
}

/// The numbers of the EPSG in records of a cloud: keys of `GeoTIFF`, and the text of a compound system.
#[test]
fn systems_of_clouds_go_along() {
    let folder = clouds();
    let keys = |numbers: &[u16]| -> Vec<u8> {
        numbers
            .iter()
            .flat_map(|number| number.to_le_bytes())
            .collect()
    };
    let plane = keys(&[1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 25832]);
    let globe = keys(&[1, 1, 0, 2, 1024, 0, 1, 2, 2048, 0, 1, 4258]);
    let own = keys(&[1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 32767]);
    let compound = br#"COMPD_CS["UTM [32], both",PROJCS["UTM",GEOGCS["ETRS89",AUTHORITY["EPSG","4258"]],AUTHORITY["EPSG","25832"]],VERT_CS["z",AUTHORITY["EPSG","5783"]],AUTHORITY["EPSG","5554"]]"#;
    let nameless = br#"PROJCS["own",GEOGCS["ETRS89",AUTHORITY["EPSG","4258"]]]"#;
    for (record, data, number) in [
        (34735, &plane[..], Some(25832)),
        (34735, &globe, Some(4258)),
        (34735, &own, None),
        (2112, compound, Some(25832)),
        (2112, nameless, None),
    ] {
        let bytes = cloud(POINTS.into_iter(), &[(record, data)]);
        fs::write(folder.path().join("b.las"), bytes).expect("a file");
        let system = number.map(|number| format!("SRID={number};"));
        let system = system.unwrap_or_default();
        for arguments in [
            "triangulate b.las -o c.wkt",
            "stream b.las --contours c.wkt --every 1",
        ] {
            let output = ran(&folder, arguments);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            let written = read(&folder, "c.wkt");
            assert_eq!(written.starts_with("SRID="), number.is_some(), "{written}");
            assert!(written.starts_with(&system), "{written}");
        }
        let output = ran(&folder, "stream b.las --raster c.asc --cell 1");
        let lost = "note: c.asc: not written: the coordinate system EPSG:";
        assert_eq!(text(&output.stderr).contains(lost), number.is_some());
    }
}

/// A tile of water alone does not end a run over many.
#[test]
fn a_tile_without_points_of_the_class_is_left_out() {
    let folder = clouds();
    let water = [[0, 0, 0, 9], [9000, 9000, 0, 9]];
    for (name, points) in [("water.las", &water[..]), ("empty.las", &[])] {
        let bytes = cloud(points.iter().copied(), &[]);
        fs::write(folder.path().join(name), bytes).expect("a file");
    }
    let grid = |tiles: &str| {
        let arguments = format!("stream {tiles} --class 2 --raster r.asc --cell 0.25");
        ran(&folder, &arguments)
    };
    for tiles in ["a.las", "water.las a.las empty.las"] {
        let made = grid(tiles);
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        fs::rename(folder.path().join("r.asc"), folder.path().join(&tiles[..1])).expect("a grid");
    }
    let [alone, among] = ["a", "w"].map(|name| fs::read(folder.path().join(name)).expect("a grid"));
    assert_eq!(alone, among);
    let said = grid("water.las a.las");
    assert!(
        text(&said.stderr).contains("water.las: 0 of 2 points are of the classes that were chosen"),
        "{}",
        text(&said.stderr)
    );
    for (tiles, why) in [
        (
            "water.las",
            "water.las: no point is of class 2: 2 are of class 9",
        ),
        (
            "water.las empty.las",
            "water.las and empty.las: there are no points",
        ),
        ("empty.las", "empty.las: there are no points"),
    ] {
        let made = grid(tiles);
        assert!(
            text(&made.stderr).ends_with(&format!("error: {why}\n")),
            "{}",
            text(&made.stderr)
        );
        assert_eq!(made.status.code(), Some(1));
    }
    let made = ran(&folder, "contours empty.las --every 1");
    assert_eq!(
        text(&made.stderr),
        "error: empty.las: there are no points\n"
    );
}

/// No result names the system of one file for the places of another, or none without a word.
#[test]
fn systems_that_differ_or_get_lost_are_said() {
    let folder = clouds();
    let of = |text: &'static [u8]| [(2112_u16, text)];
    let points = [[0, 0, 0, 2], [9000, 0, 9000, 2], [0, 9000, 3000, 2]];
    for (name, record) in [
        ("n.las", of(br#"PROJCS["a", AUTHORITY["EPSG", "25832"]]"#)),
        ("e.las", of(br#"PROJCS["ETRS_1989_UTM_Zone_32N"]"#)),
    ] {
        let bytes = cloud(points.into_iter(), &record);
        fs::write(folder.path().join(name), bytes).expect("a file");
    }
    let places = r#"{"type":"Feature","properties":null,"crs":{"type":"name","properties":{"name":"EPSG:25833"}},
        "geometry":{"type":"Point","coordinates":[1,1]}}"#;
    fs::write(folder.path().join("p.geojson"), places).expect("a file");
    let made = ran(&folder, "heights n.las --at p.geojson -o h.geojson");
    let why = "error: p.geojson: the coordinate system is EPSG:25833, and that of n.las is EPSG:25832: files of one input must \
               have the same\n";
    assert!(text(&made.stderr).ends_with(why), "{}", text(&made.stderr));
    let why = "t.ply: not written: the coordinate system EPSG:25832\n";
    let made = ran(&folder, "stream n.las -o t.ply");
    assert!(text(&made.stderr).ends_with(why), "{}", text(&made.stderr));
    let why = "e.las: ignored: 1 coordinate system, which has no number of the EPSG\n";
    for command in ["stream e.las -o t.ply", "triangulate e.las -o t.obj"] {
        let made = ran(&folder, command);
        assert!(text(&made.stderr).contains(why), "{}", text(&made.stderr));
    }
}
