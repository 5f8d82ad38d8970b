//! An input in doubles, and how it is written in the table of cases.

use std::fmt;
use std::str::FromStr;

/// Points and edges, as [`sweep_cdt::triangulate`] takes them.
#[derive(Clone, Debug, Default)]
pub struct Input {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// The edges, as positions in `points`; not checked.
    pub edges: Vec<[usize; 2]>,
}

impl Input {
    /// Reads `"0 0, 1.5 2, -3 1e300"` and `"0 1, 2 0"`.
    pub fn parse(points: &str, edges: &str) -> Input {
        Input {
            points: pairs(points),
            edges: pairs(edges),
        }
    }

    /// The same input with point `order[i]` as point `i`.
    pub fn permuted(&self, order: &[usize]) -> Input {
        let mut place = vec![0; order.len()];
        for (i, &v) in order.iter().enumerate() {
            place[v] = i;
        }
        Input {
            points: order.iter().map(|&v| self.points[v]).collect(),
            edges: self
                .edges
                .iter()
                .map(|edge| edge.map(|v| place[v]))
                .collect(),
        }
    }
}

fn pairs<T: FromStr>(text: &str) -> Vec<[T; 2]> {
    let pair = |pair: &str| {
        let mut numbers = pair.split_whitespace().map(|number| number.parse().ok());
        let mut next = || {
            numbers
                .next()
                .flatten()
                .unwrap_or_else(|| panic!("two numbers: {pair}"))
        };
        let pair = [next(), next()];
        assert!(numbers.next().is_none(), "two numbers, not three");
        pair
    };
    text.split(',')
        .filter(|pair| !pair.trim().is_empty())
        .map(pair)
        .collect()
}

/// A row of the table, ready to be pasted.
impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points: Vec<String> = self
            .points
            .iter()
            .map(|[x, y]| format!("{x:?} {y:?}"))
            .collect();
        let edges: Vec<String> = self.edges.iter().map(|[a, b]| format!("{a} {b}")).collect();
        write!(
            f,
            "(\"name\", {:?}, {:?}),",
            points.join(", "),
            edges.join(", ")
        )
    }
}
