//! Algorithm and settings: they change the time and never the result.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use sweep_cdt::memory::of_bands;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Bands, Error, Heuristics, Stats, Triangulation, Watch};
use sweep_cdt_engine::{ALGORITHMS, Choice, FRONTS, FrontKind, HEURISTICS, chosen};

use super::resources::{Progress, has_room};

/// Arguments that select how the sweep runs.
#[derive(clap::Args)]
#[command(next_help_heading = "Settings (they change the time, never the result)")]
pub(crate) struct Settings {
    /// Algorithm
    #[arg(long, value_parser = parser(&ALGORITHMS), default_value = ALGORITHMS[0].name)]
    algorithm: Algorithm,

    /// Search structure of the advancing front
    #[arg(long, value_parser = parser(&FRONTS), default_value = FRONTS[0].name)]
    front: FrontKind,

    /// Angles up to which the heuristics add triangles
    #[arg(long, value_parser = parser(&HEURISTICS), default_value = HEURISTICS[0].name)]
    heuristics: Heuristics,

    /// Switch off the pi/2 heuristic (algorithm auto: until flips are many)
    #[arg(long)]
    no_narrow_corners: bool,

    /// Switch off the basin heuristic (algorithm auto: until flips are many)
    #[arg(long)]
    no_basins: bool,
}

/// Reads the name of a choice.
fn parser<T: Copy + Send + Sync + 'static>(
    choices: &'static [Choice<T>],
) -> impl TypedValueParser<Value = T> {
    let values = choices
        .iter()
        .map(|choice| PossibleValue::new(choice.name).help(choice.about));
    PossibleValuesParser::new(values).try_map(|name| chosen("setting", choices, &name))
}

impl Settings {
    /// Triangulates on all threads; or on one, where a progress bar shows if that takes long, and with counts
    /// and times if asked to.
    pub(crate) fn triangulate<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        stats: bool,
    ) -> Result<(Triangulation, Option<Stats>), Error> {
        // Other fronts are for comparison, on one thread.
        let is_parallel = self.front == FrontKind::Hash && !stats;
        let settings = self.with(self.algorithm);
        if is_parallel && has_room(of_bands(points.len(), edges.len()) as u64) {
            let triangulator = settings.triangulator();
            let result = triangulator.triangulate_parallel(points, edges, Bands::new())?;
            return Ok((result, None));
        }
        let mut progress = Progress::new("sweeping");
        let mut show = |swept, points| progress.show(swept, points);
        let mut found = Stats::default();
        let mut watch = Watch::new().progress(&mut show);
        if stats {
            watch = watch.stats(&mut found);
        }
        let result = settings.run(points, edges, watch)?;
        Ok((result, stats.then_some(found)))
    }

    /// Triangulates by the sweep in the paper's order, and reports every step to `observer`.
    pub(crate) fn observe<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        mut observer: impl FnMut(Event),
    ) -> Result<Triangulation, Error> {
        let watch = Watch::new().events(&mut observer);
        self.with(Algorithm::Paper).run(points, edges, watch)
    }

    /// The settings with this algorithm.
    fn with(&self, algorithm: Algorithm) -> sweep_cdt_engine::Settings {
        sweep_cdt_engine::Settings {
            algorithm,
            front: self.front,
            heuristics: self.heuristics(),
        }
    }

    fn heuristics(&self) -> Heuristics {
        let mut heuristics = self.heuristics;
        if self.no_narrow_corners {
            heuristics.corners = Heuristics::OFF.corners;
        }
        heuristics.basins &= !self.no_basins;
        heuristics
    }
}
