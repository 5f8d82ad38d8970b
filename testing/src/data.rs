//! The test data: contour lines, and inputs that broke other programs.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use sweep_cdt::formats::{self, InputFormat, Source};

use crate::Input;

/// A file of this repository.
pub fn path(inside: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    root.expect("the crate has a folder of its own")
        .join(inside)
}

/// The files of a folder whose names end in this extension; sorted.
///
/// # Panics
/// If there is none.
pub fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|found| found == extension))
        .collect();
    paths.sort();
    let folder = folder.display();
    assert!(!paths.is_empty(), "{folder} holds no .{extension} file");
    paths
}

/// The contour lines of `tests/data/isolines_small.poly`.
pub fn contours() -> Input {
    poly(&path("tests/data/isolines_small.poly"))
}

/// Reads a `.poly` file that holds its own points, none of them fractions.
///
/// # Panics
/// If it is no such file.
pub fn poly(path: &Path) -> Input {
    let source = Source {
        name: path.display().to_string(),
        bytes: fs::read(path).expect("a readable file"),
    };
    match formats::read(InputFormat::Poly, &source, None) {
        Ok(formats::Input::Doubles(graph)) => Input {
            points: graph.points,
            edges: graph.edges,
        },
        Ok(formats::Input::Rationals(_)) => panic!("{}: fractions", source.name),
        Err(error) => panic!("{error}"),
    }
}

/// An input that broke some program: a file of `tests/data/hard`, or another folder of such files.
///
/// Each says where it comes from (`source`), what broke (`note`) and, computed with exact rational
/// arithmetic, what is special about it (`expect`, `flags`).
#[derive(Clone, Debug)]
pub struct Hard {
    /// The file.
    pub path: PathBuf,
    /// What must come out: `nonfinite`, `invalid_index` or `crossing` if it is an error.
    pub expect: String,
    /// Whether there is no triangle.
    pub is_flat: bool,
    /// The points, some of which may not be finite, and edges, whose ends may not exist.
    pub input: Input,
}

impl Hard {
    /// Reads one file. Coordinates may be the words `nan`, `inf` and `-inf`.
    ///
    /// # Panics
    /// If it is no such file.
    pub fn read(path: &Path) -> Hard {
        let text = fs::read_to_string(path).expect("a readable file");
        let json: Value = serde_json::from_str(&text).expect("a JSON file");
        let list = |name: &str| json[name].as_array().expect(name).iter();
        let coordinate = |value: &Value| match value {
            Value::String(text) => text.parse().expect("nan, inf or -inf"),
            _ => value.as_f64().expect("a number"),
        };
        // What no index can be is out of range in any case.
        let index = |value: &Value| {
            let index = value.as_u64().unwrap_or(u64::MAX);
            usize::try_from(index).unwrap_or(usize::MAX)
        };
        let has_flag = |name| json["flags"].get(name).is_some();
        Hard {
            path: path.to_owned(),
            expect: json["expect"].as_str().expect("expect").to_owned(),
            is_flat: has_flag("all_collinear") || has_flag("fewer_than_3_distinct_points"),
            input: Input {
                points: list("points")
                    .map(|p| [0, 1].map(|i| coordinate(&p[i])))
                    .collect(),
                edges: list("edges")
                    .map(|e| [0, 1].map(|i| index(&e[i])))
                    .collect(),
            },
        }
    }

    /// All files of `tests/data/hard`.
    pub fn own() -> Vec<Hard> {
        Hard::all(&path("tests/data/hard"))
    }

    /// All files of the folder that the environment variable `SWEEP_CDT_HARD` names, if it does.
    pub fn further() -> Vec<Hard> {
        let folder = std::env::var_os("SWEEP_CDT_HARD").map(PathBuf::from);
        folder.map_or_else(Vec::new, |folder| Hard::all(&folder))
    }

    fn all(folder: &Path) -> Vec<Hard> {
        let paths = files(folder, "json");
        paths.iter().map(|path| Hard::read(path)).collect()
    }
}
