//! What the subcommands share.

pub(crate) mod arithmetic;
pub(crate) mod failure;
pub(crate) mod files;
pub(crate) mod input;
pub(crate) mod inside;
pub(crate) mod output_args;
pub(crate) mod outputs;
pub(crate) mod resources;
pub(crate) mod settings;
pub(crate) mod signals;
pub(crate) mod tables;
pub(crate) mod unnamed;
pub(crate) mod verification;
