//! The points of each kind of input.

use super::Random;

/// What is special about an input's points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Nothing.
    General,
    /// A corner of the integer lattice.
    Lattice,
    /// Two or three different x.
    Columns,
    /// Two or three different y.
    Rows,
    /// Points inside the line segments between others.
    OnEdges,
    /// Many equal points.
    Duplicates,
    /// All on one line.
    Collinear,
    /// All but a few on one line.
    AlmostCollinear,
    /// On a few common circles, with their centre.
    Cocircular,
    /// Teeth, so that long edges lie above or below many others.
    Comb,
    /// On a parabola.
    Parabola,
    /// Lattice, line or circle with coordinates moved by one unit in the last place.
    Nudged,
    /// The largest, the smallest and ordinary numbers together.
    Extreme,
}

impl Kind {
    pub(crate) const ALL: &[Kind] = &[
        Kind::General,
        Kind::Lattice,
        Kind::Columns,
        Kind::Rows,
        Kind::OnEdges,
        Kind::Duplicates,
        Kind::Collinear,
        Kind::AlmostCollinear,
        Kind::Cocircular,
        Kind::Comb,
        Kind::Parabola,
        Kind::Nudged,
        Kind::Extreme,
    ];
}

/// About half a dozen points of this kind, up to a dozen.
pub(crate) fn points(kind: Kind, random: &mut Random) -> Vec<[f64; 2]> {
    let n = random.below(6) + random.below(7) + usize::from(!random.one_in(20));
    let mut points = match kind {
        Kind::General => repeat(n, || [random.integer(1 << 20), random.integer(1 << 20)]),
        Kind::Lattice => lattice(n, random),
        Kind::Columns => repeat(n, || [random.integer(1), random.integer(9)]),
        Kind::Rows => repeat(n, || [random.integer(9), random.integer(1)]),
        Kind::OnEdges => on_edges(n, random),
        Kind::Duplicates => {
            let few = repeat(n / 2 + 1, || [random.integer(4), random.integer(4)]);
            repeat(n, || random.pick(&few))
        }
        Kind::Collinear => line(n, random),
        Kind::AlmostCollinear => {
            let mut points = line(n, random);
            points.extend(repeat(random.below(3), || {
                [random.integer(9), random.integer(9)]
            }));
            points
        }
        Kind::Cocircular => circle(n, random),
        Kind::Comb => (0..n)
            .map(|i| [2.0 * f64::from(small(i)), tooth(i, random)])
            .collect(),
        Kind::Parabola => (0..n)
            .map(|_| random.integer(6))
            .map(|x| [x, x * x])
            .collect(),
        Kind::Nudged => nudged(n, random),
        Kind::Extreme => {
            let size = random.pick(&[3, SIZES.len()]);
            let sizes: Vec<f64> = (0..size).map(|_| random.pick(SIZES)).collect();
            let number = |random: &mut Random| random.integer(2) * random.pick(&sizes);
            // Exact arithmetic on these takes thousands of bits: fewer points.
            repeat(n.min(8), || [number(random), number(random)])
        }
    };
    if random.one_in(6) && !points.is_empty() {
        let again = random.pick(&points);
        points.push(again);
    }
    points
}

/// From the smallest subnormal to half of the largest double.
const SIZES: &[f64] = &[
    5e-324,
    1e-310,
    1e-300,
    1e-160,
    1e-42,
    1.0,
    3.0,
    1e15,
    1e60,
    1e155,
    1e300,
    f64::MAX / 2.0,
];

fn repeat(n: usize, mut point: impl FnMut() -> [f64; 2]) -> Vec<[f64; 2]> {
    (0..n).map(|_| point()).collect()
}

fn small(i: usize) -> u32 {
    u32::try_from(i).expect("a few points")
}

fn lattice(n: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let size = 1 + small(random.below(3));
    repeat(n, || [random.integer(size), random.integer(size)])
}

/// A few points, and points at exact fractions of the way between two of them.
fn on_edges(n: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let mut points = repeat(n / 2 + 2, || {
        [4.0 * random.integer(4), 4.0 * random.integer(4)]
    });
    for _ in points.len()..n {
        let [a, b] = [random.pick(&points[..2]), random.pick(&points)];
        let quarters = random.pick(&[1.0, 2.0, 3.0]);
        points.push([0, 1].map(|i| a[i] + (b[i] - a[i]) * quarters / 4.0));
    }
    points
}

fn line(n: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let (start, step) = (
        [random.integer(9), random.integer(9)],
        [random.integer(2), random.integer(2)],
    );
    repeat(n, || {
        let k = random.integer(8);
        [start[0] + k * step[0], start[1] + k * step[1]]
    })
}

fn circle(n: usize, random: &mut Random) -> Vec<[f64; 2]> {
    /// Integer points at distance 5 and at distance 25, one of eight by symmetry.
    const FIVE: &[[f64; 2]] = &[[5.0, 0.0], [3.0, 4.0]];
    const TWENTY_FIVE: &[[f64; 2]] = &[[25.0, 0.0], [15.0, 20.0], [7.0, 24.0]];
    let circles = random.pick(&[
        &[FIVE][..],
        &[TWENTY_FIVE],
        &[FIVE, TWENTY_FIVE],
        &[FIVE, &[[0.0, 0.0]]],
    ]);
    let centre = if random.one_in(2) {
        [0.0, 0.0]
    } else {
        [random.integer(99), random.integer(99)]
    };
    repeat(n, || {
        let circle = random.pick(circles);
        let mut point = random.pick(circle);
        if random.one_in(2) {
            point.reverse();
        }
        [0, 1].map(|i| {
            centre[i]
                + if random.one_in(2) {
                    point[i]
                } else {
                    -point[i]
                }
        })
    })
}

/// High for even, low for odd `i`.
fn tooth(i: usize, random: &mut Random) -> f64 {
    let height = if i.is_multiple_of(2) { 8.0 } else { 1.0 };
    height
        + if random.one_in(3) {
            random.integer(2)
        } else {
            0.0
        }
}

fn nudged(n: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let kind = random.pick(&[
        Kind::Lattice,
        Kind::Cocircular,
        Kind::Collinear,
        Kind::OnEdges,
    ]);
    let scale = random.pick(&[1.0, 0.1, 1.0 / 3.0, 1e-9]);
    let mut points = points(kind, random);
    points.truncate(n);
    for point in &mut points {
        *point = point.map(|x| match (x * scale, random.below(4)) {
            (x, 0) => x.next_up(),
            (x, 1) => x.next_down(),
            (x, _) => x,
        });
    }
    points
}
