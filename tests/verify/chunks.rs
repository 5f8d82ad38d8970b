//! Triangulations that are verified in several chunks, on one thread and on all.

use std::collections::BTreeSet;
use std::sync::Mutex;

use sweep_cdt::verify::{Report, Verifier, Violations};

/// How many points a side of the raster has.
const SIDE: usize = 200;
const SQUARES: usize = (SIDE - 1) * (SIDE - 1);
/// Triangles in a chunk, as the verifier has it.
const CHUNK: usize = 1 << 14;

/// A raster whose squares are cut from the upper left to the lower right corner, as is canonical, or the
/// other way. Its rows may be shifted against each other. It is so wide that doubles do not decide all ties.
fn raster(is_canonical: bool, shift: f64) -> (Vec<[f64; 2]>, Vec<[usize; 3]>) {
    let at = |i: usize| [i % SIDE, i / SIDE].map(|x| 25.0 * x as f64);
    let points = (0..SIDE * SIDE)
        .map(at)
        .map(|[x, y]| [x + shift * y, y])
        .collect();
    let corners = (0..SIDE * (SIDE - 1)).filter(|i| i % SIDE + 1 < SIDE);
    let triangles = corners.flat_map(|a| {
        let (b, c, d) = (a + 1, a + SIDE, a + SIDE + 1);
        if is_canonical {
            [[a, b, c], [b, d, c]]
        } else {
            [[a, b, d], [a, d, c]]
        }
    });
    (points, triangles.collect())
}

/// Verifies on one thread and on all, which must agree.
fn verify(
    verifier: Verifier<'_>,
    (points, triangles): &(Vec<[f64; 2]>, Vec<[usize; 3]>),
    edges: &[[usize; 2]],
) -> Result<Report, Violations> {
    let result = verifier.verify(points, edges, triangles);
    assert_eq!(verifier.verify_parallel(points, edges, triangles), result);
    result
}

#[test]
fn sides_are_counted_once() {
    let row = [[0, SIDE - 1]];
    for (is_canonical, edges) in [
        (true, &[] as &[_]),
        (true, &row),
        (false, &[]),
        (false, &row),
    ] {
        let report = verify(Verifier::new(), &raster(is_canonical, 0.0), edges);
        let report = report.expect("any diagonal of a square will do");
        assert_eq!(report.triangles, 2 * SQUARES);
        assert_eq!(report.boundary_sides, 4 * (SIDE - 1));
        let fixed = edges.len() * (SIDE - 1);
        assert_eq!(report.constrained_sides, fixed);
        // Each triangle has three sides, and two triangles share an inner one. The row is on the boundary.
        let inner = (3 * report.triangles - report.boundary_sides) / 2;
        assert_eq!(report.free_sides, inner);
        assert_eq!(report.cocircular_sides, SQUARES);
        let uncanonical = if is_canonical { 0 } else { SQUARES };
        assert_eq!(report.uncanonical_sides, uncanonical);
        assert_eq!(report.is_canonical(), is_canonical);
        if edges.is_empty() {
            // A sign for each triangle, each corner of the boundary and each free side.
            let signs = report.triangles + report.boundary_sides + report.free_sides;
            assert_eq!(report.filtered + report.exact, signs as u64);
            assert!(report.filtered > 0 && report.exact > 0, "{report:?}");
        }
    }
}

#[test]
fn what_is_listed_is_limited_over_all() {
    let wrong = raster(false, 0.25);
    for limit in [0, 10, SQUARES - 1, SQUARES + 1] {
        let violations = verify(Verifier::new().limit(limit), &wrong, &[]);
        let violations = violations.expect_err("no diagonal is the shorter one");
        assert_eq!(violations.found, SQUARES);
        assert_eq!(violations.list.len(), limit.min(SQUARES));
        let distinct: BTreeSet<String> = violations.list.iter().map(|v| v.to_string()).collect();
        assert_eq!(distinct.len(), violations.list.len());
    }
}

#[test]
fn progress_goes_by_chunks() {
    let (points, triangles) = raster(true, 0.0);
    let seen = Mutex::new(Vec::new());
    let progress = |done, all| seen.lock().unwrap().push((done, all));
    let verifier = Verifier::new().progress(&progress);
    let count = triangles.len();
    let chunks = count.div_ceil(CHUNK);
    let done = (1..=chunks).map(|chunk| count.min(chunk * CHUNK));
    let expected: Vec<_> = [0, count]
        .into_iter()
        .flat_map(|before| done.clone().map(move |done| (before + done, 2 * count)))
        .collect();
    let result = verifier.verify(&points, &[], &triangles);
    assert!(result.is_ok());
    assert_eq!(std::mem::take(&mut *seen.lock().unwrap()), expected);

    // Threads report chunks in any order, the short one too.
    let result = verifier.verify_parallel(&points, &[], &triangles);
    assert!(result.is_ok());
    let mut seen = std::mem::take(&mut *seen.lock().unwrap());
    seen.sort_unstable();
    assert_eq!((seen.len(), seen[chunks - 1].0), (2 * chunks, count));
    for pass in [0, count] {
        let before = seen
            .iter()
            .map(|&(done, _)| done)
            .filter(|&done| done > pass);
        let mut last = pass;
        let mut lengths: Vec<usize> = before
            .take(chunks)
            .map(|done| done - std::mem::replace(&mut last, done))
            .collect();
        lengths.sort_unstable();
        let mut expected = vec![CHUNK; chunks];
        expected[0] = count - CHUNK * (chunks - 1);
        assert_eq!(lengths, expected);
    }
}
