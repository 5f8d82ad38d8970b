//! What columns and properties are usually called.
//!
//! A name is looked for in any case and without its unit: `Elev (m)` and `elev_m` are `elev`.

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

/// Which of these names, in lower case, a name is.
pub(super) fn rank(known: &[&str], name: &str) -> Option<usize> {
    let name = name.to_lowercase();
    let bracket = name.find(['(', '[']).filter(|&at| at > 0);
    let name = name[..bracket.unwrap_or(name.len())].trim();
    let place = |name: &str| known.iter().position(|&known| known == name);
    let without_unit = || {
        let (name, unit) = name.rsplit_once(['_', ' '])?;
        place(name.trim_end()).filter(|_| UNITS.contains(&unit))
    };
    place(name).or_else(without_unit)
}

#[cfg(test)]
mod tests {
    use super::{HEIGHTS, rank};

    #[test]
    fn a_unit_is_no_part_of_a_name() {
        for name in ["elev", "Elev", "ELEV_M", "elev (m)", "Elev[ft]", "elev ft"] {
            assert_eq!(rank(&HEIGHTS, name), Some(2), "{name}");
        }
        for name in ["m", "elev_x", "elevator", "_m", "(z)", ""] {
            assert_eq!(rank(&HEIGHTS, name), None, "{name}");
        }
    }
}
