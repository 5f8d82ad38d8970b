//! A table whose intervals are learned ([`super::interval_table`]): a few lines tell the rank of an x.
//!
//! T. Kraska and others, The case for learned index structures, SIGMOD 2018, doi:10.1145/3183713.3196909: the place
//! of a key among sorted ones is a function that a model learns. P. Ferragina, G. Vinciguerra, The PGM-index, VLDB
//! 2020, doi:10.14778/3389133.3389135: the model is made of lines that err by a given bound at most. Here the keys are
//! the different x of a sample, eight for each interval, and the bound is the width of an interval.
//!
//! The lines are laid from left to right. Each begins at a key, and goes on as long as one slope fits all keys up
//! to there: a cone of slopes that shrinks with every key. The cone may take more lines than the least
//! number, which the PGM-index finds. The PGM-index also has lines over lines; here the line of an x is found by halves,
//! as there are few.
//!
//! Why it is right: a guess is as good as any. Lines ascend, and one is taken up to the start of the next.
//!
//! Cost: O(log m) comparisons for m lines for a search; m is a handful where x spreads evenly, O(sqrt(n)) at worst.
//! Else the cost is that of [`super::rank_table`], but a sample is sorted and no array of ranks is kept. Points made
//! against the sample crowd in one interval, and then the sweep walks over O(n) nodes.

use sweep_cdt::front::{FrontInput, FrontNode, Work};

use super::interval_table::{IntervalTable, Intervals};
use super::parts::mixed;

/// A table with 2 sqrt(n) intervals of about equally many x, as lines guess: O(log m) for m lines.
pub type LearnedTable = IntervalTable<Lines>;

/// Keys of the sample for each interval.
const SAMPLE: usize = 8;

/// The lines from x to ranks among the keys.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// Ascending by the x where they begin.
    lines: Vec<Line>,
    /// How many keys there are.
    ranks: usize,
}

#[derive(Clone, Copy, Debug)]
struct Line {
    /// Where it begins.
    x: f64,
    rank: f64,
    /// Ranks for x.
    slope: f64,
}

/// Lines through the places of these numbers, which ascend, that err by `bound` at most but for rounding.
fn lines(xs: &[f64], bound: f64) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut cone = [0.0, f64::INFINITY];
    for (rank, &x) in xs.iter().enumerate() {
        let rank = rank as f64;
        if let Some(line) = lines.last_mut() {
            let [low, high] = [-bound, bound].map(|by| (rank + by - line.rank) / (x - line.x));
            let narrower = [low.max(cone[0]), high.min(cone[1])];
            if narrower[0] <= narrower[1] {
                cone = narrower;
                line.slope = (cone[0] + cone[1]) / 2.0;
                continue;
            }
        }
        let slope = 0.0;
        lines.push(Line { x, rank, slope });
        cone = [0.0, f64::INFINITY];
    }
    lines
}

impl Intervals for Lines {
    fn begin(&mut self, input: FrontInput<'_>, work: &mut Work) -> usize {
        let (n, count) = (input.len(), 2 * input.len().isqrt() + 1);
        let drawn = |i| (mixed(FrontNode::from_rank(i), 0) % n as u64) as usize;
        let few = n <= SAMPLE * count;
        let sample = (0..n.min(SAMPLE * count)).map(|i| if few { i } else { drawn(i) });
        let mut xs: Vec<f64> = sample.map(|v| input.x(v)).collect();
        xs.retain(|x| x.is_finite());
        xs.sort_unstable_by(f64::total_cmp);
        xs.dedup();
        self.lines = lines(&xs, xs.len() as f64 / count as f64);
        self.ranks = xs.len();
        work.bytes += size_of_val(&self.lines[..]) as u64;
        count
    }

    fn of(&self, x: f64, count: usize, work: &mut Work) -> usize {
        let after = self.lines.partition_point(|line| {
            work.comparisons += 1;
            line.x <= x
        });
        let guess = |line: &Line| line.rank + (x - line.x) * line.slope;
        let rank = after
            .checked_sub(1)
            .map_or(0.0, |at| guess(&self.lines[at]));
        let end = self
            .lines
            .get(after)
            .map_or(self.ranks as f64, |next| next.rank);
        // Saturates; what is no number is 0.
        let interval = rank.min(end) * count as f64 / self.ranks.max(1) as f64;
        (interval as usize).min(count - 1)
    }
}

#[cfg(test)]
mod tests {
    use sweep_cdt::front::{FrontInput, Work};

    use super::{Intervals, Lines, lines};

    /// Every place is guessed within the bound, by one line where they are on one.
    #[test]
    fn lines_err_by_the_bound_at_most() {
        let even: Vec<f64> = (0..1000).map(f64::from).collect();
        let squares: Vec<f64> = even.iter().map(|x| x * x).collect();
        for (xs, count) in [(&even, 1), (&squares, 9)] {
            let lines = lines(xs, 4.0);
            assert_eq!(lines.len(), count);
            for (rank, &x) in xs.iter().enumerate() {
                let at = lines.partition_point(|line| line.x <= x) - 1;
                let guess = lines[at].rank + (x - lines[at].x) * lines[at].slope;
                assert!((guess - rank as f64).abs() <= 4.001, "{guess} for {rank}");
            }
        }
    }

    /// The intervals of x ascend with x, whatever lines there are, and infinite x fall in the outermost ones.
    #[test]
    fn intervals_ascend() {
        let x = |i: i32| f64::from(i * i % 997).powi(3);
        let points: Vec<[f64; 2]> = (0..997).map(|i| [x(i), 0.0]).collect();
        let (mut intervals, mut work) = (Lines::default(), Work::default());
        let count = intervals.begin(FrontInput::new(&points), &mut work);
        let mut xs: Vec<f64> = points.iter().map(|point| point[0]).collect();
        xs.extend([f64::INFINITY, f64::NEG_INFINITY]);
        xs.sort_by(f64::total_cmp);
        let of: Vec<usize> = xs
            .iter()
            .map(|&x| intervals.of(x, count, &mut work))
            .collect();
        assert!(of.is_sorted(), "{of:?}");
        assert_eq!([of[0], of[998]], [0, count - 1]);
    }
}
