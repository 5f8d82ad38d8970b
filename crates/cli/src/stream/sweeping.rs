//! Vertices in order, swept: in bands on all cores where triangles alone are written, otherwise window by window, with
//! whoever takes vertices or judges triangles on the way.
//!
//! Memory: half of `--memory` is for vertices, as `docs/streaming.md` says.

use std::io::Write;
use std::num::NonZeroUsize;

use sweep_cdt::Triangulator;
use sweep_cdt_stream::external::{Bands, Summary, SweepOrder};
use sweep_cdt_stream::{Final, Stream, StreamStats, StreamVerifier, settle_all};

use super::order::is_one_place;
use super::output::Triangles;
use super::terrain::{Passing, Terrain};
use super::{STEP, StreamCommand, Trouble, to_usize};
use crate::shared::resources::Progress;

/// So many bytes of memory a vertex takes, new or alive, while its window is triangulated (some 170 were measured). A
/// window has at least as many new ones as are alive.
const BYTES: u64 = 200;
/// So many new vertices for each that is alive has a window whose size nobody gives, and so many at least.
const SHARE: usize = 7;
const WINDOW: usize = 1 << 15;
/// In bands an edge that is open at the sweep line takes as much memory as so many vertices: each band names it.
const OPEN: usize = 6;
/// No band has more, unless as many are alive.
const BAND: usize = 1 << 19;

impl StreamCommand {
    /// Takes all vertices in order, and passes on what is final.
    pub(super) fn swept(
        &self,
        order: &mut SweepOrder,
        triangles: Option<&mut Triangles<'_, '_, '_>>,
        mut vertices: Option<&mut dyn Write>,
        terrain: Option<&Passing<'_>>,
    ) -> Result<StreamStats, Trouble> {
        let is_renumbered =
            vertices.is_some() || triangles.as_ref().is_some_and(|out| out.is_certificate());
        let of_edges = OPEN.saturating_mul(to_usize(order.summary().open_edges));
        let is_plain = !is_renumbered && terrain.is_none() && !self.check;
        if is_plain && self.window.is_none() && of_edges <= self.most() / 2 {
            return self.swept_in_bands(order, triangles, of_edges);
        }
        // The stream then numbers distinct vertices as they come.
        let is_counted = is_renumbered || terrain.is_some();
        let Summary { points, x, .. } = order.summary();
        let mut progress = Progress::new("sweeping");
        // What the closure meets cannot end the stream from there.
        let trouble = std::cell::RefCell::new(None);
        let verifier = std::cell::RefCell::new(self.check.then(StreamVerifier::new));
        let triangles = std::cell::RefCell::new(triangles);
        let mut found = |found| {
            let mut trouble = trouble.borrow_mut();
            if trouble.is_some() {
                return;
            }
            if let Some(Err(error)) = terrain.map(|terrain| terrain.found(&found)) {
                *trouble = Some(Trouble::Terrain(error));
            }
            let named = match (found, terrain) {
                (Final::Triangle { corners, .. }, Some(terrain)) if !is_renumbered => {
                    Some(corners.map(|v| terrain.number(v)))
                }
                (Final::Triangle { corners, .. }, _) => Some(corners),
                _ => None,
            };
            let mut triangles = triangles.borrow_mut();
            if let Some(Err(error)) = triangles.as_mut().map(|out| out.found(&found, named)) {
                *trouble = Some(Trouble::Out(error));
            }
            if let Final::Triangle {
                corners,
                constrained,
            } = found
            {
                let mut verifier = verifier.borrow_mut();
                let verifier = verifier.as_mut();
                let judged = verifier.map(|verifier| verifier.triangle(corners, Some(constrained)));
                if let Some(Err(violation)) = judged {
                    *trouble = Some(Trouble::Violation(violation));
                }
            }
        };
        let most = self.most();
        let stream = Stream::<f64, _>::new(Triangulator::new(), &mut found);
        let mut stream = stream.limit(most / 2);
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
            let number = match (terrain, last) {
                (Some(terrain), _) => terrain.vertex(&vertex, known.map(|(_, before)| before)),
                (None, _) if !is_renumbered => vertex.number,
                (None, None) => 0,
                // Equal points are one vertex.
                (None, Some((_, before))) => before + u64::from(known.is_none()),
            };
            if known.is_none()
                && let Some(out) = &mut vertices
            {
                let bytes = point.map(f64::to_le_bytes);
                out.write_all(bytes.as_flattened()).map_err(Trouble::Out)?;
            }
            if known.is_none()
                && let Some(out) = triangles.borrow_mut().as_mut()
            {
                out.vertex(point).map_err(Trouble::Out)?;
            }
            stream.push(number, point).map_err(Trouble::Stream)?;
            if let Some(terrain) = terrain {
                terrain.forget(&stream);
            }
            let alive = stream.stats().most_alive.vertices;
            if self.window.is_none() && alive > most_alive && alive > most / (1 + SHARE) {
                most_alive = alive;
                stream = stream.window(most - alive);
            }
            let first = known.map_or(number, |(_, first)| first);
            if let Some(verifier) = verifier.borrow_mut().as_mut() {
                let judged = match known {
                    None => verifier.vertex(number, point),
                    Some(_) if is_counted => Ok(()),
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
                if let Some(out) = triangles.borrow_mut().as_mut() {
                    out.edge(upper);
                }
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

    /// Takes all vertices in bands, which all cores triangulate, and passes on what is final. Edges that are open at once
    /// take as much memory as so many vertices.
    fn swept_in_bands(
        &self,
        order: &mut SweepOrder,
        mut triangles: Option<&mut Triangles<'_, '_, '_>>,
        of_edges: usize,
    ) -> Result<StreamStats, Trouble> {
        let Summary { points, edges, .. } = order.summary();
        // All bands in memory take as much as four vertices for each vertex of one, and as three for each edge.
        let weight = to_usize(4 + edges.saturating_mul(3).div_ceil(points.max(1)));
        let points = to_usize(points);
        let mut bands = Bands::new(order, 1).map_err(Trouble::Order)?;
        let mut progress = Progress::new("sweeping");
        // The closure that gets what is final cannot end the stream.
        let trouble = std::cell::RefCell::new(None);
        let most = self.most();
        let next = |alive: usize| -> Result<_, Trouble> {
            trouble.take().map_or(Ok(()), Err)?;
            let room = most.saturating_sub(alive + of_edges);
            // Four bands are swept beside what is alive.
            let size = (room / weight).min(BAND.max(SHARE * alive / 4));
            bands.resize(size as u64);
            let band = bands.next_band().map_err(Trouble::Order)?;
            progress.show(to_usize(bands.done()), points);
            Ok(band)
        };
        let stats = settle_all(
            next,
            |band| Ok(band.into()),
            most / 2,
            |found| {
                let corners = match found {
                    Final::Triangle { corners, .. } => Some(corners),
                    _ => None,
                };
                let mut trouble = trouble.borrow_mut();
                if let (None, Some(out)) = (&*trouble, &mut triangles) {
                    *trouble = out.found(&found, corners).err().map(Trouble::Out);
                }
            },
        )?;
        trouble.take().map_or(Ok(stats), Err)
    }

    /// How many vertices there may be in memory, of which half may be alive. The other half of the memory is for what is
    /// merged. Two windows are held whatever the memory.
    fn most(&self) -> usize {
        let most = self.sort.memory().saturating_mul(2) / self.bytes();
        let most = usize::try_from(most).unwrap_or(usize::MAX);
        let window = self.window.map_or(WINDOW, NonZeroUsize::get);
        most.max(window.saturating_mul(2))
    }

    /// How many bytes of memory there must be for each vertex that is alive. With a terrain lines and rows have a quarter of
    /// it, since they grow twofold.
    pub(super) fn bytes(&self) -> u64 {
        match self.terrain.is_asked() {
            false => 4 * BYTES,
            true => 8 * (BYTES + Terrain::BYTES),
        }
    }
}
