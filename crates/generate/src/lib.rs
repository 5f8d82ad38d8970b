//! Generated data by kind, number of points and seed: the same bytes on every platform.
//!
//! Only `+ - * /`, square roots and integers make coordinates: these are rounded alike everywhere, sines and
//! powers are not. What is random comes from [`Random`]. Every kind can be triangulated at every size: edges
//! meet at their ends only, or at a vertex. Time and memory are proportional to the number of points.
//!
//! ```
//! use sweep_cdt_generate::Kind;
//!
//! let parcels = Kind::named("parcels").expect("there is such a kind").graph(1000, 1);
//! let result = sweep_cdt::triangulate(&parcels.points, &parcels.edges)?;
//! assert!(parcels.edges.len() > parcels.points.len());
//! assert!(result.len() > parcels.edges.len());
//! # Ok::<(), sweep_cdt::Error>(())
//! ```

mod contours;
mod edges;
mod points;
mod random;

pub use random::Random;

use sweep_cdt::Pslg;

/// A kind of data.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// The kind's name, a word.
    pub name: &'static str,
    /// The description, in a line.
    pub about: &'static str,
    make: Make,
}

/// Points and edges, and the height of each point.
type Terrain = (Pslg<f64>, Vec<f64>);

/// How the data of a kind is made, for a number of points.
#[derive(Clone, Copy, Debug)]
enum Make {
    /// Points and edges in the plane.
    Plane(fn(n: usize, random: &mut Random) -> Pslg<f64>),
    /// Points and edges as above, with a height for each point.
    Terrain(fn(n: usize, random: &mut Random) -> Terrain),
}

impl Kind {
    /// About `n` points for a seed, with their edges: none for 0, and otherwise at least one. The numbers of
    /// points of a lattice, of parcels and of contour lines differ from `n` most where `n` is small.
    pub fn graph(&self, n: usize, seed: u64) -> Pslg<f64> {
        self.graph_and_heights(n, seed).0
    }

    /// The [graph](Kind::graph), and the height of each of its points if it is a terrain: whole numbers, the levels of
    /// contour lines. Levels are so far apart that the slopes are like those of hills whatever `n` is.
    ///
    /// ```
    /// use sweep_cdt_generate::Kind;
    ///
    /// let contours = Kind::named("contours").expect("there is such a kind");
    /// let (graph, heights) = contours.graph_and_heights(1000, 1);
    /// let heights = heights.expect("contour lines have heights");
    /// assert_eq!(graph.points.len(), heights.len());
    /// assert!(graph.edges.iter().all(|&[a, b]| heights[a] == heights[b]));
    /// ```
    pub fn graph_and_heights(&self, n: usize, seed: u64) -> (Pslg<f64>, Option<Vec<f64>>) {
        let random = &mut Random::new(seed);
        match self.make {
            _ if n == 0 => Default::default(),
            Make::Plane(make) => (make(n, random), None),
            Make::Terrain(make) => {
                let (graph, heights) = make(n, random);
                (graph, Some(heights))
            }
        }
    }

    /// The kind of this name.
    pub fn named(name: &str) -> Option<Kind> {
        KINDS.iter().copied().find(|kind| kind.name == name)
    }
}

/// All kinds: points, points with edges, and inputs made against some structure.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "uniform",
        about: "points anywhere in a square",
        make: Make::Plane(points::uniform),
    },
    Kind {
        name: "integers",
        about: "points anywhere with integers below a million as coordinates",
        make: Make::Plane(points::integers),
    },
    Kind {
        name: "clusters",
        about: "twenty clusters, the widest 512 times as wide as the narrowest",
        make: Make::Plane(points::clusters),
    },
    Kind {
        name: "power-law",
        about: "one cluster whose density falls with a power of the distance",
        make: Make::Plane(points::power_law),
    },
    Kind {
        name: "lattice",
        about: "a square lattice, its points in random order",
        make: Make::Plane(points::shuffled_lattice),
    },
    Kind {
        name: "lattice-in-order",
        about: "a square lattice, row by row",
        make: Make::Plane(points::lattice),
    },
    Kind {
        name: "rows",
        about: "sixteen rows of equal y",
        make: Make::Plane(points::rows),
    },
    Kind {
        name: "columns",
        about: "sixteen columns of equal x",
        make: Make::Plane(points::columns),
    },
    Kind {
        name: "circle",
        about: "points on a circle",
        make: Make::Plane(points::circle),
    },
    Kind {
        name: "parabola-up",
        about: "a parabola open above: left and right in turn",
        make: Make::Plane(points::parabola_up),
    },
    Kind {
        name: "parabola-right",
        about: "a parabola open to the right",
        make: Make::Plane(points::parabola_right),
    },
    Kind {
        name: "comb",
        about: "long narrow teeth that hang down, with edges along them",
        make: Make::Plane(edges::comb),
    },
    Kind {
        name: "fans",
        about: "a hundred edges at each upper end",
        make: Make::Plane(edges::fans),
    },
    Kind {
        name: "asterisk",
        about: "edges in all directions through one vertex",
        make: Make::Plane(edges::asterisk),
    },
    Kind {
        name: "segments",
        about: "short edges that do not meet",
        make: Make::Plane(edges::segments),
    },
    Kind {
        name: "outlines",
        about: "rough closed outlines of 256 vertices, nothing inside",
        make: Make::Plane(edges::outlines),
    },
    Kind {
        name: "parcels",
        about: "parcels of land, with the paper's ratio of points to edges",
        make: Make::Plane(edges::parcels),
    },
    Kind {
        name: "contours",
        about: "contour lines of a fractal terrain, with their heights",
        make: Make::Terrain(contours::contours),
    },
    Kind {
        name: "alternating",
        about: "a row, and above it points near its two ends in turn",
        make: Make::Plane(points::alternating),
    },
    Kind {
        name: "above-a-row",
        about: "a row, and points anywhere above it",
        make: Make::Plane(points::above_a_row),
    },
    Kind {
        name: "outliers",
        about: "the same in a four-millionth of the width, between two points far away",
        make: Make::Plane(points::outliers),
    },
    Kind {
        name: "towers",
        about: "a row between two tall strips, whose points come in turn",
        make: Make::Plane(points::towers),
    },
    Kind {
        name: "leftwards",
        about: "half a parabola, each point to the left of all before it",
        make: Make::Plane(points::leftwards),
    },
];

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
