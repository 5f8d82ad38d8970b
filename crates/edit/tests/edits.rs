//! After every edit of random histories the triangulation is that of a fresh run, on degenerate points.

use sweep_cdt::scalar::Scalar;
use sweep_cdt_edit::Edits;
use sweep_cdt_testing::{Random, edits};

/// Points of a kind: few places, so that many are equal, on lines and on circles. Of a kind `n` times as wide.
type Kind = (&'static str, fn(&mut Random, usize) -> [i64; 2]);

fn below(random: &mut Random, n: usize) -> i64 {
    random.below(n) as i64
}

const KINDS: [Kind; 8] = [
    ("lattice", |r, n| [below(r, 6 * n), below(r, 6 * n)]),
    ("wide lattice", |r, n| [below(r, 40 * n), below(r, 3)]),
    ("one line", |r, n| [below(r, 12 * n), 0]),
    ("slanted line and a few beside", |r, n| {
        let i = below(r, 12 * n);
        [2 * i, 3 * i + i64::from(r.below(6) == 0)]
    }),
    ("circles", |r, n| {
        let [x, y] = r.pick(&CIRCLE);
        let [to_right, up] = [below(r, n), below(r, n)];
        [x + 20 * to_right, y + 20 * up]
    }),
    ("circle and lattice", |r, n| {
        if r.one_in(2) {
            r.pick(&CIRCLE)
        } else {
            [below(r, 5 * n) - 2, below(r, 5 * n) - 2]
        }
    }),
    ("even", |r, n| [below(r, n << 20), below(r, n << 20)]),
    ("two clusters", |r, n| {
        let far = 1000 * below(r, 2);
        [far + below(r, 5 * n), below(r, 5 * n)]
    }),
];

/// All whole points at a distance of 25 from the origin.
const CIRCLE: [[i64; 2]; 20] = [
    [25, 0],
    [24, 7],
    [20, 15],
    [15, 20],
    [7, 24],
    [0, 25],
    [-7, 24],
    [-15, 20],
    [-20, 15],
    [-24, 7],
    [-25, 0],
    [-24, -7],
    [-20, -15],
    [-15, -20],
    [-7, -24],
    [0, -25],
    [7, -24],
    [15, -20],
    [20, -15],
    [24, -7],
];

/// `SWEEP_CDT_EDITS` sets how many histories of thirty batches each kind has.
fn histories<S: Scalar + Clone>(convert: impl Fn(i64) -> S, default: usize) {
    let histories = std::env::var("SWEEP_CDT_EDITS");
    let histories = histories.map_or(default, |text| text.parse().expect("a number"));
    for (name, point) in KINDS {
        let mut made = 0;
        for history in 0..histories {
            let mut random = Random::new(history as u64);
            let most = [1, 3, 10][history % 3];
            let what = format!("{name}, history {history}");
            let point = |random: &mut Random| point(random, 1).map(&convert);
            made += edits::history(&mut random, Edits::default(), [30, most], &what, point)[0];
        }
        assert!(made > 10 * histories, "{name}: {made} batches were made");
    }
}

#[test]
fn every_history_of_integers_ends_in_the_fresh_result() {
    histories(|x| x, 60);
}

#[test]
fn every_history_of_rounded_doubles_ends_in_the_fresh_result() {
    histories(|x| x as f64 * 0.1, 30);
}

#[test]
fn every_history_of_fractions_ends_in_the_fresh_result() {
    histories(|x| num_rational::BigRational::new(x.into(), 7.into()), 6);
}

#[test]
#[ignore = "some minutes with optimization: a million edits, and a fresh run after each batch"]
fn a_million_edits_end_in_the_fresh_result() {
    for (name, point) in KINDS {
        // Of single edits at most 200 points, of batches of a thousand at most 10,000 or so.
        for (most, width, batches) in [(1, 2, 200), (10, 3, 60), (1000, 30, 40)] {
            let (mut edits, mut histories) = (0, 0);
            while edits < 42_000 {
                let mut random = Random::new(histories);
                let what = format!("{name}, at most {most}, history {histories}");
                let point = |random: &mut Random| point(random, width).map(|x| x as f64);
                let first = Edits {
                    points: (0..100).map(|_| point(&mut random)).collect(),
                    ..Edits::default()
                };
                let counts = edits::history(&mut random, first, [batches, most], &what, point);
                edits += counts[2];
                histories += 1;
            }
            println!("{name}, at most {most}: {edits} edits in {histories} histories");
        }
    }
}
