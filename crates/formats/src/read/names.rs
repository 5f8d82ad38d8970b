//! What columns and properties are usually called.
//!
//! A name is looked for in any case and without its unit: `Elev (m)` and `elev_m` are `elev`. A name without a unit is
//! better than one with it, so that `x` beside `x_ft` is x.

use crate::read::source::quoted;

/// The names of x and y, in families: both are of the same one.
const PLACES: [[&[&str]; 2]; 5] = [
    [&["x"], &["y"]],
    [
        &["point_x", "x_coord", "xcoord", "coord_x"],
        &["point_y", "y_coord", "ycoord", "coord_y"],
    ],
    [
        &["easting", "east", "rechtswert"],
        &["northing", "north", "hochwert"],
    ],
    [&["longitude", "lon", "long", "lng"], &["latitude", "lat"]],
    [
        &["e", "este", "est", "ost"],
        &["n", "norte", "nord", "nord"],
    ],
];

/// The usual names of heights, the better ones first.
pub(super) const HEIGHTS: [&str; 20] = [
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
    "höhe",
    "cota",
    "quota",
    "cote",
    "altitud",
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

/// Columns that are known by their names.
pub(super) struct Places {
    pub(super) x: usize,
    pub(super) y: usize,
    /// The columns with the best name of a height.
    pub(super) heights: Vec<usize>,
}

/// The columns by their names; nothing, if none are x and y.
pub(super) fn places(names: &[String]) -> Result<Option<Places>, String> {
    // The columns with the best of these names.
    let places = |known: &[&str]| {
        let ranks = names.iter().map(|name| rank(known, name));
        let ranks: Vec<Option<(usize, bool)>> = ranks.collect();
        let best = ranks.iter().flatten().min();
        let is_best = |at: &usize| best.is_some() && ranks[*at].as_ref() == best;
        (0..names.len()).filter(is_best).collect::<Vec<usize>>()
    };
    let mut pairs = PLACES.iter().map(|pair| pair.map(places));
    let Some([x, y]) = pairs.find(|pair| pair.iter().all(|places| !places.is_empty())) else {
        return Ok(None);
    };
    Ok(Some(Places {
        x: only(&x, "x", names)?,
        y: only(&y, "y", names)?,
        heights: places(&HEIGHTS),
    }))
}

/// The columns of x, y and perhaps the height by their names, as in the first row of a table; nothing, if none are x and y.
///
/// ```
/// use sweep_cdt_formats::named_columns;
///
/// let names = ["id", "Northing", "Easting", "elev (m)"].map(str::to_owned);
/// assert_eq!(named_columns(&names), Ok(Some(vec![2, 1, 3])));
/// assert_eq!(named_columns(&names[..1]), Ok(None));
/// assert!(named_columns(&names[..2]).is_err());
/// ```
///
/// # Errors
/// Two columns may both be one of them, or one is x, y or the height and others are not. The text names them.
pub fn named_columns(names: &[String]) -> Result<Option<Vec<usize>>, String> {
    let Some(Places { x, y, heights }) = places(names)? else {
        return half(names).map_or(Ok(None), |half| {
            Err(format!("{half}: rename columns, or pass an array of them"))
        });
    };
    let mut found = vec![x, y];
    if !heights.is_empty() {
        found.push(only(&heights, "the height", names)?);
    }
    Ok(Some(found))
}

/// What there is of the names of x, y and heights, and what is missing beside it.
fn half(names: &[String]) -> Option<String> {
    let find = |known: &[&str]| {
        let mut ranks = names.iter().map(|name| Some((name, rank(known, name)?.0)));
        ranks.find_map(|found| found)
    };
    let [named @ .., _] = &PLACES;
    // A column `e`, `n` or `est` alone may be anything.
    let sides = named.iter().flat_map(|&[x, y]| [(x, y), (y, x)]);
    let mut halves = sides.filter_map(|(one, other)| {
        let (name, at) = find(one)?;
        let missing = other[at.min(other.len() - 1)];
        Some(format!(
            "there is {} but no `{missing}`",
            quoted(name.as_bytes())
        ))
    });
    halves.next().or_else(|| {
        let (name, _) = find(&HEIGHTS)?;
        Some(format!(
            "there is {} but no `x` and no `y`",
            quoted(name.as_bytes())
        ))
    })
}

/// The column with the best of the names of a height, the first of several; nothing, if none has one.
///
/// ```
/// use sweep_cdt_formats::named_height;
///
/// let names = ["name", "alt", "ELEV_M"].map(str::to_owned);
/// assert_eq!(named_height(&names), Some(2));
/// ```
pub fn named_height(names: &[String]) -> Option<usize> {
    let ranks = names.iter().enumerate();
    let ranks = ranks.filter_map(|(at, name)| Some((rank(&HEIGHTS, name)?, at)));
    ranks.min().map(|(_, at)| at)
}

/// The only one of the columns that may be x, y or the height.
pub(super) fn only(columns: &[usize], what: &str, names: &[String]) -> Result<usize, String> {
    match columns {
        [one, other, ..] => {
            let [one, other] = [one, other].map(|&at| quoted(names[at].as_bytes()));
            Err(format!(
                "the columns {one} and {other} may both be {what}: rename one"
            ))
        }
        _ => Ok(columns[0]),
    }
}

#[cfg(test)]
mod tests {
    use super::{HEIGHTS, named_columns, rank};

    #[test]
    fn half_a_pair_is_no_place() {
        for (names, message) in [
            (
                ["number", "Height"],
                "there is `Height` but no `x` and no `y`",
            ),
            (
                ["number", "easting"],
                "there is `easting` but no `northing`",
            ),
            (["lat (deg)", "z"], "there is `lat (deg)` but no `lon`"),
            (["y", "lon"], "there is `y` but no `x`"),
        ] {
            let found = named_columns(&names.map(str::to_owned));
            let message = format!("{message}: rename columns, or pass an array of them");
            assert_eq!(found, Err(message));
        }
        let other = ["e", "value"].map(str::to_owned);
        assert_eq!(named_columns(&other), Ok(None));
    }

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
