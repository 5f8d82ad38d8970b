//! What a stream writes: triangles, vertices, contour lines and a grid, all of them or none.

use std::io::{self, Write};
use std::sync::Mutex;
use std::thread;
use std::time::Instant;

use sweep_cdt_stream::external::{Format as LineFormat, SweepOrder};
use sweep_cdt_stream::{StreamError, StreamStats};

use super::beside::Beside;
use super::node::Node;
use super::order::Sorted;
use super::output::{self, Format, Triangles};
use super::terrain::{Passing, Terrain, TerrainTargets};
use super::{Outcome, StreamCommand, Trouble};
use crate::shared::failure::Failure;
use crate::shared::files::FilesRead;
use crate::shared::outputs::{Destination, Out, Outputs};

/// Where triangles go, vertices in the order of the sweep, and contour lines, each if it is asked for.
#[derive(Default)]
pub(super) struct Written<'a, 'w> {
    triangles: Option<(&'a mut Out<'w>, Format)>,
    /// The number of the first point in triangles.
    first: u64,
    vertices: Option<&'a mut dyn Write>,
    lines: Option<(&'a mut dyn Write, LineFormat)>,
}

/// Where they go, before anything is written.
pub(super) struct Targets {
    pub(super) triangles: Option<(Destination, Format)>,
    pub(super) vertices: Option<Destination>,
    /// The `.node` beside the triangles.
    pub(super) node: Option<Node>,
    pub(super) terrain: TerrainTargets,
}

impl StreamCommand {
    /// Takes all vertices in order, and puts what is written in its place, if it may be of use.
    pub(super) fn written(
        &self,
        sorted: Sorted,
        targets: Targets,
        read: &FilesRead,
    ) -> Result<Outcome, Failure> {
        let name = self.name();
        let summary = sorted.order.summary();
        let first_point = sorted.first_point;
        let first = match targets.vertices {
            None => first_point,
            Some(_) => 0,
        };
        let mut terrain = self.terrain.begin(&name, &sorted, &self.sort)?;
        let (triangles, format) = targets.triangles.unzip();
        let (lines, line_format) = targets.terrain.lines.unzip();
        let [mut outputs, mut of_vertices, mut of_terrain, mut of_node] =
            [(); 4].map(|()| Outputs::default());
        if let Some(node) = targets.node {
            node.write(&sorted, &mut of_node)?;
        }
        let columns = sorted.columns.clone();
        let mut outcome = None;
        let written = with(&mut of_terrain, lines, |lines| {
            with(&mut of_vertices, targets.vertices, |vertices| {
                with(&mut outputs, triangles, |triangles| {
                    let written = Written {
                        triangles: triangles.zip(format),
                        first,
                        vertices: vertices.map(|out| out as &mut dyn Write),
                        lines: lines.map(|out| out as &mut dyn Write).zip(line_format),
                    };
                    let found = outcome.insert(self.streamed(sorted, written, terrain.as_mut()));
                    match found.is_kept() {
                        true => Ok(found.ended.is_ok()),
                        // The report says why.
                        false => Err(Failure::Error("the stream has failed".to_owned())),
                    }
                })
            })
        });
        let Some(mut outcome) = outcome else {
            written?;
            unreachable!("what is written comes of a stream");
        };
        if outcome.is_kept() {
            let is_whole = written?;
            if let Some(format) = format {
                outputs.rewrite_beginning(&format.beginning(
                    summary.points,
                    &columns,
                    outcome.written,
                ))?;
            }
            if let Some(mut terrain) = terrain {
                if let Ok(stats) = &outcome.ended {
                    read.say(&name, &terrain.remarks(first_point, stats.triangles))?;
                }
                outcome.lines = terrain.summary();
                if let Some((raster, format)) = targets.terrain.raster {
                    of_terrain.add_part(raster, |out| {
                        terrain.write_raster(format, &self.sort.folder(), out)?;
                        Ok(is_whole)
                    })?;
                }
            }
            outputs.append(of_node);
            outputs.append(of_vertices);
            outputs.append(of_terrain);
            outputs.finish()?;
        }
        Ok(outcome)
    }

    /// Takes all vertices in order, and writes what is asked for.
    fn streamed<'a>(
        &self,
        mut sorted: Sorted,
        mut out: Written<'a, '_>,
        terrain: Option<&'a mut Terrain>,
    ) -> Outcome {
        let mut since = Instant::now();
        let begun = out
            .triangles
            .as_mut()
            .map_or(Ok(()), |(out, format)| output::begin(out, *format, &sorted));
        let mut written = 0;
        let ended = begun.and_then(|()| {
            since = Instant::now();
            let lines = out.lines.take();
            let passing = terrain.map(|terrain| terrain.passing(lines)).transpose();
            let passing = passing.map_err(Trouble::Terrain)?;
            let order = &mut sorted.order;
            let ended = match out.triangles.take() {
                None => self.swept(order, None, out.vertices, passing.as_ref()),
                Some(triangles) => {
                    self.swept_beside(order, triangles, out, passing.as_ref(), &mut written)
                }
            };
            let finished = passing.map_or(Ok(()), Passing::finish);
            ended.and_then(|stats| finished.map(|()| stats).map_err(Trouble::Terrain))
        });
        Outcome {
            ended: ended.map_err(|trouble| trouble.named(&*sorted.input)),
            sorting: sorted.order.statistics(),
            sweeping: since.elapsed(),
            written,
            lines: None,
        }
    }

    /// Takes all vertices in order; a thread beside writes the triangles, and `written` says how many.
    fn swept_beside(
        &self,
        order: &mut SweepOrder,
        (triangles, format): (&mut Out<'_>, Format),
        out: Written<'_, '_>,
        terrain: Option<&Passing<'_>>,
        written: &mut u64,
    ) -> Result<StreamStats, Trouble> {
        let shared = Mutex::new(triangles);
        thread::scope(|scope| {
            let beside = Beside::new(scope, &shared);
            let mut triangles = Triangles::new(beside, format, out.first, &order.summary());
            let ended = self.swept(order, Some(&mut triangles), out.vertices, terrain);
            let is_whole = ended.is_ok();
            match (ended, triangles.finish(is_whole)) {
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
}

/// Writes an output, if there is one, beside others, which `work` writes: it tells whether all of them are whole.
fn with(
    outputs: &mut Outputs<'_>,
    destination: Option<Destination>,
    work: impl FnOnce(Option<&mut Out<'_>>) -> Result<bool, Failure>,
) -> Result<bool, Failure> {
    let Some(destination) = destination else {
        return work(None);
    };
    let mut done = Ok(false);
    let written = outputs.add_part(destination, |out| {
        done = work(Some(out));
        let failed = |_: &Failure| io::Error::other("what stands beside it is not written");
        done.as_ref().copied().map_err(failed)
    });
    let is_whole = done?;
    written.map(|()| is_whole)
}
