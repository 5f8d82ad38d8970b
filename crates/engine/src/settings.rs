//! Algorithms, search structures of the front and heuristics, by name. They change the time and never the result.

use std::fmt;

use sweep_cdt::front::{FrontSearch, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Algorithm, Error, Heuristics, Triangulation, Triangulator, Watch};

/// One of several values, by name.
#[derive(Clone, Copy, Debug)]
pub struct Choice<T> {
    /// The name.
    pub name: &'static str,
    /// What it is, in a few words.
    pub about: &'static str,
    /// The value.
    pub value: T,
}

const fn choice<T>(name: &'static str, value: T, about: &'static str) -> Choice<T> {
    Choice { name, about, value }
}

/// The algorithms; the default comes first.
pub const ALGORITHMS: [Choice<Algorithm>; 3] = [
    choice(
        "auto",
        Algorithm::Auto,
        "The sweep, where flips are many with the paper's heuristics; divide and conquer where it would take too long",
    ),
    choice(
        "sweep",
        Algorithm::Sweep,
        "The sweep, to its end; traces always show the sweep",
    ),
    choice(
        "divide-and-conquer",
        Algorithm::DivideAndConquer,
        "Divide and conquer, then the edges one by one",
    ),
];

/// The search structures of the front; the default comes first.
pub const FRONTS: [Choice<FrontKind>; 3] = [
    choice("hash", FrontKind::Hash, "Hash table over x, the paper's"),
    choice("skip-list", FrontKind::SkipList, "Skip list"),
    choice(
        "linear",
        FrontKind::Linear,
        "Walk from the node inserted last; slow for many points",
    ),
];

/// The heuristics; the default comes first.
pub const HEURISTICS: [Choice<Heuristics>; 3] = [
    choice("fast", Heuristics::FAST, "The angles measured as fastest"),
    choice("paper", Heuristics::PAPER, "The paper's pi/2 and 3pi/4"),
    choice("off", Heuristics::OFF, "None"),
];

/// A kind of search structure of the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrontKind {
    /// The default, which the sweep calls directly.
    #[default]
    Hash,
    /// A skip list.
    SkipList,
    /// A walk from the node inserted last.
    Linear,
}

/// A name that is not one of those known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName(String);

impl UnknownName {
    /// `name` is no `what`; the known ones are these.
    pub fn new<'a>(
        what: &str,
        name: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> UnknownName {
        let known = known.into_iter().collect::<Vec<_>>().join(", ");
        UnknownName(match known.is_empty() {
            true => format!("there is no {what} {name:?}, nor any other {what}"),
            false => format!("{what} {name:?} is not one of {known}"),
        })
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UnknownName {}

/// The value of this name; `what` is what messages call it.
///
/// # Errors
/// None has it.
///
/// ```
/// use sweep_cdt_engine::{FRONTS, FrontKind, chosen};
///
/// assert_eq!(chosen("front", &FRONTS, "linear")?, FrontKind::Linear);
/// let error = chosen("front", &FRONTS, "tree").unwrap_err();
/// assert_eq!(error.to_string(), r#"front "tree" is not one of hash, skip-list, linear"#);
/// # Ok::<(), sweep_cdt_engine::UnknownName>(())
/// ```
pub fn chosen<T: Copy>(what: &str, choices: &[Choice<T>], name: &str) -> Result<T, UnknownName> {
    let found = choices.iter().find(|choice| choice.name == name);
    let known = choices.iter().map(|choice| choice.name);
    found
        .map(|choice| choice.value)
        .ok_or_else(|| UnknownName::new(what, name, known))
}

/// How the sweep runs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Settings {
    /// The algorithm.
    pub algorithm: Algorithm,
    /// The search structure of the front.
    pub front: FrontKind,
    /// The heuristics.
    pub heuristics: Heuristics,
}

impl Settings {
    /// The settings of these names.
    ///
    /// # Errors
    /// One is not known.
    pub fn named(algorithm: &str, front: &str, heuristics: &str) -> Result<Settings, UnknownName> {
        Ok(Settings {
            algorithm: chosen("algorithm", &ALGORITHMS, algorithm)?,
            front: chosen("front", &FRONTS, front)?,
            heuristics: chosen("heuristics", &HEURISTICS, heuristics)?,
        })
    }

    /// The library's call with the algorithm and the heuristics.
    pub fn triangulator(&self) -> Triangulator {
        Triangulator::new()
            .algorithm(self.algorithm)
            .heuristics(self.heuristics)
    }

    /// Triangulates with all three, on one thread.
    ///
    /// # Errors
    /// Those of the library.
    pub fn run<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        watch: Watch<'_>,
    ) -> Result<Triangulation, Error> {
        let mut front: Box<dyn FrontSearch> = match self.front {
            FrontKind::Hash => return self.triangulator().run(points, edges, watch),
            FrontKind::SkipList => Box::new(SkipList::default()),
            FrontKind::Linear => Box::new(Linear::default()),
        };
        self.triangulator()
            .run(points, edges, watch.front(&mut *front))
    }
}
