//! A front structure may be slow, but never changes a step; and it keeps to its contract alone, too.
//!
//! Half of the inputs are swept with every structure, one of which names nodes that are as bad as can be:
//! the events must be those of the first. The other half is no input of a sweep: points go on and off a
//! front in ways that no sweep would take, and a list of them is the judge (`alone`).

mod alone;

use arbitrary::Unstructured;
use sweep_cdt::Heuristics;
use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch};
use sweep_cdt_testing::fronts::FrontKind;

use crate::reached;
use sweep_cdt_testing::Steps;
use sweep_cdt_testing::{Input, generators};

/// The property for the choices and the input, or the changes of a front, that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let mut bytes = Unstructured::new(bytes);
    // Reading is total but for a type that has no values.
    let choices: u64 = bytes.arbitrary().unwrap_or_default();
    if choices & 1 == 0 {
        let input = generators::read(&mut bytes).unwrap_or_default();
        reached::sample(&input);
        judge(&input, choices >> 1);
    } else {
        alone::test(&mut bytes).unwrap_or_default();
    }
}

/// The input that the bytes stand for, if it is swept.
pub fn input(bytes: &[u8]) -> Option<Input> {
    let (choices, input) = generators::input_with_choices(bytes);
    (choices & 1 == 0).then_some(input)
}

/// Panics unless the sweep of this input, all of whose coordinates are finite, takes the same steps with
/// every structure.
fn judge(Input { points, edges }: &Input, choices: u64) {
    let settings = [Heuristics::FAST, Heuristics::PAPER, Heuristics::OFF];
    let heuristics = settings[(choices % 3) as usize];
    let steps = Steps::of(points, edges, heuristics);
    for (name, front) in FrontKind::ALL {
        steps.assert_same(points, edges, front, name);
    }
    let astray = Astray::default();
    steps.assert_same_with(points, edges, astray, "a structure that leads astray");
    steps.assert_same_with(points, edges, Idle, "a structure that knows nothing");
}

/// Names both ends and all nodes ever inserted in turn, as far as they are on the front.
#[derive(Clone, Default)]
struct Astray {
    nodes: Vec<FrontNode>,
    turn: usize,
}

impl FrontSearch for Astray {
    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        self.turn += 1;
        match self.turn % 3 {
            0 => front.left_end(),
            1 => front.right_end(),
            _ => {
                let node = self.nodes[self.turn % self.nodes.len()];
                if front.contains(node) {
                    node
                } else {
                    front.right_end()
                }
            }
        }
    }

    fn inserted(&mut self, node: FrontNode, _: f64) {
        self.nodes.push(node);
    }
}

/// Names the same end always.
#[derive(Clone, Default)]
struct Idle;

impl FrontSearch for Idle {
    fn begin(&mut self, domain: Domain<'_>) {
        let count = domain.len();
        assert_eq!(domain.is_empty(), count == 0);
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.right_end()
    }
}
