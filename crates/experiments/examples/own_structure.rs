//! A structure of your own beside all others: in the report, the CSV file and the plots.
//!
//!     cargo run --release -p sweep-cdt-experiments --example own_structure -- fronts --quick
//!
//! A crate of your own needs `sweep-cdt` and `sweep-cdt-experiments`, by the path of a clone, and this as its
//! `main.rs`; then it is `cargo run --release -- fronts --quick`.
//!
//! `Recent` starts at the nearest of the last few vertices that joined the front. It counts the distances
//! that it looks at; a structure that counts nothing leaves `impl Structure for ... {}` empty.

use std::collections::VecDeque;
use std::process::ExitCode;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};
use sweep_cdt_experiments::fronts::Structure;
use sweep_cdt_experiments::{Contestant, main_with};

/// The last `size` vertices that joined the front, each with its x.
#[derive(Clone)]
struct Recent {
    size: usize,
    nodes: VecDeque<(FrontNode, f64)>,
    work: Work,
}

impl Recent {
    fn new(size: usize) -> Recent {
        Recent {
            size,
            nodes: VecDeque::new(),
            work: Work::default(),
        }
    }
}

impl FrontSearch for Recent {
    fn begin(&mut self, _: FrontInput<'_>) {
        *self = Recent::new(self.size);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.nodes.retain(|&(node, _)| front.contains(node));
        self.work.visited += self.nodes.len() as u64;
        self.work.comparisons += self.nodes.len() as u64;
        let distance = |entry: &&(FrontNode, f64)| (entry.1 - x).abs();
        let nearest = |a: &_, b: &_| distance(a).total_cmp(&distance(b));
        let found = self.nodes.iter().min_by(nearest);
        found.map_or(front.left_end(), |&(node, _)| node)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.nodes.push_back((node, x));
        if self.nodes.len() > self.size {
            self.nodes.pop_front();
        }
        self.work.updates += 1;
        self.work.hold::<(FrontNode, f64)>(self.nodes.len());
    }
}

impl Structure for Recent {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

fn main() -> ExitCode {
    main_with([Contestant::new("the last ten", Recent::new(10)).linear()])
}
