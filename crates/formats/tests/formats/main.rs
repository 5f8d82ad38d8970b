//! The formats as one program: certificates (`certificates`), vertices that are matched (`matching`), odd but correct files
//! (`files`), files put together (`layers`), points as text (`points`), their columns (`columns`), tables and maps that get
//! heights (`raised`), properties of features (`properties`), roles of rings (`roles`), every pair of formats (`exchange`), the formats of
//! other programs (`meshes`, `vtu`, `msh`, `numpy`), and files that are refused (`meshes_refused`).

mod certificates;
mod columns;
mod exchange;
mod files;
mod layers;
mod matching;
mod meshes;
mod meshes_refused;
mod msh;
mod numpy;
mod points;
mod properties;
mod raised;
mod reports;
mod roles;
mod vtu;
