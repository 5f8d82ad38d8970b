//! Your own front: a search structure with a parameter and a counter, compared with the three that are
//! built in.
//!
//!     cargo run --release --example own_front
//!
//! `Recent` remembers the last few vertices that joined the front, and starts at the nearest of them. A
//! search structure changes the number of steps along the front, never the triangles.

use std::collections::VecDeque;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::{Error, Run, Triangulator};

/// The last `size` vertices put on the front, each with its x.
#[derive(Clone, Default)]
struct Recent {
    size: usize,
    nodes: VecDeque<(FrontNode, f64)>,
    /// How many vertices the searches have compared.
    compared: usize,
}

impl FrontSearch for Recent {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.nodes.clear();
        self.compared = 0;
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.nodes.retain(|&(node, _)| front.contains(node));
        self.compared += self.nodes.len();
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
    }
}

fn main() -> Result<(), Error> {
    let points = scattered(20_000);
    println!("front        steps along it   sweeping   compared");
    measure("hash table", HashTable::default(), &points)?;
    measure("skip list", SkipList::default(), &points)?;
    measure("linear", Linear::default(), &points)?;
    for size in [1, 10, 100] {
        let front = Recent {
            size,
            ..Recent::default()
        };
        let front = measure(&format!("recent {size}"), front, &points)?;
        println!("{:>49}", front.compared);
    }
    Ok(())
}

/// Triangulates, prints the steps and the time, and returns the front.
fn measure<F: FrontSearch + Clone>(name: &str, front: F, points: &[[f64; 2]]) -> Result<F, Error> {
    let Run { stats, front, .. } = Triangulator::new()
        .front(front)
        .triangulate_with_stats(points, &[])?;
    let steps = stats.counters.front_steps;
    println!("{name:<12} {steps:>14} {:>10.2?}", stats.sweeping);
    Ok(front)
}

/// Points all over a square, by the fractional parts of multiples of two irrational numbers.
fn scattered(count: u32) -> Vec<[f64; 2]> {
    let point = |i| [0.754_877_666, 0.569_840_290].map(|step: f64| (f64::from(i) * step).fract());
    (0..count).map(point).collect()
}
