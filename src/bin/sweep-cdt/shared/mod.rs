//! What the subcommands share.

pub(crate) mod arithmetic;
pub(crate) mod destination;
pub(crate) mod failure;
pub(crate) mod file_argument;
pub(crate) mod files_read;
pub(crate) mod format;
pub(crate) mod identity;
pub(crate) mod input;
pub(crate) mod inside;
pub(crate) mod memory;
pub(crate) mod output_args;
pub(crate) mod outputs;
pub(crate) mod overwriting;
pub(crate) mod printable;
pub(crate) mod progress;
pub(crate) mod rationals;
pub(crate) mod report;
pub(crate) mod settings;
pub(crate) mod signals;
pub(crate) mod table;
pub(crate) mod threads;
pub(crate) mod unnamed;
pub(crate) mod verification;
