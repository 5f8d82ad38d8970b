//! `sweep-cdt verify`: is it a constrained Delaunay triangulation?

use std::io::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use clap::builder::{PossibleValuesParser, TypedValueParser};

use sweep_cdt::scalar::Scalar;
use sweep_cdt::triangulate;
use sweep_cdt::verify::Level;
use sweep_cdt_draw::ViolationsPicture;
use sweep_cdt_engine::{
    Input as Asked, Inside, OUT_OF_BOUNDS, Question, Verdict, headline, nothing_free,
};
use sweep_cdt_formats::{
    Coordinate, Format, GraphFile, Input, Matching, ResultError, WayOut, added_points,
    write_certificate, write_violations,
};

use crate::advice::advice;
use crate::bounded::Bounded;
use crate::completed::completed;
use crate::mesh::Mesh;
use crate::record::{self, Fingerprint, Subject};
use crate::shared::arguments::{ResultArgs, ResultFiles, distance};
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::bounds::BoundsArgs;
use crate::shared::earlier::Earlier;
use crate::shared::failure::{Failure, way_out};
use crate::shared::files::{FileArgument, FilesRead, ReadingArgs, format_parser};
use crate::shared::inside::{default_of, expect_suits};
use crate::shared::layers::LayersArgs;
use crate::shared::outputs::{Destination, Outputs, refuse_read, refuse_twice};
use crate::shared::places::located_interior;
use crate::shared::resources::limit_threads;
use crate::shared::verification::{self, violations};
use crate::stream::{SortArgs, verify_stream};

/// Reads the name of a level.
fn level_parser() -> impl TypedValueParser<Value = Level> {
    let named = |name: String| Level::ALL.into_iter().find(|level| level.name() == name);
    PossibleValuesParser::new(Level::ALL.map(Level::name))
        .map(move |name| named(name).expect("one of the possible values"))
}

/// Verify a triangulation made by any program
///
/// Proves by exact arithmetic that the triangles are a constrained Delaunay triangulation of the input,
/// or says what is wrong and where. In a correct one the triangles tile the convex hull of the points (or
/// the interior, by --domain), every point there is a corner, every edge there is a side (or a chain of
/// sides, where points lie on it), and every other side is locally Delaunay.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
#[command(override_usage = "sweep-cdt verify [OPTIONS] <INPUT>... [RESULT]")]
pub(crate) struct Verify {
    /// INPUT, in any format that `sweep-cdt triangulate` reads; several are layers of one input. Behind it RESULT, its
    /// triangulation: .ele (and the .node beside it), .json, .obj, .off, .ply, .vtk, .vtu, .vtp, .msh, .stl, .geojson, .wkt,
    /// .npy or .npz. One of them may be `-` for standard input. Without RESULT, INPUT is a mesh of which only bounds are asked
    #[arg(value_name = "FILES", required = true)]
    files: Vec<FileArgument>,

    /// Format of the input; of several inputs, of those whose extension tells none [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::INPUTS))]
    input_format: Option<Format>,

    #[command(flatten)]
    result: ResultArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    #[command(flatten)]
    scalar: ScalarArgs,

    /// What the triangles must tile: hull, or what is inside by another rule of `sweep-cdt triangulate --inside`
    /// [default: holes for a file with holes, polygons for one with polygons, otherwise hull]
    ///
    /// The interior is found from a triangulation of the input, which is itself verified first. Points and edges
    /// outside of it need not be used.
    #[arg(long, value_name = "RULE", value_parser = Inside::from_str)]
    domain: Option<Inside>,

    /// What the triangles must reach: tiling, constrained (and every edge is there), delaunay, or canonical
    ///
    /// Each includes those before it. Violations of higher ones are not reported. The report names the
    /// highest one reached.
    #[arg(long, value_name = "LEVEL", value_parser = level_parser(), default_value = "delaunay")]
    level: Level,

    /// By how much a coordinate of the result may differ from the input's [default: by rounding]
    ///
    /// Applies where the vertices of the result are not exactly those of the input: they are then matched
    /// by number, if no coordinate differs by more, or else each with the only vertex of the input that is
    /// not farther. By default each must be the coordinate of the input, rounded to as many significant digits
    /// as the result has for it, 6 or more, or to single precision.
    #[arg(long, value_name = "DIFFERENCE", value_parser = distance, conflicts_with = "by_number")]
    tolerance: Option<f64>,

    /// Match vertices by number, whatever their coordinates
    #[arg(long)]
    by_number: bool,

    /// Allow for vertices that the input lacks (Steiner points)
    ///
    /// New vertices must lie in the hull of the input's points, or in the interior asked for. They may split
    /// edges. Where they lie beside the edge, because they were rounded, this is a violation with a depth: see
    /// --max-depth. All other vertices must be the input's.
    #[arg(long, conflicts_with_all = ["by_number", "tolerance"])]
    steiner: bool,

    /// How deep violations may be that count as rounding [default: none]
    ///
    /// The depth of a side that is not Delaunay is how far the opposite vertex lies in the circle: its power in
    /// units of the square of the radius. That of a concave turn of the hull is the height of its vertex over the
    /// line between the two beside it, in units of their distance. That of an edge, or a side of the boundary, that added
    /// vertices split is the distance of the farthest one from it, in units of its length. Rounding makes depths of about 1e-16. A
    /// result with none beyond this is not correct, but gets a verdict and an exit status of its own.
    #[arg(long, value_name = "DEPTH", value_parser = distance)]
    max_depth: Option<f64>,

    #[command(flatten)]
    bounds: BoundsArgs,

    /// How many violations to list
    #[arg(long, value_name = "N", default_value_t = 20)]
    limit: usize,

    /// Threads to work on [default: as many as there are cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,

    /// Print below each figure of the report what it is
    #[arg(long, conflicts_with = "json")]
    explain: bool,

    /// Print the record instead of the report
    #[arg(long)]
    json: bool,

    /// Draw a picture, with close-ups of the first violations
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// Write the violations that are listed for a map: a .geojson with a feature each, with name, message and depth
    #[arg(long, value_name = "FILE")]
    geojson: Option<PathBuf>,

    /// Write a record: the SHA-256 of the files, the counts and the verdict, as JSON
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,

    /// Write a certificate of a correct result, for the proved checker (the folder proof of the repository)
    ///
    /// The certificate holds input and triangles with hints, from which a program whose verdict is a theorem sees that
    /// they are right. With --domain it has the other triangles of the hull, too, and must be of polygons, even-odd or
    /// nonzero, or of a rule by which the same is inside. With --steiner its points are those of the result. Of a wrong
    /// result none is written.
    #[arg(long, value_name = "FILE")]
    write_certificate: Option<PathBuf>,

    /// Read the triangles once, in memory for what is open alone: RESULT is a .u32 or .u64 of `sweep-cdt stream`
    ///
    /// INPUT is sorted by y first, as `sweep-cdt stream` does; several are one, in the order in which that read them.
    /// Numbers are positions in INPUT, from 0. Triangles may come
    /// in any order; the order of a sweep takes least memory. The first violation ends the run.
    #[arg(
        long,
        conflicts_with_all = ["input_format", "result_format", "faces", "height_property", "strict", "unpacked_limit",
            "scalar", "domain", "tolerance", "by_number", "steiner", "max_depth", "limit", "threads", "explain", "json",
            "svg", "geojson", "record", "write_certificate", "min_angle", "max_area", "max_side"],
    )]
    stream: bool,

    #[command(flatten)]
    sort: SortArgs,
}

const AFTER_HELP: &str = "\
Result:
  .ele     Triangle's triangles, numbered from 0 or 1, and the .node beside it, if there is one
  .json    {\"triangles\": [[i, j, k], ...]}, or all corners in one list; numbered from 0; with
           \"points\": [[x, y], ...] or without. Also simplices or faces, and vertices
  .obj, .off, .ply, .vtk, .vtu, .vtp, .msh
           vertices and faces; z is ignored. All but the first two may be binary
  .npy, .npz
           triangles as an array of NumPy, (t, 3) or (3t,), numbered from 0; or as arrays triangles,
           simplices or faces, with points or vertices, or without
  .stl, .geojson, .wkt
           triangles by the coordinates of their corners, and no others; .stl may be binary
  If the result has coordinates, its vertices are matched with those of the input by them, exactly
  and in any order. If it has none, they are matched by number. Rounded ones are matched by number
  too, or each with the only vertex that is rounded to it, and the report says by how much they
  differ. A result with other vertices is refused; see --tolerance and --by-number.
  The last line of the report says in words what was found, and what to do.

Violations:
  triangle-out-of-range, edge-out-of-range    a vertex that does not exist
  flat-triangle, reversed-triangle            corners that are not counter-clockwise
  repeated-side                               two triangles that lie on the same side of a side
  pinched-boundary, extra-boundary,
  concave-boundary, winding-boundary          triangles that do not cover the convex hull once
  undeclared-boundary, missing-boundary,
  tangled-boundary                            triangles that do not cover the interior once
  unused-point, no-triangles, wrong-count     points that are not corners
  added-outside                               a vertex that --steiner allows, outside of the hull
  missing-edge                                an input edge that is not a chain of sides
  bent-edge, bent-boundary                    vertices that --steiner allows, beside the edge that they split
  wrong-region                                an attribute that is not that of the region, with --domain holes
  not-delaunay                                a side that should be flipped
  small-angle, large-area, long-side          triangles out of --min-angle, --max-area, --max-side
  not-canonical                               ties that end at another vertex, with --level canonical

Exit status:
  0  correct   1  wrong, or a file cannot be read   2  wrong usage
  3  wrong, but no violation is deeper than --max-depth

Examples:
  triangle -pcz terrain.poly && sweep-cdt verify terrain.poly terrain.1.ele
  sweep-cdt verify polygon.json earcut.json --domain even-odd --level constrained
  triangle -pqz part.poly
  sweep-cdt verify part.poly part.1.ele --domain holes --steiner --max-depth 1e-12
  triangle -pz part.poly && sweep-cdt verify part.poly part.1.ele --domain holes
  sweep-cdt verify mesh.msh --min-angle 25 --max-side 0.5
  sweep-cdt verify terrain.poly terrain.obj --svg wrong.svg --record terrain.verified.json
  sweep-cdt verify --stream points.f64 triangles.u32 --level canonical";

impl Verify {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let earlier = Earlier::of(self.write_certificate.as_deref());
        earlier.note_if_failed(self.verified())
    }

    fn verified(&self) -> Result<(), Failure> {
        let Some((result, inputs)) = self
            .files
            .split_last()
            .filter(|(_, inputs)| !inputs.is_empty())
        else {
            let others = [
                &self.svg,
                &self.geojson,
                &self.record,
                &self.write_certificate,
            ];
            let is_asked_more = self.stream || others.iter().any(|file| file.is_some());
            let mesh = Mesh {
                input: &self.files[0],
                result: &self.result,
                scalar: &self.scalar,
                bounds: self.bounds.given().filter(|_| !is_asked_more),
                limit: self.limit,
                is_json: self.json,
            };
            return mesh.verify(self.reading.files(), refusal);
        };
        if self.files.iter().filter(|file| file.is_standard()).count() > 1 {
            let message = "only one of INPUT and RESULT can be standard input";
            return Err(Failure::Usage(message.to_owned()));
        }
        if self.stream {
            return verify_stream(
                &self.sort,
                self.level,
                (inputs, self.reading.choice()),
                result,
            );
        }
        self.sort.refuse_without("--stream")?;
        let of = |path: &Option<PathBuf>| path.clone().map(Destination::of_path).transpose();
        let (svg, geojson) = (of(&self.svg)?, of(&self.geojson)?);
        let (record, certificate) = (of(&self.record)?, of(&self.write_certificate)?);
        if certificate.is_some() && self.level < Level::Delaunay {
            let message =
                "--write-certificate is for constrained Delaunay triangulations: leave out --level";
            return Err(Failure::Usage(message.to_owned()));
        }
        let standard = Destination::standard();
        let outputs = [&svg, &record, &geojson, &certificate];
        let written = || outputs.into_iter().flatten();
        refuse_twice([&standard].into_iter().chain(written()))?;
        if let Some(threads) = self.threads {
            limit_threads(threads);
        }
        let mut read = self.reading.files();
        // Only the record names the files by their sums, which take longer than the verdict.
        let has_record = self.json || self.record.is_some();
        let note = |list: &mut Vec<Fingerprint>, source: &_| {
            list.extend(has_record.then(|| Fingerprint::of(source)));
        };
        let (mut of_input, mut of_result) = (Vec::new(), Vec::new());
        let layers = LayersArgs::new(inputs, self.input_format);
        let name = layers.name();
        let input = layers.read_shown(&mut read, |source| note(&mut of_input, source))?;
        // Then the result may have fractions, too.
        let mut input = self.scalar.convert(&name, input)?;
        let files = self
            .result
            .load(result, &mut read, |source| note(&mut of_result, source))?;
        refuse_read(&read, written())?;
        let own = self.with_added(&mut input, &files)?;
        let run = Run {
            arguments: self,
            names: [name.clone(), result.input_name()],
            read: &read,
            result: files,
            own,
            of_input: &of_input,
            of_result: &of_result,
            svg,
            geojson,
            record,
            certificate,
        };
        self.scalar.apply(&name, &input, run)
    }

    /// Gives the input the vertices that the result has added, if these are allowed. Returns how many are its own.
    fn with_added(&self, input: &mut Input, result: &ResultFiles) -> Result<usize, Failure> {
        match input {
            Input::Doubles(file) => self.with_added_to(file, result),
            Input::Rationals(file) => self.with_added_to(file, result),
        }
    }

    fn with_added_to<S: Coordinate>(
        &self,
        file: &mut GraphFile<S>,
        result: &ResultFiles,
    ) -> Result<usize, Failure> {
        let own = file.graph.points.len();
        if self.steiner {
            let added = added_points(result.format, &result.source, result.node.as_ref(), file);
            let added = added.map_err(|error| refusal(&error))?;
            file.graph.points.extend(added);
        }
        Ok(own)
    }
}

/// A run with files that are read.
struct Run<'a> {
    arguments: &'a Verify,
    /// The names of input and result in messages.
    names: [String; 2],
    read: &'a FilesRead,
    result: ResultFiles,
    /// How many points are the input's own; the others were added.
    own: usize,
    of_input: &'a [Fingerprint],
    of_result: &'a [Fingerprint],
    svg: Option<Destination>,
    geojson: Option<Destination>,
    record: Option<Destination>,
    certificate: Option<Destination>,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let Given { file, scalar, .. } = given;
        let ResultFiles {
            format,
            source,
            node,
        } = self.result;
        let arguments = self.arguments;
        // The result is read in the type of the input, so that equal coordinates match.
        let matching = Matching::new().by_number(arguments.by_number);
        let matching = match arguments.tolerance {
            Some(tolerance) => matching.tolerance(tolerance),
            None => matching,
        };
        let triangles = matching
            .read(format, &source, node.as_ref(), file)
            .map_err(|error| refusal(&error))?;
        let domain = arguments.domain.unwrap_or(default_of(file));
        expect_suits(domain, given.name, file)?;
        let question = Question {
            input: &Asked::from(file),
            points: given.points,
            added_from: arguments.steiner.then_some(self.own),
            numbering: file.numbering,
            triangles: &triangles.list,
            first_triangle: triangles.first,
            strangers: &triangles.strangers,
            attributes: triangles.attributes.as_deref(),
            domain,
            level: arguments.level,
            max_depth: arguments.max_depth,
            limit: arguments.limit,
            triangulate: &triangulate,
            verify: &verification::verify,
        };
        let answer = question.answer();
        let answer = answer.map_err(|error| given.failure(located_interior(file, error)))?;
        let [input, result] = self.names;
        self.read
            .say(&result, nothing_free(&answer, arguments.level).as_slice())?;
        let bounds = arguments.bounds.given().map(|bounds| {
            let points = &file.graph.points;
            Bounded::new(bounds, points, &triangles, arguments.limit)
        });
        let bounds = bounds.transpose()?;
        let violators = bounds.as_ref().map_or(&[][..], |bounds| &bounds.violators);
        let unbounded = question.verdict(&answer);
        let verdict = unbounded.with_bounds(violators);
        let subject = Subject {
            input: self.of_input,
            result: self.of_result,
            scalar,
            domain,
            level: arguments.level.name(),
            steiner: arguments.steiner,
            max_depth: arguments.max_depth,
            verdict,
            file,
            triangles: &triangles,
            bounds: bounds.as_ref(),
        };
        let advice = (!arguments.json).then(|| match unbounded {
            Verdict::Wrong => advice(&given, &question, &answer),
            _ if !violators.is_empty() => OUT_OF_BOUNDS.to_owned(),
            _ => advice(&given, &question, &answer),
        });
        let mut outputs = Outputs::default();
        if let Some(record) = self.record {
            outputs.add(record, |out| record::write(&subject, &answer, out))?;
        }
        if let Some(certificate) = self.certificate.filter(|_| answer.is_ok()) {
            let graph = &file.graph;
            let (list, is_inside) = match domain {
                Inside::HULL => (triangles.list.clone(), vec![true; triangles.list.len()]),
                _ => completed(&given, &triangles.list)?,
            };
            let polygons = matches!(domain, Inside::Polygons).then_some(&file.polygons);
            outputs.add(certificate, move |out| {
                let is_inside = |t: usize| is_inside[t];
                write_certificate(&graph.points, &graph.edges, polygons, &list, is_inside, out)
            })?;
        }
        if let Some(svg) = self.svg {
            outputs.add(svg, |out| {
                let (list, found) = violations(&answer);
                ViolationsPicture::new(file, &triangles, list)
                    .found(found)
                    .write(out)
            })?;
        }
        if let Some(geojson) = self.geojson {
            outputs.add(geojson, |out| {
                let (list, _) = violations(&answer);
                write_violations(file, &triangles, list, out)
            })?;
        }
        outputs.add(Destination::standard(), |out| {
            let Some(advice) = &advice else {
                return record::write(&subject, &answer, out);
            };
            let interior = |rule: Inside| format!("the interior of {input} ({rule})");
            let verified = match domain {
                Inside::HULL => input.clone(),
                rule => interior(rule),
            };
            let files = [&*result, &*verified];
            let headline = headline(&answer, arguments.level, arguments.max_depth, files);
            let bounded = bounds.as_ref().map(|bounds| bounds.headline(&headline));
            writeln!(out, "{}", bounded.unwrap_or(headline))?;
            writeln!(out, "{}", triangles.matched.words())?;
            let report = verification::report(&answer);
            if report.clockwise {
                writeln!(out, "the triangles run clockwise")?;
            }
            writeln!(out)?;
            verification::write_counts(report, arguments.explain, out)?;
            verification::write_depths(&answer, arguments.explain, out)?;
            verification::write_violations(&answer, file, &triangles, out)?;
            if let Some(bounds) = &bounds {
                bounds.write(out)?;
            }
            writeln!(out, "\n{advice}")
        })?;
        outputs.finish()?;
        match verdict {
            Verdict::Correct => Ok(()),
            Verdict::WithinMaxDepth => Err(Failure::Rounded),
            Verdict::Wrong => Err(Failure::Wrong),
        }
    }
}

/// The failure of a result that is not read, with what helps.
fn refusal(error: &ResultError) -> Failure {
    if let ResultError::Unreadable(error) = error {
        return Failure::Error(format!("{error}{}", way_out(error)));
    }
    Failure::Error(error.with_ways_out(|way| match way {
        WayOut::Tolerance(tolerance) => format!("--tolerance {} accepts it", tolerance.text()),
        WayOut::Steiner => "--steiner allows for vertices that were added".to_owned(),
        WayOut::ByNumber => "--by-number ignores coordinates".to_owned(),
        _ => "write the result with all digits, 17, or without coordinates".to_owned(),
    }))
}
