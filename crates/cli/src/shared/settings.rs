//! Algorithm and settings: they change the time and never the result.

use clap::ValueEnum;
use sweep_cdt::front::{Linear, SkipList};
use sweep_cdt::memory::of_bands;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Bands, Error, Heuristics, Stats, Triangulation, Triangulator, Watch};

use super::resources::{Progress, has_room};

/// Arguments that select how the sweep runs.
#[derive(clap::Args)]
#[command(next_help_heading = "Settings (they change the time, never the result)")]
pub(crate) struct Settings {
    /// Algorithm
    #[arg(long, value_enum, default_value_t = Method::Auto)]
    algorithm: Method,

    /// Search structure of the advancing front
    #[arg(long, value_enum, default_value_t = Front::Hash)]
    front: Front,

    /// Angles up to which the heuristics add triangles
    #[arg(long, value_enum, default_value_t = Preset::Fast)]
    heuristics: Preset,

    /// Switch off the pi/2 heuristic (algorithm auto: until flips are many)
    #[arg(long)]
    no_narrow_corners: bool,

    /// Switch off the basin heuristic (algorithm auto: until flips are many)
    #[arg(long)]
    no_basins: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Method {
    /// The sweep, where flips are many with the paper's heuristics; divide and conquer where it would take too long
    Auto,
    /// The sweep, to its end; traces always show the sweep
    Sweep,
    /// Divide and conquer, then the edges one by one
    DivideAndConquer,
}

#[derive(Clone, Copy, ValueEnum)]
enum Front {
    /// Hash table over x, the paper's
    Hash,
    /// Skip list
    SkipList,
    /// Walk from the node inserted last; slow for many points
    Linear,
}

#[derive(Clone, Copy, ValueEnum)]
enum Preset {
    /// The angles measured as fastest
    Fast,
    /// The paper's pi/2 and 3pi/4
    Paper,
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
        let is_parallel = matches!(self.front, Front::Hash) && !stats;
        let triangulator = Triangulator::new()
            .algorithm(self.algorithm())
            .heuristics(self.heuristics());
        if is_parallel && has_room(of_bands(points.len(), edges.len()) as u64) {
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
        let result = self.run(triangulator, points, edges, watch)?;
        Ok((result, stats.then_some(found)))
    }

    /// Triangulates by the sweep in the paper's order, and reports every step to `observer`.
    pub(crate) fn observe<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        mut observer: impl FnMut(Event),
    ) -> Result<Triangulation, Error> {
        let triangulator = Triangulator::new()
            .algorithm(Algorithm::Paper)
            .heuristics(self.heuristics());
        let watch = Watch::new().events(&mut observer);
        self.run(triangulator, points, edges, watch)
    }

    /// A run with the front that was chosen.
    fn run<S: Scalar>(
        &self,
        triangulator: Triangulator,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        watch: Watch<'_>,
    ) -> Result<Triangulation, Error> {
        match self.front {
            Front::Hash => triangulator.run(points, edges, watch),
            Front::SkipList => {
                triangulator.run(points, edges, watch.front(&mut SkipList::default()))
            }
            Front::Linear => triangulator.run(points, edges, watch.front(&mut Linear::default())),
        }
    }

    fn algorithm(&self) -> Algorithm {
        match self.algorithm {
            Method::Auto => Algorithm::Auto,
            Method::Sweep => Algorithm::Sweep,
            Method::DivideAndConquer => Algorithm::DivideAndConquer,
        }
    }

    fn heuristics(&self) -> Heuristics {
        let mut heuristics = match self.heuristics {
            Preset::Fast => Heuristics::FAST,
            Preset::Paper => Heuristics::PAPER,
        };
        if self.no_narrow_corners {
            heuristics.corners = Heuristics::OFF.corners;
        }
        heuristics.basins &= !self.no_basins;
        heuristics
    }
}
