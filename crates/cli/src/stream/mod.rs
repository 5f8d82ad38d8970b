//! `sweep-cdt stream`: any number of points and edges in, the triangles out as they become final.

mod bands;
mod beside;
mod join;
mod numbers;
mod order;
mod output;
mod verify;

use std::io::{self, Write};
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::PathBuf;
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use sweep_cdt::Triangulator;
use sweep_cdt::verify::Level;
use sweep_cdt_stream::external::{Choice, Statistics, Summary, SweepOrder};
use sweep_cdt_stream::{Final, Stream, StreamError, StreamStats, StreamVerifier, StreamViolation};

use crate::shared::failure::Failure;
use crate::shared::files::FileArgument;
use crate::shared::outputs::{Destination, Out, Outputs, print, refuse_read, refuse_twice};
use crate::shared::resources::Progress;
use beside::Beside;
pub(crate) use join::Join;
pub(crate) use order::SortArgs;
use order::{Sorted, is_one_place};
use output::{Format, Triangles};
pub(crate) use verify::verify_stream;

/// So many bytes of memory a vertex takes, new or alive, while its window is triangulated (some 170 were measured). A
/// window has at least as many new ones as are alive.
const BYTES: u64 = 200;
/// So many new vertices for each that is alive has a window whose size nobody gives, and so many at least.
const SHARE: usize = 7;
const WINDOW: usize = 1 << 15;
/// The bar moves each time that so many vertices have come.
const STEP: u64 = 1 << 16;

/// Triangulate more points than memory holds
///
/// Sorts points and edges with a stated memory and temporary files, and sweeps them. Each triangle is written as soon as
/// nothing to come can change it, and forgotten. As a set, the triangles are those of `sweep-cdt triangulate`.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct StreamCommand {
    /// Points and edges: .f64 (doubles, x and y of each point), .ply, .node, .poly, .csv, .xyz or .txt
    #[arg(value_name = "INPUT")]
    input: FileArgument,

    #[command(flatten)]
    sort: SortArgs,

    /// File to write the triangles to, counter-clockwise: .u32 or .u64 (raw numbers), .ele or .ply; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Option<FileArgument>,

    /// File to write the distinct vertices to, in the order of the sweep: .f64. The triangles then have their numbers in
    /// this file
    #[arg(long, value_name = "FILE", requires = "output")]
    vertices: Option<PathBuf>,

    /// Triangulate nothing, but cut the sorted vertices into bands of so many, each a file in the folder OUTPUT, for
    /// `sweep-cdt join`
    #[arg(long, value_name = "N", requires = "output")]
    #[arg(conflicts_with_all = ["vertices", "window", "check", "stats"])]
    band: Option<NonZeroU64>,

    /// Triangulate in windows of so many new vertices [default: seven times as many as are alive]
    #[arg(long, value_name = "N")]
    window: Option<NonZeroUsize>,

    /// Verify the triangles on the way, by exact arithmetic that shares no other code with the sweep
    #[arg(long)]
    check: bool,

    /// The columns of a .csv, .xyz or .txt that are x, y and perhaps z, by their names or their places from 1 on
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',')]
    columns: Vec<String>,

    /// Refuse inputs that say more than points and edges: heights, for example
    #[arg(long)]
    strict: bool,

    /// Print counts, times and bytes as a table
    #[arg(long)]
    stats: bool,
}

const AFTER_HELP: &str = "\
Input:
  .f64     raw doubles, little-endian: x and y of each point. Edges in a file of their own (--edges)
  .ply     vertices and edges, binary or text
  .node, .poly
           Triangle's vertices and segments
  .csv, .xyz, .txt
           points, one a row
Output:
  .u32, .u64
           three numbers for each triangle, little-endian, of 32 or 64 bits: the positions of its
           corners among the points of the input, from 0. NumPy reads them by fromfile
  .ele     Triangle's elements, with the numbers that a .node or .poly gives its vertices
  .ply     binary: the points in the order of the input, and the triangles. Their z is 0, or NaN where the
           input has heights, which are left out
  Where more stays alive than --memory holds, the triangles up to there are written to a file whose
  name ends in .incomplete. A run that fails otherwise writes no file.
Memory:
  --memory is for sorting, and then a half for merging and a half for vertices: those that are
  alive and those of a window. A vertex alive takes 800 bytes of it, and two windows are allowed
  whatever it is. The program itself takes up to 48 MiB more. No option bounds the edges of a vertex
  or window, those open at the sweep line, and what --check keeps of sides that wait.

Exit status:
  0  done   1  wrong input, or too much alive   2  wrong usage

Examples:
  sweep-cdt stream points.f64 -o triangles.u32 --stats
  sweep-cdt stream points.f64 --edges breaklines.u64 --memory 1GiB -o triangles.u32 --check
  sweep-cdt stream points.f64 --vertices sorted.f64 -o triangles.u32
  sweep-cdt stream points.f64 --band 1000000 -o bands
  sweep-cdt verify --stream points.f64 triangles.u32";

/// How a stream has ended.
struct Outcome {
    ended: Result<StreamStats, Trouble>,
    sorting: Statistics,
    /// The time from the first vertex to the last triangle.
    sweeping: Duration,
    /// How many triangles are written.
    written: u64,
}

/// Where triangles go, and vertices in the order of the sweep.
struct Written<'a, 'w> {
    triangles: &'a mut Out<'w>,
    format: Format,
    /// The number of the first point.
    first: u64,
    vertices: Option<&'a mut dyn Write>,
}

/// Why a stream ends early.
enum Trouble {
    Order(sweep_cdt_stream::external::Error),
    Stream(StreamError),
    Violation(StreamViolation),
    Out(io::Error),
}

impl Trouble {
    /// The trouble with edges as a file numbers them whose first edge has this number.
    fn numbered_from(self, first_edge: u64) -> Trouble {
        match self {
            Trouble::Stream(StreamError::CrossingEdges { edges }) => {
                let edges = edges.map(|edge| edge + first_edge);
                Trouble::Stream(StreamError::CrossingEdges { edges })
            }
            other => other,
        }
    }
}

impl Outcome {
    /// Whether what was written may be of use: all triangles, or all that are final up to some place.
    fn is_kept(&self) -> bool {
        matches!(
            self.ended,
            Ok(_) | Err(Trouble::Stream(StreamError::TooMuchAlive { .. }))
        )
    }
}

impl StreamCommand {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(size) = self.band {
            return self.cut(size.get());
        }
        let format = self.output.as_ref().map(Format::of_output).transpose()?;
        output::refuse_vertices(self.vertices.as_deref())?;
        let destination = self.output.as_ref().map(Destination::of).transpose()?;
        let vertices = self
            .vertices
            .clone()
            .map(Destination::of_path)
            .transpose()?;
        if let Some((format, destination)) = format.zip(destination.as_ref()) {
            format.suits(destination, vertices.is_some())?;
        }
        let writes_standard = destination.as_ref().is_some_and(Destination::is_standard);
        if self.stats && writes_standard {
            let message = "--stats and `-o -` would both write to standard output";
            return Err(Failure::Usage(message.to_owned()));
        }
        let part = destination.as_ref().map(Destination::part).transpose()?;
        let part = part.flatten();
        let read = self.sort.files(&self.input, self.strict);
        refuse_read(&read, destination.iter().chain(&part).chain(&vertices))?;
        refuse_twice(destination.iter().chain(&part).chain(&vertices))?;
        let name = self.input.input_name();
        let sorted = self.sort.sorted(&self.input, self.choice(), |remarks| {
            read.say(&name, remarks)
        })?;
        let summary = sorted.order.summary();
        if let Some(format) = format {
            format.holds(summary.points)?;
        }
        let Some((destination, format)) = destination.zip(format) else {
            let outcome = self.streamed(sorted, None);
            return self.report(outcome, &summary, "");
        };
        let kept = match &part {
            Some(part) => format!("; what is final up to there is in {}", part.name.display()),
            None => "; what is final up to there is written".to_owned(),
        };
        let outcome = self.written(sorted, (destination, format), vertices)?;
        match writes_standard && outcome.ended.is_ok() {
            true => Ok(()),
            false => self.report(outcome, &summary, &kept),
        }
    }

    /// What is read of the input.
    fn choice(&self) -> Choice {
        Choice {
            columns: self.columns.clone(),
            ..Choice::default()
        }
    }

    /// Takes all vertices in order, and puts what is written in its place, if it may be of use.
    fn written(
        &self,
        sorted: Sorted,
        (destination, format): (Destination, Format),
        vertices: Option<Destination>,
    ) -> Result<Outcome, Failure> {
        let points = sorted.order.summary().points;
        let first = match vertices {
            None => sorted.first_point,
            Some(_) => 0,
        };
        let [mut outputs, mut beside] = [Outputs::default(), Outputs::default()];
        let mut outcome = None;
        let whole = |out: &mut Out<'_>, vertices: Option<&mut dyn Write>| {
            let written = Written {
                triangles: out,
                format,
                first,
                vertices: vertices.map(|vertices| vertices as &mut dyn Write),
            };
            let found = outcome.insert(self.streamed(sorted, Some(written)));
            match found.is_kept() {
                true => Ok(found.ended.is_ok()),
                // The report says why.
                false => Err(io::Error::other("the stream has failed")),
            }
        };
        let mut of_vertices = Ok(());
        let of_triangles = match vertices {
            None => outputs.add_part(destination, |out| whole(out, None)),
            Some(vertices) => outputs.add_part(destination, |out| {
                let mut is_whole = false;
                of_vertices = beside.add_part(vertices, |vertices| {
                    is_whole = whole(out, Some(vertices))?;
                    Ok(is_whole)
                });
                match of_vertices {
                    Ok(()) => Ok(is_whole),
                    Err(_) => Err(io::Error::other("the vertices are not written")),
                }
            }),
        };
        let written = of_vertices.and(of_triangles);
        let Some(outcome) = outcome else {
            written?;
            unreachable!("what is written comes of a stream");
        };
        if outcome.is_kept() {
            written?;
            outputs.rewrite_beginning(&format.beginning(points, outcome.written))?;
            outputs.append(beside);
            outputs.finish()?;
        }
        Ok(outcome)
    }

    /// Takes all vertices in order, and writes the triangles.
    fn streamed(&self, mut sorted: Sorted, mut out: Option<Written<'_, '_>>) -> Outcome {
        let summary = sorted.order.summary();
        let mut since = Instant::now();
        let begun = out.as_mut().map_or(Ok(()), |out| {
            let points = || sorted.points().map_err(Trouble::Order);
            output::begin(out.triangles, out.format, &summary, points)
        });
        let mut written = 0;
        let ended = begun.and_then(|()| {
            since = Instant::now();
            match out {
                None => self.swept(&mut sorted.order, None, None),
                Some(out) => self.swept_beside(&mut sorted.order, out, &mut written),
            }
        });
        Outcome {
            ended: ended.map_err(|trouble| trouble.numbered_from(sorted.first_edge)),
            sorting: sorted.order.statistics(),
            sweeping: since.elapsed(),
            written,
        }
    }

    /// Takes all vertices in order; a thread beside writes the triangles, and `written` says how many.
    fn swept_beside(
        &self,
        order: &mut SweepOrder,
        out: Written<'_, '_>,
        written: &mut u64,
    ) -> Result<StreamStats, Trouble> {
        let shared = Mutex::new(out.triangles);
        thread::scope(|scope| {
            let beside = Beside::new(scope, &shared);
            let mut triangles = Triangles::new(beside, out.format, out.first);
            let ended = self.swept(order, Some(&mut triangles), out.vertices);
            match (ended, triangles.finish()) {
                // Both would be kept, and are not all written.
                (Ok(_) | Err(Trouble::Stream(StreamError::TooMuchAlive { .. })), Err(error)) => {
                    Err(Trouble::Out(error))
                }
                (ended, count) => {
                    *written = count.unwrap_or(0);
                    ended
                }
            }
        })
    }

    fn swept(
        &self,
        order: &mut SweepOrder,
        mut triangles: Option<&mut Triangles<'_, '_, '_>>,
        mut vertices: Option<&mut dyn Write>,
    ) -> Result<StreamStats, Trouble> {
        let is_renumbered = vertices.is_some();
        let Summary { points, x, .. } = order.summary();
        let mut progress = Progress::new("sweeping");
        // What the closure meets cannot end the stream from there.
        let trouble = std::cell::RefCell::new(None);
        let verifier = std::cell::RefCell::new(self.check.then(StreamVerifier::new));
        let mut found = |found| {
            let mut trouble = trouble.borrow_mut();
            if trouble.is_some() {
                return;
            }
            if let Final::Triangle {
                corners,
                constrained,
            } = found
            {
                if let Some(Err(error)) = triangles.as_mut().map(|out| out.write(corners)) {
                    *trouble = Some(Trouble::Out(error));
                }
                let mut verifier = verifier.borrow_mut();
                let verifier = verifier.as_mut();
                let judged = verifier.map(|verifier| verifier.triangle(corners, Some(constrained)));
                if let Some(Err(violation)) = judged {
                    *trouble = Some(Trouble::Violation(violation));
                }
            }
        };
        // The other half of the memory is for what is merged. Two windows are held whatever the memory.
        let most = usize::try_from(self.sort.memory() / 2 / BYTES).unwrap_or(usize::MAX);
        let window = self.window.map_or(WINDOW, NonZeroUsize::get);
        let most = most.max(window.saturating_mul(2));
        let limit = most / 2;
        let stream = Stream::<f64, _>::new(Triangulator::new(), &mut found);
        let mut stream = stream.limit(limit);
        if points > 0 {
            stream = stream.between(x[0], x[1]);
        }
        if let Some(window) = self.window {
            stream = stream.window(window.get());
        }
        let mut done: u64 = 0;
        let mut most_alive = 0;
        let mut last: Option<([f64; 2], u64)> = None;
        while let Some(vertex) = order.next_vertex().map_err(Trouble::Order)? {
            let point = vertex.point;
            let known = last.filter(|&(place, _)| is_one_place(place, point));
            let number = match (is_renumbered, last) {
                (false, _) => vertex.number,
                (true, None) => 0,
                // Equal points are one vertex.
                (true, Some((_, before))) => before + u64::from(known.is_none()),
            };
            if known.is_none()
                && let Some(out) = &mut vertices
            {
                let bytes = point.map(f64::to_le_bytes);
                out.write_all(bytes.as_flattened()).map_err(Trouble::Out)?;
            }
            stream.push(number, point).map_err(Trouble::Stream)?;
            let alive = stream.stats().most_alive.vertices;
            if self.window.is_none() && alive > most_alive && alive > most / (1 + SHARE) {
                most_alive = alive;
                stream = stream.window(most - alive);
            }
            let first = known.map_or(number, |(_, first)| first);
            if let Some(verifier) = verifier.borrow_mut().as_mut() {
                let judged = match known {
                    None => verifier.vertex(number, point),
                    Some(_) if is_renumbered => Ok(()),
                    Some(_) => verifier.duplicate(number, &point, first),
                };
                judged.map_err(Trouble::Violation)?;
                for &(edge, upper) in vertex.upper {
                    verifier
                        .edge(edge, first, upper)
                        .map_err(Trouble::Violation)?;
                }
            }
            last = Some((point, first));
            for &(edge, upper) in vertex.upper {
                stream.edge(edge, upper).map_err(Trouble::Stream)?;
            }
            done += 1;
            if done.is_multiple_of(STEP) {
                progress.show(to_usize(done), to_usize(points));
                if let Some(trouble) = trouble.take() {
                    return Err(trouble);
                }
            }
        }
        let stats = stream.finish().map_err(Trouble::Stream)?;
        if let Some(trouble) = trouble.take() {
            return Err(trouble);
        }
        if let Some(verifier) = verifier.take() {
            verifier.finish().map_err(Trouble::Violation)?;
        }
        Ok(stats)
    }

    /// Prints what has come of it; `kept` says where the triangles are of a stream that keeps too much alive.
    fn report(&self, outcome: Outcome, summary: &Summary, kept: &str) -> Result<(), Failure> {
        let input = self.input.input_name();
        let stats = match outcome.ended {
            Ok(stats) => stats,
            Err(Trouble::Order(error)) => return Err(self.sort.failure(&error)),
            Err(Trouble::Stream(error)) => {
                let advice = match error {
                    StreamError::TooMuchAlive { alive, .. } => {
                        let bytes = (alive.vertices as u64).saturating_mul(4 * BYTES);
                        format!(" (--memory {}MiB allows so many)", bytes.div_ceil(1 << 20))
                    }
                    StreamError::CrossingEdges { .. } => {
                        " (where memory holds them, `sweep-cdt crossings` lists all that do)"
                            .to_owned()
                    }
                    _ => String::new(),
                };
                let kept = match error {
                    StreamError::TooMuchAlive { .. } => kept,
                    _ => "",
                };
                return Err(Failure::Error(format!("{input}: {error}{advice}{kept}")));
            }
            Err(Trouble::Violation(violation)) => {
                return Err(Failure::Error(format!(
                    "{input}: a bug of sweep-cdt: {violation}"
                )));
            }
            // A reader that has closed its end of the pipe has what it needs.
            Err(Trouble::Out(error)) if error.kind() == io::ErrorKind::BrokenPipe => return Ok(()),
            Err(Trouble::Out(error)) => {
                let name = self.output.as_ref().and_then(FileArgument::path);
                let name = name.unwrap_or("standard output".as_ref());
                return Err(Failure::of_file(name, &error));
            }
        };
        let is_asked = self.stats || self.output.is_none();
        print(|out| {
            if is_asked {
                write_table(&stats, &outcome.sorting, outcome.sweeping, summary, out)?;
            }
            if self.check {
                let what = Level::Canonical.title();
                writeln!(out, "correct: the result is {what} of {input}")?;
            }
            Ok(())
        })
    }
}

/// Writes counts, times and bytes.
fn write_table(
    stats: &StreamStats,
    sorting: &Statistics,
    sweeping: Duration,
    summary: &Summary,
    out: &mut impl Write,
) -> io::Result<()> {
    let alive = stats.most_alive;
    let seconds = |time: Duration| format!("{:.2} s", time.as_secs_f64());
    let rows = [
        ("points", summary.points.to_string()),
        ("edges", summary.edges.to_string()),
        ("triangles", stats.triangles.to_string()),
        ("sides of the hull", stats.hull_sides.to_string()),
        ("equal points", stats.duplicates.to_string()),
        ("windows", stats.windows.to_string()),
        ("vertices alive at most", alive.vertices.to_string()),
        (
            "  triangles waiting for the line",
            alive.circles.to_string(),
        ),
        ("  triangles waiting for edges", alive.edges.to_string()),
        ("  sides of the hull waiting", alive.hull_sides.to_string()),
        ("runs sorted", sorting.runs.to_string()),
        ("bytes of temporary files", sorting.written.to_string()),
        (
            "time of sorting",
            seconds(sorting.reading + sorting.joining),
        ),
        (
            "time of merging, beside the sweep",
            seconds(sorting.merging),
        ),
        ("time of sweeping", seconds(sweeping)),
    ];
    for (name, value) in rows {
        writeln!(out, "{name:<34} {value:>14}")?;
    }
    Ok(())
}

fn to_usize(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}
