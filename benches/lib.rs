//! The benches `instructions`, `memory` and `crossings` measure the library as its users build it: `cargo bench -p
//! sweep-cdt-benches`. The comparison with other programs is a workspace of its own, in `peers`.
