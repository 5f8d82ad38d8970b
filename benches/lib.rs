//! The benches `instructions`, `memory`, `crossings` and `bands` measure the libraries as their users build them: `cargo
//! bench -p sweep-cdt-benches`. The comparison with other programs is a workspace of its own, in `peers`.
