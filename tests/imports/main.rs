//! No two files import each other, directly or round a corner, but a folder's `mod.rs` and the files of the folder may:
//! a folder owns its type.
//!
//! An *arrow* leads from a file that names an item, in a `use` or in a path, to the file that defines the
//! item. A re-export (`pub use`) is no arrow, unless its file uses the name as well. Comments, strings and
//! a module within one file make no arrows.

mod made_up;
mod names;
mod scope;

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fs;
use std::path::Path;

use names::{Arrow, Tree, arrows};

/// Adds the Rust files of a folder, if there is one.
fn read(folder: &Path, path: &str, tree: &mut Tree) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries {
        let entry = entry.expect("an entry of a folder");
        let name = entry.file_name().into_string().expect("a name in UTF-8");
        let (place, path) = (entry.path(), format!("{path}/{name}"));
        // The tests of the page take a file of another package's tests by `#[path]`.
        if path == "crates/page/tests" || name == "target" {
            continue;
        }
        if place.is_dir() {
            read(&place, &path, tree);
        } else if name.ends_with(".rs") {
            tree.insert(path, fs::read_to_string(place).expect("a text"));
        }
    }
}

fn arrows_of_this_repository() -> Vec<Arrow> {
    let mut tree = Tree::new();
    for folder in ["src", "fuzz", "crates"] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        read(&root.join(folder), folder, &mut tree);
    }
    arrows(&tree).unwrap_or_else(|message| panic!("{message}"))
}

#[test]
fn no_two_files_import_each_other() {
    let circles = circles(&arrows_of_this_repository());
    assert!(
        circles.is_empty(),
        "{} circles:\n\n{}",
        circles.len(),
        circles.join("\n")
    );
}

/// Apart from what shares work out to threads, which decides no verdict.
#[test]
fn the_verifier_uses_the_scalars_and_nothing_else() {
    let arrows = arrows_of_this_repository();
    let out = leaving("src/verify/", &arrows);
    let out = out.into_iter().filter(|arrow| arrow.to != "src/threads.rs");
    let (to_scalars, others): (Vec<&Arrow>, Vec<&Arrow>) =
        out.partition(|arrow| arrow.to.starts_with("src/scalar/"));
    assert!(!to_scalars.is_empty());
    assert_eq!(others, [] as [&Arrow; 0]);
}

/// Of its own package nothing, and of the library the scalars and the names of levels.
#[test]
fn so_does_the_verifier_of_streams() {
    let folder = "crates/stream/src/verify/";
    let arrows = arrows_of_this_repository();
    assert_eq!(leaving(folder, &arrows), [] as [&Arrow; 0]);
    let mut tree = Tree::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    read(&root.join(folder), folder, &mut tree);
    let mut uses = 0;
    for (file, text) in &tree {
        let lines = text.lines().map(str::trim_start);
        let code = lines.filter(|line| !line.starts_with("//"));
        for path in code.flat_map(|line| line.split("sweep_cdt::").skip(1)) {
            let is_allowed = path.starts_with("scalar::") || path.starts_with("verify::Level");
            assert!(is_allowed, "{file}: {path}");
            uses += 1;
        }
    }
    assert!(uses > 5, "{uses}");
}

/// The arrows from a folder to other ones.
fn leaving<'a>(folder: &str, arrows: &'a [Arrow]) -> Vec<&'a Arrow> {
    let from = arrows.iter().filter(|arrow| arrow.from.starts_with(folder));
    from.filter(|arrow| !arrow.to.starts_with(folder)).collect()
}

/// Whether one of two files is the `mod.rs` of a folder that the other one lies in.
fn are_family(a: &str, b: &str) -> bool {
    let owns = |parent: &str, child: &str| {
        let folder = parent.strip_suffix("mod.rs");
        folder.is_some_and(|folder| child.starts_with(folder))
    };
    owns(a, b) || owns(b, a)
}

/// For each file in a circle a shortest one through it, as text; each circle once. Arrows within a family make none.
fn circles(arrows: &[Arrow]) -> Vec<String> {
    // Of several arrows between two files the first one stands for all.
    let mut from: BTreeMap<&str, BTreeMap<&str, &Arrow>> = BTreeMap::new();
    let strangers = arrows
        .iter()
        .filter(|arrow| !are_family(&arrow.from, &arrow.to));
    for arrow in strangers {
        let of_file = from.entry(&arrow.from).or_default();
        of_file.entry(&arrow.to).or_insert(arrow);
    }
    let mut seen = BTreeSet::new();
    let mut circles = Vec::new();
    for &start in from.keys() {
        let Some(circle) = shortest(start, &from) else {
            continue;
        };
        let files: BTreeSet<&str> = circle.iter().map(|arrow| arrow.to.as_str()).collect();
        if seen.insert(files) {
            circles.push(circle.iter().map(|arrow| format!("{arrow}\n")).collect());
        }
    }
    circles
}

/// A shortest circle from a file back to it, breadth first.
fn shortest<'a>(
    start: &'a str,
    from: &BTreeMap<&'a str, BTreeMap<&'a str, &'a Arrow>>,
) -> Option<Vec<&'a Arrow>> {
    let mut reached_by: BTreeMap<&str, &Arrow> = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(file) = queue.pop_front() {
        for (&to, &arrow) in from.get(file).into_iter().flatten() {
            if reached_by.contains_key(to) {
                continue;
            }
            reached_by.insert(to, arrow);
            queue.push_back(to);
        }
    }
    let mut circle = vec![*reached_by.get(start)?];
    while circle[circle.len() - 1].from != start {
        circle.push(reached_by[circle[circle.len() - 1].from.as_str()]);
    }
    circle.reverse();
    Some(circle)
}
