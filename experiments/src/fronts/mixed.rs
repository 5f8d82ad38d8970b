//! Numbers that look random, from the rank of a node: the same ones in every run.

use sweep_cdt::front::FrontNode;

/// 64 bits for a node and a seed (the finalizer of Steele, Lea and Flood's `SplitMix64`).
pub(super) fn mixed(node: FrontNode, seed: u64) -> u64 {
    let mut z = (node.rank() as u64 + 1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(seed);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
