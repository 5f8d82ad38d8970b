//! A file as it was read, with other heights: features keep their properties, and rows all their fields.

use crate::properties::Properties;
use crate::read::edited::Edited;
use crate::read::matching::find;
use crate::read::shapes::geojson;
use crate::read::text;
use crate::{Coordinate, CoordinateError, Format, GraphFile, ReadError, Source};

/// The text of the file that was read as `file`, with the heights of that in place of its own: all else stays, byte for
/// byte. A `.geojson` has them as third coordinates, a table in its column of heights, or else in a new last one. Where
/// there is no height, none is written. `None` for another format.
///
/// ```
/// use sweep_cdt_formats::{Column, Format, Input, Source, raised, read};
///
/// let source = Source::new("trees.csv", "name,x,y\noak,1,2\n");
/// let Input::Doubles(mut file) = read(Format::Csv, &source, None)? else {
///     unreachable!("no fraction in the file")
/// };
/// file.columns = vec![Column::heights(vec![7.5])];
/// assert_eq!(raised(Format::Csv, &source, &file)?.unwrap(), b"name,x,y,z\noak,1,2,7.5\n");
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
///
/// # Errors
/// Those of [`read()`](crate::read()), by which it was read before.
pub fn raised<S: Coordinate>(
    format: Format,
    source: &Source,
    file: &GraphFile<S>,
) -> Result<Option<Vec<u8>>, ReadError> {
    let heights = file.heights().map_or(&[][..], |column| &column.values);
    Ok(Some(match format {
        Format::Csv | Format::Xyz | Format::Txt => text::raised(source, heights)?,
        Format::Geojson => {
            let vertices = geojson::read(source)?.into_graph().vertices;
            let points = match vertices.points::<f64>() {
                Ok(doubles) => {
                    let exact = |[x, y]: [f64; 2]| Ok([S::from_double(x)?, S::from_double(y)?]);
                    let exact: Result<Vec<[S; 2]>, CoordinateError> =
                        doubles.into_iter().map(exact).collect();
                    exact.map_err(|error| ReadError::of_file(&source.name, error.to_string()))?
                }
                Err(_) => vertices.points::<S>().map_err(|(_, error)| error)?,
            };
            let found = find(&points, &file.graph.points);
            let mut edited = Edited::new(source);
            for ([_, y], vertex) in vertices.coordinates.iter().zip(found) {
                let height = vertex.and_then(|vertex| heights.get(vertex));
                let height = height.filter(|height| !height.is_nan());
                let third = height.map_or(String::new(), |height| format!(",{}", height.text()));
                edited.replace_up_to(y, b']', third.as_bytes());
            }
            edited.into_text()
        }
        _ => return Ok(None),
    }))
}

/// The properties of the points of a table, each a feature: the fields of its row but x, y and the height. Numbers stay as they
/// stand, all else is a text, and `null` stands for what is missing.
///
/// ```
/// use sweep_cdt_formats::{Source, properties_of_rows};
///
/// let source = Source::new("trees.csv", "name,x,y,age\noak,1,2,90\nash,3,4,\n");
/// let properties = properties_of_rows(&source)?;
/// assert_eq!(properties.of(1), r#""name":"oak","age":90"#);
/// assert_eq!(properties.of(2), r#""name":"ash","age":null"#);
/// # Ok::<(), sweep_cdt_formats::ReadError>(())
/// ```
///
/// # Errors
/// The errors of [`read()`](crate::read()), by which it was read before.
pub fn properties_of_rows(source: &Source) -> Result<Properties, ReadError> {
    text::properties(source)
}
