//! Remarks: what is ignored, merged, missing, chosen or guessed on the way from a file to a result. Readers, the engine
//! and the terrain make them. Front ends print them, and add the name of the file.

use std::fmt;

use serde::Serialize;

/// Something about a file or a result that its user should know.
///
/// ```
/// use sweep_cdt_formats::{Format, Input, Remark, Source, read};
///
/// let source = Source::new("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n");
/// let Input::Doubles(file) = read(Format::Obj, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(file.remarks, [Remark::ignored(1, "line of `vt`", "lines of `vt`")]);
/// assert_eq!(file.remarks[0].to_string(), "ignored: 1 line of `vt`");
/// assert_eq!((file.remarks[0].name(), file.remarks[0].is_loss()), ("ignored", true));
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[non_exhaustive]
pub enum Remark {
    /// The file says something, and nothing is made of it.
    Ignored {
        /// How many there are.
        count: usize,
        /// The name of so many.
        what: String,
    },
    /// The format has more of points than any reader takes, on which nothing depends that can be asked.
    Unread {
        /// How many there are.
        count: usize,
        /// The name of so many.
        what: String,
    },
    /// The faces of a mesh count for nothing: what is triangulated is the hull of the vertices.
    Faces {
        /// How many there are.
        count: usize,
    },
    /// One place has two numbers in a column.
    Conflict {
        /// The name of the column.
        column: String,
        /// The vertex, as a position.
        vertex: usize,
        /// The number that counts, and the first other one.
        values: [f64; 2],
        /// How many places have two numbers.
        count: usize,
    },
    /// An output has no room for this.
    NotWritten {
        /// The names of all that is left out.
        what: Vec<String>,
    },
    /// Heights stand in a property, or were asked for in one or in a column that is not there.
    HeightProperty {
        /// The name of the property or column.
        name: String,
        /// How many features have it: none if it is not there.
        count: usize,
    },
    /// A table names no columns, so that their order tells x, y and z.
    Columns {
        /// The columns of x, y and z, from 1; those of z where there is one.
        places: Vec<usize>,
        /// How many columns there are.
        count: usize,
    },
    /// A number was asked to mean that there is none.
    NoValue {
        /// The number.
        value: f64,
        /// How many there are in the columns.
        count: usize,
    },
    /// Heights are a number that programs write where there is none.
    Void {
        /// The number.
        value: f64,
        /// How many heights are that.
        count: usize,
    },
    /// Points of some classes alone were asked for.
    Classes {
        /// How many points are of these classes.
        kept: usize,
        /// How many points there are.
        points: usize,
        /// The classes of all points in ascending order, each with how many it has.
        counts: Vec<(u8, usize)>,
    },
    /// A header contradicts the rest of its file, or says that all points are one.
    Promise {
        /// The contradiction, in words.
        what: String,
    },
    /// Sides that span more than half of all longitudes, in a map of longitudes and latitudes.
    HalfOfTheGlobe {
        /// How many there are.
        edges: usize,
    },
    /// Sides of polygons that one polygon has twice, so that they bound nothing.
    TracedTwice {
        /// How many there are.
        edges: usize,
    },
    /// Heights are made from those of the vertices around.
    Interpolated {
        /// How many are made.
        heights: usize,
        /// How many vertices lie outside of the hull of those with heights.
        outside: usize,
    },
    /// Vertices have no height, and others have.
    WithoutHeights {
        /// How many have none.
        missing: usize,
        /// How many there are.
        vertices: usize,
    },
    /// Triangles of a terrain are left out: they have a corner without a height.
    OpenTriangles {
        /// How many there are.
        missing: usize,
        /// How many triangles there are.
        triangles: usize,
    },
    /// Places on no triangle of a terrain: they get no height.
    OffTerrain {
        /// How many there are.
        missing: usize,
        /// How many places there are.
        places: usize,
    },
    /// Polygons overlap: each triangle names one feature alone.
    CoveredTwice {
        /// How many triangles more than one polygon covers.
        triangles: usize,
    },
    /// Triangles of a refined mesh break a bound still.
    Unrefined {
        /// How many do for this reason.
        triangles: usize,
        /// The reason, in words.
        reason: String,
    },
    /// Greatest areas of regions count for nothing: the rule for what is inside has no regions.
    UnusedAreas {
        /// How many there are.
        areas: usize,
        /// The name of the rule.
        rule: String,
    },
    /// Every side between two triangles is an edge, so that none had to be Delaunay.
    NothingFree {
        /// How many such sides there are.
        sides: usize,
    },
    /// Equal points share a cell.
    SharedCells {
        /// How many are equal to a point before them.
        points: usize,
    },
    /// There are no triangles.
    NoTriangles(NoTriangles),
    /// There are triangles, and none is inside.
    NothingInside {
        /// How many edges there are.
        edges: usize,
        /// Whether there are seeds of holes.
        has_holes: bool,
    },
}

/// Why there are no triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "why", rename_all = "kebab-case")]
pub enum NoTriangles {
    /// There are no points.
    NoPoints,
    /// All points are equal.
    OnePlace,
    /// All points lie on one line.
    OneLine {
        /// The coordinate that all share while the heights differ, 0 for x: it is up perhaps.
        up: Option<usize>,
    },
}

impl Remark {
    /// So many things that are ignored, with the name of one and of many.
    pub fn ignored(count: usize, one: &str, many: &str) -> Remark {
        let what = if count == 1 { one } else { many }.to_owned();
        Remark::Ignored { count, what }
    }

    /// The remark on sides that span more than half of all longitudes, if there are any. Where only one place is no
    /// longitude and latitude, none is.
    ///
    /// ```
    /// use sweep_cdt_formats::Remark;
    ///
    /// let places = [[179.0, -17.0], [-179.5, -17.0], [-179.5, -16.0]];
    /// let remark = Remark::half_of_the_globe(&places, [[0, 1], [1, 2], [2, 0]]);
    /// assert_eq!(remark, Some(Remark::HalfOfTheGlobe { edges: 2 }));
    /// ```
    ///
    /// # Panics
    /// A side ends at no place.
    pub fn half_of_the_globe(
        places: &[[f64; 2]],
        sides: impl IntoIterator<Item = [usize; 2]>,
    ) -> Option<Remark> {
        let is_on_globe = |[x, y]: &[f64; 2]| x.abs() <= 180.0 && y.abs() <= 90.0;
        if !places.iter().all(is_on_globe) {
            return None;
        }
        let is_wide = |&[a, b]: &[usize; 2]| (places[a][0] - places[b][0]).abs() > 180.0;
        let edges = sides.into_iter().filter(is_wide).count();
        (edges > 0).then_some(Remark::HalfOfTheGlobe { edges })
    }

    /// The name of the kind, which stays as it is.
    pub fn name(&self) -> &'static str {
        match self {
            Remark::Ignored { .. } => "ignored",
            Remark::Unread { .. } => "unread",
            Remark::Faces { .. } => "faces",
            Remark::Conflict { .. } => "conflict",
            Remark::NotWritten { .. } => "not-written",
            Remark::HeightProperty { .. } => "height-property",
            Remark::Columns { .. } => "columns",
            Remark::NoValue { .. } => "no-value",
            Remark::Void { .. } => "void",
            Remark::Classes { .. } => "classes",
            Remark::Promise { .. } => "promise",
            Remark::HalfOfTheGlobe { .. } => "half-of-the-globe",
            Remark::TracedTwice { .. } => "traced-twice",
            Remark::Interpolated { .. } => "interpolated",
            Remark::WithoutHeights { .. } => "without-heights",
            Remark::OpenTriangles { .. } => "open-triangles",
            Remark::OffTerrain { .. } => "off-terrain",
            Remark::CoveredTwice { .. } => "covered-twice",
            Remark::Unrefined { .. } => "unrefined",
            Remark::UnusedAreas { .. } => "unused-areas",
            Remark::NothingFree { .. } => "nothing-free",
            Remark::SharedCells { .. } => "shared-cells",
            Remark::NoTriangles(_) => "no-triangles",
            Remark::NothingInside { .. } => "nothing-inside",
        }
    }

    /// The numbers and names in the remark, by the names of its fields: `null` for a number that is not finite.
    ///
    /// ```
    /// use sweep_cdt_formats::{NoTriangles, Remark};
    /// use serde_json::json;
    ///
    /// let remark = Remark::OffTerrain { missing: 2, places: 9 };
    /// assert_eq!(remark.numbers(), json!({"missing": 2, "places": 9}));
    /// let remark = Remark::NoTriangles(NoTriangles::OneLine { up: Some(0) });
    /// assert_eq!(remark.numbers(), json!({"why": "one-line", "up": 0}));
    /// ```
    ///
    /// # Panics
    /// Never: a remark is made of numbers, names, and lists of them.
    pub fn numbers(&self) -> serde_json::Value {
        serde_json::to_value(self).expect("numbers, names, and lists of them")
    }

    /// Whether something of the file gets lost, or is not as it was asked for. A strict run refuses that.
    pub fn is_loss(&self) -> bool {
        matches!(
            self,
            Remark::Ignored { .. }
                | Remark::Faces { .. }
                | Remark::Conflict { .. }
                | Remark::NotWritten { .. }
                | Remark::Promise { .. }
                | Remark::Unrefined { .. }
                | Remark::UnusedAreas { .. }
        )
    }

    /// The setting that changes it, and what it does, if there is one.
    pub fn setting(&self) -> Option<(&'static str, &'static str)> {
        match self {
            Remark::Faces { .. } => Some(("faces", "takes them for polygons")),
            Remark::Columns { .. } => Some(("columns", "names others")),
            Remark::Void { .. } => Some(("no-value", "takes a number for that")),
            Remark::UnusedAreas { .. } => Some(("inside", "holes has regions")),
            Remark::NothingInside {
                has_holes: true, ..
            } => Some(("inside", "hull-without-holes keeps all but the holes")),
            _ => None,
        }
    }

    /// The remark in words, with a name for the vertex in it.
    pub(crate) fn words(&self, name: impl Fn(usize) -> String) -> String {
        let of = |count: usize, one: &str, many: &str| {
            format!("{count} {}", if count == 1 { one } else { many })
        };
        match self {
            Remark::Ignored { count, what } | Remark::Unread { count, what } => {
                format!("ignored: {count} {what}")
            }
            Remark::Faces { count } => format!(
                "ignored: {}; the hull of the vertices is triangulated",
                of(*count, "face", "faces")
            ),
            Remark::Conflict {
                column,
                vertex,
                values: [kept, other],
                count,
            } => {
                let more = match count.saturating_sub(1) {
                    0 => String::new(),
                    1 => "; another vertex has two, too".to_owned(),
                    more => format!("; {more} more vertices have two, too"),
                };
                let name = name(*vertex);
                format!(
                    "{name} has two numbers for {column}, {kept} and {other}: {kept} counts{more}"
                )
            }
            Remark::NotWritten { what } => format!("not written: {}", what.join(", ")),
            Remark::HeightProperty { name, count: 0 } => {
                format!("no property or column with heights is called `{name}`")
            }
            Remark::HeightProperty { name, count } => {
                let features = of(*count, "feature", "features");
                format!("heights are the property `{name}` of {features}")
            }
            Remark::Columns { places, count } => {
                let places = ["x", "y", "z"].iter().zip(places);
                let places: Vec<String> = places
                    .map(|(name, place)| format!("{name} is column {place}"))
                    .collect();
                format!("{} of {count}: none has a name", places.join(", "))
            }
            Remark::NoValue { value, count: 0 } => format!("no number is {value}"),
            Remark::NoValue { value, count } => {
                let numbers = of(*count, "number is", "numbers are");
                format!("{numbers} {value} and counted as missing")
            }
            Remark::Void { value, count } => {
                let of = of(*count, "height is", "heights are");
                let value = match value.abs() < 1e16 {
                    true => value.to_string(),
                    false => format!("{value:e}"),
                };
                format!("{of} {value}, which often means that there is none")
            }
            Remark::Classes {
                kept,
                points,
                counts,
            } => format!(
                "{kept} of {points} points are of the classes that were chosen: {}",
                of_classes(counts)
            ),
            Remark::Promise { what } => format!("the header says {what}"),
            Remark::HalfOfTheGlobe { edges } => format!(
                "{} more than 180 degrees of longitude: what crosses the line of 180 degrees must be cut there, or have \
                 longitudes beyond 180",
                of(*edges, "edge spans", "edges span")
            ),
            Remark::TracedTwice { edges } => format!(
                "{} traced twice by one polygon: what is covered twice counts as outside by the rules polygons and \
                 even-odd, and as inside by nonzero",
                of(*edges, "edge is", "edges are")
            ),
            Remark::Interpolated {
                heights,
                outside: 0,
            } => {
                let of = of(*heights, "height is", "heights are");
                format!("{of} interpolated")
            }
            Remark::Interpolated { heights, outside } => format!(
                "{heights} heights are interpolated, {outside} vertices lie outside of the hull of those with heights"
            ),
            Remark::WithoutHeights { missing, vertices } => format!(
                "{missing} of {vertices} vertices have no height: z is `NaN` there, or left out, which some programs \
                 read as 0"
            ),
            Remark::OpenTriangles { missing, triangles } => format!(
                "{missing} of {triangles} triangles have a corner without a height, and are left out"
            ),
            Remark::OffTerrain { missing, places } => format!(
                "{missing} of {places} points have no height: they are on no triangle that has three"
            ),
            Remark::CoveredTwice { triangles } => format!(
                "polygons overlap: {triangles} triangles are covered more than once, and have the first feature that does"
            ),
            Remark::Unrefined { triangles, reason } => {
                let of = of(*triangles, "triangle breaks", "triangles break");
                format!("{of} a bound still: {reason}")
            }
            Remark::UnusedAreas { areas, rule } => {
                let of = of(*areas, "area of a region is", "areas of regions are");
                format!("{of} not used: the rule {rule} has no regions")
            }
            Remark::NothingFree { sides } => {
                let of = of(*sides, "side", "sides");
                format!(
                    "of {of} between two triangles each is an edge: nothing was asked of Delaunay"
                )
            }
            Remark::SharedCells { points } => {
                let [one, many] = [
                    "equals another one, and shares its cell",
                    "equal others, and share their cells",
                ];
                of(*points, &format!("point {one}"), &format!("points {many}"))
            }
            Remark::NoTriangles(why) => format!("no triangles: {why}"),
            Remark::NothingInside { edges: 0, .. } => {
                "no triangles are inside: there are no edges".to_owned()
            }
            Remark::NothingInside {
                edges,
                has_holes: true,
            } => format!("no triangles are inside: {edges} edges keep the outside out nowhere"),
            Remark::NothingInside { edges, .. } => format!(
                "no triangles are inside: {edges} edges enclose nothing by the rule that was chosen"
            ),
        }
    }
}

impl fmt::Display for NoTriangles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NoTriangles::NoPoints => "there are no points",
            NoTriangles::OnePlace => "all points are one",
            NoTriangles::OneLine { up: None } => "all points lie on one line",
            NoTriangles::OneLine { up: Some(0) } => {
                "all points lie on one line (x is the same everywhere and z is not: perhaps x is up in this file)"
            }
            NoTriangles::OneLine { up: Some(_) } => {
                "all points lie on one line (y is the same everywhere and z is not: perhaps y is up in this file)"
            }
        })
    }
}

/// How many points each class has, of the first twelve.
pub(crate) fn of_classes(counts: &[(u8, usize)]) -> String {
    const MOST: usize = 12;
    let mut said = String::new();
    for (at, (class, count)) in counts.iter().take(MOST).enumerate() {
        said += &match (at, count) {
            (0, 1) => format!("1 is of class {class}"),
            (0, _) => format!("{count} are of class {class}"),
            _ => format!(", {count} of class {class}"),
        };
    }
    let others = counts.iter().skip(MOST).map(|(_, count)| count);
    match others.sum::<usize>() {
        0 => said,
        count => format!("{said}, {count} of others"),
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words(|vertex| format!("vertex {vertex}")))
    }
}
