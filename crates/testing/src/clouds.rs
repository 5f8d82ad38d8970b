//! Random points without edges, and random segments that do not cross, for benchmarks.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use sweep_cdt::scalar::orient2d;
use sweep_cdt_generate::Random;

use crate::Input;

/// Uniform points in the unit square.
pub fn uniform(n: usize) -> Input {
    Input::generated("uniform", n, 1)
}

/// Normal distributions around 100 uniform centres.
pub fn clusters(n: usize) -> Input {
    let mut random = Random::new(2);
    let centres = random.points(100);
    let near = |_| {
        let [x, y] = centres[random.below(centres.len())];
        // Box and Muller's transformation; one minus the unit is not 0.
        let radius = 0.003 * (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    points((0..n).map(near).collect())
}

/// One cluster, whose density falls with a power of the distance from its centre.
pub fn power_law(n: usize) -> Input {
    let mut random = Random::new(3);
    let near = |_| {
        let radius = random.unit().powi(6);
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        [radius * cos, radius * sin]
    };
    points((0..n).map(near).collect())
}

/// A square lattice, row by row.
pub fn lattice(n: usize) -> Input {
    Input::generated("lattice-in-order", n, 4)
}

/// A square lattice in random order.
pub fn shuffled_lattice(n: usize) -> Input {
    Input::generated("lattice", n, 4)
}

/// Points on the unit circle, as far as doubles can be, in random order.
pub fn circle(n: usize) -> Input {
    let point = |i| {
        let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
        [cos, sin]
    };
    let mut list: Vec<_> = (0..n).map(point).collect();
    Random::new(5).shuffle(&mut list);
    points(list)
}

fn points(points: Vec<[f64; 2]>) -> Input {
    let edges = Vec::new();
    Input { points, edges }
}

/// Half as many segments as points, at random places, in random directions and up to twice as long as they
/// are apart. One that meets an earlier one is drawn again.
pub fn segments(points: usize) -> Input {
    let count = points / 2;
    let mut random = Random::new(6);
    let mut grid = Grid::new(count);
    let mut input = Input::default();
    while input.edges.len() < count {
        let [x, y] = [random.unit(), random.unit()];
        let length = 2.0 * random.unit() / (count as f64).sqrt();
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        let ends = [[x, y], [x + length * cos, y + length * sin]];
        if grid.add(ends) {
            let first = input.points.len();
            input.points.extend(ends);
            input.edges.push([first, first + 1]);
        }
    }
    input
}

/// Segments in square cells by their first ends; a cell is as wide as a segment may be long.
struct Grid {
    width: usize,
    cells: Vec<Vec<[[f64; 2]; 2]>>,
}

impl Grid {
    fn new(segments: usize) -> Grid {
        let width = (segments.isqrt() / 2).max(1);
        Grid {
            width,
            cells: vec![Vec::new(); width * width],
        }
    }

    /// Adds a segment, unless it meets another one.
    fn add(&mut self, segment: [[f64; 2]; 2]) -> bool {
        let [column, row] = segment[0].map(|c| self.place(c));
        // The first ends of two segments that meet are less than two cells apart.
        let near = |i: usize| i.saturating_sub(2)..self.width.min(i + 3);
        let is_free = near(row).all(|row| {
            near(column).all(|column| {
                let others = &self.cells[row * self.width + column];
                others.iter().all(|other| !meet(segment, *other))
            })
        });
        if is_free {
            self.cells[row * self.width + column].push(segment);
        }
        is_free
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to 1"
    )]
    fn place(&self, coordinate: f64) -> usize {
        ((coordinate * self.width as f64) as usize).min(self.width - 1)
    }
}

/// Whether two segments meet; true of some that only lie on one line.
fn meet([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let turn = orient2d;
    let is_between = |one: Ordering, other: Ordering| one != other || one == Ordering::Equal;
    is_between(turn(&a, &b, &c), turn(&a, &b, &d)) && is_between(turn(&c, &d, &a), turn(&c, &d, &b))
}
