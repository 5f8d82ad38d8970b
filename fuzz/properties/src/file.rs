//! Files that show what bytes stand for.

/// The name of a file and what is in it.
pub type File = (String, Vec<u8>);

/// Points and edges as the command reads them.
pub fn json(points: &[[f64; 2]], edges: &[[usize; 2]]) -> String {
    format!("{{\"points\": {points:?}, \"edges\": {edges:?}}}\n")
}
