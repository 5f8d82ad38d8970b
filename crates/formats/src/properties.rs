//! Properties of features: what a `.geojson` says of a polygon beside its place. They go to the triangles that it covers.

use std::collections::HashMap;

use serde_json::value::RawValue;

use crate::{Remark, quoted};

/// The name of one property and of many.
pub(crate) const PROPERTY: [&str; 2] = ["property", "properties"];

/// So many properties are named where they are lost.
const MOST_NAMES: usize = 12;

/// The properties of the features that have polygons, as they stand in the file.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Source, read};
///
/// let text = r#"{"type": "Feature", "properties": {"name": "pond", "depth": 2.50},
///     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]]]}}"#;
/// let Input::Doubles(file) = read(Format::Geojson, &Source::new("a.geojson", text), None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.properties.of(1), r#""name":"pond","depth":2.50"#);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Properties {
    /// The members of each feature, from 1 on, as JSON without the braces around them; others have none.
    members: Vec<String>,
    /// The names in their order, each with the number of features that have it.
    names: Vec<(String, usize)>,
    places: HashMap<String, usize>,
}

impl Properties {
    /// The properties of a feature, counted from 1: members of JSON without the braces around them. One that is called
    /// `feature`, as its number is in what is written, is called `feature_2`.
    pub fn of(&self, feature: usize) -> &str {
        let place = feature.checked_sub(1);
        let members = place.and_then(|place| self.members.get(place));
        members.map_or("", String::as_str)
    }

    /// Sets those of a feature. Those that are heights have no loss to be named.
    pub(crate) fn set(
        &mut self,
        feature: usize,
        members: &[(String, &RawValue)],
        is_height: impl Fn(&str) -> bool,
    ) {
        let mut text = String::new();
        for (name, value) in members {
            if !is_height(name) {
                self.count(name, 1);
            }
            let name = match &name[..] {
                "feature" => "feature_2",
                name => name,
            };
            let comma = if text.is_empty() { "" } else { "," };
            let name = serde_json::Value::from(name);
            text.push_str(&format!("{comma}{name}:{}", value.get()));
        }
        self.members.resize(feature.max(1) - 1, String::new());
        self.members.push(text);
    }

    fn count(&mut self, name: &str, features: usize) {
        let next = self.names.len();
        let place = *self.places.entry(name.to_owned()).or_insert(next);
        if place == next {
            self.names.push((name.to_owned(), 0));
        }
        self.names[place].1 += features;
    }

    /// Adds those of a layer whose features follow so many.
    pub(crate) fn add(&mut self, layer: Properties, before: usize) {
        if !layer.members.is_empty() {
            self.members.resize(before, String::new());
            self.members.extend(layer.members);
        }
        for (name, features) in layer.names {
            self.count(&name, features);
        }
    }

    /// The losses where they are not written, in words.
    pub(crate) fn losses(&self) -> impl Iterator<Item = String> {
        let names = self.names.iter().take(MOST_NAMES);
        let more = self.names.len().saturating_sub(MOST_NAMES);
        let more = (more > 0).then(|| format!("{more} more properties"));
        let named = names.map(|(name, _)| format!("the property {}", quoted(name.as_bytes())));
        named.chain(more)
    }

    /// The remarks where they count for nothing.
    pub(crate) fn ignored(&self) -> Vec<Remark> {
        let (named, others) = self.names.split_at(self.names.len().min(MOST_NAMES));
        let others = others.iter().map(|(_, features)| features).sum();
        let named = named.iter().map(|(name, features)| {
            let [one, many] = PROPERTY.map(|kind| format!("{kind} {}", quoted(name.as_bytes())));
            Remark::ignored(*features, &one, &many)
        });
        let others = (others > 0).then(|| {
            Remark::ignored(
                others,
                "property of another name",
                "properties of other names",
            )
        });
        named.chain(others).collect()
    }
}
