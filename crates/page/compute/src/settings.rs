//! The triangulation of a request: with its front, its algorithm and its heuristics, and what of it is inside.

use std::borrow::Cow;

use sweep_cdt::crossings::{Exact, SplitError, crossings};
use sweep_cdt::front::{Linear, SkipList};
use sweep_cdt::interior::{FillRule, Interior, InteriorError};
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Heuristics, Pslg, Stats, Triangulation, Triangulator, Watch};
use sweep_cdt_formats::{Coordinate, GraphFile};

use super::request::{Front, Inside, Preset, Settings};

impl Settings {
    /// The graph that is triangulated: that of the file, or its edges split, if they are to be split and any cross.
    pub(crate) fn pieces<'a, S: Coordinate + Exact>(
        &self,
        file: &'a GraphFile<S>,
    ) -> Result<Cow<'a, GraphFile<S>>, SplitError> {
        let graph = &file.graph;
        if !self.split || crossings(&graph.points, &graph.edges)?.is_empty() {
            return Ok(Cow::Borrowed(file));
        }
        Ok(Cow::Owned(file.split_crossings()?.0))
    }

    /// Triangulates; where steps are wanted, by the sweep.
    pub(crate) fn triangulate<S: Coordinate>(
        &self,
        Pslg { points, edges, .. }: &Pslg<S>,
        steps: Option<&mut Vec<Event>>,
    ) -> Result<(Triangulation, Stats), Error> {
        let (mut skip_list, mut linear) = (SkipList::default(), Linear::default());
        let mut stats = Stats::default();
        let mut watch = Watch::new().stats(&mut stats);
        match self.front {
            Front::Hash => {}
            Front::SkipList => watch = watch.front(&mut skip_list),
            Front::Linear => watch = watch.front(&mut linear),
        }
        let mut push;
        let mut algorithm = self.method.into();
        if let Some(steps) = steps {
            algorithm = Algorithm::Paper;
            push = |event| steps.push(event);
            watch = watch.events(&mut push);
        }
        let triangulator =
            Triangulator::new()
                .algorithm(algorithm)
                .heuristics(match self.heuristics {
                    Preset::Fast => Heuristics::FAST,
                    Preset::Paper => Heuristics::PAPER,
                    Preset::Off => Heuristics::OFF,
                });
        let result = triangulator.run(points, edges, watch)?;
        Ok((result, stats))
    }

    /// The interior; nothing, if that is the whole hull.
    pub(crate) fn domain<'a, S: Coordinate>(
        &self,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Option<Result<Interior<'a>, InteriorError>> {
        let graph = &file.graph;
        let rule = match self.inside {
            Inside::Default if !graph.holes.is_empty() => Inside::Holes,
            Inside::Default if !file.polygons.is_empty() => {
                return Some(file.polygons.interior(result));
            }
            Inside::Default => Inside::Hull,
            rule => rule,
        };
        match rule {
            Inside::EvenOdd => Some(result.interior(FillRule::EvenOdd)),
            Inside::Nonzero => Some(result.interior(FillRule::NonZero)),
            Inside::Holes => {
                let seeds = graph.regions.iter().map(|region| region.seed.clone());
                let regions: Vec<[S; 2]> = seeds.collect();
                Some(
                    result
                        .with_points(&graph.points)
                        .interior_of_seeds(&graph.holes, &regions),
                )
            }
            Inside::Hull | Inside::Default => None,
        }
    }
}
