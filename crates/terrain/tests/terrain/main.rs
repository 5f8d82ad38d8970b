//! Contour lines and heights, compared with what the definition says in whole numbers, triangle by triangle and without
//! the code under test.

mod contours;
mod heights;
mod levels;
mod passing;
mod places;

use sweep_cdt::Triangulation;
use sweep_cdt_generate::Random;

/// A number from `0` to `most`.
fn below(random: &mut Random, most: u64) -> i64 {
    i64::try_from(random.bits() % (most + 1)).expect("a small number")
}

/// Points of a small lattice, many of them equal or on one line, with small whole heights, some of them missing.
struct Lattice {
    points: Vec<[i64; 2]>,
    heights: Vec<Option<i64>>,
}

impl Lattice {
    fn new(random: &mut Random, missing: bool) -> Lattice {
        let count = 3 + below(random, 40);
        let (size, steps) = (2 + below(random, 10), below(random, 6));
        let [size, steps] = [size, steps].map(i64::unsigned_abs);
        let points = (0..count).map(|_| [below(random, size), below(random, size)]);
        let points: Vec<[i64; 2]> = points.collect();
        let heights = points.iter().map(|_| {
            let height = below(random, steps);
            (!missing || below(random, 9) > 0).then_some(height)
        });
        let mut heights: Vec<Option<i64>> = heights.collect();
        // Equal points have equal heights.
        for v in 0..points.len() {
            let first = points.iter().position(|point| *point == points[v]);
            heights[v] = heights[first.expect("itself")];
        }
        Lattice { points, heights }
    }

    fn doubles(&self) -> Vec<[f64; 2]> {
        let double = |point: &[i64; 2]| point.map(|x| x as f64);
        self.points.iter().map(double).collect()
    }

    fn known(&self) -> Vec<f64> {
        let known = |height: &Option<i64>| height.map_or(f64::NAN, |height| height as f64);
        self.heights.iter().map(known).collect()
    }

    /// The triangles whose corners all have heights, with these.
    fn triangles(&self, result: &Triangulation) -> Vec<([usize; 3], [i64; 3])> {
        let known = |corners: [usize; 3]| {
            let [a, b, c] = corners.map(|v| self.heights[v]);
            Some((corners, [a?, b?, c?]))
        };
        result.triangles().filter_map(known).collect()
    }
}

fn triangulated(points: &[[f64; 2]]) -> Triangulation {
    sweep_cdt::triangulate(points, &[]).expect("points alone can be triangulated")
}
