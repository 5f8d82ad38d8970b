//! The formats as one program: odd but correct files (`files`), points as text (`points`), and with the feature
//! `mesh-formats` the formats of other programs (`meshes`, `vtu`, `msh`, `numpy`), and files that are refused
//! (`meshes_refused`).

#[cfg(feature = "mesh-formats")]
mod dxf;
mod files;
#[cfg(feature = "mesh-formats")]
mod meshes;
#[cfg(feature = "mesh-formats")]
mod meshes_refused;
#[cfg(feature = "mesh-formats")]
mod msh;
#[cfg(feature = "mesh-formats")]
mod numpy;
mod points;
mod reports;
#[cfg(feature = "mesh-formats")]
mod vtu;
