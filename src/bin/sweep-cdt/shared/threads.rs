//! How many threads work.

use std::num::NonZeroUsize;

use rayon::ThreadPoolBuilder;

use super::failure::Failure;

/// Starts so many threads for all that follows. Nothing may have been done on several threads yet.
pub(crate) fn limit(threads: NonZeroUsize) -> Result<(), Failure> {
    let pool = ThreadPoolBuilder::new().num_threads(threads.get());
    pool.build_global()
        .map_err(|error| Failure::Error(format!("--threads {threads}: {error}")))
}
