//! Bands that follow each other from below, on all cores.
//!
//! ```text
//!      cut          settle           join            Four bands are settled at once, each by itself. Beside them the
//!                                                    caller's thread joins the four rests below to what is left of
//!     8 to 11  ->   4  5    ->   0 to 3    ->  out   all before, passes on what is final, and cuts the next four.
//!                   6  7
//! ```
//!
//! **Why nothing depends on the cores:** four bands are settled at once however many there are, and what is passed on is
//! passed on in the order of the bands. So the triangles come in one order, with the sizes that the caller cuts.
//!
//! **Cost:** what is alive is swept again with the rests of four bands. Memory: for each vertex of a band
//! some 750 bytes, all bands taken together, with an edge for each some 1,400; and what is alive.

use std::mem;

use super::error::StreamError;
use super::rest::Rest;
use super::retire::Final;
use super::stats::{Alive, StreamStats};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::threads::{beside, on_all_cores};
use sweep_cdt::{Session, Triangulator};

/// So many bands are settled at once.
const AT_ONCE: usize = 4;

/// Triangulates all bands of an input, and passes on what is final: as a set what a [`Stream`](crate::Stream) passes on.
///
/// - `next` returns the next band, from below, in any form, until there are no more. The closure gets the number of
///   vertices that are alive some bands below, to which the size of a band may be fitted; four bands are settled at once.
/// - `band` makes a [`Rest`] of it, by [`Cut::band`](crate::Cut::band), on any core. Equal vertices are counted, and not
///   told.
/// - `limit`: so many vertices may be alive.
///
/// With the feature `external` (a default) all cores work.
///
/// ```
/// use sweep_cdt_stream::{Cut, Final, StreamError, settle_all};
///
/// let points = [[0, 0], [4, 0], [2, 1], [0, 3], [4, 4]];
/// let cut = Cut { vertices: 5, between: [0, 4] };
/// let mut cut_off = points.chunks(2).enumerate();
/// let mut triangles = Vec::new();
/// let stats = settle_all(
///     |_| Ok::<_, StreamError>(cut_off.next()),
///     |(at, points)| {
///         let first = 2 * at as u64;
///         cut.band(first, (first..).zip(points.iter().copied()), [], |_| ())
///     },
///     usize::MAX,
///     |found| {
///         if let Final::Triangle { corners, .. } = found {
///             triangles.push(corners);
///         }
///     },
/// )?;
/// assert_eq!((stats.vertices, stats.triangles, triangles.len()), (5, 4, 4));
/// # Ok::<(), StreamError>(())
/// ```
///
/// # Errors
/// What `next` returns; [`StreamError`]: what [`Cut::band`](crate::Cut::band) returns, the bands do not follow each other,
/// do not begin at the first vertex or do not end at the last, edges cross, and more than `limit` vertices are alive. What
/// has been passed on before is right.
pub fn settle_all<S: Scalar + Clone + Send, B: Send, E: From<StreamError>>(
    mut next: impl FnMut(usize) -> Result<Option<B>, E>,
    band: impl Fn(B) -> Result<Rest<S>, StreamError> + Sync,
    limit: usize,
    out: impl FnMut(Final),
) -> Result<StreamStats, E> {
    let session = || Triangulator::new().session();
    let mut sessions: Vec<Session> = Vec::new();
    let mut joined = Joined {
        session: session(),
        below: None,
        limit,
        stats: StreamStats::default(),
        out,
    };
    let mut settled = Vec::new();
    let mut cut = joined.cut(&mut next);
    loop {
        let bands = match cut {
            Ok(bands) => bands,
            Err(error) => {
                // Bands that lie below have the first word.
                joined.join(settled)?;
                return Err(error);
            }
        };
        if bands.is_empty() && settled.is_empty() {
            return joined.finish().map_err(E::from);
        }
        sessions.resize_with(AT_ONCE, session);
        let mut below = Some(mem::take(&mut settled));
        let mut parts = Some(bands.into_iter().zip(sessions).collect());
        let (mut ended, mut done) = (Ok(()), Vec::new());
        cut = Ok(Vec::new());
        beside(
            &mut || {
                ended = joined.join(below.take().unwrap_or_default());
                if ended.is_ok() {
                    cut = joined.cut(&mut next);
                }
            },
            &mut || {
                let parts = parts.take().unwrap_or_default();
                done = on_all_cores(parts, |(cut, session)| settle(&band, cut, session));
            },
        );
        ended?;
        (settled, sessions) = done.into_iter().unzip();
    }
}

/// What of a band is final, and its rest, with the counts of the band and what is alive.
type Settled<S> = (Vec<Final>, Result<(Rest<S>, [u64; 3], Alive), StreamError>);

fn settle<S: Scalar + Clone, B>(
    band: &impl Fn(B) -> Result<Rest<S>, StreamError>,
    cut: B,
    mut session: Session,
) -> (Settled<S>, Session) {
    let mut found = Vec::new();
    let rest = band(cut).and_then(|band| {
        let counts = band.counts();
        let (rest, alive) = band.settle_counted(&mut session, &mut |each| found.push(each))?;
        Ok((rest, counts, alive))
    });
    ((found, rest), session)
}

/// All bands that have been joined.
struct Joined<S, O> {
    session: Session,
    below: Option<Rest<S>>,
    /// So many vertices may be alive.
    limit: usize,
    stats: StreamStats,
    out: O,
}

impl<S: Scalar + Clone, O: FnMut(Final)> Joined<S, O> {
    /// The bands that are settled next.
    fn cut<B, E>(
        &mut self,
        next: &mut impl FnMut(usize) -> Result<Option<B>, E>,
    ) -> Result<Vec<B>, E> {
        let mut bands = Vec::new();
        while bands.len() < AT_ONCE
            && let Some(band) = next(self.stats.alive.vertices)?
        {
            bands.push(band);
        }
        Ok(bands)
    }

    /// Joins rests that follow, and passes on what is final with them.
    fn join(&mut self, settled: Vec<Settled<S>>) -> Result<(), StreamError> {
        if settled.is_empty() {
            return Ok(());
        }
        let (stats, out) = (&mut self.stats, &mut self.out);
        let mut pass_on = |found: Final| {
            found.count(stats);
            out(found);
        };
        let mut windows = settled.len() as u64;
        let is_one = self.below.is_none() && windows == 1;
        let (mut counts, mut alive) = ([0; 3], Alive::default());
        for (found, rest) in settled {
            let (rest, of_band, alive_there) = rest?;
            alive = alive_there;
            for (all, count) in counts.iter_mut().zip(of_band) {
                *all += count;
            }
            found.into_iter().for_each(&mut pass_on);
            self.below = Some(match self.below.take() {
                None => rest,
                Some(below) => below.followed_by(rest)?,
            });
        }
        if !is_one && let Some(below) = self.below.take() {
            let (below, alive_now) = below.settle_counted(&mut self.session, &mut pass_on)?;
            (alive, self.below) = (alive_now, Some(below));
            windows += 1;
        }
        let [vertices, duplicates, edges] = counts;
        stats.vertices += vertices;
        stats.duplicates += duplicates;
        stats.edges += edges;
        stats.after(windows, alive);
        StreamError::refuse(alive, self.limit)
    }

    fn finish(self) -> Result<StreamStats, StreamError> {
        match self.below {
            Some(below) if !below.is_complete() => {
                let covered = below.covered();
                let [end, next] = match covered.start {
                    0 => [covered.end, below.total()],
                    start => [0, start],
                };
                Err(StreamError::NotNext { end, next })
            }
            _ => Ok(self.stats),
        }
    }
}
