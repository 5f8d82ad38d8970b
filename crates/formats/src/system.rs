//! The coordinate system of a file, which goes through as it is: nothing is computed with it.

use serde_json::Value;
use serde_json::value::RawValue;

/// A coordinate system: the member `crs` of a `GeoJSON`, or the `SRID` of a WKT.
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
        }
    }

    /// The system of a member `crs`.
    pub(crate) fn of_json(json: &RawValue) -> CoordinateSystem {
        CoordinateSystem {
            json: json.get().to_owned(),
        }
    }

    /// The text of the member `crs` of a `GeoJSON`.
    pub fn json(&self) -> &str {
        &self.json
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
        ["CRS84", "CRS83", "CRS27"].iter().any(is_named) || self.srid().is_some_and(is_of_epsg)
    }

    /// Whether it is the system of another file: by the numbers of both, or else by what their members say.
    pub(crate) fn is(&self, other: &CoordinateSystem) -> bool {
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
