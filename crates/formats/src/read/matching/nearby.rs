//! Which points are near a place: two in a rectangle, the nearest one, and how far places are from their points.
//!
//! The points are sorted by x. For each power of two, each run of so many of them is sorted by y. The points between two
//! x are so many runs, at most two of each length, and in each of them the points between two y stand together.
//!
//! Cost: O(n log n) time and memory once. A rectangle takes O(log² n), wherever points and rectangles are: no cell can
//! fill up, and the search ends at the second point. The nearest point takes O(n), and is asked for a few times only.
//! Numbers are compared exactly.

use crate::Coordinate;

/// Points to be found.
pub(super) struct Nearby<'a, S> {
    points: &'a [[S; 2]],
    /// The positions of the points, in runs of 1, 2, 4 and so on.
    levels: Vec<Vec<usize>>,
}

/// So often a tolerance is raised, at most.
const RAISED: usize = 64;

impl<'a, S: Coordinate> Nearby<'a, S> {
    /// Finds those of `points` that are `wanted`, by their positions. Their coordinates are finite.
    pub(super) fn new(points: &'a [[S; 2]], mut wanted: Vec<usize>) -> Nearby<'a, S> {
        wanted.sort_by(|&v, &w| points[v][0].compare(&points[w][0]));
        let mut levels = vec![wanted];
        let mut length = 2;
        while let Some(last) = levels.last()
            && length <= last.len()
        {
            let mut level = last.clone();
            for run in level.chunks_mut(length) {
                // It sorts two sorted runs by merging them.
                run.sort_by(|&v, &w| points[v][1].compare(&points[w][1]));
            }
            levels.push(level);
            length *= 2;
        }
        Nearby { points, levels }
    }

    /// Two points with x and y from the first to the second of these, or the one that there is, or none.
    pub(super) fn first_two(
        &self,
        [left, right]: &[S; 2],
        [below, above]: &[S; 2],
    ) -> [Option<usize>; 2] {
        let mut found = [None; 2];
        let by_x = &self.levels[0];
        let mut first = by_x.partition_point(|&v| self.points[v][0].compare(left).is_lt());
        let mut end = by_x.partition_point(|&v| self.points[v][0].compare(right).is_le());
        let mut visit = |run: &[usize]| {
            let after = run.partition_point(|&v| self.points[v][1].compare(below).is_lt());
            let inside = run[after..].iter().take(2).copied();
            for v in inside.take_while(|&v| self.points[v][1].compare(above).is_le()) {
                match &mut found {
                    [one @ None, _] | [_, one @ None] => *one = Some(v),
                    _ => {}
                }
            }
        };
        // Runs are numbered in each level; those of the next one are twice as long.
        for (power, level) in self.levels.iter().enumerate() {
            if first >= end {
                break;
            }
            let mut run = |number: usize| visit(&level[number << power..(number + 1) << power]);
            if first % 2 == 1 {
                run(first);
                first += 1;
            }
            if end % 2 == 1 && first < end {
                end -= 1;
                run(end);
            }
            (first, end) = (first / 2, end / 2);
        }
        found
    }

    /// The point whose coordinates differ least from those of a place.
    pub(super) fn nearest(&self, place: &[S; 2]) -> Option<usize> {
        let pairs = self.levels[0]
            .iter()
            .map(|&v| (v, apart(place, &self.points[v])));
        let least = pairs.min_by(|(v, near), (w, far)| near.total_cmp(far).then(v.cmp(w)));
        Some(least?.0)
    }

    /// The points that differ from a place by no more than a tolerance, up to two.
    fn around(&self, place: &[S; 2], tolerance: f64) -> [Option<usize>; 2] {
        self.first_two(&place[0].within(tolerance), &place[1].within(tolerance))
    }

    /// A tolerance, in two digits and less than half of the least distance of two points, within which each place has a
    /// point, and no two places have the same; `None`, if there is none, or if it would have to be raised too often to be
    /// found.
    pub(super) fn tolerance(&self, places: &[[S; 2]]) -> Option<f64> {
        let (mut tolerance, mut raised) = (0.0, 0);
        for place in places {
            if self.around(place, tolerance)[0].is_none() {
                tolerance = in_two_digits(apart(place, &self.points[self.nearest(place)?]))?;
                raised += 1;
            }
            if raised > RAISED {
                return None;
            }
        }
        let is_alone = |&v: &usize| self.around(&self.points[v], 2.0 * tolerance)[1].is_none();
        if !self.levels[0].iter().all(is_alone) {
            return None;
        }
        let mut place_of = vec![None; self.points.len()];
        let mut is_only = |place| {
            let v = self.around(place, tolerance)[0]?;
            (*place_of[v].get_or_insert(place) == place).then_some(())
        };
        places
            .iter()
            .all(|place| is_only(place).is_some())
            .then_some(tolerance)
    }
}

/// The greater of the differences in x and in y.
pub(super) fn apart<S: Coordinate>(p: &[S; 2], q: &[S; 2]) -> f64 {
    p[0].apart(&q[0]).max(p[1].apart(&q[1]))
}

/// The least number of two digits that is no less than this one.
fn in_two_digits(number: f64) -> Option<f64> {
    let text = format!("{number:.1e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let tenths: u32 = mantissa.replace('.', "").parse().ok()?;
    let exponent = exponent.parse::<i32>().ok()? - 1;
    let candidates = [tenths, tenths + 1].map(|tenths| format!("{tenths}e{exponent}").parse());
    let mut candidates = candidates.into_iter().filter_map(Result::ok);
    candidates.find(|&candidate: &f64| candidate >= number && candidate.is_finite())
}

#[cfg(test)]
mod tests {
    use sweep_cdt_testing::Random;

    use super::Nearby;

    #[test]
    fn as_many_are_found_as_there_are_up_to_two() {
        let mut random = Random::new(7);
        for count in 0..70 {
            let mut number = || random.below(12) as f64;
            let points: Vec<[f64; 2]> = (0..count).map(|_| [number(), number()]).collect();
            let wanted: Vec<usize> = (0..count).filter(|v| v % 3 != 1).collect();
            let nearby = Nearby::new(&points, wanted.clone());
            for _ in 0..50 {
                let ranges = [number(), number()].map(|low| [low, low + number() / 3.0]);
                let is_in = |v: &usize| {
                    let pairs = points[*v].iter().zip(&ranges);
                    pairs
                        .into_iter()
                        .all(|(x, &[low, high])| (low..=high).contains(x))
                };
                let inside: Vec<usize> = wanted.iter().copied().filter(|v| is_in(v)).collect();
                let [one, other] = nearby.first_two(&ranges[0], &ranges[1]);
                let found: Vec<usize> = [one, other].into_iter().flatten().collect();
                assert_eq!(found.len(), inside.len().min(2), "{points:?} {ranges:?}");
                assert!(found.iter().all(is_in) && (one != other || one.is_none()));
            }
        }
    }

    #[test]
    fn a_tolerance_is_large_enough_and_not_too_large() {
        let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]];
        let nearby = Nearby::new(&points, vec![0, 1, 2]);
        assert_eq!(nearby.nearest(&[1.25, 1.5]), Some(2));
        assert_eq!(nearby.tolerance(&[[0.0, 0.0], [1.0, 2.0]]), Some(0.0));
        assert_eq!(nearby.tolerance(&[[0.0, 0.125], [1.0, 2.0]]), Some(0.13));
        // Half of the least distance of two points, and a little less.
        assert_eq!(nearby.tolerance(&[[1.0, 2.5]]), None);
        assert_eq!(nearby.tolerance(&[[1.0, 2.4375]]), Some(0.44));
        // Both places would have one.
        assert_eq!(nearby.tolerance(&[[0.0, 0.0], [0.0, 0.125]]), None);
        assert_eq!(Nearby::new(&[], Vec::new()).tolerance(&[[0.0, 0.0]]), None);
    }
}
