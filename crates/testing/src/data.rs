//! Inputs in doubles, and the test data: contour lines, and inputs that broke other programs.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde_json::Value;
use sweep_cdt::Pslg;
use sweep_cdt_formats::{self as formats, Format, Source};
use sweep_cdt_generate::Kind;

/// Points and edges, as [`sweep_cdt::triangulate`] takes them.
#[derive(Clone, Debug, Default)]
pub struct Input {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// The edges, as positions in `points`; not checked.
    pub edges: Vec<[usize; 2]>,
}

impl From<Pslg<f64>> for Input {
    fn from(Pslg { points, edges, .. }: Pslg<f64>) -> Input {
        Input { points, edges }
    }
}

impl Input {
    /// The generated data of this kind.
    ///
    /// # Panics
    /// If there is no such kind.
    pub fn generated(kind: &str, n: usize, seed: u64) -> Input {
        let kind = Kind::named(kind).expect("a kind of data");
        kind.graph(n, seed).into()
    }

    /// Reads `"0 0, 1.5 2, -3 1e300"` and `"0 1, 2 0"`.
    pub fn parse(points: &str, edges: &str) -> Input {
        Input {
            points: pairs(points),
            edges: pairs(edges),
        }
    }

    /// The input with point `order[i]` as point `i`.
    pub fn permuted(&self, order: &[usize]) -> Input {
        let mut place = vec![0; order.len()];
        for (i, &v) in order.iter().enumerate() {
            place[v] = i;
        }
        Input {
            points: order.iter().map(|&v| self.points[v]).collect(),
            edges: self
                .edges
                .iter()
                .map(|edge| edge.map(|v| place[v]))
                .collect(),
        }
    }

    /// Copies of the input side by side, a little apart.
    pub fn tiled(&self, [columns, rows]: [usize; 2]) -> Input {
        let offset = |axis: usize, copies: usize| {
            let all = self.points.iter().map(|p| p[axis]);
            let (low, high) = (
                all.clone().fold(f64::INFINITY, f64::min),
                all.fold(f64::NEG_INFINITY, f64::max),
            );
            (0..copies).map(move |copy| copy as f64 * (1.01 * (high - low)).ceil())
        };
        let mut tiled = Input::default();
        for dy in offset(1, rows) {
            for dx in offset(0, columns) {
                let first = tiled.points.len();
                let points = self.points.iter().map(|[x, y]| [x + dx, y + dy]);
                tiled.points.extend(points);
                let edges = self.edges.iter().map(|edge| edge.map(|v| first + v));
                tiled.edges.extend(edges);
            }
        }
        tiled
    }
}

fn pairs<T: FromStr>(text: &str) -> Vec<[T; 2]> {
    let pair = |pair: &str| {
        let mut numbers = pair.split_whitespace().map(|number| number.parse().ok());
        let mut next = || {
            numbers
                .next()
                .flatten()
                .unwrap_or_else(|| panic!("two numbers: {pair}"))
        };
        let pair = [next(), next()];
        assert!(numbers.next().is_none(), "two numbers, not three");
        pair
    };
    text.split(',')
        .filter(|pair| !pair.trim().is_empty())
        .map(pair)
        .collect()
}

/// A row of the table of cases, ready to be pasted.
impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points: Vec<String> = self
            .points
            .iter()
            .map(|[x, y]| format!("{x:?} {y:?}"))
            .collect();
        let edges: Vec<String> = self.edges.iter().map(|[a, b]| format!("{a} {b}")).collect();
        write!(
            f,
            "(\"name\", {:?}, {:?}),",
            points.join(", "),
            edges.join(", ")
        )
    }
}

/// A file of this repository.
pub fn path(inside: &str) -> PathBuf {
    let mut folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let root = folders.nth(2).expect("the crate lies in crates/");
    root.join(inside)
}

/// The files of a folder; sorted.
///
/// # Panics
/// If there is no such folder.
pub fn all_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
}

/// The files of a folder whose names end in this extension; sorted.
///
/// # Panics
/// If there is none.
pub fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let has_extension = |path: &PathBuf| path.extension().is_some_and(|found| found == extension);
    let mut paths = all_files(folder);
    paths.retain(has_extension);
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
    let bytes = fs::read(path).expect("a readable file");
    poly_of(path.display().to_string(), bytes)
}

/// Reads the bytes of such a file with this name.
///
/// # Panics
/// If they are no such file.
pub fn poly_of(name: String, bytes: Vec<u8>) -> Input {
    let source = Source::new(name, bytes);
    match formats::read(Format::Poly, &source, None) {
        Ok(formats::Input::Doubles(file)) => file.graph.into(),
        Ok(formats::Input::Rationals(_)) => panic!("{}: fractions", source.name),
        Err(error) => panic!("{error}"),
    }
}

/// An input that broke some program: a line of `tests/data/hard.jsonl`, or a file of the same form.
///
/// Each says where it comes from (`source`), what broke (`note`) and, computed with exact rational
/// arithmetic, what is special about it (`expect`, `flags`).
#[derive(Clone, Debug)]
pub struct Hard {
    /// The input's name.
    pub name: String,
    /// Where the input is from, with its licence in brackets.
    pub source: String,
    /// The right outcome: `nonfinite`, `invalid_index` or `crossing` if it is an error.
    pub expect: String,
    /// Whether there is no triangle.
    pub is_flat: bool,
    /// The points, some of which may not be finite, and edges, whose ends may not exist.
    pub input: Input,
}

impl Hard {
    /// The inputs of this repository.
    pub fn own() -> Vec<Hard> {
        let text = fs::read_to_string(path("tests/data/hard.jsonl")).expect("a readable file");
        let named = |line| {
            let json: Value = serde_json::from_str(line).expect("a line of JSON");
            Hard::of(json["name"].as_str().expect("a name"), &json)
        };
        text.lines().map(named).collect()
    }

    /// The files of the folder that the environment variable `SWEEP_CDT_HARD` names, if it does.
    pub fn further() -> Vec<Hard> {
        let folder = std::env::var_os("SWEEP_CDT_HARD").map(PathBuf::from);
        let paths = folder.map_or_else(Vec::new, |folder| files(&folder, "json"));
        let read = |path: &PathBuf| {
            let text = fs::read_to_string(path).expect("a readable file");
            let json = serde_json::from_str(&text).expect("a JSON file");
            Hard::of(
                &path.file_stem().unwrap_or_default().to_string_lossy(),
                &json,
            )
        };
        paths.iter().map(read).collect()
    }

    /// Coordinates may be the words `nan`, `inf` and `-inf`.
    fn of(name: &str, json: &Value) -> Hard {
        let list = |key: &str| json[key].as_array().expect(key).iter();
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
            name: name.to_owned(),
            source: json["source"].as_str().unwrap_or_default().to_owned(),
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
}
