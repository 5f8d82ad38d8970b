//! What the subcommands share.

pub(crate) mod arithmetic;
pub(crate) mod atomic_files;
pub(crate) mod failure;
pub(crate) mod file_argument;
pub(crate) mod format;
pub(crate) mod input;
pub(crate) mod output;
pub(crate) mod progress;
pub(crate) mod rationals;
pub(crate) mod report;
pub(crate) mod settings;
pub(crate) mod table;
pub(crate) mod verification;
