//! What columns and properties are usually called.
//!
//! A name is looked for in any case and without its unit: `Elev (m)` and `elev_m` are `elev`. A name without a unit is
//! better than one with it, so that `x` beside `x_ft` is x.

/// The usual names of heights, the better ones first.
pub(super) const HEIGHTS: [&str; 15] = [
    "z",
    "elevation",
    "elev",
    "ele",
    "height",
    "h",
    "altitude",
    "alt",
    "point_z",
    "z_coord",
    "zcoord",
    "coord_z",
    "z_value",
    "contour",
    "hoehe",
];

/// The units that may end a name.
const UNITS: [&str; 7] = ["m", "ft", "meter", "meters", "metres", "feet", "masl"];

/// Which of these names, in lower case, a name is, and whether it has a unit. The lowest rank is the best.
pub(super) fn rank(known: &[&str], name: &str) -> Option<(usize, bool)> {
    let name = name.to_lowercase();
    let place = |name: &str| known.iter().position(|&known| known == name);
    let bracket = name.find(['(', '[']).filter(|&at| at > 0);
    let plain = name[..bracket.unwrap_or(name.len())].trim();
    let without_unit = || {
        let (plain, unit) = plain.rsplit_once(['_', ' '])?;
        place(plain.trim_end()).filter(|_| UNITS.contains(&unit))
    };
    match place(plain) {
        Some(place) => Some((place, bracket.is_some())),
        None => without_unit().map(|place| (place, true)),
    }
}

#[cfg(test)]
mod tests {
    use super::{HEIGHTS, rank};

    #[test]
    fn a_unit_is_no_part_of_a_name() {
        for name in ["elev", "Elev", " elev "] {
            assert_eq!(rank(&HEIGHTS, name), Some((2, false)), "{name}");
        }
        for name in ["ELEV_M", "elev (m)", "Elev[ft]", "elev ft"] {
            assert_eq!(rank(&HEIGHTS, name), Some((2, true)), "{name}");
        }
        for name in ["m", "elev_x", "elevator", "_m", "(z)", ""] {
            assert_eq!(rank(&HEIGHTS, name), None, "{name}");
        }
    }
}
