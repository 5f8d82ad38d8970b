//! The data sets: made with fixed seeds, or read from files.

use std::f64::consts::TAU;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use flate2::read::GzDecoder;
use sweep_cdt_testing::{Input, Random, clouds, data, segments};

/// The contents of a data set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Points without edges.
    Points,
    /// Points and edges.
    Edges,
    /// Many polygons, whose points are in the order of their boundaries, counter-clockwise.
    Polygons,
}

/// The share of another program's time that this crate should need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    pub(crate) of: Of,
    pub(crate) share: f64,
}

/// Of whose time.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Of {
    Program(&'static str),
    /// Of the fastest exact program whose answer is right.
    Exact,
}

/// A data set.
pub(crate) struct DataSet {
    pub(crate) name: String,
    /// The series of sizes to which it belongs, for the plot.
    pub(crate) family: String,
    pub(crate) kind: Kind,
    pub(crate) inputs: Vec<Input>,
    pub(crate) aim: Option<Aim>,
}

impl DataSet {
    /// Points of all inputs.
    pub(crate) fn points(&self) -> usize {
        self.inputs.iter().map(|input| input.points.len()).sum()
    }

    /// Edges of all inputs.
    pub(crate) fn edges(&self) -> usize {
        self.inputs.iter().map(|input| input.edges.len()).sum()
    }
}

/// A data set of so many points.
struct Plan {
    family: &'static str,
    kind: Kind,
    /// Points of each input.
    size: usize,
    make: fn(size: usize) -> Vec<Input>,
    aim: Aim,
}

const fn of_spade(share: f64) -> Aim {
    Aim {
        of: Of::Program("spade"),
        share,
    }
}

const HALF_OF_CGAL: Aim = Aim {
    of: Of::Program("CGAL"),
    share: 0.5,
};

const QUARTER_OF_EXACT: Aim = Aim {
    of: Of::Exact,
    share: 0.25,
};

const THIRD_OF_EXACT: Aim = Aim {
    of: Of::Exact,
    share: 1.0 / 3.0,
};

#[rustfmt::skip]
const PLANS: [Plan; 16] = [
    Plan { family: "uniform", kind: Kind::Points, size: 10_000, make: |n| vec![clouds::uniform(n)], aim: of_spade(0.25) },
    Plan { family: "uniform", kind: Kind::Points, size: 100_000, make: |n| vec![clouds::uniform(n)], aim: of_spade(0.21) },
    Plan { family: "uniform", kind: Kind::Points, size: 1_000_000, make: |n| vec![clouds::uniform(n)], aim: of_spade(0.25) },
    Plan { family: "uniform", kind: Kind::Points, size: 4_000_000, make: |n| vec![clouds::uniform(n)], aim: of_spade(0.22) },
    Plan { family: "clusters", kind: Kind::Points, size: 1_000_000, make: |n| vec![clouds::clusters(n)], aim: of_spade(0.22) },
    Plan { family: "power-law cluster", kind: Kind::Points, size: 1_000_000, make: |n| vec![clouds::power_law(n)], aim: QUARTER_OF_EXACT },
    Plan { family: "lattice, shuffled", kind: Kind::Points, size: 1_000_000, make: |n| vec![clouds::shuffled_lattice(n)], aim: of_spade(0.19) },
    Plan { family: "lattice, in order", kind: Kind::Points, size: 1_000_000, make: |n| vec![clouds::lattice(n)], aim: QUARTER_OF_EXACT },
    Plan { family: "circle", kind: Kind::Points, size: 100_000, make: |n| vec![clouds::circle(n)], aim: HALF_OF_CGAL },
    Plan { family: "segments", kind: Kind::Edges, size: 200_000, make: |n| vec![segments(n)], aim: of_spade(0.25) },
    Plan { family: "segments", kind: Kind::Edges, size: 1_000_000, make: |n| vec![segments(n)], aim: of_spade(0.21) },
    Plan { family: "polygons", kind: Kind::Polygons, size: 10, make: polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 30, make: polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 100, make: polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 1_000, make: polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 5_000, make: polygons, aim: THIRD_OF_EXACT },
];

/// In a quick run, data sets have a tenth of their points (polygons have not), and files of more points than
/// this are left out.
const QUICK: usize = 100_000;

/// All data sets, each made when its turn comes.
pub(crate) fn sets(quick: bool, folder: Option<&Path>) -> impl Iterator<Item = DataSet> {
    let made = PLANS.into_iter().map(move |plan| {
        let is_smaller = quick && plan.kind != Kind::Polygons;
        let size = if is_smaller {
            plan.size / 10
        } else {
            plan.size
        };
        DataSet {
            name: format!("{} {}", plan.family, short(size)),
            family: plan.family.to_owned(),
            kind: plan.kind,
            inputs: (plan.make)(size),
            aim: (!is_smaller).then_some(plan.aim),
        }
    });
    let files = files(folder).filter(move |set| !quick || set.points() <= QUICK);
    made.chain(files)
}

/// A number in few characters: `1e6`, `4e6`, `23k`.
fn short(n: usize) -> String {
    let zeros = n.checked_ilog10().unwrap_or(0);
    let unit = 10_usize.pow(zeros);
    match n {
        _ if zeros >= 4 && n.is_multiple_of(unit) => format!("{}e{zeros}", n / unit),
        1_000_000.. => format!("{:.2}M", n as f64 / 1e6),
        10_000.. => format!("{}k", n / 1000),
        _ => n.to_string(),
    }
}

/// The points of all polygons of a data set together.
const POLYGON_POINTS: usize = 200_000;

/// Coordinates of polygons are integers up to this.
const RADIUS: f64 = (1 << 26) as f64;

/// Polygons of `n` points, star-shaped, with a boundary that is rough on every scale.
fn polygons(n: usize) -> Vec<Input> {
    let mut random = Random::new(7);
    (0..POLYGON_POINTS / n)
        .map(|_| polygon(n, &mut random))
        .collect()
}

fn polygon(n: usize, random: &mut Random) -> Input {
    let radii = radii(n, random);
    let point = |(i, radius): (usize, &f64)| {
        let (sin, cos) = (TAU * (i as f64 + 0.8 * random.unit()) / n as f64).sin_cos();
        [radius * cos, radius * sin].map(|c| (RADIUS * c).round())
    };
    Input {
        points: radii.iter().enumerate().map(point).collect(),
        edges: (0..n).map(|i| [i, (i + 1) % n]).collect(),
    }
}

/// Distances of the corners of a polygon from its centre, from 0.25 to 1: between two of them, the middle one is moved at random by up to
/// a quarter of their distance along the boundary, and so on.
fn radii(n: usize, random: &mut Random) -> Vec<f64> {
    let levels = n.next_power_of_two();
    let mut radii = vec![0.6; levels + 1];
    let mut step = levels;
    while step > 1 {
        let reach = 0.5 * step as f64 / levels as f64;
        for middle in (step / 2..levels).step_by(step) {
            let mean = (radii[middle - step / 2] + radii[middle + step / 2]) / 2.0;
            let moved = mean + reach * (2.0 * random.unit() - 1.0);
            radii[middle] = moved.clamp(0.25, 1.0);
        }
        step /= 2;
    }
    radii.truncate(n);
    radii
}

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
fn files(folder: Option<&Path>) -> impl Iterator<Item = DataSet> {
    let own = data::path("tests/data/isolines_small.poly");
    let mut paths = folder.map(poly_files).unwrap_or_default();
    paths.retain(|path| path.file_name() != own.file_name());
    paths.insert(0, own);
    paths.into_iter().flat_map(|path| {
        let family = poly_name(&path).expect("a `.poly` file").to_owned();
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
            let copied = input.tiled(copies);
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
    let mut paths: Vec<_> = paths.filter(|path| poly_name(path).is_some()).collect();
    paths.sort();
    paths
}

/// The name of a `.poly` file without its extensions.
fn poly_name(path: &Path) -> Option<&str> {
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
