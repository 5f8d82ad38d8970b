//! Which inputs get the judges that cost much.
//!
//! A fuzzer finds a fault sooner if it sees many inputs with cheap judges than few with all. The bytes of an input decide,
//! so that a finding is found again.

/// Whether these bytes are among the chosen ones, about one in so many.
pub(crate) fn is_chosen(bytes: &[u8], one_in: u64) -> bool {
    of(bytes).is_multiple_of(one_in)
}

/// A number that these bytes choose.
pub(crate) fn of(bytes: &[u8]) -> u64 {
    // FNV-1a, whose low bits alone are poor.
    let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
    let hash = bytes.iter().fold(0xcbf2_9ce4_8422_2325, mix);
    hash ^ hash >> 32
}

#[test]
fn about_one_in_four_is_chosen() {
    let chosen = (0_u16..4000)
        .filter(|number| is_chosen(&number.to_le_bytes(), 4))
        .count();
    assert!((900..1100).contains(&chosen), "{chosen}");
}
