//! Families of inputs that grow: each gives an input of about `n` points, for every `n`.
//!
//! Each family attacks a promise about time. The bench `growth` of `benches/peers` measures how time and
//! memory grow; the tests compare small members with the oracle.

mod crossed;
mod hubs;
mod outlines;
mod points;
mod slanted;

use sweep_cdt_generate::Random;

use crate::Input;
pub use crossed::{Crossed, crossed};
pub use points::Family;

/// All families.
pub fn all() -> impl Iterator<Item = Family> {
    let parts = [
        points::ROWS,
        outlines::CHAINS,
        outlines::OUTLINES,
        hubs::HUBS,
        points::CROWDS,
    ];
    parts.into_iter().flatten().copied()
}

/// The families of edges that some order of insertion makes quadratic.
pub fn slanted() -> impl Iterator<Item = Family> {
    let parts = [
        slanted::HATCHES,
        slanted::ZIGZAGS,
        slanted::RINGS,
        slanted::STARS,
    ];
    parts.into_iter().flatten().copied()
}

/// The input with its points in a scattered order.
pub fn scattered(input: &Input) -> Input {
    let n = input.points.len();
    // A prime: coprime to every smaller n and to most larger ones.
    let stride = [7_368_787, 7_368_791]
        .into_iter()
        .find(|&p| !n.is_multiple_of(p));
    let stride = stride.expect("no n is a multiple of both");
    let order: Vec<usize> = (0..n).map(|i| i * stride % n).collect();
    input.permuted(&order)
}

/// An order in which points and edges are given.
#[derive(Clone, Copy, Debug)]
pub enum Order {
    /// As the family makes them.
    Natural,
    /// From the last to the first.
    Reversed,
    /// At random, the same at each call.
    Shuffled,
}

impl Order {
    /// All orders.
    pub const ALL: [Order; 3] = [Order::Natural, Order::Reversed, Order::Shuffled];

    /// The input in this order.
    pub fn of(self, input: &Input) -> Input {
        let mut random = Random::new(9);
        let mut places: Vec<usize> = (0..input.points.len()).collect();
        self.arrange(&mut places, &mut random);
        let mut input = input.permuted(&places);
        self.arrange(&mut input.edges, &mut random);
        input
    }

    fn arrange<T>(self, list: &mut [T], random: &mut Random) {
        match self {
            Order::Natural => {}
            Order::Reversed => list.reverse(),
            Order::Shuffled => random.shuffle(list),
        }
    }
}
