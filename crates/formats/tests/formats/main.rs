//! The formats as one program: certificates (`certificates`), vertices that are matched (`matching`), odd but correct files
//! (`files`), points as text (`points`), roles of rings (`roles`), every pair of formats (`exchange`), and with the feature
//! `mesh-formats` the formats of other programs (`meshes`, `vtu`, `msh`, `numpy`), and files that are refused
//! (`meshes_refused`).

mod certificates;
#[cfg(feature = "mesh-formats")]
mod dxf;
mod exchange;
mod files;
mod matching;
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
mod roles;
#[cfg(feature = "mesh-formats")]
mod vtu;
