//! Rough closed outlines, like those of islands: each in a cell of a lattice, seen whole from its middle, so
//! that no two edges cross.

use sweep_cdt_testing::{Input, Random};

use super::curves::direction;

/// How many vertices an outline has: four times a power of two makes the displacement simple.
const VERTICES: usize = 256;

pub(super) fn outlines(n: usize, random: &mut Random) -> Input {
    let count = n.div_ceil(VERTICES);
    let side = count.isqrt().max(1);
    let mut input = Input::default();
    for cell in 0..count {
        let centre = [cell % side, cell / side].map(|x| x as f64);
        let first = input.points.len();
        for (i, radius) in radii(random).into_iter().enumerate() {
            let quarter = VERTICES / 4;
            let [x, y] = direction(i / quarter, (i % quarter) as f64 / quarter as f64);
            input
                .points
                .push([centre[0] + radius * x, centre[1] + radius * y]);
            input.edges.push([first + i, first + (i + 1) % VERTICES]);
        }
    }
    input
}

/// Distances from the middle, by displacing middles of ever shorter arcs by ever less.
fn radii(random: &mut Random) -> Vec<f64> {
    let mut radii = vec![0.3; VERTICES];
    let (mut arc, mut by) = (VERTICES, 0.15);
    while arc > 1 {
        for start in (0..VERTICES).step_by(arc) {
            let mean = (radii[start] + radii[(start + arc) % VERTICES]) / 2.0;
            let radius = mean + by * (random.unit() - 0.5);
            radii[start + arc / 2] = radius.clamp(0.1, 0.49);
        }
        (arc, by) = (arc / 2, by * 0.6);
    }
    radii
}
