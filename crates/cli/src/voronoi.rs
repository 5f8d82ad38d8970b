//! `sweep-cdt voronoi`: points in, the cells of all places that are nearest to each out.

use std::ffi::OsString;
use std::io;

use num_rational::BigRational;
use sweep_cdt::{Bands, Triangulation, Triangulator};
use sweep_cdt_draw::CellsPicture;
use sweep_cdt_edit::{Voronoi as Diagram, VoronoiError};
use sweep_cdt_engine::{Clip, Input as Asked, cells, remarks};
use sweep_cdt_formats::{
    Cell, Coordinate, Format, GraphFile, Input, Ridges, write_cells, write_ridges,
};

use crate::shared::arguments::InputArgs;
use crate::shared::arithmetic::as_rationals;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, ReadingArgs, format_of_output, format_parser};
use crate::shared::inside::default_of;
use crate::shared::layers::LayersArgs;
use crate::shared::outputs::{Destination, Out, Outputs, refuse_read, refuse_twice};
use crate::shared::places::{located, located_interior};

/// The formats that are written.
const FORMATS: &[Format] = &[Format::Geojson, Format::Json, Format::Svg, Format::Png];

/// Find the Voronoi cells of points
///
/// The cell of a point is where no other point is nearer. Cells are cut to a box around the points, or to what --clip
/// says. Which cells share a ridge, and where cells are cut, is decided exactly; of doubles each corner is rounded once.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Voronoi {
    #[command(flatten)]
    layers: LayersArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    /// Take the points alone, where the input has edges
    #[arg(long)]
    without_edges: bool,

    /// What the cells are cut to: hull, a box X,Y,X,Y, or a file with polygons [default: the box around the points, a tenth of
    /// its longer side larger on all sides]
    ///
    /// Of a file it is what is inside by default in `sweep-cdt triangulate`: polygons without their holes, what edges
    /// enclose where seeds of holes are, and otherwise the hull. A file called hull is ./hull.
    #[arg(long, value_name = "hull|X,Y,X,Y|FILE", allow_hyphen_values = true)]
    clip: Option<ClipArgument>,

    /// File to write: .geojson, .json, .svg or .png; may be given several times; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT", required = true)]
    output: Vec<FileArgument>,

    /// Format of standard output, and of outputs whose extension tells none
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(FORMATS))]
    output_format: Option<Format>,
}

const AFTER_HELP: &str = "\
Output:
  .geojson  a polygon for each point, with the property point, its number in the file
  .json     the diagram as it is, not cut: vertices, and ridges with their points, ends and
            directions; null for an end where a ridge goes on for ever; and the vertices around the
            cell of each point. Numbers are positions, from 0
  .svg, .png
            a picture: ridges grey, border orange, points as dots
  Equal points share a cell, which has the number of the first.

The points may have edges only where each is a side of the triangulation of the points alone.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt voronoi wells.csv -o wells.geojson -o wells.svg
  sweep-cdt voronoi wells.csv --clip county.geojson -o wells.geojson
  sweep-cdt voronoi wells.csv --clip 0,0,100,50 -o - --output-format geojson";

/// What cells are cut to, as it is asked for.
#[derive(Clone)]
enum ClipArgument {
    Hull,
    /// Least x and y, and greatest x and y.
    Box(Vec<String>),
    File(FileArgument),
}

impl From<OsString> for ClipArgument {
    fn from(text: OsString) -> ClipArgument {
        let numbers: Vec<String> = text
            .to_string_lossy()
            .split(',')
            .map(str::to_owned)
            .collect();
        let is_number = |text: &String| BigRational::from_text(text).is_ok();
        if text == "hull" {
            ClipArgument::Hull
        } else if numbers.len() == 4 && numbers.iter().all(is_number) {
            ClipArgument::Box(numbers)
        } else {
            ClipArgument::File(text.into())
        }
    }
}

impl Voronoi {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = |file: &FileArgument| -> Result<_, Failure> {
            let format = format_of_output(file, self.output_format, FORMATS)?;
            Ok((format, Destination::of(file)?))
        };
        let targets: Result<Vec<_>, Failure> = self.output.iter().map(target).collect();
        let targets = targets?;
        let destinations = || targets.iter().map(|(_, destination)| destination);
        refuse_twice(destinations())?;
        let mut read = self.reading.files();
        let points = self.layers.read(&mut read)?;
        let clip = match &self.clip {
            Some(ClipArgument::File(file)) => {
                let clip = InputArgs::new(file.clone(), None);
                Some((clip.name(), clip.read(&mut read, |_| ())?))
            }
            _ => None,
        };
        refuse_read(&read, destinations())?;
        let name = self.layers.name();
        match (points, clip) {
            (Input::Doubles(points), None) => self.write(points, None, targets, &read),
            (Input::Rationals(points), None) => self.write(points, None, targets, &read),
            (Input::Doubles(points), Some((clip_name, Input::Doubles(clip)))) => {
                self.write(points, Some(&(clip_name, clip)), targets, &read)
            }
            (points, Some((clip_name, clip))) => {
                let points = as_rationals(&name, points)?;
                let clip = as_rationals(&clip_name, clip)?;
                self.write(points, Some(&(clip_name, clip)), targets, &read)
            }
        }
    }

    fn write<S: Coordinate>(
        &self,
        mut file: GraphFile<S>,
        clip: Option<&(String, GraphFile<S>)>,
        targets: Vec<(Format, Destination)>,
        read: &FilesRead,
    ) -> Result<(), Failure> {
        let name = self.layers.name();
        if self.without_edges {
            file.graph.edges.clear();
        }
        let result = triangulated(&name, &file)?;
        let diagram = Diagram::new(&result, &file.graph.points).map_err(|error| {
            let error = match error {
                VoronoiError::NotDelaunay { side } => VoronoiError::NotDelaunay {
                    side: side.map(|v| v + file.numbering.vertex),
                },
                error => error,
            };
            let hint = match error {
                VoronoiError::NotDelaunay { .. } => " (--without-edges takes the points alone)",
                _ => "",
            };
            Failure::Error(format!("{name}: {error}{hint}"))
        })?;
        let of_clip = clip
            .map(|(name, clip)| triangulated(name, clip))
            .transpose()?;
        let domain = clip.zip(of_clip.as_ref()).map(|((name, clip), result)| {
            let inside = default_of(clip).interior(&Asked::from(clip), result);
            let inside = inside.map_err(|error| {
                Failure::Error(format!("{name}: {}", located_interior(clip, error)))
            })?;
            Ok::<_, Failure>((inside, &clip.graph.points[..]))
        });
        let domain = domain.transpose()?;
        let around = Clip::around(&file.graph.points);
        let clip = match (&self.clip, &domain) {
            (_, Some((inside, points))) => Some(Clip::Inside(inside, points)),
            (Some(ClipArgument::Hull), _) => {
                let hull = result.hull().map(|v| file.graph.points[v].clone());
                Some(Clip::Convex(hull.collect()))
            }
            (Some(ClipArgument::Box(numbers)), _) => Some(a_box(numbers)?),
            _ => around,
        };
        let found = clip.map(|clip| cells(&diagram, &result, &clip)).transpose();
        let found = found.map_err(|error| Failure::Error(format!("{name}: {error}")))?;
        let (cells, shared) = found.unwrap_or_default();
        let mut outputs = Outputs::default();
        for (format, destination) in targets {
            let (file, diagram, cells) = (&file, &diagram, &cells);
            outputs.add(destination, move |out| {
                write(format, file, diagram, cells, out)
            })?;
        }
        outputs.finish()?;
        read.say(&name, shared.as_slice())?;
        if cells.iter().all(|cell| cell.polygons.is_empty()) {
            read.say(&name, &remarks(&file, &result, None))?;
        }
        Ok(())
    }
}

/// The triangulation of the file of this name.
fn triangulated<S: Coordinate>(name: &str, file: &GraphFile<S>) -> Result<Triangulation, Failure> {
    let graph = &file.graph;
    let result =
        Triangulator::new().triangulate_parallel(&graph.points, &graph.edges, Bands::new());
    result.map_err(|error| Failure::Error(format!("{name}: {}", located(file, error))))
}

/// The box of these limits.
fn a_box<S: Coordinate>(numbers: &[String]) -> Result<Clip<'_, S>, Failure> {
    let refused = || {
        Failure::Usage(format!(
            "--clip {}: it is no box X,Y,X,Y with the least x and y first",
            numbers.join(",")
        ))
    };
    let numbers: Result<Vec<S>, _> = numbers.iter().map(|text| S::from_text(text)).collect();
    let numbers: Result<[S; 4], _> = numbers.map_err(|_| refused())?.try_into();
    let [left, low, right, high] = numbers.map_err(|_| refused())?;
    if left.compare(&right).is_lt() && low.compare(&high).is_lt() {
        Ok(Clip::Box([[left, low], [right, high]]))
    } else {
        Err(refused())
    }
}

/// Writes cells, or the diagram that they are of.
fn write<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    diagram: &Diagram<'_, S>,
    cells: &[Cell<S>],
    out: &mut Out<'_>,
) -> io::Result<()> {
    let picture = || CellsPicture::new(&file.graph.points, cells).numbering(file.numbering);
    match format {
        Format::Svg => picture().write(out),
        Format::Png => picture().write_png(out),
        Format::Json => {
            let ridges = diagram.ridges.iter();
            let ridges = Ridges {
                vertices: &diagram.vertices,
                points: ridges.clone().map(|ridge| ridge.points).collect(),
                ends: ridges.clone().map(|ridge| ridge.ends).collect(),
                directions: ridges.map(|ridge| diagram.direction(ridge)).collect(),
                cells: &diagram.cells,
            };
            write_ridges(file, &ridges, out)
        }
        _ => write_cells(file, cells, out),
    }
}
