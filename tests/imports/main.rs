//! No two files import each other, directly or round a corner.
//!
//! An *arrow* leads from a file that names an item, in a `use` or in a path, to the file that defines the
//! item. A re-export (`pub use`) is no arrow, unless its file uses the name as well. Comments, strings and
//! a module within one file make no arrows.

mod circles;
mod made_up;
mod names;
mod scope;

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
        if place.is_dir() && name != "target" {
            read(&place, &path, tree);
        } else if name.ends_with(".rs") {
            tree.insert(path, fs::read_to_string(place).expect("a text"));
        }
    }
}

fn arrows_of_this_repository() -> Vec<Arrow> {
    let mut tree = Tree::new();
    for folder in ["src", "fuzz", "testing", "experiments"] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        read(&root.join(folder), folder, &mut tree);
    }
    arrows(&tree).unwrap_or_else(|message| panic!("{message}"))
}

#[test]
fn no_two_files_import_each_other() {
    let circles = circles::circles(&arrows_of_this_repository());
    assert!(
        circles.is_empty(),
        "{} circles:\n\n{}",
        circles.len(),
        circles.join("\n")
    );
}

/// Apart from whether a thread can be made, which decides no verdict.
#[test]
fn the_verifier_uses_the_scalars_and_nothing_else() {
    let arrows = arrows_of_this_repository();
    let out: Vec<&Arrow> = arrows
        .iter()
        .filter(|arrow| arrow.from.starts_with("src/verify/"))
        .filter(|arrow| !arrow.to.starts_with("src/verify/"))
        .filter(|arrow| arrow.to != "src/threads.rs")
        .collect();
    let (to_scalars, others): (Vec<&Arrow>, Vec<&Arrow>) = out
        .into_iter()
        .partition(|arrow| arrow.to.starts_with("src/scalar/"));
    assert!(!to_scalars.is_empty());
    assert_eq!(others, [] as [&Arrow; 0]);
}
