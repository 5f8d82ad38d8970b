//! Data sets from `.poly` files.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use flate2::read::GzDecoder;
use sweep_cdt_testing::{Input, data};

use super::{Aim, DataSet, Kind, of_spade, short};

/// Files with an aim: so many copies side by side in each direction.
const AIMS: [(&str, [usize; 2], Aim); 6] = [
    ("cadastre_23k", [1, 1], of_spade(0.20)),
    ("cadastre_23k", [4, 4], of_spade(0.19)),
    ("cadastre_23k", [8, 8], of_spade(0.21)),
    ("isolines_162k", [1, 1], of_spade(0.22)),
    ("isolines_162k", [4, 2], of_spade(0.19)),
    ("coastlines_472k", [1, 1], of_spade(0.23)),
];

/// The contour lines of this repository and the files of a folder, each as it is or with its copies.
pub(super) fn sets(folder: Option<&Path>) -> impl Iterator<Item = DataSet> {
    let own = data::path("tests/data/isolines_small.poly");
    let mut paths = folder.map(poly_files).unwrap_or_default();
    paths.retain(|path| path.file_name() != own.file_name());
    paths.insert(0, own);
    paths.into_iter().flat_map(|path| {
        let family = name(&path).expect("a `.poly` file").to_owned();
        let plans: Vec<_> = AIMS.iter().filter(|(name, ..)| *name == family).collect();
        let plans = if plans.is_empty() {
            vec![([1, 1], None)]
        } else {
            plans
                .iter()
                .map(|(_, copies, aim)| (*copies, Some(*aim)))
                .collect()
        };
        let input = read(&path);
        plans.into_iter().map(move |(copies, aim)| {
            let copied = tiles(&input, copies);
            let size = short(copied.points.len());
            DataSet {
                name: if copies == [1, 1] {
                    family.clone()
                } else {
                    format!("{family} x{}: {size}", copies[0] * copies[1])
                },
                family: family.clone(),
                kind: Kind::Edges,
                inputs: vec![copied],
                aim,
            }
        })
    })
}

/// The `.poly` and `.poly.gz` files of a folder, sorted.
fn poly_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of data");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> = paths.filter(|path| name(path).is_some()).collect();
    paths.sort();
    paths
}

/// The name of a `.poly` file without its extensions.
fn name(path: &Path) -> Option<&str> {
    let name = path.file_name()?.to_str()?;
    name.strip_suffix(".gz")
        .unwrap_or(name)
        .strip_suffix(".poly")
}

fn read(path: &Path) -> Input {
    let mut bytes = fs::read(path).expect("a readable file");
    if path.extension().is_some_and(|extension| extension == "gz") {
        let packed = std::mem::take(&mut bytes);
        let size = GzDecoder::new(&packed[..]).read_to_end(&mut bytes);
        size.expect("a file of gzip");
    }
    data::poly_of(path.display().to_string(), bytes)
}

/// Copies side by side, a little apart.
fn tiles(input: &Input, [columns, rows]: [usize; 2]) -> Input {
    let offset = |axis: usize, copies: usize| {
        let all = input.points.iter().map(|p| p[axis]);
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
            tiled
                .points
                .extend(input.points.iter().map(|[x, y]| [x + dx, y + dy]));
            tiled
                .edges
                .extend(input.edges.iter().map(|edge| edge.map(|v| first + v)));
        }
    }
    tiled
}
