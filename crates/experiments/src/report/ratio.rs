//! Two variants compared: the ratio of their times with an interval, and the verdict.
//!
//! A seed gives the ratio of the least times of its turns: whatever disturbs a turn adds to it, and the least is the
//! estimate that this moves least (Chen and Revels 2016, arXiv:1608.04295). The middle is the geometric mean over the
//! seeds. The interval is a percentile bootstrap (Efron 1979, doi:10.1214/aos/1176344552): seeds are drawn with replacement, and 95
//! of a hundred drawn means are in it. Turns are not drawn as well: their noise is in the spread of the seeds already
//! (Davison and Hinkley 1997, section 3.8). Of one seed the turns are drawn, the same for both variants, which ran in
//! turn; then there is no verdict, as an interval says nothing of other seeds. A difference of a twentieth either way is
//! taken for none: that was settled before the runs.

use sweep_cdt_testing::Random;

use crate::measure::{Row, Turn};

/// The time of a variant over that of another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ratio {
    pub(crate) middle: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) seeds: usize,
}

/// Ratios up to this, and down to its inverse, are ties.
const TIE: f64 = 1.05;
const DRAWS: usize = 1000;

impl Ratio {
    /// The rows of a variant and of another one on all seeds of one kind and size; `None` without a turn.
    pub(crate) fn of(rows: &[&Row], first: &[&Row]) -> Option<Ratio> {
        let mut seeds: Vec<Vec<[f64; 2]>> = Vec::new();
        for row in rows {
            let other = first.iter().find(|other| other.seed == row.seed)?;
            let turns = row.turns.iter().zip(&other.turns);
            seeds.push(turns.map(|(a, b)| [a, b].map(Turn::ms)).collect());
        }
        let of_seeds: Option<Vec<f64>> = seeds.iter().map(|turns| log_ratio(turns)).collect();
        let of_seeds = of_seeds.filter(|ratios| !ratios.is_empty())?;
        let middle = mean(&of_seeds);
        let mut random = Random::new(1);
        let mut draw = || match &seeds[..] {
            [turns] => {
                let drawn: Vec<[f64; 2]> = turns.iter().map(|_| random.pick(turns)).collect();
                log_ratio(&drawn).expect("turns")
            }
            _ => {
                let drawn: Vec<f64> = of_seeds.iter().map(|_| random.pick(&of_seeds)).collect();
                mean(&drawn)
            }
        };
        let mut drawn: Vec<f64> = (0..DRAWS).map(|_| draw()).collect();
        drawn.sort_by(f64::total_cmp);
        let at = |share: f64| drawn[(share * (DRAWS - 1) as f64) as usize].exp();
        Some(Ratio {
            middle: middle.exp(),
            low: at(0.025),
            high: at(0.975),
            seeds: seeds.len(),
        })
    }

    /// Whether the interval has a ratio that counts as none.
    pub(crate) fn is_tie(&self) -> bool {
        self.low <= TIE && self.high >= 1.0 / TIE
    }

    /// What the first variant of the two did: it won where the other takes longer. One seed has no verdict.
    pub(crate) fn verdict(&self) -> Option<&'static str> {
        let verdict = match (self.is_tie(), self.middle > 1.0) {
            (true, _) => "tie",
            (false, true) => "win",
            (false, false) => "loss",
        };
        (self.seeds > 1).then_some(verdict)
    }
}

/// The logarithm of the ratio of the least times; `None` without a turn.
fn log_ratio(turns: &[[f64; 2]]) -> Option<f64> {
    let least = turns
        .iter()
        .copied()
        .reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])]);
    least.map(|[a, b]| (a / b).ln())
}

fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len() as f64
}

#[cfg(test)]
mod tests {
    use super::Ratio;
    use crate::measure::{Row, Turn};

    /// The rows of a variant whose turns take these times, a list for each seed.
    fn rows(seeds: &[&[f64]]) -> Vec<Row> {
        let turn = |&clock_ms: &f64| Turn {
            clock_ms,
            ..Turn::default()
        };
        let row = |(seed, turns): (u64, &&[f64])| Row {
            seed,
            turns: turns.iter().map(turn).collect(),
            ..Row::default()
        };
        (1..).zip(seeds).map(row).collect()
    }

    fn ratio(a: &[&[f64]], b: &[&[f64]]) -> Ratio {
        let (a, b) = (rows(a), rows(b));
        let refer = |rows: &'static [Row]| rows.iter().collect::<Vec<_>>();
        Ratio::of(&refer(a.leak()), &refer(b.leak())).expect("turns")
    }

    #[test]
    fn equal_turns_have_no_interval() {
        let double = ratio(&[&[2.0, 2.0], &[6.0, 6.0]], &[&[1.0, 1.0], &[3.0, 3.0]]);
        assert_eq!(
            [double.middle, double.low, double.high].map(|x| (x * 1e9).round()),
            [2e9; 3]
        );
        assert_eq!(double.verdict(), Some("win"));
        let half = ratio(&[&[1.0], &[1.0]], &[&[2.0], &[2.0]]);
        assert_eq!(half.verdict(), Some("loss"));
        assert_eq!(ratio(&[&[1.0]], &[&[2.0]]).verdict(), None, "one seed");
    }

    #[test]
    fn disturbed_turns_change_nothing() {
        let other: [&[f64]; 2] = [&[2.0; 3]; 2];
        let calm = ratio(&[&[3.0; 3], &[3.3; 3]], &other);
        let disturbed = ratio(&[&[4.3, 3.0, 4.3], &[3.3, 9.0, 3.4]], &other);
        assert_eq!(calm, disturbed);
    }

    #[test]
    fn what_is_within_the_spread_is_a_tie() {
        let noisy: &[&[f64]] = &[&[1.0, 1.3, 0.8], &[0.9, 1.2, 1.0], &[1.4, 0.7, 1.1]];
        let other: &[&[f64]] = &[&[1.1, 0.9, 1.0], &[1.2, 1.0, 0.8], &[1.0, 1.1, 0.75]];
        let ratio = ratio(noisy, other);
        assert!(
            ratio.low < ratio.middle && ratio.middle < ratio.high,
            "{ratio:?}"
        );
        assert_eq!(ratio.verdict(), Some("tie"));
        let of = |middle: f64, spread: f64| Ratio {
            middle,
            low: middle - spread,
            high: middle + spread,
            seeds: 3,
        };
        // A difference that is sure and small is none either.
        assert_eq!(of(1.03, 0.01).verdict(), Some("tie"));
        assert_eq!(of(1.08, 0.02).verdict(), Some("win"));
    }

    #[test]
    fn without_turns_there_is_no_ratio() {
        let row = Row::default();
        assert_eq!(Ratio::of(&[&row], &[&row]), None);
        assert_eq!(Ratio::of(&[], &[]), None);
    }
}
