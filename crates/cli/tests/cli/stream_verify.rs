//! `sweep-cdt verify --stream`: right triangles in any order are accepted, and every damage is refused.

use std::collections::BTreeSet;
use std::fs;

use sweep_cdt_testing::Random;
use tempfile::TempDir;

use crate::stream::{Triangles, ran};
use crate::{FORMATS, assert_fails, folder, printed, printed_despite_losses, text};

/// A folder with the triangles of `ten.poly`, and these.
fn with_triangles() -> (TempDir, Triangles) {
    let folder = folder(&[]);
    let output = ran(&folder, &format!("stream {FORMATS}/ten.poly -o t.u64"));
    assert_eq!(printed_despite_losses(&output), "");
    let bytes = fs::read(folder.path().join("t.u64")).expect("a file");
    let (numbers, _) = bytes.as_chunks();
    let numbers: Vec<u64> = numbers
        .iter()
        .map(|&number| u64::from_le_bytes(number))
        .collect();
    (folder, numbers.as_chunks().0.to_vec())
}

/// The verdict on these triangles in place of those of `ten.poly`, in numbers of 64 and of 32 bits.
fn judged(folder: &TempDir, triangles: &[[u64; 3]], options: &str) -> (Option<i32>, String) {
    let numbers = triangles.as_flattened().iter();
    let wide: Vec<u8> = numbers
        .clone()
        .flat_map(|number| number.to_le_bytes())
        .collect();
    let narrow = |&number: &u64| u32::try_from(number).unwrap_or(u32::MAX).to_le_bytes();
    let narrow: Vec<u8> = numbers.flat_map(narrow).collect();
    let verdicts = [("w.u64", wide), ("w.u32", narrow)].map(|(name, bytes)| {
        fs::write(folder.path().join(name), bytes).expect("a file");
        let arguments = format!("verify --stream {FORMATS}/ten.poly {name} {options}");
        let output = ran(folder, &arguments);
        assert_eq!(text(&output.stderr), "");
        let report = text(&output.stdout).replace(name, "w");
        (output.status.code(), report.replace(FORMATS, ""))
    });
    let [wide, narrow] = verdicts;
    // At which of several vertices a border is wrong is not the same each time.
    let words = |report: &str| {
        let border = report.split_once(", as shows at vertex ");
        border.map_or(report, |(words, _)| words).to_owned()
    };
    assert_eq!((wide.0, words(&wide.1)), (narrow.0, words(&narrow.1)));
    wide
}

#[track_caller]
fn assert_accepted(folder: &TempDir, triangles: &[[u64; 3]], options: &str) {
    let (status, report) = judged(folder, triangles, options);
    assert!(
        report.starts_with("correct: w is "),
        "{triangles:?}\n{report}"
    );
    assert_eq!(status, Some(0));
}

/// Asserts that triangles are refused, and returns why.
#[track_caller]
fn refused(folder: &TempDir, triangles: &[[u64; 3]], options: &str) -> String {
    let (status, report) = judged(folder, triangles, options);
    let why = report.strip_prefix("wrong: w is not ");
    assert!(why.is_some(), "{triangles:?}\n{report}");
    assert_eq!(status, Some(1));
    why.unwrap_or_default().to_owned()
}

#[test]
fn the_report_of_a_right_result() {
    let (folder, triangles) = with_triangles();
    let (mut open, mut most) = (BTreeSet::new(), 0);
    for [a, b, c] in triangles {
        for [u, v] in [[a, b], [b, c], [c, a]] {
            let side = [u.min(v), u.max(v)];
            if !open.remove(&side) {
                open.insert(side);
            }
        }
        most = most.max(open.len());
    }
    let input = format!("{FORMATS}/ten.poly");
    let hull = open.len();
    let report = format!(
        "\
correct: t.u64 is a constrained Delaunay triangulation of {input}

points                            10
edges                              5
triangles                         12
sides of the hull     {hull:>14}
vertices kept at most             10
sides kept at most    {most:>14}
"
    );
    let output = ran(&folder, &format!("verify --stream {input} t.u64"));
    assert_eq!(printed(&output), report);
}

#[test]
fn triangles_come_in_any_order_and_from_any_corner() {
    let (folder, mut triangles) = with_triangles();
    for i in 0..triangles.len() {
        triangles.rotate_left(1);
        triangles[i].rotate_left(1);
        assert_accepted(&folder, &triangles, "--level canonical");
    }
    triangles.reverse();
    assert_accepted(&folder, &triangles, "--memory 20K");
}

#[test]
fn every_damage_is_refused() {
    let (folder, right) = with_triangles();
    let mut seen_at_once = 0;
    for (at, &corners) in right.iter().enumerate() {
        let with = |triangle: [u64; 3]| {
            let mut triangles = right.clone();
            triangles[at] = triangle;
            refused(&folder, &triangles, "")
        };
        let [a, b, c] = corners;
        assert!(with([b, a, c]).contains(" does not turn left"));
        assert!(with([a, b, b]).contains(" does not turn left"));
        with([(a + 1) % 10, b, c]);
        with([a, (b + 3) % 10, c]);
        let beyond = format!(
            "a constrained Delaunay triangulation of /ten.poly: point 10 is named, and there are 10 \
             points\nfound at triangle {at} of 12; points, edges and triangles are numbered from 0\n"
        );
        assert_eq!(with([a, b, 10]), beyond);
        let mut less = right.clone();
        less.remove(at);
        let why = refused(&folder, &less, "");
        assert!(
            why.contains("found behind the last of 11 triangles"),
            "{why}"
        );
        let mut twice = right.clone();
        twice.push(corners);
        refused(&folder, &twice, "");
        twice.pop();
        twice.insert(at, corners);
        let why = refused(&folder, &twice, "");
        // Where the neighbours came before, the copy opens three sides anew, and the border shows it in the end, if no
        // corner is forgotten.
        let place = format!("found at triangle {} of 13", at + 1);
        let is_seen = why.contains("two triangles lie left of the side ") && why.contains(&place);
        seen_at_once += usize::from(is_seen);
        let is_forgotten = why.contains("triangles went all the way round it before");
        assert!(
            is_seen || is_forgotten || why.contains("found behind the last"),
            "{why}"
        );
    }
    assert!(seen_at_once > 0);
    refused(&folder, &[], "");
}

/// Two triangles with the other diagonal: a triangulation still, but not Delaunay, or without an edge.
#[test]
fn a_flip_is_refused_by_the_level_that_it_breaks() {
    let (folder, right) = with_triangles();
    let mut flips = [0; 2];
    for i in 0..right.len() {
        for j in 0..i {
            for (k, l) in (0..9).map(|n| (n / 3, n % 3)) {
                let ([mut p, mut q], [at, other]) = ([right[i], right[j]], [k, l]);
                p.rotate_left(at);
                q.rotate_left(other);
                // p is a, b, c, and q is d, c, b.
                if [p[1], p[2]] != [q[2], q[1]] {
                    continue;
                }
                let mut flipped = right.clone();
                flipped[i] = [p[0], p[1], q[0]];
                flipped[j] = [p[0], q[0], p[2]];
                let why = refused(&folder, &flipped, "");
                if why.contains(" is not locally Delaunay") {
                    flips[0] += 1;
                    assert_accepted(&folder, &flipped, "--level constrained");
                } else if why.contains(" is no chain of constrained sides from vertex ") {
                    flips[1] += 1;
                    refused(&folder, &flipped, "--level constrained");
                } else {
                    assert!(why.contains(" does not turn left"), "{why}");
                }
            }
        }
    }
    assert!(flips.iter().all(|&flips| flips > 0), "{flips:?}");
}

#[test]
fn ties_count_for_the_canonical_level_alone() {
    let folder = folder(&[("a.xyz", "0 0\n1 0\n1 1\n0 1\n")]);
    let judged = |corners: [u32; 6], level: &str| {
        let bytes: Vec<u8> = corners
            .iter()
            .flat_map(|corner| corner.to_le_bytes())
            .collect();
        fs::write(folder.path().join("t.u32"), bytes).expect("a file");
        let arguments = format!("verify --stream a.xyz t.u32 --level {level}");
        text(&ran(&folder, &arguments).stdout).to_owned()
    };
    // The leftmost, upper corner is 3.
    let (canonical, other) = ([0, 1, 3, 1, 2, 3], [0, 1, 2, 0, 2, 3]);
    for (corners, level, is_right) in [
        (canonical, "canonical", true),
        (other, "canonical", false),
        (other, "delaunay", true),
    ] {
        let report = judged(corners, level);
        assert_eq!(report.starts_with("correct: "), is_right, "{report}");
        assert!(is_right || report.contains(" misses the first of four vertices on one circle"));
    }
}

/// Writes triangles and what else is raw, and returns the verdict.
fn verdict(files: &[(&str, Vec<u8>)], arguments: &str) -> String {
    let folder = folder(&[]);
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("a file");
    }
    let output = ran(&folder, &format!("verify --stream {arguments}"));
    assert_eq!(text(&output.stderr), "");
    text(&output.stdout).to_owned()
}

fn raw(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|n| n.to_le_bytes()).collect()
}

/// Found by review: a corner was unknown if a point that equals it has a lower number.
#[test]
fn of_equal_points_any_may_be_named() {
    let points = || ("p.xyz", b"0 0\n1 0\n0 1\n0 0\n".to_vec());
    for corners in [[3, 1, 2], [0, 1, 2]] {
        let files = [points(), ("t.u32", raw(&corners))];
        let report = verdict(&files, "p.xyz t.u32 --level canonical");
        assert!(report.starts_with("correct: "), "{report}");
    }
    let report = verdict(&[points(), ("t.u32", raw(&[3, 0, 2]))], "p.xyz t.u32");
    assert!(
        report.contains("triangle 3 0 2 does not turn left"),
        "{report}"
    );
}

/// Found by review: a triangulation was refused for an edge that it need not have.
#[test]
fn a_tiling_needs_no_edges() {
    let files = [
        ("p.xyz", b"0 0\n1 0\n1 1\n0 1\n".to_vec()),
        ("e.u64", [1_u64, 3].map(u64::to_le_bytes).concat()),
        ("t.u32", raw(&[0, 1, 2, 0, 2, 3])),
    ];
    for (level, is_right) in [("tiling", true), ("constrained", false)] {
        let arguments = format!("p.xyz t.u32 --edges e.u64 --level {level}");
        let report = verdict(&files, &arguments);
        assert_eq!(report.starts_with("correct: "), is_right, "{report}");
    }
}

/// Found by review: a vertex on an edge was forgotten before the chain of the edge had come up to it, in about half of the
/// orders of 12,482 triangles.
#[test]
fn an_edge_through_a_column_of_a_lattice_is_found_in_any_order() {
    let size: u64 = 80;
    let places = (0..size * size).map(|v| format!("{} {}\n", v % size, v / size));
    let points: String = places.collect();
    let edge = [size / 2, size * (size - 1) + size / 2].map(u64::to_le_bytes);
    let folder = folder(&[("p.xyz", &points)]);
    fs::write(folder.path().join("e.u64"), edge.concat()).expect("a file");
    let output = ran(&folder, "stream p.xyz --edges e.u64 -o t.u32");
    assert_eq!(text(&output.stderr), "");
    let right = fs::read(folder.path().join("t.u32")).expect("a file");
    let mut triangles: Vec<[u8; 12]> = right.as_chunks().0.to_vec();
    for seed in 0..5 {
        Random::new(seed).shuffle(&mut triangles);
        fs::write(folder.path().join("t.u32"), triangles.concat()).expect("a file");
        let output = ran(
            &folder,
            "verify --stream p.xyz t.u32 --edges e.u64 --level canonical",
        );
        assert!(text(&output.stdout).starts_with("correct: "), "{seed}");
    }
}

/// Found by review: the vertex in the middle was forgotten before edges through it had come up to it.
#[test]
fn what_is_streamed_is_accepted_where_edges_pass_one_vertex() {
    let folder = folder(&[]);
    for arguments in [
        "generate asterisk 5000 -o a.poly",
        "stream a.poly -o a.u32",
        "verify --stream a.poly a.u32 --level canonical",
    ] {
        let output = ran(&folder, arguments);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
    }
}

#[test]
fn files_that_are_cut_off_or_of_another_width_are_refused() {
    let (folder, right) = with_triangles();
    let whole = fs::read(folder.path().join("t.u64")).expect("a file");
    let verify = |name: &str| {
        ran(
            &folder,
            &format!("verify --stream {FORMATS}/ten.poly {name}"),
        )
    };
    fs::write(folder.path().join("cut.u64"), &whole[..100]).expect("a file");
    let error = "cut.u64: 100 bytes are no whole number of triangles of 24 bytes";
    assert_fails(&verify("cut.u64"), error);
    fs::write(folder.path().join("cut.u64"), &whole[..96]).expect("a file");
    assert_eq!(verify("cut.u64").status.code(), Some(1));
    for (from, to) in [("w.u64", "narrow.u32"), ("w.u32", "wide.u64")] {
        assert_accepted(&folder, &right, "");
        fs::copy(folder.path().join(from), folder.path().join(to)).expect("a copy");
        let output = verify(to);
        assert!(text(&output.stdout).starts_with("wrong: "), "{to}");
        assert_eq!(output.status.code(), Some(1));
    }
    fs::create_dir(folder.path().join("folder.u32")).expect("a folder");
    let error = "folder.u32: is no file: triangles of a stream are read from one";
    assert_fails(&verify("folder.u32"), error);
    assert_fails(&verify("no.u32"), "no.u32: no such file or directory");
}
