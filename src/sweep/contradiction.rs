//! What only signs that contradict each other lead to: a panic that says so. The sweep ends for any scalar.
//!
//! Walks and loops are limited by the number of triangles, flips by a *limit* ([`super::flip_limit`]). The limit is
//! quadratic, and no exact scalar can reach it: a flip lowers the lifted surface, so a side that was flipped away does not
//! come back before the next edge is inserted. With n vertices and two artificial ones there are fewer than
//! (n + 2)^2 / 2 sides. A scalar that reaches the limit contradicts itself: each of its signs may look right, but together
//! they belong to no points. Without a limit its flips might never end.

/// Panics: only signs that contradict each other can lead here.
#[cold]
#[inline(never)]
pub(super) fn inexact_scalar() -> ! {
    panic!("the scalar is not exact: its signs contradict each other");
}
