//! Contour lines (the paper's figure 16c) of a terrain whose lattice is cut into triangles.
//!
//! Levels are odd and heights of corners even, so no line passes through a corner of the lattice. Across a triangle a
//! line is straight, and lines of different levels do not cross. The heights of lines are the numbers of their levels.

use super::random::Random;
use sweep_cdt::Pslg;

pub(super) fn contours(n: usize, random: &mut Random) -> (Pslg<f64>, Vec<f64>) {
    let side = n.isqrt().next_power_of_two().max(4);
    let terrain = Terrain::new(side, random);
    // Levels are this far apart: as many points as asked for, or a few less.
    let (mut low, mut high) = (1, 1 << 40);
    while low < high {
        let middle = (low + high) / 2;
        let lines = Lines {
            terrain: &terrain,
            apart: 2 * middle,
        };
        if lines
            .sides()
            .map(|side| lines.crossings(side))
            .sum::<usize>()
            > n
        {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    let lines = Lines {
        terrain: &terrain,
        apart: 2 * low,
    };
    lines.input()
}

type Corner = [usize; 2];

struct Lines<'a> {
    terrain: &'a Terrain,
    apart: i64,
}

impl Lines<'_> {
    /// The greatest number of a level below the height at a corner.
    fn band(&self, [x, y]: Corner) -> i64 {
        (self.terrain.height(x, y) - 1).div_euclid(self.apart)
    }

    /// How many levels cross a side of a triangle.
    fn crossings(&self, side: [Corner; 2]) -> usize {
        let [from, to] = side.map(|corner| self.band(corner));
        usize::try_from(from.abs_diff(to)).expect("not so many levels")
    }

    /// All sides of triangles: to the right, up, and both. Three for each corner, where they exist.
    fn sides(&self) -> impl Iterator<Item = [Corner; 2]> {
        let side = self.terrain.side;
        let corners = (0..=side).flat_map(move |y| (0..=side).map(move |x| [x, y]));
        corners.flat_map(move |[x, y]| {
            let ends = [[x + 1, y], [x, y + 1], [x + 1, y + 1]];
            ends.into_iter()
                .filter(move |end| end[0] <= side && end[1] <= side)
                .map(move |end| [[x, y], end])
        })
    }

    /// The number of a side among three for each corner.
    fn number(&self, [[x, y], end]: [Corner; 2]) -> usize {
        let way = match [end[0] - x, end[1] - y] {
            [1, 0] => 0,
            [0, 1] => 1,
            _ => 2,
        };
        3 * (y * (self.terrain.side + 1) + x) + way
    }

    fn input(&self) -> (Pslg<f64>, Vec<f64>) {
        let corners = (self.terrain.side + 1) * (self.terrain.side + 1);
        let (mut input, mut heights) = (Pslg::default(), Vec::new());
        // The first point on each side; the others follow from the lowest level up.
        let mut first = vec![0; 3 * corners];
        for side in self.sides() {
            first[self.number(side)] = input.points.len();
            let [from, to] = side.map(|corner| self.band(corner));
            for level in from.min(to) + 1..=from.max(to) {
                input.points.push(self.crossing(side, level));
                heights.push(level as f64);
            }
        }
        let cells = self.terrain.side;
        for y in 0..cells {
            for x in 0..cells {
                let [a, c] = [[x, y], [x + 1, y + 1]];
                for b in [[x + 1, y], [x, y + 1]] {
                    self.cross([[a, b], [b, c], [a, c]], &first, &mut input.edges);
                }
            }
        }
        (input, heights)
    }

    /// Where a level crosses a side.
    fn crossing(&self, [from, to]: [Corner; 2], level: i64) -> [f64; 2] {
        let [low, high] = [from, to].map(|[x, y]| self.terrain.height(x, y));
        let part = (level * self.apart + 1 - low) as f64 / (high - low) as f64;
        [0, 1].map(|axis| from[axis] as f64 + part * (to[axis] - from[axis]) as f64)
    }

    /// The lines across a triangle with these sides: of each level from one side to another.
    fn cross(&self, sides: [[Corner; 2]; 3], first: &[usize], edges: &mut Vec<[usize; 2]>) {
        let bands = sides.map(|side| side.map(|corner| self.band(corner)));
        let all = || bands.iter().flatten().copied();
        let [low, high] = [all().min(), all().max()].map(|band| band.expect("three sides"));
        for level in low + 1..=high {
            let point = |i: usize| {
                let [from, to] = bands[i];
                let below = from.min(to);
                let is_crossed = below < level && level <= from.max(to);
                let place = usize::try_from(level - below - 1);
                is_crossed.then(|| first[self.number(sides[i])] + place.expect("above"))
            };
            let mut points = (0..3).filter_map(point);
            let [from, to] = [points.next(), points.next()]
                .map(|point| point.expect("a level that crosses one side crosses two"));
            edges.push([from, to]);
        }
    }
}

/// A fractal terrain: even heights on a square lattice, by midpoint displacement (Fournier, Fussell and
/// Carpenter 1982) in integers.
#[derive(Clone, Debug)]
struct Terrain {
    /// Cells of the lattice in a row; a power of two.
    side: usize,
    heights: Vec<i64>,
}

/// The heights of the corners differ by about this much; of each four times shorter step by a fraction.
const ROUGH: i64 = 1 << 30;

impl Terrain {
    fn new(side: usize, random: &mut Random) -> Terrain {
        let mut terrain = Terrain {
            side,
            heights: vec![0; (side + 1) * (side + 1)],
        };
        let (mut step, mut rough) = (side, ROUGH);
        while step > 1 {
            let half = step / 2;
            // The middles of squares, then those of their sides.
            for y in (half..side).step_by(step) {
                for x in (half..side).step_by(step) {
                    terrain.displace(
                        x,
                        y,
                        half,
                        [[-1, -1], [-1, 1], [1, -1], [1, 1]],
                        rough,
                        random,
                    );
                }
            }
            for y in (0..=side).step_by(half) {
                let first = if y % step == 0 { half } else { 0 };
                for x in (first..=side).step_by(step) {
                    terrain.displace(
                        x,
                        y,
                        half,
                        [[-1, 0], [1, 0], [0, -1], [0, 1]],
                        rough,
                        random,
                    );
                }
            }
            step = half;
            rough = rough * 9 / 16;
        }
        terrain
    }

    /// The height at a corner of the lattice.
    fn height(&self, x: usize, y: usize) -> i64 {
        self.heights[y * (self.side + 1) + x]
    }

    /// Makes a height the mean of those around it and a random number.
    fn displace(
        &mut self,
        x: usize,
        y: usize,
        distance: usize,
        ways: [[isize; 2]; 4],
        rough: i64,
        random: &mut Random,
    ) {
        let inside = |x: usize, way: isize| {
            let x = match way {
                -1 => x.checked_sub(distance)?,
                0 => x,
                _ => x + distance,
            };
            (x <= self.side).then_some(x)
        };
        let around: Vec<i64> = ways
            .iter()
            .filter_map(|&[dx, dy]| Some(self.height(inside(x, dx)?, inside(y, dy)?)))
            .collect();
        let mean = around.iter().sum::<i64>() / around.len() as i64;
        let by = random.bits() as i64 % rough;
        self.heights[y * (self.side + 1) + x] = (mean + by) / 2 * 2;
    }
}
