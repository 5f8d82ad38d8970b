//! The formats as one program: odd but correct files (`files`), and with the feature `mesh-formats` the formats of
//! other programs (`meshes`, `vtu`), and files that are refused (`meshes_refused`).

mod files;
#[cfg(feature = "mesh-formats")]
mod meshes;
#[cfg(feature = "mesh-formats")]
mod meshes_refused;
mod points;
mod reports;
#[cfg(feature = "mesh-formats")]
mod vtu;
