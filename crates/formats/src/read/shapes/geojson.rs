//! `GeoJSON` (RFC 7946): a geometry, a feature, or collections of them; one, or a sequence of them, one a line or as
//! RFC 8142 has them.
//!
//! | type | an input takes | a result takes |
//! |---|---|---|
//! | `Point`, `MultiPoint` | points | |
//! | `LineString`, `MultiLineString` | points and edges | |
//! | `Polygon`, `MultiPolygon` | points and edges of the rings | triangles: polygons of three corners |
//! | `GeometryCollection`, `Feature`, `FeatureCollection` | what is in it | what is in it |
//!
//! The third coordinate is a height, unless [`Source::height_property`] names a property that is. Where there is
//! neither, of points and lines the best of the usual names (`names.rs`) with a number is. The member
//! `crs` goes through. Without it, or where it is one of degrees, a side that spans more than 180 of them gets a
//! remark. The properties of features with polygons go along. Numbers of a position behind the third are measures.
//! Measures, other properties and members are ignored with a remark, and so is a geometry that is `null` or
//! whose coordinates are an empty list, without one. A coordinate may be a string with a fraction, as in our own JSON.
//!
//! Cost: each object is read once for each object around it, of which there may be [`NESTED`].

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::properties::PROPERTY;
use crate::read::content::Syntax;
use crate::read::json::pieces::{Measured, Position, fault, members, texts};
use crate::read::names::{HEIGHTS, rank};
use crate::read::shapes::{Part, Shapes};
use crate::read::source::{ReadError, Source, quoted};
use crate::{CoordinateSystem, Remark};

/// So many objects may be in each other.
const NESTED: usize = 100;

/// Any object of the format.
#[derive(Default)]
struct Object<'a> {
    kind: Option<&'a RawValue>,
    coordinates: Option<&'a RawValue>,
    geometry: Option<&'a RawValue>,
    geometries: Option<&'a RawValue>,
    features: Option<&'a RawValue>,
    properties: Option<&'a RawValue>,
    system: Option<&'a RawValue>,
    /// The names of other members.
    others: Vec<String>,
}

/// The types of objects.
#[derive(Clone, Copy, Deserialize)]
enum Kind {
    Point,
    MultiPoint,
    LineString,
    MultiLineString,
    Polygon,
    MultiPolygon,
    GeometryCollection,
    Feature,
    FeatureCollection,
}

impl<'a> Object<'a> {
    /// The object that a piece is, if it is one, and has no member of the format twice.
    fn of(piece: &'a RawValue) -> Option<Object<'a>> {
        let mut object = Object::default();
        for (name, value) in members(piece.get().as_bytes())? {
            let member = match &name[..] {
                "type" => &mut object.kind,
                "coordinates" => &mut object.coordinates,
                "geometry" => &mut object.geometry,
                "geometries" => &mut object.geometries,
                "features" => &mut object.features,
                "properties" => &mut object.properties,
                "crs" => &mut object.system,
                _ => {
                    object.others.push(name);
                    continue;
                }
            };
            if member.replace(value).is_some() {
                return None;
            }
        }
        object.kind.is_some().then_some(object)
    }

    /// The type, if the format has it.
    fn kind(&self) -> Option<Kind> {
        serde_json::from_str(self.kind?.get()).ok()
    }
}

/// The objects in a list.
fn list(piece: Option<&RawValue>) -> Option<Vec<&RawValue>> {
    piece.map_or(Some(Vec::new()), |piece| {
        serde_json::from_str(piece.get()).ok()
    })
}

/// Whether a `.json` holds `GeoJSON`: its first text has a type of it.
pub(crate) fn is_in(source: &Source) -> bool {
    let text = source.text().unwrap_or_default();
    let mut texts = serde_json::Deserializer::from_slice(text).into_iter::<&RawValue>();
    let first = texts.next().and_then(Result::ok);
    first
        .and_then(Object::of)
        .is_some_and(|object| object.kind().is_some())
}

/// The refusal of JSON that holds a map in another program's form, by its name and with what makes one that is read.
pub(crate) fn foreign(source: &Source) -> Option<ReadError> {
    let text = source.text().ok()?;
    let mut texts = serde_json::Deserializer::from_slice(text).into_iter::<&RawValue>();
    let piece = texts.next()?.ok()?;
    let members = members(piece.get().as_bytes())?;
    let value = |name: &str| {
        let mut members = members.iter();
        let member = members.find(|(other, _)| other == name);
        member.map(|(_, value)| value.get())
    };
    let is_esri = ["geometryType", "spatialReference", "rings", "paths"]
        .iter()
        .any(|name| value(name).is_some())
        || value("features").is_some_and(|features| features.contains("\"attributes\""));
    let ogr = "`ogr2ogr -f GeoJSON` makes a .geojson of it";
    let (form, help) = match value("type") {
        Some("\"Topology\"") => ("TopoJSON", ogr),
        Some("\"CityJSON\"") => (
            "CityJSON",
            "`cjio FILE export obj FILE.obj` makes an .obj of it",
        ),
        None if is_esri => ("Esri's JSON", ogr),
        _ => return None,
    };
    let message = format!("this is {form}, which is not read: {help}");
    Some(ReadError::of_file(&source.name, message))
}

/// Reads a `.geojson`.
pub(crate) fn read(source: &Source) -> Result<Shapes<'_>, ReadError> {
    let mut shapes = Shapes::new(source, Syntax::Json);
    // What is still to be read, each with the number of objects around it, and whether a feature is; the next one last.
    let mut waiting: Vec<_> = texts(source)?.into_iter().rev().map(Waiting::new).collect();
    let mut raised = Raised::default();
    while let Some(next) = waiting.pop() {
        let Waiting {
            piece,
            around,
            feature,
        } = next;
        if piece.get() == "null" {
            continue;
        }
        if around > NESTED {
            let message = format!("more than {NESTED} objects are in each other");
            return Err(fault(source, piece, message));
        }
        let in_it = |piece| Waiting {
            piece,
            around: around + 1,
            feature: feature.clone(),
        };
        let wrong = |piece: &RawValue, what: &str| {
            let shown = quoted(piece.get().as_bytes());
            fault(source, piece, format!("{shown} is not {what}"))
        };
        let object = Object::of(piece)
            .ok_or_else(|| wrong(piece, "a geometry, a feature or a collection of them"))?;
        // GDAL names each collection as the file.
        let is_file = matches!(object.kind(), Some(Kind::FeatureCollection));
        let others = object
            .others
            .iter()
            .filter(|name| !is_file || *name != "name");
        for name in others {
            shapes
                .remarks
                .ignore_named(1, ["member", "members"], name.as_bytes());
        }
        if let Some(system) = object.system.filter(|system| system.get() != "null") {
            shapes.system = Some(CoordinateSystem::of_json(system));
        }
        let coordinates = || object.coordinates.unwrap_or(piece);
        let all = |piece| {
            list(piece).ok_or_else(|| wrong(piece.unwrap_or(next.piece), "a list of objects"))
        };
        let kind = object
            .kind()
            .ok_or_else(|| wrong(object.kind.unwrap_or(piece), "a type of GeoJSON"))?;
        let is_geometry = !matches!(
            kind,
            Kind::Feature | Kind::FeatureCollection | Kind::GeometryCollection
        );
        if is_geometry && feature.is_none() {
            shapes.begin_feature();
        }
        let first = shapes.len();
        match kind {
            Kind::Feature => {
                shapes.begin_feature();
                let properties = raised.properties(source, &object, &mut shapes)?;
                let geometry = object.geometry.map(in_it);
                waiting.extend(geometry.map(|waiting| Waiting {
                    feature: Some(properties),
                    ..waiting
                }));
            }
            Kind::FeatureCollection => {
                waiting.extend(all(object.features)?.into_iter().rev().map(in_it));
            }
            Kind::GeometryCollection => {
                waiting.extend(all(object.geometries)?.into_iter().rev().map(in_it));
            }
            Kind::Point if is_empty(coordinates()) => {}
            Kind::Point => {
                let point: Measured<'_> = serde_json::from_str(coordinates().get())
                    .map_err(|_| wrong(coordinates(), "a position"))?;
                add(&mut shapes, vec![point], Part::Points);
            }
            kind @ (Kind::MultiPoint | Kind::LineString) => {
                let list: Vec<Measured<'_>> = serde_json::from_str(coordinates().get())
                    .map_err(|_| wrong(coordinates(), "a list of positions"))?;
                let is_line = matches!(kind, Kind::LineString);
                add(
                    &mut shapes,
                    list,
                    if is_line { Part::Line } else { Part::Points },
                );
            }
            kind @ (Kind::MultiLineString | Kind::Polygon) => {
                let lists: Vec<Vec<Measured<'_>>> = serde_json::from_str(coordinates().get())
                    .map_err(|_| wrong(coordinates(), "a list of lists of positions"))?;
                if matches!(kind, Kind::Polygon) {
                    add_polygon(&mut shapes, lists);
                } else {
                    lists
                        .into_iter()
                        .for_each(|list| add(&mut shapes, list, Part::Line));
                }
            }
            Kind::MultiPolygon => {
                let polygons: Vec<Vec<Vec<Measured<'_>>>> =
                    serde_json::from_str(coordinates().get())
                        .map_err(|_| wrong(coordinates(), "a list of polygons"))?;
                polygons
                    .into_iter()
                    .for_each(|rings| add_polygon(&mut shapes, rings));
            }
        }
        if let Some(height) = feature.clone().flatten() {
            let is_area = matches!(kind, Kind::Polygon | Kind::MultiPolygon);
            raised.raise(&height, is_area, first, &mut shapes);
        }
    }
    raised.say(source, &mut shapes);
    let system = shapes.system.as_ref();
    if system.is_none_or(CoordinateSystem::is_of_degrees) {
        shapes.say_wide_sides();
    }
    Ok(shapes)
}

/// An object that is still to be read.
struct Waiting<'a> {
    piece: &'a RawValue,
    /// How many objects are around it.
    around: usize,
    /// The height in the properties of the feature around it, if there is one.
    feature: Option<Option<Height<'a>>>,
}

impl<'a> Waiting<'a> {
    fn new(piece: &'a RawValue) -> Waiting<'a> {
        Waiting {
            piece,
            around: 0,
            feature: None,
        }
    }
}

/// A property that is a height.
#[derive(Clone)]
struct Height<'a> {
    name: String,
    piece: &'a RawValue,
    /// Whether it was asked for by its name.
    is_asked: bool,
    /// Whether it is kept as a property, too.
    is_kept: bool,
}

/// The features whose height is a property.
#[derive(Default)]
struct Raised {
    /// The name of the property.
    name: Option<String>,
    count: usize,
    /// The last of them. A feature may have several geometries.
    last: usize,
}

impl Raised {
    /// The height among the properties of a feature. Those of a feature with polygons are kept, all others are ignored.
    fn properties<'a>(
        &mut self,
        source: &Source,
        feature: &Object<'a>,
        shapes: &mut Shapes<'a>,
    ) -> Result<Option<Height<'a>>, ReadError> {
        let members = feature
            .properties
            .and_then(|piece| members(piece.get().as_bytes()));
        let members = members.unwrap_or_default();
        let asked = source.height_property.as_deref();
        let rank_of = |(name, value): &(String, &RawValue)| match asked {
            Some(asked) => (name == asked).then_some((0, false)),
            None => rank(&HEIGHTS, name).filter(|_| is_number(value)),
        };
        let ranks = members.iter().enumerate();
        let ranks = ranks.filter_map(|(at, member)| Some((rank_of(member)?, at)));
        let place = ranks.min().map(|(_, at)| at);
        let geometry = feature.geometry.map_or("", RawValue::get);
        let are_kept = memchr::memmem::find(geometry.as_bytes(), b"Polygon\"").is_some();
        if are_kept {
            let is_height = |name: &str| asked == Some(name);
            shapes.properties.set(shapes.features, &members, is_height);
        }
        let others = members.iter().enumerate();
        let others = others.filter(|(at, _)| Some(*at) != place && !are_kept);
        for (_, (name, _)) in others {
            shapes.remarks.ignore_named(1, PROPERTY, name.as_bytes());
        }
        let Some((name, piece)) = place.map(|place| &members[place]) else {
            return Ok(None);
        };
        if asked.is_some() && !is_number(piece) && piece.get() != "null" {
            let shown = quoted(piece.get().as_bytes());
            return Err(fault(
                source,
                piece,
                format!("{shown} is not a height, a number"),
            ));
        }
        self.name.get_or_insert_with(|| name.clone());
        let is_asked = asked.is_some();
        let height = Height {
            name: name.clone(),
            piece,
            is_asked,
            is_kept: are_kept,
        };
        Ok((piece.get() != "null").then_some(height))
    }

    /// Gives the positions from `first` on the height of their feature. Areas have to be asked for: the height of a
    /// building is not that of its ground.
    fn raise<'a>(
        &mut self,
        height: &Height<'a>,
        is_area: bool,
        first: usize,
        shapes: &mut Shapes<'a>,
    ) {
        let is_height = height.is_asked || !is_area;
        let text = height.piece.get().as_bytes();
        // What was asked for wins.
        if is_height && shapes.raise(first, text, height.is_asked) {
            self.count += usize::from(shapes.features != self.last);
            self.last = shapes.features;
        } else if !height.is_kept && !shapes.is_raised(first, text) {
            shapes
                .remarks
                .ignore_named(1, PROPERTY, height.name.as_bytes());
        }
    }

    /// Says where heights come from, or that none has the property that was asked for.
    fn say(self, source: &Source, shapes: &mut Shapes<'_>) {
        let count = self.count;
        let asked = source.height_property.clone();
        if let Some(name) = asked.or(self.name.filter(|_| count > 0)) {
            shapes.remarks.add(Remark::HeightProperty { name, count });
        }
    }
}

/// Whether a value is a finite number, or a string with one.
fn is_number(value: &RawValue) -> bool {
    Syntax::Json
        .value::<f64>(value.get().as_bytes())
        .is_ok_and(f64::is_finite)
}

/// Whether a list is empty, as coordinates are that stand for none.
fn is_empty(list: &RawValue) -> bool {
    serde_json::from_str(list.get()).is_ok_and(|list: Vec<&RawValue>| list.is_empty())
}

fn add_polygon<'a>(shapes: &mut Shapes<'a>, rings: Vec<Vec<Measured<'a>>>) {
    for (at, ring) in rings.into_iter().enumerate() {
        add(shapes, ring, if at == 0 { Part::Ring } else { Part::Hole });
    }
}

fn add<'a>(shapes: &mut Shapes<'a>, positions: Vec<Measured<'a>>, part: Part) {
    for Measured(Position([x, y], z), measures) in positions {
        shapes.remarks.ignore(measures, "measure", "measures");
        let text = |raw: &'a RawValue| raw.get().as_bytes();
        shapes.push([text(x), text(y)], z.map(text));
    }
    shapes.end(part);
}
