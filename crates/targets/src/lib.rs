//! What is compared between two machines: inputs of every kind, computed without the mathematical
//! library of a platform, and a line for each of them with the triangles, the steps and the verdict.

use std::fmt::Debug;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::verify;
use sweep_cdt::{Algorithm, Error, Triangulator, Watch, triangulate};

/// One line for each case.
pub fn report() -> Vec<String> {
    let mut lines = Vec::new();
    for (name, points) in whole_numbers() {
        all_scalars(name, &points, &mut lines);
    }
    for (name, points) in doubles() {
        lines.push(line(&format!("{name} f64"), &points));
    }
    lines
}

/// Points that every scalar can hold.
fn whole_numbers() -> Vec<(&'static str, Vec<[i32; 2]>)> {
    let lattice = (0..20).flat_map(|x| (0..20).map(move |y| [x, y])).collect();
    // All points of one circle with whole coordinates: 65^2 has many sums of two squares.
    let circle = (-65..=65).flat_map(|x| (-65..=65).map(move |y| [x, y]));
    let circle = circle.filter(|[x, y]| x * x + y * y == 65 * 65).collect();
    let comb = (0..100).map(|x| [x, if x % 2 == 0 { 0 } else { 1000 - x }]);
    let mut random = Random(1);
    let crowd = (0..400).map(|_| [0; 2].map(|_| i32::from(random.byte() >> 2)));
    vec![
        ("lattice", lattice),
        ("circle", circle),
        ("comb", comb.collect()),
        ("crowd", crowd.collect()),
    ]
}

/// Points for which doubles are hard: all digits, all exponents, nearly on a line.
fn doubles() -> Vec<(&'static str, Vec<[f64; 2]>)> {
    let mut random = Random(2);
    let uniform = (0..2000).map(|_| [0; 2].map(|_| random.unit())).collect();
    let mut random = Random(3);
    let magnitudes = std::iter::repeat_with(|| [0; 2].map(|_| f64::from_bits(random.bits())));
    let magnitudes = magnitudes.filter(|[x, y]| x.is_finite() && y.is_finite());
    let mut random = Random(4);
    let line = (0..300).map(|_| {
        let x = random.unit();
        [x, 3.0 * x + 0.1]
    });
    vec![
        ("uniform", uniform),
        ("magnitudes", magnitudes.take(200).collect()),
        ("nearly a line", line.collect()),
    ]
}

fn all_scalars(name: &str, points: &[[i32; 2]], lines: &mut Vec<String>) {
    lines.push(line(&format!("{name} i32"), points));
    let doubles: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
    lines.push(line(&format!("{name} f64"), &doubles));
    let third = |x| BigRational::new(BigInt::from(x), BigInt::from(3));
    let rationals: Vec<[BigRational; 2]> = points.iter().map(|p| p.map(third)).collect();
    lines.push(line(&format!("{name} BigRational"), &rationals));
}

/// The result and its steps without edges, with edges that do not cross, and with edges that do.
fn line<S: Scalar + Clone>(name: &str, points: &[[S; 2]]) -> String {
    let edges = sides_of_every_other(points);
    let crossing: Vec<[usize; 2]> = (1..points.len()).map(|v| [v, v / 2]).collect();
    let mut line = format!("{name}: {} points", points.len());
    for edges in [&[], &edges[..], &crossing] {
        let (result, steps) = run(points, edges);
        line += &match result {
            Ok(triangles) => {
                let report = verify(points, edges, &triangles).expect("a correct result");
                assert!(report.is_canonical(), "{name}: not canonical");
                let digest = digest(FNV, &triangles);
                format!(
                    "; {} triangles {digest:016x}, steps {steps:016x}",
                    triangles.len()
                )
            }
            Err(error) => format!("; {error}, steps {steps:016x}"),
        };
    }
    line
}

/// The sides of a triangulation of every other point: edges for all points.
fn sides_of_every_other<S: Scalar + Clone>(points: &[[S; 2]]) -> Vec<[usize; 2]> {
    let half: Vec<[S; 2]> = points.iter().step_by(2).cloned().collect();
    let result = triangulate(&half, &[]).expect("points alone");
    let sides = |[a, b, c]: [usize; 3]| [[a, b], [b, c], [c, a]];
    let sides = result.triangles().flat_map(sides);
    sides.map(|[a, b]| [2 * a, 2 * b]).collect()
}

type Triangles = Result<Vec<[usize; 3]>, Error>;

/// The triangles, and a digest of all steps.
fn run<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]]) -> (Triangles, u64) {
    let mut steps = FNV;
    let mut observer = |event| steps = digest(steps, &event);
    let watch = Watch::new().events(&mut observer);
    let result = Triangulator::new()
        .algorithm(Algorithm::Paper)
        .run(points, edges, watch);
    let triangles = result.map(|result| result.triangles().collect());
    (triangles, steps)
}

/// The first value of a digest.
const FNV: u64 = 0xcbf2_9ce4_8422_2325;

/// The digest of what came before and of `value`, as Fowler, Noll and Vo have it.
fn digest(before: u64, value: &impl Debug) -> u64 {
    let text = format!("{value:?}");
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    text.bytes().fold(before, step)
}

/// Numbers by Knuth's linear congruence, the same on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        let mut word = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
            self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
            self.0 >> 32
        };
        word() << 32 | word()
    }

    fn byte(&mut self) -> u8 {
        self.bits().to_be_bytes()[0]
    }

    /// A double in `0..1`, with all its digits.
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}
