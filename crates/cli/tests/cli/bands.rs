//! `sweep-cdt stream --band` and `sweep-cdt join`: joined in any order, the triangles of all runs are those of
//! `sweep-cdt triangulate`; and which rests are refused.

use std::fs;

use sweep_cdt_testing::{Input, Random};
use tempfile::TempDir;

use crate::stream::{Triangles, expected, ran, set, triangles, write_both};
use crate::{CONTOURS, FORMATS, folder, names, printed, printed_despite_losses, text};

/// The bands of an input, by their names, in their order.
fn cut(folder: &TempDir, input: &str, size: usize) -> Vec<String> {
    let made = ran(folder, &format!("stream {input} --band {size} -o bands"));
    assert_eq!(printed_despite_losses(&made), "");
    let names = fs::read_dir(folder.path().join("bands")).expect("a folder");
    let names = names.map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = names
        .map(|name| format!("bands/{}", name.display()))
        .collect();
    names.sort_unstable();
    names
}

/// Joins neighbours by chance, one to three at a time, until nothing is left.
fn joined(folder: &TempDir, mut rests: Vec<String>, random: &mut Random) -> Triangles {
    let mut found = Vec::new();
    for step in 0.. {
        let at = random.below(rests.len());
        let end = (at + 1 + random.below(3)).min(rests.len());
        let is_last = end - at == rests.len();
        let inputs = rests[at..end].join(" ");
        let left = format!("left-{step}.rest");
        let rest = match is_last {
            true => String::new(),
            false => format!("--rest {left}"),
        };
        let extension = random.pick(&["u32", "u64"]);
        let made = ran(folder, &format!("join {inputs} -o t.{extension} {rest}"));
        assert_eq!(printed(&made), "");
        let bytes = fs::read(folder.path().join(format!("t.{extension}"))).expect("a file");
        found.extend(triangles(&bytes, extension));
        if is_last {
            break;
        }
        rests.splice(at..end, [left]);
    }
    found
}

#[track_caller]
fn assert_joined(input: &str, folder: &TempDir, expected: &Triangles, sizes: &[usize]) {
    for &size in sizes {
        let bands = cut(folder, input, size);
        let random = &mut Random::new(size as u64);
        let found = set(joined(folder, bands, random));
        assert!(found == *expected, "{input} in bands of {size}");
        fs::remove_dir_all(folder.path().join("bands")).expect("a folder");
    }
}

#[test]
fn files_in_bands_give_the_triangles_of_triangulate() {
    for (input, sizes) in [("ten.poly", &[1, 3, 99][..]), ("split.poly", &[1, 2])] {
        let folder = folder(&[]);
        let input = format!("{FORMATS}/{input}");
        let expected = expected(&folder, &input);
        assert_joined(&input, &folder, &expected, sizes);
    }
    let folder = folder(&[]);
    assert_joined(CONTOURS, &folder, &expected(&folder, CONTOURS), &[3000]);
}

#[test]
fn raw_points_and_edges_do_too() {
    let mut inputs = vec![
        Input::generated("uniform", 900, 3),
        Input::generated("lattice", 400, 3),
        Input::generated("segments", 500, 4),
        Input::generated("outlines", 400, 5),
    ];
    // Equal points belong to one band.
    inputs[1].points.extend_from_within(100..200);
    for input in inputs {
        let folder = folder(&[]);
        write_both(&folder, &input);
        let expected = expected(&folder, "p.json");
        let raw = match input.edges.is_empty() {
            true => "p.f64",
            false => "p.f64 --edges e.u64",
        };
        assert_joined(raw, &folder, &expected, &[70, 250]);
    }
}

/// The error of a run that writes nothing.
#[track_caller]
fn refused(folder: &TempDir, arguments: &str, code: i32) -> String {
    let before = names(folder.path());
    let made = ran(folder, arguments);
    let error = text(&made.stderr).to_owned();
    assert_eq!(made.status.code(), Some(code), "{arguments}: {error}");
    assert_eq!(names(folder.path()), before, "{arguments}");
    error
}

/// A folder with points in three bands.
fn in_bands() -> TempDir {
    let folder = folder(&[]);
    write_both(&folder, &Input::generated("uniform", 300, 1));
    assert_eq!(cut(&folder, "p.f64", 100).len(), 3);
    folder
}

#[test]
fn rests_that_do_not_fit_are_refused() {
    let folder = in_bands();
    let joined = |rests: &str| refused(&folder, &format!("join {rests} -o t.u32 --rest r.rest"), 1);
    assert_eq!(
        joined("bands/1.rest bands/3.rest"),
        "error: bands/3.rest: a rest ends before vertex 100 of the order, and the next one begins with vertex 200\n"
    );
    assert_eq!(joined("p.json"), "error: p.json: is no rest of a band\n");
    let path = folder.path().join("bands/2.rest");
    let bytes = fs::read(&path).expect("a file");
    fs::write(&path, &bytes[..bytes.len() - 9]).expect("a file");
    let damaged = "error: bands/2.rest: is damaged: it does not fit its checksum\n";
    assert_eq!(joined("bands/2.rest"), damaged);
    let mut altered = bytes;
    altered[200] ^= 4;
    fs::write(&path, altered).expect("a file");
    assert_eq!(joined("bands/1.rest bands/2.rest"), damaged);
    assert!(joined("bands/4.rest").starts_with("error: bands/4.rest: "));
    // Bands of another cut.
    let error = refused(&folder, "stream p.f64 --band 150 -o bands", 1);
    assert!(
        error.contains(
            "is there, and no band of this cut: remove it, or let OUTPUT be another folder"
        ),
        "{error}"
    );
    let made = ran(&folder, "stream p.f64 --band 150 -o others");
    assert_eq!(printed(&made), "");
    let error = joined("bands/1.rest others/2.rest");
    assert!(
        error.contains("the next one begins with vertex 150"),
        "{error}"
    );
}

#[test]
fn arguments_that_do_not_fit_are_refused() {
    let folder = in_bands();
    for (arguments, words) in [
        (
            "join bands/1.rest bands/2.rest -o t.u32",
            "these are vertices 0 to 199 of 300 in the order, so something is left: name its file with --rest",
        ),
        (
            "join bands/1.rest -o t.ply --rest r.rest",
            "t.ply is no name for triangles of bands: let it end in .u32 or .u64",
        ),
        (
            "join bands/1.rest -o t.u32 --rest bands/1.rest",
            "bands/1.rest is an input and would be overwritten",
        ),
        (
            "join bands/1.rest -o t.u32 --rest t.u32",
            "t.u32 and t.u32 are the same file and would both be written",
        ),
        (
            "stream p.f64 --band 10 -o -",
            "bands are files: let OUTPUT be the folder for them",
        ),
        ("stream p.f64 --band 10 --check -o b", "--check"),
        ("stream p.f64 --band 10", "--output"),
        ("stream p.f64 --band 0 -o b", "--band"),
    ] {
        let error = refused(&folder, arguments, 2);
        assert!(error.contains(words), "{arguments}: {error}");
    }
    let error = refused(&folder, "stream p.f64 --band 10 -o p.json", 1);
    assert!(error.starts_with("error: p.json: "), "{error}");
}

/// A run that is repeated writes the same bytes, and one that fails leaves what was there.
#[test]
fn runs_may_be_repeated() {
    let folder = in_bands();
    let read = |name: &str| fs::read(folder.path().join(name)).expect("a file");
    let join = "join bands/2.rest -o t.u32 --rest r.rest";
    let mut before = None;
    for _ in 0..2 {
        printed(&ran(&folder, "stream p.f64 --band 100 -o bands"));
        printed(&ran(&folder, join));
        let now = ["bands/2.rest", "t.u32", "r.rest"].map(read);
        assert_eq!(*before.get_or_insert_with(|| now.clone()), now);
    }
    fs::write(folder.path().join("bands/2.rest"), "sweeprst").expect("a file");
    refused(&folder, join, 1);
    let [_, triangles, rest] = before.expect("two runs");
    assert_eq!(["t.u32", "r.rest"].map(read), [triangles, rest]);
}

/// Edges that cross are named by their numbers, in the run that has both.
#[test]
fn crossing_edges_are_named() {
    let folder = folder(&[]);
    let points = vec![[0.0, 0.0], [4.0, 1.0], [2.0, 2.0], [0.0, 3.0], [4.0, 4.0]];
    let edges = vec![[0, 2], [0, 4], [3, 1]];
    let moved = vec![[0.0, 0.0], [4.0, 1.0], [1.5, 1.2], [0.0, 3.0], [4.0, 4.0]];
    for (points, is_crossed) in [(points, false), (moved, true)] {
        let edges = edges.clone();
        write_both(&folder, &Input { points, edges });
        printed(&ran(
            &folder,
            "stream p.f64 --edges e.u64 --band 2 -o bands",
        ));
        let all = "join bands/1.rest bands/2.rest bands/3.rest -o t.u32";
        let made = ran(&folder, all);
        match is_crossed {
            false => assert_eq!(printed(&made), ""),
            true => assert_eq!(text(&made.stderr), "error: edges 1 and 2 cross\n"),
        }
    }
}
