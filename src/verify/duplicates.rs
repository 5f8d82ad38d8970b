//! Which points are equal: indices sorted by a hash of the approximated coordinates.
//!
//! Equal points have equal approximations and so equal hashes. Only points with the same hash are compared
//! exactly: few, apart from true duplicates. Cost: one sort of 64-bit numbers.

use std::cmp::Ordering;

use crate::scalar::Scalar;

/// For each point the lowest index of a point equal to it; `None` if all differ. Only points that are
/// finite are compared.
pub(super) fn representatives<S: Scalar>(
    points: &[[S; 2]],
    approximations: &[[f64; 2]],
    is_finite: impl Fn(u32) -> bool,
) -> Option<Vec<u32>> {
    let count = u32::try_from(points.len()).expect("the size was checked");
    // A key is a hash, with the index of the point in its low bits.
    let low_bits = u64::from(count.next_power_of_two()) * 2 - 1;
    let mut keys: Vec<u64> = (0..count)
        .filter(|&v| is_finite(v))
        .map(|v| hash(approximations[v as usize]) & !low_bits | u64::from(v))
        .collect();
    keys.sort_unstable();

    let same_hash = |a: &u64, b: &u64| a & !low_bits == b & !low_bits;
    let order = |&a: &u32, &b: &u32| {
        let (p, q) = (&points[a as usize], &points[b as usize]);
        p[0].compare(&q[0]).then_with(|| p[1].compare(&q[1]))
    };
    let mut found: Option<Vec<u32>> = None;
    for group in keys.chunk_by(same_hash).filter(|group| group.len() > 1) {
        let index = |key: &u64| u32::try_from(key & low_bits).expect("an index");
        let mut group: Vec<u32> = group.iter().map(index).collect();
        group.sort_by(order);
        for equal in group.chunk_by(|a, b| order(a, b) == Ordering::Equal) {
            if equal.len() > 1 {
                let all = found.get_or_insert_with(|| (0..count).collect());
                // The sort is stable, so the lowest index comes first.
                for &v in equal {
                    all[v as usize] = equal[0];
                }
            }
        }
    }
    found
}

/// Mixes two doubles. Zeros of both signs give the same hash.
#[expect(
    clippy::cast_possible_truncation,
    reason = "folds both halves into one"
)]
fn hash([x, y]: [f64; 2]) -> u64 {
    let [x, y] = [x + 0.0, y + 0.0].map(f64::to_bits);
    let product = u128::from(x ^ 0x9e37_79b9_7f4a_7c15) * u128::from(y ^ 0xd1b5_4a32_d192_ed03);
    (product >> 64) as u64 ^ product as u64
}
