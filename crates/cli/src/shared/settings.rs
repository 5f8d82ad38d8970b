//! Algorithm and settings: they change the time and never the result.

use std::cell::RefCell;

use clap::ValueEnum;
use sweep_cdt::front::{AnyFront, HashTable, Linear, SkipList};
use sweep_cdt::memory::of_bands;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Heuristics, Stats, Triangulation, Triangulator};

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
        let progress = RefCell::new(Progress::new("sweeping"));
        let show = |swept, points| progress.borrow_mut().show(swept, points);
        let triangulator = Triangulator::new()
            .front(self.front())
            .algorithm(self.algorithm())
            .heuristics(self.heuristics())
            .progress(&show);
        if stats {
            let run = triangulator.triangulate_with_stats(points, edges)?;
            return Ok((run.triangulation, Some(run.stats)));
        }
        let bytes = of_bands(points.len(), edges.len()) as u64;
        let result = if has_room(bytes) {
            triangulator.triangulate_parallel(points, edges)?
        } else {
            triangulator.triangulate(points, edges)?
        };
        Ok((result, None))
    }

    /// Triangulates by the sweep, and reports every step to `observer`.
    pub(crate) fn observe<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        observer: impl FnMut(Event),
    ) -> Result<Triangulation, Error> {
        let triangulator = Triangulator::new()
            .front(self.front())
            .heuristics(self.heuristics());
        let run = triangulator.observe(points, edges, observer)?;
        Ok(run.triangulation)
    }

    fn front(&self) -> AnyFront {
        match self.front {
            Front::Hash => AnyFront::HashTable(HashTable::default()),
            Front::SkipList => AnyFront::SkipList(SkipList::default()),
            Front::Linear => AnyFront::Linear(Linear::default()),
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
