//! Running the verifier.

use std::sync::Mutex;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Report, Verifier, Violation, Violations};

use super::progress::Progress;

/// The verifier's answer.
pub(crate) type Answer = Result<Report, Violations>;

/// Verifies on all cores, with a progress bar where that takes long.
pub(crate) fn verify<T: Scalar + Sync>(
    verifier: Verifier<'_>,
    points: &[[T; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Answer {
    let progress = Mutex::new(Progress::new("verifying"));
    let show = |done, all| {
        // If another thread is drawing the bar, this report is not needed.
        if let Ok(mut progress) = progress.try_lock() {
            progress.show(done, all);
        }
    };
    verifier
        .progress(&show)
        .verify_parallel(points, edges, triangles)
}

/// The counts of an answer.
pub(crate) fn report(answer: &Answer) -> &Report {
    match answer {
        Ok(report) => report,
        Err(violations) => &violations.report,
    }
}

/// The violations of an answer that are listed, and how many there are in all.
pub(crate) fn violations(answer: &Answer) -> (&[Violation], usize) {
    match answer {
        Ok(_) => (&[], 0),
        Err(violations) => (&violations.list, violations.found),
    }
}
