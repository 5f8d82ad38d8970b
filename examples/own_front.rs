//! Your own front: a search structure with a parameter and a counter, compared with the three that are
//! built in.
//!
//!     cargo run --release --example own_front
//!
//! `Recent` remembers the last few vertices that joined the front, and starts at the nearest of them. A
//! search structure changes the number of steps along the front, never the triangles.

use std::collections::VecDeque;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::{Algorithm, Error, Stats, Triangulator, Watch};

/// The last `size` vertices put on the front, each with its x.
#[derive(Default)]
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
    measure("hash table", &mut HashTable::default(), &points)?;
    measure("skip list", &mut SkipList::default(), &points)?;
    measure("linear", &mut Linear::default(), &points)?;
    for size in [1, 10, 100] {
        let mut front = Recent {
            size,
            ..Recent::default()
        };
        measure(&format!("recent {size}"), &mut front, &points)?;
        println!("{:>49}", front.compared);
    }
    Ok(())
}

/// Triangulates, and prints the steps and the time.
fn measure(name: &str, front: &mut dyn FrontSearch, points: &[[f64; 2]]) -> Result<(), Error> {
    let mut stats = Stats::default();
    let watch = Watch::new().front(front).stats(&mut stats);
    // The default algorithm abandons a sweep whose walks are long.
    let triangulator = Triangulator::new().algorithm(Algorithm::Sweep);
    triangulator.run(points, &[], watch)?;
    let steps = stats.counters.front_steps;
    println!("{name:<12} {steps:>14} {:>10.2?}", stats.sweeping);
    Ok(())
}

/// Points all over a square, by the fractional parts of multiples of two irrational numbers.
fn scattered(count: u32) -> Vec<[f64; 2]> {
    let point = |i| [0.754_877_666, 0.569_840_290].map(|step: f64| (f64::from(i) * step).fract());
    (0..count).map(point).collect()
}
