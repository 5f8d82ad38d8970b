//! Every structure takes the same steps to the same triangles, those of the crate's default.

use sweep_cdt::Heuristics;
use sweep_cdt_experiments::standard;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::{Input, Random, Steps, generators};

/// Hard inputs of more points would take long with every structure.
const LARGEST: usize = 3000;
/// Random inputs, and bytes for each.
const CASES: u64 = 400;
const BYTES: usize = 160;

fn assert_same(Input { points, edges }: &Input, heuristics: Heuristics, from: &str) {
    let steps = Steps::of(points, edges, heuristics);
    for contestant in standard() {
        let name = format!("{} on {from}", contestant.name());
        steps.assert_same_with(points, edges, contestant.front().clone(), &name);
    }
}

#[test]
fn on_inputs_that_broke_other_programs() {
    let hard = Hard::own();
    let small = || {
        hard.iter()
            .filter(|hard| hard.input.points.len() <= LARGEST)
    };
    assert!(small().count() > 100, "there are hard inputs");
    for hard in small() {
        assert_same(&hard.input, Heuristics::FAST, &hard.name);
    }
}

#[test]
fn on_random_degenerate_inputs() {
    for seed in 0..CASES {
        let input = generators::input(&Random::new(seed).bytes(BYTES));
        let heuristics = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
        let heuristics = heuristics[(seed % 3) as usize];
        assert_same(&input, heuristics, &format!("random input {seed}"));
    }
}
