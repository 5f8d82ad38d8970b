//! The oracle itself against another program, and against the local tests of `check`.

use arbitrary::Unstructured;
use sweep_cdt_testing::generators::{Shape, read_shape, small};
use sweep_cdt_testing::oracle::{Verdict, check_found, verdict};
use sweep_cdt_testing::peers;

use sweep_cdt_testing::Random;

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

#[test]
fn triangles_by_definition_pass_the_local_tests() {
    let mut crossing = 0;
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let input = small(&mut random);
        match verdict(&input.points, &input.edges) {
            Ok(answer) => check_found(&input.points, &input.edges, &answer),
            Err(_) => crossing += 1,
        }
    }
    println!("{crossing} of 1000 inputs have crossing edges");
    assert!(
        (50..500).contains(&crossing),
        "{crossing} of 1000 inputs have crossing edges"
    );
}

#[test]
fn fans_start_at_the_leftmost_upper_vertex() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let triangles = |edges: &[[usize; 2]]| verdict(&square, edges).map(|answer| answer.triangles);
    assert_eq!(triangles(&[]), Ok(vec![[0, 1, 3], [1, 2, 3]]));
    assert_eq!(triangles(&[[0, 2]]), Ok(vec![[0, 1, 2], [0, 2, 3]]));
    let crossing: Verdict = verdict(&square, &[[0, 2], [1, 3]]);
    assert_eq!(crossing, Err(vec![[0, 1]]));
}
