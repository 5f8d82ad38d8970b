//! The data sets: made with fixed seeds, or read from files.

mod files;
mod polygons;

use std::path::Path;

use sweep_cdt_testing::{Input, clouds, segments};

/// What a data set holds.
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
    /// What it is one size of, for the plot.
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
    Plan { family: "polygons", kind: Kind::Polygons, size: 10, make: polygons::polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 30, make: polygons::polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 100, make: polygons::polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 1_000, make: polygons::polygons, aim: THIRD_OF_EXACT },
    Plan { family: "polygons", kind: Kind::Polygons, size: 5_000, make: polygons::polygons, aim: THIRD_OF_EXACT },
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
    let files = files::sets(folder).filter(move |set| !quick || set.points() <= QUICK);
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
