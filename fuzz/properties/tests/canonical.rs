//! Changes that must not change a result do not, on small and larger random inputs.

use sweep_cdt_properties::canonical;
use sweep_cdt_testing::generators::{medium, small};
use sweep_cdt_testing::{Random, minimize};

#[test]
fn what_must_not_change_the_result_does_not() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let mut inputs = vec![small(&mut random)];
        if seed % 15 == 0 {
            inputs.push(medium(&mut random));
        }
        for input in inputs {
            minimize::run(&|input| canonical::judge(input, seed), &input, seed);
        }
    }
}
