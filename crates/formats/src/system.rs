//! The coordinate system of a file, which goes through as it is: nothing is computed with it. Of the text of a cloud (WKT
//! of systems, not of shapes) the number of the EPSG counts that stands in the system of x and y, not in that of heights
//! or in a part of it.

use serde_json::Value;
use serde_json::value::RawValue;

use crate::ReadError;

/// A coordinate system: the member `crs` of a `GeoJSON`, the `SRID` of a WKT, or the number in a record of a `.las`.
///
/// ```
/// use sweep_cdt_formats::CoordinateSystem;
///
/// let system = CoordinateSystem::of_srid(25832);
/// assert!(system.json().contains("urn:ogc:def:crs:EPSG::25832"));
/// assert_eq!(system.srid(), Some(25832));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CoordinateSystem {
    /// The text of the member `crs`.
    json: String,
    /// Whether it is known to be one of longitudes and latitudes, or known not to be.
    is_geographic: Option<bool>,
}

impl CoordinateSystem {
    /// The system of a number of the EPSG.
    pub fn of_srid(srid: u32) -> CoordinateSystem {
        CoordinateSystem::named(&format!("urn:ogc:def:crs:EPSG::{srid}"))
    }

    /// The system of this name.
    pub fn named(name: &str) -> CoordinateSystem {
        let name = Value::from(name);
        CoordinateSystem {
            json: format!(r#"{{"type":"name","properties":{{"name":{name}}}}}"#),
            is_geographic: None,
        }
    }

    /// The system of a number of the EPSG, of longitudes and latitudes or of a plane.
    pub fn of_epsg(srid: u32, is_geographic: bool) -> CoordinateSystem {
        CoordinateSystem {
            is_geographic: Some(is_geographic),
            ..CoordinateSystem::of_srid(srid)
        }
    }

    /// The system of x and y that a text of WKT describes, if it has a number of the EPSG.
    ///
    /// ```
    /// use sweep_cdt_formats::CoordinateSystem;
    ///
    /// let text = r#"COMPD_CS["both", PROJCS["UTM 32", GEOGCS["ETRS89", AUTHORITY["EPSG", "4258"]],
    ///     AUTHORITY["EPSG", "25832"]], VERT_CS["height", AUTHORITY["EPSG", "5783"]]]"#;
    /// let system = CoordinateSystem::of_wkt(text).unwrap();
    /// assert_eq!((system.srid(), system.is_geographic()), (Some(25832), Some(false)));
    /// ```
    pub fn of_wkt(text: &str) -> Option<CoordinateSystem> {
        let (mut depth, mut is_quoted, mut word) = (0_usize, false, 0);
        // How deep the system of x and y stands, and whether it is geographic.
        let mut system = None;
        for (at, sign) in text.char_indices() {
            match sign {
                '"' => is_quoted = !is_quoted,
                _ if is_quoted => {}
                '[' | '(' => {
                    depth += 1;
                    let name = text[word..at].trim().to_ascii_uppercase();
                    match (system, &name[..]) {
                        (None, "PROJCS" | "PROJCRS") => system = Some((depth, false)),
                        (None, "GEOGCS" | "GEOGCRS") => system = Some((depth, true)),
                        (Some((above, is_geographic)), "AUTHORITY" | "ID")
                            if depth == above + 1 =>
                        {
                            let mut parts = text[at + 1..].split([',', ']', ')']);
                            let mut part = || Some(parts.next()?.trim().trim_matches('"'));
                            if part()?.eq_ignore_ascii_case("EPSG") {
                                let number = part()?.parse().ok()?;
                                return Some(CoordinateSystem::of_epsg(number, is_geographic));
                            }
                        }
                        _ => {}
                    }
                }
                ']' | ')' => {
                    depth = depth.saturating_sub(1);
                    if system.is_some_and(|(above, _)| depth < above) {
                        return None;
                    }
                }
                _ => {}
            }
            if "[](),".contains(sign) {
                word = at + 1;
            }
        }
        None
    }

    /// The system of a member `crs`.
    pub(crate) fn of_json(json: &RawValue) -> CoordinateSystem {
        CoordinateSystem {
            json: json.get().to_owned(),
            is_geographic: None,
        }
    }

    /// The text of the member `crs` of a `GeoJSON`.
    pub fn json(&self) -> &str {
        &self.json
    }

    /// Whether coordinates are longitudes and latitudes, where the file says so.
    pub fn is_geographic(&self) -> Option<bool> {
        self.is_geographic
    }

    /// The number of the EPSG, if the text has one: behind `EPSG:` and a version, if there is one.
    pub fn srid(&self) -> Option<u32> {
        let (_, behind) = self.json.split_once("EPSG:")?;
        let end = behind.find(|c: char| c != ':' && c != '.' && !c.is_ascii_digit());
        let number = behind[..end.unwrap_or(behind.len())].rsplit(':').next()?;
        number.parse().ok()
    }

    /// Whether it is one of longitudes and latitudes: `CRS84` and such, or a number of the EPSG from 4001 to 4999.
    ///
    /// ```
    /// use sweep_cdt_formats::CoordinateSystem;
    ///
    /// assert!(CoordinateSystem::of_srid(4326).is_of_degrees());
    /// assert!(!CoordinateSystem::of_srid(25832).is_of_degrees());
    /// ```
    pub fn is_of_degrees(&self) -> bool {
        let is_named = |name: &&str| self.json.contains(name);
        let is_of_epsg = |srid| (4001..5000).contains(&srid);
        let seems = || {
            let mut names = ["CRS84", "CRS83", "CRS27"].iter();
            names.any(is_named) || self.srid().is_some_and(is_of_epsg)
        };
        self.is_geographic.unwrap_or_else(seems)
    }

    /// The one system of files of these names; those without one have that of the others.
    ///
    /// # Errors
    /// Two files have different ones.
    pub fn of_all<'a>(
        files: impl Iterator<Item = (&'a str, Option<CoordinateSystem>)>,
    ) -> Result<Option<CoordinateSystem>, ReadError> {
        let mut systems = files.filter_map(|(name, system)| Some((name, system?)));
        let Some((first, system)) = systems.next() else {
            return Ok(None);
        };
        match systems.find(|(_, other)| !other.is(&system)) {
            None => Ok(Some(system)),
            Some((name, other)) => {
                let [system, other] = [&system, &other].map(CoordinateSystem::name);
                let message = format!(
                    "the coordinate system is {other}, and that of {first} is {system}: files of one input must have the same"
                );
                Err(ReadError::of_file(name, message))
            }
        }
    }

    /// Whether it is the system of another file: by the numbers of both, or else by what their members say.
    fn is(&self, other: &CoordinateSystem) -> bool {
        let member = |json| serde_json::from_str::<Value>(json).ok();
        match [self, other].map(CoordinateSystem::srid) {
            [Some(one), Some(other)] => one == other,
            _ => member(&self.json) == member(&other.json),
        }
    }

    /// The name of the system in messages.
    pub fn name(&self) -> String {
        match self.srid() {
            Some(srid) => format!("EPSG:{srid}"),
            None => self.json.clone(),
        }
    }
}
