//! A fractal terrain: even heights on a square lattice, by midpoint displacement (Fournier, Fussell and
//! Carpenter 1982) in integers.

use sweep_cdt_testing::Random;

#[derive(Clone, Debug)]
pub(super) struct Terrain {
    /// Cells of the lattice in a row; a power of two.
    pub(super) side: usize,
    heights: Vec<i64>,
}

/// The heights of the corners differ by about this much; of each four times shorter step by a fraction.
const ROUGH: i64 = 1 << 30;

impl Terrain {
    pub(super) fn new(side: usize, random: &mut Random) -> Terrain {
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
    pub(super) fn height(&self, x: usize, y: usize) -> i64 {
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
