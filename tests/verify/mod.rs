//! The verifier must pass what is right and name what is wrong.
//!
//! Here: triangulations to verify and to break.

mod bent;
mod broken;
mod chunks;
mod depths;
mod domains;
mod faults;
mod growth;
mod levels;
mod matching;
mod reports;
mod violations;

use std::collections::HashSet;

use sweep_cdt::triangulate;
use sweep_cdt::verify::{Report, Violations, verify};
use sweep_cdt_testing::Random;

/// A triangulation to break.
#[derive(Clone, Debug, Default)]
struct Case {
    points: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    triangles: Vec<[usize; 3]>,
}

impl Case {
    fn of(points: Vec<[f64; 2]>, edges: &[[usize; 2]]) -> Case {
        let triangles = triangulate(&points, edges).unwrap().triangles().collect();
        Case {
            points,
            edges: edges.to_vec(),
            triangles,
        }
    }

    fn literal(points: &[[f64; 2]], triangles: &[[usize; 3]]) -> Case {
        Case {
            points: points.to_vec(),
            edges: vec![],
            triangles: triangles.to_vec(),
        }
    }

    fn verify(&self) -> Result<Report, Violations> {
        verify(&self.points, &self.edges, &self.triangles)
    }

    /// A triangle and its neighbour across its first side, if that is an inner side.
    fn neighbor(&self, t: usize) -> Option<usize> {
        let [a, b, _] = self.triangles[t];
        self.triangles
            .iter()
            .position(|u| (0..3).any(|i| [u[(i + 1) % 3], u[i]] == [a, b]))
    }

    /// A triangle none of whose corners is on the hull.
    fn inner_triangle(&self) -> usize {
        let hull: HashSet<usize> = triangulate(&self.points, &[]).unwrap().hull().collect();
        self.triangles
            .iter()
            .position(|t| t.iter().all(|v| !hull.contains(v)))
            .unwrap()
    }

    /// Replaces the diagonal of two triangles by the other one, where that leaves both of them
    /// counter-clockwise.
    fn flip(&mut self) {
        for t in 0..self.triangles.len() {
            let Some(u) = self.neighbor(t) else { continue };
            let [a, b, c] = self.triangles[t];
            let d = *self.triangles[u]
                .iter()
                .find(|v| ![a, b].contains(v))
                .unwrap();
            let mut flipped = self.clone();
            flipped.triangles[t] = [c, a, d];
            flipped.triangles[u] = [d, b, c];
            if flipped
                .verify()
                .is_err_and(|e| e.list[0].name() == "not-delaunay")
            {
                *self = flipped;
                return;
            }
        }
        panic!("nothing to flip");
    }
}

fn random() -> Case {
    Case::of(Random::new(1).points(60), &[])
}

fn constrained() -> Case {
    let mut case = random();
    // The longest edges are no Delaunay edges.
    case.edges = (0..60).step_by(2).map(|a| [a, (a + 1) % 60]).collect();
    while let Err(sweep_cdt::Error::CrossingEdges { edges: [_, b] }) =
        triangulate(&case.points, &case.edges)
    {
        case.edges.remove(b);
    }
    Case::of(case.points, &case.edges)
}

/// A square with its upper right corner moved inwards by one unit in the last place, so that its
/// diagonal 1-3 is wrong.
fn square(size: f64) -> Case {
    let mut case = Case::literal(&[[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]], &[]);
    case.points[2][0] = size.next_down();
    case.triangles = vec![[0, 1, 3], [1, 2, 3]];
    case
}
