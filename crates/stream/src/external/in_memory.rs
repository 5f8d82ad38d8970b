//! Records sorted in memory.
//!
//! A list is spread over buckets by y, which is divided evenly between the least and the greatest of the list; or by x
//! if all y are equal. Rounding keeps the order, so that of two buckets the first holds the lesser places. Each bucket
//! is small enough for a cache and is spread again, on all cores. Where most buckets hold a few records, moving each to
//! its place past the last ones ends the work: they have nowhere far to go. A list that three levels have not made small is sorted
//! by comparisons.
//!
//! Cost: linear for places that are spread over the plane, also in clusters and in rows; O(n log n) at worst. Memory for
//! as many records again.

use std::ops::Range;

use sweep_cdt::threads::on_all_cores;

use crate::external::record::Record;

/// A list so short that it is not spread.
const SHORT: usize = 48;
/// How many records a bucket gets if they are spread evenly.
const EACH: usize = 4;
/// The most buckets of a long list, and of one that is spread again.
const MOST: [usize; 2] = [1024, 4096];
/// How often a list is spread at most.
const LEVELS: usize = 4;

/// Sorts records; what `scratch` holds is lost.
pub(crate) fn sort<R: Record>(records: &mut Vec<R>, scratch: &mut Vec<R>) {
    scratch.resize(records.len(), R::default());
    let Some(ends) = spread(records, scratch, MOST[0]) else {
        return sort_list(records, scratch, 0);
    };
    std::mem::swap(records, scratch);
    // The buckets, in parts for the threads.
    let share = records.len() / 64 + 1;
    let (mut lists, mut spare) = (records.as_mut_slice(), scratch.as_mut_slice());
    let mut parts = Vec::new();
    let (mut begin, mut part_begin, mut inner) = (0, 0, Vec::new());
    for end in ends.into_iter().map(|end| end as usize) {
        inner.push(begin - part_begin..end - part_begin);
        if end - part_begin >= share {
            let (list, others) = lists.split_at_mut(end - part_begin);
            let (part_spare, other_spare) = spare.split_at_mut(end - part_begin);
            (lists, spare) = (others, other_spare);
            parts.push((list, part_spare, std::mem::take(&mut inner)));
            part_begin = end;
        }
        begin = end;
    }
    parts.push((lists, spare, inner));
    on_all_cores(
        parts,
        |(list, spare, buckets): (&mut [R], &mut [R], Vec<Range<usize>>)| {
            for bucket in buckets {
                sort_list(&mut list[bucket.clone()], &mut spare[bucket], LEVELS - 1);
            }
        },
    );
}

/// Sorts records that fit in a cache, on this thread; what `scratch` holds is lost.
pub(crate) fn sort_piece<R: Record>(records: &mut [R], scratch: &mut Vec<R>) {
    if scratch.len() < records.len() {
        scratch.resize(records.len(), R::default());
    }
    sort_list(records, &mut scratch[..records.len()], LEVELS);
}

/// Sorts a list that may be spread so often.
fn sort_list<R: Record>(list: &mut [R], scratch: &mut [R], levels: usize) {
    if list.len() <= SHORT {
        return insert_each(list);
    }
    let ends = match levels {
        0 => None,
        _ => spread(list, scratch, MOST[1]),
    };
    let Some(ends) = ends else {
        return list.sort_unstable_by(R::compare);
    };
    list.copy_from_slice(scratch);
    let mut begin = 0;
    for end in ends.into_iter().map(|end| end as usize) {
        if end - begin > SHORT {
            sort_list(&mut list[begin..end], &mut scratch[begin..end], levels - 1);
        }
        begin = end;
    }
    insert_each(list);
}

/// Moves each record to the left, past those that come after it.
fn insert_each<R: Record>(list: &mut [R]) {
    for at in 1..list.len() {
        let record = list[at];
        let mut place = at;
        while place > 0 && record.compare(&list[place - 1]).is_lt() {
            list[place] = list[place - 1];
            place -= 1;
        }
        list[place] = record;
    }
}

/// Spreads a list over up to `most` buckets in `spread`, and returns where each of them ends; `None` if nothing tells
/// the records apart but their numbers, or no double tells how.
fn spread<R: Record>(list: &[R], spread: &mut [R], most: usize) -> Option<Vec<u32>> {
    let buckets = (list.len() / EACH).clamp(2, most);
    #[expect(clippy::float_cmp, reason = "equal y leave the order to x")]
    let is_row = || list.iter().all(|record| record.y() == list[0].y());
    match Scale::new(list, R::y, buckets) {
        Some(scale) => Some(move_all(list, spread, buckets, |record| {
            scale.bucket(record.y())
        })),
        None if !is_row() => None,
        None => Scale::new(list, R::x, buckets)
            .map(|scale| move_all(list, spread, buckets, |record| scale.bucket(record.x()))),
    }
}

/// An interval of doubles, divided evenly.
struct Scale {
    least: f64,
    factor: f64,
    last: usize,
}

impl Scale {
    /// The interval of a coordinate; `None` if it cannot be divided.
    fn new<R: Record>(list: &[R], coordinate: impl Fn(&R) -> f64, buckets: usize) -> Option<Scale> {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for record in list {
            least = least.min(coordinate(record));
            greatest = greatest.max(coordinate(record));
        }
        let factor = buckets as f64 / (greatest - least);
        (factor.is_finite() && factor > 0.0).then_some(Scale {
            least,
            factor,
            last: buckets - 1,
        })
    }

    /// The bucket of a coordinate. The least and the greatest have different ones.
    fn bucket(&self, coordinate: f64) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it is not negative, and too large a number becomes the largest"
        )]
        let bucket = ((coordinate - self.least) * self.factor) as u32;
        (bucket as usize).min(self.last)
    }
}

/// Moves each record to its bucket, in the order of the list.
fn move_all<R: Record>(
    list: &[R],
    spread: &mut [R],
    buckets: usize,
    bucket: impl Fn(&R) -> usize,
) -> Vec<u32> {
    let mut places = vec![0_u32; buckets];
    for record in list {
        places[bucket(record)] += 1;
    }
    let mut sum = 0;
    for place in &mut places {
        sum += std::mem::replace(place, sum);
    }
    for record in list {
        let place = &mut places[bucket(record)];
        spread[*place as usize] = *record;
        *place += 1;
    }
    places
}
