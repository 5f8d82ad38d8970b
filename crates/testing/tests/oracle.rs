//! The oracle against another program.

use arbitrary::Unstructured;
use sweep_cdt_testing::generators::{Shape, read_shape};
use sweep_cdt_testing::oracle::verdict;
use sweep_cdt_testing::{Random, peers};

/// The triangles that `spade` finds, each with its lowest vertex first; sorted.
fn spade_triangles(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Vec<[usize; 3]> {
    let mut triangles = peers::spade(points, edges).expect("finite points");
    for corners in &mut triangles {
        let least = (0..3).min_by_key(|&i| corners[i]).expect("three corners");
        corners.rotate_left(least);
    }
    triangles.sort_unstable();
    triangles
}

#[test]
fn agrees_with_spade_in_general_position() {
    let mut compared = 0;
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let mut bytes = random.bytes(60);
        // Few points, and not so small that the other program refuses them.
        bytes[0] %= 7 << 5;
        bytes[1] %= 12;
        let input = read_shape(Shape::General, &mut Unstructured::new(&bytes)).expect("bytes");
        let Ok(answer) = verdict(&input.points, &input.edges) else {
            continue;
        };
        let has_duplicates = answer
            .representatives
            .iter()
            .enumerate()
            .any(|(v, &of)| v != of);
        if !has_duplicates {
            let triangles = spade_triangles(&input.points, &answer.constrained);
            assert_eq!(answer.triangles, triangles, "seed {seed}: {input}");
            compared += usize::from(!answer.constrained.is_empty() && triangles.len() > 3);
        }
    }
    assert!(
        compared > 300,
        "only {compared} inputs of 1000 were of interest"
    );
}
