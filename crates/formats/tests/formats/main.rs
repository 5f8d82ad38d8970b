//! The formats as one program: odd but correct files (`files`), the formats of other programs (`meshes`, `vtu`), and
//! files that are refused (`meshes_refused`).

mod files;
mod meshes;
mod meshes_refused;
mod vtu;
