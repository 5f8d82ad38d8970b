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
//! The third coordinate is a height. Properties and all other members are ignored, and so is a geometry that is `null` or whose
//! coordinates are an empty list. A coordinate may be a string with a fraction, as in our own JSON.
//!
//! Cost: each object is read once for each object around it, of which there may be [`NESTED`].

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::read::content::Syntax;
use crate::read::json_pieces::{Position, fault, texts};
use crate::read::shapes::{Part, Shapes};
use crate::read::source::{ReadError, Source, quoted};

/// So many objects may be in each other.
const NESTED: usize = 100;

/// Any object of the format.
#[derive(Deserialize)]
struct Object<'a> {
    #[serde(borrow, rename = "type")]
    kind: &'a RawValue,
    #[serde(borrow, default)]
    coordinates: Option<&'a RawValue>,
    #[serde(borrow, default)]
    geometry: Option<&'a RawValue>,
    #[serde(borrow, default)]
    geometries: Vec<&'a RawValue>,
    #[serde(borrow, default)]
    features: Vec<&'a RawValue>,
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

impl Object<'_> {
    /// The type, if the format has it.
    fn kind(&self) -> Option<Kind> {
        serde_json::from_str(self.kind.get()).ok()
    }
}

/// Whether a `.json` holds `GeoJSON`: its first text has a type of it.
pub(super) fn is_in(source: &Source) -> bool {
    let text = source.text().unwrap_or_default();
    let mut texts = serde_json::Deserializer::from_slice(text).into_iter::<&RawValue>();
    let first = texts.next().and_then(Result::ok).map(RawValue::get);
    first
        .filter(|text| text.starts_with('{'))
        .and_then(|text| serde_json::from_str::<Object<'_>>(text).ok())
        .is_some_and(|object| object.kind().is_some())
}

/// Reads a `.geojson`.
pub(super) fn read(source: &Source) -> Result<Shapes<'_>, ReadError> {
    let mut shapes = Shapes::new(source, Syntax::Json);
    // What is still to be read, each with the number of objects around it, the next one last.
    let mut waiting: Vec<_> = texts(source)?
        .into_iter()
        .rev()
        .map(|text| (text, 0))
        .collect();
    while let Some((piece, around)) = waiting.pop() {
        if piece.get() == "null" {
            continue;
        }
        if around > NESTED {
            let message = format!("more than {NESTED} objects are in each other");
            return Err(fault(source, piece, message));
        }
        let in_it = |piece| (piece, around + 1);
        let wrong = |piece: &RawValue, what: &str| {
            let shown = quoted(piece.get().as_bytes());
            fault(source, piece, format!("{shown} is not {what}"))
        };
        // Serde would take a list for an object without names.
        let object = Some(piece.get()).filter(|text| text.starts_with('{'));
        let object: Object<'_> = object
            .and_then(|text| serde_json::from_str(text).ok())
            .ok_or_else(|| wrong(piece, "a geometry, a feature or a collection of them"))?;
        let coordinates = || object.coordinates.unwrap_or(piece);
        let kind = object.kind();
        match kind.ok_or_else(|| wrong(object.kind, "a type of GeoJSON"))? {
            Kind::Feature => waiting.extend(object.geometry.map(in_it)),
            Kind::FeatureCollection => {
                waiting.extend(object.features.into_iter().rev().map(in_it));
            }
            Kind::GeometryCollection => {
                waiting.extend(object.geometries.into_iter().rev().map(in_it));
            }
            Kind::Point if is_empty(coordinates()) => {}
            Kind::Point => {
                let point: Position<'_> = serde_json::from_str(coordinates().get())
                    .map_err(|_| wrong(coordinates(), "a position"))?;
                add(&mut shapes, vec![point], Part::Points);
            }
            kind @ (Kind::MultiPoint | Kind::LineString) => {
                let list: Vec<Position<'_>> = serde_json::from_str(coordinates().get())
                    .map_err(|_| wrong(coordinates(), "a list of positions"))?;
                let is_line = matches!(kind, Kind::LineString);
                add(
                    &mut shapes,
                    list,
                    if is_line { Part::Line } else { Part::Points },
                );
            }
            kind @ (Kind::MultiLineString | Kind::Polygon) => {
                let lists: Vec<Vec<Position<'_>>> = serde_json::from_str(coordinates().get())
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
                let polygons: Vec<Vec<Vec<Position<'_>>>> =
                    serde_json::from_str(coordinates().get())
                        .map_err(|_| wrong(coordinates(), "a list of polygons"))?;
                polygons
                    .into_iter()
                    .for_each(|rings| add_polygon(&mut shapes, rings));
            }
        }
    }
    Ok(shapes)
}

/// Whether a list is empty, as coordinates are that stand for none.
fn is_empty(list: &RawValue) -> bool {
    serde_json::from_str(list.get()).is_ok_and(|list: Vec<&RawValue>| list.is_empty())
}

fn add_polygon<'a>(shapes: &mut Shapes<'a>, rings: Vec<Vec<Position<'a>>>) {
    for (at, ring) in rings.into_iter().enumerate() {
        add(shapes, ring, if at == 0 { Part::Ring } else { Part::Hole });
    }
}

fn add<'a>(shapes: &mut Shapes<'a>, positions: Vec<Position<'a>>, part: Part) {
    for Position([x, y], z) in positions {
        let text = |raw: &'a RawValue| raw.get().as_bytes();
        shapes.push([text(x), text(y)], z.map(text));
    }
    shapes.end(part);
}
