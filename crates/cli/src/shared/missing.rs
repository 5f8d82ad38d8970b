//! Vertices without a height, where the outputs need one: what stands in its place.

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt::{Bands, Pslg, Triangulator};
use sweep_cdt_formats::{Column, Coordinate, GraphFile, Input, Remark};
use sweep_cdt_terrain::Surface;

use super::failure::Failure;
use super::files::FilesRead;

/// Arguments that choose it.
#[derive(clap::Args)]
pub(crate) struct MissingArgs {
    /// Height of vertices that have none, if others have: a number, interpolate, or refuse [default: none]
    ///
    /// interpolate takes the height in the triangulation of the vertices that have heights, with the edges between
    /// them: along an edge, or within a triangle. Outside of their hull there is none. refuse ends the run and names
    /// the first such vertex. By default the height stays missing: it is left out, or NaN, as a format has it.
    #[arg(long, value_name = "VALUE|interpolate|refuse", value_parser = Missing::named, allow_negative_numbers = true)]
    missing: Option<Missing>,
}

/// What stands in place of a missing height.
#[derive(Clone, Copy)]
enum Missing {
    Value(f64),
    Interpolate,
    Refuse,
}

impl Missing {
    fn named(text: &str) -> Result<Missing, String> {
        let value = || text.parse().ok().filter(|value: &f64| value.is_finite());
        match text {
            "interpolate" => Ok(Missing::Interpolate),
            "refuse" => Ok(Missing::Refuse),
            _ => {
                let value = value().map(Missing::Value);
                value.ok_or_else(|| "it is a number, interpolate or refuse".to_owned())
            }
        }
    }
}

impl MissingArgs {
    /// The input called `name` with these heights.
    pub(crate) fn apply(
        &self,
        name: &str,
        input: Input,
        files: &FilesRead,
    ) -> Result<Input, Failure> {
        let Some(missing) = self.missing else {
            return Ok(input);
        };
        Ok(match input {
            Input::Doubles(file) => Input::Doubles(missing.filled(name, file, files)?),
            Input::Rationals(file) => Input::Rationals(missing.filled(name, file, files)?),
        })
    }
}

impl Missing {
    fn filled<S: Coordinate + Exact>(
        self,
        name: &str,
        mut file: GraphFile<S>,
        files: &FilesRead,
    ) -> Result<GraphFile<S>, Failure> {
        let vertices = file.graph.points.len();
        let heights = file.heights().map(|column| {
            let height = |v: usize| column.values.get(v).copied().unwrap_or(f64::NAN);
            (0..vertices).map(height).collect::<Vec<f64>>()
        });
        let Some(mut heights) = heights else {
            return Ok(file);
        };
        let missing: Vec<usize> = (0..vertices).filter(|&v| heights[v].is_nan()).collect();
        let Some(&first) = missing.first() else {
            return Ok(file);
        };
        match self {
            Missing::Refuse => {
                let [x, y] = file.graph.points[first].each_ref().map(S::text);
                let vertex = first + file.numbering.vertex;
                return Err(Failure::Error(format!(
                    "{name}: vertex {vertex} at ({x}, {y}) has no height, and {} others have none \
                     (--missing interpolate makes them)",
                    missing.len() - 1
                )));
            }
            Missing::Value(value) => missing.iter().for_each(|&v| heights[v] = value),
            Missing::Interpolate => {
                let places: Vec<[S; 2]> = missing
                    .iter()
                    .map(|&v| file.graph.points[v].clone())
                    .collect();
                let found = interpolated(name, &file, &heights, &places)?;
                for (&v, height) in missing.iter().zip(&found) {
                    heights[v] = height.unwrap_or(f64::NAN);
                }
                let outside = found.iter().filter(|height| height.is_none()).count();
                let heights = missing.len() - outside;
                files.say(name, &[Remark::Interpolated { heights, outside }])?;
            }
        }
        let column = file
            .columns
            .iter_mut()
            .find(|column| column.name == Column::HEIGHT);
        column.expect("there are heights").values = heights;
        Ok(file)
    }
}

/// The heights of places in the triangulation of the vertices that have heights.
fn interpolated<S: Coordinate + Exact>(
    name: &str,
    file: &GraphFile<S>,
    heights: &[f64],
    places: &[[S; 2]],
) -> Result<Vec<Option<f64>>, Failure> {
    let graph = &file.graph;
    let known: Vec<usize> = (0..graph.points.len())
        .filter(|&v| !heights[v].is_nan())
        .collect();
    let place = |v: usize| known.binary_search(&v).ok();
    let edge = |&[a, b]: &[usize; 2]| Some([place(a)?, place(b)?]);
    let part = Pslg {
        points: known.iter().map(|&v| graph.points[v].clone()).collect(),
        edges: graph.edges.iter().filter_map(edge).collect(),
        ..Pslg::default()
    };
    let result = Triangulator::new().triangulate_parallel(&part.points, &part.edges, Bands::new());
    let result = result.map_err(|error| {
        let error = error.renumbered(|v| known[v] + file.numbering.vertex, |edge| edge);
        Failure::Error(format!("{name}: heights cannot be interpolated: {error}"))
    })?;
    let whole = Interior::whole(&result);
    let known: Vec<f64> = known.iter().map(|&v| heights[v]).collect();
    Ok(Surface::new(&part.points, &whole, &known).heights_at(places))
}
