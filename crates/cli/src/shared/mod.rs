//! Parts that the subcommands share.

pub(crate) mod arguments;
pub(crate) mod arithmetic;
pub(crate) mod around;
pub(crate) mod bounds;
pub(crate) mod earlier;
pub(crate) mod failure;
pub(crate) mod files;
pub(crate) mod glossary;
pub(crate) mod inside;
pub(crate) mod layers;
pub(crate) mod missing;
pub(crate) mod outputs;
pub(crate) mod places;
pub(crate) mod raster;
pub(crate) mod resources;
pub(crate) mod settings;
pub(crate) mod splitting;
pub(crate) mod tables;
pub(crate) mod terrain;
pub(crate) mod unnamed;
mod unread;
pub(crate) mod verification;
